# SPDX-License-Identifier: GPL-3.0-or-later
# The misfit of all channels over time or distance, in standard deviations, before and,
# where found is 1, with what was found. Set before: found, n, and the Name of each channel.
set terminal pngcairo size 1100, 140 + 50*n noenhanced font ',11'
set output 'map.png'
set multiplot layout 1, found ? 2 : 1
set palette defined (-6 'blue', 0 'white', 6 'red')
set cbrange [-6:6]
set cblabel 'recorded - simulated [sigma]'
set yrange [n - 0.5:-0.5]
set ytics (Name[1] 0)
do for [i = 2:n] {
    set ytics add (Name[i] i - 1)
}
set xlabel 'time [s] or distance [m]'
unset key
set style fill solid noborder
do for [panel = 0:found] {
    set title panel ? 'with what was found' : 'calibrated base'
    plot 'map.dat' using (0.5*($1+$2)):3:1:2:($3-0.42):($3+0.42):4 + panel \
        with boxxyerror linecolor palette
}
unset multiplot
