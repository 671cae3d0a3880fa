# Deviator and volume strain over axial compression: gnuplot biaxial.gp
set terminal pngcairo size 1000,430 font ',10'
set output 'biaxial.png'
# Columns of a test: path, strains, stresses xx .. zz (8 .. 13), volume strain; of a specimen: time, deviator, worst, square, specific volume
set datafile separator ",\t"
test = 'postProcessing/elementTest/biaxial.csv'
table = 'postProcessing/specimen/0/reduction.dat'
set multiplot layout 1,2
set grid
set xlabel 'axial compression, logarithmic [%]'
set ylabel 'sigma_3 - sigma_1 [kPa]' noenhanced
set key bottom right
set xrange [0:6]
plot test using (100*$1):(1e-3*($8 - $13)) with lines lc 'black' title 'element test', './'.table using (-100*log(1 - 0.01*$1/0.1)):(1e-3*$2) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth platens', \
    'run/half/'.table using (-100*log(1 - 0.005*$1/0.1)):(1e-3*$2) with points pt 2 ps 0.6 lc rgb '#1a8a34' title 'half the speed', 'run/rough/'.table using (-100*log(1 - 0.02*$1/0.1)):(1e-3*$2) with points pt 4 ps 0.8 lc rgb '#d95319' title 'rough platens', \
    'run/calmFine/'.table using (-100*log(1 - 0.01*$1/0.1)):(1e-3*$2) with points pt 1 ps 0.8 lc rgb '#7e2f8e' title 'off the lattice, balanced'
set ylabel 'volume strain [%]'
set key top right
plot test using (100*$1):(100*$14) with lines lc 'black' title 'element test', './'.table using (-100*log(1 - 0.01*$1/0.1)):(100*log(1850*$5)) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth platens', \
    'run/half/'.table using (-100*log(1 - 0.005*$1/0.1)):(100*log(1850*$5)) with points pt 2 ps 0.6 lc rgb '#1a8a34' title 'half the speed', 'run/rough/'.table using (-100*log(1 - 0.02*$1/0.1)):(100*log(1850*$5)) with points pt 4 ps 0.8 lc rgb '#d95319' title 'rough platens', \
    'run/calmFine/'.table using (-100*log(1 - 0.01*$1/0.1)):(100*log(1850*$5)) with points pt 1 ps 0.8 lc rgb '#7e2f8e' title 'off the lattice, balanced'
