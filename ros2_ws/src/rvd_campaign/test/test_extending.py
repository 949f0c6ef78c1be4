"""The example of docs/extending.md is code that works: it is taken from the page and flown."""

from dataclasses import replace
import re
import sys
import types

import numpy as np
import pytest

from rvd_campaign import catalogue
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.params import leaves
from rvd_dynamics.diagram.scenario import load, Scenario

PAGE = catalogue.root() / 'docs' / 'extending.md'


def of_the_page(name, module_name, monkeypatch):
    """Return a class that the page writes out, in a module of its own."""
    blocks = re.findall(r'```python\n(.*?)```', PAGE.read_text(), re.DOTALL)
    whole, = (block for block in blocks if f'class {name}' in block)
    module = types.ModuleType(module_name)
    monkeypatch.setitem(sys.modules, module_name, module)
    exec(compile(whole, str(PAGE), 'exec'), vars(module))   # noqa: S102 - our own page
    return getattr(module, name)


@pytest.fixture
def my_law(monkeypatch):
    return of_the_page('MyLaw', 'my_law', monkeypatch)


@pytest.fixture
def my_pilot(monkeypatch):
    return of_the_page('MyPilot', 'my_pilot', monkeypatch)


def test_law_of_the_page_has_settings_and_flies_better_than_no_law(my_law):
    scenario = load(catalogue.root() / 'scenarios' / 'paper.yaml').with_values(
        '/**', operator='none', mode='auto')
    assert [key for key, _ in leaves(my_law)] == ['stiffness_per_s2', 'damping_per_s']
    sys.modules['my_law'].law = lambda scenario: scenario.wired(my_law())       # for LAWS
    mission = replace(scenario.mission, parts={**scenario.mission.parts, 'law': 'my_law:law'})
    ours = fly(Scenario('ours', mission, scenario.sections), range(100))
    assert np.mean(ours.verdict.success) > 0.9      # nothing done docks in next to none


def test_law_of_the_page_refuses_what_is_impossible(my_law):
    with pytest.raises(ValueError, match='damping_per_s'):
        my_law(damping_per_s=-1.0)


def test_pilot_of_the_page_flies_and_leaves_no_rate_that_he_minds(my_pilot):
    scenario = load(catalogue.root() / 'scenarios' / 'paper.yaml').with_values(
        '/**', mode='manual')
    sys.modules['my_pilot'].pilot = lambda scenario: scenario.wired(my_pilot())     # for PILOTS
    mission = replace(scenario.mission,
                      parts={**scenario.mission.parts, 'pilot': 'my_pilot:pilot'})
    flown = fly(Scenario('mine', mission, scenario.sections), range(40),
                record=['/truth/relative_state'])
    rate = np.abs(flown.history['/truth/relative_state'].state[..., 4:])
    # The drift of the start has a deviation of 0.01 m/s. Full thrust for one step changes the
    # rate by 0.01 m/s, and he sees a state 10 s ahead with an error of a few mm/s.
    assert np.nanmax(rate[-40:]) < 0.02 + 0.01 + 0.01


def test_every_table_that_the_page_names_exists():
    from rvd_dynamics.link.models import MODELS
    from rvd_dynamics.world.plants.relative import TRUTH_MODELS
    from rvd_dynamics.world.sensors import SENSORS
    from rvd_groundstation.guidance import LAWS
    from rvd_groundstation.operators.pilot import PERSONS, PILOTS
    from rvd_groundstation.prediction.filter import FILTERS
    from rvd_groundstation.sharing import SHARING
    page = PAGE.read_text()
    for name, table in {'MODELS': MODELS, 'TRUTH_MODELS': TRUTH_MODELS, 'SENSORS': SENSORS,
                        'LAWS': LAWS, 'FILTERS': FILTERS, 'SHARING': SHARING, 'PILOTS': PILOTS,
                        'PERSONS': PERSONS}.items():
        assert f'`{name}`' in page and table
