"""
Attitude and position filters of `filters`, row by row, for numba: fixed layouts, no checks.

Attitude  q (4) craft relative to target, bias b (3) of the gyro, P (6, 6) over the vector part of
          dq = q^-1 (x) q_true and db = b_true - b.
Position  s = (r, V, d) (9): place [m] and velocity [m/s] of the craft's centre in the target's
          axes, bias of the accelerometer [m/s^2], P (9, 9).
"""

import numpy as np

from rvd_dynamics.compiled import compiled

EULER, FROZEN, NEWEST = 0, 1, 2                     # predictors
NONE, NORMALISED, PROJECTED = 0, 1, 2               # how the norm is kept
MOST = 1e9                                          # of a NIS: that of an outlier may be infinite
FAR_OFF = 1e-3                                      # norm error from which it is projected twice


@compiled
def inverse(m):
    """Return the inverse of a symmetric matrix (3, 3)."""
    a, b, c, d, e, f = m[0, 0], m[0, 1], m[0, 2], m[1, 1], m[1, 2], m[2, 2]
    p, q, r = d*f - e*e, c*e - b*f, b*e - c*d
    k = 1.0/(a*p + b*q + c*r)
    found = np.empty((3, 3))
    found[0, 0], found[0, 1], found[0, 2] = k*p, k*q, k*r
    found[1, 1], found[1, 2], found[2, 2] = k*(a*f - c*c), k*(b*c - a*e), k*(a*d - b*b)
    found[1, 0], found[2, 0], found[2, 1] = found[0, 1], found[0, 2], found[1, 2]
    return found


@compiled
def product(a, b, transposed):
    """Return a b, or a b^T, summed in a fixed order."""
    n, m = a.shape[0], b.shape[0] if transposed else b.shape[1]
    made = np.zeros((n, m))
    for i in range(n):
        for k in range(a.shape[1]):
            value = a[i, k]
            if value != 0.0:
                for j in range(m):
                    made[i, j] += value*(b[j, k] if transposed else b[k, j])
    return made


@compiled
def carry(f, p, half):
    """Write F P F^T into P, summed in a fixed order; zeros of F cost nothing. `half`: scratch."""
    n = len(f)
    for i in range(n):
        for j in range(n):
            half[j, i] = 0.0
        for k in range(n):
            value = f[i, k]
            if value != 0.0:
                for j in range(n):
                    half[j, i] += value*p[k, j]
    for j in range(n):
        for i in range(n):
            p[i, j] = 0.0
        for k in range(n):
            value = f[j, k]
            if value != 0.0:
                for i in range(n):
                    p[i, j] += half[k, i]*value


@compiled
def rotation(q):
    """Return R, craft to target, of a quaternion of any length, as three rows."""
    x, y, z, w = q[0], q[1], q[2], q[3]
    k = 2.0/(x*x + y*y + z*z + w*w)
    return ((1 - k*(y*y + z*z), k*(x*y - w*z), k*(x*z + w*y)),
            (k*(x*y + w*z), 1 - k*(x*x + z*z), k*(y*z - w*x)),
            (k*(x*z - w*y), k*(y*z + w*x), 1 - k*(x*x + y*y)))


@compiled
def times(p, q):
    """Return the quaternion product p (x) q."""
    a, b, c, d = p[0], p[1], p[2], p[3]
    x, y, z, w = q[0], q[1], q[2], q[3]
    return (d*x + a*w + b*z - c*y, d*y + b*w + c*x - a*z,
            d*z + c*w + a*y - b*x, d*w - a*x - b*y - c*z)


@compiled
def along(q, k, slope):
    """Return q + k slope."""
    return (q[0] + k*slope[0], q[1] + k*slope[1], q[2] + k*slope[2], q[3] + k*slope[3])


@compiled
def attitude_slope(q, gyro, bias, n):
    """Return q' (4): turning by the gyro less its bias, less the target's own turning."""
    r = rotation(q)[1]
    x, y, z, w = times(q, (gyro[0] - bias[0] + n*r[0], gyro[1] - bias[1] + n*r[1],
                           gyro[2] - bias[2] + n*r[2], 0.0))
    return 0.5*x, 0.5*y, 0.5*z, 0.5*w


@compiled
def kept(q, norm):
    """Return a quaternion scaled as the norm is to be kept."""
    x, y, z, w = q
    if norm == NONE:
        return x, y, z, w
    size = np.sqrt(x**2 + y**2 + z**2 + w**2)
    if norm == NORMALISED:
        return x/size, y/size, z/size, w/size
    for _ in range(2 if abs(size - 1.0) > FAR_OFF else 1):
        k = (size*size + 1.0)/(2.0*size*size)           # eq. 27 with W = 1: on D x = d
        x, y, z, w = k*x, k*y, k*z, k*w
        size = np.sqrt(x**2 + y**2 + z**2 + w**2)
    return x, y, z, w


@compiled
def turn_on(q, before, now, bias, dt, n, predictor, norm):
    """Return an attitude carried over a step: eq. 17, or eq. 18 and 19."""
    first = attitude_slope(q, before, bias, n)
    if predictor == EULER:
        return kept(along(q, dt, first), norm)
    ahead = along(q, dt, first)
    second = attitude_slope(ahead, now if predictor == NEWEST else before, bias, n)
    both = (first[0] + second[0], first[1] + second[1], first[2] + second[2], first[3] + second[3])
    return kept(along(q, 0.5*dt, both), norm)


@compiled
def move_on(s, force, r, dt, n):
    """Carry place and velocity over a step in place, by the midpoint rule, the attitude held."""
    fx, fy, fz = force[0] - s[6], force[1] - s[7], force[2] - s[8]
    x0 = 0.0 + r[0][0]*fx + r[0][1]*fy + r[0][2]*fz
    y0 = 0.0 + r[1][0]*fx + r[1][1]*fy + r[1][2]*fz
    z0 = 0.0 + r[2][0]*fx + r[2][1]*fy + r[2][2]*fz
    ax = ay = az = 0.0
    u, v, w = s[3], s[4], s[5]
    for h in (0.0, 0.5*dt):
        y, z = s[1] + h*v, s[2] + h*w
        u, v, w = s[3] + h*ax, s[4] + h*ay, s[5] + h*az
        ax, ay, az = x0 + 2*n*w, y0 - n*n*y, z0 - 2*n*u + 3*n*n*z
    s[0], s[1], s[2] = s[0] + dt*u, s[1] + dt*v, s[2] + dt*w
    s[3], s[4], s[5] = s[3] + dt*ax, s[4] + dt*ay, s[5] + dt*az


@compiled
def attitude_transition(gyro, bias, dt, feedback, f):
    """Write Phi (6, 6) of dq and db; `feedback` is alpha where it stands in the covariance."""
    x, y, z = gyro[0] - bias[0], gyro[1] - bias[1], gyro[2] - bias[2]
    skew = ((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0))
    for i in range(6):
        for j in range(6):
            f[i, j] = 1.0 if i == j else 0.0
    for i in range(3):
        for j in range(3):
            square = 0.0
            for k in range(3):
                if skew[i][k] != 0.0:
                    square += skew[i][k]*skew[k][j]
            f[i, j] += -dt*skew[i][j] + 0.5*dt*dt*square
            f[i, 3 + j] += 0.25*dt*dt*skew[i][j]
        f[i, 3 + i] -= 0.5*dt
        f[3 + i, i] += 0.5*feedback*dt


@compiled
def position_transition(r, dt, n, f):
    """Write Phi (9, 9) of (r, V, d), to second order in the step."""
    half = 0.5*dt*dt
    g = (0.0, -n*n, 3.0*n*n)
    m = ((0.0, 0.0, 2.0*n), (0.0, 0.0, 0.0), (-2.0*n, 0.0, 0.0))
    for i in range(9):
        for j in range(9):
            f[i, j] = 1.0 if i == j else 0.0
    for i in range(3):
        f[i, i] += half*g[i]
        f[i, 3 + i] += dt
        f[3 + i, i] += dt*g[i]
        for j in range(3):
            f[i, 3 + j] += half*m[i][j]
            f[3 + i, 3 + j] += dt*m[i][j]
            f[i, 6 + j] -= half*r[i][j]
            f[3 + i, 6 + j] -= dt*r[i][j]


@compiled
def joseph(p, k, h, noise):
    """Return (1 - K H) P (1 - K H)^T + K R K^T, symmetric."""
    a = np.eye(p.shape[0]) - product(k, h, False)
    made = product(product(a, p, False), a, True) + product(product(k, noise, False), k, True)
    return 0.5*(made + made.T)


@compiled
def see_attitude(q, b, p, seen, noise, injected, norm, gate):
    """
    Take a measured attitude in place; return its normalised innovation squared.

    One that is above `gate` is left out.
    """
    size = q[0]**2 + q[1]**2 + q[2]**2 + q[3]**2
    dq = times((-q[0]/size, -q[1]/size, -q[2]/size, q[3]/size), seen)
    sign = 1.0 if dq[3] >= 0.0 else -1.0
    z = np.array([sign*dq[0], sign*dq[1], sign*dq[2]])
    si = inverse(p[:3, :3] + noise)
    k = product(p[:, :3], si, False)
    nis, dx = 0.0, np.zeros(6)
    for i in range(3):
        for j in range(3):
            nis += z[i]*si[i, j]*z[j]
        for j in range(6):
            dx[j] += k[j, i]*z[i]
    if not nis <= gate:
        return nis if nis < MOST else MOST
    h = np.zeros((3, 6))
    h[0, 0] = h[1, 1] = h[2, 2] = 1.0
    p[:, :] = joseph(p, k, h, noise)
    q[0], q[1], q[2], q[3] = kept(times(q, (dx[0], dx[1], dx[2], 1.0)), norm)
    b += dx[3:] - injected*z
    return nis


@compiled
def see_position(s, p, r, seen, port, noise, gate):
    """
    Take the port's place in craft axes in place; return its normalised innovation squared.

    One that is above `gate` is left out.
    """
    h = np.zeros((3, 9))
    y = seen.copy()
    for i in range(3):
        for j in range(3):
            h[i, j] = -r[j][i]
            y[i] -= r[j][i]*(port[j] - s[j])
    pht = product(p, h, True)
    si = inverse(product(h, pht, False) + noise)
    k = product(pht, si, False)
    nis = 0.0
    for i in range(3):
        for j in range(3):
            nis += y[i]*si[i, j]*y[j]
    if not nis <= gate:
        return nis if nis < MOST else MOST
    for i in range(3):
        for j in range(9):
            s[j] += k[j, i]*y[i]
    p[:, :] = joseph(p, k, h, noise)
    return nis


@compiled
def lever(place, p):
    """Return the covariance that an attitude error of P (dq) gives a place seen from the craft."""
    x, y, z = place
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return product(product(skew, 4.0*p, False), skew, True)


@compiled
def advance(q, b, p, s, ps, known, missed, samples, place, turn, covariance, settings, noises,
            start, port, output):
    """
    Carry the filters of all rows over a step in place; return both NIS (N, 2), NaN if none.

    State (N, ...); `samples` (N, L + 1, 6) gyro and specific force, oldest first, of which the
    oldest is the step of the filters. `place`, `turn`, `covariance`: what was seen at that step,
    NaN if nothing. `output` (N, 16): q, rate, r, V, d at the newest sample. `missed` (N,): views
    in a row that were outliers; after `patience` of them the next one is where a row begins anew.
    """
    dt, n, predictor, norm, counting, injected, in_covariance, gate, patience = settings
    q_dq, q_b, q_v, q_d = noises
    nis = np.full((len(q), 2), np.nan)
    depth = samples.shape[1]
    f, g, half, ninth, turned = (np.empty((6, 6)), np.empty((9, 9)), np.empty((6, 6)),
                                 np.empty((9, 9)), np.empty((3, 3)))
    for i in range(len(q)):
        seen = np.isfinite(place[i, 0])
        if seen and missed[i] >= patience:
            known[i], missed[i] = False, 0
        if not known[i] and seen:               # nothing is held against it but its own length
            size = turn[i, 0]**2 + turn[i, 1]**2 + turn[i, 2]**2 + turn[i, 3]**2
            seen = abs(size - 1.0) < 0.1
        if known[i]:
            before = samples[i, 1 if counting else 0]
            now = samples[i, 1]
            held = rotation(q[i])
            q[i, 0], q[i, 1], q[i, 2], q[i, 3] = turn_on(
                (q[i, 0], q[i, 1], q[i, 2], q[i, 3]), before, now, b[i], dt, n, predictor, norm)
            attitude_transition(now, b[i], dt, in_covariance, f)
            carry(f, p[i], half)
            position_transition(held, dt, n, g)
            carry(g, ps[i], ninth)
            move_on(s[i], now[3:], held, dt, n)
            for j in range(3):
                p[i, j, j] += q_dq
                p[i, 3 + j, 3 + j] += q_b
                ps[i, j, j] += 0.25*q_v*dt*dt
                ps[i, j, 3 + j] += 0.5*q_v*dt
                ps[i, 3 + j, j] += 0.5*q_v*dt
                ps[i, 3 + j, 3 + j] += q_v
                ps[i, 6 + j, 6 + j] += q_d
            if seen:
                noise = 0.25*covariance[i, 3:, 3:]
                nis[i, 0] = see_attitude(q[i], b[i], p[i], turn[i], noise, injected, norm, gate)
                if nis[i, 0] <= gate:
                    noise = covariance[i, :3, :3] + lever(place[i], p[i, :3, :3])
                    nis[i, 1] = see_position(s[i], ps[i], rotation(q[i]), place[i], port, noise,
                                             gate)
                missed[i] = 0 if nis[i, 1] <= gate else missed[i] + 1
        elif seen:
            known[i] = True
            q[i] = turn[i]
            r = rotation(q[i])
            for j in range(3):
                for k in range(3):
                    turned[j, k] = r[j][k]
            b[i] = 0.0
            s[i] = 0.0
            p[i] = 0.0
            ps[i] = 0.0
            there = covariance[i, :3, :3] + lever(place[i], 0.25*covariance[i, 3:, 3:])
            there = product(product(turned, there, False), turned, True)
            for j in range(3):
                s[i, j] = port[j]
                for k in range(3):
                    s[i, j] -= r[j][k]*place[i, k]
                    p[i, j, k] = 0.25*covariance[i, 3 + j, 3 + k]
                    ps[i, j, k] = there[j, k]
                p[i, 3 + j, 3 + j] = start[0]
                ps[i, 3 + j, 3 + j] = start[1]
                ps[i, 6 + j, 6 + j] = start[2]
        out = output[i]
        if not known[i]:
            out[:] = np.nan
            continue
        ahead, moving = (q[i, 0], q[i, 1], q[i, 2], q[i, 3]), out[7:]
        moving[:] = s[i]
        for j in range(2, depth):               # what the camera has not yet shown
            held = rotation(ahead)
            before = samples[i, j if counting else j - 1]
            ahead = turn_on(ahead, before, samples[i, j], b[i], dt, n, predictor, norm)
            move_on(moving, samples[i, j, 3:], held, dt, n)
        out[0], out[1], out[2], out[3] = ahead
        for j in range(3):
            out[4 + j] = samples[i, depth - 1, j] - b[i, j]
    return nis
