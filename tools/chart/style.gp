# SPDX-License-Identifier: MIT
# What all charts share. chart.py sets `data`, a file of rows (panel, series, x, y), and `panels` and `series`, which it names.
# A chart says which series are lines, and gives each a colour, a shape and a dash; @draw draws what a panel has.
# Colours differ in lightness, for readers who do not tell red from green, and for paper; shapes tell the same as colours.
set encoding utf8
set datafile separator tab
set datafile missing NaN
paper = "#fcfcfb"; ink = "#24292f"; grey = "#6e7781"
navy = "#0b2f5c"; blue = "#1c76a8"; gold = "#d98a00"; purple = "#9c3587"
set grid linecolor rgb "#dce0e5" linewidth 0.6 linetype 1
set border linecolor rgb grey
set tics textcolor rgb ink nomirror scale 0.5
set key outside right top Left reverse textcolor rgb ink noenhanced width -4 font ",11"
set title noenhanced offset 0,-0.6

has(s, word) = strstrt(s, word) > 0
named(i) = word(series, i)
pick(i, lines, c) = is_line(named(i)) == lines && strcol(1) eq panel && strcol(2) eq named(i) ? column(c) : NaN
is_line(s) = 0
label(s) = s
colour(s) = ink
shape(s) = 7
size(s) = 0.8
dash(s) = 1
thick(s) = 1.5
draw_lines = 'for [i=1:words(series)] data using (pick(i, 1, 3)):(pick(i, 1, 4)) with linespoints pt shape(named(i)) ps 0.6 dt dash(named(i)) lw thick(named(i)) lc rgb colour(named(i)) title is_line(named(i)) ? label(named(i)) : ""'
draw_points = 'for [i=1:words(series)] data using (pick(i, 0, 3)):(pick(i, 0, 4)) with points pt shape(named(i)) ps size(named(i)) lw 1.3 lc rgb colour(named(i)) title is_line(named(i)) ? "" : label(named(i))'
draw = 'plot @draw_lines, @draw_points'
# Ticks of a logarithmic axis.
ticks = '(0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100, 300, 1000, 3000, 10000)'

# Ways to light: the shape and the colour tell where light is evaluated, the size the model, a filled mark the local viewer.
evaluation(s) = has(s, "per facet") ? 1 : has(s, "per vertex") ? 2 : has(s, "per fragment") ? 3 : 4
evaluation_colour(s) = word(sprintf("%s %s %s %s", gold, blue, navy, ink), evaluation(s))
evaluation_shape(s) = word("9 5 7 13", evaluation(s)) + 0
way_shape(s) = has(s, "Lambert") ? evaluation(s) : evaluation_shape(s) - has(s, "infinite")
way_size(s) = has(s, "Blinn") ? 1 : has(s, "Lambert") ? 0.6 : 0.45
# Phong's small mark stands out of Blinn-Phong's by a rim.
is_rimmed(s) = has(s, "Phong local") && !has(s, "Blinn")
rim(i, c) = is_rimmed(named(i)) ? pick(i, 0, c) : NaN
draw_ways = '@draw_points, for [i=1:words(series)] data using (rim(i, 3)):(rim(i, 4)) with points pt shape(named(i)) ps size(named(i)) + 0.25 lc rgb paper notitle, for [i=1:words(series)] data using (rim(i, 3)):(rim(i, 4)) with points pt shape(named(i)) ps size(named(i)) lc rgb colour(named(i)) notitle'
