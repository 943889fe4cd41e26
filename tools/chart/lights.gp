# SPDX-License-Identifier: MIT
# Instructions over the number of lights.
set terminal svg size 820,520 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = 1
colour(s) = has(s, "directional") ? blue : has(s, "point") ? red : gold
dash(s) = has(s, "float") ? 2 : 1
thick(s) = 2
panel = ""
set key inside left top
set title heading
set xrange [0:8]
set yrange [0:*]
set xlabel "lights"
set ylabel "million instructions per frame"
@draw
