"""
The true motion of the gripper on its tether, compiled by numba: one row at a time, N rows a call.

State   r, v from the platform in I [m, m/s]; quaternion (x, y, z, w) of the body; body rates
        [rad/s]: 13 numbers for the 12 states of the paper.
Command tension [N]; force along x_t, in plane and out of it [N]; torque about body axes [N m];
        held over a step, its directions turning with tether and body.
Orbit   (3, 3): mu / r^3 [1/s^2] and the sine and cosine of nu - nu0, at the beginning, the middle
        and the end of the step.
Craft   (N, 8): mass [kg], three moments of inertia [kg m^2], lever arm of the attachment [m],
        disturbing force in I [N].
Valid   the platform is on the target's orbit, undisturbed; massless tether; separations far below
        the orbit's radius.
Source  Hu et al. (docs/missions/tether.md):
        r'' = mu/r^3 (3 (rhat . r) rhat - r) + (F - T x_t)/m
        I w' + w x I w = tau + 0.25 m T (x_b x x_t),  q' = q (w, 0)/2
        One classical Runge-Kutta step. Elastic: T = max(0, EA s + c s'), s = (l1 - ls)/ls, where a
        reel pays out ls by a proportional-integral law on the tension that a load cell feels;
        explicit motion, implicit reel (backward Euler, Newton), since its time constant is
        microseconds.

Import it where it is used: numba takes a second. Each function is compiled once for a machine.
"""

from math import sqrt

import numpy as np

from rvd_dynamics.compiled import compiled

STATES, COMMANDS, CRAFT = 13, 7, 8
NEWTON = 12                             # most iterations of the reel's equation


@compiled
def rate(x, u, tension, g, s, c, p, out):
    """Write the rate of one state (13,) to `out`, for mu/r^3, sine and cosine of the orbit."""
    rx, ry, rz = x[0], x[1], x[2]
    flat = sqrt(rx*rx + ry*ry)
    l1 = sqrt(rx*rx + ry*ry + rz*rz)
    ca, sa, cb, sb = rx/flat, ry/flat, flat/l1, rz/l1
    tx, ty, tz = cb*ca, cb*sa, sb
    pull, m = u[1] - tension, p[0]
    outward = 3.0*(s*rx - c*ry)
    out[0], out[1], out[2] = x[3], x[4], x[5]
    out[3] = g*(outward*s - rx) + (pull*tx - u[2]*sa - u[3]*sb*ca + p[5])/m
    out[4] = g*(-outward*c - ry) + (pull*ty + u[2]*ca - u[3]*sb*sa + p[6])/m
    out[5] = -g*rz + (pull*tz + u[3]*cb + p[7])/m
    qx, qy, qz, qw = x[6], x[7], x[8], x[9]
    wx, wy, wz = x[10], x[11], x[12]
    out[6] = 0.5*(qw*wx + qy*wz - qz*wy)
    out[7] = 0.5*(qw*wy + qz*wx - qx*wz)
    out[8] = 0.5*(qw*wz + qx*wy - qy*wx)
    out[9] = -0.5*(qx*wx + qy*wy + qz*wz)
    by = 2.0*(qx*qy - qz*qw)*tx + (1.0 - 2.0*(qx*qx + qz*qz))*ty + 2.0*(qy*qz + qx*qw)*tz
    bz = 2.0*(qx*qz + qy*qw)*tx + 2.0*(qy*qz - qx*qw)*ty + (1.0 - 2.0*(qx*qx + qy*qy))*tz
    arm = p[4]*tension
    out[10] = (u[4] - (p[3] - p[2])*wy*wz)/p[1]
    out[11] = (u[5] - arm*bz - (p[1] - p[3])*wz*wx)/p[2]
    out[12] = (u[6] + arm*by - (p[2] - p[1])*wx*wy)/p[3]


@compiled
def step(x, u, tension, orbit, p, h, work):
    """Advance one state (13,) in place by `h` [s]; `work` is scratch (5, 13)."""
    for stage in range(4):
        if stage == 0:
            for i in range(13):
                work[4, i] = x[i]
        else:
            part = h if stage == 3 else 0.5*h
            for i in range(13):
                work[4, i] = x[i] + part*work[stage - 1, i]
        at = (stage + 1)//2
        rate(work[4], u, tension, orbit[at, 0], orbit[at, 1], orbit[at, 2], p, work[stage])
    sixth = h/6.0
    for i in range(13):
        x[i] += sixth*(work[0, i] + 2.0*(work[1, i] + work[2, i]) + work[3, i])
    size = sqrt(x[6]*x[6] + x[7]*x[7] + x[8]*x[8] + x[9]*x[9])
    for i in range(6, 10):
        x[i] /= size


@compiled
def advance(states, commands, orbit, craft, h):
    """Return states (N, 13) after a step of `h` [s] under commands (N, 7), the tether stiff."""
    made = states.copy()
    work = np.empty((5, 13))
    for row in range(len(made)):
        step(made[row], commands[row], commands[row, 0], orbit, craft[row], h, work)
    return made


@compiled
def reel_step(l1, wanted, ls, speed, strain, stiffness, damping, gain, reset, h):
    """
    Return unstretched length, integral speed, tension and strain of one reel after `h` [s].

    ls' = speed + gain (T - wanted), speed' = gain/reset (T - wanted), at the end of the step;
    `gain` [m/s/N], `reset` [s], `damping` [N s] per unit of strain.
    """
    tension, found = 0.0, ls
    for _ in range(NEWTON):
        now = (l1 - found)/found
        tension = stiffness*now + damping*(now - strain)/h
        slope = -(stiffness + damping/h)*l1/(found*found)
        if tension < 0.0:
            tension, slope = 0.0, 0.0
        pay = gain*(1.0 + h/reset)*h
        left = found - ls - h*speed - pay*(tension - wanted)
        change = left/(1.0 - pay*slope)
        found -= change
        if abs(change) < 1e-15*found:
            break
    now = (l1 - found)/found
    tension = max(0.0, stiffness*now + damping*(now - strain)/h)
    return found, speed + h*gain/reset*(tension - wanted), tension, now


@compiled
def advance_elastic(states, reels, commands, orbit, craft, reel, h, parts):
    """
    Return states (N, 13) and reels (N, 4) after a step of `h` [s] in `parts` parts.

    A row of `reels`: unstretched length [m], integral speed [m/s], tension [N], strain. `reel`: EA
    [N], damping [N s], gain [m/s/N], reset [s]. The orbit is taken as straight within the step.
    """
    made, reels = states.copy(), reels.copy()
    work, now = np.empty((5, 13)), np.empty((3, 3))
    part = h/parts
    for row in range(len(made)):
        x, r = made[row], reels[row]
        for i in range(parts):
            for j in range(3):
                at = (i + 0.5*j)/parts
                for k in range(3):
                    now[j, k] = orbit[0, k] + at*(orbit[2, k] - orbit[0, k])
            step(x, commands[row], r[2], now, craft[row], part, work)
            l1 = sqrt(x[0]*x[0] + x[1]*x[1] + x[2]*x[2])
            r[0], r[1], r[2], r[3] = reel_step(
                l1, commands[row, 0], r[0], r[1], r[3], reel[0], reel[1], reel[2], reel[3], part)
    return made, reels
