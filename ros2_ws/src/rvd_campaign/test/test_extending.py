"""The example of docs/extending.md is code that works: it is taken from the page and flown."""

import dataclasses
import re

import numpy as np
import pytest

from rvd_campaign import catalogue
from rvd_campaign.loop import fly
from rvd_campaign.scenario import load
from rvd_dynamics.diagram.params import leaves

PAGE = catalogue.root() / 'docs' / 'extending.md'


@pytest.fixture
def my_law():
    blocks = re.findall(r'```python\n(.*?)```', PAGE.read_text(), re.DOTALL)
    names = {'__name__': 'my_law'}
    exec(compile(blocks[0], str(PAGE), 'exec'), names)      # noqa: S102 - our own page
    return names['MyLaw']


def test_law_of_the_page_has_settings_and_flies_better_than_no_law(my_law):
    scenario = load(catalogue.root() / 'scenarios' / 'paper.yaml').with_values(
        '/**', operator='none', mode='auto')
    loop = scenario.loop()
    assert [key for key, _ in leaves(my_law)] == ['stiffness_per_s2', 'damping_per_s']
    ours = fly(dataclasses.replace(loop, law=my_law(loop.mission)), range(100))
    assert np.mean(ours.verdict.success) > 0.9      # nothing done docks in next to none


def test_law_of_the_page_refuses_what_is_impossible(my_law):
    from rvd_dynamics.mission import Mission
    with pytest.raises(ValueError, match='damping_per_s'):
        my_law(Mission(), damping_per_s=-1.0)


def test_every_table_that_the_page_names_exists():
    from rvd_dynamics.link.models import MODELS
    from rvd_dynamics.world.plants.relative import TRUTH_MODELS
    from rvd_dynamics.world.sensors import SENSORS
    from rvd_groundstation.guidance import LAWS
    from rvd_groundstation.prediction.filter import FILTERS
    from rvd_groundstation.sharing import SHARING
    page = PAGE.read_text()
    for name, table in {'MODELS': MODELS, 'TRUTH_MODELS': TRUTH_MODELS, 'SENSORS': SENSORS,
                        'LAWS': LAWS, 'FILTERS': FILTERS, 'SHARING': SHARING}.items():
        assert f'`{name}`' in page and table
