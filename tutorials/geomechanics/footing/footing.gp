set terminal pngcairo size 900,600 font "sans,11"
set output "load.png"
set xlabel "settlement [mm]"
set ylabel "load over c B"
set yrange [0:6]
set key bottom right
plot for [n in "8 12 16 24"] "run/".n."/postProcessing/load/0/forces.dat" using (-$6*1e3):($3/1e4) with lines title n." spacings to the width", 5.14159 with lines dashtype 2 title "2 + pi"
