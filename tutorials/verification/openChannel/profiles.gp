# U across the channel one and a half widths from the inlet, and p along it, beside the solution: gnuplot profiles.gp
set terminal pngcairo size 1100,430 font ',10'
set output 'profiles.png'
set multiplot layout 1,2
folder(variant, n) = 'run/workPrecision/'.variant.'/'.n.'/postProcessing/'
end = '/0.02/'
colours = "#0060ad #d95319 #3a923a"
set xlabel 'y [mm]'
set ylabel 'U_x [m/s]'
set key bottom center
plot [0:1] 0.6*x*(1 - x) with lines lc rgb 'black' title '6 U y (W - y)/W^2', \
    for [k=1:3] folder('suite', word("8 16 32", k)).'across'.end.'bins_U.xy' using (1e3*$1):2 with points pt 7 ps 0.8 lc rgb word(colours, k) title word("8 16 32", k).' across'
set xlabel 'x [mm]'
set ylabel 'p [Pa]'
set key top right
plot [0:3] 120*(3 - x) with lines lc rgb 'black' title '12 {/Symbol m} U (L - x)/W^2', \
    folder('suite', '16').'along'.end.'bins_p.xy' using (1e3*$1):2 with points pt 7 ps 0.8 lc rgb word(colours, 1) title 'developed profile', \
    folder('uniform', '16').'along'.end.'bins_p.xy' using (1e3*$1):2 with points pt 7 ps 0.8 lc rgb word(colours, 2) title 'uniform profile'
