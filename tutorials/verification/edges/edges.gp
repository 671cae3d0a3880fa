# Errors of the density at rest against the angle of the wedge: gnuplot edges.gp
set terminal pngcairo size 700,430 font ',10'
set output 'edges.png'
of(figure) = "< awk -F, '$1 ~ /^wedge/ && $2 == \"".figure."\" { print substr($1, 6), $3 }' run/results.csv"
set xlabel 'angle of the fluid [degrees]'
set ylabel 'error of the density at rest [%]'
set xrange [0:360]
set xtics 30
set yrange [0.001:10]
set logscale y
set key top right
plot 1 with lines dt 2 lc rgb 'black' title 'bound', of('largest error') with linespoints pt 7 title 'largest', \
    of('largest error near') with linespoints pt 7 title 'largest within H of the edge', of('rms error') with linespoints pt 7 title 'root mean square'
