"""Every campaign has its own seed: what two of them find are two findings."""

from collections import Counter

import pytest

from rvd_campaign.campaign.spec import load_campaign
from rvd_campaign.catalogue import entries

PUBLISHED = {'table3': 1}               # its hash and its numbers are: it keeps the seed


@pytest.fixture(scope='module')
def seeds():
    """Return the seeds of each shipped campaign, with that of its confirmation."""
    found = {}
    for name, _ in entries('campaigns'):
        campaign = load_campaign(name)
        found[name] = [campaign.seed, *([campaign.confirm.seed] if campaign.confirm else [])]
    return found


def test_no_two_campaigns_share_a_seed(seeds):
    used = Counter(seed for both in seeds.values() for seed in both)
    assert {seed: count for seed, count in used.items() if count > 1} == {}


def test_what_is_published_keeps_its_seed(seeds):
    assert {name: seeds[name][0] for name in PUBLISHED} == PUBLISHED
