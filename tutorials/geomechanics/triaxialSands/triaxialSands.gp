# Element tests of dense and loose sand, lines, beside the independent integrator and specimens of particles: gnuplot triaxialSands.gp
set terminal pngcairo size 1200,760 font ',10'
set output 'triaxialSands.png'
set multiplot layout 2,3
# a table of a function object with its columns by name
dat(file) = "< sed -n '/^# Time/,$ { s/^# //; y/\\t/,/; p }' ".file
set datafile separator ','
set datafile columnheaders
set datafile commentschars '#'
tables = 'postProcessing/elementTest/'
set grid
set style line 1 lc rgb '#0060ad' lw 1.5
set style line 2 lc rgb '#d95319' lw 1.5
q = "(1e-3*(column('stress.xx [Pa]') - column('stress.zz [Pa]')))"
# of a table of the reference: plain sand in compression at 100 kPa with this void ratio
is(e) = strcol(1) eq "plain" && strcol(2) eq "compression" && column(3) == 1e5 && column(4) == e ? 1 : NaN
set xlabel 'axial compression [%]'
set title 'drained, 100 kPa'
set ylabel 'q [kPa]'
set key bottom right
plot tables.'dense.csv' using (100*$1):@q with lines ls 1 title 'dense, e = 0.56', tables.'loose.csv' using (100*$1):@q with lines ls 2 title 'loose, e = 0.8', \
    'reference/drained.csv' using (is(0.56)*100*$5):(1e-3*$6) with points pt 6 ps 0.9 lc 'black' title 'reference', '' using (is(0.8)*100*$5):(1e-3*$6) with points pt 6 ps 0.9 lc 'black' notitle, \
    dat('run/dense/postProcessing/specimen/0/reduction.dat') using (-100*log(1 - 0.1*column('Time'))):(1e-3*column('deviator')) with points pt 2 ps 0.7 lc 'black' title 'specimen of particles', dat('run/loose/postProcessing/specimen/0/reduction.dat') using (-100*log(1 - 0.1*column('Time'))):(1e-3*column('deviator')) with points pt 2 ps 0.7 lc 'black' notitle
set ylabel 'void ratio'
set key center right
plot tables.'dense.csv' using (100*$1):'voidRatio [-]' with lines ls 1 title 'dense', tables.'loose.csv' using (100*$1):'voidRatio [-]' with lines ls 2 title 'loose', \
    'reference/drained.csv' using (is(0.56)*100*$5):8 with points pt 6 ps 0.9 lc 'black' title 'reference', '' using (is(0.8)*100*$5):8 with points pt 6 ps 0.9 lc 'black' notitle, \
    dat('run/dense/postProcessing/specimen/0/reduction.dat') using (-100*log(1 - 0.1*column('Time'))):(column('meanVoidRatio')) with points pt 2 ps 0.7 lc 'black' title 'specimen of particles', dat('run/loose/postProcessing/specimen/0/reduction.dat') using (-100*log(1 - 0.1*column('Time'))):(column('meanVoidRatio')) with points pt 2 ps 0.7 lc 'black' notitle
set title 'undrained, 100 kPa'
set xlabel "p' [kPa]"
set ylabel 'q [kPa]'
set key top left
set xrange [0:250]
set yrange [0:300]
plot tables.'denseUndrained.csv' using (1e-3*column('p [Pa]')):@q with lines ls 1 title 'dense, e = 0.6', tables.'looseUndrained.csv' using (1e-3*column('p [Pa]')):@q with lines ls 2 title 'loose, e = 0.8', \
    'reference/undrained.csv' using (is(0.6)*1e-3*$7):(1e-3*$6) with points pt 6 ps 0.9 lc 'black' title 'reference', '' using (is(0.8)*1e-3*$7):(1e-3*$6) with points pt 6 ps 0.9 lc 'black' notitle, \
    1.2*x with lines dt 2 lc 'black' title 'critical state, 30 degrees'
set autoscale
set xlabel 'axial compression [%]'
set key center right
set ylabel 'pore pressure [kPa]'
set yrange [-150:100]
plot tables.'denseUndrained.csv' using (100*$1):(1e-3*column('porePressure [Pa]')) with lines ls 1 title 'dense', tables.'looseUndrained.csv' using (100*$1):(1e-3*column('porePressure [Pa]')) with lines ls 2 title 'loose', \
    dat('run/undrained-dense/postProcessing/specimen/0/reduction.dat') using (-100*log(1 - 0.1*column('Time'))):(1e-3*column('meanPorePressure')) with points pt 2 ps 0.7 lc 'black' title 'specimen of particles', dat('run/undrained-loose/postProcessing/specimen/0/reduction.dat') using (-100*log(1 - 0.1*column('Time'))):(1e-3*column('meanPorePressure')) with points pt 2 ps 0.7 lc 'black' notitle, \
    'reference/undrained.csv' using (is(0.6)*100*$5):(1e-3*$8) with points pt 6 ps 0.9 lc 'black' notitle, '' using (is(0.8)*100*$5):(1e-3*$8) with points pt 6 ps 0.9 lc 'black' notitle
set autoscale
set title 'oedometer, e = 0.58'
set xlabel 'vertical stress [kPa]'
set ylabel 'void ratio'
set logscale x
set key bottom left
plot tables.'oedometer.csv' using (-1e-3*column('stress.zz [Pa]')):'voidRatio [-]' with lines ls 1 title 'loaded, unloaded, reloaded', \
    'reference/oedometer.csv' using (strcol(1) eq "plain" && $3 == 0.58 ? 1e-3*$4 : NaN):6 with points pt 6 ps 0.9 lc 'black' title 'reference'
unset logscale x
set title 'cycles without drainage'
set xlabel "p' [kPa]"
set ylabel 'q [kPa]'
plot tables.'liquefaction.csv' using (1e-3*column('p [Pa]')):@q with lines ls 1 notitle
unset multiplot
