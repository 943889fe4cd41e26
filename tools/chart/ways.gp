# SPDX-License-Identifier: MIT
# PSNR over instructions of every way to light, by the kind and the number of lights, on each core.
set terminal svg size 1240,960 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
colour(s) = evaluation_colour(s)
shape(s) = way_shape(s)
size(s) = way_size(s)
# The best is joined from 1 light to 8, and says how many.
is_best(i) = has(named(i), "per fragment Blinn-Phong local")
best(i, c) = is_best(i) ? pick(i, 0, c) : NaN
lights = 0.5
count(i) = best(i, 3) == best(i, 3) ? (lights = 2 * lights, sprintf("%.0f", lights)) : ""
set logscale x
set xrange [0.33:32]
set yrange [18:47]
set xtics (0.5, 1, 2, 5, 10, 20)
set multiplot layout 3,5 margins 0.045,0.99,0.185,0.93 spacing 0.022,0.055 title heading
do for [j=1:words(panels)] {
    panel = word(panels, j)
    set title panel
    set xlabel j > 10 ? "million instructions per frame" : ""
    set ylabel j % 5 == 1 ? "PSNR, dB" : "" offset 1,0
    if (j == 1) { set key at screen 0.52,0.105 center top vertical maxrows 5 width 2 } else { unset key }
    lights = 0.5
    plot for [i=1:words(series)] data using (best(i, 3)):(best(i, 4)) with lines lw 0.8 lc rgb grey notitle, @draw_ways, \
        for [i=1:words(series)] data using (best(i, 3)):(best(i, 4)):(count(i)) with labels font ",9" offset 0,0.7 notitle
}
