"""
Parts of the console's display: both crafts as solids, lamps, hand controllers, forms.

Shapes are in the axes of the scene (`display`): x towards the target, y up, z to the right.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.display import (
    Axis, Box, Button, Controller, Cylinder, DERIVED, Digits, Form, Hand, LampGroup, Lamps, Motion,
    Number, Reading, Ref, Torus)
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.motion import attitude
from rvd_groundstation.console.forms import setting
from rvd_missions.docking import markers
from rvd_missions.docking.settings import Panels, Tanks
from rvd_missions.docking.signals import THRUST

CHORD_M = 0.75                          # half the width of a panel in the picture
TANK_M, LIQUID_M = 0.78, 0.5            # radii of the belt that marks a tank, and of its liquid
UP = np.array([np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)])       # from LVLH to the scene's axes
NEAR_X = float(markers.TARGET_PORT[0])
HULL, FOIL, DARK, CELLS, STATION = '#d5dbe2', '#b79a4b', '#39434f', '#27508a', '#c3cad2'
AXES = ('x', 'y', 'z', 'roll', 'pitch', 'yaw')


def seen(vector: ArrayLike) -> NDArray[np.float64]:
    """Return vectors (..., 3) of LVLH in the axes of the scene."""
    x, y, z = np.moveaxis(np.asarray(vector, dtype=float), -1, 0)
    return np.stack([x, -z, y], axis=-1)


def seen_turn(q: ArrayLike) -> NDArray[np.float64]:
    """Return an attitude relative to LVLH as one in the scene, of a body whose shape is `seen`."""
    return attitude.multiply(attitude.multiply(UP, np.asarray(q, dtype=float)),
                             attitude.conjugate(UP))


def lamps() -> Lamps:
    """Return the lamps of the thrusters, in the order of `thruster_layout`."""
    def signed(names: Sequence[str], each: int = 2) -> tuple[str, ...]:
        return tuple(f'{sign}{name}' for name in names for sign in '+\u2212' for _ in range(each))
    return Lamps(
        'Thrusters', 'Which of the 37 thrusters fire, by group', (
            LampGroup('J1', 'transfer 490 N', ('+x',)),
            LampGroup('J2', 'translation 20 N', signed('xyz')),
            LampGroup('J3', 'attitude 10 N', signed(('roll', 'pitch', 'yaw'))),
            LampGroup('J4', 'emergency 60, 10 N', (*('brake \u2212x',)*4, *(
                f'couple {i}' for i in range(1, 5) for _ in range(2))))),
        Ref(THRUST.name, 'value'), Ref(DERIVED, 'glow'), Ref(DERIVED, 'pulses'),
        Ref(DERIVED, 'books'))


def digits(*of: tuple[str, str]) -> Digits:
    """Return the large digits of the port, of (role, ending of the derived names) pairs."""
    def read(name: str, i: int) -> tuple[Reading, ...]:
        return tuple(Reading(role, Number(DERIVED, name + end, (i,), 1000.0)) for role, end in of)
    return Digits((
        Motion('to go', read('distance', 0), read('closing', 0), 'closing', signed=False),
        Motion('up', read('port', 1), read('port_rate', 1)),
        Motion('right', read('port', 2), read('port_rate', 2))), 'mm', 'mm/s', 0, 1)


def hands() -> Controller:
    """
    Return both hand controllers: translation left, rotation right, in body axes.

    Each has a Joy of its own: three axes, and the buttons dead-man, pulse or rate, resume.
    """
    return Controller(
        (Axis('x', 'forward', 'back', (('KeyW', 'KeyS'),), pad_pair=(7, 6), along='+x'),
         Axis('y', 'right', 'left', (('KeyD', 'KeyA'),), 0, along='+z'),
         Axis('z', 'down', 'up', (('KeyF', 'KeyR'),), 1, along='-y'),
         Axis('roll', 'right', 'left', (('KeyE', 'KeyQ'),), pad_pair=(15, 14)),
         Axis('pitch', 'nose up', 'nose down', (('ArrowUp', 'ArrowDown'),), 3, True),
         Axis('yaw', 'nose right', 'nose left', (('ArrowRight', 'ArrowLeft'),), 2)),
        (0.25, 0.5, 1.0), verb='go',
        buttons=(Button('way', 'translation by pulses or by rates, while held', 'KeyC', 5),
                 Button('turning', 'rotation by pulses or by rates, while held', 'KeyB', 0),
                 Button('resume', 'take over again after HOLD or RETREAT', 'Backspace', 9)),
        hands=(Hand('/joy/translation', AXES[:3], ('way', 'resume')),
               Hand('/joy/rotation', AXES[3:], ('turning',))))


def forms(scenario: Scenario) -> tuple[Form, ...]:
    """Return what may be changed before a run: the tabs of the paper's window."""
    def shared(*rows: tuple) -> tuple:
        return tuple(setting(scenario, '/**', *row) for row in rows)

    def controller(*rows: tuple) -> tuple:
        return tuple(setting(scenario, 'docking_controller', *row) for row in rows)

    def loop(of: str, unit: str) -> tuple:
        return controller(
            (f'{of}.gain', 'gain K', unit), (f'{of}.derivative_s', 'derivative time', 's'),
            (f'{of}.integral_per_s', 'integral gain', '1/s'),
            (f'{of}.modulator.on_threshold', 'fires at H_E'),
            (f'{of}.modulator.off_threshold', 'stops at H_A'),
            (f'{of}.modulator.time_constant_s', 'time constant T_F', 's'))
    return (
        Form('Initial values', shared(
            ('start.position_m', 'place x, y, z', 'm'),
            ('start.attitude_deg', 'roll, pitch, yaw', 'deg'),
            ('aim.distance_m', 'distance to hover at', 'm'),
            ('aim.nominal_s', 'nominal time', 's'), ('timeout_s', 'length of the run', 's'))),
        Form('Planning', (*shared(('planner', 'planner')), *controller(
            ('profile.fast_m_s', 'fast', 'm/s'), ('profile.dock_m_s', 'docking', 'm/s'),
            ('profile.acceleration_m_s2', 'acceleration', 'm/s\u00b2'),
            ('profile.lateral_s', 'offset away in', 's'), ('safety.active', 'safety strategy'),
            ('allocation', 'allocation'), ('attitude_law', 'law of the attitude')))),
        Form('Position loops', loop('position', '1/m')),
        Form('Attitude loops', loop('attitude', '1/rad')),
        Form('Camera', (*shared(
            ('seeing.camera', 'camera'), ('seeing.period_s', 'period', 's'),
            ('seeing.latency_s', 'latency', 's')),
            setting(scenario, 'camera', 'image.corner_sigma_px', 'noise of a marker', 'px'),
            setting(scenario, 'camera', 'image.drop_out', 'views lost'))))


def chaser(panels: Panels, tanks: Tanks) -> tuple:
    """Return the chaser in the scene's axes, from its centre: port towards +x, panels along z."""
    made = [
        Cylinder(0.35, 2.1, centre_m=(-0.35, 0.0, 0.0), colour=HULL),
        Cylinder(0.3, 0.5, 0.4, (0.95, 0.0, 0.0), colour=HULL),
        Cylinder(0.24, 0.3, 0.3, (1.35, 0.0, 0.0), colour=DARK),
        Cylinder(0.15, 0.3, 0.34, (-1.55, 0.0, 0.0), colour=DARK),
        *(Torus(TANK_M, 0.03, (x, 0.0, 0.0), colour=FOIL) for x in tanks.place_m)]
    for side in (1.0, -1.0):
        middle = side*(panels.root_m + 0.5*panels.length_m)
        made += [Box((2*CHORD_M, 0.04, panels.length_m), (0.0, 0.0, middle), CELLS),
                 Box((0.08, 0.06, panels.root_m), (0.0, 0.0, 0.5*side*panels.root_m), DARK)]
    return tuple(made)


def target() -> tuple:
    """Return the target: its port looks along -x, with the markers about it."""
    made = [Cylinder(0.9, 2.2, centre_m=(0.4, 0.0, 0.0), colour=STATION),
            Cylinder(0.62, 0.6, 0.5, (-0.99, 0.0, 0.0), colour='#8d99a6'),
            Cylinder(0.36, 0.2, 0.45, (NEAR_X + 0.11, 0.0, 0.0), colour='#59646f'),
            Torus(0.3, 0.02, (NEAR_X, 0.0, 0.0), colour='#c3cad2'),
            *(Box((1.2, 0.05, 5.0), (0.9, 0.0, z), CELLS) for z in (3.5, -3.5))]
    for points, size, colour in ((markers.BIG, 0.03, '#ffffff'), (markers.SMALL, 0.009, '#ffe08a')):
        for point in seen(markers.TARGET_PORT + points):
            reach = float(NEAR_X - point[0])
            if reach > 0.0:             # it stands out
                made.append(Box((reach, 0.4*size, 0.4*size), (NEAR_X - 0.5*reach, 0.0, 0.0), DARK))
            made.append(Cylinder(size, 0.01, centre_m=tuple(point.tolist()), colour=colour,
                                 lit=False))
    return tuple(made)
