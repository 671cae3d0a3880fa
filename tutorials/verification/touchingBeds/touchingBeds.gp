# Error of the drag factor against the spacing: gnuplot touchingBeds.gp
set terminal pngcairo size 640,440 font ',10'
set output 'touchingBeds.png'
# spacings a sphere of a row of results, of this gap
across(gap) = strstrt(strcol(2), 'Van der Hoef') && strstrt(strcol(1).'|', ' gap '.gap.'|') ? real(word(strcol(1), 1)) : NaN
set datafile separator ','
set datafile missing NaN
set xlabel 'spacings a sphere'
set ylabel 'K too low by [%]'
set logscale xy
set xtics (8, 12, 16, 24)
set xrange [7:28]
set yrange [3:100]
set key bottom left
plot for [gap in "0 0.35 0.7 1"] 'run/results.csv' using (across(gap)):(-$3) with linespoints lw 1.5 title 'gaps of '.gap.' spacings', \
    43*(8.0/x)**2 with lines dt 2 lc rgb 'grey' title 'order 2'
