# SPDX-License-Identifier: GPL-3.0-or-later
# Follows each grain through a dump of LIGGGHTS with the columns id x diameter:
#
#   awk -v end=X -f count.awk grains.seen
#
# Prints numbers of grains: seen at any time, there at the end, gone when last
# seen within 10 mm of x = end or beyond, gone from anywhere else; then the
# smallest and the largest diameter [m].

/^ITEM: TIMESTEP/ { inside = 0; ++frame; next }
/^ITEM: ATOMS/    { inside = 1; next }
!inside           { next }

{
    if (!($1 in last)) ++ids
    last[$1] = frame
    x[$1] = $2
    if (!smallest || $3 < smallest) smallest = $3
    if ($3 > largest) largest = $3
}

END {
    for (id in last)
        if (last[id] == frame) ++present
        else if (x[id] > end - 0.01) ++gone
        else ++lost
    print ids + 0, present + 0, gone + 0, lost + 0, smallest + 0, largest + 0
}
