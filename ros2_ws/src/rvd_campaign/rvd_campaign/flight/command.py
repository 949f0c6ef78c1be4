"""
`./rvd fly`: which way a run is flown: by the graph, for the browser, or again from a campaign.
"""

import argparse

from rvd_campaign.exits import CannotRun, EXIT_DONE, EXIT_FAILED
from rvd_campaign.flight import choice, fly, leftovers, preflight, reach, run_folder, verdict
from rvd_campaign.flight.domain import reserved_domain
from rvd_campaign.interrupts import all_like_ctrl_c
from rvd_dynamics.bad_input import one_line


CONSOLE = {'port': 8480, 'bind': '127.0.0.1', 'tls_cert': '', 'tls_key': '', 'session': None}


def main(args: argparse.Namespace) -> int:
    """Fly one approach as the command line asks; return the exit code."""
    again = None
    if args.pace is None and args.operator in ('console', 'joy'):   # a person flies in real time
        args.pace = 'realtime'
    if args.campaign is not None:
        from rvd_campaign.campaign import again
        if args.in_process:
            return again.in_process(args)
    elif args.condition or args.run_number is not None or args.in_process:
        raise CannotRun('--condition, --run and --in-process go with --from DIR')
    scenario = again.chosen(args) if again else choice.chosen(args)
    scenario.diagram                            # refused now if it must be
    choice.check_foreign(scenario)
    preflight.check()
    open_to = reach.settle(args.network)
    if open_to:
        print(one_line(open_to), flush=True)
    if _for_the_console(args, 'console' in (args.operator, choice.operator_of(scenario))):
        from rvd_campaign.flight import console
        return console.main(args, scenario)
    all_like_ctrl_c()
    with reserved_domain() as domain:           # refused, if it must be, before there is a folder
        run_dir = run_folder.new_folder(args.out, scenario.name)
        domain.held_for(str(run_dir.absolute()))
        run_folder.keep_scenario(run_dir, scenario)
        if removed := leftovers.remove(domain).in_words():
            print(removed, flush=True)
        print(f'{choice.introduced(scenario)}, ROS_DOMAIN_ID={domain}, {run_dir}', flush=True)
        code = fly.Flight(scenario, run_dir, domain, args.headless).fly()
    if again and code in (EXIT_DONE, EXIT_FAILED):
        print(again.compared(args, verdict.read(run_dir / 'verdict.json')), flush=True)
    return code


def _for_the_console(args: argparse.Namespace, wanted: bool) -> bool:
    """
    Give the console's options their defaults if it is wanted, else refuse those that are given.
    """
    for name, usual in CONSOLE.items():
        if getattr(args, name) is None:
            setattr(args, name, usual)
        elif not wanted:
            raise CannotRun(f'--{name.replace("_", "-")} goes with --operator console')
    return wanted
