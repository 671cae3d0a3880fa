# phi along the middle on the way, beside finite volumes, in the middle over time, and over the section: gnuplot profiles.gp
n = system('ls -d run/across39rho2500ratio0.1 2> /dev/null') eq '' ? '19' : '39'
set terminal pngcairo size 1500,430 font ',10'
set output 'profiles.png'
set multiplot layout 1,3
h = 1.25e-4; unit = 66e-9
folder(rho, ratio) = 'run/across'.n.'rho'.rho.'ratio'.ratio.'/'
particles(t) = '< ../squareChannel/particleTable '.folder('2500', '0.1').t.' phi'
times = "0.1 0.2 0.3"; folders = "6.6e-09 1.32e-08 1.98e-08"; colours = "#0060ad #d95319 #3a923a"
set xlabel '|y|/h, from the middle'
set ylabel 'phi'
set xrange [0:1]
set yrange [0.56:0.74]
set datafile separator ','
plot for [k=1:3] 'reference/centreLine.csv' using ($1 == 2500 && $2 == 0.1 && $3 == word(times, k) ? $4 : NaN):5 every ::1 with lines lc rgb word(colours, k) title word(times, k).' t*, finite volumes', \
    for [k=1:3] particles(word(folders, k)) using (abs($3/h - 1) < 0.01 ? abs($2/h - 1) : NaN):4 with points pt 7 ps 0.7 lc rgb word(colours, k) title n.' across'
set datafile separator whitespace
set xlabel 't/t*'
set ylabel 'phi in the middle'
set xrange [0:0.3]
set yrange [0.62:0.74]
set key top left
densities = "1000 1700 2500"
plot for [k=1:3] 'run/across19rho'.word(densities, k).'ratio0.1/postProcessing/middle/0/phi' using ($1/unit):2 with lines lc rgb word(colours, k) title 'rho = '.word(densities, k).' kg/m^3, 19 across', \
    n eq '39' ? folder('2500', '0.1').'postProcessing/middle/0/phi' : '/dev/null' using ($1/unit):2 with lines dt 2 lc rgb word(colours, 3) title n eq '39' ? '39 across' : ''
set xrange [-1:1]
set yrange [-1:1]
set size ratio -1
set xlabel 'y/h - 1'
set ylabel 'z/h - 1'
set cblabel 'phi at 0.1 t*, rho = 2500 kg/m^3'
set palette defined (0 '#2b4a8b', 0.5 '#e8e4d8', 1 '#8b2b1d')
set datafile separator ','
plot particles('6.6e-09') using ($2/h - 1):($3/h - 1):4 with points pt 5 ps 60.0/n*0.5 lc palette notitle
