# Error of the drag factor against the spacing: gnuplot touchingBeds.gp
set terminal pngcairo size 640,440 font ',10'
set output 'touchingBeds.png'
of(gap) = "< awk -F, '$2 ~ /Van der Hoef/ && $1 ~ / gap ".gap."$/ { error[$1 + 0] = -$3 } END { for (n in error) print n, error[n] }' run/results.csv | sort -n"
set xlabel 'spacings a sphere'
set ylabel 'K too low by [%]'
set logscale xy
set xtics (8, 12, 16, 24)
set xrange [7:28]
set yrange [3:100]
set key bottom left
plot for [gap in "0 0.35 0.7 1"] of(gap) using 1:2 with linespoints lw 1.5 title 'gaps of '.gap.' spacings', \
    43*(8.0/x)**2 with lines dt 2 lc rgb 'grey' title 'order 2'
