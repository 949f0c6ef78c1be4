"""
What the console tells a pilot of the lunar approach: alarms, and what a good approach is.

Frame   target orbital, the port at the origin: +x along track, +y up, +z right.
"""

from collections.abc import Callable
from typing import Any

from rvd_dynamics.diagram.display import Alarm, DERIVED, Gate, Guidance, Number, Reading
from rvd_dynamics.geometry.cone import Cone
from rvd_missions.lunar_approach import signals
from rvd_missions.lunar_approach.settings import DockingParams

GATES_M = (20.0, 10.0, 5.0, 2.0)        # [m] before the port, where the approach is checked
# By how much an alarm's reading must be inside its limit again.
BACK_M, BACK_M_S, BACK_S = 0.05, 0.01, 2.0
STATES = (('measured', signals.TELEMETRY.name), ('predicted', signals.PREDICTION.name))


def alarms(docking: DockingParams, loop_s: float, obstacles: bool) -> tuple[Alarm, ...]:
    """Return the alarms, the gravest first; `loop_s` is the delay of the whole loop [s]."""
    def distance(words: str, role: str, part: str) -> Alarm:
        return Alarm(words, (Reading(role, Number(DERIVED, f'{part}_{role}'), low=0.0),),
                     part, 'm', back=BACK_M)
    keep_out = (distance('AT AN OBSTACLE', 'measured', 'clearance'),
                distance('HEADING FOR AN OBSTACLE', 'predicted', 'clearance'))
    return (
        *(keep_out if obstacles else ()),
        distance('OUTSIDE THE CORRIDOR', 'measured', 'margin'),
        distance('LEAVING THE CORRIDOR', 'predicted', 'margin'),
        Alarm('TOO FAST', both('velocity', (0,), None, docking.max_closing_rate_m_s),
              'closing rate', 'm/s', 3, BACK_M_S),
        Alarm('TOO FAST SIDEWAYS',
              both('velocity', (1, 2), None, docking.max_lateral_rate_m_s),
              'lateral rate', 'm/s', 3, BACK_M_S),
        Alarm('DRIFTING OUT WITHIN THE DELAY',
              (Reading('predicted', Number(DERIVED, 'leave_s'), low=loop_s),),
              'leaves in', 's', 0, BACK_S, 'caution'),
        Alarm('NEAR THE WALL', (Reading('predicted', Number(DERIVED, 'room'), low=0.0),),
              'inside the control boundary by', 'm', back=BACK_M, level='caution'))


def guidance(docking: DockingParams, corridor: Cone, start_m: float, rate_m_s: float,
             boundary: Callable[[float], Any]) -> Guidance:
    """
    Return the gates ahead of a start `start_m` before the port, and the limits at contact.

    `boundary` gives the radius of the control boundary [m] at a station [m].
    """
    return Guidance(
        tuple(Gate(at, (f'within {float(boundary(-at)):.2f} m of the axis',
                        f'closing at {rate_m_s:g} m/s')) for at in GATES_M if at < start_m),
        (f'inside the circle of {corridor.docking_radius_m:g} m',
         f'closing slower than {docking.max_closing_rate_m_s:g} m/s',
         f'sideways slower than {docking.max_lateral_rate_m_s:g} m/s'),
        tuple(Number(signal, 'position', (0,), -1.0) for _, signal in reversed(STATES)))


def both(part: str, index: tuple[int, ...], low: float | None = None, high: float | None = None,
         factor: float = 1.0, past: int | None = None) -> tuple[Reading, ...]:
    """Return the readings of one part as measured and as predicted."""
    return tuple(Reading(role, Number(signal, part, index, factor, past=past), low, high)
                 for role, signal in STATES)
