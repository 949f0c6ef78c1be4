"""
What a mission shows on the console, as data; the page draws it and knows no mission.

A display says where numbers come from (`Ref`, `Number`: a part of a signal) and how they look:
bodies made of simple solids, surfaces, lines, views, a camera, instruments, a cross-section, an
attitude indicator, lamps, commands, the axes of the hand controller, charts, alarms, what a good
approach is, and the settings that may be changed before a run. Whatever has to be computed from
signals (a distance to a wall, a path of free drift, words) is computed by the mission in Python
and reaches the page as a part of the signal `DERIVED`. `as_data` turns a display into plain JSON
values.
All of the vocabulary is imported from here.

Frame   points and directions are in the frame of the mission's positions, [m].
Errors  a value that cannot be drawn raises ValueError with the name of its field and the value.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from math import isfinite
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.display.alarms import Alarm
from rvd_dynamics.diagram.display.cockpit import (  # noqa: F401 - the vocabulary
    Attitude, Form, LampGroup, Lamps, Needles, Pixels, Setting)
from rvd_dynamics.diagram.display.panels import (  # noqa: F401 - the vocabulary
    Axis, Button, Camera, CameraMark, Chart, Charts, CommandAxis, CommandRow, Commands, Controller,
    Gauge, Hand, Instrument, Instruments, Mode, PILOTED, Readout, Ring, Section, Spot)
from rvd_dynamics.diagram.display.parts import (  # noqa: F401 - the vocabulary
    DERIVED, is_real, MODES, MOST_AXES, MOST_BUTTONS, Number, Ref, require_known, SENT_PARTS,
    TRUTH)
from rvd_dynamics.diagram.display.pilot import (  # noqa: F401 - the vocabulary
    Digits, Gate, Guidance, Motion)
from rvd_dynamics.diagram.display.readings import Reading   # noqa: F401 - the vocabulary
from rvd_dynamics.diagram.display.scene import (  # noqa: F401 - the vocabulary
    Ball, Body, Box, cone, Cylinder, Field, Flat, Label, Legend, Line, Perspective, Revolved, Solid,
    Sphere, Spheres, Surface, Torus, Trail, View)
from rvd_dynamics.diagram.params import require


@dataclass(frozen=True)
class Display:
    """
    All that the console shows of a mission.

    `measured` is the signal whose instants the first two clocks show, `predicted` that of the
    third; without a prediction there is no third. Panels that are None are not there.
    """

    commands: Commands
    measured: str
    predicted: str = ''
    bodies: tuple[Body, ...] = ()
    surfaces: tuple[Surface, ...] = ()
    lines: tuple[Line | Trail, ...] = ()
    labels: tuple[Label, ...] = ()
    views: tuple[View, ...] = (Perspective('Orbit'),)
    stars: bool = True
    sky: tuple[Ball, ...] = ()
    camera: Camera | None = None
    instruments: Instruments | None = None
    section: Section | None = None
    attitude: Attitude | None = None
    lamps: Lamps | None = None
    controller: Controller | None = None
    charts: Charts | None = None
    legend: tuple[Legend, ...] = ()
    link: bool = True           # commands go over a link: with their ladder and the round trip
    forms: tuple[Form, ...] = ()            # what may be changed before a run
    modes: tuple[Mode | str, ...] = MODES   # buttons; a name of MODES stands for that of a pilot
    on_board: Ref | None = None             # name of the mode that telemetry says is obeyed there
    abort: str = ''             # what the craft does under ABORT: "braking and backing away"
    goal: str = 'success'       # what a good flight is: "docking within the limits"
    hint: str = ''              # what a pilot is told before a flight
    alarms: tuple[Alarm, ...] = ()          # in the order of their weight
    guidance: Guidance | None = None        # what a good approach is

    def __post_init__(self) -> None:
        require(bool(self.measured), 'display.measured', 'name a signal', repr(self.measured))
        require(len(self.views) > 0, 'display.views', 'be one or more', self.views)
        piloted = {mode.name: mode for mode in PILOTED}
        object.__setattr__(self, 'modes', tuple(
            piloted.get(mode, mode) if isinstance(mode, str) else mode for mode in self.modes))
        self._check_modes()
        names = [item.name for item in (*self.bodies, *self.surfaces, *self.lines)]
        twice = sorted({name for name in names if names.count(name) > 1})
        require(not twice, 'display: bodies, surfaces and lines', 'have names of their own',
                ', '.join(twice))
        bodies = {body.name for body in self.bodies}
        for view in self.views:
            if isinstance(view, Perspective):
                require_known(f'view {view.label}: follow', view.follow, bodies)
        if self.camera is not None:
            require_known('camera.carried_by', self.camera.carried_by, bodies)
        labels = [view.label for view in self.views]
        require(len(set(labels)) == len(labels), 'display.views', 'have labels of their own',
                labels)
        said = [alarm.words for alarm in self.alarms]
        require(len(set(said)) == len(said), 'display.alarms', 'have words of their own', said)
        for part in walk(self):
            shown = [getattr(part, name, None) for name in ('value', 'place', 'points')]
            shown += list(getattr(part, 'angles', ())) + list(getattr(part, 'rates', None) or ())
            if any(isinstance(one, Ref | Number) and one.signal == TRUTH for one in shown):
                require(part.role == 'truth', f'{type(part).__name__.lower()}: role',
                        'be truth where the truth is shown', repr(part.role))

    def _check_modes(self) -> None:
        require(all(isinstance(mode, Mode) for mode in self.modes), 'display.modes',
                f'be of class Mode, or some of {", ".join(MODES)}', self.modes)
        names = [mode.name for mode in self.modes]
        require(len(set(names)) == len(names), 'display.modes', 'have names of their own', names)
        codes = [mode.key for mode in self.modes if mode.key]
        codes += self.controller.keys if self.controller is not None else []
        twice = sorted({code for code in codes if codes.count(code) > 1})
        require(not twice, 'display.modes', 'share no key', ', '.join(twice))
        require(self.on_board is None or self.on_board.signal != TRUTH, 'display.on_board',
                'come down the link', self.on_board)

    def parts(self) -> dict[str, frozenset[str]]:
        """Return the signals that are shown, each with the names of its parts that are."""
        wanted: dict[str, set[str]] = {self.measured: set(),
                                       self.commands.sent: set(SENT_PARTS)}
        if self.predicted:
            wanted[self.predicted] = set()
        for part in walk(self):
            if isinstance(part, Ref | Number):
                wanted.setdefault(part.signal, set()).add(part.part)
        return {signal: frozenset(names) for signal, names in wanted.items()}

    def trails(self) -> tuple[Trail, ...]:
        """Return the lines that the page remembers."""
        return tuple(line for line in self.lines if isinstance(line, Trail))


def walk(value: Any) -> Iterator[Any]:
    """Yield a part of a display and all parts in it."""
    if is_dataclass(value):
        yield value
        for f in fields(value):
            yield from walk(getattr(value, f.name))
    elif isinstance(value, tuple):
        for inner in value:
            yield from walk(inner)


def as_data(value: Any, where: str = 'display') -> Any:
    """
    Return a display, or a part of one, as values that JSON knows.

    A part becomes an object with its fields and its kind, the name of its class in lower case.

    Raises
    ------
    ValueError
        If a value is none that JSON knows; the text names the field.
    """
    if is_dataclass(value):
        return {'kind': type(value).__name__.lower(),
                **{f.name: as_data(getattr(value, f.name), f'{where}.{f.name}')
                   for f in fields(value)}}
    if isinstance(value, (tuple, list)):
        return [as_data(inner, f'{where}[{i}]') for i, inner in enumerate(value)]
    if isinstance(value, Mapping):
        return {str(key): as_data(inner, f'{where}.{key}') for key, inner in value.items()}
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, int):
        return value
    if is_real(value):
        require(isfinite(value), where, 'be finite', value)
        return float(value)
    raise BadInput(f'{where} must be a number, words or a part of a display, got {value!r}')
