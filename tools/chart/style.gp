# SPDX-License-Identifier: MIT
# What all charts share. chart.py sets `data`, a file of rows (panel, series, x, y), and `panels` and `series`, which it names.
# A chart says which series are lines, and gives each a colour, a shape and a dash; @draw draws what a panel has.
set encoding utf8
set datafile separator tab
set datafile missing NaN
paper = "#fcfcfb"; ink = "#24292f"; grey = "#6e7781"
blue = "#1f6fb5"; gold = "#946200"; red = "#b3261f"; green = "#1a7a36"; violet = "#7a45c4"; teal = "#0b7285"
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
dash(s) = 1
thick(s) = 1.5
draw = 'plot for [i=1:words(series)] data using (pick(i, 1, 3)):(pick(i, 1, 4)) with linespoints pt shape(named(i)) ps 0.5 dt dash(named(i)) lw thick(named(i)) lc rgb colour(named(i)) title is_line(named(i)) ? label(named(i)) : "", for [i=1:words(series)] data using (pick(i, 0, 3)):(pick(i, 0, 4)) with points pt shape(named(i)) ps 0.8 lw 1.3 lc rgb colour(named(i)) title is_line(named(i)) ? "" : label(named(i))'
# Ticks of a logarithmic axis.
ticks = '(0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100, 300, 1000, 3000, 10000)'
