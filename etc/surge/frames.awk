# SPDX-License-Identifier: GPL-3.0-or-later
# The frames of the page of surgePage, from what grains.awk wrote:
#
#   awk -v about=FILE -f frames.awk kept moves > frames
#
# The first line holds diameter (12 bits) and type (6 bits) of each grain. A line for each
# time follows: a bit for each grain that has moved, then its x, y and z as 16-bit
# integers and its speed in 6 bits. All in base64. A grain that is not drawn is at 65535.
# about: times, ranges and numbers, as members of a JSON object.

BEGIN {
    digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
    for (i = 0; i < 64; i++) six[i] = substr(digits, i + 1, 1)
    for (i = 0; i < 4096; i++) twelve[i] = six[int(i/64)] six[i%64]
    gone = "////////A"
}
NR == 1 {
    unit = $2; all = $3; drawn = $4; fastest = $5
    for (c = 1; c <= 3; c++)
    {
        lo[c] = $(4 + 2*c)
        hi[c] = $(5 + 2*c) > lo[c] ? $(5 + 2*c) : lo[c] + 1
    }
    next
}
NR == FNR {
    place[$1] = ++n
    d[n] = $2; type[n] = $3
    if ($2 > largest) largest = $2
    code[n] = gone
    next
}
FNR == 1 { sizes() }
$1 == "t" { if (t++) frame(); now = $2; next }
{
    k = place[$1]
    moved[k]
    code[k] = $2 == "-" ? gone : encoded($2, $3, $4, $5)
}
END { frame(); summary() }

function sizes(    k)
{
    for (k = 1; k <= n; k++)
        printf "%s%s", twelve[int(4095*d[k]/largest + 0.5)], six[type[k] % 64]
    print ""
}

function share(p, c) { return int(65534*(p - lo[c])/(hi[c] - lo[c]) + 0.5) }

function encoded(x, y, z, v)
{
    x = share(x, 1); y = share(y, 2); z = share(z, 3)
    return twelve[int(x/16)] twelve[(x%16)*256 + int(y/256)] \
        twelve[(y%256)*16 + int(z/4096)] twelve[z%4096] \
        six[fastest ? int(63*sqrt(v/fastest) + 0.5) : 0]
}

function frame(    k, bits)
{
    for (k = 1; k <= n; k++)
    {
        bits = 2*bits + (k in moved)
        if (k % 6 == 0 || k == n)
        {
            for (; k % 6; k++) bits *= 2
            printf "%s", six[bits]
            bits = 0
        }
    }
    for (k = 1; k <= n; k++) if (k in moved) printf "%s", code[k]
    print ""
    split("", moved)
    times = times (times == "" ? "" : ", ") now
}

function metres(list,    c, s)
{
    for (c = 1; c <= 3; c++) s = s (c > 1 ? ", " : "") sprintf("%.9g", (list[c] - 1e6)*unit)
    return "[" s "]"
}

function summary()
{
    printf "\"times\": [%s], \"grains\": %d, \"all\": %d, \"drawn\": %d,\n" \
        "\"lo\": %s, \"hi\": %s, \"largest\": %.9g, \"fastest\": %.9g", times, n, all, \
        drawn, metres(lo), metres(hi), largest, fastest/1000 > about
}
