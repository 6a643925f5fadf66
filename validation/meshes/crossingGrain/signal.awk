# SPDX-License-Identifier: GPL-3.0-or-later
# Parts what probes recorded (time, then a column a probe) into a smooth signal,
# the mean over a window, and what is beside it.
# Give  from, to: times to look at [s];  half: half of the window, in lines.
# Prints the largest smooth signal, the largest value beside it, and the largest
# jump from one line to the next, of the probe where the second is largest [Pa].
/^#/ { next }
{
    t[++n] = $1
    for (i = 2; i <= NF; i++) p[n, i] = $i
    last = NF
}
function size(x) { return x < 0 ? -x : x }
END {
    worst = -1
    for (i = 2; i <= last; i++)
    {
        smooth = beside = jump = 0
        for (k = half + 1; k <= n - half; k++)
        {
            if (t[k] < from || t[k] > to) continue
            mean = 0
            for (j = k - half; j <= k + half; j++) mean += p[j, i]/(2*half + 1)
            if (size(mean) > smooth) smooth = size(mean)
            if (size(p[k, i] - mean) > beside) beside = size(p[k, i] - mean)
            if (size(p[k, i] - p[k-1, i]) > jump) jump = size(p[k, i] - p[k-1, i])
        }
        if (beside > worst)
        {
            worst = beside
            found = sprintf("%.4g %.4g %.4g", smooth, beside, jump)
        }
    }
    print found
}
