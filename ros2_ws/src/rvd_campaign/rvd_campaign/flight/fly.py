"""
Fly one approach by the graph: bring it up, follow it, say how it went, leave a run folder.
"""

import contextlib
import importlib
import os
import shutil
import sys
import threading
import time
from pathlib import Path
from typing import Any, Callable

from rvd_campaign import catalogue
from rvd_campaign.flight import kept, room, verdict, vigil
from rvd_dynamics.bad_input import one_line
from rvd_dynamics.recording import drawing, flown, reader
from rvd_campaign.exits import (
    EXIT_CANNOT, EXIT_DONE, EXIT_FAILED, EXIT_FAULT, EXIT_INTERRUPTED)
from rvd_dynamics.diagram.identity import new_run
from rvd_dynamics.diagram.judge import ABORTED
from rvd_dynamics.diagram.roster import (
    ENDED_EARLY, GIVEN_UP, listed, MONITOR, SECOND_WRITER, SILENT)
from rvd_dynamics.diagram.scenario import Scenario
from rvd_campaign.interrupts import uninterrupted
from rvd_campaign.flight.starting import Starting
from rvd_campaign.flight.supervisor import Supervisor
from rvd_campaign.flight.vigil import STALL_S, Vigil
from rvd_campaign.report.attempt import attempt

END_S = 15.0                    # [s] wall time for the nodes to end after the verdict
SHOW_S = 0.2                    # [s] wall time between two looks
STOPPED_S = 5.0                 # [s] wall time without a look: this process did not run


class _Stopped(KeyboardInterrupt):
    """A page of the console has ended the run."""


class Flight:
    """One run under supervision."""

    def __init__(self, scenario: Scenario, run_dir: Path, domain: int, headless: bool,
                 stop_asked: Callable[[], bool] = lambda: False, console: bool = False,
                 known: Callable[[int], None] = lambda code: None,
                 progress: Callable[[str], None] = lambda words: None) -> None:
        """
        Start the processes.

        `stop_asked` says whether a page wants the run to end; `known` is told the exit code once
        the run folder has its bag and its verdict, before the report is drawn; `progress` is told
        in words how many nodes are ready.
        """
        self._scenario = scenario
        self._run = scenario.run
        self._roster = listed(scenario, headless, console)
        self._run_dir, self._domain = run_dir, domain
        self._headless = headless
        self._stop_asked, self._known, self._progress = stop_asked, known, progress
        self._run_id = new_run()
        self.problem = ''                       # why the run could not be flown
        self.ended_by = ''                      # who ended it before its end, in words
        self._fault = False                     # of this software: not what it was given
        self._supervisor = Supervisor(
            catalogue.root() / 'scripts' / 'bringup.sh', run_dir / 'scenario.yaml', run_dir,
            headless, domain, self._roster, self._run_id)
        try:
            if scenario.run.processes == 'one':     # a core is idle while the one process starts
                threading.Thread(target=_load_the_report, daemon=True).start()
            os.environ['ROS_LOG_DIR'] = str(run_dir.resolve() / 'logs')     # and not ~/.ros
            from rvd_campaign.flight.watch import FlightWatch   # imports ROS while the nodes do
            self._watch = FlightWatch(self._roster, domain, self._run_id,
                                      self._supervisor.told,
                                      self._supervisor.pulse)
        except BaseException:                       # Ctrl-C, too
            self._supervisor.stop()
            raise
        self._vigil = Vigil(
            self._roster.processes, self._supervisor.pulse, self._supervisor.left,
            [name for name, e in self._roster.externals.items() if e.foreign or e.viewer])
        self._starting = Starting(self._roster, domain, self._vigil)
        self._early: list[str] = []             # who ended before the run was over
        self._silences: list[dict[str, Any]] = []           # what was said of processes, and when
        self._shown_at, self._shown = 0.0, ''
        self._on_line = False

    def fly(self) -> int:
        """Follow the run to its end; every process has ended when this returns."""
        problem, interrupted, stopped = None, False, False
        try:
            problem = self._follow()
            if problem is not None:             # the bag ends with it, where there still is one
                self.problem = problem
                self._supervisor.pulse.say(GIVEN_UP, self._step, problem)
        except KeyboardInterrupt as how:
            interrupted, stopped = True, isinstance(how, _Stopped)
        finally:
            with uninterrupted():
                self._supervisor.stop()
                self._watch.spin(0.1)
                self._watch.close()
                self._end_line()
                room.give(self._run_dir)        # whoever could have taken it has ended
        if problem is not None:
            print(f'rvd fly: {problem}', file=sys.stderr)
            if set(self._supervisor.failures().values()) != {EXIT_CANNOT}:      # that says it all
                print(f'rvd fly: logs are in {self._run_dir / "logs"}', file=sys.stderr)
            self._keep_given_up(problem)
            code = EXIT_FAULT if self._fault else EXIT_CANNOT
            self._known(code)
            return code
        last, links = self._outcome()
        judged = verdict.outcome(last, interrupted, stopped=stopped)
        held = self._kept(last)
        from rvd_campaign.flight import second_opinion          # imports ROS, by now loaded
        if stopped and second_opinion.was_aborted(self._run_dir, self._scenario):
            judged = judged._replace(reason=ABORTED, words=verdict.STOPPED_ABORTED)
        self.ended_by = judged.words if stopped else ''
        doubts, trust = second_opinion.asked(
            self._run_dir, self._scenario, None if interrupted else last, self._watch.strangers)
        content = verdict.as_dict(judged, links, self._scenario, held) | trust
        content['silences'] = self._silences
        content['flown'] = self._flown()
        if stopped:
            content['ended_by'] = verdict.STOPPED
        verdict.write(self._run_dir / 'verdict.json', content)
        if doubts:
            self.problem = f'not to be trusted: {"; ".join(doubts)}'
            print(f'rvd fly: {one_line(self.problem)}', file=sys.stderr, flush=True)
        else:
            print(verdict.in_words(judged), flush=True)
        incomplete = held is not None and not held.complete
        code = EXIT_DONE if judged.success else EXIT_FAILED
        if interrupted:
            code = EXIT_INTERRUPTED
        elif doubts or incomplete:
            code = EXIT_CANNOT
        self._known(code)
        if interrupted and not stopped:         # Ctrl-C: who waits for the prompt
            return code
        from rvd_campaign.report.run import write_report        # takes a while, loaded meanwhile
        attempt(write_report, self._run_dir, self._run_dir / 'logs' / 'report.log')
        if incomplete and not interrupted:
            print(f'rvd fly: {held.in_words()}', file=sys.stderr)
        return code

    def _flown(self, quiet: bool = False) -> dict[str, Any] | None:
        """Return what was flown, by the bag; None where it cannot be read."""
        try:
            return flown.of_bag(self._run_dir, self._scenario, self._step).as_dict()
        except (*reader.NO_MESSAGE, OSError) as error:     # the verdict is kept all the same
            if not quiet:
                print(f'rvd fly: what was flown is not known: {one_line(str(error))}',
                      file=sys.stderr)
            return None

    def _keep_given_up(self, problem: str) -> None:
        """Write why there is no verdict, for who finds the run folder: the bag may not say it."""
        last, links = self._outcome()
        content = verdict.as_dict(verdict.outcome(last, problem=problem), links, self._scenario)
        verdict.write(self._run_dir / 'verdict.json', content | verdict.trust(
            self._watch.strangers, None, 'the run was given up') | {
                'given_up': one_line(problem), 'silences': self._silences,
                'flown': self._flown(quiet=True)})

    def _follow(self) -> str | None:
        """Return None when the run has ended, or the sentence that says why it could not."""
        gone_at = None
        while True:
            stopped_s = self._look(SHOW_S if self._watch.steps else 0.05)
            if self._watch.strangers:           # told in the end, with all that there were
                self._watch.hear_of_strangers()
                self._show()
                for words in self._watch.strangers:     # for a recorder that has not read it
                    self._supervisor.pulse.say(SECOND_WRITER, self._step, words)
                return None
            if self._is_final(self._watch.verdict):
                self._wait_for_the_nodes()
                return None
            if self._stop_asked():              # not of a run that has come to its end meanwhile
                raise _Stopped
            failures = self._supervisor.failures()
            if by := self._supervisor.ended_by():               # it says so before anybody ends
                return self._after(by)
            gone = self._gone()
            self._say_who_is_early(gone)
            if failures and self._is_final(self._outcome()[0]):     # one that could not leave
                self._wait_for_the_nodes()
                return None
            if failures:                        # code 1 is a traceback, in the node's log
                self._fault = 1 in failures.values()
                return self._why(failures)
            if self._supervisor.ended:
                if self._is_final(self._outcome()[0]):
                    return None
                return self._supervisor.complaint() or (
                    f'{", ".join(self._early)} ended before the run was over' if self._early
                    else f'the run ended without a verdict: {MONITOR} ended and had given none')
            now = time.monotonic()
            if gone:                            # told to, by somebody else; the others go on
                gone_at = now if gone_at is None else gone_at + stopped_s
                if now - gone_at > END_S:
                    return f'{", ".join(gone)} ended before the run was over'
            if not self._watch.steps:
                if why := self._starting.look(self._watch, stopped_s):
                    return why
                if news := self._starting.news():
                    self._end_line()
                    print(f'  {news}', flush=True)
            if lost := self._vigil.given_up():
                return self._vigil.in_words(lost, self._owed_by({s.name for s in lost}))
            if self._stalled(now):
                return f'no step for {STALL_S:g} s of wall time: {self._owing()}'

    def _after(self, ended_by: str) -> str | None:
        """
        Wait for what a bring-up leaves that a signal has ended; say so unless the run is over.

        What a process in its start answers to a signal is no failure of its own.
        """
        deadline = time.monotonic() + END_S
        while not self._supervisor.ended and time.monotonic() < deadline:
            deadline += self._look(SHOW_S)
        return None if self._is_final(self._outcome()[0]) else (
            f'{ended_by} before the run was over')

    def _gone(self) -> list[str]:
        """Return our nodes that have ended well, as all do within `END_S` once the run is over."""
        foreign = {e.name for e in self._roster.diagram.externals if e.foreign}
        return sorted(name for name, code in self._supervisor.codes.items()
                      if code == 0 and name not in foreign)

    def _say_who_is_early(self, gone: list[str]) -> None:
        """
        Say which nodes have ended well, as if told to, before they should have.

        That is while the plant knows of no last step, or if the process says that it had more to
        do.
        """
        page, processes = self._supervisor.pulse, self._roster.processes
        for place, process in enumerate(processes if gone else ()):
            flies, name = page.final < 0, process.name
            if name in gone and name not in self._early and (flies or page.left_early(place)):
                self._early.append(name)
                self._say(f'{vigil.in_words(process)} has ended, and '
                          f'{"the run is not over" if flies else "its work was not done"}',
                          ENDED_EARLY)

    def _look(self, seconds: float) -> float:
        """
        Take in and show what comes within `seconds`.

        Returns
        -------
        float
            Wall time for which this process was stopped meanwhile (Ctrl-Z, a paused container)
            [s]: nobody else's fault.
        """
        begun = time.monotonic()
        self._watch.spin(seconds)
        self._show()
        for sentence in self._vigil.look():
            self._say(sentence)
        stopped_s = time.monotonic() - begun
        if stopped_s < STOPPED_S:
            return 0.0
        self._end_line()
        print(f'  rvd fly was stopped for {stopped_s:.0f} s', flush=True)
        self._watch.progress_at += stopped_s
        return stopped_s

    def _owed_by(self, processes: set[str]) -> str:
        """Say in lock step which nodes of silent processes owe a message; empty if none does."""
        if self._run.pace != 'lockstep' or not self._watch.steps:
            return ''
        owing = self._watch.who_owes()
        silent = owing and {self._roster.process_of.get(name, name) for name in owing} <= processes
        return f'{self._owing(owing)}; ' if silent else ''

    def _owing(self, owing: list[str] | None = None) -> str:
        """Say which nodes owe a message, and in which process they are if it is not their own."""
        owing = self._watch.who_owes() if owing is None else owing
        homes = dict.fromkeys(self._roster.process_of.get(name, name) for name in owing)
        shared = '' if list(homes) == owing else f' (process {", ".join(homes)})'
        verb = 'owe' if len(owing) > 1 else 'owes'
        refused = ''.join(f'; {name} refused {one_line(text)}'
                          for name, text in self._watch.refused.items())
        return f'{", ".join(owing) or "no node"}{shared} {verb} a message{refused}'

    @staticmethod
    def _is_final(judged: Any) -> bool:
        return judged is not None and judged.final

    def _outcome(self) -> tuple[Any, dict[str, Any]]:
        """
        Return the last verdict, None if there is none, and the last status of each link.

        The bag is asked, for whose writer the nodes wait: nobody waits for this process, and a
        run of a few steps can be over before it has found the others. Only a verdict that came
        after the recorder had died is known here alone.
        """
        links = {leg.name.removeprefix('link_'): leg.status.name
                 for leg in self._roster.diagram.legs()}
        topics = ('/run/verdict', *links.values())
        try:
            last = reader.newest(self._run_dir, topics)
        except ValueError:                      # no bag: ended before there was one
            last = dict.fromkeys(topics)
        judged = last['/run/verdict']
        final = self._is_final(judged)          # told by the judge, or forged
        return (self._watch.verdict or (None if final else judged),
                {name: last[topic] for name, topic in links.items()})

    def _wait_for_the_nodes(self) -> None:
        """
        Let every node end, now that the verdict is known; say which one did not end well.

        The middleware has been seen, once, to hang for ever while a process left it
        (`destroy_node`): that must not take the flight with it. A long bag takes a slow disk
        longer than that to write its index; as long as it grows, the recorder works.
        """
        _load_the_report()
        from rvd_campaign.flight import second_opinion      # imports ROS, by now loaded
        second_opinion.prepare(self._scenario)
        deadline, written = time.monotonic() + END_S, self._written()
        foreign = {e.name for e in self._roster.diagram.externals if e.foreign}
        while not self._supervisor.ended and time.monotonic() < deadline:
            self._say_who_is_early(self._gone())
            self._supervisor.end_if_left(foreign)
            for name in self._supervisor.let_go_on():
                self._say(f'{name} was stopped; the run is over, and it is let go on')
            deadline += self._look(SHOW_S)
            if self._written() != written:
                deadline, written = time.monotonic() + END_S, self._written()
        self._say_who_is_early(self._gone())
        late = sorted(self._supervisor.left())
        if late:
            self._end_line()
            print(f'rvd fly: {", ".join(late)} did not end after the flight and is ended now',
                  file=sys.stderr)
        elif self._supervisor.failures():
            self._end_line()
            print(f'rvd fly: after the flight {self._why(self._supervisor.failures())}',
                  file=sys.stderr)

    def _written(self) -> int:
        """Return how much there is of the bag, with what is about to take its place [bytes]."""
        with contextlib.suppress(OSError):      # a draft has just taken its place
            return sum(file.stat().st_size for file in (self._run_dir / 'bag').iterdir())
        return 0

    def _stalled(self, now: float) -> bool:
        watch, run = self._watch, self._run
        if not watch.steps or watch.paused or self._is_final(watch.verdict):
            return False
        if self._vigil.waits:                   # who comes back gets the time to make a step
            watch.progress_at = now
            return False
        patience = STALL_S
        if run.pace == 'realtime':
            patience = max(patience, 4.0 * run.step_s / run.pace_factor)
        return now - watch.progress_at > patience

    def _why(self, failures: dict[str, int]) -> str:
        parts = {}
        for name, code in failures.items():
            words = self._supervisor.last_words(name)
            if code == EXIT_CANNOT and words:   # bad input: the node has said which,
                parts.setdefault(words.partition(': ')[2], words)   # and two may refuse the same
                continue
            how = f'was ended by signal {code - 128}' if code > 128 else f'ended with code {code}'
            parts[name] = f'{name} {how}' + (f': {words}' if words else '')
        return '; '.join(parts.values())

    def _kept(self, judged: Any) -> kept.Kept | None:
        """Return what the bag holds of a run that came to its end; None of another."""
        if not self._is_final(judged):
            return None
        last = max(judged.step, self._supervisor.pulse.final)
        return kept.kept(self._run_dir, self._roster.owed, self._roster.diagram.truth.name, last,
                         self._supervisor.pulse.lost)

    # -- what is shown --------------------------------------------------------------------

    def _say(self, sentence: str, code: str = SILENT) -> None:
        """Say what has happened to the processes of the run."""
        self._end_line()
        t = self._step * self._run.step_s
        self._silences.append({'t_s': t, 'said': sentence})
        self._supervisor.pulse.say(code, self._step, sentence)
        print(f'  {t:.1f} s {sentence}', flush=True)

    @property
    def _step(self) -> int:
        return max(self._supervisor.pulse.flown, 0)

    def _show(self) -> None:
        for event in self._watch.new_events():
            self._end_line()
            print(one_line(f'  {event.step * self._run.step_s:.1f} s {event.node}: {event.text}'))
        if not self._watch.steps:
            self._progress(one_line(self._starting.progress(len(self._watch.ready))))
        if self._headless:
            return
        line = one_line(self._watch.line())
        if not self._watch.steps:
            line = self._starting.line(len(self._watch.ready))
        if sys.stdout.isatty():
            width = shutil.get_terminal_size().columns - 1      # a longer line would wrap
            print(f'\r\x1b[K{line[:width]}', end='', flush=True)
            self._on_line = True
        elif line != self._shown and time.monotonic() - self._shown_at > 1.0:
            self._shown_at, self._shown = time.monotonic(), line
            print(line, flush=True)

    def _end_line(self) -> None:
        if self._on_line:
            print()
            self._on_line = False


def _load_the_report() -> None:
    """Import what the report needs: it takes a second, in which nodes start or end."""
    with contextlib.suppress(Exception):    # why it cannot be made is said when it is made
        importlib.import_module('rvd_campaign.report.run')
        drawing.load()
