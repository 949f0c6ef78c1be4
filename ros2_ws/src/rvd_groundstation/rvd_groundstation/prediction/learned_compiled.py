"""
The time and measurement updates of `learned`, LANES rows at a time.

Along track and radially (x, y, vx, vy) the motion is coupled, out of plane (z, vz) it is by itself,
so a covariance has a block of 4 x 4 and one of 2 x 2; components are in that ORDER here. It has two
parts: what comes of start, thrust and lost commands (KNOWN), and what comes of the sensor, by the
noise that is assumed (SENSED). The second one counts by the factor that has been learned.

What a row is, is kept as KEPT numbers, each for LANES rows side by side: number i of row r is at
i*LANES + r, and so it is in `work`, which holds TEMPORARY ones besides. All offsets are constants,
so the loops over the rows, of which no one depends on another, become vector instructions: five
times as fast as row by row. The last rows may be of nobody.
"""

import numpy as np

from rvd_dynamics.compiled import compiled

LANES = 16
ORDER = (0, 1, 3, 4, 2, 5)              # components, in the plane and out of it
# where the numbers of a row begin: two covariances, by block
KNOWN, KNOWN_NORMAL, SENSED, SENSED_NORMAL = 0, 16, 20, 36
ESTIMATE = 40                           # state, (6,)
SUM, WEIGHT = 46, 47                    # what samples say of the factor, weighted; the weights
AGREE, UNKNOWN = 48, 49                 # how much innovations agree; variance of what is unknown
OFF, THEIRS, REST = 50, 56, 62          # last innovations (6,), and of what their variance came
SOME = 68                               # 1 where there was one
KEPT = 69
MEASURED, DRAWN, SHIFT = 69, 75, 81     # sample, variance of its noise; thrust and its covariance
USED, FACTOR, TOGETHER = 88, 89, 90     # 1 where it is used; the factor; how much they agree now
GAINS, GAINS_NORMAL, TEMPORARY = 91, 107, 111   # gains of a component after the other
WORK = 127
RECENT, AGREED, GROWS, SHRINKS = 30.0, 0.25, 2.0, 0.99  # chosen, not derived: see `_follow`
FIRST = 1e-10                           # [m^2/s^4] that it begins with: of 1e-5 m/s^2
MOST = 1e-4                             # [m^2/s^4] variance of an unknown acceleration of 1 cm/s^2


@compiled
def update(state, accel, variance, measured, received, plane, normal, push, share, sigma, least,
           most, calm, gate, besides, patience, in_a_row, outliers, taken, anew, estimate, left):
    """
    Advance N rows by one sample; `state` and all from `in_a_row` on change.

    Parameters
    ----------
    state : ndarray, shape (chunks, KEPT*LANES)
        See above; chunks*LANES is N or a little more.
    accel : ndarray, shape (N, 3)
        Mean acceleration since the sample before [m/s^2].
    variance : ndarray, shape (N, 4)
        Its covariance: xx, yy, zz and xy [m^2/s^4].
    measured, received
        Samples (N, 6), and the rows that have them (N,).
    plane, normal : ndarray, shape (16,) and (4,)
        Motion since the sample before, block by block.
    push : ndarray, shape (10,)
        What an acceleration adds: in the plane (4, 2), and out of it (2,).
    share : float
        Variance of the noise, as a fraction of the component's mean square.
    sigma : ndarray, shape (6,)
        Variance of the noise that does not depend on the component.
    least, most : float
        Bounds of the factor.
    calm : float
        The least variance of the unknown acceleration [m^2/s^4].
    gate, besides, patience
        As `gate.Gate` has them; `besides` are variances (6,).
    in_a_row, outliers, taken, anew
        As `gate.Gate` has them, (N,).
    estimate : ndarray, shape (N, 6)
        Is filled.
    left : ndarray, shape (N, 6, 6)
        Is filled: what a sample leaves of a difference of the estimate; not where it is empty.
    """
    work = np.zeros(WORK*LANES)
    for chunk in range(len(state)):
        first = chunk*LANES
        rows = min(LANES, len(received) - first)
        for i in range(KEPT*LANES):
            work[i] = state[chunk, i]
        for r in range(rows):
            for i in range(6):
                work[(MEASURED + i)*LANES + r] = measured[first + r, ORDER[i]]
            for i in range(3):
                work[(SHIFT + i)*LANES + r] = accel[first + r, i]
            for i in range(4):
                work[(SHIFT + 3 + i)*LANES + r] = variance[first + r, i]
        _carry(work, KNOWN, 4, plane)
        _carry(work, SENSED, 4, plane)
        _carry(work, KNOWN_NORMAL, 2, normal)
        _carry(work, SENSED_NORMAL, 2, normal)
        _move(work, plane, normal, push)
        _expect(work, share, sigma, least, most, besides)
        for r in range(rows):
            row = first + r
            taken[row], anew[row] = received[row] and work[TOGETHER*LANES + r] <= gate, False
            if received[row] and not taken[row]:        # infinite or NaN, too
                in_a_row[row] += 1
                taken[row] = anew[row] = in_a_row[row] > patience
                outliers[row] += not taken[row]
            if taken[row]:
                in_a_row[row] = 0
            if anew[row]:
                _begin_anew(work, r, share, sigma)
            work[USED*LANES + r] = taken[row] and not anew[row]
            if work[USED*LANES + r] == 0.0:             # a sample that nobody can tell from none
                for i in range(6):
                    work[(MEASURED + i)*LANES + r] = work[(ESTIMATE + i)*LANES + r]
            work[TOGETHER*LANES + r] = 0.0
        _measure(work, 0, 4, 0, KNOWN, SENSED, GAINS)
        _measure(work, 1, 4, 0, KNOWN, SENSED, GAINS)
        _measure(work, 2, 4, 0, KNOWN, SENSED, GAINS)
        _measure(work, 3, 4, 0, KNOWN, SENSED, GAINS)
        _measure(work, 0, 2, 4, KNOWN_NORMAL, SENSED_NORMAL, GAINS_NORMAL)
        _measure(work, 1, 2, 4, KNOWN_NORMAL, SENSED_NORMAL, GAINS_NORMAL)
        _follow(work, calm)
        for r in range(rows):
            for i in range(6):
                estimate[first + r, ORDER[i]] = work[(ESTIMATE + i)*LANES + r]
            if len(left):
                _leave(work, r, left[first + r], anew[first + r])
        for i in range(KEPT*LANES):
            state[chunk, i] = work[i]


@compiled
def _carry(work, base, n, phi):
    """Carry the block of a covariance, (n, n) at `base`, over a step: phi C phi'."""
    for r in range(LANES):
        for a in range(n):
            for b in range(n):
                total = 0.0
                for c in range(n):
                    total += phi[a*n + c]*work[(base + c*n + b)*LANES + r]
                work[(TEMPORARY + a*n + b)*LANES + r] = total
    for r in range(LANES):
        for a in range(n):
            for b in range(a + 1):
                total = 0.0
                for c in range(n):
                    total += work[(TEMPORARY + a*n + c)*LANES + r]*phi[b*n + c]
                work[(base + a*n + b)*LANES + r] = total
                work[(base + b*n + a)*LANES + r] = total


@compiled
def _move(work, plane, normal, push):
    """Move the estimate, and add to the covariance what is not known of the acceleration."""
    for r in range(LANES):
        ax, ay = work[SHIFT*LANES + r], work[(SHIFT + 1)*LANES + r]
        for a in range(4):
            total = push[2*a]*ax + push[2*a + 1]*ay
            for b in range(4):
                total += plane[4*a + b]*work[(ESTIMATE + b)*LANES + r]
            work[(TEMPORARY + a)*LANES + r] = total
        for a in range(2):
            total = push[8 + a]*work[(SHIFT + 2)*LANES + r]
            for b in range(2):
                total += normal[2*a + b]*work[(ESTIMATE + 4 + b)*LANES + r]
            work[(TEMPORARY + 4 + a)*LANES + r] = total
    for r in range(LANES):
        for a in range(6):
            work[(ESTIMATE + a)*LANES + r] = work[(TEMPORARY + a)*LANES + r]
        unknown = work[UNKNOWN*LANES + r]
        xx = work[(SHIFT + 3)*LANES + r] + unknown
        yy = work[(SHIFT + 4)*LANES + r] + unknown
        zz, xy = work[(SHIFT + 5)*LANES + r] + unknown, work[(SHIFT + 6)*LANES + r]
        for a in range(4):
            x, y = xx*push[2*a] + xy*push[2*a + 1], xy*push[2*a] + yy*push[2*a + 1]
            for b in range(a + 1):
                total = work[(KNOWN + 4*a + b)*LANES + r] + (x*push[2*b] + y*push[2*b + 1])
                work[(KNOWN + 4*a + b)*LANES + r] = total
                work[(KNOWN + 4*b + a)*LANES + r] = total
        for a in range(2):
            for b in range(a + 1):
                total = work[(KNOWN_NORMAL + 2*a + b)*LANES + r] + zz*push[8 + a]*push[8 + b]
                work[(KNOWN_NORMAL + 2*a + b)*LANES + r] = total
                work[(KNOWN_NORMAL + 2*b + a)*LANES + r] = total


@compiled
def _expect(work, share, sigma, least, most, besides):
    """Find the factor, the noise that a sample has, and how far off it is, all six together."""
    for r in range(LANES):
        factor = min(max(work[SUM*LANES + r]/work[WEIGHT*LANES + r], least), most)
        together = 0.0
        for i in range(6):
            place = 5*i if i < 4 else KNOWN_NORMAL + 3*(i - 4)
            variance = work[(KNOWN + place)*LANES + r] + factor*work[(SENSED + place)*LANES + r]
            x = work[(ESTIMATE + i)*LANES + r]
            drawn = share*(x*x + variance) + sigma[i]
            off = work[(MEASURED + i)*LANES + r] - x
            together += off*off/(variance + factor*drawn + besides[i])
            work[(DRAWN + i)*LANES + r] = drawn
        work[FACTOR*LANES + r] = factor
        work[TOGETHER*LANES + r] = together


@compiled
def _begin_anew(work, r, share, sigma):
    """Let the sample be all that is known of row r."""
    for i in range(ESTIMATE):
        work[i*LANES + r] = 0.0
    for i in range(6):
        place = 5*i if i < 4 else KNOWN_NORMAL + 3*(i - 4)
        x = work[(MEASURED + i)*LANES + r]
        work[(ESTIMATE + i)*LANES + r] = x
        work[(SENSED + place)*LANES + r] = share*x*x + sigma[i]
    work[SOME*LANES + r] = 0.0


@compiled
def _measure(work, j, n, first, known, sensed, gains):
    """
    Use component j of a block, which is component first + j of the state.

    One after the other is the same as all at once. Adds to TOGETHER how much its innovation agrees
    with the last one, and leaves the gains at `gains` + j*n.
    """
    for r in range(LANES):
        used, factor = work[USED*LANES + r], work[FACTOR*LANES + r]
        rest = work[(known + j*n + j)*LANES + r]
        theirs = work[(sensed + j*n + j)*LANES + r] + work[(DRAWN + first + j)*LANES + r]
        total = rest + factor*theirs
        off = work[(MEASURED + first + j)*LANES + r] - work[(ESTIMATE + first + j)*LANES + r]
        before = work[(OFF + first + j)*LANES + r]
        both, others = work[(THEIRS + first + j)*LANES + r], work[(REST + first + j)*LANES + r]
        work[(OFF + first + j)*LANES + r] = off if used else before
        work[(THEIRS + first + j)*LANES + r] = theirs if used else both
        work[(REST + first + j)*LANES + r] = rest if used else others
        # by differences: what lasts is not the sensor's
        both, others, count = both + theirs, others + rest, used*work[SOME*LANES + r]
        weight = factor*both/(factor*both + others)
        said = weight*weight*((off - before)**2 - others)/both
        work[SUM*LANES + r] += said if count else 0.0
        work[WEIGHT*LANES + r] += weight*weight if count else 0.0
        agree = off*before/(0.5*(factor*both + others))
        work[TOGETHER*LANES + r] += agree if count else 0.0
        for a in range(n):
            x, y = work[(known + a*n + j)*LANES + r], work[(sensed + a*n + j)*LANES + r]
            work[(TEMPORARY + a)*LANES + r], work[(TEMPORARY + 4 + a)*LANES + r] = x, y
            work[(gains + j*n + a)*LANES + r] = (x + factor*y)/total if used else 0.0
        work[(TEMPORARY + 8)*LANES + r] = off
        work[(TEMPORARY + 9)*LANES + r], work[(TEMPORARY + 10)*LANES + r] = rest, theirs
    for r in range(LANES):
        off = work[(TEMPORARY + 8)*LANES + r]
        rest, theirs = work[(TEMPORARY + 9)*LANES + r], work[(TEMPORARY + 10)*LANES + r]
        for a in range(n):
            gain = work[(gains + j*n + a)*LANES + r]
            x, y = work[(TEMPORARY + a)*LANES + r], work[(TEMPORARY + 4 + a)*LANES + r]
            work[(ESTIMATE + first + a)*LANES + r] += gain*off
            for b in range(a + 1):
                other = work[(gains + j*n + b)*LANES + r]
                u, v = work[(TEMPORARY + b)*LANES + r], work[(TEMPORARY + 4 + b)*LANES + r]
                left = work[(known + a*n + b)*LANES + r] + (
                    gain*other*rest - (gain*u + other*x))
                work[(known + a*n + b)*LANES + r] = left
                work[(known + b*n + a)*LANES + r] = left
                left = work[(sensed + a*n + b)*LANES + r] + (
                    gain*other*theirs - (gain*v + other*y))
                work[(sensed + a*n + b)*LANES + r] = left
                work[(sensed + b*n + a)*LANES + r] = left


@compiled
def _follow(work, calm):
    """
    Learn of an acceleration that nobody knows of, from innovations that agree.

    Those of a filter that is right do not: the mean over RECENT samples and six components is then
    about 0, give or take 0.05. Above AGREED the unknown acceleration grows, else it shrinks. A
    single pair counts for 1 at most: the first ones of a start that is far off agree by far more.
    """
    for r in range(LANES):
        used, some = work[USED*LANES + r], work[SOME*LANES + r]
        agree, unknown = work[AGREE*LANES + r], work[UNKNOWN*LANES + r]
        now = min(max(work[TOGETHER*LANES + r]/6.0, -1.0), 1.0)
        agree += used*some*(now - agree)/RECENT
        grown = min(max(unknown*GROWS, FIRST), MOST)
        unlike = grown if agree > AGREED else max(unknown*SHRINKS, calm)
        work[AGREE*LANES + r] = agree
        work[UNKNOWN*LANES + r] = unlike if used else unknown
        work[SOME*LANES + r] = 1.0 if used else some


@compiled
def _leave(work, r, left, anew):
    """Fill `left` (6, 6): what the gains of row r leave, nothing where it began anew."""
    for a in range(6):
        for b in range(6):
            left[a, b] = 1.0 if a == b and not anew else 0.0
    for j in range(6):
        n, first, gains = (4, 0, GAINS) if j < 4 else (2, 4, GAINS_NORMAL)
        for b in range(6):
            row = left[ORDER[j], b]
            for a in range(n):
                gain = work[(gains + (j - first)*n + a)*LANES + r]
                left[ORDER[first + a], b] -= gain*row
