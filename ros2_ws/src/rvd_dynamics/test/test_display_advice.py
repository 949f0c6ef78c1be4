"""Alarms, digits and gates of a display are checked where they are written down."""

import json

import pytest

from rvd_dynamics.diagram.display import (
    Alarm, as_data, Axis, Chart, Charts, CommandAxis, Commands, Digits, Display, Gate, Guidance,
    Motion, Number, Reading, TRUTH)

COMMANDS = Commands('Force', (CommandAxis('x', 2.0),), '/command')
RATE = Number('/state', 'v')
FAST = Alarm('TOO FAST', (Reading('measured', RATE, high=0.3),), 'speed', 'm/s', back=0.01)


def test_they_become_json_and_their_numbers_are_among_what_is_shown():
    shown = Display(COMMANDS, '/state', alarms=(FAST,), guidance=Guidance(
        (Gate(10.0, ('slowly',)), Gate(2.0, ('more slowly',))), ('softly',),
        (Number('/far', 'x'),)))
    data = json.loads(json.dumps(as_data(shown), allow_nan=False))
    assert data['alarms'][0]['readings'][0]['high'] == 0.3
    assert [gate['at'] for gate in data['guidance']['gates']] == [10.0, 2.0]
    assert shown.parts()['/state'] == {'v'} and shown.parts()['/far'] == {'x'}


@pytest.mark.parametrize('make, names', [
    (lambda: Alarm('', FAST.readings), 'alarm.words'),
    (lambda: Alarm('A', ()), 'alarm A: readings'),
    (lambda: Alarm('A', (Reading('measured', RATE),)), 'have a limit'),
    (lambda: Alarm('A', (Reading('truth', Number(TRUTH, 'v'), high=1.0),)), 'alarm A: role'),
    (lambda: Alarm('A', FAST.readings, back=-1.0), 'alarm A: back'),
    (lambda: Alarm('A', FAST.readings, level='loud'), 'alarm A: level'),
    (lambda: Display(COMMANDS, '/state', alarms=(FAST, FAST)), 'display.alarms'),
    (lambda: Motion('', (Reading('measured', RATE),)), 'motion.label'),
    (lambda: Motion('up'), 'motion up'),
    (lambda: Digits(()), 'digits.rows'),
    (lambda: Gate(float('nan'), ('x',)), 'gate.at'),
    (lambda: Gate(1.0, ()), 'gate.wanted'),
    (lambda: Guidance((Gate(1.0, ('x',)), Gate(2.0, ('x',))), (), ()), 'guidance.gates'),
    (lambda: Guidance((), (), ()), 'guidance'),
    (lambda: Axis('x', 'on', 'back', (), along='x'), 'axis x: along'),
    (lambda: Axis('x', 'on', 'back', (('KeyK', 'KeyS'),)), 'axis x: keys'),
    (lambda: Charts('c', (Chart('v', (RATE,)),), columns=4), 'charts.columns')])
def test_what_makes_no_sense_is_refused_with_the_name_of_its_field(make, names):
    with pytest.raises(ValueError, match=names.replace('.', r'\.')) as refused:
        make()
    assert '\n' not in str(refused.value)
