"""The start of a run is not given up while loops are compiled, and says that they are."""

from pathlib import Path
import time
from types import SimpleNamespace

import pytest

from rvd_campaign.cpu import Usage
from rvd_campaign.flight import starting, vigil
from rvd_campaign.flight.starting import START_S, Starting
from rvd_dynamics.diagram.roster import listed
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.pulse import Pulse

SCENARIOS = Path(__file__).resolve().parents[4] / 'scenarios'
PACE = 'lockstep'


class Start:
    """The start of a flight of the docking mission, in a time that the test makes."""

    def __init__(self, monkeypatch):
        self.now, self.does = 1000.0, 'R'
        monkeypatch.setattr(time, 'monotonic', lambda: self.now)
        scenario = load(SCENARIOS / 'docking.yaml').with_values('/**', pace=PACE)
        self.roster = listed(scenario, headless=True)
        self.page = Pulse.shared(len(self.roster.processes))
        self.names = [process.name for process in self.roster.processes]
        self.watch = SimpleNamespace(ready=set(self.roster.names) - {'vision'},
                                     is_written=lambda topic: True)
        watched = vigil.Vigil(
            self.roster.processes, self.page, lambda: dict.fromkeys(self.names, 1),
            usage=lambda pid: Usage(self.does, 0.0))
        self.starting = Starting(self.roster, 7, watched)

    def compiles(self, begins):
        self.page.compile(self.names.index('onboard'), begins, round(1e9*self.now))

    def goes(self, seconds):
        """Let time go by; return why the start is given up, where it is."""
        for _ in range(round(seconds)):
            self.now += 1.0
            if why := self.starting.look(self.watch, 0.0):
                return why
        return None


@pytest.fixture
def start(monkeypatch):
    return Start(monkeypatch)


def test_who_is_not_ready_in_time_is_named(start):
    assert start.goes(START_S[PACE] - 1.0) is None
    assert start.goes(3.0) == 'the graph did not come up in 60 s: not ready: vision'
    assert start.starting.news() == '' and 'compiled' not in start.starting.line(3)


def test_what_is_compiled_is_no_part_of_that_time_and_is_said_once(start):
    start.compiles(True)
    assert start.goes(500.0) is None
    assert start.starting.news() == f'{starting.COMPILING}: onboard'
    assert start.starting.news() == ''
    assert start.starting.line(3) == 'starting: 3 of 9 nodes ready; loops are compiled: onboard'
    start.compiles(False)
    assert start.goes(START_S[PACE] - 5.0) is None
    why = start.goes(10.0)
    assert why.startswith('the graph did not come up in 60 s, and 500 s in which loops were '
                          'compiled: not ready: vision')


@pytest.mark.parametrize('does', ['T', 't'])
def test_one_that_is_stopped_does_not_compile(start, does):
    start.compiles(True)
    start.does = does
    assert 'not ready: vision' in start.goes(START_S[PACE] + 2.0)


def test_a_start_that_stood_still_as_a_whole_has_as_long_as_before(start):
    start.now += 1000.0
    assert start.starting.look(start.watch, 1000.0) is None
    assert start.goes(START_S[PACE] - 1.0) is None
