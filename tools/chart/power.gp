# SPDX-License-Identifier: MIT
# Largest error over instructions of every method on each core; bars reach to the worst exponent.
set terminal svg size 1100,800 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = has(s, "best for") || has(s, "half a step")
first = word(series, 1)
is_first(s) = s[1:strstrt(first, ":") - 1] eq first[1:strstrt(first, ":") - 1]
colour(s) = has(s, "half a step") ? grey : is_first(s) ? navy : gold
number(s) = sum [i=1:words(series)] (named(i) eq s ? i : 0)
shape(s) = is_line(s) ? 0 : has(s, "glint") ? (is_first(s) ? 7 : 13) : word("1 2 3 4 8 6 10 12 14", number(s)) + 0
dash(s) = 2
set logscale xy
set xtics (1, 10, 100, 1000, 10000)
set ytics @ticks
set yrange [0.006:has(heading, "cos") ? 200 : 1]
set xlabel "instructions per call"
set ylabel "largest error, steps of 8 bits" offset 1,0
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set multiplot layout 2,2 margins 0.07,0.69,0.07,0.92 spacing 0.09,0.12 title heading
do for [j=1:words(panels)] {
    panel = word(panels, j)
    set title panel
    if (j == 1) { set key left at screen 0.70,0.92 } else { unset key }
    plot for [i=1:words(series)] data using (pick(i, 0, 3)):(pick(i, 0, 4)):(pick(i, 0, 4)):5 with yerrorbars pt -1 lw 0.8 lc rgb colour(named(i)) notitle, @draw_lines, @draw_points
}
