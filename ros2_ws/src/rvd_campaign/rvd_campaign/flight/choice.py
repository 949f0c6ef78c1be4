"""
What is to be flown: a scenario with what the command line changes in it.
"""

import argparse
import os
from pathlib import Path
import sys

from rvd_campaign import catalogue
from rvd_campaign.exits import CannotRun
from rvd_dynamics.bad_input import one_line
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_groundstation.operators.tape import read_tape, TOPIC

USUAL_PACE = '10'               # of a scenario that names none


def chosen(args: argparse.Namespace) -> Scenario:
    """Return the scenario with what the command line changes in it."""
    usual = 'hand' if args.operator == 'console' else 'paper'
    scenario = load(catalogue.find('scenarios', args.scenario or usual, ('.yaml',)))
    shared: dict[str, object] = paced(args.pace, scenario)
    if args.processes:
        shared['processes'] = args.processes
    if args.mode and not scenario.has_shared('mode'):
        raise CannotRun(f'--mode: mission {scenario.mission.name} has no modes')
    for flag in ('operator', 'tape'):
        watched = flag == 'operator' and args.operator == 'console'     # which needs no operator
        if getattr(args, flag) and not watched and not scenario.has_shared('operator'):
            raise CannotRun(f'--{flag}: mission {scenario.mission.name} has no operator')
    operator = args.operator or ('replay' if args.tape else operator_of(scenario))
    if args.tape and operator != 'replay':
        raise CannotRun(f'--tape needs --operator replay, not {operator}')
    if operator and scenario.has_shared('operator'):
        shared['operator'] = operator
        shared['joy_input'] = 'held' if operator in ('joy', 'console') else 'stepped'
        if operator == 'joy' and not args.operator:     # a pilot of your own may answer each step
            shared['joy_input'] = scenario.sections.get('/**', {}).get('joy_input', 'held')
    if args.mode:
        shared['mode'] = args.mode
    if args.seed is not None:
        shared['seed'] = args.seed
    scenario = scenario.with_values('/**', **shared)
    if args.tape:
        tape = catalogue.find('tapes', args.tape, ('.csv', ''))
        scenario = scenario.with_values('joystick_replay', tape=str(tape),
                                        tape_topic=args.tape_topic or TOPIC)
    elif args.tape_topic:
        raise CannotRun('--tape-topic goes with --tape BAG')
    if operator == 'replay':
        settings = scenario.settings('joystick_replay')
        if not settings.tape:
            raise CannotRun('--operator replay needs --tape FILE (see rvd list tapes)')
        tape = read_tape(settings.tape, settings.tape_topic)    # a bad one is refused at once
        if tape.note:
            print(f'rvd fly: {one_line(tape.note)}', file=sys.stderr)
    return scenario


def operator_of(scenario: Scenario) -> str:
    """Return who flies; empty where the mission has no operator."""
    return scenario.part('operation').operator if scenario.has_shared('operator') else ''


def check_foreign(scenario: Scenario) -> None:
    """Refuse a run that is to start a node of somebody else's package that is not installed."""
    prefixes = os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep)
    for node in scenario.diagram.externals:
        if node.foreign and node.started and not any(
                os.access(Path(prefix, 'lib', node.package, node.executable), os.X_OK)
                for prefix in prefixes):
            name = f'ros-jazzy-{node.package.replace("_", "-")}'
            raise CannotRun(f'the ROS package {node.package} with {node.executable} is not '
                            f'installed (sudo apt-get install {name}); '
                            'our own driver needs nothing: joy_driver: joystick')


def introduced(scenario: Scenario) -> str:
    """Return in a few words what is about to be flown."""
    words = [f'{scenario.name}: mission {scenario.mission.name}']
    if scenario.has_shared('operator'):
        operation = scenario.part('operation')
        words += [f'mode {operation.mode}', f'operator {operation.operator}']
    return ', '.join([*words, f'seed {scenario.run.seed}'])


def paced(pace: str | None, scenario: Scenario) -> dict[str, object]:
    """Return the pace settings of `--pace`; without it those that the scenario gives count."""
    if pace is None and 'pace' in scenario.sections.get('/**', {}):
        return {}
    return pace_of(pace or USUAL_PACE)


def pace_of(text: str) -> dict[str, object]:
    """Return the pace settings that `--pace` means."""
    if text == 'lockstep':
        return {'pace': 'lockstep'}
    if text == 'realtime':
        return {'pace': 'realtime', 'pace_factor': 1.0}
    try:
        return {'pace': 'realtime', 'pace_factor': float(text)}
    except ValueError:
        raise CannotRun(f'--pace must be lockstep, realtime or a factor, got {text!r}') from None
