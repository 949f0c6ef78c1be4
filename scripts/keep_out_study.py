"""
Fly the barrier against pilots who mean ill, on many more maps than the tests do; see
docs/cluttered.md.

    ./rvd shell python scripts/keep_out_study.py LOST FIRST_MAP MAPS

with LOST FIRST_MAP MAPS of 0 1000 60, 1 5000 120 and 2 1000 60.
"""

import sys
from pathlib import Path

import numpy as np

TESTS = Path(__file__).resolve().parents[1] / 'ros2_ws' / 'src' / 'rvd_groundstation' / 'test'
STEPS, STARTS = 200, 60                 # of each map


def main(lost: int, first: int, maps: int) -> None:
    """Print, by pilot, how many flew, how many touched something, and the least clearance [m]."""
    sys.path.insert(0, str(TESTS))
    import test_keep_out as t
    stop = t.stop_for(lost_commands=lost)
    for pilot in t.PILOTS:
        gaps = []
        for number in range(maps):
            state, places, radii = t.feasible(first + number, stop, [0.0]*6, rows=STARTS)
            law = t.barrier(places, radii, stop)
            gaps.append(t.flown(law, places, radii, state, pilot, [0.0]*6, lambda k: 0.0, STEPS,
                                number, lost))
        gap = np.concatenate(gaps)
        print(f'{pilot}: {len(gap)} flights, {np.count_nonzero(gap <= 0.0)} contacts, '
              f'least clearance {gap.min():.4f} m')


if __name__ == '__main__':
    if len(sys.argv) != 4:
        sys.exit(__doc__.strip())
    main(*map(int, sys.argv[1:]))
