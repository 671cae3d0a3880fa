# phi across the channel on the way, beside finite volumes, and in the middle over time: gnuplot profiles.gp
set terminal pngcairo size 1100,430 font ',10'
set output 'profiles.png'
set multiplot layout 1,2
h = 1.25e-4; unit = 66e-9
times = "0.1 0.2 0.3"; folders = "6.6e-09 1.32e-08 1.98e-08"; colours = "#0060ad #d95319 #3a923a"
set datafile separator ','
set xlabel '|y|/h, from the middle'
set ylabel 'phi'
set xrange [0:1]
set yrange [0.53:0.73]
plot for [k=1:3] 'reference/startUp.csv' using ($1 == word(times, k) ? $2 : NaN):3 every ::1 with lines lc rgb word(colours, k) title word(times, k).' t*, finite volumes', \
    for [k=1:3] '< tr " \t" ",," < run/rho2500/postProcessing/profile/'.word(folders, k).'/bins_phi_U.xy' using (abs($1/h - 1)):2 with points pt 7 ps 0.7 lc rgb word(colours, k) title '39 across'
set datafile separator whitespace
set xlabel 't/t*'
set ylabel 'phi in the middle'
set xrange [0:0.3]
set yrange [0.62:0.73]
set key top left
plot for [rho in "1000 2500 4000"] 'run/rho'.rho.'/postProcessing/middle/0/phi' using ($1/unit):2 with lines title 'rho = '.rho.' kg/m^3'
