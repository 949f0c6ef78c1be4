"""
Which thrusters answer a command of six axes: by table, least squares or linear programme.

Command  (..., 6) of -1, 0, 1: push along x, y, z and turn about x, y, z, body axes. `authority` (6)
         says what 1 means [N, N m]. The answer (..., T) is how much of each thruster, 0 to 1.
Ways     table      pushing groups for forces, turning groups for torques, by direction, all on
         nnls       min |B u - w|, u >= 0 (Lawson, Hanson 1974), scaled so that u <= 1
         programme  min of the propellant, B u = s w, 0 <= u <= 1, with s as near to 1 as can be
Source   An, Qu, Wang 2015, section 2.5: an allocation module designed beforehand, not printed.

There are only 729 commands: each is solved once for a set of usable thrusters, when it comes.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.thruster_set import require_control, ThrusterSet

Array = NDArray[np.float64]
POWERS = 3**np.arange(6)
MOSTLY = 0.5                            # cosine between an axis and thrusters of the table for it
SHORTFALL = 1e3                         # price of a unit of s, against propellant of full thrust


def by_table(matrix: Array, authority: Array, force: Array, wrench: Array) -> Array:
    """
    Return the thrusters (T,) that act along the axes of a wrench (6,).

    Of the columns those of the pushing groups have no torque here, the others no force.
    """
    size = np.sqrt(np.sum(matrix*matrix, axis=0))
    along = matrix*np.sign(wrench)[:, np.newaxis] > MOSTLY*size
    return along.any(axis=0).astype(float)


def by_nnls(matrix: Array, authority: Array, force: Array, wrench: Array) -> Array:
    """Return u (T,) >= 0 with B u nearest to a wrench (6,), each axis by its authority."""
    from scipy.optimize import nnls
    u, _ = nnls(matrix/authority[:, np.newaxis], wrench/authority)
    return u/max(1.0, u.max(initial=0.0))


def by_programme(matrix: Array, authority: Array, force: Array, wrench: Array) -> Array:
    """Return u (T,) of 0 to 1 with the least propellant and B u along a wrench (6,)."""
    from scipy.optimize import linprog
    scaled = np.column_stack([matrix/authority[:, np.newaxis], -wrench/authority])
    cost = np.append(force/force.max(), -SHORTFALL)
    found = linprog(cost, A_eq=scaled, b_eq=np.zeros(6), bounds=(0.0, 1.0), method='highs')
    return np.clip(found.x[:-1], 0.0, 1.0)


WAYS: dict[str, Callable] = {'table': by_table, 'nnls': by_nnls, 'programme': by_programme}


class Allocation:
    """
    Thrusters for commands of six axes.

    Parameters
    ----------
    thrusters : ThrusterSet
    way : str
        One of WAYS.
    authority : array_like, shape (6,)
        Force and torque of a command of 1 [N, N m].
    push, turn : tuple of str
        Groups that may be used. The table takes forces from the one and torques from the other.

    Raises
    ------
    BadInput
        If those thrusters cannot push and turn the craft both ways along each axis.
    """

    def __init__(self, thrusters: ThrusterSet, way: str, authority: ArrayLike,
                 push: tuple[str, ...], turn: tuple[str, ...]) -> None:
        if way not in WAYS:
            raise BadInput(f'way must be one of {", ".join(WAYS)}, got {way!r}')
        self._thrusters, self._way = thrusters, WAYS[way]
        self._authority = np.asarray(authority, dtype=float)
        self._push, self._turn = push, turn
        self.fail(np.zeros(len(thrusters), dtype=bool))

    def fail(self, failed: ArrayLike) -> None:
        """
        Leave out thrusters (T,) known to have failed.

        Raises
        ------
        BadInput
            If the others cannot produce every wrench.
        """
        groups = dict.fromkeys(self._push + self._turn)
        usable = self._thrusters.of(*groups) & ~np.asarray(failed, dtype=bool)
        matrix = self._thrusters.nominal
        if self._way is by_table:
            push, turn = self._thrusters.of(*self._push), self._thrusters.of(*self._turn)
            matrix = np.concatenate([matrix[:3]*push, matrix[3:]*turn])
        require_control(matrix, usable, f'thrusters of {", ".join(groups)}')
        self._index = np.flatnonzero(usable)
        self._matrix = matrix[:, self._index]
        self._solved = np.zeros((3**6, len(self._thrusters)))
        self._known = np.zeros(3**6, dtype=bool)

    def __call__(self, command: ArrayLike) -> Array:
        """Return how much of each thruster (..., T) answers commands (..., 6) of -1, 0, 1."""
        command = np.asarray(command)
        codes = ((np.rint(command).astype(np.int64) + 1)*POWERS).sum(axis=-1)
        new = ~self._known[codes]
        if np.count_nonzero(new):
            for code in np.unique(codes[new]):
                self._solve(int(code))
        return self._solved[codes]

    def _solve(self, code: int) -> None:
        wrench = (code//POWERS % 3 - 1)*self._authority
        if np.any(wrench):
            self._solved[code, self._index] = self._way(
                self._matrix, self._authority, self._thrusters.force[self._index], wrench)
        self._known[code] = True


class Shares:
    """
    Makes pulses of shares: a valve that is to be open for a part of the time opens now and then.

    A share of 1 is open, one of 0 shut; what lies between adds up until half of a shortest pulse
    of `steps` is owed, and is then paid by one.
    """

    def __init__(self, steps: int, shape: tuple) -> None:
        self._steps = steps
        self._owed = np.zeros(shape)
        self._left = np.zeros(shape, dtype=np.int64)

    def open(self, share: ArrayLike) -> NDArray[np.bool_]:
        """Return which valves are open in this step."""
        share = np.asarray(share, dtype=float)
        whole, part = share > 1.0 - 1e-9, (share > 1e-9) & (share <= 1.0 - 1e-9)
        self._left = np.maximum(self._left - 1, 0)
        if part.any():
            self._owed = np.where(part, self._owed + share, self._owed)
            starts = part & (self._left == 0) & (self._owed >= 0.5*self._steps)
            self._left = np.where(starts, self._steps, self._left)
            self._owed = np.where(starts, self._owed - self._steps, self._owed)
        return whole | (self._left > 0)
