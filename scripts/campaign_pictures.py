"""
Make the pictures of campaigns in docs/images again, from the folder that holds those of campaigns.

    for name in table3 delay eta variants loss loss_cause ablations replicates pilots pilots_delay \
            laws consistency; do
        ./rvd campaign $name --out runs/$name
    done
    ./rvd shell python scripts/campaign_pictures.py runs        # of those that are in there
"""

import sys
from pathlib import Path

from rvd_campaign.campaign.figures import shown_by
from rvd_campaign.campaign.report import read
from rvd_dynamics.recording.drawing import png

IMAGES = Path(__file__).resolve().parents[1] / 'docs' / 'images'
PICTURES = {                    # campaign: its figures, and the picture of each
    'table3': {'success': 'campaign_table3', 'landing': 'campaign_landing'},
    'delay': {'curve': 'campaign_delay'}, 'eta': {'curve': 'campaign_eta'},
    'variants': {'success': 'campaign_variants'}, 'loss': {'curve': 'campaign_loss'},
    'loss_cause': {'curve': 'campaign_loss_cause'},
    'ablations': {'differences': 'campaign_ablations'},
    'pilots': {'ensemble': 'campaign_pilots'}, 'pilots_delay': {'curve': 'campaign_pilots_delay'},
    'replicates': {'replicates': 'campaign_replicates'}, 'laws': {'comparison': 'laws'},
    'consistency': {'consistency': 'campaign_consistency'},
    'docking': {'margins': 'docking-campaign'},
    'docking_alignment': {'curve': 'docking-alignment-campaign'},
    'docking_failures': {'thrusters': 'docking-failures-campaign'},
    'docking_improvements': {'improvements': 'docking-improvements-campaign'}}

if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    for campaign, pictures in PICTURES.items():
        folder = Path(sys.argv[1]) / campaign
        if not folder.is_dir():
            continue
        results = read(folder)
        for name, picture in pictures.items():
            figure = shown_by(results.campaign)[name]
            png(IMAGES / f'{picture}.png', lambda: figure.draw(results)[0])
            print(IMAGES / f'{picture}.png')
