"""
Settings of every test: fast ones first, and property tests that do not depend on the clock.
"""

import os

from hypothesis import settings
import pytest

# No deadlines, since the cores are shared with the processes of other tests. With CI set, the same
# examples each time.
settings.register_profile('rvd', deadline=None)
settings.register_profile('rvd_ci', deadline=None, derandomize=True, print_blob=True)
settings.load_profile('rvd_ci' if os.environ.get('CI') else 'rvd')


def pytest_collection_modifyitems(config, items):
    """
    Run what is quick to fail first; within fast and slow the order of the files stays.

    Where two run at a time the slow files come first: else one is left alone with them.
    """
    side_by_side = hasattr(config, 'workerinput')
    items.sort(key=lambda item: (item.get_closest_marker('slow') is None) == side_by_side)


@pytest.fixture
def own_domain(monkeypatch):
    """Set ROS_DOMAIN_ID to a domain that no run and no other test has meanwhile; return it."""
    from rvd_campaign.flight.domain import reserved_domain
    monkeypatch.delenv('ROS_DOMAIN_ID', raising=False)
    with reserved_domain() as number:
        monkeypatch.setenv('ROS_DOMAIN_ID', str(number))
        yield number
