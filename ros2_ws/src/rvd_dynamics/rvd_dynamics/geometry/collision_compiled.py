"""
Loops of `collision` that numba compiles: the probability of one row, and its bounds.

Method  In the principal axes (deviations s1 <= s2 <= s3, mean m) the ball is cut into chords along
        the third axis, whose probability is a difference of two erf. The chords are summed by
        Gauss-Legendre rules over x = R sin(a), y = h sin(b), h = R cos(a): the square roots at the
        rim are gone. Each range is cut to CUT deviations about the mean, beyond which less than
        1e-9 is left, so that NODES suffice however narrow the distribution is.
Bounds  The ball lies within the cube about it and within the slab that the direction of the mean
        is normal to, and the cube inscribed in it lies within the ball.

Import it where it is used; see `compiled`.
"""

from math import asin, cos, erf, exp, isfinite, nan, pi, sin, sqrt

import numpy as np

from rvd_dynamics.compiled import compiled

CUT = 6.0                               # [standard deviations]
NODES = 32                              # of each of the two rules: an error of 1e-8
X, W = np.polynomial.legendre.leggauss(NODES)
SWEEPS = 8                              # of Jacobi's rotations; three reach 1e-16 as a rule


@compiled
def principal(c, mean):
    """Return deviations, rising, and the mean along their axes, of a covariance (3, 3)."""
    a = c.copy()
    v = np.eye(3)
    for _ in range(SWEEPS):
        off = abs(a[0, 1]) + abs(a[0, 2]) + abs(a[1, 2])
        if off <= 1e-15 * (a[0, 0] + a[1, 1] + a[2, 2]):
            break
        for p in range(2):
            for q in range(p + 1, 3):
                if a[p, q] == 0.0:
                    continue
                theta = 0.5 * (a[q, q] - a[p, p]) / a[p, q]
                sign = 1.0 if theta >= 0.0 else -1.0
                t = sign / (abs(theta) + sqrt(theta*theta + 1.0))
                co = 1.0 / sqrt(t*t + 1.0)
                si = t*co
                for k in range(3):
                    kp, kq = a[k, p], a[k, q]
                    a[k, p], a[k, q] = co*kp - si*kq, si*kp + co*kq
                for k in range(3):
                    pk, qk = a[p, k], a[q, k]
                    a[p, k], a[q, k] = co*pk - si*qk, si*pk + co*qk
                for k in range(3):
                    kp, kq = v[k, p], v[k, q]
                    v[k, p], v[k, q] = co*kp - si*kq, si*kp + co*kq
    s, m = np.empty(3), np.empty(3)
    for i in range(3):
        s[i] = sqrt(max(a[i, i], 0.0))
        m[i] = v[0, i]*mean[0] + v[1, i]*mean[1] + v[2, i]*mean[2]
    for i in range(2):                  # rising
        for j in range(2 - i):
            if s[j] > s[j + 1]:
                s[j], s[j + 1] = s[j + 1], s[j]
                m[j], m[j + 1] = m[j + 1], m[j]
    return s, m


@compiled
def between(low, high, mean, sigma):
    """Return the probability of a normal variable between two numbers."""
    k = 1.0 / (sigma * sqrt(2.0))
    a, b = (low - mean) * k, (high - mean) * k
    if a > 5.9 or b < -5.9:             # erfc(5.9) < 1e-16
        return 0.0
    return 0.5 * (erf(b) - erf(a))


@compiled
def of_ball(s, m, r):
    """Return the probability of the ball of radius r, in principal axes."""
    for i in range(3):
        if abs(m[i]) - r > CUT * s[i]:
            return 0.0
    low = max(-r, m[0] - CUT*s[0])
    high = min(r, m[0] + CUT*s[0])
    a0, a1 = asin(max(low / r, -1.0)), asin(min(high / r, 1.0))
    half_a, mid_a = 0.5*(a1 - a0), 0.5*(a1 + a0)
    total = 0.0
    norm = 1.0 / (2.0*pi*s[0]*s[1])
    for i in range(NODES):
        a = mid_a + half_a*X[i]
        h = r*cos(a)
        u = (r*sin(a) - m[0]) / s[0]
        low = max(-h, m[1] - CUT*s[1])
        high = min(h, m[1] + CUT*s[1])
        if low >= high:
            continue
        b0, b1 = asin(max(low / h, -1.0)), asin(min(high / h, 1.0))
        half_b, mid_b = 0.5*(b1 - b0), 0.5*(b1 + b0)
        line = 0.0
        for j in range(NODES):
            b = mid_b + half_b*X[j]
            chord = h*cos(b)
            w = (h*sin(b) - m[1]) / s[1]
            line += W[j] * exp(-0.5*w*w) * chord * between(-chord, chord, m[2], s[2])
        total += W[i] * exp(-0.5*u*u) * h * half_b * line
    return min(max(total * half_a * norm, 0.0), 1.0)


@compiled
def bounds(s, m, r, c, mean):
    """Return numbers between which the probability of the ball lies."""
    upper, lower = 1.0, 1.0
    edge = r / sqrt(3.0)
    for i in range(3):
        upper *= between(-r, r, m[i], s[i])
        lower *= between(-edge, edge, m[i], s[i])
    d = sqrt(mean[0]*mean[0] + mean[1]*mean[1] + mean[2]*mean[2])
    if d > 0.0:
        along = 0.0
        for i in range(3):
            for j in range(3):
                along += mean[i]*c[i, j]*mean[j]
        upper = min(upper, between(-r, r, d, sqrt(along) / d))
    return lower, upper


@compiled
def known(mean, c, r):
    """Return whether all numbers of a row are finite."""
    total = r
    for i in range(3):
        total += mean[i]
        for j in range(3):
            total += c[i, j]
    return isfinite(total)


@compiled
def probabilities(means, covariances, radii):
    """Return the probabilities (N,) of rows."""
    found = np.empty(len(radii))
    for n in range(len(radii)):
        if not known(means[n], covariances[n], radii[n]):
            found[n] = nan
        elif radii[n] <= 0.0:
            found[n] = 0.0
        else:
            s, m = principal(covariances[n], means[n])
            found[n] = of_ball(s, m, radii[n])
    return found


@compiled
def reach(means, covariances, radii, threshold):
    """Return which rows (N,) reach a probability, and which took a quadrature; NaN never does."""
    above = np.zeros(len(radii), dtype=np.bool_)
    integrated = np.zeros(len(radii), dtype=np.bool_)
    for n in range(len(radii)):
        if radii[n] <= 0.0 or not known(means[n], covariances[n], radii[n]):
            continue
        s, m = principal(covariances[n], means[n])
        lower, upper = bounds(s, m, radii[n], covariances[n], means[n])
        if lower >= threshold:
            above[n] = True
        elif upper >= threshold:
            integrated[n] = True
            above[n] = of_ball(s, m, radii[n]) >= threshold
    return above, integrated
