"""
Processes of a run: `scripts/bringup.sh` starts and ends them, this watches it.
"""

import os
import queue
import signal
import subprocess
import threading
from pathlib import Path

from rvd_campaign.cpu import is_alive, STOPPED, usage
from rvd_dynamics import lifeline, pulse, verdict_line
from rvd_dynamics.bad_input import one_line
from rvd_dynamics.diagram.roster import lines, Roster
from rvd_dynamics.pulse import Pulse

BRINGUP = 'the bring-up'
STOP_S = 15.0                   # [s] wall time the bring-up gets to end all; it asks for 13
TOLD = 128 + signal.SIGTERM     # code of a process that had no answer yet to being told to end


class Supervisor:
    """
    The bring-up as a child process in a session of its own.

    A Ctrl-C at the terminal reaches the caller alone, which then lets the bring-up end the nodes
    in order. If the caller is killed, the kernel tells the bring-up to, and the nodes see it by a
    pipe that nobody writes to.

    Attributes
    ----------
    pulse : Pulse
        The page on which every process of the run gives its signs of life.
    """

    def __init__(self, bringup: Path, scenario: Path, run_dir: Path, headless: bool,
                 domain: int, roster: Roster, run_id: str) -> None:
        """Start the bring-up of the processes that a roster has."""
        self.run_dir = run_dir
        self.pids: dict[str, int] = {}
        self.codes: dict[str, int] = {}
        self._ended_by_us: set[str] = set()
        self._told_to_end = ''                  # the signal that the bring-up got
        self._verdict_line = verdict_line.VerdictLine()
        self.pulse = Pulse.shared(len(roster.processes))
        line, self._line = os.pipe()            # ours alone: it is cut when this process ends
        command = [str(bringup), str(scenario), str(run_dir)] + ['--headless'] * headless
        self._process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True, start_new_session=True,
            preexec_fn=lambda: lifeline.die_with_parent(signal.SIGUSR1),
            pass_fds=(line, self.pulse.file, self._verdict_line.writes), env={
                **os.environ, 'ROS_DOMAIN_ID': str(domain),
                lifeline.LINE: str(line), pulse.PAGE: str(self.pulse.file),
                'ROS_LOG_DIR': str(run_dir.resolve() / 'logs'),
                verdict_line.VARIABLE: str(self._verdict_line.writes),
                'RVD_PROCESSES': '\n'.join(lines(roster, str(run_dir.resolve()), run_id))})
        self._verdict_line.handed_over()
        os.close(line)
        self.pulse.handed_on()
        self._lines: queue.Queue[str] = queue.Queue()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        for line in self._process.stdout:
            self._lines.put(line)

    def poll(self) -> None:
        """Take in what the bring-up has said since the last call."""
        while True:
            try:
                words = self._lines.get_nowait().split()
            except queue.Empty:
                return
            if words[:1] == ['start']:
                self.pids[words[1]] = int(words[2])
            elif words[:1] == ['exit']:
                self.codes[words[1]] = int(words[2])
            elif words[:1] == ['told']:
                self._told_to_end = words[1]

    @property
    def ended(self) -> bool:
        """Say whether the bring-up and with it every node has ended."""
        if self._process.poll() is None or self._reader.is_alive():
            return False
        self.poll()
        return True

    @property
    def code(self) -> int:
        """Exit code of the bring-up, once ended."""
        return self._process.returncode

    def ended_by(self) -> str:
        """Say which signal has ended the bring-up, or is about to; empty where none has."""
        self.poll()
        if self._told_to_end:
            return f'{BRINGUP} was told to end ({self._told_to_end})'
        if self.ended and self.code < 0:
            return f'{BRINGUP} was ended by {_name_of(-self.code)}'
        return ''

    def failures(self) -> dict[str, int]:
        """
        Return the nodes that ended with an error, with their codes.

        When the first has failed the bring-up ends the others, which in their start die of that.
        """
        self.poll()
        found = {name: code for name, code in self.codes.items()
                 if code != 0 and name not in self._ended_by_us}
        return {name: code for i, (name, code) in enumerate(found.items()) if not i or code != TOLD}

    def end_if_left(self, names: set[str]) -> None:
        """End these nodes, which know nothing of the run's end, once no other one is left."""
        self.poll()
        left = set(self.pids) - set(self.codes)
        if left and left <= names:
            for name in left:
                _signal(self.pids[name], signal.SIGTERM)
            self._ended_by_us |= left

    def told(self) -> list[verdict_line.Message]:
        """Return what the judge's own process has told: the final verdict, second writers."""
        return self._verdict_line.heard()

    def left(self) -> dict[str, int]:
        """Return the processes that are still there, by name, with their ids."""
        self.poll()
        return {name: pid for name, pid in self.pids.items()
                if name not in self.codes and is_alive(pid)}

    def let_go_on(self) -> list[str]:
        """Let processes go on that somebody has stopped, the bring-up too; return their names."""
        stopped = {name: pid for name, pid in {**self.left(), BRINGUP: self._process.pid}.items()
                   if usage(pid).state in STOPPED}
        for pid in stopped.values():
            _signal(pid, signal.SIGCONT)
        return list(stopped)

    def complaint(self) -> str:
        """Return what the bring-up itself wrote to stderr."""
        return '\n'.join(map(one_line, self._process.stderr.read().strip().splitlines()))

    def last_words(self, name: str) -> str:
        """Return the last line of a node's log; whatever it holds does nothing to a terminal."""
        try:
            text = (self.run_dir / 'logs' / f'{name}.log').read_text(errors='replace')
        except OSError:
            return ''
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        return one_line(lines[-1]) if lines else ''

    def stop(self) -> None:
        """End every process, the recorder last, and wait for them; what does not go is killed."""
        _signal(self._process.pid, signal.SIGTERM)
        _signal(self._process.pid, signal.SIGCONT)      # a stopped process cannot end itself
        try:
            self._process.wait(STOP_S)
        except subprocess.TimeoutExpired:
            pass
        try:                                            # its session: whatever it has started
            os.killpg(self._process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self._process.wait()
        self._reader.join(1.0)
        self._verdict_line.close()
        self.poll()
        if self._line >= 0:
            os.close(self._line)
            self._line = -1


def _name_of(number: int) -> str:
    """Return the name of a signal; real-time ones have numbers alone."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f'signal {number}'


def _signal(pid: int, number: int) -> None:
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        pass
