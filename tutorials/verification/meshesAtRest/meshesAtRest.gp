# Kinetic energy against time: gnuplot meshesAtRest.gp
set terminal pngcairo size 800,480 font ',10'
set output 'meshesAtRest.png'
H = 0.6; g = 9.81
# a table of a function object with its columns by name
dat(file) = "< sed -n '/^# Time/,$ { s/^# //; y/\\t/,/; p }' ".file
set datafile separator ','
set datafile columnheaders
of(scene) = dat('run/'.scene.'/postProcessing/conservation/0/conservation.dat')
set xlabel 't/sqrt(2 H/g)'
set ylabel 'kinetic energy/(m g H)'
set logscale y
set format y '10^{%L}'
set yrange [1e-8:1e-3]
set key outside right
plot 1e-6 with lines dt 2 lc rgb 'black' title 'floor', \
    for [s in "turnedBox rockBed rockBed-20 block cube wedge angularRock"] of(s) using (column('Time')/sqrt(2*H/g)):(column('kineticEnergy')/column('mass_water')/(g*H)) with lines lw 1.5 title s, \
    for [s in "mergedBlock mergedCube mergedWedge mergedAngularRock"] of(s) using (column('Time')/sqrt(2*H/g)):(column('kineticEnergy')/column('mass_water')/(g*H)) with lines dt 3 lw 1.5 title s
