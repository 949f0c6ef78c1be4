"""
Equations of motion of a spacecraft with panels and tanks, and of its target, for numba.

Everything here is for the machine: arrays of a fixed layout, no checks; `spacecraft` makes them and
says what they are. The same compiled loop serves a node and a batch, row by row.

Method  A panel is a line of mass elements at r = root + xi s along its span s, which bend along its
        normal e by u(xi) = sum phi_i(xi) eta_i; a tank is a particle that swings along one to
        three axes. With rho the place of an element in the craft, its acceleration is
            a + w' x rho + w x (w x rho) + 2 w x rho_dot + rho_ddot,
        and the equations are the sums of it over all elements along the directions in which the
        craft can move (Kane). Only sums enter: a_i = S phi_i, d_i = S xi phi_i, and, with the modes
        normalised to mass, S phi_i phi_j = 1 for i = j, else 0. So the equations are exact for any
        size of eta and w within that picture: energy and both momenta of the free craft stay.
        Modes and swings are eliminated one by one, since no two of them couple but through the
        hub; what is left are two systems of three equations.

    [ m I      -[s]x    P ] [ a      ]   [ F     - S rho-bias           ]
    [ [s]x      I(eta)  R ] [ w'     ] = [ T + Mg - S rho x rho-bias     ]
    [ P^T       R^T     1 ] [ eta''  ]   [ -2 xi Om eta' - Om^2 eta - .. ]

Source  An, Qu, Wang 2015, eq. 1 to 9, made symmetric; P, R, m, I as docs/missions/docking.md.
"""

import numpy as np

from rvd_dynamics.compiled import compiled

# Positions in a state; modes follow from FLEX on, each panel's, then each tank's, then the drives.
X, V, QT, WT, QC, WC, FLEX = 0, 3, 6, 10, 13, 17, 20
# Positions in a row of properties. First the hub's matrix [A, B; B^T, J + I], symmetric parts as
# six numbers: J is the inertia at rest, I what elimination takes from it; then the target's
# inertia.
A, B, I, J, TARGET, PARTS = 0, 6, 15, 21, 27, 33
# In a panel's part, then four numbers for each mode: a, d, 2 xi omega, omega^2.
ROOT, SPAN, NORMAL, CHORD, SUMS, MODES = 0, 3, 6, 9, 10, 13
# In a tank's part, then three numbers for each axis.
PLACE, ROOT_MASS, DAMPING, STIFFNESS, AXES = 0, 3, 4, 5, 6
# In the layout: panels, tanks, then modes and 0 or 1 (driven) of each panel, and axes of each tank.
PANELS, TANKS, SHAPES = 0, 1, 2
KEPT_PANEL, KEPT_AXIS = 16, 7           # scratch of a panel, to which its modes add, and of an axis
SENSED = 12                 # turned [rad], gained [m/s], acceleration [m/s^2], angular acceleration


@compiled
def relative(x, y, z, vx, vz, n, radius):
    """
    Return what gravity and the turning frame add to the relative acceleration, in LVLH axes.

    Second order in distance over orbit radius; paper, eq. 1: -A X' - B X - C(X).
    """
    k = 3.0*n*n/radius
    return (2.0*n*vz - k*x*z,
            -n*n*y - k*y*z,
            -2.0*n*vx + 3.0*n*n*z - 0.5*k*(x*x + y*y - 2.0*z*z))


@compiled
def inverse(a, b, c, d, e, f):
    """Return the inverse of the symmetric matrix [[a, b, c], [b, d, e], [c, e, f]], alike."""
    p, q, r = d*f - e*e, c*e - b*f, b*e - c*d
    k = 1.0/(a*p + b*q + c*r)
    return k*p, k*q, k*r, k*(a*f - c*c), k*(b*c - a*e), k*(a*d - b*b)


@compiled
def turning(q, at, wx, wy, wz, out):
    """Write q' = 1/2 q (x) (w, 0)."""
    x, y, z, s = q[at], q[at + 1], q[at + 2], q[at + 3]
    out[at] = 0.5*(s*wx + y*wz - z*wy)
    out[at + 1] = 0.5*(s*wy + z*wx - x*wz)
    out[at + 2] = 0.5*(s*wz + x*wy - y*wx)
    out[at + 3] = -0.5*(x*wx + y*wy + z*wz)


@compiled
def target_slope(y, out, torque, row, n):
    """Write the slope of the target's attitude: a rigid body under a torque."""
    a, b, c = row[TARGET], row[TARGET + 1], row[TARGET + 2]
    d, e, f = row[TARGET + 3], row[TARGET + 4], row[TARGET + 5]
    qx, qy, qz, qw = y[QT], y[QT + 1], y[QT + 2], y[QT + 3]
    wx, wy, wz = y[WT], y[WT + 1], y[WT + 2]
    hx, hy, hz = a*wx + b*wy + c*wz, b*wx + d*wy + e*wz, c*wx + e*wy + f*wz
    tx = torque[0] - (wy*hz - wz*hy)
    ty = torque[1] - (wz*hx - wx*hz)
    tz = torque[2] - (wx*hy - wy*hx)
    a, b, c, d, e, f = inverse(a, b, c, d, e, f)
    out[WT], out[WT + 1], out[WT + 2] = (a*tx + b*ty + c*tz, b*tx + d*ty + e*tz,
                                         c*tx + e*ty + f*tz)
    # the frame turns at -n about its y axis, which the body sees as the second row of R
    turning(y, QT, wx + n*2.0*(qx*qy + qw*qz), wy + n*(1.0 - 2.0*(qx*qx + qz*qz)),
            wz + n*2.0*(qy*qz - qw*qx), out)


@compiled
def plus(p, q):
    """Return the sum of two tuples of fifteen."""
    return (p[0] + q[0], p[1] + q[1], p[2] + q[2], p[3] + q[3], p[4] + q[4], p[5] + q[5],
            p[6] + q[6], p[7] + q[7], p[8] + q[8], p[9] + q[9], p[10] + q[10], p[11] + q[11],
            p[12] + q[12], p[13] + q[13], p[14] + q[14])


@compiled
def weigh(hub, px, py, pz, rx, ry, rz, k):
    """Take the inertia of one coordinate out of the hub's matrix: k (P, R) (P, R)^T."""
    qx, qy, qz = k*px, k*py, k*pz
    hub[A] -= px*qx
    hub[A + 1] -= px*qy
    hub[A + 2] -= px*qz
    hub[A + 3] -= py*qy
    hub[A + 4] -= py*qz
    hub[A + 5] -= pz*qz
    hub[B] -= qx*rx
    hub[B + 1] -= qx*ry
    hub[B + 2] -= qx*rz
    hub[B + 3] -= qy*rx
    hub[B + 4] -= qy*ry
    hub[B + 5] -= qy*rz
    hub[B + 6] -= qz*rx
    hub[B + 7] -= qz*ry
    hub[B + 8] -= qz*rz
    qx, qy, qz = k*rx, k*ry, k*rz
    hub[I] -= rx*qx
    hub[I + 1] -= rx*qy
    hub[I + 2] -= rx*qz
    hub[I + 3] -= ry*qy
    hub[I + 4] -= ry*qz
    hub[I + 5] -= rz*qz


@compiled
def panel(y, at, angle, turn, row, part, modes, keep, kept, wx, wy, wz):
    """
    Return what a panel adds to the hub: force, torque, first moment, inertia of its bent shape.

    Its angle [rad] and rate [rad/s] are zero where it is fixed. What its modes need later goes into
    `keep` from `kept` on.
    """
    rx, ry, rz = row[part], row[part + 1], row[part + 2]
    px, py, pz = row[part + SPAN], row[part + SPAN + 1], row[part + SPAN + 2]
    ex, ey, ez = row[part + NORMAL], row[part + NORMAL + 1], row[part + NORMAL + 2]
    cx, cy, cz = py*ez - pz*ey, pz*ex - px*ez, px*ey - py*ex            # chord: s x e
    if angle != 0.0:
        co, si = np.cos(angle), np.sin(angle)
        ex, ey, ez, cx, cy, cz = (co*ex + si*cx, co*ey + si*cy, co*ez + si*cz,
                                  co*cx - si*ex, co*cy - si*ey, co*cz - si*ez)
    w2 = wx*wx + wy*wy + wz*wz
    ew = ex*wx + ey*wy + ez*wz
    pw = px*wx + py*wy + pz*wz
    along = ew*(rx*wx + ry*wy + rz*wz) - w2*(ex*rx + ey*ry + ez*rz)     # e . w x (w x root)
    across = ew*pw                                                      # e . w x (w x s)
    own = ew*ew - w2 - 2.0*turn*pw - turn*turn      # the same of e, and what turning adds
    u = du = v = dv = nn = nd = qa = qd = 0.0
    mode = part + MODES
    for i in range(modes):
        eta, speed = y[at + i], y[at + modes + i]
        a, d = row[mode], row[mode + 1]
        u += a*eta
        du += d*eta
        v += a*speed
        dv += d*speed
        nn += eta*eta
        nd += eta*speed
        q = -row[mode + 2]*speed - (row[mode + 3] + own)*eta - a*along - d*across
        keep[kept + KEPT_PANEL + i] = q
        mode += 4
        qa += a*q
        qd += d*q
    # moments of the bent shape: l = S r u and its rate m
    lx, ly, lz = rx*u + px*du, ry*u + py*du, rz*u + pz*du
    mx, my, mz = rx*v + px*dv, ry*v + py*dv, rz*v + pz*dv
    # Coriolis: force 2 w x S rho_dot, torque 2 S (w (rho . rho_dot) - rho_dot (rho . w));
    # turning: 2 c theta' u' - e theta'^2 u along the panel
    ut, vt, ft = turn*u, 2*turn*v, turn*turn*u
    gx, gy, gz = 2*(ex*v + cx*ut), 2*(ey*v + cy*ut), 2*(ez*v + cz*ut)
    c1 = 2*(mx*ex + my*ey + mz*ez + turn*(lx*cx + ly*cy + lz*cz) + nd)
    c2 = 2*(mx*wx + my*wy + mz*wz + ew*nd)
    c3 = 2*turn*(lx*wx + ly*wy + lz*wz + ew*nn)
    # the modes: P = e a, R = k a + c d with k = root x e
    kx, ky, kz = ry*ez - rz*ey, rz*ex - rx*ez, rx*ey - ry*ex
    keep[kept], keep[kept + 1], keep[kept + 2] = ex, ey, ez
    keep[kept + 3], keep[kept + 4], keep[kept + 5] = kx, ky, kz
    keep[kept + 6], keep[kept + 7], keep[kept + 8] = cx, cy, cz
    keep[kept + 9], keep[kept + 10], keep[kept + 11] = lx, ly, lz
    keep[kept + 12], keep[kept + 13], keep[kept + 14] = u, nn, nd
    fx = -(wy*gz - wz*gy + cx*vt - ex*ft + ex*qa)
    fy = -(wz*gx - wx*gz + cy*vt - ey*ft + ey*qa)
    fz = -(wx*gy - wy*gx + cz*vt - ez*ft + ez*qa)
    ut, vt = 2*turn, turn*turn
    tx = -(c1*wx - c2*ex - c3*cx + ut*(my*cz - mz*cy + px*nd) - vt*(ly*ez - lz*ey)
           + kx*qa + cx*qd)
    ty = -(c1*wy - c2*ey - c3*cy + ut*(mz*cx - mx*cz + py*nd) - vt*(lz*ex - lx*ez)
           + ky*qa + cy*qd)
    tz = -(c1*wz - c2*ez - c3*cz + ut*(mx*cy - my*cx + pz*nd) - vt*(lx*ey - ly*ex)
           + kz*qa + cz*qd)
    le = 2*(lx*ex + ly*ey + lz*ez) + nn
    return (fx, fy, fz, tx, ty, tz, ex*u, ey*u, ez*u,
            le - (2*lx + nn*ex)*ex, -(lx*ey + ex*ly + nn*ex*ey), -(lx*ez + ex*lz + nn*ex*ez),
            le - (2*ly + nn*ey)*ey, -(ly*ez + ey*lz + nn*ey*ez), le - (2*lz + nn*ez)*ez)


@compiled
def drive(hub, row, part, keep, kept, turn, torque, wx, wy, wz):
    """
    Return what `panel` does for its drive and its chord, which only a panel that turns shows.

    The column of the drive and its right-hand side go into `keep`.
    """
    ox, oy, oz = row[part + NORMAL], row[part + NORMAL + 1], row[part + NORMAL + 2]    # at rest
    px, py, pz = row[part + SPAN], row[part + SPAN + 1], row[part + SPAN + 2]
    chord = row[part + CHORD]
    ex, ey, ez = keep[kept], keep[kept + 1], keep[kept + 2]
    kx, ky, kz = keep[kept + 3], keep[kept + 4], keep[kept + 5]
    cx, cy, cz = keep[kept + 6], keep[kept + 7], keep[kept + 8]
    lx, ly, lz = keep[kept + 9], keep[kept + 10], keep[kept + 11]
    u, nn, nd = keep[kept + 12], keep[kept + 13], keep[kept + 14]
    xx, xy, xz = chord*(ex*ex - ox*ox), chord*(ex*ey - ox*oy), chord*(ex*ez - ox*oz)
    yy, yz, zz = chord*(ey*ey - oy*oy), chord*(ey*ez - oy*oz), chord*(ez*ez - oz*oz)
    # all modes at once, as two with the same sums S a^2, S a d, S d^2
    aa, ad, dd = row[part + SUMS], row[part + SUMS + 1], row[part + SUMS + 2]
    root = np.sqrt(aa)
    second = ad/root
    weigh(hub, ex*root, ey*root, ez*root, kx*root + cx*second, ky*root + cy*second,
          kz*root + cz*second, 1.0)
    rest = np.sqrt(max(dd - second*second, 0.0))
    weigh(hub, 0.0, 0.0, 0.0, cx*rest, cy*rest, cz*rest, 1.0)
    ew = ex*wx + ey*wy + ez*wz
    cw = cx*wx + cy*wy + cz*wz
    pw = px*wx + py*wy + pz*wz
    w2 = wx*wx + wy*wy + wz*wz
    c4 = 2*turn*chord*cw
    size = nn + chord
    q = (torque - (cw*(lx*wx + ly*wy + lz*wz) - w2*(lx*cx + ly*cy + lz*cz)
                   + (nn - chord)*cw*ew + 2*nd*(pw + turn)))/size
    ox, oy, oz = cx*u, cy*u, cz*u
    hx, hy, hz = ly*cz - lz*cy + px*size, lz*cx - lx*cz + py*size, lx*cy - ly*cx + pz*size
    weigh(hub, ox, oy, oz, hx, hy, hz, 1.0/size)
    for i, value in enumerate((ox, oy, oz, hx, hy, hz)):
        keep[kept + 9 + i] = value/size
    keep[kept + 15] = q
    return (-ox*q, -oy*q, -oz*q, -c4*ex - hx*q, -c4*ey - hy*q, -c4*ez - hz*q, 0.0, 0.0, 0.0,
            xx, xy, xz, yy, yz, zz)


@compiled
def tank(y, at, hub, row, part, count, keep, kept, wx, wy, wz):
    """Return what `panel` does for a tank."""
    ox, oy, oz = row[part], row[part + 1], row[part + 2]
    root = row[part + ROOT_MASS]
    rx, ry, rz = ox, oy, oz
    gx = gy = gz = 0.0                                      # rho_dot
    inverse_root = 1.0/root
    for i in range(count):
        axis = part + AXES + 3*i
        q, v = y[at + i]*inverse_root, y[at + count + i]*inverse_root
        ax, ay, az = row[axis], row[axis + 1], row[axis + 2]
        rx += ax*q
        ry += ay*q
        rz += az*q
        gx += ax*v
        gy += ay*v
        gz += az*v
    mass = root*root
    hx, hy, hz = 2*(wy*gz - wz*gy), 2*(wz*gx - wx*gz), 2*(wx*gy - wy*gx)
    fx, fy, fz = -mass*hx, -mass*hy, -mass*hz
    tx, ty, tz = -mass*(ry*hz - rz*hy), -mass*(rz*hx - rx*hz), -mass*(rx*hy - ry*hx)
    rw, w2 = rx*wx + ry*wy + rz*wz, wx*wx + wy*wy + wz*wz
    hx += wx*rw - w2*rx                                     # with w x (w x rho): the bias
    hy += wy*rw - w2*ry
    hz += wz*rw - w2*rz
    for i in range(count):
        axis = part + AXES + 3*i
        ax, ay, az = row[axis], row[axis + 1], row[axis + 2]
        q = (-row[part + DAMPING]*y[at + count + i] - row[part + STIFFNESS]*y[at + i]
             - root*(ax*hx + ay*hy + az*hz))
        ax, ay, az = root*ax, root*ay, root*az
        kx, ky, kz = ry*az - rz*ay, rz*ax - rx*az, rx*ay - ry*ax
        to = kept + KEPT_AXIS*i
        keep[to] = q
        keep[to + 1], keep[to + 2], keep[to + 3] = ax, ay, az
        keep[to + 4], keep[to + 5], keep[to + 6] = kx, ky, kz
        fx, fy, fz = fx - ax*q, fy - ay*q, fz - az*q
        tx, ty, tz = tx - kx*q, ty - ky*q, tz - kz*q
        if count > 1:                           # else its inertia is constant, and the hub's
            weigh(hub, ax, ay, az, kx, ky, kz, 1.0)
    xx, yy, zz = mass*(rx*rx - ox*ox), mass*(ry*ry - oy*oy), mass*(rz*rz - oz*oz)
    return (fx, fy, fz, tx, ty, tz, mass*(rx - ox), mass*(ry - oy), mass*(rz - oz),
            yy + zz, -mass*(rx*ry - ox*oy), -mass*(rx*rz - ox*oz),
            xx + zz, -mass*(ry*rz - oy*oz), xx + yy)


@compiled
def solve(hub, right, wx, wy, wz):
    """Return acceleration and angular acceleration of the hub, all else eliminated."""
    fx, fy, fz, tx, ty, tz, sx, sy, sz, jxx, jxy, jxz, jyy, jyz, jzz = right
    # w x (w x s), and w x (J w) with the inertia of the shape as it is
    ws, w2 = wx*sx + wy*sy + wz*sz, wx*wx + wy*wy + wz*wz
    fx, fy, fz = fx - wx*ws + w2*sx, fy - wy*ws + w2*sy, fz - wz*ws + w2*sz
    hx, hy, hz = jxx*wx + jxy*wy + jxz*wz, jxy*wx + jyy*wy + jyz*wz, jxz*wx + jyz*wy + jzz*wz
    tx, ty, tz = tx - (wy*hz - wz*hy), ty - (wz*hx - wx*hz), tz - (wx*hy - wy*hx)
    # [V B; B^T K] [a; w'] = [f; t]: V first
    b00, b01, b02 = hub[B], hub[B + 1] + sz, hub[B + 2] - sy
    b10, b11, b12 = hub[B + 3] - sz, hub[B + 4], hub[B + 5] + sx
    b20, b21, b22 = hub[B + 6] + sy, hub[B + 7] - sx, hub[B + 8]
    vxx, vxy, vxz, vyy, vyz, vzz = inverse(
        hub[A], hub[A + 1], hub[A + 2], hub[A + 3], hub[A + 4], hub[A + 5])
    g00, g01, g02 = (vxx*b00 + vxy*b10 + vxz*b20, vxx*b01 + vxy*b11 + vxz*b21,
                     vxx*b02 + vxy*b12 + vxz*b22)
    g10, g11, g12 = (vxy*b00 + vyy*b10 + vyz*b20, vxy*b01 + vyy*b11 + vyz*b21,
                     vxy*b02 + vyy*b12 + vyz*b22)
    g20, g21, g22 = (vxz*b00 + vyz*b10 + vzz*b20, vxz*b01 + vyz*b11 + vzz*b21,
                     vxz*b02 + vyz*b12 + vzz*b22)
    tx -= g00*fx + g10*fy + g20*fz
    ty -= g01*fx + g11*fy + g21*fz
    tz -= g02*fx + g12*fy + g22*fz
    kxx, kxy, kxz, kyy, kyz, kzz = inverse(
        jxx + hub[I] - b00*g00 - b10*g10 - b20*g20,
        jxy + hub[I + 1] - b00*g01 - b10*g11 - b20*g21,
        jxz + hub[I + 2] - b00*g02 - b10*g12 - b20*g22,
        jyy + hub[I + 3] - b01*g01 - b11*g11 - b21*g21,
        jyz + hub[I + 4] - b01*g02 - b11*g12 - b21*g22,
        jzz + hub[I + 5] - b02*g02 - b12*g12 - b22*g22)
    hx, hy, hz = kxx*tx + kxy*ty + kxz*tz, kxy*tx + kyy*ty + kyz*tz, kxz*tx + kyz*ty + kzz*tz
    return (vxx*fx + vxy*fy + vxz*fz - (g00*hx + g01*hy + g02*hz),
            vxy*fx + vyy*fy + vyz*fz - (g10*hx + g11*hy + g12*hz),
            vxz*fx + vyz*fy + vzz*fz - (g20*hx + g21*hy + g22*hz), hx, hy, hz)


@compiled
def slope(y, out, wrench, torque, torques, row, layout, n, radius, hub, keep):
    """
    Write the slope of a state and return the acceleration felt at the centre, in body axes.

    `wrench` (6) force and torque about the centre [N, N m], `torque` (3) on the target, `torques`
    of the drives [N m]; `row` of properties; `hub` and `keep` are scratch.
    """
    target_slope(y, out, torque, row, n)
    wx, wy, wz = y[WC], y[WC + 1], y[WC + 2]
    # rows of R, body to LVLH
    qx, qy, qz, qw = y[QC], y[QC + 1], y[QC + 2], y[QC + 3]
    r00, r01, r02 = 1 - 2*(qy*qy + qz*qz), 2*(qx*qy - qw*qz), 2*(qx*qz + qw*qy)
    r10, r11, r12 = 2*(qx*qy + qw*qz), 1 - 2*(qx*qx + qz*qz), 2*(qy*qz - qw*qx)
    r20, r21, r22 = 2*(qx*qz - qw*qy), 2*(qy*qz + qw*qx), 1 - 2*(qx*qx + qy*qy)
    turning(y, QC, wx + n*r10, wy + n*r11, wz + n*r12, out)
    for i in range(J):
        hub[i] = row[i]
    jxx, jxy, jxz = row[J], row[J + 1], row[J + 2]
    jyy, jyz, jzz = row[J + 3], row[J + 4], row[J + 5]
    # gravity gradient on the craft at rest: 3 n^2 z x J z, z the nadir in body axes
    k = 3.0*n*n
    hx, hy, hz = (jxx*r20 + jxy*r21 + jxz*r22, jxy*r20 + jyy*r21 + jyz*r22,
                  jxz*r20 + jyz*r21 + jzz*r22)
    right = (wrench[0], wrench[1], wrench[2], wrench[3] + k*(r21*hz - r22*hy),
             wrench[4] + k*(r22*hx - r20*hz), wrench[5] + k*(r20*hy - r21*hx), 0.0, 0.0, 0.0,
             jxx, jxy, jxz, jyy, jyz, jzz)

    panels, tanks = layout[PANELS], layout[TANKS]
    at, part, kept = FLEX, PARTS, 0
    angles = len(y) - 2*len(torques)
    drives = 0
    for p in range(panels):
        modes = layout[SHAPES + 2*p]
        if layout[SHAPES + 2*p + 1]:
            turn = y[angles + 2*drives + 1]
            right = plus(right, panel(y, at, y[angles + 2*drives], turn, row, part, modes, keep,
                                      kept, wx, wy, wz))
            right = plus(right, drive(hub, row, part, keep, kept, turn, torques[drives],
                                      wx, wy, wz))
            drives += 1
        else:
            right = plus(right, panel(y, at, 0.0, 0.0, row, part, modes, keep, kept, wx, wy, wz))
        at += 2*modes
        part += MODES + 4*modes
        kept += KEPT_PANEL + modes
    for t in range(tanks):
        count = layout[SHAPES + 2*panels + t]
        right = plus(right, tank(y, at, hub, row, part, count, keep, kept, wx, wy, wz))
        at += 2*count
        part += AXES + 3*count
        kept += KEPT_AXIS*count

    ax, ay, az, hx, hy, hz = solve(hub, right, wx, wy, wz)
    out[WC], out[WC + 1], out[WC + 2] = hx, hy, hz
    at, part, kept = FLEX, PARTS, 0
    drives = 0
    for p in range(panels):                     # modes, drives and swings from the hub
        modes = layout[SHAPES + 2*p]
        by_a = (keep[kept]*ax + keep[kept + 1]*ay + keep[kept + 2]*az
                + keep[kept + 3]*hx + keep[kept + 4]*hy + keep[kept + 5]*hz)
        by_d = keep[kept + 6]*hx + keep[kept + 7]*hy + keep[kept + 8]*hz
        for i in range(modes):
            mode = part + MODES + 4*i
            out[at + i] = y[at + modes + i]
            out[at + modes + i] = (keep[kept + KEPT_PANEL + i]
                                   - row[mode]*by_a - row[mode + 1]*by_d)
        if layout[SHAPES + 2*p + 1]:
            out[angles + 2*drives] = y[angles + 2*drives + 1]
            out[angles + 2*drives + 1] = keep[kept + 15] - (
                keep[kept + 9]*ax + keep[kept + 10]*ay + keep[kept + 11]*az
                + keep[kept + 12]*hx + keep[kept + 13]*hy + keep[kept + 14]*hz)
            drives += 1
        at += 2*modes
        part += MODES + 4*modes
        kept += KEPT_PANEL + modes
    for t in range(tanks):
        count = layout[SHAPES + 2*panels + t]
        for i in range(count):
            out[at + i] = y[at + count + i]
            out[at + count + i] = keep[kept] - (
                keep[kept + 1]*ax + keep[kept + 2]*ay + keep[kept + 3]*az
                + keep[kept + 4]*hx + keep[kept + 5]*hy + keep[kept + 6]*hz)
            kept += KEPT_AXIS
        at += 2*count

    out[X], out[X + 1], out[X + 2] = y[V], y[V + 1], y[V + 2]
    dx, dy, dz = relative(y[X], y[X + 1], y[X + 2], y[V], y[V + 2], n, radius)
    out[V] = r00*ax + r01*ay + r02*az + dx
    out[V + 1] = r10*ax + r11*ay + r12*az + dy
    out[V + 2] = r20*ax + r21*ay + r22*az + dz
    return ax, ay, az


@compiled
def unit(y, at):
    """Scale a quaternion to unit length, in place."""
    k = 1.0/np.sqrt(y[at]**2 + y[at + 1]**2 + y[at + 2]**2 + y[at + 3]**2)
    for i in range(4):
        y[at + i] *= k


@compiled
def scratch(size, layout):
    """Return scratch memory for `slope`, enough for states of this size."""
    return np.empty(J), np.empty(KEPT_PANEL*layout[PANELS] + KEPT_AXIS*(size - FLEX))


@compiled
def slopes(states, wrench, torque, torques, which, table, layout, n, radius):
    """Return slopes (N, size) of states (N, size), and accelerations felt (N, 3)."""
    out, felt = np.zeros_like(states), np.empty((len(states), 3))
    hub, keep = scratch(states.shape[1], layout)
    for r in range(len(states)):
        felt[r] = slope(states[r], out[r], wrench[r], torque[r], torques[r], table[which[r]],
                        layout, n, radius, hub, keep)
    return out, felt


@compiled
def advance(states, wrench, torque, torques, which, h, table, layout, n, radius):
    """
    Carry states (N, size) on in place by Runge-Kutta steps of h [s]; return what is sensed.

    `wrench` (N, 2 K + 1, 6) is given at the ends and the middle of each of K steps; torques are
    held. Returned (N, SENSED): the turn and the velocity gained over all steps as integrals in
    body axes, and at the end the acceleration felt and the angular acceleration.
    """
    rows, size = states.shape
    count = (wrench.shape[1] - 1)//2
    sensed = np.zeros((rows, SENSED))
    hub, keep = scratch(size, layout)
    y, k, total = np.empty(size), np.empty(size), np.empty(size)
    for r in range(rows):
        s, seen, row = states[r], sensed[r], table[which[r]]
        for call in range(4*count + 1):         # the last one for what is sensed at the end
            j, stage = call//4, call % 4
            if stage == 0:
                y[:] = s
            a = slope(y, k, wrench[r, 2*j + (stage + 1)//2], torque[r], torques[r], row, layout, n,
                      radius, hub, keep)
            if call == 4*count:
                for i in range(3):
                    seen[6 + i] = a[i]
                    seen[9 + i] = k[WC + i]
                break
            part = h/6.0 if stage == 0 or stage == 3 else h/3.0
            for i in range(3):
                seen[i] += part*y[WC + i]
                seen[3 + i] += part*a[i]
            if stage == 0:
                for i in range(size):
                    total[i] = s[i] + part*k[i]
                    y[i] = s[i] + 0.5*h*k[i]
            elif stage == 3:
                for i in range(size):
                    s[i] = total[i] + part*k[i]
                if j == count - 1:
                    unit(s, QT)
                    unit(s, QC)
            else:
                step = 0.5*h if stage == 1 else h
                for i in range(size):
                    total[i] += part*k[i]
                    y[i] = s[i] + step*k[i]
    return sensed
