# SPDX-License-Identifier: MIT
# PSNR over instructions of frames, by every way to light and by other libraries, which are letters.
set terminal svg size 1240,560 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = has(s, "best for") || has(s, "rounded")
is_other(s) = has(s, ",") && !is_line(s)
colour(s) = has(s, "best for") ? ink : is_line(s) ? grey : is_other(s) ? paper : evaluation_colour(s)
letter(s) = has(s, "TGX") ? "T" : has(s, "Pico3D") ? "P" : has(s, "callback") ? "C" : has(s, "small3dlib, per vertex") ? "s" : \
    has(s, "small3dlib") ? "S" : has(s, "TinyGL") ? "Y" : has(s, "PortableGL") ? "O" : has(s, "naive") ? "N" : "F"
shape(s) = is_line(s) || is_other(s) ? 0 : way_shape(s)
size(s) = is_other(s) ? 0 : way_size(s)
label(s) = is_other(s) ? letter(s) . "  " . s : s
dash(s) = has(s, "best for") ? 1 : 2
thick(s) = 1
other(i, c) = is_other(named(i)) ? pick(i, 0, c) : NaN
set logscale x
set xtics @ticks
set xlabel "million instructions per frame"
set yrange [19:45]
set offsets graph 0.05, graph 0.05, 0, 0
set multiplot layout 1,3 margins 0.04,0.735,0.11,0.88 spacing 0.03 title heading
do for [j=1:words(panels)] {
    panel = word(panels, j)
    set title panel
    set ylabel j == 1 ? "PSNR, dB" : "" offset 1,0
    if (j == 1) { set key left at screen 0.745,0.91 spacing 0.8 width -12 samplen 2 font ",10" } else { unset key }
    plot @draw_lines, @draw_ways, for [i=1:words(series)] data using (other(i, 3)):(other(i, 4)):(letter(named(i))) with labels font "DejaVu Sans Bold,12" tc rgb purple notitle
}
