# SPDX-License-Identifier: MIT
# Error against the smooth surface over triangles and over instructions: gnuplot -e "csv='...'" shading.gp > shading.svg
set terminal svg size 900,420 font "sans-serif,13" background "#f8f8f8"
set datafile separator ","
set multiplot layout 1,2 title "A torus with a highlight (p = 50), 320x240: error against the true smooth surface"
set logscale xy
set grid linecolor "#cccccc"
set key off
set border linecolor "#444444"
set ylabel "root mean square error, steps of 8 bits"
set yrange [0.4:40]
set xlabel "triangles"
set xrange [100:50000]
set style line 1 linecolor "#b8860b" linewidth 2 pointtype 7 pointsize 0.6
set style line 2 linecolor "#1f6fb4" linewidth 2 pointtype 7 pointsize 0.6
set style line 3 linecolor "#b02a30" linewidth 2 pointtype 7 pointsize 0.6
select(name, wanted, value) = (strcol(name) eq wanted ? column(value) : NaN)
set label 1 "per facet" at 10500,4.6 textcolor "#8a6508"
set label 2 "per vertex" at 10500,1.75 textcolor "#1f6fb4"
set label 3 "per fragment" at 10500,0.62 textcolor "#b02a30"
set datafile missing NaN
plot csv using 2:(select(1, "facet", 3)) with linespoints linestyle 1, \
     csv using 2:(select(1, "vertex", 3)) with linespoints linestyle 2, \
     csv using 2:(select(1, "fragment", 3)) with linespoints linestyle 3
set xlabel "instructions per frame on Cortex-M3, millions"
set xrange [2:60]
unset label
set label 1 "per facet" at 4.1,24 textcolor "#8a6508"
set label 2 "per vertex" at 8.8,19 textcolor "#1f6fb4"
set label 3 "per fragment" at 20,0.85 textcolor "#b02a30"
plot csv using (column(5) / 1e6):(select(1, "facet", 3)) with linespoints linestyle 1, \
     csv using (column(5) / 1e6):(select(1, "vertex", 3)) with linespoints linestyle 2, \
     csv using (column(5) / 1e6):(select(1, "fragment", 3)) with linespoints linestyle 3
unset multiplot
