# SPDX-License-Identifier: GPL-3.0-or-later
# Channels of a report, side by side. Set before: file (name of the data and the picture),
# n, found (1: there is a last column), and of each channel Title, Unit, Axis ('': a number
# alone) and Length along that axis.
rows(n, columns) = (n + columns - 1)/columns
columns = n < 2 ? 1 : n < 5 ? 2 : 3

# Three to eight labels: gnuplot's own overlap in three columns
power(step) = 10.0**floor(log10(step))
leading(step) = step < 1.5 ? 1 : step < 3.5 ? 2 : step < 7.5 ? 5 : 10
labels(step) = power(step)*leading(step/power(step))

set terminal pngcairo size 1100, 80 + 270*rows(n, columns) noenhanced font ',11'
set output file.'.png'
set multiplot layout rows(n, columns), columns \
    title 'points: recorded; grey: uncertain (2 sigma); blue, dashed: calibrated base' \
    .(found ? '; red: with what was found' : '')
set style fill transparent solid 0.35 noborder
unset key
data = file.'.dat'
do for [i = 1:n] {
    set title Title[i]
    set ylabel Unit[i]
    set xlabel Axis[i]
    if (Axis[i] eq '') {
        set xrange [-0.5:(found ? 2.5 : 1.5)]
        set xtics ('recorded' 0, 'base' 1, 'found' 2)
        plot data index i - 1 using (0):2:(2*$3) with yerrorbars \
                pointtype 7 linecolor 'black', \
            '' index i - 1 using (1):4 with points \
                pointtype 9 pointsize 2 linecolor 'blue', \
            '' index i - 1 using (2):(found ? $5 : NaN) with points \
                pointtype 9 pointsize 2 linecolor 'red'
    } else {
        set autoscale x
        set xtics labels(0.25*Length[i])
        plot data index i - 1 using 1:($2-2*$3):($2+2*$3) with filledcurves \
                linecolor 'gray', \
            '' index i - 1 using 1:2 with points \
                pointtype 7 pointsize 0.5 linecolor 'black', \
            '' index i - 1 using 1:4 with lines \
                linewidth 2 dashtype 2 linecolor 'blue', \
            '' index i - 1 using 1:(found ? $5 : NaN) with lines \
                linewidth 2 linecolor 'red'
    }
}
unset multiplot
