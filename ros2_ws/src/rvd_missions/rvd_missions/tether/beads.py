"""
The gripper on a tether that has a mass: a chain of point masses, compiled by numba.

Chain   The tether is paid out in pieces of one unstretched length a, each with its mass rho a in a
        bead at its inner end. Between two beads, and between the last one and
        the gripper, T = max(0, EA s + c s'), s = (d - a)/a. The piece at the reel has no bead yet;
        its tension is what is commanded, as in `motion`. Longer than 1.5 a it gets a bead, which
        moves as the material there does: with the next one along the line, in proportion across
        it. Shorter than 0.5 a it loses one.
Gravity the gradient of `motion`, on each bead.
Method  leapfrog (kick, drift, kick) of all masses, semi-implicit Euler for the attitude, in parts
        of a step that resolve the axial mode of a piece, 2/a sqrt(EA/rho).
Source  assumed: the paper names a tether with mass as its next step.
"""

from math import sqrt

import numpy as np

from rvd_dynamics.compiled import compiled

LARGEST_PHASE = 0.4                     # of the fastest axial mode in a part of a step [rad]


def parts_of(step_s: float, piece_m: float, stiffness_n: float, density_kg_m: float) -> int:
    """Return into how many parts a step is divided so that the axial mode is resolved."""
    fastest = 2.0/piece_m*sqrt(stiffness_n/density_kg_m)
    return max(1, int(np.ceil(step_s*fastest/LARGEST_PHASE)))


@compiled
def forces(x, beads, n, u, g, s, c, p, tether, out, told):
    """
    Write accelerations (n + 1, 3) of beads and gripper to `out`, torque and tension to `told`.

    `x` (13,) is the gripper's state, `beads` (most, 6) the chain, outermost first; `u` (7,) the
    command; `p` (8,) the craft; `tether` EA [N], c [N s], a [m], rho [kg/m]. `told`: torque of the
    tether about body y and z [N m], tension at the gripper [N].
    """
    ea, damping, a, rho = tether[0], tether[1], tether[2], tether[3]
    for i in range(n + 1):
        rx, ry, rz = (x[0], x[1], x[2]) if i == 0 else (
            beads[i - 1, 0], beads[i - 1, 1], beads[i - 1, 2])
        outward = 3.0*(s*rx - c*ry)
        out[i, 0], out[i, 1], out[i, 2] = g*(outward*s - rx), g*(-outward*c - ry), -g*rz
    fx, fy, fz = 0.0, 0.0, 0.0                          # of the tether on the gripper
    for i in range(n + 1):                              # piece on the inner side of mass i
        if i == 0:
            x0, y0, z0, vx0, vy0, vz0 = x[0], x[1], x[2], x[3], x[4], x[5]
        else:
            x0, y0, z0 = beads[i - 1, 0], beads[i - 1, 1], beads[i - 1, 2]
            vx0, vy0, vz0 = beads[i - 1, 3], beads[i - 1, 4], beads[i - 1, 5]
        if i == n:
            d = sqrt(x0*x0 + y0*y0 + z0*z0)
            ex, ey, ez, tension = -x0/d, -y0/d, -z0/d, u[0]
        else:
            dx, dy, dz = beads[i, 0] - x0, beads[i, 1] - y0, beads[i, 2] - z0
            d = sqrt(dx*dx + dy*dy + dz*dz)
            ex, ey, ez = dx/d, dy/d, dz/d
            slide = (ex*(beads[i, 3] - vx0) + ey*(beads[i, 4] - vy0) + ez*(beads[i, 5] - vz0))
            tension = max(0.0, ea*(d - a)/a + damping*slide/a)
        if i == 0:
            fx, fy, fz = tension*ex, tension*ey, tension*ez
            told[2] = tension
        else:
            out[i, 0] += tension*ex/(rho*a)
            out[i, 1] += tension*ey/(rho*a)
            out[i, 2] += tension*ez/(rho*a)
        if i < n:
            out[i + 1, 0] -= tension*ex/(rho*a)
            out[i + 1, 1] -= tension*ey/(rho*a)
            out[i + 1, 2] -= tension*ez/(rho*a)
    flat = sqrt(x[0]*x[0] + x[1]*x[1])
    l1 = sqrt(flat*flat + x[2]*x[2])
    ca, sa, cb, sb = x[0]/flat, x[1]/flat, flat/l1, x[2]/l1
    out[0, 0] += (fx + u[1]*cb*ca - u[2]*sa - u[3]*sb*ca + p[5])/p[0]
    out[0, 1] += (fy + u[1]*cb*sa + u[2]*ca - u[3]*sb*sa + p[6])/p[0]
    out[0, 2] += (fz + u[1]*sb + u[3]*cb + p[7])/p[0]
    qx, qy, qz, qw = x[6], x[7], x[8], x[9]
    by = 2.0*(qx*qy - qz*qw)*fx + (1.0 - 2.0*(qx*qx + qz*qz))*fy + 2.0*(qy*qz + qx*qw)*fz
    bz = 2.0*(qx*qz + qy*qw)*fx + 2.0*(qy*qz - qx*qw)*fy + (1.0 - 2.0*(qx*qx + qy*qy))*fz
    told[0], told[1] = p[4]*bz, -p[4]*by                # (-arm, 0, 0) x force


@compiled
def turn(x, u, told, p, h):
    """Advance the attitude of a state (13,) in place by `h` [s], semi-implicitly."""
    wx, wy, wz = x[10], x[11], x[12]
    x[10] += h*(u[4] - (p[3] - p[2])*wy*wz)/p[1]
    x[11] += h*(u[5] + told[0] - (p[1] - p[3])*wz*wx)/p[2]
    x[12] += h*(u[6] + told[1] - (p[2] - p[1])*wx*wy)/p[3]
    wx, wy, wz = x[10], x[11], x[12]
    qx, qy, qz, qw = x[6], x[7], x[8], x[9]
    x[6] += 0.5*h*(qw*wx + qy*wz - qz*wy)
    x[7] += 0.5*h*(qw*wy + qz*wx - qx*wz)
    x[8] += 0.5*h*(qw*wz + qx*wy - qy*wx)
    x[9] += -0.5*h*(qx*wx + qy*wy + qz*wz)
    size = sqrt(x[6]*x[6] + x[7]*x[7] + x[8]*x[8] + x[9]*x[9])
    for i in range(6, 10):
        x[i] /= size


@compiled
def pay_out(x, beads, n, tension, tether):
    """Return the number of beads after one is added at the reel, or taken in."""
    ea, a = tether[0], tether[2]
    if n == 0:
        x0, y0, z0, vx, vy, vz = x[0], x[1], x[2], x[3], x[4], x[5]
    else:
        x0, y0, z0 = beads[n - 1, 0], beads[n - 1, 1], beads[n - 1, 2]
        vx, vy, vz = beads[n - 1, 3], beads[n - 1, 4], beads[n - 1, 5]
    d = sqrt(x0*x0 + y0*y0 + z0*z0)
    wound = d/(1.0 + tension/ea)
    if wound < 0.5*a and n > 0:
        return n - 1
    if wound <= 1.5*a or n == len(beads):
        return n
    left = 1.0 - a*(1.0 + tension/ea)/d                 # of the way from the reel
    ex, ey, ez = x0/d, y0/d, z0/d
    along = vx*ex + vy*ey + vz*ez
    beads[n, 0], beads[n, 1], beads[n, 2] = left*x0, left*y0, left*z0
    beads[n, 3] = along*ex + left*(vx - along*ex)
    beads[n, 4] = along*ey + left*(vy - along*ey)
    beads[n, 5] = along*ez + left*(vz - along*ez)
    return n + 1


@compiled
def advance(states, beads, counts, commands, orbit, craft, tether, h, parts):
    """
    Return what a step of `h` [s] in `parts` parts makes of N grippers and their chains.

    States (N, 13), beads (N, most, 6), outermost first, counts (N,), and (N, 2): unstretched length
    that is paid out [m], tension at the gripper [N].
    """
    made, chain, count = states.copy(), beads.copy(), counts.copy()
    most = beads.shape[1]
    out, told, found = np.zeros((most + 1, 3)), np.zeros(3), np.zeros((len(states), 2))
    part = h/parts
    for row in range(len(made)):
        x, b, n, u, p = made[row], chain[row], count[row], commands[row], craft[row]
        forces(x, b, n, u, orbit[0, 0], orbit[0, 1], orbit[0, 2], p, tether, out, told)
        for k in range(parts):
            for half in range(2):
                for j in range(3):
                    x[3 + j] += 0.5*part*out[0, j]
                    for i in range(n):
                        b[i, 3 + j] += 0.5*part*out[i + 1, j]
                if half == 1:
                    break
                for j in range(3):
                    x[j] += part*x[3 + j]
                    for i in range(n):
                        b[i, j] += part*b[i, 3 + j]
                turn(x, u, told, p, part)
                at = (k + 1)/parts
                forces(x, b, n, u, orbit[0, 0] + at*(orbit[2, 0] - orbit[0, 0]),
                       orbit[0, 1] + at*(orbit[2, 1] - orbit[0, 1]),
                       orbit[0, 2] + at*(orbit[2, 2] - orbit[0, 2]), p, tether, out, told)
        inner = x if n == 0 else b[n - 1]
        d = sqrt(inner[0]*inner[0] + inner[1]*inner[1] + inner[2]*inner[2])
        found[row, 0] = d/(1.0 + u[0]/tether[0]) + n*tether[2]
        found[row, 1] = told[2]
        count[row] = pay_out(x, b, n, u[0], tether)
    return made, chain, count, found
