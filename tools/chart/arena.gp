# SPDX-License-Identifier: MIT
# What a smaller arena costs.
set terminal svg size 820,520 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = !has(s, "stay")
colour(s) = has(s, "torus") ? blue : has(s, "spot") ? red : has(s, "teapot") ? teal : gold
shape(s) = is_line(s) ? 0 : 7
panel = ""
set key inside
set title heading
set logscale xy
set xtics @ticks
set ytics @ticks
set yrange [0.9:*]
set xlabel "arena, KB"
set ylabel "instructions, times those of one pass"
@draw
