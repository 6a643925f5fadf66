# SPDX-License-Identifier: GPL-3.0-or-later
# The bed of one run at some times before its end, from its tables, those of all starts
# in one and without headings:
#
#   awk -v run= -v hash= -f readings.awk layers.dat bedErosion.dat

BEGIN {
    OFS = ","
    n = split("1.6 2 2.4 2.8 3.2", moments, " ")
}

FNR == 1 { file++ }

# After a stop a run looks at other times
{
    for (k = 1; k <= n; k++)
    {
        off = ($1 - moments[k])^2
        if ((file, k) in line && off >= least[file, k]) continue
        least[file, k] = off
        line[file, k] = $0
    }
}

END {
    for (k = 1; k <= n; k++)
    {
        split(line[1, k], layer, " ")
        split(line[2, k], bed, " ")
        print run, hash, moments[k], sprintf("%.4g", bed[2]), sprintf("%.4g", bed[5]), \
            sprintf("%.2f", bed[15]), sprintf("%.4f", layer[5]), sprintf("%.3f", layer[6])
    }
}
