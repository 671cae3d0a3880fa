# Stresses over depth at 2.6 s, means of rows: gnuplot sandColumn.gp
set terminal pngcairo size 1000,430 font ',10'
set output 'sandColumn.png'
# a table of a function object with its columns by name
dat(file) = "< sed -n '/^# Time/,$ { s/^# //; y/\\t/,/; p }' ".file
set datafile separator ','
set datafile columnheaders
# The surface: half a spacing above the highest particle, column `top` of function object `column`
stats dat('run/roughFine/postProcessing/column/0/reduction.dat') using (top = column('top')) nooutput      # the last row's stays
unset datafile
set multiplot layout 1,2
set grid
set yrange [1:0]
set ylabel 'depth [m]'
set xlabel 'mean vertical stress [kPa]'
set key bottom left
# Columns of rows: distance, y, vertical, lateral, rho, particles
rows(run) = 'run/'.run.'/postProcessing/rows/2.6/bins_y_vertical_lateral_rho.xy'
depth(y) = top - y
r = 2*tan(pi/12)*0.5135/0.5
janssen(z, rho) = rho*9.81/r*(1 - exp(-r*z))
plot rows('fine') using (1e-3*9.81*$5*depth($2)):(depth($2)) with lines lc 'black' title 'rho g z' noenhanced, \
    rows('roughFine') using (1e-3*janssen(depth($2), $5)):(depth($2)) with lines dt 2 lc 'black' title 'Janssen (1895)', \
    rows('fine') using (1e-3*$3):(depth($2)) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth walls', \
    rows('roughFine') using (1e-3*$3):(depth($2)) with points pt 4 ps 0.8 lc rgb '#d95319' title '15 degrees'
set xlabel 'lateral over vertical stress'
set xrange [0.4:0.65]
set arrow from 0.5135,1 to 0.5135,0 nohead dt 2
plot rows('fine') using ($4/$3):(depth($2)) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth walls', rows('roughFine') using ($4/$3):(depth($2)) with points pt 4 ps 0.8 lc rgb '#d95319' title '15 degrees', \
    NaN dt 2 lc 'black' title '0.5135'
