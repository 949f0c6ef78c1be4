"""The shipped comparison of laws: what its files say is what the laws and the tuning say."""

import numpy as np
import pytest

from rvd_campaign.campaign.spec import load_campaign
from rvd_dynamics.diagram.in_process import fly
from rvd_missions.lunar_approach import tuning


def law_of(condition):
    settings = condition.scenario.settings('auto_controller')
    return settings.law, settings.selected


def test_every_law_flies_with_the_pilot_and_alone_with_the_same_gains():
    campaign = load_campaign('laws')
    modes = {'with pilot': ('shared', 'model'), 'alone': ('auto', 'none')}
    for condition in campaign.conditions[1:]:
        how = next(word for word in modes if condition.name.endswith(word))
        operation = condition.scenario.part('operation')
        assert (operation.mode, operation.operator) == modes[how]
        other = condition.name.replace(how, next(word for word in modes if word != how))
        assert law_of(condition) == law_of(campaign.condition(other))
    assert {law_of(c)[0] for c in campaign.conditions[1:]} == set(tuning.RANGES)


def test_the_tuned_laws_are_the_same_away_from_what_they_were_tuned_on():
    tuned = {c.name: law_of(c) for c in load_campaign('laws').conditions}
    rough = load_campaign('laws_rough')
    assert len(rough.conditions) == 50
    for condition in rough.conditions:
        assert law_of(condition) == tuned[condition.group]


@pytest.mark.parametrize('name', ['laws', 'laws_rough'])
def test_tuned_gains_lie_in_the_ranges_of_the_tuning(name):
    for condition in load_campaign(name).conditions:
        law, gains = law_of(condition)
        if law not in ('safe_apf', 'odrrca') and 'retuned' not in condition.name:
            continue
        for key, (low, high) in tuning.RANGES[law].items():
            found = gains.coasts_s[1] if key == 'coast_s' else gains
            for part in () if key == 'coast_s' else key.split('.'):
                found = getattr(found, part)
            assert low <= found <= high, (condition.name, key)


@pytest.mark.slow
def test_nobody_docks_in_time_with_the_published_gains():
    for condition in load_campaign('laws_published').conditions:
        if condition.scenario.run.timeout_s == 200.0:
            verdict = fly(condition.scenario, range(20)).verdict
            assert not verdict.success.any(), condition.name
            assert np.isin(verdict.reason, ['timeout', 'left_corridor']).all()


@pytest.mark.slow
def test_the_laws_that_fly_by_themselves_do():
    campaign = load_campaign('laws')
    for law in ('barrier retuned', 'safe_apf', 'odrrca'):
        for how in ('with pilot', 'alone'):
            verdict = fly(campaign.condition(f'{law} {how}').scenario, range(40)).verdict
            assert verdict.success.mean() > 0.95, (law, how)
