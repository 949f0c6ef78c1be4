"""The recording of a flight over DDS is that of its in-process history, to the last bit."""

from dataclasses import fields
import re

import numpy as np
import pytest
from runs import ROOT

from rvd_campaign.report.figures import figures_of
from rvd_dynamics.diagram import in_process
from rvd_dynamics.recording.drawing import svg
from rvd_dynamics.recording.history import everything, of_history
from rvd_dynamics.recording.reader import read

# What the guard says of a command it reads off the bytes of its frame, which only the graph has.
OF_BYTES = {('/onboard/thruster_command', column) for column in (
    'sequence', 'reason', 'decided_by')}


@pytest.fixture(params=['flight', 'rough_flight'], scope='module')
def both(request):
    """The recording of a bag, and that of the same run in process, flown beside another."""
    bag = read(request.getfixturevalue(request.param).run)
    run = bag.scenario.run.run
    batch = in_process.fly(bag.scenario, [run + 1, run], record=everything(bag.scenario))
    return bag, of_history(bag.scenario, batch, 1)


def columns(series):
    """Yield the columns of a series by name."""
    for field in fields(series):
        value = getattr(series, field.name)
        named = value.items() if isinstance(value, dict) else [(field.name, value)]
        yield from named


def test_they_have_the_same_topics(both):
    bag, history = both
    assert set(history.series) == set(bag.series)
    assert all(history.counts[topic] == bag.counts[topic] for topic in history.series)
    assert history.kinds == {topic: bag.kinds[topic] for topic in history.series}


def test_every_column_of_every_series_is_equal_to_the_bit(both):
    bag, history = both
    unknown = set()
    for topic, series in history.series.items():
        assert type(series) is type(bag.of(topic))
        recorded = dict(columns(bag.of(topic)))
        assert list(recorded) == [name for name, _ in columns(series)]
        for name, column in columns(series):
            if column is None:
                unknown.add((topic, name))
                continue
            assert column.dtype == recorded[name].dtype, (topic, name)
            np.testing.assert_array_equal(column, recorded[name], err_msg=f'{topic} {name}')
    assert unknown == OF_BYTES


def test_they_say_the_same_about_the_run(both):
    bag, history = both
    assert repr(history.verdict) == repr(bag.verdict)       # NaN too
    assert history.scenario_text == bag.scenario_text
    assert (history.last_step, history.ended, history.judged) == (bag.last_step, True, bag.judged)
    assert [(link.name, link.hold_s, link.upward) for link in history.links.values()] == [
        (link.name, link.hold_s, link.upward) for link in bag.links.values()]


def test_their_figures_are_the_same_drawing(both):
    bag, history = both
    assert list(figures_of(history)) == list(figures_of(bag))
    for name, figure in figures_of(bag).items():
        assert svg(name, lambda: figure.draw(history)) == svg(name, lambda: figure.draw(bag))


def test_the_example_of_the_page_runs_as_it_stands(flight, tmp_path, monkeypatch):
    page = (ROOT / 'docs' / 'report.md').read_text(encoding='utf-8')
    code = re.search(r'```python\n(.*?)```', page, re.S)[1]
    (tmp_path / 'runs').mkdir()
    (tmp_path / 'runs' / 'picture').symlink_to(flight.run)
    (tmp_path / 'scenarios').symlink_to(ROOT / 'scenarios')
    monkeypatch.chdir(tmp_path)
    exec(code, {})
    assert (tmp_path / 'approach.png').read_bytes()[1:4] == b'PNG'
