"""
Make the pictures of docs/missions/docking.md again, from a run.

    ./rvd fly docking --processes one --out runs/docked
    ./rvd shell python scripts/make_docking_pictures.py runs/docked
"""

import sys
from pathlib import Path

from rvd_dynamics.recording.drawing import png
from rvd_dynamics.recording.reader import read
from rvd_missions.docking.figures import approach, navigation

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'

if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    run = read(Path(sys.argv[1]))
    png(IMAGES / 'docking.png', lambda: approach(run))
    png(IMAGES / 'docking-navigation.png', lambda: navigation(run))
