"""
How much the memory of each process grows with every step of a long flight over DDS in lock step.

The flight is the lunar approach from far away, so that nothing ends it: model pilot, law, filter
and link work as ever. What a process has for itself (RssAnon, proc(5)) is noted as the steps go by,
from when the histories of DDS are full on; the growth per step is the slope of a straight line
through the notes of the second half of the flight. In the first one the allocator still finds its
size. Of a leak of 100 bytes per message ten times as many would show.

What may grow is said by the sizes that the run is planned for: random numbers and the fates of
frames are drawn before it.
"""

from bisect import bisect_left
from dataclasses import dataclass, field
from pathlib import Path
import shutil
import tempfile
import time

import numpy as np

from rvd_campaign import catalogue
from rvd_campaign.flight.domain import reserved_domain
from rvd_campaign.flight.supervisor import Supervisor
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.identity import new_run
from rvd_dynamics.diagram.ros.qos import DEPTH
from rvd_dynamics.diagram.ros.recorder import REPORT_EVERY
from rvd_dynamics.diagram.roster import listed
from rvd_dynamics.diagram.scenario import load

STEP_S = 0.08                   # [s] simulation time: a million steps are less than a day
# [steps] after which every history of DDS is full, that of what is said least often last.
WARM_UP_STEPS = (REPORT_EVERY + 1)*DEPTH
STEPS = {'blocks': 20_000, 'segments': 40_000, 'one': 1_000_000 - WARM_UP_STEPS}     # measured
QUICK = {'one': 20_000}
MAX_BYTES = 16.0                # [bytes] a step and process, flat: 16 MB in a million steps
BAG_BYTES = 4000                # [bytes] a step that the bag takes at most
PERIOD_S = 0.5                  # [s] wall time between two notes
STALL_S = 60.0                  # [s] wall time without a step: it is given up
SCENARIO = """
/**:
  ros__parameters:
    pace: lockstep
    processes: {processes}
    step_s: {step_s}
    forward_delay_s: 4.0
    back_delay_s: 4.0
    timeout_s: {timeout_s}
    start: {{position_m: [-90000.0, 0.0, 0.0]}}
"""


@dataclass
class Notes:
    """Memory of the processes of a run by step."""

    steps: list[int] = field(default_factory=list)
    memory: list[dict[str, int]] = field(default_factory=list)      # [bytes] by process

    def note(self, step: int, pids: dict[str, int]) -> None:
        """Note what each process has at `step`, after the warm-up."""
        if step >= WARM_UP_STEPS and (not self.steps or step > self.steps[-1]):
            self.steps.append(step)
            self.memory.append({name: anonymous(pid) for name, pid in pids.items()})

    def growth(self) -> dict[str, float]:
        """Return how much each process has grown with every step of the second half [bytes]."""
        middle = (self.steps[0] + self.steps[-1])/2 if self.steps else 0
        half = bisect_left(self.steps, middle)
        steps, memory = self.steps[half:], self.memory[half:]
        if len(steps) < 3:
            raise BadInput('the flight was too short to say how memory grows')
        return {name: float(np.polyfit(steps, [m.get(name, 0) for m in memory], 1)[0])
                for name in memory[-1]}

    def grown(self) -> dict[str, int]:
        """Return by how much each process has grown after the warm-up [bytes]."""
        return {name: now - self.memory[0].get(name, 0) for name, now in self.memory[-1].items()}


def measure(quick: bool = False, steps: dict[str, int] | None = None) -> dict:
    """Fly one long flight for each way of sharing processes; return growth and sizes."""
    found = {}
    for processes, number in (steps or (QUICK if quick else STEPS)).items():
        with tempfile.TemporaryDirectory(prefix='rvd-bench-') as folder, \
                reserved_domain() as domain:
            notes = fly(processes, number, Path(folder), domain)
        found[processes] = {
            'steps': notes.steps[-1] - notes.steps[0],
            'bytes_per_step': {n: round(g, 2) for n, g in notes.growth().items()},
            'kilobytes_in_all': {n: round(g/1e3) for n, g in notes.grown().items()},
            'megabytes': {n: round(m/1e6, 1) for n, m in notes.memory[-1].items()}}
    return found


def fly(processes: str, steps: int, folder: Path, domain: int) -> Notes:
    """
    Fly until so many steps have followed the warm-up; return the notes.

    Raises
    ------
    ValueError
        If the flight does not come so far, and what ended it; or if the disk has no room.
    """
    last = WARM_UP_STEPS + steps
    if shutil.disk_usage(folder).free < last*BAG_BYTES:
        raise BadInput(f'the bag of {last} steps takes {last*BAG_BYTES/1e9:.1f} GB, and {folder} '
                       'has less: set TMPDIR to a folder that has it')
    path = folder / 'scenario.yaml'
    path.write_text(SCENARIO.format(processes=processes, step_s=STEP_S,
                                    timeout_s=STEP_S*(last + 1000)))
    (folder / 'logs').mkdir()
    roster = listed(load(path), headless=False)
    supervisor = Supervisor(catalogue.root() / 'scripts' / 'bringup.sh', path, folder, False,
                            domain, roster, new_run())
    notes = Notes()
    moved, newest = time.monotonic(), -1
    try:
        while newest < last:
            time.sleep(PERIOD_S)
            step = supervisor.pulse.flown
            if failures := supervisor.failures():
                raise BadInput('; '.join(f'{name} ended with code {code}: '
                                         f'{supervisor.last_words(name)}'
                                         for name, code in failures.items()))
            if step > newest:
                moved, newest = time.monotonic(), step
                notes.note(step, supervisor.left())
            elif supervisor.ended or time.monotonic() - moved > STALL_S:
                raise BadInput(f'the flight ended at step {step} of {last}')
    finally:
        supervisor.stop()
    return notes


def anonymous(pid: int) -> int:
    """Return the memory that a process has for itself [bytes]; 0 when it is gone."""
    try:
        lines = Path(f'/proc/{pid}/status').read_text(encoding='ascii').splitlines()
    except OSError:
        return 0
    return next((1024*int(line.split()[1]) for line in lines if line.startswith('RssAnon:')), 0)
