"""The driver of a stick: what it reads of a device, and when it sends what."""

import pytest
from virtual_stick import VirtualStick

from rvd_groundstation.joystick.device import Device, INPUTS, Reading
from rvd_groundstation.joystick.messages import Messages, outside
from rvd_groundstation.joystick.params import JoystickParams

REST = Reading((0.0, 0.0), (0, 0))
LEFT = Reading((1.0, 0.0), (0, 0))
PRESSED = Reading((0.0, 0.0), (1, 0))


# -- the device -------------------------------------------------------------------------------

@pytest.fixture
def device():
    made = Device()
    yield made
    made.close()


def test_a_stick_is_found_read_lost_and_found_again(device):
    assert device.poll() is None and device.name == ''
    for _ in range(2):                          # plugged in, out, and in again
        stick = VirtualStick(axes=6, buttons=8, hats=1)
        rest = (0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0)     # triggers rest at 1
        assert device.poll() == Reading(rest, (0,)*8)
        assert 'Virtual' in device.name
        stick.move(1, -32768)                   # SDL: forwards is negative
        stick.move(0, 32767)
        stick.press(4)
        stick.push_hat(0, 1 + 8)
        read = device.poll()
        assert read.axes == (-1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0)
        assert read.buttons == (0, 0, 0, 0, 1, 0, 0, 0)
        stick.unplug()
        assert device.poll() is None and device.name == ''


def test_with_two_sticks_number_and_name_choose():
    device = Device()
    try:
        two, four = VirtualStick(axes=2), VirtualStick(axes=4)
        names = device.names()
        assert len(names) == 2
        assert [len(Device(number=i).poll().axes) for i in (0, 1)] == [4, 6]    # and a hat
        assert Device(number=7, name=names[0]).poll() is not None
        assert Device(name='no such stick').poll() is None
        why = Device(name='no such stick').why_not()
        assert "no stick named 'no such stick': there is 0 " in why
        assert Device(number=2).why_not().startswith('no stick with number 2: there is 0 ')
        two.unplug()
        four.unplug()
    finally:
        device.close()


def test_why_there_is_no_stick_names_what_to_do(device, monkeypatch, tmp_path):
    import rvd_groundstation.joystick.device as module
    monkeypatch.setattr(module, 'INPUTS', tmp_path / 'input')
    assert '--device /dev/input' in device.why_not()
    (tmp_path / 'input').mkdir()
    assert device.why_not() == 'no stick is plugged in'
    (tmp_path / 'input' / 'event3').touch()
    monkeypatch.setattr(module.os, 'access', lambda path, mode: False)
    assert '1 devices in /dev/input are closed): sudo usermod -aG input' in device.why_not()
    assert INPUTS.as_posix() == '/dev/input'


# -- messages ---------------------------------------------------------------------------------

def sent(readings, **settings):
    """Return (time, Joy) of what is sent, one reading each 10 ms from 1 s on."""
    messages = Messages(JoystickParams(**settings))
    made = [(round(1.0 + i * 0.01, 6), messages.due(r, 1.0 + i * 0.01))
            for i, r in enumerate(readings)]
    return [(at, due) for at, due in made if due is not None]


@pytest.mark.parametrize('value, out', [(0.0, 0.0), (0.05, 0.0), (-0.05, 0.0), (1.0, 1.0),
                                        (-1.0, -1.0), (0.525, 0.5), (-0.525, -0.5)])
def test_beyond_the_dead_zone_an_axis_rises_from_0_to_1(value, out):
    assert outside(value, 0.05) == pytest.approx(out, abs=1e-15)
    assert abs(outside(value, 0.05)) <= 1.0
    assert outside(value, 0.0) == value


def test_a_stick_at_rest_is_repeated_at_the_rate():
    assert [at for at, _ in sent([REST]*16, autorepeat_rate=24.0)] == [1.0, 1.05, 1.1, 1.15]
    assert [at for at, _ in sent([REST]*16, autorepeat_rate=0.0)] == [1.0]


def test_a_change_is_sent_at_once_and_a_button_is_never_held_back():
    readings = [REST, REST, LEFT, LEFT, PRESSED, PRESSED]
    assert sent(readings, autorepeat_rate=0.0, coalesce_interval_ms=0) == [
        (1.0, REST), (1.02, LEFT), (1.04, PRESSED)]
    assert sent(readings, autorepeat_rate=0.0, coalesce_interval_ms=1000) == [
        (1.0, REST), (1.04, PRESSED)]


def test_changes_within_the_interval_go_into_one_message():
    half = Reading((0.5, 0.0), (0, 0))
    assert sent([REST, half, LEFT, LEFT], autorepeat_rate=0.0, coalesce_interval_ms=15,
                deadzone=0.0) == [(1.0, REST), (1.03, LEFT)]


def test_a_sticky_button_switches_over():
    readings = [REST, PRESSED, PRESSED, REST, REST, PRESSED, REST]
    assert [(at, due.buttons) for at, due in sent(readings, autorepeat_rate=0.0,
                                                  sticky_buttons=True)] == [
        (1.0, (0, 0)), (1.01, (1, 0)), (1.05, (0, 0))]


def test_a_stick_that_comes_back_begins_anew():
    messages = Messages(JoystickParams(sticky_buttons=True, autorepeat_rate=0.0))
    assert messages.due(PRESSED, 1.0).buttons == (1, 0)
    messages.lost()
    assert messages.due(REST, 1.01).buttons == (0, 0)
