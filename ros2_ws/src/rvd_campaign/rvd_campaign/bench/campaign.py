"""
The campaign: runs per core-second, against one filterpy object and one pilot object per run,
with the predictor that knows of lost commands against the paper's, on two processes, the paper's
table, and that of another checkout of the project.
"""

import io
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from rvd_campaign import catalogue
from rvd_campaign.campaign import engine
from rvd_campaign.campaign.progress import Progress
from rvd_campaign.bench.before import Checkout
from rvd_campaign.campaign.spec import Campaign, load_campaign
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_groundstation.prediction.predictor import PredictorParams

MIN_RUNS_PER_CORE_S = 3000
MIN_RATIO = 50
MAX_TABLE_S = 60.0
MIN_RATE_OF_BEFORE = 0.97
MIN_RATE_OF_PAPER = 0.9         # with the predictor that is the default, of the paper's
MIN_SPEED_UP = 1.8              # on two processes: near-linear
BATCH = 3000                    # as a campaign flies them
ONE_BY_ONE = 10                 # runs of the slow way that are timed
TABLE_RUNS = 10_000
PAIRS = 5                       # turns that this and another checkout take


def measure(quick: bool = False, before: Checkout | None = None) -> dict:
    """
    Fly a batch, the same work run by run, and `table3` with one and with two workers.

    Rates are runs per second of CPU, draws included, with the paper's law in the world of
    Clohessy and Wiltshire; times of the whole command are wall time.
    """
    paper = load(catalogue.find('scenarios', 'paper', ('.yaml',)))
    batch, table = (BATCH // 4, TABLE_RUNS // 20) if quick else (BATCH, TABLE_RUNS)
    # One filterpy filter with its own covariance, one pilot, one link plan ... for each run.
    alone = paper.with_values('state_predictor', filter='adaptive')
    fly(alone, [0])                             # imports filterpy
    repeats = 1 if quick else 3
    rate = max(_rate(paper, range(batch)) for _ in range(repeats))
    slow = max(_rate_one_by_one(alone, 2 if quick else ONE_BY_ONE) for _ in range(repeats))
    of_paper = _default_of_paper(paper, range(batch), 1 if quick else PAIRS)
    with tempfile.TemporaryDirectory() as folder:
        _flying_s(load_campaign('table3', 200), Path(folder) / 'warm', 2)   # starts processes
        flown = load_campaign('table3', table)
        one, two = (_flying_s(flown, Path(folder) / str(count), count) for count in (1, 2))
    compared = {} if before is None else _against(before, 1 if quick else PAIRS, table // 4)
    return {**compared, 'runs_per_core_s': round(rate), 'one_by_one_per_core_s': round(slow, 2),
            'ratio': round(rate / slow, 1), 'default_of_paper': round(of_paper, 3),
            'speed_up_on_two': round(one / two, 2),
            'table_runs': table, 'table3_s': round(_campaign_s(table, 2), 1)}


def _against(before: Checkout, pairs: int, runs: int) -> dict:
    """Return runs of `table3` per second of CPU here and there, in turns, and their ratio."""
    here, rates = Checkout(catalogue.root()), []
    for _ in range(pairs):
        rates.append([tree.rate_of_table(runs) for tree in (before, here)])
    return {'rates': [{'before': round(b), 'now': round(n)} for b, n in rates],
            'rate_of_before': round(median(now / then for then, now in rates), 3)}


def _rate(scenario: Scenario, runs: range) -> float:
    begun = time.process_time()
    fly(scenario, runs)
    return len(runs) / (time.process_time() - begun)


def _default_of_paper(paper: Scenario, runs: range, pairs: int) -> float:
    """Return runs per second of CPU with the default predictor, of those with the paper's."""
    default = paper.with_values('state_predictor', **{
        key: getattr(PredictorParams(), key) for key in ('in_flight', 'filter', 'prior')})
    fly(default, [0])                           # compiles
    return median(_rate(default, runs) / _rate(paper, runs) for _ in range(pairs))


def _rate_one_by_one(scenario: Scenario, count: int) -> float:
    """Return runs per second of CPU when each is flown by itself."""
    begun = time.process_time()
    for run in range(count):
        fly(scenario, [run])
    return count / (time.process_time() - begun)


def _flying_s(campaign: Campaign, folder: Path, workers: int) -> float:
    """Return the wall time [s] of the flying alone, without start of processes and figures."""
    folder.mkdir()
    engine.start(campaign, folder)
    progress = Progress(io.StringIO())
    engine.fly_campaign(campaign, folder, engine.Workers(workers), progress)
    return progress.elapsed_s


def _campaign_s(runs: int, workers: int) -> float:
    """Return the wall time [s] of the whole command: start, flying, tables, figures."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, '-m', 'rvd_campaign.cli', 'campaign', 'table3',
                   '--runs', str(runs), '--workers', str(workers),
                   '--out', str(Path(folder) / 'table3')]
        begun = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=dict(os.environ))
        return time.perf_counter() - begun
