# SPDX-License-Identifier: MIT
# Instructions of frames that grow, and the lines that were fitted to them.
set terminal svg size 960,1140 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = has(s, "fitted")
colour(s) = has(s, "M3") ? blue : red
label(s) = has(s, "fitted") ? "" : s
shape(s) = is_line(s) ? 0 : has(s, "farthest") ? 6 : 7
set xrange [0:*]
set yrange [0:*]
set ylabel "million instructions per frame" offset 1,0
set key inside left top
set multiplot layout 3,2 margins 0.06,0.98,0.06,0.95 spacing 0.08,0.07 title heading
do for [j=1:words(panels)] {
    panel = word(panels, j)
    set xlabel panel
    @draw
}
