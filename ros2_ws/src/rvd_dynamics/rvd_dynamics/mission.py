"""
What all nodes must agree on: time grid, orbit, corridor, thrust levels, delays, stick.

These are the keys that stand under `/**` in a scenario and nowhere else. Each node gets the
same frozen `Mission`; shared mathematics takes what it needs from it.

Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, Tables 1 and 2, sections 1.2, 1.3, 3.1.
"""

from dataclasses import dataclass
from functools import cached_property
from math import isfinite, pi, radians, sqrt, tan

from rvd_dynamics.constants import MU_MOON
from rvd_dynamics.diagram.params import param, require

MODES = ('manual', 'shared', 'auto')
OPERATORS = ('model', 'replay', 'console', 'joy', 'none')
JOY_INPUTS = ('stepped', 'held')
PACES = ('lockstep', 'realtime')


@dataclass(frozen=True)
class OrbitParams:
    """Circular orbit of the target about the Moon."""

    radius_m: float = param(1938e3, 'Radius of the circular target orbit [m].')
    gravitational_parameter_m3_s2: float = param(MU_MOON, 'Of the central body [m^3/s^2].')

    def __post_init__(self) -> None:
        require(self.radius_m > 0.0, 'orbit.radius_m', 'be positive', self.radius_m)
        mu = self.gravitational_parameter_m3_s2
        require(mu > 0.0, 'orbit.gravitational_parameter_m3_s2', 'be positive', mu)

    @cached_property
    def mean_motion(self) -> float:
        """Orbital rate of the target [rad/s]."""
        return sqrt(self.gravitational_parameter_m3_s2 / self.radius_m) / self.radius_m


@dataclass(frozen=True)
class StartParams:
    """Nominal start: the state the approach is planned from."""

    position_m: tuple = param((-30.0, 0.0, 0.0), 'Nominal start position x, y, z [m].')
    velocity_m_s: tuple = param((0.25, 0.0, 0.0), 'Nominal start velocity x, y, z [m/s].')

    def __post_init__(self) -> None:
        for name in ('position_m', 'velocity_m_s'):
            value = getattr(self, name)
            require(len(value) == 3 and all(isfinite(v) for v in value),
                    f'start.{name}', 'be three finite numbers', list(value))
        require(self.position_m[0] < 0.0, 'start.position_m', 'begin with x < 0',
                self.position_m[0])


@dataclass(frozen=True)
class CorridorParams:
    """The approach cone: half angle and lateral limit at the docking plane."""

    half_angle_deg: float = param(3.0, 'Half angle of the corridor cone [deg].')
    docking_radius_m: float = param(0.3, 'Lateral limit at the docking plane x = 0 [m].')

    def __post_init__(self) -> None:
        require(0.0 < self.half_angle_deg < 90.0, 'corridor.half_angle_deg',
                'be between 0 and 90', self.half_angle_deg)
        require(self.docking_radius_m > 0.0, 'corridor.docking_radius_m', 'be positive',
                self.docking_radius_m)

    @cached_property
    def alpha(self) -> float:
        """Half angle [rad]."""
        return self.half_angle_deg * pi / 180.0

    @cached_property
    def tan_alpha(self) -> float:
        """Slope of the wall."""
        return tan(radians(self.half_angle_deg))


@dataclass(frozen=True)
class DockingParams:
    """Limits at the docking plane (section 3.1 of the paper)."""

    max_closing_rate_m_s: float = param(0.3, 'Closing rate must be below this [m/s].')
    max_lateral_rate_m_s: float = param(0.3, 'Lateral rate must be below this [m/s].')

    def __post_init__(self) -> None:
        for name in ('max_closing_rate_m_s', 'max_lateral_rate_m_s'):
            require(getattr(self, name) > 0.0, f'docking.{name}', 'be positive',
                    getattr(self, name))


@dataclass(frozen=True)
class ThrustParams:
    """Thrust acceleration of the levels 1, 2, 3 (Table 2)."""

    x_m_s2: tuple = param((0.01, 0.02, 0.03), 'Levels 1, 2, 3 along x [m/s^2].')
    lateral_m_s2: tuple = param((0.005, 0.01, 0.02), 'Levels 1, 2, 3 along y and z [m/s^2].')

    def __post_init__(self) -> None:
        for name in ('x_m_s2', 'lateral_m_s2'):
            a = getattr(self, name)
            require(len(a) == 3 and 0.0 < a[0] < a[1] < a[2] < float('inf'), f'thrust.{name}',
                    'be three positive rising numbers', list(a))


@dataclass(frozen=True)
class StickParams:
    """How a `sensor_msgs/Joy` becomes levels; the defaults are those of the `joy` ecosystem."""

    axis_x: int = param(1, 'Index of the axis that commands x.')
    axis_y: int = param(0, 'Index of the axis that commands y.')
    axis_z: int = param(4, 'Index of the axis that commands z.')
    sign_x: int = param(1, '+1 or -1: sense of the x axis.')
    sign_y: int = param(1, '+1 or -1: sense of the y axis.')
    sign_z: int = param(1, '+1 or -1: sense of the z axis.')
    dead_zone: float = param(0.05, 'Deflection that still counts as neutral, of 1.')
    deadman_button: int = param(4, 'Index of the button that must be held; -1: none.')

    def __post_init__(self) -> None:
        for name in ('axis_x', 'axis_y', 'axis_z'):
            require(0 <= getattr(self, name) < 64, f'stick.{name}', 'be 0 to 63',
                    getattr(self, name))
        require(len({self.axis_x, self.axis_y, self.axis_z}) == 3, 'stick.axis_x, axis_y, axis_z',
                'differ', [self.axis_x, self.axis_y, self.axis_z])
        for name in ('sign_x', 'sign_y', 'sign_z'):
            require(getattr(self, name) in (-1, 1), f'stick.{name}', 'be 1 or -1',
                    getattr(self, name))
        require(0.0 <= self.dead_zone < 1.0, 'stick.dead_zone', 'be 0 up to 1', self.dead_zone)
        require(-1 <= self.deadman_button < 64, 'stick.deadman_button', 'be -1 to 63',
                self.deadman_button)


@dataclass(frozen=True)
class Mission:
    """The shared settings of a scenario; the YAML keys under `/**` are these names."""

    step_s: float = param(0.5, 'Sampling period of every node [s], 0.05 to 1.')
    timeout_s: float = param(200.0, 'The run ends here if it has not docked [s].')
    seed: int = param(0, 'Seed of every random stream.')
    run: int = param(0, 'Number of the run within the seed.')
    pace: str = param('lockstep', 'lockstep: as fast as it goes; realtime: by the wall clock.')
    pace_factor: float = param(1.0, 'With pace realtime: simulated seconds per wall second.')
    mode: str = param('shared', 'Who decides: manual, shared or auto.')
    operator: str = param('model', 'The pilot: model, replay, console, joy or none.')
    joy_input: str = param('stepped', 'stepped: one Joy per step; held: the newest Joy counts.')
    forward_delay_s: float = param(5.0, 'Constant delay of the forward link [s].')
    back_delay_s: float = param(5.0, 'Constant delay of the back link [s].')
    frame_id: str = param('target_lvlh', 'Name of the target orbital frame.')
    nodes: tuple = param(('',), 'Names of all nodes of this run; empty: the ring alone.')
    orbit: OrbitParams = param(OrbitParams, 'Target orbit.')
    start: StartParams = param(StartParams, 'Nominal start.')
    corridor: CorridorParams = param(CorridorParams, 'Approach corridor.')
    docking: DockingParams = param(DockingParams, 'Limits at the docking plane.')
    thrust: ThrustParams = param(ThrustParams, 'Thrust levels.')
    stick: StickParams = param(StickParams, 'Stick.')

    def __post_init__(self) -> None:
        require(0.05 <= self.step_s <= 1.0, 'step_s', 'be between 0.05 and 1', self.step_s)
        require(abs(self.step_s * 1e9 - self.step_ns) < 1e-3, 'step_s',
                'be a whole number of nanoseconds', self.step_s)
        require(self.step_s <= self.timeout_s <= 86400.0, 'timeout_s',
                'be between one step and 86400', self.timeout_s)
        require(self.seed >= 0, 'seed', 'not be negative', self.seed)
        require(self.run >= 0, 'run', 'not be negative', self.run)
        require(0.01 <= self.pace_factor <= 1000.0, 'pace_factor', 'be between 0.01 and 1000',
                self.pace_factor)
        for name, allowed in (('pace', PACES), ('mode', MODES), ('operator', OPERATORS),
                              ('joy_input', JOY_INPUTS)):
            require(getattr(self, name) in allowed, name, f'be one of {", ".join(allowed)}',
                    getattr(self, name))
        if self.joy_input == 'held' and self.pace == 'lockstep':
            raise ValueError('joy_input held needs pace realtime: lock step has no wall clock '
                             'by which a stick could be held')
        self.forward_steps, self.back_steps     # refuse delays off the grid at once

    @cached_property
    def step_ns(self) -> int:
        """Sampling period [ns]; every instant is a whole number of these."""
        return round(self.step_s * 1e9)

    @cached_property
    def forward_steps(self) -> int:
        """Delay of the forward link [steps]."""
        return self._whole_steps('forward_delay_s')

    @cached_property
    def back_steps(self) -> int:
        """Delay of the back link [steps]."""
        return self._whole_steps('back_delay_s')

    @cached_property
    def last_step(self) -> int:
        """First step at or after the time limit: no run is longer."""
        return -(-round(self.timeout_s * 1e9) // self.step_ns)

    def _whole_steps(self, name: str) -> int:
        delay = getattr(self, name)
        require(0.0 <= delay <= 3600.0, name, 'be between 0 and 3600', delay)
        steps = round(delay / self.step_s)
        if abs(steps * self.step_s - delay) > 1e-9:
            below = int(delay / self.step_s)
            raise ValueError(
                f'{name} must be a whole number of steps of {self.step_s:g} s, got {delay:g}: '
                f'the two nearest are {below * self.step_s:g} and {(below + 1) * self.step_s:g}')
        return steps
