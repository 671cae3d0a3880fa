# phi and gammaDot across the channel in steady state beside eq. (4.1) of Kauzlaric et al. (2011): gnuplot profiles.gp
set terminal pngcairo size 1100,430 font ',10'
set output 'profiles.png'
set multiplot layout 1,2
phi_0 = 0.45; phi_m = 0.68; c = 1.82; mu_0 = 33.2; G = 1.28e8; h = 1.25e-4
phi(s) = phi_m*phi_0/(phi_0 + s*(phi_m - phi_0))
gammaDot(s) = G*h*s/mu_0*(1 - phi(s)/phi_m)**c
file(variant, n) = system('ls run/workPrecision/'.variant.'/'.n.'/postProcessing/profile/*/bins_phi_U_gammaDot_eta.xy')
set samples 400
set xlabel 'y/h - 1'
set key bottom center
set ylabel 'phi'
plot [-1:1] phi(abs(x)) lc 'black' title 'exact', \
    for [n in "9 19 39"] file('suite', n) using ($1/h - 1):2 with points pt (n eq '9' ? 7 : n eq '19' ? 5 : 1) ps (n eq '39' ? 0.6 : 1) lc rgb '#0060ad' title 'suite, '.n.' across', \
    for [n in "9 19"] file('paper', n) using ($1/h - 1):2 with points pt (n eq '9' ? 6 : 4) ps 1 lc rgb '#d95319' title 'as printed, '.n.' across'
set ylabel 'gammaDot [1/s]'
set key top center
plot [-1:1] gammaDot(abs(x)) lc 'black' title 'exact', \
    for [n in "9 19 39"] file('suite', n) using ($1/h - 1):6 with points pt (n eq '9' ? 7 : n eq '19' ? 5 : 1) ps (n eq '39' ? 0.6 : 1) lc rgb '#0060ad' title 'suite, '.n.' across', \
    for [n in "9 19"] file('paper', n) using ($1/h - 1):6 with points pt (n eq '9' ? 6 : 4) ps 1 lc rgb '#d95319' title 'as printed, '.n.' across'
