# SPDX-License-Identifier: GPL-3.0-or-later
# The grains of one moment as spheres of POV-Ray, from grains.dat of a sideView, in six
# shades by their numbers. Colours: by type, or by speed where "fastest" [m/s], that of
# the last colour, is above zero. range: x from,to, where not all shows.

BEGIN { cut = split(range, end, ",") == 2 }
/^#/ || cut && ($1 < end[1] + $4/2 || $1 > end[2] - $4/2) { next }
{
    colour = fastest > 0 ? int(7.99*($5 < fastest ? $5/fastest : 1)) : ($6 - 1) % 4
    printf "sphere{<%g,%g,%g>,%g texture{Colour[%d][%d]}}\n", $1, $3, $2, $4/2, \
        colour, ((NF > 6 ? $7 : NR)*7919 % 1009) % 6
}
