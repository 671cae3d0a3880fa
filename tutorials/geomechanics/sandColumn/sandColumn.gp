# Stresses over depth at 2.6 s, means of rows: gnuplot sandColumn.gp
set terminal pngcairo size 1000,430 font ',10'
set output 'sandColumn.png'
set multiplot layout 1,2
set grid
set yrange [1:0]
set ylabel 'depth [m]'
set xlabel 'mean vertical stress [kPa]'
set key bottom left
smooth = 'run/fine/rows'
rough = 'run/roughFine/rows'
plot smooth using (1e-3*$4):1 with lines lc 'black' title 'rho g z' noenhanced, rough using (1e-3*$3):1 with lines dt 2 lc 'black' title 'Janssen (1895)', \
    smooth using (1e-3*$2):1 with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth walls', rough using (1e-3*$2):1 with points pt 4 ps 0.8 lc rgb '#d95319' title '15 degrees'
set xlabel 'lateral over vertical stress'
set xrange [0.4:0.65]
set arrow from 0.5135,1 to 0.5135,0 nohead dt 2
plot smooth using 5:1 with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth walls', rough using 5:1 with points pt 4 ps 0.8 lc rgb '#d95319' title '15 degrees', \
    NaN dt 2 lc 'black' title '0.5135'
