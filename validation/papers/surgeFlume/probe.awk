# SPDX-License-Identifier: GPL-3.0-or-later
# The pore pressure at the probe, from porePressureProbes.dat of one probe: a
# moving mean over 0.1 s of column q (p or hydrostatic), then
#
#   peak [Pa], its time [s], time above half of it [s], time from the peak until
#   5 % of it is left [s; > the rest of the record if it is not], and the mean
#   of q over that of sigma while it is above half of its peak
#
#   awk -v q=hydrostatic -f probe.awk porePressureProbes.dat

/^# Time/ {
    for (i = 2; i <= NF; i++)
    {
        name = $i
        sub(/^.*:/, "", name)
        c[name] = i - 1
    }
}

/^#/ { next }

{ t[++n] = $1; raw[n] = $(c[q]); sigma[n] = $(c["sigma"]) }

END {
    if (n < 3) exit 1

    first = 1
    for (i = 1; i <= n; i++)
    {
        sum += raw[i]
        while (t[i] - t[first] > 0.1) sum -= raw[first++]
        v[i] = sum/(i - first + 1)
        if (v[i] > peak) { peak = v[i]; iPeak = i }
    }

    for (i = 2; i <= n; i++)
        if (v[i] > 0.5*peak)
        {
            high += t[i] - t[i - 1]
            sumQ += raw[i]
            sumSigma += sigma[i]
        }

    for (end = n; end > iPeak && v[end] < 0.05*peak; end--);
    printf "%.4g %.3g %.3g %s%.3g %.3g\n", peak, t[iPeak], high, \
        end == n ? ">" : "", t[end] - t[iPeak], sumQ/sumSigma
}
