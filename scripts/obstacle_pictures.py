"""
Make the pictures of docs/missions/obstacle_field.md again, from the first runs of its campaigns.

    ./rvd shell python scripts/obstacle_pictures.py
"""

from pathlib import Path
from types import SimpleNamespace

from rvd_campaign.campaign.spec import load_campaign
from rvd_dynamics.recording.drawing import png
from rvd_missions.obstacle_field.campaign_figures import FIGURES

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'
PICTURES = {                            # file: campaign, figure, and which conditions
    'obstacles_moving': ('obstacle_moving', 'tracks', ('distance', 'probability')),
    'obstacles_static': ('obstacle_static', 'tracks', ('distance', 'probability 0.3 m')),
    'obstacles_corridor': ('obstacle_corridor', 'speeds', ()),
    'obstacles_thrust': ('obstacle_thrust', 'accelerations', (
        'rate 3 s', 'rate2 3 s', 'bang-bang round', 'pulses')),
    'obstacles_near_target': ('obstacle_thrust', 'near_target', (
        'rate 3 s', 'rate2 3 s', 'bang-bang round', 'pulses')),
}


def main() -> None:
    """Draw them all."""
    for name, (campaign, figure, wanted) in PICTURES.items():
        shown = [c for c in load_campaign(campaign).conditions if c.name in wanted or not wanted]
        results = SimpleNamespace(shown=shown, tables={c.name: {'run': [0]} for c in shown})
        png(IMAGES / f'{name}.png', lambda: FIGURES[figure].draw(results)[0], dpi=110)


if __name__ == '__main__':
    main()
