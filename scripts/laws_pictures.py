"""
Make the picture of docs/laws.md again from its campaign.

    ./rvd campaign laws --out runs/laws && ./rvd shell python scripts/laws_pictures.py runs/laws
"""

import sys
from pathlib import Path

from rvd_campaign.campaign.report import read
from rvd_dynamics.recording.drawing import png
from rvd_missions.lunar_approach.campaign_figures import comparison

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'

if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    results = read(Path(sys.argv[1]))
    png(IMAGES / 'laws.png', lambda: comparison(results)[0])
