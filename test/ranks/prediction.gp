# prediction.dat of test/ranks/run: ranks, and of a rank particles, copies, messages and bytes of a refresh, bytes of a step, share of the time in communication [%]
set terminal pngcairo size 640,420
set output "prediction.png"
set logscale xy
set xlabel "ranks"
set ylabel "%"
set key top left
set grid
plot "prediction.dat" using 1:(100*$3/$2) with linespoints title "copies of others' particles over own", \
     "" using 1:7 with linespoints title "time in communication"
