"""Who gives no sign of life, and what is said of it: a stopped process, a hung one, a busy one."""

import pytest

from rvd_campaign.cpu import Usage
from rvd_campaign.flight.vigil import Vigil
from rvd_dynamics.diagram.roster import Process
from rvd_dynamics.pulse import Pulse

PROCESSES = (Process('link', '', '', ('link_back', 'link_forward'), True),
             Process('joy_node', 'joy', 'joy_node', ('joy_node',), False))


class Run:
    """A run of two processes, in a time that the test makes."""

    def __init__(self, spared=()) -> None:
        self.now, self.page, self.does, self.cpu_s = 100.0, Pulse.shared(2), 'S', 0.0
        self.said = []
        self.vigil = Vigil(PROCESSES, self.page, lambda: {'link': 1, 'joy_node': 2}, spared,
                           lambda pid: Usage(self.does, self.cpu_s) if pid == 1 else
                           Usage(self.other, 0.0))
        self.other = 'S'
        self.vigil._looked = self.vigil._since = self.now

    def goes(self, seconds, beats=True, busy=0.0):
        """Let time go by; `busy`: the share of a core that the link uses."""
        for _ in range(round(seconds/0.25)):
            self.now += 0.25
            self.cpu_s += 0.25*busy
            if beats:
                self.page.beat(0, round(1e9*self.now))
            self.said += self.vigil.look(self.now)


@pytest.fixture
def run():
    made = Run()
    made.goes(5.0)
    assert made.said == [] and not made.vigil.silent and not made.vigil.given_up()
    return made


@pytest.mark.parametrize('does, busy, how, patience_s', [
    ('T', 0.0, 'is stopped', 10), ('t', 0.0, 'is stopped', 10), ('S', 0.02, 'hangs', 10),
    ('R', 1.0, 'computes', 120), ('S', 0.9, 'computes', 120), ('D', 0.0, 'computes', 120)])
def test_silence_is_told_once_within_three_seconds_and_given_up_later(
        run, does, busy, how, patience_s):
    run.does = does
    run.goes(1.9, beats=False, busy=busy)
    assert run.said == []
    run.goes(0.6, beats=False, busy=busy)
    told, = run.said
    assert told.startswith('process link (link_back, link_forward) has given no sign of life')
    assert f'it {how}' in told and f'given up after {patience_s} s' in told
    run.goes(patience_s - 3.0, beats=False, busy=busy)
    assert len(run.said) == 1 and not run.vigil.given_up() and run.vigil.waits
    run.goes(1.0, beats=False, busy=busy)
    lost = run.vigil.given_up()
    assert f'no sign of life for {patience_s} s of wall time: it {how}' in run.vigil.in_words(lost)
    assert f'wall time: a owes; it {how}' in run.vigil.in_words(lost, 'a owes; ')


def test_a_process_that_comes_back_is_told_of_and_starts_anew(run):
    run.does = 'T'
    run.goes(6.0, beats=False)
    run.does = 'S'
    run.goes(1.0)
    assert run.said[1] == 'process link (link_back, link_forward) goes on, after 6.0 s'
    assert not run.vigil.waits
    run.goes(1.5, beats=False)
    assert len(run.said) == 2


def test_one_that_computed_and_then_hangs_is_given_up_as_one_that_hangs(run):
    run.goes(20.0, beats=False, busy=1.0)
    assert not run.vigil.given_up()
    run.goes(5.0, beats=False)
    assert 'it hangs' in run.vigil.in_words(run.vigil.given_up())


@pytest.mark.parametrize('notes', [True, False])
def test_one_that_compiles_is_waited_for_and_counts_from_there(run, notes):
    """The negative twin: one that notes nothing is given up after two minutes."""
    for _ in range(6):                          # loops, 40 s each, with a moment between them
        if notes:
            run.page.compile(0, True, round(1e9*run.now))
        run.goes(39.5, beats=False, busy=0.5)
        if notes:
            run.page.compile(0, False, round(1e9*run.now))
        run.goes(0.5, beats=False, busy=0.5)
    assert bool(run.vigil.given_up()) != notes
    told, = run.said                            # once, not for each
    if not notes:
        return
    assert 'it compiles loops, which is done once on a machine; the flight waits' in told
    assert run.vigil.waits and run.vigil.silent['link'].seconds > 200.0
    run.goes(118.0, beats=False, busy=0.5)
    assert not run.vigil.given_up()
    run.goes(2.0, beats=False, busy=0.5)
    assert 'for 120 s of wall time: it computes' in run.vigil.in_words(run.vigil.given_up())


@pytest.mark.parametrize('does, how', [('S', 'hangs'), ('T', 'is stopped')])
def test_one_that_does_nothing_does_not_compile_whatever_it_has_noted(run, does, how):
    run.page.compile(0, True, round(1e9*run.now))
    run.does = does
    run.goes(16.0, beats=False)
    assert f'it {how}' in run.vigil.in_words(run.vigil.given_up())


def test_while_this_process_does_not_run_nobody_is_to_blame(run):
    run.now += 60.0                             # a paused container: all stood still
    run.goes(1.5, beats=False)
    assert run.said == []
    run.goes(1.0, beats=False)
    assert len(run.said) == 1                   # from here on it counts


def test_who_has_not_begun_or_has_done_its_work_need_not_speak(run):
    run.page.leave(0)
    run.goes(30.0, beats=False)
    assert run.said == []


def test_a_foreign_process_is_silent_only_when_it_is_stopped_and_the_flight_goes_on():
    run = Run(spared=['joy_node'])
    run.goes(5.0)
    run.other = 'T'
    run.goes(20.0)
    assert run.said == ['joy_node has given no sign of life for 2.2 s: it is stopped (SIGSTOP, '
                        'or a debugger); the flight goes on without it'] or len(run.said) == 1
    assert not run.vigil.given_up() and not run.vigil.waits
