# SPDX-License-Identifier: MIT
# Largest error of every power over the exponent.
set terminal svg size 1020,600 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = 1
number(s) = sum [i=1:words(series)] (named(i) eq s ? i : 0)
colour(s) = has(s, "half a step") ? grey : word(join(blue, red, gold, violet, teal, ink, green), number(s))
join(a, b, c, d, e, f, g) = sprintf("%s %s %s %s %s %s %s", a, b, c, d, e, f, g)
shape(s) = has(s, "half a step") ? 0 : 7
thick(s) = has(s, "glint") ? 3 : 1.2
dash(s) = has(s, "half a step") ? 2 : 1
panel = ""
set title heading
set logscale xy
set xtics (0.25, 1, 4, 16, 64, 256, 1024, 4096)
set ytics @ticks
set xlabel "exponent p"
set ylabel "largest error, steps of 8 bits"
@draw
