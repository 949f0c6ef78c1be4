"""A display is checked where it is written down, and reaches the page as plain JSON values."""

import json

import numpy as np
import pytest

from rvd_dynamics.diagram.display import (
    as_data, Axis, Ball, Body, Box, Camera, Chart, Charts, CommandAxis, Commands, cone,
    Controller, Cylinder, DERIVED, Display, Flat, Gauge, Instrument, Instruments, Line, Mode,
    Number, Perspective, Reading, Ref, Revolved, Ring, Section, Sphere, Spot, Trail, TRUTH, walk)

BOX = Box((1.0, 2.0, 0.5))
COMMANDS = Commands('Force', (CommandAxis('x', 2.0),), '/command')
PLACE, RATE = Ref('/state', 'x'), Number('/state', 'v')


def display(**parts):
    return Display(COMMANDS, '/state', **parts)


def test_a_display_becomes_json_and_back_without_loss():
    whole = display(
        bodies=(Body('box', 'measured', (BOX, Cylinder(0.2, 1.0)), PLACE, 'x'),),
        surfaces=(cone('wall', 'limit', -10.0, 0.0, 1.5, 0.5, skin=True),
                  Sphere('rock', 'limit', 2.0, (3.0, 0.0, 1.0))),
        lines=(Line('rail', 'plain', ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))),
               Trail('way', 'measured', PLACE, 'x')),
        instruments=Instruments('Motion', (Instrument('rate', 'm/s', (
            Reading('measured', RATE, -1.0, 1.0),)),)),
        charts=Charts('Errors', (Chart('m', (RATE,)),)))
    data = as_data(whole)
    assert json.loads(json.dumps(data, allow_nan=False)) == data
    assert [body['shape'][1]['kind'] for body in data['bodies']] == ['cylinder']
    assert data['surfaces'][0]['radii_m'] == [1.5, 0.5]
    assert data['bodies'][0]['place'] == {'kind': 'ref', 'signal': '/state', 'part': 'x'}


def test_numbers_of_numpy_are_plain_numbers_in_json():
    ring = as_data(Revolved('wall', 'limit', tuple(np.linspace(-1.0, 0.0, 3)),
                            tuple(np.float32([1, 2, 3]))))
    assert json.loads(json.dumps(ring))['radii_m'] == [1.0, 2.0, 3.0]


def test_the_parts_that_are_shown_are_named_once_for_who_sends_them():
    shown = display(predicted='/ahead', bodies=(Body('box', 'measured', (BOX,), PLACE, 'x'),),
                    lines=(Line('drift', 'predicted', Ref(DERIVED, 'path')),))
    parts = shown.parts()
    assert parts['/state'] == {'x'} and parts[DERIVED] == {'path'} and parts['/ahead'] == set()
    assert 'kind' in parts['/command']          # of the command the page shows who decided it


def test_modes_are_those_of_a_pilot_by_name_or_the_missions_own():
    go = Mode('go', 'GO', 'KeyF')
    data = as_data(display(modes=('auto', go)))
    assert [(mode['name'], mode['label'], mode['key']) for mode in data['modes']] == [
        ('auto', 'Auto', ''), ('go', 'GO', 'KeyF')]
    assert [mode['label'] for mode in as_data(display())['modes']] == ['Manual', 'Shared', 'Auto']


def test_a_walk_meets_every_part():
    shown = display(section=Section('Cut', 'a cut', 1.0, rings=(Ring('limit', RATE),)))
    assert RATE in list(walk(shown)) and COMMANDS in list(walk(shown))


@pytest.mark.parametrize('make, names', [
    (lambda: Box((1.0, 0.0, 1.0)), 'box.size_m'),
    (lambda: Box((1.0, 1.0)), 'box.size_m'),
    (lambda: Box((1.0, 1.0, 1.0), colour='red'), 'box.colour'),
    (lambda: Cylinder(-0.1, 1.0), 'cylinder.radius_m'),
    (lambda: Cylinder(0.1, 1.0, along='x'), 'cylinder.along'),
    (lambda: Body('b', 'mesured', (BOX,)), 'body b: role'),
    (lambda: Body('b', 'plain', ()), 'body b: shape'),
    (lambda: Body('b', 'plain', (BOX,), (0.0, float('nan'), 0.0)), 'body b: place'),
    (lambda: Body('b', 'plain', (BOX,), PLACE, 'xw'), 'body b: axes'),
    (lambda: Revolved('w', 'limit', (0.0, -1.0), (1.0, 1.0)), 'revolved w: stations_m'),
    (lambda: Revolved('w', 'limit', (0.0, 1.0), (1.0,)), 'revolved w: radii_m'),
    (lambda: Revolved('w', 'limit', (0.0, 1.0), (1.0, -1.0)), 'revolved w: radii_m'),
    (lambda: Sphere('s', 'limit', 0.0), 'sphere s: radius_m'),
    (lambda: Line('l', 'plain', ((0.0, 0.0, 0.0),)), 'line l: points'),
    (lambda: Ball((0.0, 0.0, 0.0), 0.3), 'ball.direction'),
    (lambda: Flat('Side', '+x', '-x'), 'view Side: directions'),
    (lambda: Perspective('Orbit', distance_m=0.0), 'view Orbit: distance_m'),
    (lambda: Gauge('m', 1.0, 1.0, 0.1, 2, ()), 'gauge.high'),
    (lambda: Gauge('m', 0.0, 1.0, 1e-6, 2, ()), 'gauge.tick'),
    (lambda: Reading('sent', RATE), 'reading.role'),
    (lambda: Reading('plain', RATE, low=float('inf')), 'reading.low'),
    (lambda: Number('/s', 'v', ()), 'number.index'),
    (lambda: Number('/s', 'v', factor=float('nan')), 'number.factor'),
    (lambda: Ref('', 'v'), 'ref.signal'),
    (lambda: Instrument('v', 'm/s', (Reading('plain', RATE),) * 2), 'instrument v: readings'),
    (lambda: Spot('plain', PLACE, 'star'), 'spot.mark'),
    (lambda: CommandAxis('x', 0.0), 'command axis x: highest'),
    (lambda: Axis('x', 'on', 'back', (('KeyT', 'KeyS'),)), 'axis x: keys'),
    (lambda: Axis('x y', 'on', 'back', ()), 'axis.name'),
    (lambda: Controller(()), 'controller.axes'),
    (lambda: Controller((Axis('x', 'on', 'back', (('KeyW', 'KeyS'),)),
                         Axis('y', 'on', 'back', (('KeyW', 'KeyD'),)))), 'share no key'),
    (lambda: Controller((Axis('x', 'on', 'back', ()),), (0.5, 1.5)), 'key_deflections'),
    (lambda: Chart('c', (RATE, Number('/other', 'v'))), 'chart c: curves'),
    (lambda: Display(COMMANDS, ''), 'display.measured'),
    (lambda: display(modes=('manual', 'fast')), 'display.modes'),
    (lambda: display(modes=(Mode('manual', 'By hand'), 'manual')), 'display.modes'),
    (lambda: display(modes=(Mode('a', 'A', 'KeyH'), Mode('b', 'B', 'KeyH'))), 'share no key'),
    (lambda: display(modes=(Mode('a', 'A', 'KeyW'),), controller=Controller(
        (Axis('x', 'on', 'back', (('KeyW', 'KeyS'),)),))), 'display.modes'),
    (lambda: display(modes=('auto',), on_board=Ref(TRUTH, 'mode')), 'display.on_board'),
    (lambda: Mode('go now', 'GO'), 'mode.name'),
    (lambda: Mode('go', 'GO', 'KeyG'), 'mode go: key'),
    (lambda: Mode('go', ''), 'mode go: label'),
    (lambda: display(bodies=(Body('a', 'plain', (BOX,)),) * 2), 'names of their own, got a'),
    (lambda: display(views=(Perspective('Orbit', follow=('ghost',)),)), 'view Orbit: follow'),
    (lambda: display(camera=Camera('c', 'c', ('ghost',))), 'camera.carried_by'),
    (lambda: display(bodies=(Body('a', 'measured', (BOX,), Ref(TRUTH, 'x')),)), 'body: role'),
    (lambda: display(instruments=Instruments('i', (Instrument('x', 'm', (
        Reading('measured', Number(TRUTH, 'x')),)),))), 'reading: role'),
    (lambda: display(lines=(Trail('t', 'plain', Ref(TRUTH, 'x')),)), 'trail: role')])
def test_what_cannot_be_drawn_is_refused_with_the_name_of_its_field(make, names):
    with pytest.raises(ValueError, match=names.replace('.', r'\.')) as refused:
        make()
    assert '\n' not in str(refused.value)


@pytest.mark.parametrize('value', [object(), {1, 2}, b'bytes', float('nan')])
def test_a_value_that_json_does_not_know_is_refused_with_its_place(value):
    with pytest.raises(ValueError, match=r'display\.goal'):
        as_data(display(goal=value))
