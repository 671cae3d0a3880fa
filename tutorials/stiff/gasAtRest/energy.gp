# Kinetic energy of air left alone against time, calm and whole: gnuplot energy.gp
set terminal pngcairo size 900,420 font ',10'
set output 'gasAtRest.png'
set datafile separator tab
set logscale y
set format y '10^{%T}'
set xlabel 't [s]'
set ylabel 'kinetic energy [J]'
set yrange [1e-20:1e-5]
set key outside right
plot for [name in "whole spheresWhole calm spheres"] "< sed 's/^# Time/Time/' run/".name."/postProcessing/conservation/0/conservation.dat" using 'Time':'kineticEnergy' with lines lw 1.5 title name
