# SPDX-License-Identifier: MIT
# Errors of each evaluation over triangles and over instructions.
set terminal svg size 960,790 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = 1
colour(s) = evaluation_colour(s)
shape(s) = evaluation_shape(s)
set logscale xy
set xtics @ticks
set ytics @ticks
set ylabel "rms error, steps of 8 bits" offset 1,0
set multiplot layout 2,2 margins 0.075,0.98,0.07,0.9 spacing 0.1,0.13 title heading
do for [j=1:words(panels)] {
    panel = word(panels, j)
    set title word(panel, 1)
    set xlabel has(panel, "triangles") ? "triangles" : "million instructions per frame on Cortex-M3"
    set key inside right top width 2
    @draw
}
