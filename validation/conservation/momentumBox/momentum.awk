# SPDX-License-Identifier: GPL-3.0-or-later
# Momentum of the grains and the impulse they are still to get, from the cloud
# of one time:
#
#   awk -v interval=SECONDS -f momentum.awk grains/mass grains/U grains/force
#
# Prints  sum m v (x y z)  sum F interval (x y z).

FNR == 1 {
    name = FILENAME
    sub(/.*\//, "", name)
    inHeader = 1
    n = 0
}

inHeader {
    if ($0 ~ /^}/) inHeader = 0
    next
}

# All values are the same: N{value}
name == "mass" && /^[0-9]+\{/ {
    sub(/^[0-9]+\{/, "")
    uniform = $0 + 0
    next
}

name == "mass" && /^[-+0-9.]/ && started {
    mass[++n] = $1
    next
}

/^\($/ { started = 1; next }
/^\)$/ { started = 0; next }

name != "mass" && /^\(/ {
    gsub(/[()]/, "")
    ++n
    for (k = 1; k <= 3; ++k)
        if (name == "U")
            momentum[k] += (uniform ? uniform : mass[n])*$k
        else
            pending[k] += interval*$k
}

END {
    printf "%.17g %.17g %.17g %.17g %.17g %.17g\n",
        momentum[1], momentum[2], momentum[3],
        pending[1], pending[2], pending[3]
}
