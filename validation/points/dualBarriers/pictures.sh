# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures, of the runs that were made here. Sourced by Allrun.

# drawRun name picture from to height times...: the debris by its speed, after impact
drawRun()
{
    local name="$1" picture="$2" from="$3" to="$4" high="$5"
    local impact table time panels='' folder places
    shift 5
    folder="$(tablesOf "$name")/.."
    [ -d "$folder/postProcessing/view" ] || return 0
    places="$folder/system/places"
    impact="$(kept "$name" impact)"
    [ -n "$impact" ] || impact="$(quickly "$name-quick" impact)"
    for time
    do
        table="$(tableAt "$(at "$impact" "$time")" "$folder/postProcessing")" || return 0
        panels="$panels
set title '$time s after impact' offset 0,-0.8
plot '$table' using 1:3:(\$4/2):5 with circles linecolor palette fillstyle solid noborder"
    done
    plot "$picture" <<PLOT
set terminal pngcairo size 1100,$((190*$#)) noenhanced font ',11'
set output '$picture'
set multiplot layout $#,1
set size ratio -1; set key off; set lmargin 9; set rmargin 12
set bmargin 2; set tmargin 1.5; set ytics 2; unset grid
set xrange [$from:$to]; set yrange [0:$high]
set ylabel 'z [m]'; set cblabel 'speed [m/s]'; set cbrange [0:14]
$(awk '{ v[$1] = $2 + 0 }
    END {
        for (i = 1; i <= 2; i++)
            if (("face" i) in v)
                printf "set object %d rectangle from %g,0 to %g,%g fillstyle solid " \
                    "fillcolor rgb \"#303030\" front\n", i, v["face" i], \
                    v["face" i] + v["thick"], v["height"]
    }' "$places")
$panels
PLOT
}

drawRun Fr2S_E fr2.png -20 40 6 0.7 1.3 2.3 4.3
drawRun Fr6S_E fr6.png 30 120 11 1.3 2.3 4.3 6
drawRun Fr2S_T fr2water.png -20 40 6 0.7 1.3 2.3 4.3
drawRun Fr4S_T fr4water.png 10 100 9 0.7 1.3 2.3 4.3

for Fr in 2 4 6
do
    for L in 1.5 2 3 5
    do
        name="Fr${Fr}D${L}_E"
        ! has "$name" || echo "$L $(overDesign "$name")"
    done > "run/forces$Fr"
    [ -s "run/forces$Fr" ] || echo "0 0" > "run/forces$Fr"
done

plot forces.png <<'PLOT'
set xlabel 'L/x_i'; set ylabel 'force on barrier 2 over the design force'
set xrange [1:5.5]; set yrange [0:*]; set key top left
plot 'run/forces2' with linespoints title 'Fr 2', \
    'run/forces4' with linespoints title 'Fr 4', \
    'run/forces6' with linespoints title 'Fr 6'
PLOT
