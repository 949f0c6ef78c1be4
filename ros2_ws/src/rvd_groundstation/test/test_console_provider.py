"""How the console finds what a mission shows, and what it reads from messages of any mission."""

from dataclasses import replace
from math import isnan, nan
from types import SimpleNamespace

import pytest

from rvd_dynamics.commands.codes import BY_PILOT, KIND_ABORT
from rvd_dynamics.diagram.display import (
    as_data, CommandAxis, Commands, Display, Instrument, Instruments, Number, Reading)
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.link.frame import pack_downlink, ReplayWindow
from rvd_groundstation.console.decode import (
    command_of_values, Heard, Lost, telemetry_of, values_of)
from rvd_groundstation.console.provider import display_of, MissionDisplay

SCENARIO = parse('/**: {ros__parameters: {forward_delay_s: 2.0, seed: 4}}', 'test')
FORCE = Commands('Force', (CommandAxis('x', 1.0),), '/ground/command')


class Shows(MissionDisplay):
    """What a mission shows: the number of one signal."""

    def __init__(self, facts, signal, commands=FORCE, measured='/ground/telemetry'):
        super().__init__(facts, Display(commands, measured, instruments=Instruments('i', (
            Instrument('x', 'm', (Reading('plain', Number(signal, 'x')),)),))))


class Truth(Shows):
    def __init__(self, facts):
        super().__init__(facts, '/truth/relative_state')


class OnBoard(Shows):
    def __init__(self, facts):
        super().__init__(facts, '/onboard/command')


class SendsTheEstimate(Shows):
    def __init__(self, facts):
        super().__init__(facts, '/joy', replace(FORCE, sent='/ground/telemetry'))


class MeasuresTheEstimate(Shows):
    def __init__(self, facts):
        super().__init__(facts, '/joy', measured='/ground/estimate')


class Greedy(Shows):
    def __init__(self, facts, world):
        raise AssertionError


def shown_as(display):
    return replace(SCENARIO, mission=replace(SCENARIO.mission, display=display))


@pytest.mark.parametrize('name, complaint', [
    (f'{__name__}:Truth', 'its display shows /truth/relative_state, which is not on the ground'),
    (f'{__name__}:OnBoard', 'its display shows /onboard/command, which is not on the ground'),
    (f'{__name__}:SendsTheEstimate', 'has /ground/telemetry as commands.sent, which must be'),
    (f'{__name__}:MeasuresTheEstimate', 'has /ground/estimate as measured, which must be'),
    (f'{__name__}:Greedy', "needs 'world', which neither the scenario nor the mission has"),
    ('nowhere.at_all:Shows', "nowhere.at_all:Shows cannot be loaded: No module named 'nowhere'")])
def test_a_display_that_cannot_be_shown_is_refused_in_one_line(name, complaint):
    with pytest.raises(ValueError, match='^mission lunar_approach: ') as refused:
        display_of(shown_as(name))
    assert complaint in str(refused.value) and '\n' not in str(refused.value)


def test_a_mission_without_a_display_is_shown_as_numbers():
    provider = display_of(shown_as(''))
    display, facts = provider.display, provider.facts
    assert (facts.forward_s, facts.back_s, facts.seed) == (2.0, 5.0, 4)
    assert display.measured == '/ground/telemetry'
    assert [(row.label, row.unit) for row in display.instruments.rows] == [
        ('state 0', 'm'), ('state 1', 'm'), ('state 2', 'm'),
        ('state 3', 'm/s'), ('state 4', 'm/s'), ('state 5', 'm/s')]
    assert display.commands.sent == '/ground/command'
    assert [axis.highest for axis in display.commands.axes] == [3.0, 3.0, 3.0]
    assert provider.measured([1.0] * 6) == {'state': [1.0] * 6}
    as_data(display)


# -- messages of any mission ------------------------------------------------------------------

def values(layout, *numbers, step=7):
    stamp = SimpleNamespace(sec=3, nanosec=500_000_000)
    return SimpleNamespace(header=SimpleNamespace(stamp=stamp), step=step, layout=layout,
                           values=list(numbers))


def test_values_become_the_parts_that_their_layout_names():
    sample = values_of(values('state[2], image[2,2], final', 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 1.0))
    assert sample.parts == {'state': [1.0, 2.0], 'image': [3.0, 4.0, 5.0, 6.0], 'final': 1.0}
    assert (sample.step, sample.t, sample.ok) == (7, 3.5, True)


def test_values_that_are_unknown_or_say_that_they_are_not_valid_say_nothing():
    assert not values_of(values('state[2]', nan, nan)).ok
    assert values_of(values('state[2]', nan, 1.0)).ok
    assert not values_of(values('state[1], valid', 1.0, 0.0)).ok


def test_a_command_as_values_has_what_the_ladder_needs():
    parts = command_of_values(values('command[1], kind', 0.25, KIND_ABORT)).parts
    assert isnan(parts.pop('weight'))
    assert parts == {'value': [0.25], 'kind': KIND_ABORT, 'by': None, 'reason': 0,
                     'sequence': 8}
    named = values('command[1], kind, decided_by, pilot_weight', 0.25, 0.0, BY_PILOT, 0.5)
    assert command_of_values(named).parts['by'] == BY_PILOT


def test_telemetry_of_any_width_is_named_by_the_mission():
    payload = pack_downlink(sequence=5, generated_ns=2_000_000_000, state=[0.5, -1.0],
                            accepted_sequence=3, refusal=0)
    frame = SimpleNamespace(step=6, empty=False, payload=payload, sent=2_000_000_000,
                            arrived=2_750_000_000)
    heard = telemetry_of(frame, 0.5, 2, lambda state: {'x': state[0], 'v': state[1]})
    assert isinstance(heard, Heard) and heard.sample.parts == {'x': 0.5, 'v': -1.0}
    assert (heard.sample.t, heard.sample.received, heard.sample.transit) == (2.0, 3.0, 0.75)
    assert isinstance(telemetry_of(frame, 0.5, 6, dict), Lost)
    window = ReplayWindow()                     # a page shows each frame once
    assert [telemetry_of(frame, 0.5, 2, dict.fromkeys, window) for _ in range(2)][1] == Lost(
        6, 'ORDER')
