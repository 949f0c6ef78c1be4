"""
Processes of a run: `scripts/bringup.sh` starts them, this watches them and ends them by pid.
"""

import os
import queue
import signal
import subprocess
import threading
import time
from pathlib import Path

from rvd_dynamics.diagram.roster import lines, RECORDER, Roster

STOP_S = 8.0                    # [s] wall time a node gets to end in order
BAG_S = 5.0                     # [s] more for the recorder to close its bag


class Supervisor:
    """
    The bring-up as a child process in a session of its own.

    A Ctrl-C at the terminal reaches the caller alone, which then ends the nodes in order: the
    recorder last, so that the bag holds what the others said at the end.
    """

    def __init__(self, bringup: Path, scenario: Path, run_dir: Path, headless: bool,
                 domain: int, roster: Roster) -> None:
        """Start the bring-up of the processes that a roster has."""
        self.run_dir = run_dir
        self._recorder = roster.process_of[RECORDER]
        self.pids: dict[str, int] = {}
        self.codes: dict[str, int] = {}
        command = [str(bringup), str(scenario), str(run_dir)] + ['--headless'] * headless
        self._process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True, start_new_session=True, env={
                **os.environ, 'ROS_DOMAIN_ID': str(domain),
                'RVD_PROCESSES': '\n'.join(lines(roster, str(run_dir.resolve())))})
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

    def failures(self) -> dict[str, int]:
        """Return the nodes that ended with an error, with their codes."""
        self.poll()
        return {name: code for name, code in self.codes.items() if code != 0}

    def complaint(self) -> str:
        """Return what the bring-up itself wrote to stderr."""
        return self._process.stderr.read().strip()

    def last_words(self, name: str) -> str:
        """Return the last line of a node's log."""
        try:
            text = (self.run_dir / 'logs' / f'{name}.log').read_text(errors='replace')
        except OSError:
            return ''
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        return lines[-1] if lines else ''

    def stop(self) -> None:
        """End every node by pid, the recorder last, and wait for them."""
        self.poll()
        recorder = self.pids.get(self._recorder)
        self._end([pid for pid in self.pids.values() if pid != recorder], STOP_S)
        if recorder is not None:
            self._end([recorder], BAG_S)
        try:
            self._process.wait(STOP_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join(1.0)
        self.poll()

    def _end(self, pids: list[int], patience_s: float) -> None:
        for pid in pids:
            _signal(pid, signal.SIGTERM)
            _signal(pid, signal.SIGCONT)        # a stopped process cannot end itself
        deadline = time.monotonic() + patience_s
        while time.monotonic() < deadline and any(_alive(pid) for pid in pids):
            self.poll()
            time.sleep(0.02)
        for pid in pids:
            if _alive(pid):
                _signal(pid, signal.SIGKILL)


def _signal(pid: int, number: int) -> None:
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        pass


def _alive(pid: int) -> bool:
    try:
        with open(f'/proc/{pid}/stat', encoding='ascii', errors='replace') as stat:
            return stat.read().rsplit(')', 1)[1].split()[0] != 'Z'
    except OSError:
        return False
