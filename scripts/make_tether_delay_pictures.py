"""
Make the pictures of docs/missions/tether_delay.md again, from a flight in process and the folder of
a campaign.

    ./rvd shell python scripts/make_tether_delay_pictures.py CAMPAIGN_FOLDER
"""

from pathlib import Path
import sys
from types import SimpleNamespace

from rvd_campaign.campaign.results import tables
from rvd_campaign.campaign.spec import load_campaign
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.drawing import png
from rvd_dynamics.recording.history import everything, of_history
from rvd_missions.tether_delay.campaign_figures import delays, DRAWN
from rvd_missions.tether_delay.figures import decisions

ROOT = Path(__file__).resolve().parents[1]
IMAGES = ROOT / 'docs' / 'images'

if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    campaign = load_campaign(str(ROOT / 'campaigns' / 'tether_delay.yaml'))
    found = dict(tables(Path(sys.argv[1]) / 'results.parquet', list(DRAWN)))
    png(IMAGES / 'tether_delay_delays.png',
        lambda: delays(SimpleNamespace(campaign=campaign, tables=found))[0])
    scenario = load(ROOT / 'scenarios' / 'tether_delay.yaml')
    run = of_history(scenario, fly(scenario, [0], record=everything(scenario)))
    png(IMAGES / 'tether_delay.png', lambda: decisions(run))
