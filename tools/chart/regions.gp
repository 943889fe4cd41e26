# SPDX-License-Identifier: MIT
# Where plain methods fail: how far they are off there, and how far the library is.
set terminal svg size 1280,980 font "DejaVu Sans,11" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
of(name, c) = strcol(2) eq name ? column(c) : NaN
set title heading
set logscale x
set xrange [0.08:400]
set yrange [words(panels) - 0.3:-0.7]
set ytics scale 0
set y2tics scale 0
set y2range [words(panels) - 0.3:-0.7]
set xtics (0.1, 0.3, 1, 3, 10, 30, 100, 255)
set xlabel "largest error of a colour, steps of 255"
set key at screen 0.54,0.045 center top vertical maxrows 1 width 0 samplen 2
set lmargin at screen 0.405
set rmargin at screen 0.683
set bmargin at screen 0.105
set tmargin at screen 0.96
plot data using (of("contract", 3)):(column(4) - 0.4):(0):(0.8) with vectors nohead lw 1.5 lc rgb grey title "bound of the contract", \
    "" using (of("glint", 3)):4:(column(5) - column(3)):(0) with vectors nohead lw 0.8 lc rgb grey notitle, \
    "" using (of("plain method", 3)):4:ytic(strcol(6)):y2tic(strcol(7)) with points pt 2 ps 0.8 lw 2 lc rgb gold title "plain method, named on the right", \
    "" using (of("glint", 3)):4 with points pt 7 ps 0.8 lc rgb navy title "glint, RGB888", \
    "" using (of("topic", 3)):4:5 with labels left font "DejaVu Sans Bold,11" notitle
