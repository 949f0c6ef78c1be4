"""
What console and markers show: the chaser, the target, the obstacles and their alarms.

Frame   target orbital: +x along track, +y radially outward, +z completes the triad; the target is
        at the origin.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.diagram.display import (
    Alarm, Body, Box, CommandAxis, CommandRow, Commands, DERIVED, Display, Field, Flat, Instrument,
    Instruments, Legend, Line, Number, Perspective, Reading, Ref, Sphere, Spheres, Trail, TRUTH)
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.geometry.speed_corridor import SpeedCorridor
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import MissionDisplay, RunFacts
from rvd_missions.obstacle_field.settings import Craft, Obstacles, Start
from rvd_missions.obstacle_field.signals import ALARM, ESTIMATE, OBSTACLES, PREDICTION

TELEMETRY, COMMAND = '/ground/telemetry', '/ground/command'
ESTIMATED, PREDICTED = ESTIMATE.name, PREDICTION.name
HULL, STATION = '#d5dbe2', '#c3cad2'
LARGE = 1e9                             # more than any thruster gives
DIGITS = 4
BACK_M, BACK_MM_S = 0.05, 2.0           # by which an alarm's reading must be inside its limit again


def scene(scenario: Scenario) -> Field:
    """Return what the markers draw."""
    craft, obstacles = scenario.part('craft'), scenario.part('obstacles')
    moving = (Spheres('obstacles', 'limit', Ref(OBSTACLES, 'obstacles'), tuple(obstacles.radii)),)
    return Field((Sphere('target', 'target', craft.target_radius_m),
                  Sphere('arrival', 'goal', craft.target_radius_m + craft.arrival_gap_m)),
                 moving if obstacles.count else (), craft.chaser_radius_m)


class FieldDisplay(MissionDisplay):
    """The approach among obstacles on the console."""

    heard_nodes = ('state_predictor', 'auto_controller', 'console')
    derives_from = (OBSTACLES, ALARM)

    def __init__(self, facts: RunFacts, craft: Craft, obstacles: Obstacles, start: Start,
                 speed_corridor: SpeedCorridor, form: CommandForm) -> None:
        self._craft, self._radii, self._start = craft, obstacles.radii, start
        self._corridor, self._form = speed_corridor, form
        super().__init__(facts, self._display())

    # -- what is derived --------------------------------------------------------------------

    def measured(self, state: list[float]) -> dict[str, Any]:
        """Return position and velocity of the chaser, and the places of the obstacles."""
        return {'position': state[:3], 'velocity': state[3:6], **_places(state[6:])}

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """Return where obstacles are foreseen, clearances, the speed limit and the alarms."""
        made: dict[str, Any] = {f'obstacle_{i + 1}': None for i in range(len(self._radii))}
        seen = newest.get(OBSTACLES)
        around = None
        if seen is not None and seen.ok:
            around = seen.parts['obstacles']
            made.update(_places(around))
        for name, signal in (('measured', TELEMETRY), ('predicted', PREDICTED)):
            made[f'limit_{name}'] = made[f'clearance_{name}'] = None
            sample = newest.get(signal)
            if sample is None or not sample.ok:
                continue
            position = np.array(sample.parts['position'])
            gap = float(np.sqrt(position @ position)) - self._craft.contact_m
            made[f'limit_{name}'] = float(self._corridor.limit(gap))
            known = (_places(around) if name == 'predicted' and around is not None
                     else {k: v for k, v in sample.parts.items() if k.startswith('obstacle_')})
            if known:
                made[f'clearance_{name}'] = min(
                    float(np.linalg.norm(position - place)) - self._craft.chaser_radius_m - radius
                    for place, radius in zip(known.values(), self._radii))
        alarm = newest.get(ALARM)
        made['alarms'] = None if alarm is None else float(sum(alarm.parts.get('on', ())))
        return made

    # -- what is drawn ----------------------------------------------------------------------

    def _display(self) -> Display:
        craft, unit = self._craft, 'm/s^2' if self._form.neutral.dtype.kind == 'f' else ''
        spheres = tuple(
            Sphere(f'obstacle_{i + 1}', 'limit', float(radius), Ref(DERIVED, f'obstacle_{i + 1}'))
            for i, radius in enumerate(self._radii))
        most = np.abs(self._form.quantise(np.full(3, LARGE))).astype(float)
        start, far = self._start.position_m, float(np.linalg.norm(self._start.position_m))
        return Display(
            measured=TELEMETRY, predicted=PREDICTED,
            bodies=(
                Body('chaser', 'measured', _box(craft.chaser_radius_m, HULL),
                     Ref(TELEMETRY, 'position'), label='chaser'),
                Body('ghost', 'predicted', _box(craft.chaser_radius_m, HULL),
                     Ref(PREDICTED, 'position')),
                Body('truth', 'truth', _box(craft.chaser_radius_m, HULL), Ref(TRUTH, 'position')),
                Body('target', 'target', _box(craft.target_radius_m, STATION), label='target')),
            surfaces=(Sphere('arrival', 'goal', craft.target_radius_m + craft.arrival_gap_m),
                      *spheres),
            lines=(Trail('flown', 'measured', Ref(ESTIMATED, 'position')),
                   Trail('true_path', 'truth', Ref(TRUTH, 'position')),
                   Line('direct', 'plain', (tuple(start), (0.0, 0.0, 0.0)), dashed=True)),
            legend=(Legend('measured', 'measured'), Legend('predicted', 'predicted'),
                    Legend('limit', 'obstacles'), Legend('goal', 'arrival')),
            views=(
                Perspective('Orbit', centre_m=tuple(0.5*v for v in start), distance_m=1.3*far),
                Flat('Side', '+x', '+y', tuple(0.5*v for v in start), 1.25*far),
                Flat('Top', '+x', '-z', tuple(0.5*v for v in start), 1.25*far)),
            instruments=Instruments('Approach', (
                Instrument('range', 'm', _both('position', (0, 1, 2))),
                Instrument('speed', 'mm/s', self._speeds(), 1),
                Instrument('clearance', 'm', tuple(
                    Reading(role, Number(DERIVED, f'clearance_{role}'), low=0.0)
                    for role in ('measured', 'predicted'))),
                Instrument('alarms', '', (Reading('plain', Number(DERIVED, 'alarms')),), 0))),
            commands=Commands(
                'Thrust', tuple(CommandAxis(a, m) for a, m in zip('xyz', most)), COMMAND,
                (CommandRow('sent', 'sent', Ref(COMMAND, 'value')),),
                digits=DIGITS if unit else 0, unit=unit),
            alarms=(
                *(Alarm(words, (Reading(role, Number(DERIVED, f'clearance_{role}'), low=0.0),),
                        'clearance', 'm', back=BACK_M)
                  for words, role in (('AT AN OBSTACLE', 'measured'),
                                      ('HEADING FOR AN OBSTACLE', 'predicted'))),
                *((Alarm('TOO FAST', self._speeds(), 'speed', 'mm/s', 1, BACK_MM_S),)
                  if self._corridor.kept else ())),
            modes=(), abort='thrusting away from the target',
            goal='arriving without touching an obstacle')

    def _speeds(self) -> tuple[Reading, ...]:
        """Return the speed, measured and predicted, with its limit where one is kept."""
        return tuple(Reading(role, Number(signal, 'velocity', (0, 1, 2), 1000.0),
                             high=Number(DERIVED, f'limit_{role}', (0,), 1000.0)
                             if self._corridor.kept else None)
                     for role, signal in (('measured', TELEMETRY), ('predicted', PREDICTED)))


def _places(flat: list[float]) -> dict[str, list[float]]:
    """Return the positions in rows of six numbers, by the names of the obstacles."""
    return {f'obstacle_{i + 1}': list(flat[6*i:6*i + 3]) for i in range(len(flat) // 6)}


def _both(part: str, index: tuple[int, ...]) -> tuple[Reading, ...]:
    return tuple(Reading(role, Number(signal, part, index))
                 for role, signal in (('measured', TELEMETRY), ('predicted', PREDICTED)))


def _box(radius_m: float, colour: str) -> tuple[Box, ...]:
    """Return a craft as a box with two wings that fits into its sphere."""
    edge = 0.9 * radius_m
    wing = (0.04*radius_m, 0.45*radius_m, 0.5*radius_m)
    return (Box((edge, edge, edge), colour=colour),
            *(Box(wing, (0.0, 0.0, side * 0.72*radius_m), '#27508a') for side in (-1.0, 1.0)))
