# phi over the radius in steady state for three ratios D_c/D_eta beside the exact profiles: gnuplot profiles.gp
set terminal pngcairo size 700,430 font ',10'
set output 'profiles.png'
phi_m = 0.794; c = 0.714; h = 1.25e-4
s(phi, wall, ratio) = wall/phi*((phi_m - phi)/(phi_m - wall))**(c*(1/ratio - 1))
folder(ratio) = system('ls -d run/workPrecision/ratio'.ratio.'/19/*e-*[0-9] run/workPrecision/ratio'.ratio.'/19/0.000* 2>/dev/null | sort -t/ -k5 -g | tail -n 1')
ratios = "0.4 0.2 0.1"; walls = "0.563360 0.598038 0.612385"; colours = "#0060ad #d95319 #3a923a"
set datafile separator ','
set parametric
set trange [0:1]
set samples 600
set xrange [0:1]
set yrange [0.55:0.8]
set xlabel 'r/R'
set ylabel 'phi'
plot for [k=1:3] s(word(walls, k) + t*(phi_m - word(walls, k)), word(walls, k) + 0, word(ratios, k) + 0), word(walls, k) + t*(phi_m - word(walls, k)) \
        lc rgb word(colours, k) title 'D_c/D_{eta} = '.word(ratios, k).', exact', \
    for [k=1:3] '< ../squareChannel/particleTable '.folder(word(ratios, k)).' phi' using (sqrt($2**2 + $3**2)/h):4 with points pt 7 ps 0.5 lc rgb word(colours, k) title '19 across'
