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
def rotation(q):
    """Return R (3, 3), craft to target, of a quaternion of any length."""
    x, y, z, w = q
    k = 2.0/(x*x + y*y + z*z + w*w)
    r = np.empty((3, 3))
    r[0, 0], r[0, 1], r[0, 2] = 1 - k*(y*y + z*z), k*(x*y - w*z), k*(x*z + w*y)
    r[1, 0], r[1, 1], r[1, 2] = k*(x*y + w*z), 1 - k*(x*x + z*z), k*(y*z - w*x)
    r[2, 0], r[2, 1], r[2, 2] = k*(x*z - w*y), k*(y*z + w*x), 1 - k*(x*x + y*y)
    return r


@compiled
def times(p, q):
    """Return the quaternion product p (x) q."""
    a, b, c, d = p
    x, y, z, w = q
    return np.array([d*x + a*w + b*z - c*y, d*y + b*w + c*x - a*z,
                     d*z + c*w + a*y - b*x, d*w - a*x - b*y - c*z])


@compiled
def attitude_slope(q, gyro, bias, n):
    """Return q' (4): turning by the gyro less its bias, less the target's own turning."""
    r = rotation(q)
    w = np.zeros(4)
    for i in range(3):
        w[i] = gyro[i] - bias[i] + n*r[1, i]
    return 0.5*times(q, w)


@compiled
def kept(q, norm):
    """Scale a quaternion in place as the norm is to be kept."""
    if norm == NONE:
        return
    size = np.sqrt(q[0]**2 + q[1]**2 + q[2]**2 + q[3]**2)
    if norm == NORMALISED:
        q /= size
        return
    for _ in range(2 if abs(size - 1.0) > FAR_OFF else 1):
        q *= (size*size + 1.0)/(2.0*size*size)      # eq. 27 with W = 1: on D x = d
        size = np.sqrt(q[0]**2 + q[1]**2 + q[2]**2 + q[3]**2)


@compiled
def turn_on(q, before, now, bias, dt, n, predictor, norm):
    """Carry an attitude over a step in place: eq. 17, or eq. 18 and 19."""
    first = attitude_slope(q, before, bias, n)
    if predictor == EULER:
        q += dt*first
    else:
        ahead = q + dt*first
        second = attitude_slope(ahead, now if predictor == NEWEST else before, bias, n)
        q += 0.5*dt*(first + second)
    kept(q, norm)


@compiled
def move_on(s, force, r, dt, n):
    """Carry place and velocity over a step in place, by the midpoint rule, the attitude held."""
    a = np.zeros(3)
    for i in range(3):
        for j in range(3):
            a[i] += r[i, j]*(force[j] - s[6 + j])
    ax = ay = az = 0.0
    u, v, w = s[3], s[4], s[5]
    for h in (0.0, 0.5*dt):
        y, z = s[1] + h*v, s[2] + h*w
        u, v, w = s[3] + h*ax, s[4] + h*ay, s[5] + h*az
        ax, ay, az = a[0] + 2*n*w, a[1] - n*n*y, a[2] - 2*n*u + 3*n*n*z
    s[0], s[1], s[2] = s[0] + dt*u, s[1] + dt*v, s[2] + dt*w
    s[3], s[4], s[5] = s[3] + dt*ax, s[4] + dt*ay, s[5] + dt*az


@compiled
def attitude_transition(gyro, bias, dt, feedback):
    """Return Phi (6, 6) of dq and db; `feedback` is alpha where it stands in the covariance."""
    x, y, z = gyro[0] - bias[0], gyro[1] - bias[1], gyro[2] - bias[2]
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    square = product(skew, skew, False)
    f = np.eye(6)
    for i in range(3):
        for j in range(3):
            f[i, j] += -dt*skew[i, j] + 0.5*dt*dt*square[i, j]
            f[i, 3 + j] += 0.25*dt*dt*skew[i, j]
        f[i, 3 + i] -= 0.5*dt
        f[3 + i, i] += 0.5*feedback*dt
    return f


@compiled
def position_transition(r, dt, n):
    """Return Phi (9, 9) of (r, V, d), to second order in the step."""
    f = np.eye(9)
    half = 0.5*dt*dt
    m = np.zeros((3, 3))
    m[0, 2], m[2, 0] = 2.0*n, -2.0*n
    g = np.array([0.0, -n*n, 3.0*n*n])
    for i in range(3):
        f[i, i] += half*g[i]
        f[i, 3 + i] += dt
        f[3 + i, i] += dt*g[i]
        for j in range(3):
            f[i, 3 + j] += half*m[i, j]
            f[3 + i, 3 + j] += dt*m[i, j]
            f[i, 6 + j] -= half*r[i, j]
            f[3 + i, 6 + j] -= dt*r[i, j]
    return f


@compiled
def joseph(p, k, h, noise):
    """Return (1 - K H) P (1 - K H)^T + K R K^T, symmetric."""
    a = np.eye(p.shape[0]) - product(k, h, False)
    made = product(product(a, p, False), a, True) + product(product(k, noise, False), k, True)
    return 0.5*(made + made.T)


@compiled
def see_attitude(q, b, p, seen, noise, injected, norm):
    """Take a measured attitude in place; return its normalised innovation squared."""
    opposite = np.array([-q[0], -q[1], -q[2], q[3]])/(q[0]**2 + q[1]**2 + q[2]**2 + q[3]**2)
    dq = times(opposite, seen)
    sign = 1.0 if dq[3] >= 0.0 else -1.0
    z = sign*dq[:3]
    si = inverse(p[:3, :3] + noise)
    k = product(p[:, :3], si, False)
    nis, dx = 0.0, np.zeros(6)
    for i in range(3):
        for j in range(3):
            nis += z[i]*si[i, j]*z[j]
        for j in range(6):
            dx[j] += k[j, i]*z[i]
    h = np.zeros((3, 6))
    h[0, 0] = h[1, 1] = h[2, 2] = 1.0
    p[:, :] = joseph(p, k, h, noise)
    q[:] = times(q, np.array([dx[0], dx[1], dx[2], 1.0]))
    b += dx[3:] - injected*z
    kept(q, norm)
    return nis


@compiled
def see_position(s, p, r, seen, port, noise):
    """Take the port's place in craft axes in place; return its normalised innovation squared."""
    h = np.zeros((3, 9))
    y = seen.copy()
    for i in range(3):
        for j in range(3):
            h[i, j] = -r[j, i]
            y[i] -= r[j, i]*(port[j] - s[j])
    pht = product(p, h, True)
    si = inverse(product(h, pht, False) + noise)
    k = product(pht, si, False)
    nis = 0.0
    for i in range(3):
        for j in range(3):
            nis += y[i]*si[i, j]*y[j]
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
def advance(q, b, p, s, ps, known, samples, place, turn, covariance, settings, noises, start, port,
            output):
    """
    Carry the filters of all rows over a step in place; return both NIS (N, 2), NaN if none.

    State (N, ...); `samples` (N, L + 1, 6) gyro and specific force, oldest first, of which the
    oldest is the step of the filters. `place`, `turn`, `covariance`: what was seen at that step,
    NaN if nothing. `output` (N, 16): q, rate, r, V, d at the newest sample.
    """
    dt, n, predictor, norm, counting, injected, in_covariance = settings
    q_dq, q_b, q_v, q_d = noises
    nis = np.full((len(q), 2), np.nan)
    depth = samples.shape[1]
    for i in range(len(q)):
        seen = np.isfinite(place[i, 0])
        if known[i]:
            before = samples[i, 1 if counting else 0]
            now = samples[i, 1]
            held = rotation(q[i])
            turn_on(q[i], before[:3], now[:3], b[i], dt, n, predictor, norm)
            f = attitude_transition(now[:3], b[i], dt, in_covariance)
            p[i] = product(product(f, p[i], False), f, True)
            f = position_transition(held, dt, n)
            ps[i] = product(product(f, ps[i], False), f, True)
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
                nis[i, 0] = see_attitude(q[i], b[i], p[i], turn[i], noise, injected, norm)
                noise = covariance[i, :3, :3] + lever(place[i], p[i, :3, :3])
                nis[i, 1] = see_position(s[i], ps[i], rotation(q[i]), place[i], port, noise)
        elif seen:
            known[i] = True
            q[i] = turn[i]
            r = rotation(q[i])
            b[i] = 0.0
            s[i] = 0.0
            p[i] = 0.0
            ps[i] = 0.0
            there = covariance[i, :3, :3] + lever(place[i], 0.25*covariance[i, 3:, 3:])
            there = product(product(r, there, False), r, True)
            for j in range(3):
                s[i, j] = port[j]
                for k in range(3):
                    s[i, j] -= r[j, k]*place[i, k]
                    p[i, j, k] = 0.25*covariance[i, 3 + j, 3 + k]
                    ps[i, j, k] = there[j, k]
                p[i, 3 + j, 3 + j] = start[0]
                ps[i, 3 + j, 3 + j] = start[1]
                ps[i, 6 + j, 6 + j] = start[2]
        out = output[i]
        if not known[i]:
            out[:] = np.nan
            continue
        ahead, moving = q[i].copy(), s[i].copy()
        for j in range(2, depth):               # what the camera has not yet shown
            held = rotation(ahead)
            before = samples[i, j if counting else j - 1]
            turn_on(ahead, before[:3], samples[i, j, :3], b[i], dt, n, predictor, norm)
            move_on(moving, samples[i, j, 3:], held, dt, n)
        out[:4] = ahead
        out[7:] = moving
        for j in range(3):
            out[4 + j] = samples[i, depth - 1, j] - b[i, j]
    return nis
