"""Every campaign has its own seed: what two of them find are two findings."""

from collections import Counter

import pytest

from rvd_campaign.campaign.spec import load_campaign
from rvd_campaign.catalogue import entries

SHARED = 1
ONE_RUN = 'its runs are single flights of a published case, of which no rate is claimed'
OWN_PAGE = 'the page of its mission states counts of these very runs'
KEEP = {                                # campaigns that share seed 1, and why
    'table3': 'its hash and its numbers are published',
    'obstacle_corridor': ONE_RUN, 'obstacle_moving': ONE_RUN, 'obstacle_static': ONE_RUN,
    'obstacle_thrust': ONE_RUN, 'splines': ONE_RUN,
    **dict.fromkeys((
        'attitude', 'attitude_delay', 'cluttered', 'docking', 'docking_alignment',
        'docking_failures', 'docking_improvements', 'docking_planners', 'ellipse',
        'obstacle_moving_spread', 'obstacle_smooth', 'obstacle_static_spread', 'tether',
        'tether_delay', 'tether_replan'), OWN_PAGE)}


@pytest.fixture(scope='module')
def seeds():
    """Return the seeds of each shipped campaign, with that of its confirmation."""
    found = {}
    for name, _ in entries('campaigns'):
        campaign = load_campaign(name)
        found[name] = [campaign.seed, *([campaign.confirm.seed] if campaign.confirm else [])]
    return found


def test_no_two_campaigns_share_a_seed_but_those_that_are_listed(seeds):
    used = Counter(seed for name, both in seeds.items() if name not in KEEP for seed in both)
    assert {seed: count for seed, count in used.items() if count > 1 or seed == SHARED} == {}


def test_the_list_holds_what_shares_the_seed_and_nothing_else(seeds):
    assert {name for name, both in seeds.items() if SHARED in both} == set(KEEP)


def test_single_flights_are_single(seeds):
    for name in (name for name, why in KEEP.items() if why == ONE_RUN):
        assert load_campaign(name).runs == 1
