# SPDX-License-Identifier: GPL-3.0-or-later
# Spin of a sphere that turns in still water, from w0 on, with I = m d^2/10 and
# Re = rho d^2 w/mu:
#
#   slow   torque pi mu d^3 w,                       Re below 31.7
#          w = w0 exp(-pi mu d^3 t/I)
#   fast   torque mu d^3/64 (12.9 sqrt(Re) + 128.4) w,   Re above
#          sqrt(w) = B/((A + B/sqrt(w0)) exp(B t/2) - A), with
#          A = 12.9 sqrt(rho d^2/mu) k, B = 128.4 k, k = mu d^3/(64 I)
#
# Reads "t w_x w_y w_z" of a spin along (2 -1 2), prints "t w wClosed" with w
# along that, and in its last lines the largest deviation and the largest part
# across over w0, and the rate of the decay between the first and last line
# that spin slower than at the start, over that of the slow law.

BEGIN {
    pi = atan2(0, -1)
    rho = 1000
    mu = 1e-3
    I = 2650*pi/6*d^5/10
    k = mu*d^3/(64*I)
    A = 12.9*sqrt(rho*d^2/mu)*k
    B = 128.4*k
}

/^#/ { next }

{
    w = (2*$2 - $3 + 2*$4)/3
    across = sqrt(($2 - 2*w/3)^2 + ($3 + w/3)^2 + ($4 - 2*w/3)^2)/spin
    if (across > mostAcross) mostAcross = across

    if (law == "slow") closed = spin*exp(-pi*mu*d^3*$1/I)
    else closed = (B/((A + B/sqrt(spin))*exp(B*$1/2) - A))^2

    printf "%.9g %.9g %.9g\n", $1, w, closed
    deviation = (w > closed ? w - closed : closed - w)/spin
    if (deviation > most) most = deviation

    if (!n && w < 0.999*spin) { t0 = $1; w0 = w; ++n }
    t = $1
}

END {
    if (!n) { print "# the grain does not slow down"; exit }
    print "# deviation", most
    print "# across", mostAcross + 0
    print "# rate", log(w0/w)/(t - t0)/(pi*mu*d^3/I)
}
