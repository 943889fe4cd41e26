# SPDX-License-Identifier: MIT
# Errors of colours with each evaluation, and of depth, over the depth ratio.
set terminal svg size 1080,420 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = 1
colour(s) = evaluation_colour(s)
shape(s) = evaluation_shape(s)
set logscale xy
set xtics ("2^0" 1, "2^8" 2.0**8, "2^16" 2.0**16, "2^24" 2.0**24, "2^32" 2.0**32)
set ytics @ticks
set xlabel "depth over that of the nearest geometry"
set key inside left top width 2
set multiplot layout 1,3 margins 0.05,0.98,0.14,0.82 spacing 0.06 title heading
do for [j=1:words(panels)] {
    panel = word(panels, j)
    set title panel
    @draw
}
