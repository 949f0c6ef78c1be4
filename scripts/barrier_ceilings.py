"""
Print what could be docked in each world of the campaign `barrier`: the two ceilings of its runs.

    ./rvd shell python scripts/barrier_ceilings.py [--runs N]

Each row is of the campaign's own seed, so the rates of the campaign can be held against it.
"""

import argparse

from rvd_campaign.campaign.spec import load_campaign
from rvd_missions.lunar_approach.ceiling import ceiling, first_steps

FORM = 'filter'                         # the worlds are the same for all forms of the law
WORLDS = ('paper', '20 s delay', '30 percent loss')     # others differ in pilot and sensor alone


def main() -> None:
    """Print a row for each world and ceiling."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--runs', type=int, metavar='N')
    campaign = load_campaign('barrier', parser.parse_args().runs)
    print('world, ceiling: starts outside, leaves, refuted, undecided; lowest and highest rate')
    for condition in campaign.conditions:
        world, _, form = condition.name.partition(',barrier=')
        if form != FORM or world not in WORLDS:
            continue
        for name, step in first_steps(condition.scenario).items():
            found = ceiling(condition.scenario, range(campaign.runs), step)
            parts = (found.outside, found.left, found.refuted, found.open)
            print(f'{world}, {name}:', *(int(part.sum()) for part in parts),
                  '; {:.5f} {:.5f}'.format(*found.bounds), flush=True)


if __name__ == '__main__':
    main()
