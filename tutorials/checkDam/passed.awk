# SPDX-License-Identifier: GPL-3.0-or-later
# How many grains of each size have passed the dam: grains.dat of the moments in turn, the
# first before any has arrived. A grain that is in the dam has not passed.
#
#   awk -v to=X -f passed.awk view/0.1/grains.dat view/0.2/grains.dat ...
#
# A line of headings, then one a moment: time, then for each size (bed, then debris from
# small to large) the fraction that has passed. With -v last=1 a row of Markdown for
# each size, at the last moment.

FNR == 1 {
    moments++
    parts = split(FILENAME, part, "/")
    time[moments] = part[parts - 1]
}
/^#/ { next }
{
    kind = sprintf("%d %.6g", $6, $4)
    if (moments == 1) all[kind]++
    if ($1 < to) before[moments, kind]++
}

# The sizes in the order of type and diameter, as order[1..n]
function sizes(    kind, i, n, a, b)
{
    for (kind in all)
    {
        split(kind, a, " ")
        for (i = n++; i > 0; i--)
        {
            split(order[i], b, " ")
            if (b[1] < a[1] || b[1] == a[1] && b[2] + 0 < a[2] + 0) break
            order[i + 1] = order[i]
        }
        order[i + 1] = kind
    }
    return n
}

function passed(m, kind) { return 1 - before[m, kind]/all[kind] }

function name(kind,    a)
{
    split(kind, a, " ")
    return sprintf("%s, %g mm", (a[1] == 1 ? "bed" : "debris"), 1000*a[2])
}

function row(kind)
{
    printf "| %s | %d | %.1f | %.1f |\n", name(kind), all[kind], \
        100*passed(moments, kind), 100*(1 - passed(moments, kind))
}

function headings(    i)
{
    printf "time"
    for (i = 1; i <= n; i++) printf " \"%s\"", name(order[i])
    print ""
}

END {
    n = sizes()
    if (last)
    {
        for (i = 1; i <= n; i++) row(order[i])
        exit
    }
    headings()
    for (m = 1; m <= moments; m++)
    {
        printf "%s", time[m]
        for (i = 1; i <= n; i++) printf " %.5f", passed(m, order[i])
        print ""
    }
}
