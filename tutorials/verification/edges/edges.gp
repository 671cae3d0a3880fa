# Errors of the density at rest against the angle of the wedge: gnuplot edges.gp
set terminal pngcairo size 700,430 font ',10'
set output 'edges.png'
set datafile separator ','
set datafile missing NaN
wedge(figure) = strcol(1)[1:5] eq 'wedge' && strcol(2) eq figure ? real(strcol(1)[6:]) : NaN
set xlabel 'angle of the fluid [degrees]'
set ylabel 'error of the density at rest [%]'
set xrange [0:360]
set xtics 30
set yrange [0.001:10]
set logscale y
set key top right
plot 1 with lines dt 2 lc rgb 'black' title 'bound', 'run/results.csv' using (wedge('largest error')):3 with linespoints pt 7 title 'largest', \
    'run/results.csv' using (wedge('largest error near')):3 with linespoints pt 7 title 'largest within H of the edge', 'run/results.csv' using (wedge('rms error')):3 with linespoints pt 7 title 'root mean square'
