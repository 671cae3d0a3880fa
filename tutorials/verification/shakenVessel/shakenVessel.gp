# Kinetic energy against time: gnuplot shakenVessel.gp
set terminal pngcairo size 800,430 font ',10'
set output 'shakenVessel.png'
of(kind) = "< grep -v '^#' run/".kind."/postProcessing/conservation/0/conservation.dat | awk '{ print $1, $(NF - 1)/$2 }'"
set xlabel 't [s]'
set ylabel 'kinetic energy [J/kg]'
set key outside right
plot for [k in "angular rounded elongated flat concave"] of(k) using 1:2 with lines lw 1.5 title k
