"""
The craft as the ground takes it to move, compiled; `six_dof` says what the arrays are.
"""

from math import atan2, cos, sin, sqrt

from rvd_dynamics.compiled import compiled

# Positions in a row of telemetry.
R, V, Q, W, PLACE, TURN, SAFETY = 0, 3, 6, 10, 13, 16, 20
# Positions in the model: dt, n, orbit radius, mass, three moments of inertia, force, torque, then
# gain, derivative time, least input and middle of the trigger of both loops, brake, way back: its
# end, speed and deceleration, then the rate at which the attitude goes back.
DT, N, RADIUS, MASS, INERTIA, FORCE, TORQUE, LOOPS, BRAKE, FARTHEST, BACK, SLOWS, SLEW = (
    0, 1, 2, 3, 4, 7, 8, 9, 17, 18, 19, 20, 21)
MODEL = 22
HOLD, RETREAT = 1, 2


@compiled
def turned(q, v):
    """Return R(q) v of three numbers."""
    tx, ty, tz = (2.0*(q[1]*v[2] - q[2]*v[1]), 2.0*(q[2]*v[0] - q[0]*v[2]),
                  2.0*(q[0]*v[1] - q[1]*v[0]))
    return (v[0] + q[3]*tx + q[1]*tz - q[2]*ty, v[1] + q[3]*ty + q[2]*tx - q[0]*tz,
            v[2] + q[3]*tz + q[0]*ty - q[1]*tx)


@compiled
def back(q):
    """Return the opposite turn."""
    return (-q[0], -q[1], -q[2], q[3])


@compiled
def product(p, q):
    """Return p (x) q."""
    return (p[3]*q[0] + p[0]*q[3] + p[1]*q[2] - p[2]*q[1],
            p[3]*q[1] + p[1]*q[3] + p[2]*q[0] - p[0]*q[2],
            p[3]*q[2] + p[2]*q[3] + p[0]*q[1] - p[1]*q[0],
            p[3]*q[3] - p[0]*q[0] - p[1]*q[1] - p[2]*q[2])


@compiled
def spun(q, w, dt):
    """Return q after turning at w in body axes for dt, of unit length."""
    angle = dt*sqrt(w[0]*w[0] + w[1]*w[1] + w[2]*w[2])
    ratio = 0.5*dt if angle < 1e-4 else dt*sin(0.5*angle)/angle
    p = product(q, (ratio*w[0], ratio*w[1], ratio*w[2], cos(0.5*angle)))
    size = sqrt(p[0]*p[0] + p[1]*p[1] + p[2]*p[2] + p[3]*p[3])
    return (p[0]/size, p[1]/size, p[2]/size, p[3]/size)


@compiled
def vector_of(q):
    """Return axis times angle of a turn."""
    sign = -1.0 if q[3] < 0.0 else 1.0
    s = sqrt(q[0]*q[0] + q[1]*q[1] + q[2]*q[2])
    ratio = 2.0*sign if s < 1e-4 else sign*2.0*atan2(s, sign*q[3])/s
    return (ratio*q[0], ratio*q[1], ratio*q[2])


@compiled
def share(error, rate, model, at):
    """Return the mean output of a loop and its modulator, -1 to 1: linear above the dead band."""
    x = model[at]*(error + model[at + 1]*rate)
    size = abs(x)
    if not size > model[at + 2]:
        return 0.0
    return (1.0 if x > 0.0 else -1.0)*min(size - model[at + 3], 1.0)


@compiled
def predict(rows, begin, push, speed, spin, drifts, resume, model, out):
    """
    Carry rows of telemetry (N, 21) over the wishes (S, N, ...) from `begin` (N,) on, into `out`.

    `out` (N, 13) gets position, velocity, attitude and rate.
    """
    dt, n, m = model[DT], model[N], model[MASS]
    k = 3.0*n*n/model[RADIUS]
    ix, iy, iz = model[INERTIA], model[INERTIA + 1], model[INERTIA + 2]
    for i in range(len(rows)):
        s = rows[i]
        x, y, z, vx, vy, vz = s[R], s[R + 1], s[R + 2], s[V], s[V + 1], s[V + 2]
        q = (s[Q], s[Q + 1], s[Q + 2], s[Q + 3])
        wx, wy, wz = s[W], s[W + 1], s[W + 2]
        place = (s[PLACE], s[PLACE + 1], s[PLACE + 2])
        turn = (s[TURN], s[TURN + 1], s[TURN + 2], s[TURN + 3])
        state = int(s[SAFETY])
        for j in range(begin[i], len(push)):
            if resume[j, i] and state <= RETREAT:
                state = 0
            hands = state < HOLD
            free, loose = hands and drifts[j, i, 0], hands and drifts[j, i, 1]
            # what is held: its motion, as the craft moves it
            go, about = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
            if hands:
                go = turned(q, (speed[j, i, 0], speed[j, i, 1], speed[j, i, 2]))
                about = (spin[j, i, 0], spin[j, i, 1], spin[j, i, 2])
            else:
                if state == RETREAT and place[0] > model[FARTHEST]:
                    left = place[0] - model[FARTHEST]
                    go = (-min(model[BACK], sqrt(2.0*model[SLOWS]*left), left/dt), 0.0, 0.0)
                lean = vector_of(turn)
                size = sqrt(lean[0]*lean[0] + lean[1]*lean[1] + lean[2]*lean[2])
                home = -min(model[SLEW]/max(size, 1e-12), 1.0)
                about = (home*lean[0], home*lean[1], home*lean[2])
            if free:
                place = (x, y, z)
            else:
                place = (place[0] + dt*go[0], place[1] + dt*go[1], place[2] + dt*go[2])
            turn = q if loose else spun(turn, about, dt)
            # forces and torques, body axes
            axis = turned(back(q), (0.0, n, 0.0))
            rel = (wx + axis[0], wy + axis[1], wz + axis[2])
            if free:
                f = (float(push[j, i, 0]), float(push[j, i, 1]), float(push[j, i, 2]))
            else:
                e = turned(back(q), (place[0] - x, place[1] - y, place[2] - z))
                d = turned(back(q), (go[0] - vx, go[1] - vy, go[2] - vz))
                f = (share(e[0], d[0], model, LOOPS), share(e[1], d[1], model, LOOPS),
                     share(e[2], d[2], model, LOOPS))
            if loose:
                t = (float(push[j, i, 3]), float(push[j, i, 4]), float(push[j, i, 5]))
            else:
                e = vector_of(product(back(turn), q))
                at = LOOPS + 4
                t = (share(-e[0], about[0] - rel[0], model, at),
                     share(-e[1], about[1] - rel[1], model, at),
                     share(-e[2], about[2] - rel[2], model, at))
            brake = model[BRAKE]*min(f[0], 0.0) if state == RETREAT else 0.0
            a = turned(q, (model[FORCE]*f[0] + brake, model[FORCE]*f[1], model[FORCE]*f[2]))
            # paper, eq. 1, to second order in distance over orbit radius
            ax = 2.0*n*vz - k*x*z + a[0]/m
            ay = -n*n*y - k*y*z + a[1]/m
            az = -2.0*n*vx + 3.0*n*n*z - 0.5*k*(x*x + y*y - 2.0*z*z) + a[2]/m
            x, y, z = (x + dt*(vx + 0.5*dt*ax), y + dt*(vy + 0.5*dt*ay), z + dt*(vz + 0.5*dt*az))
            vx, vy, vz = vx + dt*ax, vy + dt*ay, vz + dt*az
            # Euler: the rate of the middle of the step turns the craft
            bx = (model[TORQUE]*t[0] - (iz - iy)*wy*wz)/ix
            by = (model[TORQUE]*t[1] - (ix - iz)*wz*wx)/iy
            bz = (model[TORQUE]*t[2] - (iy - ix)*wx*wy)/iz
            h = 0.5*dt
            q = spun(q, (rel[0] + h*bx, rel[1] + h*by, rel[2] + h*bz), dt)
            wx, wy, wz = wx + dt*bx, wy + dt*by, wz + dt*bz
        out[i, R], out[i, R + 1], out[i, R + 2] = x, y, z
        out[i, V], out[i, V + 1], out[i, V + 2] = vx, vy, vz
        out[i, Q], out[i, Q + 1], out[i, Q + 2], out[i, Q + 3] = q[0], q[1], q[2], q[3]
        out[i, W], out[i, W + 1], out[i, W + 2] = wx, wy, wz
