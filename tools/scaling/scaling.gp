# SPDX-License-Identifier: MIT
# Cost of a frame as it grows: gnuplot -e "csv='...'" scaling.gp > scaling.svg
set terminal svg size 900,760 font "sans-serif,13" background "#f8f8f8"
set datafile separator ","
set datafile missing NaN
set multiplot layout 2,2 title "How a frame's cost grows (torus2304 at 320x240, one light, local viewer, where not varied); lines are straight-line fits"
set grid linecolor "#cccccc"
set key off
set border linecolor "#444444"
set ylabel "million instructions per frame"
set yrange [0:*]
set xrange [0:*]
of(wanted, cpu, value) = (strcol(2) eq wanted && strcol(1) eq cpu ? value : NaN)
line(wanted, cpu) = of(wanted, cpu, (column(5) + column(6) * column(3)) / 1e6)
set style line 1 linecolor "#1f6fb4" linewidth 1.5 pointtype 7 pointsize 0.6
set style line 2 linecolor "#b02a30" linewidth 1.5 pointtype 7 pointsize 0.6
sweeps = "triangles pixels lights objects"
names = "'triangles, thousands' 'screen, thousand pixels (same share covered)' 'lights' 'objects of 192 triangles'"
scale(i) = i <= 2 ? 1e3 : 1
do for [i=1:4] {
    sweep = word(sweeps, i)
    set xlabel word(names, i)
    # each core's name stands beside its line
    stats csv using (of(sweep, "m3", column(3) / scale(i))):(line(sweep, "m3")) name "M3" nooutput
    stats csv using (of(sweep, "m0", column(3) / scale(i))):(line(sweep, "m0")) name "M0" nooutput
    set label 1 "Cortex-M0" at 0.62 * M0_max_x, M0_slope * 0.62 * M0_max_x + M0_intercept right offset -1,0.8 textcolor "#b02a30"
    set label 2 "Cortex-M3" at 0.68 * M3_max_x, M3_slope * 0.68 * M3_max_x + M3_intercept left offset 1,-1 textcolor "#1f6fb4"
    plot csv using (column(3) / scale(i)):(of(sweep, "m3", column(4) / 1e6)) with points linestyle 1, \
         csv using (column(3) / scale(i)):(line(sweep, "m3")) with lines linestyle 1, \
         csv using (column(3) / scale(i)):(of(sweep, "m0", column(4) / 1e6)) with points linestyle 2, \
         csv using (column(3) / scale(i)):(line(sweep, "m0")) with lines linestyle 2
}
unset multiplot
