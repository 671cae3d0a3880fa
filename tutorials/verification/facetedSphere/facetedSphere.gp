# Differences from the formula against the edges of the facets: gnuplot facetedSphere.gp
set terminal pngcairo size 700,430 font ',10'
set output 'facetedSphere.png'
of(place, figure) = "< awk -F, 'sub(/^".place."16edge/, \"\", $1) && $2 == \"".figure."\" { print $1, $3 < 0 ? -$3 : $3 }' run/results.csv"
set xlabel 'edge of the facets [spacings]'
set ylabel 'difference from the formula [%]'
set logscale xy
set xrange [0.4:4.5]
set yrange [0.01:20]
set xtics (0.5, 1, 1.8, 3.6)
set key top left
plot 1 with lines dt 2 lc rgb 'black' title 'bound', of('lattice', 'difference of the pressure') with linespoints pt 7 title 'pressure, on the lattice', \
    of('off', 'difference of the pressure') with linespoints pt 7 title 'pressure, off it', \
    of('lattice', 'difference of the drag') with linespoints pt 5 title 'drag, on the lattice', \
    of('off', 'difference of the drag') with linespoints pt 5 title 'drag, off it'
