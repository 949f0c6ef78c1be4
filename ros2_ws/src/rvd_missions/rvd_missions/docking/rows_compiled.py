"""
What the mission computes for each row in each step, for numba: fixed layouts, no checks.

The same operations in the same order as `motion.attitude`, and so the same bits: a call of numpy
for each of them costs a single run a hundred times what it computes. Arrays have rows N in front.
"""

import numpy as np

from rvd_dynamics.compiled import compiled

NOMINAL, HOLD, RETREAT, ABORT = 0, 1, 2, 3          # states of `safety`


@compiled
def turned(x, y, z, w, a, b, c):
    """Return a vector (a, b, c) of the body in the reference, of the quaternion (x, y, z, w)."""
    t, u, v = 2.0*(y*c - z*b), 2.0*(z*a - x*c), 2.0*(x*b - y*a)
    return a + w*t + (y*v - z*u), b + w*u + (z*t - x*v), c + w*v + (x*u - y*t)


@compiled
def relative(position, q, target):
    """Return the chaser's centre from the target's in target axes (N, 3), its attitude (N, 4)."""
    away, turn = np.empty(position.shape), np.empty(q.shape)
    for i in range(len(q)):
        a, b, c, d = -target[i, 0], -target[i, 1], -target[i, 2], target[i, 3]
        x, y, z, w = q[i, 0], q[i, 1], q[i, 2], q[i, 3]
        turn[i, 0], turn[i, 1] = d*x + a*w + b*z - c*y, d*y + b*w + c*x - a*z
        turn[i, 2], turn[i, 3] = d*z + c*w + a*y - b*x, d*w - a*x - b*y - c*z
        away[i, 0], away[i, 1], away[i, 2] = turned(a, b, c, d, position[i, 0], position[i, 1],
                                                    position[i, 2])
    return away, turn


@compiled
def faces(position, q, target, arm, port):
    """Return the chaser's port from the target's in target axes (N, 3), its attitude (N, 4)."""
    away, turn = relative(position, q, target)
    for i in range(len(q)):
        a, b, c = turned(turn[i, 0], turn[i, 1], turn[i, 2], turn[i, 3], arm[i, 0], arm[i, 1],
                         arm[i, 2])
        away[i, 0] = away[i, 0] + a - port[0]
        away[i, 1] = away[i, 1] + b - port[1]
        away[i, 2] = away[i, 2] + c - port[2]
    return away, turn


@compiled
def estimated(r, q, rate, n, arm, port):
    """Return what an estimate says of the port (N, 3), and of the rate relative to LVLH (N, 3)."""
    there, spin = np.empty(r.shape), np.empty(r.shape)
    for i in range(len(q)):
        x, y, z, w = q[i, 0], q[i, 1], q[i, 2], q[i, 3]
        a, b, c = turned(x, y, z, w, arm[0], arm[1], arm[2])
        there[i, 0], there[i, 1], there[i, 2] = (r[i, 0] + a - port[0], r[i, 1] + b - port[1],
                                                 r[i, 2] + c - port[2])
        spin[i, 0] = rate[i, 0] + n*(2*(x*y + w*z))
        spin[i, 1] = rate[i, 1] + n*(1 - 2*(x*x + z*z))
        spin[i, 2] = rate[i, 2] + n*(2*(y*z - w*x))
    return there, spin


@compiled
def errors(r, v, q, turn, spin, wanted, speed):
    """Return the errors of place and attitude, craft axes, and their rates, (N, 6) each."""
    error, change = np.empty((len(q), 6)), np.empty((len(q), 6))
    for i in range(len(q)):
        x, y, z, w = -q[i, 0], -q[i, 1], -q[i, 2], q[i, 3]
        error[i, 0], error[i, 1], error[i, 2] = turned(
            x, y, z, w, wanted[i, 0] - r[i, 0], wanted[i, 1] - r[i, 1], wanted[i, 2] - r[i, 2])
        change[i, 0], change[i, 1], change[i, 2] = turned(
            x, y, z, w, speed[i, 0] - v[i, 0], speed[i, 1] - v[i, 1], speed[i, 2] - v[i, 2])
        for j in range(3):
            error[i, 3 + j], change[i, 3 + j] = -turn[i, j], -spin[i, j]
    return error, change


@compiled
def profile(t, start, ends, speeds, gone, left, slope):
    """
    Return port (N, 3) and velocity (N, 3) of a profile at `t`; see `profile.Profile`.

    `left` of the offset across and `slope` of it, as fractions of what it was at the start.
    """
    rows = len(start)
    port, velocity = np.empty((rows, 3)), np.empty((rows, 3))
    for i in range(rows):
        part = 0
        while part < 5 and t >= ends[i, part + 1]:
            part += 1
        if part == 5:
            way, speed = gone[i, 5], 0.0
        else:
            span = ends[i, part + 1] - ends[i, part]
            v0, v1 = speeds[part], speeds[part + 1]
            tau = min(max(t - ends[i, part], 0.0), span)
            rate = (v1 - v0)/span if span > 0.0 else 0.0
            way, speed = gone[i, part] + tau*(v0 + 0.5*rate*tau), v0 + rate*tau
        port[i, 0], velocity[i, 0] = start[i, 0] + way, speed
        for j in range(1, 3):
            port[i, j], velocity[i, j] = left*start[i, j], slope*start[i, j]
    return port, velocity


@compiled
def wrench(shares, nominal, authority):
    """Return forces and torques (N, 6) of thrusters that are open (N, T) for a share of a step."""
    made = np.zeros((len(shares), 6))
    for i in range(len(shares)):
        for t in range(shares.shape[1]):
            if shares[i, t] != 0.0:
                for j in range(6):
                    made[i, j] += nominal[j, t]*shares[i, t]/authority[j]
    return made


@compiled
def watch(state, blind, odd, mean, port, speed, turn, rate, nis, pushed, bounds, rate_bound, views,
          step, share, active):
    """Advance the states of `safety.Safety` in place; comparisons with NaN are false."""
    slope, near, aside, stop, brake, least, angle, lost, most_nis, most_mean = bounds
    for i in range(len(state)):
        known, seen = np.isfinite(port[i, 0]), np.isfinite(nis[i, 0])
        blind[i] = 0.0 if seen or not known else blind[i] + step
        if seen:
            odd[i] = odd[i] + 1 if nis[i, 0] > most_nis or nis[i, 1] > most_nis else 0
        stuck = False
        for j in range(6):
            mean[i, j] += share*(pushed[i, j] - mean[i, j])
            stuck = stuck or abs(mean[i, j]) > most_mean
        if not known or not active:
            continue
        distance = -port[i, 0]
        across = np.sqrt(port[i, 1]*port[i, 1] + port[i, 2]*port[i, 2])
        far = distance > near
        wanted = NOMINAL
        if (far and across > slope*distance) or blind[i] > lost or odd[i] >= views or stuck:
            wanted = HOLD
        for j in range(3):
            if abs(turn[i, j]) > angle or abs(rate[i, j]) > rate_bound:
                wanted = HOLD
        if not far and (across > aside or stuck):
            wanted = RETREAT
        if speed[i] > max(least, np.sqrt(2.0*brake*max(distance - stop, 0.0))):
            wanted = ABORT
        if wanted > state[i]:
            state[i] = wanted
