"""
Flies a campaign: stretches of runs on worker processes, each kept on disk when it is finished.

Folder  campaign.json    what is flown, every default resolved, and the fingerprint of it
        parts/           finished stretches; what is there is never flown again
        results.parquet, summary.json, report.html      made when all runs are there
Split   a run depends on (seed, run, purpose) and its condition alone, so that neither workers
        nor batch nor resume can change it; the hash of the result table says so.
Workers joblib's: processes of this machine (loky), or a Dask or Ray cluster. Only this process
        writes.
"""

import errno
import fcntl
import hashlib
import importlib.util
import itertools
import json
import os
import re
import shlex
import shutil
import signal
import socket
import threading
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import BrokenExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import joblib

from rvd_campaign.campaign import results
from rvd_campaign.campaign.checked import Campaign, CampaignError, from_dict, KEPT_SHAPE
from rvd_campaign.campaign.progress import Progress
from rvd_campaign.campaign.results import Stretch, Table
from rvd_campaign.campaign.software import code_hash, MATTERS, software, versions
from rvd_campaign.campaign.standstill import Standstill, STOPPED_S
from rvd_dynamics import lifeline
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import draw, draws_key, fly
from rvd_dynamics.diagram.scenario import Scenario, ScenarioError
from rvd_dynamics.given import has_shape, object_of
from rvd_dynamics.recording import whole

KEPT, PARTS, RESULTS = 'campaign.json', 'parts', 'results.parquet'
BATCH_STEPS = 1_200_000         # runs times steps that fly together: 170 MB of draws, full speed
SMALL_BATCH = 250               # runs; fewer are not parted further to give each worker some
TOGETHER = 4                    # conditions that share the draws of their runs, at most
SPARE_BYTES = 8 << 20           # of disk, for summary and report
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


@dataclass(frozen=True)
class Workers:
    """Who flies."""

    count: int = 1
    backend: str = 'local'              # local, dask or ray
    scheduler: str = ''                 # of a cluster: its address
    batch: int = 0                      # runs that fly together; 0: what suits the memory


def default_workers() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, 'sched_getaffinity'):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


# -- identity --------------------------------------------------------------------------------

def identity(campaign: Campaign) -> dict[str, str]:
    """Return what must be equal for two runs of the same number to be the same run."""
    settings = json.dumps([campaign.seed, [
        (c.name, c.scenario.resolved() if c.point is None else c.changes)
        for c in campaign.conditions]])
    return {'settings': hashlib.sha256(settings.encode()).hexdigest(),
            'code': code_hash(campaign.mission), **versions()}


def open_folder(folder: Path) -> tuple[Campaign, dict]:
    """
    Return the campaign of a folder and everything that is kept about it.

    Raises
    ------
    CampaignError
        If it is not the folder of a campaign.
    """
    try:
        if not (folder / KEPT).exists():
            raise CampaignError(f'{folder} is not the folder of a campaign: it has no {KEPT}')
        kept = object_of(folder / KEPT, 'campaign')
        if not has_shape(kept.get('campaign'), KEPT_SHAPE):
            raise CampaignError(f'{folder / KEPT} is damaged: it has not the shape of a campaign')
        return from_dict(kept['campaign']), kept
    except CampaignError:
        raise
    except ScenarioError as error:              # of a mission that is not installed, for instance
        raise CampaignError(f'{folder / KEPT}: {error}') from None
    except BadInput as error:                   # of the file, which it names
        raise CampaignError(str(error)) from None
    except (ValueError, LookupError, TypeError, AttributeError) as error:
        raise CampaignError(f'{folder / KEPT} is damaged: {type(error).__name__}: {error}'
                            ) from None


def check_same(folder: Path, kept: dict, campaign: Campaign) -> None:
    """Refuse to add runs to the folder of another campaign."""
    mine, its = identity(campaign), kept.get('identity')
    if not isinstance(its, dict) or 'settings' not in its:
        raise CampaignError(f'{folder / KEPT} is damaged: it does not say what was flown')
    if mine['settings'] != its['settings']:
        raise CampaignError(f'{folder} holds another campaign ({kept["campaign"]["name"]} with '
                            'other settings or seed): nothing is overwritten')
    for name in ('code', *MATTERS):
        if mine[name] != its.get(name):
            what = ('another version of this software' if name == 'code'
                    else f'{name} {its.get(name)}, here is {mine[name]}')
            raise CampaignError(f'{folder} was flown with {what}: its runs cannot be mixed with '
                                'new ones')


# -- flying ----------------------------------------------------------------------------------

def start(campaign: Campaign, folder: Path) -> None:
    """Make an empty folder the folder of a campaign."""
    (folder / PARTS).mkdir()
    keep(campaign, folder)


def keep(campaign: Campaign, folder: Path) -> None:
    """Write what the folder is about."""
    kept = {'campaign': campaign.as_dict(), 'identity': identity(campaign)}
    whole.write_text(folder / KEPT, json.dumps(kept, indent=1))


def fly_campaign(campaign: Campaign, folder: Path, workers: Workers, progress: Progress) -> None:
    """
    Fly every run that the folder does not hold yet.

    Raises
    ------
    CampaignError
        If the disk is full, or a worker cannot do its work or was killed; finished runs are
        kept. One that somebody stopped is ended, and others fly its runs.
    """
    parts = folder / PARTS
    todo = stretches(campaign, list(results.finished(parts)), workers)
    check_space(folder, sum(s.count for s in todo))
    total = len(campaign.conditions) * campaign.runs
    progress.begin(total - sum(s.count for s in todo), total)
    while todo:
        try:
            for stretch, table, seconds in _flown(campaign, todo, workers):
                try:
                    results.write_part(parts, stretch, table, seconds)
                except OSError as error:
                    raise full_disk(folder, error) from None
                progress.add(stretch.count)
            break
        except WorkerStopped as error:
            progress.say(f'{error}: its runs are flown by another')
            todo = stretches(campaign, list(results.finished(parts)), workers)
        except BrokenExecutor as error:
            raise CampaignError(
                f'a worker {how_it_ended(error)}; finished runs are kept: go on with ./rvd '
                f'campaign --resume {shlex.quote(str(folder))}') from None
    progress.end()


class WorkerStopped(Exception):
    """Workers were stopped by somebody and have been ended; their runs are to be flown."""


def how_it_ended(error: BrokenExecutor) -> str:
    """Return in words how a worker ended: joblib's error names the signals."""
    found = sorted(set(re.findall(r'SIG[A-Z]+', str(error))))
    if not found:
        return 'has ended'
    memory = ' or for want of memory' if 'SIGKILL' in found else ''
    return f'was ended by {", ".join(found)} (by somebody{memory})'


def stretches(campaign: Campaign, done: list[Stretch], workers: Workers) -> list[Stretch]:
    """Return what is to be flown, all conditions advancing together."""
    todo = []
    for index, condition in enumerate(campaign.conditions):
        steps = condition.scenario.run.last_step + 1
        size = workers.batch or _batch(campaign.runs, max(1, BATCH_STEPS // steps), workers.count)
        for gap in results.missing(done, index, campaign.runs):
            todo += [Stretch(index, first, min(size, gap.stop - first))
                     for first in range(gap.start, gap.stop, size)]
    return sorted(todo, key=lambda s: (s.first, s.condition))


def _batch(runs: int, most: int, workers: int) -> int:
    """Return how many runs fly together: equal shares, the same number for each worker."""
    shares = -(-runs // most)
    if runs >= SMALL_BATCH * workers:
        shares = -(-shares // workers) * workers
    return -(-runs // shares)


def check_space(folder: Path, runs: int) -> None:
    """Refuse to begin what the disk cannot hold."""
    need = runs * results.BYTES_PER_RUN + SPARE_BYTES
    free = shutil.disk_usage(folder).free
    if free < need:
        raise CampaignError(f'{folder}: {runs:,} runs need about {need >> 20} MB of disk, '
                            f'{free >> 20} MB are free')


def full_disk(folder: Path, error: OSError) -> Exception:
    """Return the refusal for an error of the disk, or the error itself."""
    if error.errno in FULL:
        return CampaignError(f'{folder}: {os.strerror(error.errno)}; finished runs are kept: make '
                             f'room and go on with --resume {folder}')
    return CampaignError(f'{folder}: {error.strerror or error}')


def _flown(campaign: Campaign, todo: list[Stretch], workers: Workers
           ) -> Iterator[tuple[Stretch, Table, float]]:
    """Yield stretches as they are finished, in any order."""
    code, parent = software(campaign.mission), os.getpid()
    work = (joblib.delayed(fly_together)(task, code, parent) for task in tasks(campaign, todo))
    with BACKENDS[workers.backend](workers.scheduler):
        if workers.backend == 'ray':            # its joblib backend hands nothing out early
            pool = joblib.Parallel(n_jobs=-1)
            while handful := list(itertools.islice(work, 4 * joblib.effective_n_jobs(-1))):
                for finished in pool(handful):
                    yield from finished
            return
        pool = joblib.Parallel(n_jobs=workers.count, return_as='generator_unordered',
                               batch_size=1, pre_dispatch='2*n_jobs')
        flown = pool(work)
        try:
            with Standstill() as standstill:
                for finished in flown:
                    yield from finished
        except BrokenExecutor:
            if not standstill.ended:
                raise
            raise WorkerStopped(f'worker {", ".join(map(str, standstill.ended))} was stopped for '
                                f'{STOPPED_S:g} s') from None
        finally:
            flown.close()                       # ends the workers when we leave early


def check_scheduler(backend: str, address: str) -> None:
    """Refuse a cluster that cannot be reached, before anything is begun."""
    match = re.fullmatch(r'(?:(?:tcp|tls)://)?(.+):(\d{1,5})', address)
    if not match:
        raise CampaignError(f'the address of a {backend} cluster is tcp://HOST:PORT, '
                            f'got {address!r}')
    if backend == 'ray' and importlib.util.find_spec('ray') is None:
        raise CampaignError('--backend ray needs Ray here and on the cluster: '
                            './rvd shell pip install ray')
    try:
        socket.create_connection((match[1].strip('[]'), int(match[2])), timeout=10).close()
    except (OSError, OverflowError) as error:
        raise CampaignError(f'no {backend} cluster at {address}: {error}') from None


@contextmanager
def _local(_: str) -> Iterator[None]:
    with joblib.parallel_config('loky', inner_max_num_threads=1):
        yield


@contextmanager
def _dask(address: str) -> Iterator[None]:
    from distributed import Client
    try:
        client = Client(address, timeout=10, set_as_default=False)
    except (OSError, ValueError) as error:
        raise CampaignError(f'no dask cluster at {address}: {error}') from None
    with client, joblib.parallel_config('dask', client=client):
        yield


@contextmanager
def _ray(address: str) -> Iterator[None]:
    import ray
    from ray.util.joblib import register_ray
    try:
        ray.init(address=address.split('://')[-1], log_to_driver=False, logging_level='ERROR')
    except (ConnectionError, ValueError, RuntimeError) as error:
        raise CampaignError(f'no ray cluster at {address}: {error}') from None
    try:
        register_ray()
        with joblib.parallel_config('ray'):
            yield
    finally:
        ray.shutdown()


BACKENDS = {'local': _local, 'dask': _dask, 'ray': _ray}


Task = list[tuple[Scenario, Stretch]]           # of the same runs, with the same draws


def tasks(campaign: Campaign, todo: list[Stretch]) -> Iterator[Task]:
    """Yield stretches in handfuls that share their draws, which cost more than the flying."""
    kinds: dict[Any, int] = {}
    kind = [kinds.setdefault(draws_key(c.scenario, ()), len(kinds))
            for c in campaign.conditions]
    order = sorted(todo, key=lambda s: (s.first, s.count, kind[s.condition], s.condition))
    for _, same in itertools.groupby(
            order, key=lambda s: (s.first, s.count, kind[s.condition])):
        while handful := list(itertools.islice(same, TOGETHER)):
            yield [(campaign.conditions[s.condition].scenario, s) for s in handful]


def fly_together(task: Task, code: tuple, parent: int) -> list[tuple[Stretch, Table, float]]:
    """
    Fly the same runs of several conditions; what a worker does.

    Returns
    -------
    list of (stretch, table, seconds)
        Seconds of one core: its own flying and its part of the drawing.

    Raises
    ------
    CampaignError
        If the worker has other sources or packages than the process that asks.
    """
    if os.getppid() == parent:
        _live_with_parent()
    if code != software(task[0][0].mission):
        raise CampaignError('a worker has another version of this software or of '
                            f'{", ".join(MATTERS)}')
    begun = time.thread_time()
    draws = draw(task[0][0], task[0][1].runs)
    each = (time.thread_time() - begun) / len(task)
    made = []
    for scenario, stretch in task:
        begun = time.thread_time()
        flown = fly(scenario, stretch.runs, draws=draws)
        table = results.rows(flown, results.order_of(scenario.mission))
        made.append((stretch, table, each + time.thread_time() - begun))
    return made


@lru_cache(maxsize=1)
def _live_with_parent() -> None:
    """Leave Ctrl-C to the parent, and end when it is killed instead of idling for minutes."""
    if threading.current_thread() is not threading.main_thread():
        return
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    lifeline.die_with_parent()


@contextmanager
def sole_writer(folder: Path) -> Iterator[None]:
    """
    Hold the folder against a second process.

    Raises
    ------
    CampaignError
        If another process flies into it.
    """
    try:
        (folder / PARTS).mkdir(exist_ok=True)   # somebody may have cleaned up: all is flown anew
        lock = os.open(folder / PARTS, os.O_RDONLY)
    except OSError as error:
        raise CampaignError(f'cannot write into {folder}: {error.strerror}') from None
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield
    except BlockingIOError:
        raise CampaignError(f'{folder} is being flown by another process') from None
    finally:
        os.close(lock)


def refly(folder: Path, name: str, run: int) -> tuple[Scenario, Table]:
    """
    Return the scenario of one run of a campaign, to fly it again, and its row.

    Raises
    ------
    CampaignError
        If the folder has no such condition or run.
    """
    campaign, _ = open_folder(folder)
    condition = campaign.condition(name)
    if not 0 <= run < campaign.runs:
        raise CampaignError(f'{folder} has runs 0 to {campaign.runs - 1}, not {run}')
    index = campaign.conditions.index(condition)
    row = _row(folder, index, run)
    scenario = condition.scenario.with_values('/**', run=run)
    return scenario.renamed(f'{campaign.name}-{name}-{run}'), row


def _row(folder: Path, condition: int, run: int) -> Table:
    for stretch in results.finished(folder / PARTS):
        if stretch.condition == condition and run in stretch.runs:
            table = results.read_table(folder / PARTS / stretch.file)
            at = int((table['run'] == run).argmax())
            return {column: values[at:at + 1] for column, values in table.items()}
    raise CampaignError(f'{folder}: run {run} of this condition is not flown yet')


def condition_tables(campaign: Campaign, folder: Path) -> Iterable[tuple[str, Table]]:
    """Yield each condition with all of its runs, in the order of the campaign."""
    done = list(results.finished(folder / PARTS))
    for index, condition in enumerate(campaign.conditions):
        yield condition.name, results.condition_table(folder / PARTS, done, index, campaign.runs)
