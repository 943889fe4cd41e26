# SPDX-License-Identifier: MIT
# What a smaller arena costs.
set terminal svg size 820,520 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = !has(s, "stay")
colour(s) = has(s, "torus") ? navy : has(s, "spot") ? gold : has(s, "teapot") ? blue : purple
shape(s) = (has(s, "torus") ? 6 : has(s, "spot") ? 8 : has(s, "teapot") ? 4 : 12) + !is_line(s)
size(s) = 1
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
