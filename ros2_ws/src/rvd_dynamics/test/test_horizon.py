"""How far ahead a step can be, by what the plant has noted or by the clock."""

from dataclasses import replace

import pytest

from rvd_dynamics.diagram.ros.horizon import AHEAD, Horizon
from rvd_dynamics.diagram.run import Run

RUN = replace(Run(step_s=0.1, timeout_s=600.0), pace='realtime')


def backlog(steps, every):
    """Return the steps of two topics, the slow one of every so many, read in turn."""
    slow = range(0, steps, every)
    for i in range(steps):
        yield from ((slow[i],) if i < len(slow) else ())
        yield i


def test_a_reader_of_many_topics_that_is_behind_loses_none():
    behind = Horizon(RUN, 6000, made=lambda: 200)
    assert all(behind.believes(step, step) for step in backlog(201, 5))
    assert behind.believes(200 + AHEAD) and not behind.believes(201 + AHEAD)


def test_by_the_clock_alone_it_would():
    assert not all(list(map(Horizon(RUN, 6000).believes, backlog(201, 50))))


@pytest.mark.parametrize('noted', [-1, 0, 37])
def test_steps_that_come_one_after_the_other_carry_a_reader_no_further(noted):
    horizon = Horizon(RUN, 6000, made=lambda: noted)
    believed = [step for step in range(1000) if horizon.believes(step, step)]
    assert believed == list(range(max(noted, 0) + AHEAD + 1))
