"""
The direction-angle equation and its Poincare map, compiled; `limit_cycles` is what calls it.

Everything here is for the machine: arrays of a fixed layout, no checks. Importing this module
imports numba, so only studies of limit cycles do.

State   y = (phi, phi'), ' = d/dnu over the true anomaly nu of the target. phi is the angle of the
        line of sight from target to chaser, from radial-out, positive along the orbital motion.
Columns (d/dphi0, d/dphi'0, d/dp) of the variational equations follow, p being one parameter.
Source  Yu, Yang 1998, eq. 10 and 11, derived again. With c = 1 + e cos nu, S = 2 e sin nu / c:
        R1  phi'' = (1 + 2 k2) S (1 + phi') - 2 (k + k1 phi')(1 + phi') - 1.5 sin(2 phi) / c
        R2  phi'' = (1 + 2 k2) S (1 + phi') - 2 k - 2 k1 phi'           - 1.5 sin(2 phi) / c
        R4  phi'' = S phi' + (1 + 2 k2) S   - 2 k - 2 k1 phi'           - 1.5 sin(2 phi) / c
        and, where there is a transverse thruster (ODRRCA),
        + a_phi / (D nu.^2) = -q wrap(phi - phi_d) - q1 phi' + ff,
        ff = 2 k + 1.5 sin(2 phi_d) / c, with the orbit's own acceleration - (1 + 2 k2) S.
        Integrated by the pair of Dormand and Prince 5(4), J. Comp. Appl. Math. 6, 1980.
"""

from math import cos, floor, pi, sin

import numpy as np

from rvd_dynamics.compiled import compiled

# Positions of the parameters in `w`.
E, K, K1, K2, Q, PHI_D, Q1, FF, FORM, TRANSVERSE = range(10)
FF_GRAVITY, FF_ALL = 1, 2               # values of w[FF] but 0, none



@compiled
def acceleration(nu, phi, rate, w):
    """Return phi'' of the direction-angle equation."""
    inverse = 1.0/(1.0 + w[E]*cos(nu))
    return _acceleration(inverse, 2.0*w[E]*sin(nu)*inverse, sin(2.0*phi), phi, rate, w)


@compiled
def _acceleration(inverse, swing, sin_2phi, phi, rate, w):
    """Return phi'' from 1 / c, S and sin 2 phi, which are dear."""
    k, k1, forcing = w[K], w[K1], (1.0 + 2.0*w[K2])*swing
    if w[FORM] == 1.0:
        f = forcing*(1.0 + rate) - 2.0*(k + k1*rate)*(1.0 + rate)
    elif w[FORM] == 2.0:
        f = forcing*(1.0 + rate) - 2.0*k - 2.0*k1*rate
    else:
        f = swing*rate + forcing - 2.0*k - 2.0*k1*rate
    f -= 1.5*sin_2phi*inverse
    if w[TRANSVERSE] != 0.0:
        f -= w[Q]*_wrap(phi - w[PHI_D]) + w[Q1]*rate
        if w[FF] != 0.0:
            f += 2.0*k + 1.5*sin(2.0*w[PHI_D])*inverse
        if w[FF] == FF_ALL:
            f -= forcing
    return f


@compiled
def _slope(nu, y, w, parameter, dy):
    """Write dy/dnu of state and columns, y (8,), into `dy`."""
    phi, rate = y[0], y[1]
    k, k1, k2, form = w[K], w[K1], w[K2], w[FORM]
    cosine, sine, sin_2phi, cos_2phi = cos(nu), sin(nu), sin(2.0*phi), cos(2.0*phi)
    inverse = 1.0/(1.0 + w[E]*cosine)                   # 1 / c
    swing = 2.0*w[E]*sine*inverse
    forcing = (1.0 + 2.0*k2)*swing
    if form == 1.0:
        by_rate = forcing - 2.0*(k + k1*rate) - 2.0*k1*(1.0 + rate)
    elif form == 2.0:
        by_rate = forcing - 2.0*k1
    else:
        by_rate = swing - 2.0*k1
    by_phi = -3.0*cos_2phi*inverse
    if w[TRANSVERSE] != 0.0:
        by_phi -= w[Q]
        by_rate -= w[Q1]
    dy[0], dy[1] = rate, _acceleration(inverse, swing, sin_2phi, phi, rate, w)
    for column in (2, 4, 6):
        dy[column] = y[column + 1]
        dy[column + 1] = by_phi*y[column] + by_rate*y[column + 1]
    if parameter >= 0:
        dy[7] += _by_parameter(inverse, cosine, sine, sin_2phi, phi, rate, w, parameter)


@compiled
def _wrap(angle):
    """Return an angle in [-pi, pi)."""
    return angle - 2.0*pi*floor(angle/(2.0*pi) + 0.5)


@compiled
def _by_parameter(inverse, cosine, sine, sin_2phi, phi, rate, w, parameter):
    """Return the derivative of phi'' by the parameter at this position of `w`."""
    swing, turn = 2.0*w[E]*sine*inverse, 1.0 + rate
    across, form = w[TRANSVERSE] != 0.0, w[FORM]
    fed = across and w[FF] != 0.0
    full = across and w[FF] == FF_ALL
    forced = 1.0 if form == 4.0 else turn               # what the forcing is multiplied by
    if full:
        forced -= 1.0
    d = 0.0
    if parameter == E:
        swing_by_e, inverse_by_e = 2.0*sine*inverse*inverse, -cosine*inverse*inverse
        d = (1.0 + 2.0*w[K2])*swing_by_e*forced - 1.5*sin_2phi*inverse_by_e
        if form == 4.0:
            d += swing_by_e*rate
        if fed:
            d += 1.5*sin(2.0*w[PHI_D])*inverse_by_e
    elif parameter == K:
        d = -2.0*turn if form == 1.0 else -2.0
        if fed:
            d += 2.0
    elif parameter == K1:
        d = -2.0*rate*turn if form == 1.0 else -2.0*rate
    elif parameter == K2:
        d = 2.0*swing*forced
    elif across and parameter == Q:
        d = -_wrap(phi - w[PHI_D])
    elif across and parameter == Q1:
        d = -rate
    elif across and parameter == PHI_D:
        d = w[Q]
        if fed:
            d += 3.0*cos(2.0*w[PHI_D])*inverse
    return d


@compiled
def _integrate(y, nu, end, w, parameter, tolerance, h):
    """Carry y (8,) from nu to `end` in place; return the last step, or 0 where it blew up."""
    k1, k2, k3, k4 = np.empty(8), np.empty(8), np.empty(8), np.empty(8)
    k5, k6, k7, z = np.empty(8), np.empty(8), np.empty(8), np.empty(8)
    _slope(nu, y, w, parameter, k1)
    kept = h
    while nu < end:
        if nu + h >= end:
            h = end - nu
        for i in range(8):
            z[i] = y[i] + h*(0.2*k1[i])
        _slope(nu + 0.2*h, z, w, parameter, k2)
        for i in range(8):
            z[i] = y[i] + h*(3/40*k1[i] + 9/40*k2[i])
        _slope(nu + 0.3*h, z, w, parameter, k3)
        for i in range(8):
            z[i] = y[i] + h*(44/45*k1[i] - 56/15*k2[i] + 32/9*k3[i])
        _slope(nu + 0.8*h, z, w, parameter, k4)
        for i in range(8):
            z[i] = y[i] + h*(19372/6561*k1[i] - 25360/2187*k2[i] + 64448/6561*k3[i]
                             - 212/729*k4[i])
        _slope(nu + 8/9*h, z, w, parameter, k5)
        for i in range(8):
            z[i] = y[i] + h*(9017/3168*k1[i] - 355/33*k2[i] + 46732/5247*k3[i]
                             + 49/176*k4[i] - 5103/18656*k5[i])
        _slope(nu + h, z, w, parameter, k6)
        for i in range(8):
            z[i] = y[i] + h*(35/384*k1[i] + 500/1113*k3[i] + 125/192*k4[i]
                             - 2187/6784*k5[i] + 11/84*k6[i])
        _slope(nu + h, z, w, parameter, k7)
        worst = 0.0
        for pair in (0, 2, 4, 6):                       # a column is as exact as it is long
            size, error = 1.0 if pair < 6 else 1e-3, 0.0
            for i in (pair, pair + 1):
                size = max(size, abs(z[i]))
                error = max(error, abs(h*(71/57600*k1[i] - 71/16695*k3[i] + 71/1920*k4[i]
                                          - 17253/339200*k5[i] + 22/525*k6[i] - k7[i]/40)))
            worst = max(worst, error/(tolerance*size))
        if not worst < 1e30:
            return 0.0
        grow = 5.0 if worst < 1e-4 else min(5.0, max(0.2, 0.9*worst**-0.2))
        if worst <= 1.0:
            nu = end if h >= end - nu else nu + h
            for i in range(8):
                y[i], k1[i] = z[i], k7[i]
            kept = h*grow
        h *= grow
        if h < 1e-9:
            return 0.0
    return kept


@compiled
def orbit_map(phi, rate, w, parameter, tolerance):
    """
    Return the state one orbit on, with its derivatives.

    Shape (8,): phi, phi', and the columns by phi0, by phi'0 and by the parameter at this position
    of `w` (-1: none, zeros). NaN where the motion diverges.
    """
    y = np.array([phi, rate, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0])
    if _integrate(y, 0.0, 2.0*pi, w, parameter, tolerance, 0.02) == 0.0:
        y[:] = np.nan
    return y


@compiled
def trace(phi, rate, w, points, orbits, tolerance):
    """Return (phi, phi') at `points` + 1 even true anomalies over so many orbits."""
    y = np.array([phi, rate, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    out = np.full((points + 1, 2), np.nan)
    out[0] = y[:2]
    h = 0.02
    for i in range(points):
        begin, end = 2.0*pi*orbits*i/points, 2.0*pi*orbits*(i + 1)/points
        h = _integrate(y, begin, end, w, -1, tolerance, h)
        if h == 0.0:
            break
        out[i + 1] = y[:2]
    return out
