"""
`./rvd limit-cycles`: cycles of the direction angle under range-rate control, and their branches.
"""

import argparse
from dataclasses import fields, replace
import json
from math import degrees, radians
from typing import Any

from rvd_campaign.exits import CannotRun, EXIT_DONE
from rvd_missions.elliptic_rendezvous.gains import CycleCase, FEED_FORWARDS, FORMS

ALONG = ('e', 'k', 'k1', 'k2', 'q', 'q1', 'phi-d-deg')
MOST_POINTS = 1000


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command; those of a case have no default, to see which are given."""
    doc = {f.name: f.metadata['doc'][0].lower() + f.metadata['doc'][1:].rstrip('.')
           for f in fields(CycleCase)}
    usual = CycleCase()
    case = parser.add_argument_group('one case (given any, it is computed instead of the study)')
    case.add_argument('--law', choices=('rrca', 'odrrca'),
                      help='rrca: thrust along the line of sight; odrrca: across, too '
                           f'(default: {usual.law})')
    case.add_argument('--form', type=str.lower, choices=FORMS,
                      help=f'{doc["form"]} (default: {usual.form})')
    for name in ('e', 'k', 'k1', 'k2', 'q', 'q1', 'phi_d_deg'):
        shown = doc[name].replace('%', '%%')
        case.add_argument('--' + name.replace('_', '-'), type=float, metavar='X',
                          help=f'{shown} (default: {getattr(usual, name):g})')
    case.add_argument('--ff', nargs='?', const='on', choices=FEED_FORWARDS,
                      help=f'{doc["ff"]} (default: off; on without a value)')
    case.add_argument('--json', action='store_true', help='print JSON')
    branch = parser.add_argument_group('a branch of cycles')
    branch.add_argument('--along', choices=ALONG, metavar='PARAMETER',
                        help=f'follow the cycle of the case in one of {", ".join(ALONG)}')
    branch.add_argument('--until', type=float, metavar='X', help='where it is to end')
    branch.add_argument('--points', type=int, default=400, metavar='N',
                        help='points of the branch, at most (default: 400)')
    study = parser.add_argument_group('the study (without a case: the cycles, branches and flights '
                                      'of the paper\'s Figures 3 to 13)')
    study.add_argument('--out', metavar='DIR',
                       help='folder, must not exist yet (default: runs/<time>-limit-cycles)')
    study.add_argument('--no-flights', action='store_true',
                       help='leave out the flights, which take a minute: Figures 7 to 13')


def main(args: argparse.Namespace) -> int:
    """Do what the command line asks; return the exit code."""
    given = {f.name: getattr(args, f.name) for f in fields(CycleCase)
             if getattr(args, f.name) is not None}
    case = replace(CycleCase(), **given)
    asked = given or args.json or args.along or args.until is not None
    if asked and (args.out or args.no_flights):
        raise CannotRun('--out and --no-flights go with the study: without a case')
    if not asked:
        from rvd_campaign.report import cycles
        return cycles.study(case, args.out, flights=not args.no_flights)
    if args.along:
        return _branch(args, case)
    if args.until is not None:
        raise CannotRun('--until needs --along PARAMETER')
    found = answer(case)
    print(json.dumps(found) if args.json else '\n'.join(_in_words(found)))
    return EXIT_DONE


def answer(case: CycleCase) -> dict[str, Any]:
    """Return what is known of the cycle of a case, as plain data; None where there is none."""
    from rvd_missions.elliptic_rendezvous.limit_cycles import cycle
    found = cycle(case)
    if found is None:
        return {'exists': False, 'phi_min_deg': None, 'phi_max_deg': None, 'multipliers': None,
                'stable': None}
    return {'exists': True, 'phi_min_deg': degrees(found.phi_min),
            'phi_max_deg': degrees(found.phi_max), 'multipliers': _pairs(found.multipliers),
            'stable': found.stable}


def _pairs(multipliers: Any) -> list[list[float]]:
    return [[float(m.real), float(m.imag)] for m in multipliers]


def _in_words(found: dict[str, Any]) -> list[str]:
    if not found['exists']:
        return ['no cycle: the branch that begins at the equilibrium of the circular orbit does '
                'not reach here']
    low, high = found['phi_min_deg'], found['phi_max_deg']
    shown = ', '.join(f'{re:.6g}' + (f' {"+" if im > 0 else "-"} {abs(im):.6g}i' if im else '')
                      for re, im in found['multipliers'])
    return [f'approach corridor  {low:.3f} .. {high:.3f} deg, {high - low:.3f} deg wide',
            f'multipliers        {shown}',
            f'the cycle is       {"stable" if found["stable"] else "unstable"}']


def _branch(args: argparse.Namespace, case: CycleCase) -> int:
    from rvd_missions.elliptic_rendezvous import limit_cycles
    if args.until is None:
        raise CannotRun('--along needs --until X: where the branch is to end')
    if not 2 <= args.points <= MOST_POINTS:
        raise CannotRun(f'--points must be between 2 and {MOST_POINTS}, got {args.points}')
    name = args.along.replace('-', '_')
    replace(case, **{name: args.until})                 # refuses what cannot be
    first = getattr(case, name)
    if first == args.until:
        raise CannotRun(f'--until must differ from where the branch begins, {first:g}')
    turned = name == 'phi_d_deg'
    branch = limit_cycles.follow(
        case, 'phi_d' if turned else name,
        *(radians(v) if turned else v for v in (first, args.until)),
        points=args.points)
    shown = degrees if turned else float
    points = [{name: shown(at), 'phi_deg': degrees(start[0]), 'phi_rate': float(start[1]),
               'multipliers': _pairs(limit_cycles.multipliers(jacobian)), 'stable': bool(stable)}
              for at, start, jacobian, stable in zip(branch.at, branch.starts, branch.jacobians,
                                                     branch.stable)]
    events = [{'kind': event.kind, name: shown(event.at)} for event in branch.events]
    if args.json:
        print(json.dumps({'points': points, 'events': events}))
        return EXIT_DONE
    print(f'{name:>12} {"phi at perigee":>16} {"|multiplier|":>14}')
    for point in points:
        largest = max(abs(complex(*m)) for m in point['multipliers'])
        print(f'{point[name]:12.6f} {point["phi_deg"]:12.4f} deg {largest:14.6g} '
              f'{"stable" if point["stable"] else "unstable"}')
    for event in events:
        print(f'{event["kind"]} at {name} = {event[name]:.6f}')
    return EXIT_DONE
