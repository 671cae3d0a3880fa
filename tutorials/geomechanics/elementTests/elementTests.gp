# Element tests: lines elementTest, points the independent integrators. gnuplot elementTests.gp
set terminal pngcairo size 1200,760 font ',10'
set output 'elementTests.png'
set multiplot layout 2,3
set datafile separator ','
set datafile commentschars '#'
tables = 'postProcessing/elementTest/'
set grid
set style line 1 lc rgb '#0060ad' lw 1.5
set style line 2 lc rgb '#d95319' lw 1.5
set style line 3 lc rgb '#1a8a34' lw 1.5
is(text) = stringcolumn(1) eq text ? 1 : NaN
set title 'oedometer, from K = 1 and 0'
set xlabel 'axial compression [%]'
set ylabel 'K = sigma_xx/sigma_zz' noenhanced
set key top right
set yrange [0:1]
plot tables.'oedometer.csv' using (100*$1):'K [-]' with lines ls 1 title 'from 1', tables.'oedometerFromK0.csv' using (100*$1):'K [-]' with lines ls 2 title 'from 0', \
    'reference/oedometer.csv' using (100*$3):6 with points pt 6 ps 0.8 lc 'black' title 'reference', 0.51013396 with lines dt 2 lc 'black' title 'K_0 of eq. (21)'
set autoscale y
set title 'drained, lateral stress 100 kPa'
set ylabel 'sigma_1 - sigma_3 [kPa]'
set key bottom right
plot tables.'triaxial.csv' using (100*$1):(1e-3*(column('stress.xx [Pa]') - column('stress.zz [Pa]'))) with lines ls 1 title 'triaxial', \
    tables.'biaxial.csv' using (100*$1):(1e-3*(column('stress.xx [Pa]') - column('stress.zz [Pa]'))) with lines ls 2 title 'biaxial', \
    'run/druckerPrager/'.tables.'triaxial.csv' using (100*$1):(1e-3*(column('stress.xx [Pa]') - column('stress.zz [Pa]'))) with lines ls 1 dt 2 title 'triaxial, Drucker-Prager', \
    'run/druckerPrager/'.tables.'biaxial.csv' using (100*$1):(1e-3*(column('stress.xx [Pa]') - column('stress.zz [Pa]'))) with lines ls 2 dt 2 title 'biaxial, Drucker-Prager', \
    'reference/triaxial.csv' using (100*$2):(1e-3*$3) every 2 with points pt 6 ps 0.8 lc 'black' title 'reference'
set ylabel 'volume strain, compression positive [%]'
set key bottom right
set yrange [0:1.2]
plot tables.'triaxial.csv' using (100*$1):(-100*column('volumeStrain [-]')) with lines ls 1 title 'triaxial', \
    tables.'biaxial.csv' using (100*$1):(-100*column('volumeStrain [-]')) with lines ls 2 title 'biaxial', \
    'reference/triaxial.csv' using (100*$2):(100*$4) every 2 with points pt 6 ps 0.8 lc 'black' title 'reference'
set autoscale y
set key top right
set title 'simple shear from 100 kPa'
set xlabel 'gamma'
set ylabel 'tau, sigma_zz [kPa]' noenhanced
plot tables.'simpleShear.csv' using 1:(1e-3*column('stress.xz [Pa]')) with lines ls 1 title 'tau at constant stress', \
    tables.'constantVolumeShear.csv' using 1:(1e-3*column('stress.xz [Pa]')) with lines ls 2 title 'tau at constant volume', \
    tables.'constantVolumeShear.csv' using 1:(-1e-3*column('stress.zz [Pa]')) with lines ls 3 title 'sigma_zz at constant volume' noenhanced, \
    'reference/simpleShear.csv' using (is('const-sz')*$4):(-1e-3*$8) every 2 with points pt 6 ps 0.8 lc 'black' title 'reference', \
    'reference/simpleShear.csv' using (is('const-volume')*$4):(-1e-3*$8) every 2 with points pt 6 ps 0.8 lc 'black' notitle, \
    'reference/simpleShear.csv' using (is('const-volume')*$4):(1e-3*$7) every 2 with points pt 6 ps 0.8 lc 'black' notitle
set title 'isotropic loading and unloading'
set xlabel 'volume compression [%]'
set ylabel 'p [kPa]'
set logscale y
set yrange [50:1000]
set samples 21
set key top left
plot tables.'isotropic.csv' using (-100*column('volumeStrain [-]')):(1e-3*column('p [Pa]')) with lines ls 1 title 'to 1 % and back', \
    [0:1] 100*exp(1.675387*x) with points pt 6 ps 0.8 lc 'black' title 'exponentials', [0.5:1] 100*exp(1.675387 - 4.199947*(1 - x)) with points pt 6 ps 0.8 lc 'black' notitle
unset logscale y
set autoscale y
set title 'cycles of +-0.01 % in an oedometer'
set xlabel 'length of the strain path [%]'
set ylabel 'vertical stress [kPa]'
set key top right
plot tables.'cycles.csv' using (100*$1):(-1e-3*column('stress.zz [Pa]')) with lines ls 1 notitle
unset multiplot
