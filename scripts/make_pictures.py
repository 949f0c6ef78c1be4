"""
Make the picture of the README again from a run.

    ./rvd fly --out runs/picture && ./rvd shell python scripts/make_pictures.py runs/picture
"""

import sys
from pathlib import Path

from rvd_dynamics.recording.drawing import png
from rvd_dynamics.recording.reader import read
from rvd_missions.lunar_approach.figures import approach

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'

if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    IMAGES.mkdir(parents=True, exist_ok=True)
    run = read(Path(sys.argv[1]))
    png(IMAGES / 'approach.png', lambda: approach(run))
