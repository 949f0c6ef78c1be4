"""
Make the pictures of docs/missions/attitude_hold.md again, from a run, a campaign and the studies.

    ./rvd fly attitude --seed 1 --out runs/held && ./rvd campaign attitude --out runs/faults
    ./rvd shell python scripts/make_attitude_pictures.py runs/held runs/faults
"""

import sys
from pathlib import Path
from types import SimpleNamespace

from rvd_dynamics.recording.drawing import png
from rvd_dynamics.recording.reader import read
from rvd_missions.attitude_hold import comparison, studies
from rvd_missions.attitude_hold.campaign_figures import comparison as compared
from rvd_missions.attitude_hold.figures import attitude, law

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'

if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    run = read(Path(sys.argv[1]))
    tables = comparison.read(Path(sys.argv[2]))
    png(IMAGES / 'attitude.png', lambda: attitude(run))
    png(IMAGES / 'attitude-law.png', lambda: law(run))
    png(IMAGES / 'attitude-comparison.png', lambda: compared(SimpleNamespace(tables=tables))[0])
    studies.main('all', IMAGES)
