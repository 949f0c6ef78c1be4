"""
The display of a mission that brings none: numbers and commands, read from its diagram.
"""

from typing import Any

import numpy as np

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.block import GROUND
from rvd_dynamics.diagram.display import (
    CommandAxis, CommandRow, Commands, Display, Instrument, Instruments, Mode, MODES,
    Number, Perspective, Reading, Ref)
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link.signals import FRAME
from rvd_groundstation.console.decode import COMMANDS

LARGE = 1e9                     # more than any craft is asked for, in whatever unit


def plain_display(scenario: Scenario) -> Display:
    """
    Return instruments for the state that comes down the link, and bars for the command.

    Raises
    ------
    ValueError
        If the diagram has no such signals; one line.
    """
    ground = [block for block in scenario.diagram.blocks if block.segment == GROUND]
    measured = _only(scenario, 'telemetry', [
        read.signal for block in ground for read in block.reads.values()
        if read.signal.message == FRAME])
    sent = _only(scenario, 'command', [
        signal for block in ground if FRAME in {s.message for s in block.writes.values()}
        for signal in block.writes.values() if signal.message in COMMANDS])
    state, command = measured.parts[0], sent.parts[0]
    value = Ref(sent.name, 'value')
    return Display(
        measured=measured.name, stars=False, views=(Perspective('Scene'),),
        instruments=Instruments('Telemetry', tuple(
            Instrument(label, unit, (Reading('measured', Number(measured.name, 'state', (i,))),), 3)
            for i, (label, unit) in enumerate(zip(_labels(state), _units(state))))),
        commands=Commands(
            'Command', tuple(CommandAxis(label, highest) for label, highest in zip(
                _labels(command), _highest(scenario, command))),
            sent.name, (CommandRow('sent', 'sent', value),), 0 if command.dtype[0] in 'iu' else 3,
            command.unit),
        modes=tuple(mode if mode in MODES else Mode(mode, mode.capitalize())
                    for mode in scenario.mission.modes))


def _only(scenario: Scenario, what: str, found: list[Signal]) -> Signal:
    names = sorted({signal.name for signal in found})
    if len(names) != 1:
        raise BadInput(f'mission {scenario.mission.name} has no display, and its ground '
                       f'{what} is {" or ".join(names) or "not there"}: its display must say '
                       'what is shown')
    return found[0]


def _size(part: Part) -> int:
    return int(np.prod(part.shape, dtype=int))


def _labels(part: Part) -> list[str]:
    size = _size(part)
    return [part.name] if size == 1 else [f'{part.name} {i}' for i in range(size)]


def _units(part: Part) -> list[str]:
    """Return the unit of each component: 'm, m/s' of six are three of each."""
    units, size = part.unit.split(', '), _size(part)
    return [units[i * len(units) // size] for i in range(size)]


def _highest(scenario: Scenario, command: Part) -> list[float]:
    """Return the largest value of each component that the mission's command form allows."""
    size = _size(command)
    try:
        form: Any = scenario.part('form')
    except LookupError:
        return [1.0] * size
    most = np.abs(np.asarray(form.quantise(np.full(size, LARGE)), dtype=float))
    return [float(v) if np.isfinite(v) and v > 0.0 else 1.0 for v in most]
