# phi along the middle of the square channel beside finite volumes, and over its section: gnuplot profiles.gp
set terminal pngcairo size 1100,430 font ',10'
set output 'profiles.png'
h = 1.25e-4
particles(ratio, n) = '< ./particleTable run/workPrecision/ratio'.ratio.'/'.n.'/0.000418199 phi'
ratios = "0.4 0.2 0.1"; colours = "#0060ad #d95319 #3a923a"
set multiplot layout 1,2
set datafile separator ','
set xlabel '|y|/h, from the middle'
set ylabel 'phi'
set xrange [0:1]
plot for [k=1:3] 'reference/centreLine.csv' using ($1 == word(ratios, k) && $2 == 0.5 ? $3 : NaN):4 every ::1 with lines lc rgb word(colours, k) title 'D_c/D_{eta} = '.word(ratios, k).', finite volumes', \
    for [k=1:3] particles(word(ratios, k), '19') using (abs($3/h - 1) < 0.01 ? abs($2/h - 1) : NaN):4 with points pt 7 lc rgb word(colours, k) title '19 across'
set xrange [-1:1]
set yrange [-1:1]
set size ratio -1
set xlabel 'y/h - 1'
set ylabel 'z/h - 1'
set cblabel 'phi, D_c/D_{eta} = 0.4, 39 across'
set palette defined (0 '#2b4a8b', 0.5 '#e8e4d8', 1 '#8b2b1d')
plot particles('0.4', '39') using ($2/h - 1):($3/h - 1):4 with points pt 5 ps 0.75 lc palette notitle
