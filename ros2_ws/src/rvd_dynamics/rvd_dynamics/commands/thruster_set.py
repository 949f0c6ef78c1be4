"""
Thrusters of a spacecraft as both sides know them: where they are, which way they push, their group.

Frame   body axes, places from the origin of the craft's drawing; SI units.
Wrench  force and torque (fx, fy, fz, tx, ty, tz) [N, N m] about the centre of mass. The column of a
        thruster is [d F; (p - c) x d F].
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput

Array = NDArray[np.float64]
AXES = ('force x', 'force y', 'force z', 'torque x', 'torque y', 'torque z')
LEAST = 1e-9                            # [N, N m] greatest effect that counts as none


@dataclass(frozen=True)
class ThrusterSet:
    """
    Any number of thrusters.

    Attributes
    ----------
    places, directions : array_like, shape (T, 3)
        Where each is [m], and the unit vector along which it pushes the craft.
    force : array_like, shape (T,)
        Nominal thrust [N].
    groups : tuple of str, length T
        Group of each, J1 to J4 for instance.

    Raises
    ------
    BadInput
        If shapes do not fit, a direction is no unit vector, or a thrust is not positive.
    """

    places: ArrayLike
    directions: ArrayLike
    force: ArrayLike
    groups: tuple[str, ...]

    def __post_init__(self) -> None:
        put = object.__setattr__
        for name, shape in (('places', (-1, 3)), ('directions', (-1, 3)), ('force', (-1,))):
            put(self, name, np.array(getattr(self, name), dtype=float).reshape(shape))
        if not len(self.places) == len(self.directions) == len(self.force) == len(self.groups):
            raise BadInput('thrusters need one place, direction, thrust and group each, got '
                           f'{len(self.places)}, {len(self.directions)}, {len(self.force)} and '
                           f'{len(self.groups)}')
        length = np.sqrt(np.sum(self.directions**2, axis=1))
        for i in np.flatnonzero(~(np.abs(length - 1.0) < 1e-9)):
            raise BadInput(f'direction of thruster {i} must have length 1, got {length[i]:g}')
        for i in np.flatnonzero(~(self.force > 0.0)):
            raise BadInput(f'thrust of thruster {i} must be positive, got {self.force[i]:g} N')

    def __len__(self) -> int:
        return len(self.force)

    def of(self, *groups: str) -> NDArray[np.bool_]:
        """Return which thrusters (T,) are in one of these groups."""
        return np.array([group in groups for group in self.groups])

    def effectiveness(self, centre: ArrayLike = (0.0, 0.0, 0.0)) -> Array:
        """Return the wrench of each thruster about a centre of mass (..., 3) as (..., 6, T)."""
        push = self.directions*self.force[:, np.newaxis]
        arm = self.places - np.asarray(centre, dtype=float)[..., np.newaxis, :]
        torque = np.cross(arm, push)
        both = np.concatenate([np.broadcast_to(push, torque.shape), torque], axis=-1)
        return np.swapaxes(both, -1, -2)

    @cached_property
    def nominal(self) -> Array:
        """Effectiveness (6, T) about the origin."""
        return self.effectiveness()


def joined(*sets: ThrusterSet) -> ThrusterSet:
    """Return all thrusters of some sets as one."""
    return ThrusterSet(np.concatenate([s.places for s in sets]),
                       np.concatenate([s.directions for s in sets]),
                       np.concatenate([s.force for s in sets]),
                       tuple(group for s in sets for group in s.groups))


def require_control(matrix: ArrayLike, usable: ArrayLike, what: str = 'thrusters') -> None:
    """
    Refuse thrusters that cannot push and turn the craft both ways along each axis.

    Parameters
    ----------
    matrix : array_like, shape (6, T)
        Effectiveness.
    usable : array_like, shape (T,)
        Which of them there are: group, and not failed.

    Raises
    ------
    BadInput
        Names the first axis and sense that no combination of them produces, and their rank.
    """
    from scipy.optimize import nnls     # 0.2 s, and a process that only counts thrusters needs none
    found = np.asarray(matrix, dtype=float)[:, np.asarray(usable, dtype=bool)]
    scale = np.abs(found).max(axis=1, initial=0.0)
    rank = np.linalg.matrix_rank(found) if found.size else 0
    for axis, name in enumerate(AXES):
        for sign, sense in ((1.0, '+'), (-1.0, '-')):
            wanted = np.zeros(6)
            wanted[axis] = sign
            if not found.size or scale[axis] < LEAST or nnls(
                    found/np.maximum(scale, 1.0)[:, np.newaxis], wanted)[1] > 1e-6:
                raise BadInput(f'{what} cannot produce {sense}{name} alone: {found.shape[1]} of '
                               f'them are left, their wrenches have rank {rank} of 6')
