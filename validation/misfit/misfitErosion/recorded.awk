# SPDX-License-Identifier: GPL-3.0-or-later
# Experiments and channels of a misfitDict from the paper's table:
#
#   awk -F, -v what=experiments|channels -v calibration="D3M115V45 ..." \
#       [-v validation=".."] [-v test=".."] -f recorded.awk ../../papers/erosionStudy/paper.csv
#
# The uncertainty of H, L, L_c and U is the scatter of the paper's 27 values around their
# own power law of D, M and V; their gain has 5 % for what the definitions leave open
# (README.md). U_e and h are not fitted: U_e is 0.67 H L (L_c - 0.6 m) in the paper, and
# how h was read is not known.

BEGIN {
    read(calibration, "calibration")
    read(validation, "validation")
    read(test, "test")
}

function read(list, use,    n, i, name)
{
    n = split(list, name, " ")
    for (i = 1; i <= n; i++) useOf[name[i]] = use
}

FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
!($1 in useOf) { next }

what == "experiments" {
    printf "%s\n{\n    use     %s;\n    changes\n    (\n", $1, useOf[$1]
    change("diameter", substr($1, 2, 1)/100)
    change("mass", substr($1, 4, 3))
    change("solidFraction", substr($1, 8, 2)/100)
    changeCells(substr($1, 4, 3)/(0.3*0.5*(1000 + 16.5*substr($1, 8, 2))))
    print "    );\n}"
}

what == "channels" {
    channel("H", "length", "m", 0.022, "bed", "summary.dat", "H")
    channel("L", "length", "m", 0.034, "bed", "summary.dat", "L")
    channel("Lc", "length", "m", 0.023, "bed", "bedErosion.dat", "xRaised")
    channel("U", "velocity", "m/s", 0.034, "head", "summary.dat", "U")
}

function change(entry, value)
{
    printf "        { file \"constant/chute\"; entry %s; value %g; }\n", entry, value
}

# Cells of some 60 mm along a box 0.5 m high, of that length [m], and beyond it
function changeCells(boxLength)
{
    change("cellsBox", int(boxLength/0.06 + 0.5))
    change("cellsBeyond", int((5 - boxLength)/0.06 + 0.5))
}

# share: standard deviation over the value
function channel(quantity, kind, unit, share, object, file, heading,    value)
{
    value = $(column[quantity])
    printf "%s%s\n{\n", quantity, substr($1, 1)
    printf "    experiment  %s;\n    quantity    %s;\n", $1, kind
    printf "    value       %s;\n    unit        \"%s\";\n", value, unit
    printf "    uncertainty %.3g;\n    gainUncertainty 0.05;\n", share*value
    printf "    simulated   { type table; function %s; file \"%s\"; column %s; }\n}\n", \
        object, file, heading
}
