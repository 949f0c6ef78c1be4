"""
What moves in a spacecraft beside its hub: panels that bend (and turn, if driven), and liquids.

Frame   the craft's body axes, from its centre of mass at rest; SI units.
Panel   a uniform cantilever beam with modes normalised to mass. With lambda_i the roots of
        cos(lambda) cosh(lambda) = -1 and sigma_i = (cosh + cos)/(sinh + sin) at lambda_i:
            a_i = S phi_i       = sqrt(m) 2 sigma_i / lambda_i
            d_i = S xi phi_i    = sqrt(m) L 2 / lambda_i^2
            f_i = f_1 (lambda_i / lambda_1)^2
Tank    a particle on springs: the equivalent mechanical model of the liquid that moves.
Source  An, Qu, Wang 2015, eq. 4 to 9: five cantilever modes a panel, an equivalent pendulum a tank;
        the beam's integrals are derived (R. D. Blevins, Formulas for Natural Frequency and Mode
        Shape, 1979, table 8-1).
"""

from dataclasses import dataclass
from math import cos, cosh, sin, sinh

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def beam_roots(count: int) -> Array:
    """Return the first roots of cos(x) cosh(x) = -1, (count,)."""
    roots = []
    for i in range(count):
        x = (i + 0.5)*np.pi if i else 1.875
        for _ in range(8):                      # Newton on cos(x) + 1/cosh(x)
            x -= (cos(x) + 1.0/cosh(x)) / (-sin(x) - sinh(x)/cosh(x)**2)
        roots.append(x)
    return np.array(roots)


def beam_sums(count: int) -> tuple[Array, Array]:
    """Return a_i / sqrt(m) and d_i / (sqrt(m) L) of a uniform cantilever, (count,) each."""
    roots = beam_roots(count)
    sigma = np.array([(cosh(x) + cos(x)) / (sinh(x) + sin(x)) for x in roots])
    return 2.0*sigma/roots, 2.0/roots**2


def beam_shapes(count: int, stations: ArrayLike) -> Array:
    """
    Return phi_i sqrt(m) of a uniform cantilever at stations (S,), parts of its length: (S, count).

    At the tip it is 2, -2, 2, ...; the deflection there is the sum of phi_i eta_i.
    """
    roots = beam_roots(count)
    sigma = np.array([(cosh(x) + cos(x)) / (sinh(x) + sin(x)) for x in roots])
    x = np.asarray(stations, dtype=float)[:, np.newaxis]*roots
    return np.cosh(x) - np.cos(x) - sigma*(np.sinh(x) - np.sin(x))


@dataclass(frozen=True)
class Panel:
    """
    A panel by its modes; leading axes of the numbers are batch axes.

    Attributes
    ----------
    root : array_like, shape (..., 3)
        Where it is clamped, or where its drive is [m].
    span, normal : array_like, shape (3,)
        Unit vectors, at right angles: along the panel, and along which it bends.
    first_moment, second_moment : array_like, shape (..., modes)
        a_i [kg^0.5] and d_i [kg^0.5 m].
    frequency, damping : array_like, shape (..., modes)
        Angular frequency of each mode, clamped [rad/s], and its damping ratio.
    chord_inertia : array_like, shape (...)
        Moment of inertia about the span at rest [kg m^2]; it counts where the panel is driven.
    driven : bool
        Whether it turns about its span, under a torque.
    """

    root: ArrayLike
    span: ArrayLike
    normal: ArrayLike
    first_moment: ArrayLike
    second_moment: ArrayLike
    frequency: ArrayLike
    damping: ArrayLike
    chord_inertia: ArrayLike = 0.0
    driven: bool = False

    @property
    def modes(self) -> int:
        """Number of modes."""
        return np.shape(self.frequency)[-1]


def cantilever(root: ArrayLike, span: ArrayLike, normal: ArrayLike, mass: ArrayLike,
               length: ArrayLike, frequency: ArrayLike, damping: ArrayLike, modes: int = 5,
               chord: float = 0.0, driven: bool = False) -> Panel:
    """
    Return the panel that is a uniform beam; leading axes of the numbers are batch axes.

    `mass` (...) [kg], `length` (...) [m], `frequency` (...) of its first mode [rad/s], `damping`
    (...) of every mode, `chord` its width [m]; the rest as `Panel`.
    """
    a, d = beam_sums(modes)
    roots = beam_roots(modes)
    mass, length, frequency, damping = (
        np.asarray(v, dtype=float)[..., np.newaxis] for v in (mass, length, frequency, damping))
    return Panel(root, span, normal, np.sqrt(mass)*a, np.sqrt(mass)*length*d,
                 frequency*(roots/roots[0])**2, damping + 0.0*roots,
                 mass[..., 0]*chord**2/12.0, driven)


@dataclass(frozen=True)
class Tank:
    """
    The liquid of a tank that moves; leading axes of the numbers are batch axes.

    Attributes
    ----------
    place : array_like, shape (..., 3)
        Where it is at rest [m].
    axes : array_like, shape (k, 3)
        One to three unit vectors, at right angles, along which it swings.
    mass : array_like, shape (...)
        What moves [kg].
    frequency, damping : array_like, shape (...)
        Angular frequency in a tank at rest [rad/s], and damping ratio.
    """

    place: ArrayLike
    axes: ArrayLike
    mass: ArrayLike
    frequency: ArrayLike
    damping: ArrayLike

    @property
    def swings(self) -> int:
        """Number of axes."""
        return len(np.atleast_2d(self.axes))


def participation(panel: Panel) -> tuple[Array, Array]:
    """Return P (..., 3, modes) and R (..., 3, modes), its columns in the mass matrix at rest."""
    e, s = np.asarray(panel.normal, dtype=float), np.asarray(panel.span, dtype=float)
    a, d = (np.asarray(v, dtype=float)[..., np.newaxis, :]
            for v in (panel.first_moment, panel.second_moment))
    by_root = np.cross(np.asarray(panel.root, dtype=float), e)[..., np.newaxis]
    return e[:, np.newaxis]*a, by_root*a + np.cross(s, e)[:, np.newaxis]*d


def swing_columns(tank: Tank) -> tuple[Array, Array]:
    """Return P (..., 3, k) and R (..., 3, k), its columns in the mass matrix at rest."""
    axes = np.atleast_2d(np.asarray(tank.axes, dtype=float))
    root = np.sqrt(np.asarray(tank.mass, dtype=float))[..., np.newaxis, np.newaxis]
    place = np.asarray(tank.place, dtype=float)[..., np.newaxis, :]
    return root*axes.T, root*np.swapaxes(np.cross(place, axes), -1, -2)
