# Kinetic energy against time: gnuplot shakenVessel.gp
set terminal pngcairo size 800,430 font ',10'
set output 'shakenVessel.png'
# a table of a function object with its columns by name
dat(file) = "< sed -n '/^# Time/,$ { s/^# //; y/\\t/,/; p }' ".file
set datafile separator ','
set datafile columnheaders
set xlabel 't [s]'
set ylabel 'kinetic energy [J/kg]'
set key outside right
plot for [k in "angular rounded elongated flat concave"] dat('run/'.k.'/postProcessing/conservation/0/conservation.dat') using (column('Time')):(column('kineticEnergy')/column('mass_water')) with lines lw 1.5 title k
