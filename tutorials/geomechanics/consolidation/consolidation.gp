# Pore pressure over the height at T = 0.05, 0.2, 0.5, 1, means of rows; settlement over time: gnuplot consolidation.gp
set terminal pngcairo size 1000,430 font ',10'
set output 'consolidation.png'
settlement = "< sed 's/^# Time/Time/' postProcessing/settlement/0/errors.dat"
set multiplot layout 1,2
set grid
series(z, T) = 0.998185*4/pi*sum [m=0:30] (sin((2*m + 1)*pi/2*z)*exp(-((2*m + 1)*pi/2)**2*T)/(2*m + 1))
y = 1 - 0.5*0.03125
left(T) = 8/pi**2*sum [m=0:200] (cos((2*m + 1)*pi/2*(1 - y))*exp(-((2*m + 1)*pi/2)**2*T)/(2*m + 1)**2)
set xlabel 'pore pressure over the load'
set ylabel 'height [m]'
set xrange [0:1.05]
set yrange [0:1]
set parametric
set trange [0:1]
set samples 200
set key top right
plot series(1 - t, 0.05),t with lines lc 'black' title 'Terzaghi (1943)', series(1 - t, 0.2),t with lines lc 'black' notitle, series(1 - t, 0.5),t with lines lc 'black' notitle, \
    series(1 - t, 1),t with lines lc 'black' notitle, 'postProcessing/rows/0.07019883115/bins_porePressure.xy' using (1e-3*$2):1 with points pt 6 ps 0.8 lc rgb '#0060ad' title 'T = 0.05', \
    'postProcessing/rows/0.2807953246/bins_porePressure.xy' using (1e-3*$2):1 with points pt 4 ps 0.8 lc rgb '#d95319' title '0.2', 'postProcessing/rows/0.7019883115/bins_porePressure.xy' using (1e-3*$2):1 with points pt 8 ps 0.8 lc rgb '#1a8a34' title '0.5', \
    'postProcessing/rows/1.403976623/bins_porePressure.xy' using (1e-3*$2):1 with points pt 2 ps 0.8 lc rgb '#7e2f8e' title '1'
unset parametric
set xlabel 'T = c_v t/H^2'
set ylabel 'settlement of the topmost row [mm]' noenhanced
set xrange [0:1]
set yrange [0.1:0]
set key default
set key top right
plot 0.1*(y - 0.998185*left(x)) with lines lc 'black' title 'Terzaghi (1943)', settlement using (0.712262571*column('Time')):(1e3*column('value')) with points pt 6 ps 0.8 lc rgb '#0060ad' title 'topmost row'
