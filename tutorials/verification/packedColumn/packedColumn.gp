# Porosity across the column: gnuplot packedColumn.gp
set terminal pngcairo size 640,440 font ',10'
set output 'packedColumn.png'
set datafile separator ','
set xlabel 'distance from the wall [sphere diameters]'
set ylabel 'porosity [-]'
set xrange [0:4]
set yrange [0:1]
set grid
plot 'run/profile.csv' using 1:2 with lines lw 2 title 'three columns, D/d = 8', '' using 1:3 with lines dt 2 lc rgb 'black' title 'de Klerk (2003)', \
    for [f in 'postProcessing run/seed2/postProcessing run/seed3/postProcessing'] f.'/solids/radialPorosity.csv' using 2:3 with lines lw 0.5 lc rgb 'grey' notitle
