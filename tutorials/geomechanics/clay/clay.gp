# Element tests of clay, lines, beside the independent integrator, points: gnuplot clay.gp
set terminal pngcairo size 1200,760 font ',10'
set output 'clay.png'
set multiplot layout 2,3
set datafile separator ','
set datafile commentschars '#'
tables = 'postProcessing/elementTest/'
set grid
q = "(1e-3*(column('stress.xx [Pa]') - column('stress.zz [Pa]')))"
# of a table of the reference: this test with this ratio
is(kind, ratio) = strcol(1) eq kind && column(4) == ratio ? 1 : NaN
ratios = '1 1.5 8'
set xlabel 'axial compression [%]'
set title 'drained, 100 kPa'
set ylabel 'q [kPa]'
set key bottom right
plot for [r in ratios] tables.'drained'.r.'.csv' using (100*$1):@q with lines lw 1.5 title 'OCR '.r, \
    for [r in ratios] 'reference/triaxial.csv' using (is('triaxialDrained', r + 0)*100*$5):(1e-3*($6 - $7)) with points pt 6 ps 0.9 lc 'black' notitle
set ylabel 'void ratio'
set key top right
plot for [r in ratios] tables.'drained'.r.'.csv' using (100*$1):'voidRatio [-]' with lines lw 1.5 title 'OCR '.r, \
    for [r in ratios] 'reference/triaxial.csv' using (is('triaxialDrained', r + 0)*100*$5):8 with points pt 6 ps 0.9 lc 'black' notitle
set title 'undrained, 100 kPa'
set xlabel "p' [kPa]"
set ylabel 'q [kPa]'
set key center right
plot for [r in ratios] tables.'undrained'.r.'.csv' using (1e-3*column('p [Pa]')):@q with lines lw 1.5 title 'OCR '.r, \
    for [r in ratios] 'reference/triaxial.csv' using (is('triaxialUndrained', r + 0)*1e-3*($6 + 2*$7)/3):(1e-3*($6 - $7)) with points pt 6 ps 0.9 lc 'black' notitle, \
    [0:250] 0.888*x with lines dt 2 lc 'black' title 'critical state'
set xlabel 'axial compression [%]'
set ylabel 'pore pressure [kPa]'
set key center right
plot for [r in ratios] tables.'undrained'.r.'.csv' using (100*$1):(1e-3*column('porePressure [Pa]')) with lines lw 1.5 title 'OCR '.r
set title 'isotropic and oedometer'
set xlabel "p' [kPa]"
set ylabel 'void ratio'
set logscale x
set key bottom left
plot tables.'isotropic.csv' using (1e-3*column('p [Pa]')):'voidRatio [-]' with lines lw 1.5 title 'isotropic', tables.'oedometer2.csv' using (1e-3*column('p [Pa]')):'voidRatio [-]' with lines lw 1.5 title 'oedometer, OCR 2'
unset logscale x
set title 'clay that softens, Mohr and Coulomb'
set xlabel 'axial compression [%]'
set ylabel 'q [kPa]'
set key bottom right
plot 'run/mohrCoulomb/postProcessing/elementTest/triaxial.csv' using (100*$1):@q with lines lw 1.5 title 'triaxial', 'run/mohrCoulomb/postProcessing/elementTest/biaxial.csv' using (100*$1):@q with lines lw 1.5 title 'plane strain'
