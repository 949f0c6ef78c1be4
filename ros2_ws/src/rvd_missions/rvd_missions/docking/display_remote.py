"""
What the console shows of a craft that is steered from the ground: what comes down, and ahead of it.

Valves, images and the confidence of the filters stay on board, so that lamps, markers and sigma are
not shown. The frame is that of `display`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from rvd_dynamics.commands.codes import BY_NOBODY, BY_PILOT
from rvd_dynamics.diagram.display import (
    Body, Box, Chart, Charts, CommandAxis, CommandRow, Commands, DERIVED, Display, Gauge,
    Instrument, Instruments, Legend, Needles, Number, Reading, Ref, Spot, Trail, TRUTH)
from rvd_dynamics.diagram.scenario import Scenario
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.provider import has_ground, PILOT, RunFacts
from rvd_missions.docking import markers, safety
from rvd_missions.docking.display import DockingDisplay
from rvd_missions.docking.display_parts import AXES, digits, seen

TELEMETRY, PREDICTION, COMMAND = '/ground/telemetry', '/ground/prediction', '/ground/command'
PERCENT = 100.0
HELD = 1 | 2                            # of the last number of a command: either is held
# What comes down, in order: the estimate, place and attitude that are held, the safety state.
DOWN = (('position', 3), ('velocity', 3), ('attitude', 4), ('rate', 3), ('reference', 3),
        ('held', 4), ('safety', 1))
AHEAD = ('chaser', 'turn', 'port', 'port_rate', 'distance', 'across', 'closing', 'angles', 'rates')


def display(facts: RunFacts, scenario: Scenario) -> DockingDisplay:
    """Return the display of a run: of a craft that is steered from the ground, or of any other."""
    kind = RemoteDisplay if has_ground(scenario.diagram) else DockingDisplay
    return kind(facts, scenario)


class RemoteDisplay(DockingDisplay):
    """The approach by hand through the link."""

    heard_nodes = ('hand_uplink', 'console')

    def __init__(self, facts: RunFacts, scenario: Scenario) -> None:
        super().__init__(facts, scenario)
        self.derives_from = (PREDICTION,)

    def measured(self, state: list[float]) -> dict[str, Any]:
        """Return the parts of what comes down."""
        made, at = {}, 0
        for name, size in DOWN:
            made[name] = state[at:at + size]
            at += size
        return made

    def sent(self, sample: Sample) -> None:
        """Keep no books: what goes up are deflections, of somebody if a flag of HELD says so."""
        value = sample.parts['value']
        sample.parts['by'] = BY_PILOT if len(value) > len(AXES) and value[-1] & HELD else BY_NOBODY

    def pilot(self, axes: Sequence[float], buttons: Sequence[int]) -> tuple[list[float], bool]:
        """Return the six deflections in percent, and whether anybody holds the controllers."""
        value, valid = super().pilot(axes, buttons)
        return [PERCENT*v for v in value], valid

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """Return what is drawn of the craft as it was, and as it will be."""
        made: dict[str, Any] = {}
        down = newest.get(TELEMETRY)
        if down is not None and down.ok:
            made |= self._estimated(down)
            for name in ('r', 'v', 'q'):        # of an earlier instant than the truth beside it
                made.pop(name, None)
            state = int(down.parts['safety'][0])
            made['safety'] = [safety.NAMES[state], state != safety.NOMINAL]
            made['unsafe'] = float(state != safety.NOMINAL)
            held = np.array(down.parts['reference'])
            if np.isfinite(held).all():
                made['wanted'] = seen(held + markers.CHASER_PORT).tolist()
        ahead = newest.get(PREDICTION)
        if ahead is not None and ahead.ok:
            found = self._estimated(ahead)
            made |= {f'{name}_ahead': found.get(name) for name in AHEAD}
        return made

    def _display(self, facts: RunFacts, scenario: Scenario) -> Display:
        shown = super()._display(facts, scenario)
        hand = facts.operator == 'console'

        def both(label: str, unit: str, part: str, factor: float = 1.0, digits: int = 1,
                 truth: bool = False, **limits: Any) -> Instrument:
            readings = [Reading(role, Number(DERIVED, name, (0,), factor), **limits)
                        for role, name in (('measured', part), ('predicted', f'{part}_ahead'))]
            if truth:
                readings.append(Reading('truth', Number(TRUTH, part, (0,), factor)))
            return Instrument(label, unit, tuple(readings[::-1]), digits)

        def needles(role: str, end: str) -> Needles:
            return Needles(role, *(tuple(Number(DERIVED, part + end, (i,)) for i in range(3))
                                   for part in ('angles', 'rates')))
        closing = tuple(Reading(role, Number(DERIVED, name, (0,), 1000.0)) for role, name in (
            ('measured', 'closing'), ('predicted', 'closing_ahead')))
        return replace(
            shown, measured=TELEMETRY, predicted=PREDICTION, link=True, lamps=None,
            bodies=(*shown.bodies, Body(
                'ghost', 'predicted', (Box((3.0, 0.7, 0.7)), Box((1.5, 0.04, 9.8))),
                Ref(DERIVED, 'chaser_ahead'), attitude=Ref(DERIVED, 'turn_ahead'),
                label='predicted')),
            lines=(*shown.lines, Trail('ahead', 'predicted', Ref(DERIVED, 'chaser_ahead'))),
            legend=(*shown.legend, Legend('predicted', 'predicted')),
            camera=replace(shown.camera, title='view from the telemetry',
                           review_title='view from the telemetry', pixels=None,
                           gauge=Gauge('mm/s', -20.0, 80.0, 10.0, 2, closing, digits=0),
                           numbers=digits(('measured', ''), ('predicted', '_ahead'))),
            instruments=Instruments('Approach', (
                both('distance', 'mm', 'distance', 1000.0, 0, True),
                both('closing', 'mm/s', 'closing', 1000.0, 0,
                     high=Number(DERIVED, 'fastest', (0,), 1000.0)),
                both('across', 'mm', 'across', 1000.0, 0, True,
                     high=Number(DERIVED, 'wall', (0,), 1000.0)))),
            section=replace(shown.section, spots=(
                *shown.section.spots, Spot('predicted', Ref(DERIVED, 'port_ahead'), 'ring'))),
            attitude=replace(shown.attitude, needles=(
                needles('predicted', '_ahead'), needles('measured', ''),
                *shown.attitude.needles[1:])),
            commands=Commands(
                'Hands, percent', tuple(CommandAxis(name, PERCENT) for name in AXES), COMMAND,
                (*((CommandRow('hands', 'pilot', Ref(PILOT, 'value')),) if hand else ()),
                 CommandRow('sent', 'sent', Ref(COMMAND, 'value')))),
            controller=shown.controller if hand else None,
            charts=Charts('Course', (
                Chart('distance, m', (
                    Number(DERIVED, 'distance'), Number(DERIVED, 'distance_ahead'),
                    Number(TRUTH, 'distance')), least=0.1,
                      names=('down', 'predicted', 'true'), centred=False,
                      levels=shown.charts.strips[0].levels),
                Chart('angles, deg', tuple(Number(DERIVED, 'angles_ahead', (i,)) for i in range(3)),
                      least=0.5, names=AXES[3:])), window_s=60.0))
