# Deviator and volume strain over axial compression: gnuplot biaxial.gp
set terminal pngcairo size 1000,430 font ',10'
set output 'biaxial.png'
# a table of a function object with its columns by name
dat(file) = "< sed -n '/^# Time/,$ { s/^# //; y/\\t/,/; p }' ".file
set datafile separator ','
set datafile columnheaders
test = 'postProcessing/elementTest/biaxial.csv'
table = 'postProcessing/specimen/0/reduction.dat'
set multiplot layout 1,2
set grid
set xlabel 'axial compression, logarithmic [%]'
set ylabel 'sigma_3 - sigma_1 [kPa]' noenhanced
set key bottom right
set xrange [0:6]
plot test using (100*$1):(1e-3*(column('stress.xx [Pa]') - column('stress.zz [Pa]'))) with lines lc 'black' title 'element test', dat(table) using (-100*log(1 - 0.01*column('Time')/0.1)):(1e-3*column('deviator')) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth platens', \
    dat('run/half/'.table) using (-100*log(1 - 0.005*column('Time')/0.1)):(1e-3*column('deviator')) with points pt 2 ps 0.6 lc rgb '#1a8a34' title 'half the speed', dat('run/rough/'.table) using (-100*log(1 - 0.02*column('Time')/0.1)):(1e-3*column('deviator')) with points pt 4 ps 0.8 lc rgb '#d95319' title 'rough platens', \
    dat('run/calmFine/'.table) using (-100*log(1 - 0.01*column('Time')/0.1)):(1e-3*column('deviator')) with points pt 1 ps 0.8 lc rgb '#7e2f8e' title 'off the lattice, balanced'
set ylabel 'volume strain [%]'
set key top right
plot test using (100*$1):(100*column('volumeStrain [-]')) with lines lc 'black' title 'element test', dat(table) using (-100*log(1 - 0.01*column('Time')/0.1)):(100*log(1850*column('volume'))) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'smooth platens', \
    dat('run/half/'.table) using (-100*log(1 - 0.005*column('Time')/0.1)):(100*log(1850*column('volume'))) with points pt 2 ps 0.6 lc rgb '#1a8a34' title 'half the speed', dat('run/rough/'.table) using (-100*log(1 - 0.02*column('Time')/0.1)):(100*log(1850*column('volume'))) with points pt 4 ps 0.8 lc rgb '#d95319' title 'rough platens', \
    dat('run/calmFine/'.table) using (-100*log(1 - 0.01*column('Time')/0.1)):(100*log(1850*column('volume'))) with points pt 1 ps 0.8 lc rgb '#7e2f8e' title 'off the lattice, balanced'
