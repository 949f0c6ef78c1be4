"""
The one command: `./rvd CMD` comes here for everything that is Python.

Exit codes: 0 done (for `fly`: docked), 1 flown and failed, 2 could not run, 130 Ctrl-C.
Bad input is one line on stderr and exit code 2.
"""

import argparse
import sys

from rvd_campaign.exits import CannotRun, EXIT_CANNOT, EXIT_DONE, EXIT_INTERRUPTED


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message: str) -> None:
        """Print one line and exit with code 2."""
        self.exit(EXIT_CANNOT, f'{self.prog}: {message} (see {self.prog} --help)\n')


def main(argv: list[str] | None = None) -> int:
    """Run one command and return its exit code."""
    args = parser().parse_args(argv)
    try:
        return args.run(args)
    except (CannotRun, ValueError) as error:
        print(f'rvd {args.command}: {error}', file=sys.stderr)
        return EXIT_CANNOT
    except KeyboardInterrupt:
        return EXIT_INTERRUPTED


def parser() -> argparse.ArgumentParser:
    """Return the parser of all commands; each is imported when it runs."""
    top = Parser(prog='rvd', description='Teleoperated rendezvous and docking ground loop.')
    commands = top.add_subparsers(dest='command', metavar='COMMAND', required=True,
                                  parser_class=Parser)
    _add_fly(commands)
    _add_report(commands)
    _add_list(commands)
    _add_bench(commands)
    return top


def _add_fly(commands: argparse._SubParsersAction) -> None:
    fly = commands.add_parser(
        'fly', help='fly one approach over DDS',
        description='Bring the node graph up, fly one approach, print the verdict, leave a run '
                    'folder with bag/, verdict.json, scenario.yaml, report.html and logs/.',
        epilog='Exit codes: 0 docked, 1 flown and failed, 2 could not run, 130 Ctrl-C.')
    fly.add_argument('scenario', nargs='?', default='paper', metavar='SCENARIO',
                     help='name in `rvd list scenarios` or a file (default: paper)')
    fly.add_argument('--mode', choices=('shared', 'manual', 'auto'),
                     help='who decides (default: the scenario, else shared)')
    fly.add_argument('--operator', choices=('model', 'replay', 'joy', 'none'),
                     help='the pilot (default: the scenario, else model)')
    fly.add_argument('--tape', metavar='FILE',
                     help='with --operator replay: name in `rvd list tapes`, CSV file or bag')
    fly.add_argument('--pace', metavar='lockstep|realtime|FACTOR', default='10',
                     help='lockstep: as fast as it goes; realtime; or FACTOR times real time '
                          '(default: 10)')
    fly.add_argument('--seed', type=int, metavar='N', help='seed of every random stream')
    fly.add_argument('--out', metavar='DIR',
                     help='run folder, must not exist (default: runs/<time>-<scenario>)')
    fly.add_argument('--headless', action='store_true',
                     help='no live progress and no markers for viewers')
    fly.set_defaults(run=_fly)


def _add_report(commands: argparse._SubParsersAction) -> None:
    report = commands.add_parser(
        'report', help='make the report of a run again',
        description='Write report.html of a run from its bag alone.')
    report.add_argument('folder', metavar='RUN', help='a run folder or a bag folder')
    report.set_defaults(run=_report)


def _add_list(commands: argparse._SubParsersAction) -> None:
    listing = commands.add_parser('list', help='what there is to choose from',
                                  description='List laws, scenarios or tapes.')
    listing.add_argument('what', choices=('laws', 'scenarios', 'tapes'))
    listing.set_defaults(run=_list)


def _add_bench(commands: argparse._SubParsersAction) -> None:
    bench = commands.add_parser(
        'bench', help='the benchmarks',
        description='Measure the graph against a bare rclpy graph of the same shape, a warm '
                    'flight and the in-process loop; every figure is a ratio within one run.')
    bench.add_argument('--out', metavar='FILE', help='write the figures as JSON')
    bench.set_defaults(run=_bench)


def _fly(args: argparse.Namespace) -> int:
    from rvd_campaign import fly
    return fly.main(args)


def _report(args: argparse.Namespace) -> int:
    from pathlib import Path

    from rvd_campaign.report import write_report
    print(write_report(Path(args.folder)))
    return EXIT_DONE


def _list(args: argparse.Namespace) -> int:
    from rvd_campaign import catalogue
    for name, meaning in catalogue.entries(args.what):
        print(f'{name:<18} {meaning}')
    return EXIT_DONE


def _bench(args: argparse.Namespace) -> int:
    from rvd_campaign import bench
    return bench.main(args)


if __name__ == '__main__':
    sys.exit(main())
