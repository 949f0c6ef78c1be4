"""
The one command: `./rvd CMD` comes here for everything that is Python.

Exit codes: 0 done (for `fly`: success), 1 flown and failed, 2 could not run, 3 a fault of this
software, 130 Ctrl-C. Bad input is one line on stderr and exit code 2; a fault keeps its traceback.
"""

import argparse
import sys
import traceback
from typing import Any

from rvd_campaign.exits import (
    CannotRun, check_open_files, EXIT_CANNOT, EXIT_DONE, EXIT_FAULT, EXIT_INTERRUPTED,
    lacks_temporary, OF_THE_DISK)
from rvd_campaign.interrupts import ctrl_c_heard, has_come
from rvd_campaign.output import keep_going
from rvd_dynamics.bad_input import BadInput, one_line, shortened


class Parser(argparse.ArgumentParser):
    """A parser that says what is wrong in one line."""

    def error(self, message: str) -> None:
        """Print one line and exit with code 2."""
        self.exit(EXIT_CANNOT, f'{self.prog}: {one_line(message)} (see {self.prog} --help)\n')

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> tuple:
        """
        Refuse words that are empty, as an unset variable of a shell leaves them, or no text.

        An empty word would count as one that is not given; ROS and YAML take nothing but text.
        """
        found, rest = super().parse_known_args(args, namespace)
        for action in self._actions:
            value = getattr(found, action.dest, None)
            if not isinstance(value, str) or value == action.default:
                continue
            name = '/'.join(action.option_strings) or action.metavar
            if not value:
                self.error(f'argument {name}: is empty')
            if not _is_text(value):
                self.error(f'argument {name}: {value!r} is not UTF-8: give the file another name')
        return found, rest


def _is_text(word: str) -> bool:
    try:
        word.encode()
    except UnicodeEncodeError:
        return False
    return True


def main(argv: list[str] | None = None) -> int:
    """Run one command and return its exit code."""
    keep_going()
    args = parser().parse_args(argv)
    try:
        check_open_files()
        with ctrl_c_heard():
            return args.run(args)
    except (CannotRun, BadInput) as error:
        print(f'rvd {args.command}: {error}', file=sys.stderr)
        return EXIT_CANNOT
    except KeyboardInterrupt:
        return EXIT_INTERRUPTED
    except Exception as error:                  # noqa: B902 - a fault of ours keeps its traceback
        if isinstance(error, OSError) and error.errno in OF_THE_DISK:
            where = '' if error.filename is None else f'{error.filename}: '
            print(f'rvd {args.command}: {shortened(one_line(where))}{error.strerror}',
                  file=sys.stderr)
            return EXIT_CANNOT
        if lacks_temporary(error):
            print(f'rvd {args.command}: no folder for temporary files can be written: set TMPDIR '
                  'to one that can', file=sys.stderr)
            return EXIT_CANNOT
        if has_come():                          # a library that it has cut short says anything
            return EXIT_INTERRUPTED
        traceback.print_exc()
        print(f'rvd {args.command}: {type(error).__name__}: a fault of this software, not of what '
              'it was given: please report it with the lines above', file=sys.stderr)
        return EXIT_FAULT


def parser() -> argparse.ArgumentParser:
    """Return the parser of all commands; each is imported when it runs."""
    top = Parser(prog='rvd', description='Teleoperated rendezvous and docking ground loop.')
    commands = top.add_subparsers(dest='command', metavar='COMMAND', required=True,
                                  parser_class=Parser)
    _add_fly(commands)
    _add_report(commands)
    _add_campaign(commands)
    _add_calibrate(commands)
    _add_list(commands)
    _add_stick(commands)
    _add_limit_cycles(commands)
    _add_bench(commands)
    return top


def _add_fly(commands: argparse._SubParsersAction) -> None:
    fly = commands.add_parser(
        'fly', help='fly one approach over DDS',
        description='Bring up the node graph, fly one approach, print the verdict and leave a run '
                    'folder with bag/, verdict.json, scenario.yaml, report.html and logs/.',
        epilog='Exit codes: 0 success, 1 flown and failed, 2 could not run, 3 a fault of this '
               'software, 130 Ctrl-C.')
    fly.add_argument('scenario', nargs='?', metavar='SCENARIO',
                     help='name from `rvd list scenarios`, or a file (default: paper; with '
                          '--operator console: hand)')
    fly.add_argument('--mode', help='who decides: shared, manual, auto, or a mode of the mission '
                                    '(default: that of the scenario)')
    fly.add_argument('--processes', choices=('blocks', 'segments', 'one'),
                     help='how nodes share processes: each its own, one for each segment (space, '
                          'link, ground ...), or all in one, the fastest (default: the scenario, '
                          'else blocks)')
    fly.add_argument('--operator', choices=('model', 'replay', 'console', 'joy', 'none'),
                     help='the pilot (default: that of the scenario, else model); a mission '
                          'without one can be watched by console')
    fly.add_argument('--tape', metavar='FILE',
                     help='with --operator replay: name from `rvd list tapes`, CSV file or bag')
    fly.add_argument('--tape-topic', metavar='TOPIC',
                     help='with --tape BAG: the topic of sensor_msgs/Joy to replay (default: /joy)')
    fly.add_argument('--pace', metavar='lockstep|realtime|FACTOR',
                     help='lockstep: as fast as possible; realtime; or FACTOR times real time '
                          '(default: the scenario, else 10; realtime for a person at a stick)')
    fly.add_argument('--seed', type=int, metavar='N', help='seed of every random stream')
    fly.add_argument('--out', metavar='DIR',
                     help='run folder, must not exist yet (default: runs/<time>-<scenario>)')
    fly.add_argument('--from', dest='campaign', metavar='DIR',
                     help='fly a run of this campaign folder again, with --condition and --run')
    fly.add_argument('--condition', metavar='NAME', help='with --from: the condition')
    fly.add_argument('--run', type=int, metavar='K', dest='run_number',
                     help='with --from: the number of the run')
    fly.add_argument('--in-process', action='store_true',
                     help='with --from: without DDS, only to check that the verdict is the same')
    fly.add_argument('--headless', action='store_true',
                     help='no live progress and no markers for viewers')
    fly.add_argument('--network', action='store_true',
                     help='let other machines reach the nodes: without it they are heard on this '
                          'machine alone')
    console = fly.add_argument_group('with --operator console')
    console.add_argument('--port', type=int, metavar='N',
                         help='port of the page (default: 8480; 0: any free port)')
    console.add_argument('--bind', metavar='ADDRESS',
                         help='address of the page (default: 127.0.0.1); any but 127.0.0.1 '
                              'needs TLS')
    console.add_argument('--tls-cert', metavar='FILE', help='TLS certificate')
    console.add_argument('--tls-key', metavar='FILE', help='key of the certificate')
    console.add_argument('--session', metavar='FILE',
                         help='lead a volunteer through the flights of a session file')
    fly.set_defaults(run=_fly)


def _add_report(commands: argparse._SubParsersAction) -> None:
    report = commands.add_parser(
        'report', help='make the report of a run or a campaign again',
        description='Write report.html of a run from its bag alone, or of a campaign from its '
                    'results.')
    report.add_argument('folder', metavar='RUN',
                        help='a run, a bag, a campaign or a session folder')
    report.set_defaults(run=_report)


def _add_campaign(commands: argparse._SubParsersAction) -> None:
    campaign = commands.add_parser(
        'campaign', help='fly thousands of approaches in process',
        description='Fly every condition of a campaign in paired runs, and leave a folder with '
                    'results.parquet, summary.json and report.html. Finished runs are never '
                    'flown again: stop at any moment and continue with --resume.',
        epilog='Exit codes: 0 done, 2 could not run, 130 Ctrl-C (continue with --resume).')
    campaign.add_argument('campaign', nargs='?', metavar='CAMPAIGN',
                          help='name from `rvd list campaigns`, or a file')
    campaign.add_argument('--runs', type=int, metavar='N', help='runs per condition')
    campaign.add_argument('--workers', type=int, metavar='N',
                          help='processes that fly (default: one per core)')
    campaign.add_argument('--batch', type=int, metavar='N',
                          help='runs that are flown together; does not change the result')
    campaign.add_argument('--out', metavar='DIR',
                          help='folder, must not exist yet (default: runs/<time>-<campaign>)')
    campaign.add_argument('--resume', metavar='DIR', help='continue the campaign of this folder')
    campaign.add_argument('--backend', choices=('local', 'dask', 'ray'), default='local',
                          help='processes of this machine, or a Dask or Ray cluster')
    campaign.add_argument('--scheduler', metavar='ADDRESS', help='of the cluster: tcp://HOST:PORT')
    campaign.set_defaults(run=_campaign)


def _add_calibrate(commands: argparse._SubParsersAction) -> None:
    calibrate = commands.add_parser(
        'calibrate', help='fit the pilot to condition 1',
        description='Fit the free numbers of a pilot to the statistics of manual flights, say '
                    'what these can and cannot identify, and write a pilot file.')
    calibrate.add_argument('pilot', nargs='?', default='A', metavar='PILOT',
                           help='pilot to start from: A, B, C or a pilot file (default: A)')
    calibrate.add_argument('--free', metavar='NAME[,NAME]',
                           help='numbers to fit (default: skill_gain; without display '
                                'no_display_trust)')
    calibrate.add_argument('--runs', type=int, default=4000, metavar='N',
                           help='runs for each evaluation of a pilot (default: 4000)')
    calibrate.add_argument('--seed', type=int, default=7, metavar='N',
                           help='seed of the draws (default: 7; the shipped campaigns have 1)')
    calibrate.add_argument('--scenario', default='paper', metavar='SCENARIO')
    calibrate.add_argument('--workers', type=int, metavar='N',
                           help='processes that fly (default: one per core)')
    calibrate.add_argument('--quick', action='store_true',
                           help='fit only, and do not study what is identifiable')
    calibrate.add_argument('--out', metavar='FILE', help='pilot file to write, must not exist yet')
    calibrate.set_defaults(run=_calibrate)


def _add_list(commands: argparse._SubParsersAction) -> None:
    listing = commands.add_parser('list', help='list what there is to choose from',
                                  description='List missions, laws, scenarios, tapes or campaigns.')
    listing.add_argument('what', choices=('missions', 'laws', 'scenarios', 'tapes', 'campaigns'))
    listing.set_defaults(run=_list)


def _add_stick(commands: argparse._SubParsersAction) -> None:
    stick = commands.add_parser(
        'stick', help='show a live stick, set it up and write its settings',
        description='Show the axes and buttons of a stick and the levels that they command, or why '
                    'they do not count; with --set-up ask for the axes and the dead-man button.')
    stick.add_argument('scenario', nargs='?', default='paper', metavar='SCENARIO',
                       help='whose stick settings are used (default: paper)')
    stick.add_argument('--layout', metavar='NAME', help='use a layout instead: xbox, ps4, ps5 ...')
    stick.add_argument('--set-up', action='store_true',
                       help='ask for x+, y+, z+ and the dead-man, and print the settings')
    stick.add_argument('--write', metavar='FILE',
                       help='write the settings as a scenario, which must not exist yet')
    stick.add_argument('--topic', metavar='TOPIC',
                       help='look at what another node publishes, such as /joy')
    stick.add_argument('--device-id', type=int, metavar='N', help='number of the stick')
    stick.add_argument('--device-name', metavar='NAME', help='name of the stick')
    stick.add_argument('--once', action='store_true', help='one picture, then end')
    stick.set_defaults(run=_stick)


def _add_limit_cycles(commands: argparse._SubParsersAction) -> None:
    from rvd_campaign import limit_cycles
    cycles = commands.add_parser(
        'limit-cycles', help='limit cycles of range-rate control on elliptic orbits',
        description='Compute the limit cycle of the direction angle, its multipliers and the '
                    'approach corridor, or follow a branch of cycles in a parameter.')
    limit_cycles.add_arguments(cycles)
    cycles.set_defaults(run=_limit_cycles)


def _add_bench(commands: argparse._SubParsersAction) -> None:
    bench = commands.add_parser(
        'bench', help='measure the speed on this machine',
        description='Measure the graph against a hollow rclpy graph of the same shape, a warm '
                    'flight and the in-process loop, and say which targets are met. Leave the '
                    'machine alone meanwhile.')
    bench.add_argument('part', nargs='?', default='all',
                       choices=('graph', 'flight', 'loop', 'campaign', 'laws', 'tether', 'docking',
                                'leak', 'console', 'attack', 'all'),
                       help='what to measure (default: all but leak, which flies for half '
                            'an hour, console, which needs Chromium, and attack, which takes a '
                            'night: about four minutes)')
    bench.add_argument('kinds', nargs='*', metavar='KIND',
                       help='with attack: frames, messages, dds, bags, texts, kills or flights '
                            '(default: all)')
    bench.add_argument('--count', type=int, metavar='N', help='with attack: how many of each kind')
    bench.add_argument('--seed', type=int, metavar='SEED',
                       help='with attack: of the first one (default: 0); with --count 1, that one '
                            'alone')
    bench.add_argument('--quick', action='store_true', help='one repetition each, small batches')
    bench.add_argument('--before', metavar='DIR',
                       help='graph and campaign: measure against this checkout, which is set up')
    bench.add_argument('--out', metavar='FILE', help='write the figures as JSON')
    bench.set_defaults(run=_bench)


def _fly(args: argparse.Namespace) -> int:
    from rvd_campaign.flight import command
    return command.main(args)


def _report(args: argparse.Namespace) -> int:
    from pathlib import Path

    folder = Path(args.folder)
    if (folder / 'session.json').is_file():
        from rvd_campaign.report.people import write_session_report
        print(write_session_report(folder))
        return EXIT_DONE
    if (folder / 'campaign.json').is_file():
        from rvd_campaign.campaign.report import write_campaign_report
        print(write_campaign_report(folder))
        return EXIT_DONE
    from rvd_campaign.report.run import write_report
    print(write_report(folder))
    return EXIT_DONE


def _campaign(args: argparse.Namespace) -> int:
    from rvd_campaign.campaign import command
    return command.main(args)


def _calibrate(args: argparse.Namespace) -> int:
    from rvd_campaign.campaign import calibrate
    return calibrate.main(args)


def _list(args: argparse.Namespace) -> int:
    from rvd_campaign import catalogue
    for name, meaning in catalogue.entries(args.what):
        print(f'{name:<18} {meaning}')
    return EXIT_DONE


def _stick(args: argparse.Namespace) -> int:
    from rvd_campaign.flight import preflight, reach
    preflight.check()                           # before ROS is loaded, which may end the process
    reach.settle()
    from rvd_campaign.flight import stick
    return stick.main(args)


def _limit_cycles(args: argparse.Namespace) -> int:
    from rvd_campaign import limit_cycles
    return limit_cycles.main(args)


def _bench(args: argparse.Namespace) -> int:
    from rvd_campaign import bench
    return bench.main(args)


if __name__ == '__main__':
    sys.exit(main())
