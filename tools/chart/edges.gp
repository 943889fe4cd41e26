# SPDX-License-Identifier: MIT
# What smooth edges cost, and what they and dithering add.
set terminal svg size 820,420 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
colour(s) = has(s, "2x2") ? navy : gold
shape(s) = has(s, "dithered") ? 7 : 5
size(s) = 1.1
set key inside right bottom
set title heading
set xlabel "million instructions a frame, Cortex-M3"
set xrange [0:*]
set yrange [*:*]
set offsets 0,0.5,1,1
panel = word(panels, 1)
set ylabel "PSNR against 64 samples a pixel, dB"
@draw
