"""Scenario texts that nobody means: each loads or is refused in one line, and soon."""

import pytest

from rvd_campaign.bench import hostile_texts
from rvd_campaign.bench.hostile_texts import fault, LARGE_ONES, shipped, text_of
from rvd_dynamics.bad_input import BadInput


def test_hostile_texts_load_or_are_refused_in_one_line():
    wrong = {seed: said for seed in range(200) if (said := fault(text_of(seed)))}
    assert not wrong


@pytest.mark.parametrize('at', range(len(LARGE_ONES)))
def test_large_texts_are_refused_before_they_cost_much(at):
    assert not fault(LARGE_ONES[at](hostile_texts.Random(at)))


def test_a_seed_is_always_the_same_text_and_most_differ():
    assert text_of(7) == text_of(7)
    assert len({text_of(seed) for seed in range(100)} | set(shipped())) > 100


@pytest.mark.parametrize('behaves, said', [
    (lambda text, name: {}[text], 'KeyError'),
    (lambda text, name: hostile_texts.time.sleep(0) or [0] * -1 + 1, 'TypeError'),
    (lambda text, name: (_ for _ in ()).throw(BadInput('')), 'is no line')])
def test_a_loader_that_does_anything_else_is_found(monkeypatch, behaves, said):
    """The negative twin."""
    monkeypatch.setattr(hostile_texts, 'parse', behaves)
    assert said in fault(shipped()[0])


def test_a_loader_that_takes_long_is_found(monkeypatch):
    monkeypatch.setattr(hostile_texts, 'MOST_S', 0.0)
    assert 'it took' in fault(shipped()[0])
