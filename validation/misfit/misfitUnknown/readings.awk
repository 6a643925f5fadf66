# SPDX-License-Identifier: GPL-3.0-or-later
# Readings of gauge number "gauge" every 5 ms, with noise of 15 Pa, from what
# patchProbes wrote.
BEGIN { srand(40 + gauge); print "t_s,p_Pa"; when = 0.01 }
/^#/ { next }
{
    while (n && when <= $1)
    {
        noise = sqrt(-2*log(1 - rand()))*cos(6.283185307*rand())
        printf "%.6g,%.6g\n", when, \
            before + ($(gauge + 1) - before)*(when - t)/($1 - t) + 15*noise
        when += 0.005
    }
    t = $1
    before = $(gauge + 1)
    ++n
}
