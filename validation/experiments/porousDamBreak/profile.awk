# SPDX-License-Identifier: GPL-3.0-or-later
# Surface of the water, computed beside measured.
#
#   awk -v height=.. -f profile.awk CELLS MEASURED
#
# CELLS is a table of sideView: the depth is the fraction of water in a column of
# cells times the height of the mesh, linear between columns. Prints, for each
# place in MEASURED, x, the depth measured and the depth computed [m].

FNR == NR && /^#/ { next }

FNR == NR {
    x = sprintf("%.5f", $1)
    if (!(x in depth)) X[++n] = x
    water[x] += $5*$4^3
    all[x] += $4^3
    next
}

FNR == 1 {
    for (i = 1; i <= n; ++i) depth[X[i]] = height*water[X[i]]/all[X[i]]
    for (i = 2; i <= n; ++i)
        for (j = i; j > 1 && X[j] + 0 < X[j - 1] + 0; --j)
        {
            x = X[j]; X[j] = X[j - 1]; X[j - 1] = x
        }
    FS = ","
}

/^[0-9]/ {
    $0 = $0
    for (i = 2; i < n && X[i] + 0 < $1; ++i) ;
    low = depth[X[i - 1]]
    share = ($1 - X[i - 1])/(X[i] - X[i - 1])
    share = share < 0 ? 0 : share > 1 ? 1 : share
    print $1, $2, low + share*(depth[X[i]] - low)
}
