# SPDX-License-Identifier: GPL-3.0-or-later
# Means over each half second since the gate moved, simulated and recorded [kPa], in lines
#
#   begin  stress  its recording  pore pressure  its recording
#
# of porePressureProbes.dat, then of a file of the recordings, column names in its first
# line. -v start=: time at which the gate moves in the first [s].
FNR == 1 { file++ }

# As OpenFOAM writes it: names follow "# Time"
file == 1 && /^# Time/ { for (i = 3; i <= NF; i++) column[$i] = i - 1 }
file == 1 && !/^#/ { add($1 - start, $column["0:sigma"]/1000, $column["0:p"]/1000) }

file == 2 && FNR == 1 { n = split($0, names, ","); for (i = 1; i <= n; i++) column[names[i]] = i }
file == 2 && FNR > 1 { split($0, cell, ","); add(cell[1], cell[column["sigma_m2_9_kPa"]], cell[column["p_m2_9_kPa"]]) }

function add(t, stress, pore,    half)
{
    half = int(2*t)
    if (t < 0 || half > 4) return
    number[file, half]++
    stresses[file, half] += stress
    pores[file, half] += pore
}

function mean(sums, of, half) { return sums[of, half]/number[of, half] }

END {
    for (half = 0; half <= 4; half++)
        if (number[1, half] && number[2, half])
            printf "%.1f %.4g %.4g %.4g %.4g\n", half/2, mean(stresses, 1, half), \
                mean(stresses, 2, half), mean(pores, 1, half), mean(pores, 2, half)
}
