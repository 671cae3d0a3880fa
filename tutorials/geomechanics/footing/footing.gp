set terminal pngcairo size 900,600 font "sans,11"
set output "load.png"
set xlabel "settlement [mm]"
set ylabel "load over c B"
set yrange [0:6]
set key bottom right
# a table of a function object with its columns by name
dat(file) = "< sed -n '/^# Time/,$ { s/^# //; y/\\t/,/; p }' ".file
set datafile separator ','
set datafile columnheaders
along(name) = real(word(strcol(name), 2))       # y of a vector (x y z)
plot for [n in "8 12 16 24"] dat("run/".n."/postProcessing/load/0/forces.dat") using (-1e3*along("displacement_footing")):(along("force_footing")/1e4) with lines title n." spacings to the width", 5.14159 with lines dashtype 2 title "2 + pi"
