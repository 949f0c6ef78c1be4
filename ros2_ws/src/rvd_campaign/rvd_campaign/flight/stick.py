"""
`./rvd stick`: show a live stick and what the scenario makes of it, set it up, write its settings.

It reads the device itself, as the node `joystick` does, or with `--topic` what any node publishes.
"""

import argparse
from collections.abc import Callable, Iterator
from contextlib import contextmanager
import os
from pathlib import Path
import shlex
import sys
import tempfile
import time

from rvd_campaign import catalogue
from rvd_campaign.exits import CannotRun, check_file, EXIT_DONE
from rvd_campaign.flight.domain import asked_for
from rvd_dynamics.bad_input import one_line
from rvd_dynamics.commands.levels import stick_fault, stick_levels, StickParams
from rvd_dynamics.diagram.params import build, flatten
from rvd_dynamics.diagram.ros.inputs import HELD_FOR_S
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording import whole
from rvd_groundstation.joystick.device import Device, Reading
from rvd_groundstation.joystick.messages import outside
from rvd_groundstation.joystick.params import JoystickParams

LOOK_S = 0.02                   # [s] wall time between two looks at the stick
SHOW_S = 0.1                    # [s] wall time between two pictures
WAIT_S = 3.0                    # [s] wall time that a publisher gets to be heard
PUSHED = 0.7                    # deflection that counts as an answer
BAR = 10                        # characters of half a bar
ASKED = (('x', 'forwards (x+)'), ('y', 'the way that commands y+'),
         ('z', 'the way that commands z+'))

Source = Callable[[], Reading | None]


def main(args: argparse.Namespace) -> int:
    """Show or set up a stick; return the exit code."""
    scenario = load(catalogue.find('scenarios', args.scenario, ('.yaml',)))
    if not scenario.has_shared('stick.layout'):
        raise CannotRun(f'mission {scenario.mission.name} has no stick')
    if args.write:
        check_file('--write', args.write)
    settings, driver = scenario.part('stick'), scenario.settings('joystick')
    if args.layout:
        settings = layout_of(args.layout)
    given = {key: value for key, value in (
        ('device_id', args.device_id), ('device_name', args.device_name)) if value is not None}
    driver = build(JoystickParams, {**flatten(driver), **given})
    source = of_topic(args.topic) if args.topic else of_device(driver)
    with source as (read, name):
        if args.set_up:
            settings = set_up(read, settings)
        if args.write:
            write(Path(args.write), settings, '' if args.topic else name)
            print(f'{args.write}: copy it into a scenario, or fly it: '
                  f'./rvd fly {shlex.quote(args.write)} --operator joy')
            return EXIT_DONE
        if args.set_up:
            print(snippet(settings, '' if args.topic else name), end='')
            return EXIT_DONE
        show(read, settings, name, args.once)
    return EXIT_DONE


def layout_of(name: str) -> StickParams:
    """Return the stick of a layout, or refuse an unknown one by name."""
    return build(StickParams, {'layout': name})


# -- where readings come from -------------------------------------------------------------------

@contextmanager
def of_device(settings: JoystickParams) -> Iterator[tuple[Source, str]]:
    """Yield what reads the stick of this machine, and its name."""
    device = Device(settings.device_id, settings.device_name)
    try:
        if device.poll() is None:
            raise CannotRun(device.why_not())

        def read() -> Reading | None:
            reading = device.poll()
            return reading and Reading(tuple(outside(a, settings.deadzone) for a in reading.axes),
                                       reading.buttons)
        yield read, device.name
    finally:
        device.close()


@contextmanager
def of_topic(topic: str) -> Iterator[tuple[Source, str]]:
    """Yield what reads the newest Joy of a topic, and the topic's name."""
    asked_for()                                 # refused if it is no domain id
    with tempfile.TemporaryDirectory(prefix='rvd-') as folder:      # of nobody else's
        os.environ.setdefault('ROS_LOG_DIR', folder)                # and not ~/.ros
        with _heard(topic) as found:
            yield found


@contextmanager
def _heard(topic: str) -> Iterator[tuple[Source, str]]:
    import rclpy
    from rclpy.executors import ExternalShutdownException
    from rclpy.node import Node
    from rclpy.signals import SignalHandlerOptions
    from sensor_msgs.msg import Joy
    from rvd_dynamics.diagram.ros.qos import TAKEN_STICK
    rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
    newest: list[tuple[float, Reading]] = []
    try:
        node = Node('rvd_stick', enable_rosout=False, start_parameter_services=False)

        def came(message: Joy) -> None:
            newest[:] = [(time.monotonic(), Reading(tuple(message.axes), tuple(message.buttons)))]
        try:
            node.create_subscription(Joy, topic, came, TAKEN_STICK)
        except Exception as error:              # rclpy has no common class for a bad name
            raise CannotRun(f'--topic {topic} is no name of a topic: '
                            f'{" ".join(str(error).split())}') from None

        def read() -> Reading | None:
            rclpy.spin_once(node, timeout_sec=0.0)
            holds = newest and time.monotonic() - newest[0][0] <= HELD_FOR_S
            return newest[0][1] if holds else None
        until = time.monotonic() + WAIT_S
        while read() is None:
            if time.monotonic() > until:
                raise CannotRun(f'nobody publishes sensor_msgs/Joy on {topic}: start the driver, '
                                'with the same ROS_DOMAIN_ID')
            time.sleep(LOOK_S)
        yield read, topic
    except ExternalShutdownException:
        raise KeyboardInterrupt from None
    finally:
        rclpy.try_shutdown()


# -- what is shown --------------------------------------------------------------------------------

def bar(value: float) -> str:
    """Return a deflection -1 to 1 as a bar around its middle."""
    if value != value:
        return 'not a number'.center(2*BAR + 1)
    filled = round(min(abs(value), 1.0) * BAR)
    left, right = ('#'*filled, '') if value < 0.0 else ('', '#'*filled)
    return f'{left:>{BAR}}|{right:<{BAR}}'


def lines(reading: Reading | None, settings: StickParams, name: str) -> list[str]:
    """Return a picture of a stick: its axes, its buttons, the levels, or why there are none."""
    if reading is None:
        return [name, 'no stick: it is unplugged, or nothing has come for '
                f'{HELD_FOR_S:g} s']
    names = {settings.axis_x: 'x', settings.axis_y: 'y', settings.axis_z: 'z'}
    axes = [f'axis {i:2d} {names.get(i, " ")} [{bar(a)}] {a:6.2f}'
            for i, a in enumerate(reading.axes)]
    down = [str(i) for i, pressed in enumerate(reading.buttons) if pressed]
    deadman = settings.deadman_button
    buttons = (f'buttons down: {" ".join(down) or "none"} of {len(reading.buttons)}'
               + (f'; dead-man {deadman}' if deadman >= 0 else '; no dead-man'))
    fault = stick_fault(reading.axes, reading.buttons, settings)
    if fault:
        return [name, *axes, buttons, f'does not count: {fault}']
    levels = stick_levels(reading.axes, reading.buttons, settings)[0]
    return [name, *axes, buttons, 'levels: ' + '  '.join(
        f'{axis} {level:+d}' for axis, level in zip('xyz', levels.tolist()))]


def show(read: Source, settings: StickParams, name: str, once: bool) -> None:
    """Show the stick until Ctrl-C; one picture if `once`, or where there is no terminal."""
    live = sys.stdout.isatty() and not once
    before = 0
    if live:
        print('Ctrl-C ends this; ./rvd stick --set-up names the axes and the dead-man button')
    while True:
        until = time.monotonic() + SHOW_S
        while time.monotonic() < until:
            reading = read()
            time.sleep(LOOK_S)
        picture = [one_line(line) for line in lines(reading, settings, name)]
        if before:
            print(f'\x1b[{before}A', end='')
        print(''.join(f'{line}\x1b[K\n' if live else f'{line}\n' for line in picture)
              + ('\x1b[J' if live else ''), end='', flush=True)
        before = len(picture)
        if not live:
            return


# -- setting up -----------------------------------------------------------------------------------

def set_up(read: Source, settings: StickParams) -> StickParams:
    """Ask for each axis and the dead-man button; return the settings that the answers mean."""
    rest = needed(read)
    print('Leave the stick alone ...', flush=True)
    until = time.monotonic() + 1.0
    while time.monotonic() < until:
        rest = needed(read)
        time.sleep(LOOK_S)
    found: dict[str, int] = {}
    for axis, how in ASKED:
        print(f'Push the stick {how}, and let go ...', flush=True)
        taken = [found[key] for key in found if key.startswith('axis')]
        index, sign = pushed(read, rest, taken)
        found[f'axis_{axis}'], found[f'sign_{axis}'] = index, sign
        print(f'  {axis} is axis {index}' + (', reversed' if sign < 0 else ''), flush=True)
    print('Press the dead-man button ...', flush=True)
    found['deadman_button'] = pressed(read, rest)
    print(f'  dead-man is button {found["deadman_button"]}', flush=True)
    return build(StickParams, {**flatten(settings), **found})


def needed(read: Source) -> Reading:
    """Return a reading, or refuse to go on without the stick."""
    reading = read()
    if reading is None:
        raise CannotRun('the stick has gone')
    return reading


def pushed(read: Source, rest: Reading, taken: list[int]) -> tuple[int, int]:
    """
    Wait for an axis not yet taken to be pushed from its rest and let go; return it and the sense.
    """
    answer: tuple[int, int] | None = None
    while True:
        moves = {i: a - r for i, (a, r) in enumerate(zip(needed(read).axes, rest.axes))
                 if i not in taken}
        if not moves:
            raise CannotRun('the stick has no axis left: three are needed')
        index = max(moves, key=lambda i: abs(moves[i]) if moves[i] == moves[i] else 0.0)
        if answer is None and abs(moves[index]) > PUSHED:
            answer = (index, 1 if moves[index] > 0.0 else -1)
        if answer is not None and abs(moves[answer[0]]) < PUSHED/2:
            return answer
        time.sleep(LOOK_S)


def pressed(read: Source, rest: Reading) -> int:
    """Wait for a button that was up to be pressed; return it."""
    while True:
        for i, (now, before) in enumerate(zip(needed(read).buttons, rest.buttons)):
            if now and not before:
                return i
        time.sleep(LOOK_S)


def snippet(settings: StickParams, name: str) -> str:
    """Return settings as a section of a scenario; `name` is that of the device, if it has one."""
    import yaml
    tree: dict = {'/**': {'ros__parameters': {'stick': flatten(settings)}}}
    if name:
        tree['joystick'] = {'ros__parameters': {'device_name': name}}
    return yaml.safe_dump(tree, sort_keys=False)


def write(path: Path, settings: StickParams, name: str) -> None:
    """Write the settings as a scenario, which has the defaults in all else."""
    try:
        whole.write_new(path, '# A stick, as ./rvd stick has set it up.\n'
                        + snippet(settings, name))
    except OSError as error:
        raise CannotRun(f'cannot write {path}: {error.strerror}') from None
