# Differences from the formula against the edges of the facets: gnuplot facetedSphere.gp
set terminal pngcairo size 700,430 font ',10'
set output 'facetedSphere.png'
set datafile separator ','
set datafile missing NaN
edge(place) = strcol(1)[1:strlen(place) + 6] eq place.'16edge' ? real(strcol(1)[strlen(place) + 7:]) : NaN
of(place, figure) = strcol(2) eq 'difference of the '.figure ? edge(place) : NaN
set xlabel 'edge of the facets [spacings]'
set ylabel 'difference from the formula [%]'
set logscale xy
set xrange [0.4:4.5]
set yrange [0.01:20]
set xtics (0.5, 1, 1.8, 3.6)
set key top left
plot 1 with lines dt 2 lc rgb 'black' title 'bound', \
    'run/results.csv' using (of('lattice', 'pressure')):(abs($3)) with linespoints pt 7 title 'pressure, on the lattice', \
    '' using (of('off', 'pressure')):(abs($3)) with linespoints pt 7 title 'pressure, off it', \
    '' using (of('lattice', 'drag')):(abs($3)) with linespoints pt 5 title 'drag, on the lattice', \
    '' using (of('off', 'drag')):(abs($3)) with linespoints pt 5 title 'drag, off it'
