# SPDX-License-Identifier: MIT
# What the bus takes over what the core takes; above the diagonal the bus takes longer.
set terminal svg size 1020,560 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
colour(s) = has(s, "320x240, ") && has(s, "torus") ? blue : has(s, "torus") ? red : has(s, "teapot") ? teal : has(s, "phong") ? violet : gold
shape(s) = has(s, "RP2040") ? 7 : has(s, "STM32F103") ? 5 : 9
panel = ""
set title heading
set logscale xy
set xrange [0.5:3000]
set yrange [0.5:200]
set xtics @ticks
set ytics @ticks
set xlabel "core, ms by the model of cycles"
set ylabel "bus, ms"
@draw, x with lines dt 2 lc rgb grey title "above the line the bus takes longer"
