"""`./rvd stick`: what it shows, what it makes of the answers, and what it refuses."""

from itertools import chain, repeat
import os

import pytest
from runs import rvd

from rvd_campaign.exits import CannotRun
from rvd_campaign.flight import stick
from rvd_dynamics.commands.levels import StickParams
from rvd_dynamics.diagram.scenario import load
from rvd_groundstation.joystick.device import Reading

HELD = (0, 0, 0, 0, 1)


@pytest.fixture
def fast(monkeypatch):
    monkeypatch.setattr(stick.time, 'sleep', lambda seconds: None)
    clock = [0.0]

    def monotonic():
        clock[0] += 0.5
        return clock[0]
    monkeypatch.setattr(stick.time, 'monotonic', monotonic)


def played(*readings):
    """Return a source that gives these readings one by one, and then the last for ever."""
    given = chain(readings, repeat(readings[-1]))
    return lambda: next(given)


def at(*axes, buttons=(0, 0, 0)):
    return Reading(axes, buttons)


REST = [at(0.0, 0.0, 1.0, 0.0)] * 6             # a trigger rests at 1


def test_a_picture_shows_axes_buttons_and_levels():
    shown = stick.lines(Reading((0.0, 1.0, 1.0, 0.0, -1.0), HELD), StickParams(), 'pad')
    assert shown[0] == 'pad' and shown[-1] == 'levels: x +3  y +0  z -3'
    assert shown[2] == 'axis  1 x [          |##########]   1.00'
    assert shown[5] == 'axis  4 z [##########|          ]  -1.00'
    assert shown[6] == 'buttons down: 4 of 5; dead-man 4'


@pytest.mark.parametrize('reading, why', [
    (None, 'no stick: it is unplugged, or nothing has come for 0.5 s'),
    (Reading((0.0,)*3, HELD), 'does not count: axis 4 (z) is not there: Joy has 3 axes'),
    (Reading((0.0,)*5, (0,)*5), 'does not count: dead-man button 4 is not held'),
    (Reading((0.0, float('nan'), 0.0, 0.0, 0.0), HELD),
     'does not count: axis 1 (x) is not a number')])
def test_a_stick_that_does_not_count_says_why(reading, why):
    assert stick.lines(reading, StickParams(), 'pad')[-1] == why


def test_the_answers_become_settings_that_a_scenario_takes(fast, tmp_path):
    read = played(*REST, at(0.2, -0.9, 1.0, 0.0), *REST, at(0.0, 0.0, 1.0, 0.8), *REST,
                  at(0.9, 0.0, 1.0, 0.0), *REST, at(0.0, 0.0, 1.0, 0.0, buttons=(0, 1, 0)))
    made = stick.set_up(read, StickParams(dead_zone=0.1))
    assert made == StickParams(axis_x=1, sign_x=-1, axis_y=3, sign_y=1, axis_z=0, sign_z=1,
                               deadman_button=1, dead_zone=0.1)
    stick.write(tmp_path / 'mine.yaml', made, "T.16000M: 'left' #1")
    scenario = load(tmp_path / 'mine.yaml')
    assert scenario.part('stick') == made
    assert scenario.settings('joystick').device_name == "T.16000M: 'left' #1"


def test_a_stick_that_goes_away_ends_the_questions(fast):
    with pytest.raises(CannotRun, match='the stick has gone'):
        stick.set_up(played(*REST, None), StickParams())


def test_no_stick_is_one_line_and_exit_code_2(tmp_path):
    done = rvd('stick', '--device-name', 'no such stick', cwd=tmp_path)
    assert done.returncode == 2 and done.stderr.startswith('rvd stick: no stick')
    assert len(done.stderr.splitlines()) == 1 and not done.stdout


def test_a_file_that_exists_is_not_overwritten(tmp_path):
    (tmp_path / 'mine.yaml').write_text('years of work')
    done = rvd('stick', '--write', 'mine.yaml', cwd=tmp_path)
    assert done.returncode == 2 and 'nothing is overwritten' in done.stderr
    assert os.listdir(tmp_path) == ['mine.yaml']


def test_a_missing_package_joy_is_one_line_before_anything_is_made(tmp_path):
    (tmp_path / 'theirs.yaml').write_text('/**: {ros__parameters: {joy_driver: joy_node}}')
    done = rvd('fly', 'theirs.yaml', '--operator', 'joy', cwd=tmp_path)
    assert done.returncode == 2 and len(done.stderr.splitlines()) == 1
    assert 'the ROS package joy with joy_node is not installed' in done.stderr
    assert 'joy_driver: joystick' in done.stderr and os.listdir(tmp_path) == ['theirs.yaml']
