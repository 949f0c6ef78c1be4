"""
Another checkout of the project, measured beside this one: what did a change cost?

It is started through its own `./rvd`, in an environment that has nothing of this one loaded. Its
bring-up, its campaign engine and the topic /run/recorded_step are all that is asked of it, so that
a checkout of a year ago will do.
"""

import os
from pathlib import Path
import re
import signal
import subprocess
from typing import Any

import yaml

from rvd_dynamics.bad_input import BadInput

HOW = '--before DIR, a set-up checkout'         # where a figure would stand
OURS = re.compile(r'VIRTUAL_ENV|PYTHON.*|LD_LIBRARY_PATH|(AMENT|CMAKE|COLCON)_PREFIX_PATH|RVD_.*|'
                  r'_ROS_WHEELS_BOOTSTRAP_COMPLETE')
STOP_S = 10.0                                   # [s] wall time that its processes get to end

# Flies table3 with one worker, and prints how many runs one second of CPU made, draws included.
TABLE = '''
import io, os, sys, tempfile
from pathlib import Path
from rvd_campaign.campaign import engine
from rvd_campaign.campaign.progress import Progress
from rvd_campaign.campaign.spec import load_campaign
def flown(runs):
    with tempfile.TemporaryDirectory() as folder:
        campaign = load_campaign('table3', runs)
        engine.start(campaign, Path(folder))
        begun = sum(os.times()[:4])
        engine.fly_campaign(campaign, Path(folder), engine.Workers(1), Progress(io.StringIO()))
        return sum(os.times()[:4]) - begun, sum(1 for _ in campaign.conditions) * runs
flown(100)
used, count = flown(int(sys.argv[1]))
print('rate', count / used)
'''


class Checkout:
    """
    A checkout that is set up.

    Raises
    ------
    ValueError
        If there is none in the folder.
    """

    def __init__(self, folder: Path) -> None:
        self.root = folder.resolve()
        if not (self.root / 'rvd').is_file() or not (self.root / '.rvd' / 'done').is_file():
            raise BadInput(f'--before {folder} must be a checkout of the project that is set up: '
                           f'git worktree add {folder} COMMIT && {folder}/rvd setup')

    def command(self, *arguments: object) -> list[str]:
        """Return a call of its `./rvd`."""
        return [str(self.root / 'rvd'), *map(str, arguments)]

    def environment(self, **more: str) -> dict[str, str]:
        """Return the environment of a shell that has nothing of ours loaded."""
        kept = {name: value for name, value in os.environ.items() if not OURS.fullmatch(name)}
        kept['PATH'] = ':'.join(p for p in kept['PATH'].split(':') if '/.rvd/' not in p)
        return {**kept, **more}

    def scenario(self, name: str, **shared: Any) -> str:
        """Return the text of one of its scenarios with changed shared keys."""
        tree = yaml.safe_load((self.root / 'scenarios' / f'{name}.yaml').read_text())
        tree['/**']['ros__parameters'].update(shared)
        return yaml.safe_dump(tree)

    def rate_of_table(self, runs: int) -> float:
        """
        Return how many runs of `table3` a second of CPU makes.

        Raises
        ------
        ValueError
            If it cannot fly them.
        """
        done = subprocess.run(self.command('shell', 'python', '-c', TABLE, runs),
                              cwd=self.root, env=self.environment(), capture_output=True, text=True)
        words = done.stdout.split()[-2:]
        if done.returncode or words[:1] != ['rate']:
            raise BadInput(f'{self.root} cannot fly table3: {done.stderr.strip()[-300:]}')
        return float(words[1])


class BringUp:
    """A flight of a checkout, by its own scripts/bringup.sh."""

    def __init__(self, checkout: Checkout, scenario: Path, folder: Path, domain: int) -> None:
        folder.mkdir(parents=True)
        self._said = folder / 'said'
        with self._said.open('w') as said:
            self._process = subprocess.Popen(
                checkout.command('shell', checkout.root / 'scripts' / 'bringup.sh', scenario,
                                 folder / 'run'),
                cwd=checkout.root, env=checkout.environment(ROS_DOMAIN_ID=str(domain)),
                stdin=subprocess.DEVNULL, stdout=said, stderr=said, start_new_session=True)

    def _lines(self, word: str) -> dict[str, int]:
        found = (line.split() for line in self._said.read_text().splitlines())
        return {words[1]: int(words[2]) for words in found if len(words) == 3 and words[0] == word}

    def pids(self) -> dict[str, int]:
        """Return the processes that have started, by name."""
        return self._lines('start')

    def ended(self) -> bool:
        """Say whether all have ended."""
        return self._process.poll() is not None

    def stop(self) -> None:
        """
        End what has not ended.

        Raises
        ------
        ValueError
            If one ended with an error before; names it.
        """
        failed = {name: code for name, code in self._lines('exit').items() if code}
        if not self.ended():
            self._process.send_signal(signal.SIGTERM)
            try:
                self._process.wait(STOP_S)
            except subprocess.TimeoutExpired:
                os.killpg(self._process.pid, signal.SIGKILL)
                self._process.wait()
        if failed or not self.pids():
            raise BadInput(f'the flight of the other checkout failed: {failed or ""} '
                           f'{self._said.read_text().strip()[-300:]}')
