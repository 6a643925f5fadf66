# SPDX-License-Identifier: GPL-3.0-or-later
# Volume of the water in a picture over that in the cells, from what
# etc/picture/water.awk writes and the table that it reads:
#
#   awk -f pictured.awk WATER.inc cells.dat WATER.top.pgm WATER.low.pgm

FILENAME ~ /inc$/ {
    gsub(/[<>,]/, " ")
    for (i = 1; i < NF; i++)
        if ($i == "scale") { a = $(i + 1); h = $(i + 2); b = $(i + 3) }
    next
}
FILENAME ~ /cells.dat$/ {
    if (!/^#/) all += $5*$4^3
    next
}
FNR == 2 { nx = $1; ny = $2 }
FNR < 4 { next }
{
    # The pixels along the rim only continue their neighbours
    n = FNR - 4
    i = n % nx
    j = int(n/nx)
    if (i == 0 || j == 0 || i == nx - 1 || j == ny - 1) next
    if (FILENAME ~ /top/) top[n] = $1
    else if (top[n] > $1) sum += (top[n] - $1)/65535
}

END { printf "%.4f", sum*h*a/(nx - 1)*b/(ny - 1)/all }
