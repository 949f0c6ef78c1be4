"""
A spacecraft near its target: hub, panels and tanks on one symmetric mass matrix.

Frames  LVLH: origin the target's centre of mass, x along its velocity, y against its orbit normal,
        z to the Moon; it turns at (0, -n, 0). Body axes: from the centre of mass at rest; nominal
        attitudes are those of LVLH.
State   rows (N, n), named parts in `Spacecraft.states`: relative position and velocity, attitude
        (x, y, z, w) and angular velocity of target and craft, then two numbers for each mode,
        swing and drive. Attitudes are relative to LVLH, angular velocities to inertial space, in
        body axes. Modes and swings are normalised to mass: eta^2 / 2 is energy.
Valid   circular orbit, separation << orbit radius; constant mass; beams without stretching by
        rotation, so angular velocity << the first mode; gravity gradient on the craft at rest; no
        contact, plume or heat.
Source  An, Qu, Wang 2015, eq. 1 to 9; docs/missions/docking.md has them as they are used.

numba is imported when motion is asked for: who only looks at frequencies does not wait for it.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.world.spacecraft.effectors import Panel, participation, swing_columns, Tank

Array = NDArray[np.float64]
PRODUCTS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))     # of an inertia, in a table


class Moved(NamedTuple):
    """What a step makes; rows N."""

    state: Array                # (N, n) at its end
    turned: Array               # (N, 3) integral of the angular velocity [rad], body axes
    gained: Array               # (N, 3) integral of the acceleration felt [m/s], body axes
    felt: Array                 # (N, 3) acceleration felt at the centre at its end [m/s^2]
    angular: Array              # (N, 3) angular acceleration at its end [rad/s^2]


@dataclass(frozen=True)
class Spacecraft:
    """
    Properties of the craft and its target; leading axes of the numbers are batch axes.

    Attributes
    ----------
    mass : array_like, shape (...)
        All of it [kg].
    inertia : array_like, shape (..., 3, 3)
        All of it at rest, about its centre of mass [kg m^2].
    target_inertia : array_like, shape (..., 3, 3)
        Of the target [kg m^2].
    panels, tanks : tuples of Panel and Tank
        Any number.
    mean_motion, orbit_radius : float
        Of the target's orbit [rad/s], [m]; zero motion leaves out gravity.

    Raises
    ------
    BadInput
        If a mass or an inertia is impossible, or the mass matrix is not positive definite.
    """

    mass: ArrayLike
    inertia: ArrayLike
    target_inertia: ArrayLike
    panels: tuple[Panel, ...] = ()
    tanks: tuple[Tank, ...] = ()
    mean_motion: float = 0.0
    orbit_radius: float = 1.0

    def __post_init__(self) -> None:
        if not np.all(np.asarray(self.mass) > 0.0):
            raise BadInput(f'mass must be positive, got {np.min(self.mass):g} kg')
        require_inertia('inertia', self.inertia)
        require_inertia('target inertia', self.target_inertia)
        least = float(np.linalg.eigvalsh(self.mass_matrix)[..., 0].min())
        if not least > 0.0:
            raise BadInput('the mass matrix must be positive definite, that is, panels and tanks '
                           f'have less inertia than all of the craft; least eigenvalue {least:.3g}')

    # -- states -----------------------------------------------------------------------------------

    @cached_property
    def states(self) -> dict[str, tuple[slice, str]]:
        """Where each part of a state is, and its unit."""
        sizes = [('position', 3, 'm'), ('velocity', 3, 'm/s'),
                 ('target_attitude', 4, ''), ('target_rate', 3, 'rad/s'),
                 ('attitude', 4, ''), ('rate', 3, 'rad/s')]
        for i, panel in enumerate(self.panels):
            sizes += [(f'panel_{i}', panel.modes, 'kg^0.5 m'),
                      (f'panel_{i}_rate', panel.modes, 'kg^0.5 m/s')]
        for i, tank in enumerate(self.tanks):
            sizes += [(f'tank_{i}', tank.swings, 'kg^0.5 m'),
                      (f'tank_{i}_rate', tank.swings, 'kg^0.5 m/s')]
        for i in self._driven:
            sizes += [(f'drive_{i}', 1, 'rad'), (f'drive_{i}_rate', 1, 'rad/s')]
        found, at = {}, 0
        for name, size, unit in sizes:
            found[name] = (slice(at, at + size), unit)
            at += size
        return found

    @property
    def size(self) -> int:
        """Number of states."""
        return max(where.stop for where, _ in self.states.values())

    @property
    def drives(self) -> int:
        """Number of driven panels."""
        return len(self._driven)

    @cached_property
    def _driven(self) -> list[int]:
        return [i for i, panel in enumerate(self.panels) if panel.driven]

    def state(self, rows: int = 1, **parts: ArrayLike) -> Array:
        """Return states (rows, n): at rest in LVLH but for the parts given by name."""
        made = np.zeros((rows, self.size))
        rest = {'target_attitude': (0, 0, 0, 1), 'attitude': (0, 0, 0, 1),
                'target_rate': (0, -self.mean_motion, 0), 'rate': (0, -self.mean_motion, 0)}
        for name, value in {**rest, **parts}.items():
            made[:, self.states[name][0]] = value
        return made

    # -- at rest ----------------------------------------------------------------------------------

    @cached_property
    def mass_matrix(self) -> Array:
        """Mass matrix at rest (..., m, m): translation, rotation, modes, swings; drives fixed."""
        columns = [participation(p) for p in self.panels] + [swing_columns(t) for t in self.tanks]
        inertia = np.asarray(self.inertia, dtype=float)
        mass = np.asarray(self.mass, dtype=float)
        batch = np.broadcast_shapes(mass.shape, inertia.shape[:-2],
                                    *(part.shape[:-2] for pair in columns for part in pair))
        size = 6 + sum(p.shape[-1] for p, _ in columns)
        made = np.zeros((*batch, size, size))
        made[...] = np.eye(size)
        made[..., :3, :3] *= mass[..., np.newaxis, np.newaxis]
        made[..., 3:6, 3:6] = inertia
        at = 6
        for p, r in columns:
            to = at + p.shape[-1]
            made[..., :3, at:to], made[..., 3:6, at:to] = p, r
            made[..., at:to, :6] = np.swapaxes(made[..., :6, at:to], -1, -2)
            at = to
        return made

    @cached_property
    def stiffness(self) -> Array:
        """Squared frequencies of modes and swings when the hub is held (..., m - 6) [1/s^2]."""
        return self._of_modes('frequency')**2

    def _of_modes(self, name: str) -> Array:
        parts = [np.asarray(getattr(p, name), dtype=float) for p in self.panels]
        parts += [np.asarray(getattr(t, name), dtype=float)[..., np.newaxis]
                  + np.zeros(t.swings) for t in self.tanks]
        batch = np.broadcast_shapes(*(part.shape[:-1] for part in parts)) if parts else ()
        return np.concatenate([np.broadcast_to(part, (*batch, part.shape[-1])) for part in parts],
                              axis=-1) if parts else np.zeros(0)

    @property
    def frequencies(self) -> Array:
        """Frequencies of the free craft with everything coupled (..., m - 6) [rad/s], rising."""
        k = self.stiffness
        m = self.mass_matrix
        # the hub eliminated: (1 - C^T H^-1 C) eta'' + K eta = 0, symmetric in K^(1/2) eta
        c = m[..., :6, 6:]
        reduced = m[..., 6:, 6:] - np.swapaxes(c, -1, -2) @ np.linalg.solve(m[..., :6, :6], c)
        root = np.sqrt(k)
        scaled = reduced/(root[..., :, np.newaxis]*root[..., np.newaxis, :])
        return 1.0/np.sqrt(np.linalg.eigvalsh(scaled)[..., ::-1])

    def numerical_damping(self, step_s: float) -> tuple[Array, Array]:
        """
        Return how much classical Runge-Kutta steps damp each coupled mode, and how much it damps.

        Parameters
        ----------
        step_s : float
            Length of a step [s].

        Returns
        -------
        numerical, own : ndarray, shape (m - 6,)
            Damping ratios that the steps add to an undamped mode, negative where they feed it, and
            those of the craft, in the order of `frequencies`; one row of properties only.
        """
        w = self.frequencies
        z = 1j*w*step_s
        grown = np.abs(1 + z*(1 + z/2*(1 + z/3*(1 + z/4))))
        m, k, xi = self.mass_matrix, self.stiffness, self._of_modes('damping')
        size, flex = len(m), len(k)
        inverse = np.linalg.inv(m)[6:, 6:]
        slope = np.block([[np.zeros((flex, flex)), np.eye(flex)],
                          [-inverse*k, -inverse*(2*xi*np.sqrt(k))]])
        roots = np.linalg.eigvals(slope)
        roots = roots[roots.imag > 0.0]
        roots = roots[np.argsort(np.abs(roots))]
        if len(roots) != size - 6:
            raise BadInput('a mode is damped beyond oscillation')
        return -np.log(grown)/(w*step_s), -roots.real/np.abs(roots)

    # -- motion -----------------------------------------------------------------------------------

    @cached_property
    def _tables(self) -> tuple:
        """Properties as the compiled loop wants them: its table, layout, and the orbit."""
        rows = self._rows

        def spread(value: ArrayLike, *shape: int) -> Array:
            return np.broadcast_to(np.asarray(value, dtype=float), (rows, *shape))

        def number(value: ArrayLike) -> Array:
            return spread(value)[:, np.newaxis]

        def six(inertia: ArrayLike) -> Array:
            inertia = spread(inertia, 3, 3)
            return np.stack([inertia[:, i, j] for i, j in PRODUCTS], axis=-1)

        # The hub at rest, with what elimination takes from it for good: all modes of fixed panels,
        # and swings along one axis.
        hub = np.zeros((rows, 21))
        hub[:, [0, 3, 5]] = number(self.mass)
        for p, r in [participation(p) for p in self.panels if not p.driven] + [
                swing_columns(t) for t in self.tanks if t.swings == 1]:
            p, r = spread(p, *p.shape[-2:]), spread(r, *r.shape[-2:])
            for at, left, right, pairs in ((0, p, p, PRODUCTS), (6, p, r, np.ndindex(3, 3)),
                                           (15, r, r, PRODUCTS)):
                for k, (i, j) in enumerate(pairs):
                    hub[:, at + k] -= (left[:, i]*right[:, j]).sum(axis=-1)
        table = [hub, six(self.inertia), six(self.target_inertia)]
        for p in self.panels:
            a, d, w, xi = (spread(v, p.modes) for v in (p.first_moment, p.second_moment,
                                                        p.frequency, p.damping))
            sums = np.stack([(a*a).sum(-1), (a*d).sum(-1), (d*d).sum(-1)], axis=-1)
            modes = np.stack([a, d, 2.0*xi*w, w*w], axis=-1).reshape(rows, -1)
            table += [spread(p.root, 3), spread(p.span, 3), spread(p.normal, 3),
                      number(p.chord_inertia), sums, modes]
        for t in self.tanks:
            w, xi = spread(t.frequency), spread(t.damping)
            table += [spread(t.place, 3), np.sqrt(number(t.mass)),
                      np.stack([2.0*xi*w, w*w], axis=-1),
                      spread(np.ravel(t.axes), 3*t.swings)]
        layout = [len(self.panels), len(self.tanks)]
        layout += [number for p in self.panels for number in (p.modes, p.driven)]
        layout += [t.swings for t in self.tanks]
        return (np.ascontiguousarray(np.concatenate(table, axis=-1)),
                np.array(layout, dtype=np.int64), float(self.mean_motion),
                float(self.orbit_radius))

    @cached_property
    def _rows(self) -> int:
        """Number of rows of properties: one for all, or one each."""
        shapes = [np.shape(self.mass), np.shape(self.inertia)[:-2],
                  np.shape(self.target_inertia)[:-2]]
        for p in self.panels:
            shapes += [np.shape(v)[:-1] for v in (p.root, p.first_moment, p.second_moment,
                                                  p.frequency, p.damping)]
            shapes.append(np.shape(p.chord_inertia))
        for t in self.tanks:
            shapes += [np.shape(t.place)[:-1], *map(np.shape, (t.mass, t.frequency, t.damping))]
        shape = np.broadcast_shapes(*shapes)
        if len(shape) > 1:
            raise ValueError(f'properties must have one batch axis, got shape {shape}')
        return int(np.prod(shape, dtype=int))

    def _which(self, rows: int) -> NDArray[np.int64]:
        if self._rows not in (1, rows):
            raise ValueError(f'{rows} states, but {self._rows} rows of properties')
        return np.arange(rows) if self._rows == rows else np.zeros(rows, dtype=np.int64)

    def slopes(self, state: ArrayLike, wrench: ArrayLike, target_torque: ArrayLike = 0.0,
               drive_torque: ArrayLike = 0.0) -> tuple[Array, Array]:
        """
        Return the time derivative (N, n) of states (N, n), and the acceleration felt (N, 3).

        `wrench` (..., 6) is force and torque about the centre of mass at rest [N, N m] in body
        axes, `target_torque` (..., 3) and `drive_torque` (..., drives) [N m].
        """
        state = np.array(state, dtype=float, order='C')
        rows = len(state)
        return _compiled().slopes(state, _full(wrench, rows, 6), _full(target_torque, rows, 3),
                                  _full(drive_torque, rows, self.drives), self._which(rows),
                                  *self._tables)

    def advance(self, state: ArrayLike, wrench: ArrayLike, step_s: float,
                target_torque: ArrayLike = 0.0, drive_torque: ArrayLike = 0.0) -> Moved:
        """
        Return states (N, n) after K sub-steps that make up `step_s` [s], and what was felt.

        `wrench` (N, 2 K + 1, 6) is given at the ends and the middle of each sub-step; the others
        as `slopes`, held over the step.
        """
        state = np.array(state, dtype=float, order='C')
        rows, wrench = len(state), np.ascontiguousarray(wrench, dtype=float)
        sub_steps = (wrench.shape[1] - 1)//2
        seen = _compiled().advance(
            state, wrench, _full(target_torque, rows, 3),
            _full(drive_torque, rows, self.drives), self._which(rows), step_s/sub_steps,
            *self._tables)
        return Moved(state, seen[:, 0:3], seen[:, 3:6], seen[:, 6:9], seen[:, 9:12])


def require_inertia(what: str, inertia: ArrayLike) -> None:
    """
    Refuse an inertia (..., 3, 3) that no body has.

    Raises
    ------
    BadInput
        If one is not symmetric, has a principal moment that is not positive, or one that is
        greater than the sum of the others.
    """
    given = np.asarray(inertia, dtype=float)
    if not np.array_equal(given, np.swapaxes(given, -1, -2)):
        raise BadInput(f'{what} must be symmetric, got {given.tolist()}')
    moments = np.linalg.eigvalsh(given)
    least = moments[..., 0].min()
    if not least > 0.0:
        raise BadInput(f'{what}: each principal moment must be positive, got {least:g} kg m^2')
    excess = moments[..., 2] - moments[..., 0] - moments[..., 1]
    if not np.all(excess <= 1e-9*moments[..., 2]):
        row = moments.reshape(-1, 3)[np.argmax(excess)]
        raise BadInput(f'{what}: no principal moment may exceed the sum of the others, got '
                       f'{row[0]:g}, {row[1]:g}, {row[2]:g} kg m^2')


def _full(value: ArrayLike, rows: int, width: int) -> Array:
    # always a copy: numba compiles all of the loop once more for an array that is read-only
    return np.array(np.broadcast_to(np.asarray(value, dtype=float), (rows, width)), order='C')


@lru_cache(maxsize=1)
def _compiled() -> Any:
    from rvd_dynamics.world.spacecraft import motion_compiled       # numba
    return motion_compiled
