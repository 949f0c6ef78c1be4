"""
One run of a campaign, flown again: over DDS or in this process, with the same verdict.
"""

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from rvd_campaign.campaign.engine import check_same, open_folder, refly
from rvd_campaign.campaign.results import order_of, rows, Table
from rvd_campaign.exits import CannotRun, EXIT_CANNOT, EXIT_DONE, EXIT_FAILED
from rvd_campaign.flight.choice import paced
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import fly, judge_of
from rvd_dynamics.diagram.judge import judgement
from rvd_dynamics.diagram.scenario import Scenario

# arguments that the campaign answers
FIXED = ('scenario', 'mode', 'operator', 'tape', 'tape_topic', 'seed')


def chosen(args: argparse.Namespace) -> Scenario:
    """Return the scenario of the run that the command line names."""
    scenario = _chosen(args)[0]
    values = paced(args.pace, scenario)
    if args.processes:
        values['processes'] = args.processes
    return scenario.with_values('/**', **values)


def _chosen(args: argparse.Namespace) -> tuple[Scenario, Table]:
    if not args.condition or args.run_number is None:
        raise CannotRun('--from needs --condition NAME and --run K')
    for name in FIXED:
        if getattr(args, name) is not None:
            raise CannotRun(f'--from takes everything from the campaign: leave out '
                            f'{"SCENARIO" if name == "scenario" else "--" + name}')
    return refly(Path(args.campaign), args.condition, args.run_number)


def compared(args: argparse.Namespace, content: dict[str, Any]) -> str:
    """Return in words whether a flown verdict is that of the campaign."""
    row = _chosen(args)[1]
    mine = {'reason': content['reason'], 'duration_s': content['duration_s'],
            **{name: m['value'] for name, m in content['measures'].items()}}
    different = [name for name, value in mine.items()
                 if name in row and not _same(value, row[name][0])]
    return _said(args, different)


def in_process(args: argparse.Namespace) -> int:
    """Fly the run in this process and compare every column; return the exit code of `fly`."""
    scenario, row = _chosen(args)
    flown = fly(scenario, [args.run_number])
    judged = judgement(judge_of(scenario), flown.verdict, 0)
    print(f'{args.condition}, run {args.run_number}: {judged.headline}')
    mine = rows(flown, order_of(scenario.mission))
    different = [name for name, values in row.items()
                 if not np.array_equal(values, mine[name], equal_nan=values.dtype.kind == 'f')]
    print(_said(args, different))
    if different:
        return EXIT_CANNOT
    return EXIT_DONE if mine['success'][0] else EXIT_FAILED


def _same(value: Any, of_campaign: Any) -> bool:
    """Say whether a value of `verdict.json` is that of the table, to the bit."""
    if isinstance(value, str):
        return value == of_campaign
    return np.array_equal(float('nan') if value is None else value, of_campaign, equal_nan=True)


def _said(args: argparse.Namespace, different: list[str]) -> str:
    if not different:
        return 'the same as in the campaign, to the last bit'
    folder = Path(args.campaign)
    campaign, kept = open_folder(folder)
    try:
        check_same(folder, kept, campaign)
        why = ''
    except BadInput as error:
        why = f' ({error})'
    return f'NOT the same as in the campaign: {", ".join(different)}{why}'
