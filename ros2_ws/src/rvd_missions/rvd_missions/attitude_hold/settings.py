"""
Settings that belong to no single block: where the law runs, the craft, what it is to do, faults,
and what counts as held.

Plant [A]   a double integrator, step 0.5 s, a step of 0.5 deg, faults at 120 s.
"""

from functools import cached_property

import numpy as np

from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import LegParams as Delays
from rvd_dynamics.diagram.run import Legs, Run

PLACES = ('onboard', 'ground')
LATEST_S = 86400.0                      # as long as a run may take


@settings
class Placement:
    """Where the law runs."""

    law_runs: str = param(
        'ground', 'Where the law runs: on the ground, behind the delays of both legs, or onboard, '
        'without a link.', choices=PLACES)


@settings
class LegParams(Delays):
    """Delays of the two legs of the link; of a law on board they do not count."""

    forward_delay_s: float = param(
        0.0, 'Constant delay of the forward link [s].', low=0.0, high=3600.0)
    back_delay_s: float = param(
        0.0, 'Constant delay of the back link [s].', low=0.0, high=3600.0)


@settings
class Craft:
    """The axis."""

    inertia_kg_m2: float = param(
        100.0, 'Moment of inertia about the axis [kg m^2], which the law knows.', low=1e-6,
        high=1e8)


@settings
class Attitude:
    """What the axis is to do: hold a reference, then come to zero."""

    reference_deg: float = param(
        0.5, 'Reference before the step [deg]; after it the reference is zero.', low=-90.0,
        high=90.0)
    step_at_s: float = param(
        120.0, 'Instant at which the reference steps to zero [s].', low=0.0, high=LATEST_S)

    @cached_property
    def reference_rad(self) -> float:
        """Reference before the step [rad]."""
        return float(np.radians(self.reference_deg))

    def at(self, k: int, step_s: float) -> float:
        """Return the reference [rad] in step k."""
        return self.reference_rad if k < first_step(self.step_at_s, step_s) else 0.0


@settings
class Faults:
    """Soft faults: from an instant on, a gain is another one. Sensors share one gain."""

    actuator_gain: float = param(
        1.0, 'Gain of the actuator after its fault, as a fraction of the nominal one.', above=0.0,
        high=100.0)
    actuator_at_s: float = param(
        120.0, 'Instant of the fault of the actuator [s].', low=0.0, high=LATEST_S)
    sensor_gain: float = param(
        1.0, 'Gain of all sensors after their fault, as a fraction of the nominal one.', above=0.0,
        high=100.0)
    sensor_at_s: float = param(
        120.0, 'Instant of the fault of the sensors [s].', low=0.0, high=LATEST_S)

    def actuator(self, k: int, step_s: float) -> float:
        """Return the gain of the actuator in step k, of what acts on [k, k+1)."""
        return 1.0 if k < first_step(self.actuator_at_s, step_s) else self.actuator_gain

    def sensor(self, k: int, step_s: float) -> float:
        """Return the gain of the sensors in step k."""
        return 1.0 if k < first_step(self.sensor_at_s, step_s) else self.sensor_gain

    @property
    def first_at_s(self) -> float:
        """Instant of the first fault [s], whatever its gain."""
        return min(self.actuator_at_s, self.sensor_at_s)


@settings
class Limits:
    """What counts as held."""

    max_rms_deg: float = param(
        0.02, 'Root mean square of the error at the end of a run below which the axis is held '
        '[deg].', above=0.0, high=90.0)
    window_s: float = param(
        60.0, 'Length of the end of a run over which that is taken [s].', above=0.0,
        high=LATEST_S)
    settled_deg: float = param(
        0.05, 'Error within which the axis has settled [deg].', above=0.0, high=90.0)
    lost_deg: float = param(
        20.0, 'Error at which the axis is lost and the run ends [deg].', above=0.0, high=180.0)


def first_step(at_s: float, step_s: float) -> int:
    """Return the first step at or after an instant."""
    return int(np.ceil(at_s/step_s - 1e-9))


def legs(placement: Placement, leg_params: LegParams, run: Run) -> Legs:
    """Return the delays of the link in steps, none for a law on board; ValueError off the grid."""
    given = leg_params.on(run)
    return given if placement.law_runs == 'ground' else Legs(0, 0, run.step_s)


def timed(limits: Limits, attitude: Attitude, run: Run) -> Limits:
    """
    Return the limits, or refuse ones that the run or the reference cannot meet.

    Raises
    ------
    ValueError
        Names the key and the value.
    """
    require(limits.window_s <= run.timeout_s, 'limits.window_s',
            f'be at most timeout_s, {run.timeout_s:g}', limits.window_s)
    require(limits.lost_deg > abs(attitude.reference_deg), 'limits.lost_deg',
            f'be above the reference, {abs(attitude.reference_deg):g}', limits.lost_deg)
    return limits
