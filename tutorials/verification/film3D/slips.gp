# The film's mean velocity over Nusselt's against time at both wall stresses, for four background pressures: gnuplot slips.gp
set terminal pngcairo size 1100,400 font ',10'
set output 'slips.png'
set datafile separator tab
flow(kind, g) = "< sed 's/^# Time/Time/' run/".kind."-".g."/postProcessing/flow/0/reduction.dat"
set multiplot layout 1,2
kinds = "default tenth whole hundredth"
titles = "0.8 0.08 0.02 0.01"
colours = "#d95319 #0060ad black #3a923a"
set xlabel 't [s]'
set ylabel 'mean velocity over that of Nusselt'
set yrange [0:1.6]
set xrange [0:0.12]
set key bottom right title 'p_b dx/{/Symbol g}'
set title 'wall stress 6e-3 {/Symbol g}/dx'
plot 1 with lines lc rgb 'grey' notitle, for [k=1:4] flow(word(kinds, k), '12') using 'Time':'ratio' with lines lw 1.5 lc rgb word(colours, k) title word(titles, k)
set title 'wall stress 6e-4 {/Symbol g}/dx'
plot 1 with lines lc rgb 'grey' notitle, for [k=1:4] flow(word(kinds, k), '1.2') using 'Time':'ratio' with lines lw 1.5 lc rgb word(colours, k) title word(titles, k)
