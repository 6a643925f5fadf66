# SPDX-License-Identifier: GPL-3.0-or-later
# Root mean square of the difference of two series.
#
#   awk -v column=.. -v until=.. -f rms.awk COMPUTED MEASURED
#
# COMPUTED has the time and, in a column, what the second column of MEASURED
# has; it is taken linearly at the times of MEASURED up to "until".

BEGIN { FS = "[ \t,]+" }

!/^ *[-+0-9.]/ { next }

FNR == NR { t[++n] = $1; v[n] = $column; next }

$1 <= until {
    while (i < n - 1 && t[i + 1] < $1) ++i
    if (i < 1) i = 1
    d = v[i] + (v[i + 1] - v[i])*($1 - t[i])/(t[i + 1] - t[i]) - $2
    sum += d*d
    ++m
}

END { print m ? sprintf("%.4g", sqrt(sum/m)) : "none" }
