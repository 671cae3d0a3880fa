# Deviator and volume strain over axial compression: gnuplot biaxial.gp
set terminal pngcairo size 1000,430 font ',10'
set output 'biaxial.png'
set multiplot layout 1,2
set grid
set xlabel 'axial compression, logarithmic [%]'
set ylabel 'sigma_3 - sigma_1 [kPa]' noenhanced
set key bottom right
set xrange [0:6]
plot 'run/element' using (100*$1):(1e-3*$2) with lines lc 'black' title 'element test', 'run/smooth.path' using (100*$1):(1e-3*$2) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth platens', \
    'run/half.path' using (100*$1):(1e-3*$2) with points pt 2 ps 0.6 lc rgb '#1a8a34' title 'half the speed', 'run/rough.path' using (100*$1):(1e-3*$2) with points pt 4 ps 0.8 lc rgb '#d95319' title 'rough platens'
set ylabel 'volume strain [%]'
set key top right
plot 'run/element' using (100*$1):(100*$3) with lines lc 'black' title 'element test', 'run/smooth.path' using (100*$1):(100*$3) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth platens', \
    'run/half.path' using (100*$1):(100*$3) with points pt 2 ps 0.6 lc rgb '#1a8a34' title 'half the speed', 'run/rough.path' using (100*$1):(100*$3) with points pt 4 ps 0.8 lc rgb '#d95319' title 'rough platens'
