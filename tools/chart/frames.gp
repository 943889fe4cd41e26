# SPDX-License-Identifier: MIT
# PSNR over instructions of frames, by every choice of shading and by other libraries.
set terminal svg size 1120,954 font "DejaVu Sans,12" background "#fcfcfb" noenhanced
load "tools/chart/style.gp"
is_line(s) = has(s, "best for") || has(s, "rounded")
colour(s) = has(s, "best for") ? green : s[1:9] eq "per facet" ? gold : s[1:10] eq "per vertex" ? blue : s[1:12] eq "per fragment" ? red : \
    is_line(s) ? grey : violet
shape(s) = is_line(s) ? 0 : has(s, "Lambert") ? 8 : has(s, "Blinn-Phong local") ? 7 : has(s, "Blinn-Phong infinite") ? 6 : has(s, "Phong local") ? 5 : \
    has(s, "Phong infinite") ? 4 : has(s, "TGX") ? 1 : has(s, "Pico3D") ? 2 : has(s, "small3dlib, per vertex") ? 12 : has(s, "callback") ? 3 : \
    has(s, "small3dlib") ? 13 : has(s, "TinyGL") ? 10 : has(s, "PortableGL") ? 11 : 9
dash(s) = 2
set logscale x
set xtics @ticks
set xlabel "million instructions per frame"
set ylabel "PSNR, dB" offset 1,0
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set multiplot layout 2,2 margins 0.05,0.69,0.06,0.92 spacing 0.08,0.11 title heading
do for [j=1:words(panels)] {
    panel = word(panels, j)
    set title panel
    if (j == 1) { set key left at screen 0.70,0.925 spacing 0.8 font ",10" } else { unset key }
    @draw
}
