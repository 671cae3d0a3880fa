# phi across the channel in steady state for three ratios D_c/D_eta beside the exact profiles: gnuplot profiles.gp
set terminal pngcairo size 700,430 font ',10'
set output 'profiles.png'
phi_m = 0.794; c = 0.714; h = 1.25e-4
s(phi, wall, ratio) = wall/phi*((phi_m - phi)/(phi_m - wall))**(c*(1/ratio - 1))
file(ratio, n) = system('ls run/workPrecision/ratio'.ratio.'/'.n.'/postProcessing/profile/*/bins_phi_U_gammaDot_eta.xy')
ratios = "0.4 0.2 0.1"; walls = "0.506412 0.571368 0.599789"; colours = "#0060ad #d95319 #3a923a"
set parametric
set trange [0:1]
set samples 600
set xrange [0:1]
set yrange [0.5:0.8]
set xlabel '|y|/h, from the middle'
set ylabel 'phi'
plot for [k=1:3] s(word(walls, k) + t*(phi_m - word(walls, k)), word(walls, k) + 0, word(ratios, k) + 0), word(walls, k) + t*(phi_m - word(walls, k)) \
        lc rgb word(colours, k) title 'D_c/D_{eta} = '.word(ratios, k).', exact', \
    for [k=1:3] file(word(ratios, k), '19') using (abs($1/h - 1)):2 with points pt 7 lc rgb word(colours, k) title '19 across', \
    for [k=1:3] file(word(ratios, k), '39') using (abs($1/h - 1)):2 with points pt 1 lc rgb word(colours, k) title '39 across'
