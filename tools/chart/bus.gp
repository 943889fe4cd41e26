# SPDX-License-Identifier: MIT
# What the bus takes over what the core takes; above the diagonal the bus takes longer.
set terminal svg size 1120,460 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
number(s) = sum [i=1:words(series)] (named(i) eq s ? i : 0)
colour(s) = word(sprintf("%s %s %s %s %s", navy, gold, blue, purple, ink), number(s))
shape(s) = word("7 4 9 12 3", number(s)) + 0
size(s) = 1
set logscale xy
set xrange [3:3000]
set yrange [1:200]
set xtics (3, 10, 30, 100, 300, 1000)
set ytics @ticks
set xlabel "core, ms by the model of cycles"
set multiplot layout 1,3 margins 0.05,0.985,0.3,0.87 spacing 0.04 title heading
do for [j=1:words(panels)] {
    panel = word(panels, j)
    set title panel
    set ylabel j == 1 ? "bus, ms" : "" offset 1,0
    if (j == 1) { set key at screen 0.52,0.13 center top vertical maxrows 2 width 3 } else { unset key }
    @draw, x with lines dt 2 lc rgb grey title "above the line the bus takes longer"
}
