"""
Make the pictures of docs/laws.md again from two campaigns.

    ./rvd campaign laws --out runs/laws && ./rvd campaign laws_published --out runs/published
    ./rvd shell python scripts/laws_pictures.py runs/laws runs/published
"""

import sys
from pathlib import Path

from rvd_campaign.campaign.report import read
from rvd_dynamics.recording.drawing import png
from rvd_missions.lunar_approach.campaign_figures import comparison

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'

if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    for folder, name in zip(sys.argv[1:], ('laws.png', 'laws_published.png')):
        results = read(Path(folder))
        png(IMAGES / name, lambda: comparison(results)[0])
