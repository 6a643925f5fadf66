# SPDX-License-Identifier: GPL-3.0-or-later
# The readings of one experiment every 8 ms, with the noise of the gauges, from the tables
# of porePressureProbes and surgeFront:
#
#   awk -v seed=1 -f readings.awk porePressureProbes.dat surgeFront.dat
function noise(deviation)
{
    return deviation*sqrt(-2*log(1 - rand()))*cos(6.283185307*rand())
}

BEGIN {
    srand(seed)
    print "t_s,P1_Pa,N1_Pa,L1_m,P2_Pa,N2_Pa,L2_m,P3_Pa,Q1_m"
}

# The columns that hold these quantities
/^# Time/ {
    ++table
    for (i = 2; i <= NF; i++)
    {
        column[$i] = i - 1
    }
}

/^#/ { next }

table == 1 { base[$1] = $0 }

table == 2 && ($1 in base) && int($1/0.008 + 0.5)*0.008 - $1 < 1e-6 && \
    $1 - int($1/0.008 + 0.5)*0.008 < 1e-6 {
    split(base[$1], b)
    printf "%.3f,%.1f,%.1f,%.5f,%.1f,%.1f,%.5f,%.1f,%.4f\n", $1, \
        b[column["0:p"]] + noise(30), b[column["0:sigma"]] + noise(50), \
        b[column["0:level"]] + noise(0.003), \
        b[column["1:p"]] + noise(30), b[column["1:sigma"]] + noise(50), \
        b[column["1:level"]] + noise(0.003), \
        b[column["2:p"]] + noise(30), $(column["xQuantile"]) + noise(0.01)
}
