"""
Make the pictures of the campaigns in docs/missions/docking.md again, from the folders of campaigns.

    for name in docking docking_alignment docking_failures docking_improvements; do
        ./rvd campaign $name --out runs/$name
    done
    ./rvd shell python scripts/docking_campaign_pictures.py runs
"""

import sys
from pathlib import Path

from rvd_campaign.campaign.figures import shown_by
from rvd_campaign.campaign.report import read
from rvd_dynamics.recording.drawing import png

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'
NAMES = ('docking', 'docking_alignment', 'docking_failures', 'docking_improvements')

if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    for name in NAMES:
        if not (Path(sys.argv[1]) / name).is_dir():
            continue
        results = read(Path(sys.argv[1]) / name)
        for figure in shown_by(results.campaign).values():
            png(IMAGES / f'{name.replace("_", "-")}-campaign.png', lambda: figure.draw(results)[0])
