# SPDX-License-Identifier: GPL-3.0-or-later
# Value of a column of a series at a time, linear between lines.
#
#   awk -v column=.. -v time=.. -f at.awk FILE

BEGIN { FS = "[ \t,]+" }

/^ *[-+0-9.]/ {
    sub(/^ +/, "")
    if ($1 >= time)
    {
        value = $column
        if (n) value = v + (value - v)*(time - t)/($1 - t)
        printf "%.6g\n", value
        exit
    }
    t = $1
    v = $column
    n = 1
}
