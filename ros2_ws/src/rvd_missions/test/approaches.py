"""Scenarios of the approach for tests: the defaults, and what is changed, section by section."""

from rvd_dynamics.diagram.scenario import parse, Scenario

DEFAULTS = parse('/**: {ros__parameters: {mission: lunar_approach}}', 'test')
PILOT_B = {'skill_gain': 1.0, 'display': False}
PILOT_C = {'skill_gain': 1.77, 'skill_spread': 0.20}
ROUGH = {'loss_fraction': 0.05, 'duplicate_fraction': 0.2, 'corrupt_fraction': 0.1,
         'reorder_fraction': 0.1, 'outage_windows_s': [40.0, 45.0]}


def approach(sections=None, **shared) -> Scenario:
    """Return a scenario; keywords are shared keys, `sections` maps nodes to theirs."""
    scenario = DEFAULTS.with_values('/**', **shared)
    for section, values in (sections or {}).items():
        scenario = scenario.with_values(section, **values)
    return scenario
