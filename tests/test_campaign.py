"""
Campaigns as people run them: killed and resumed, stopped, refused, flown again over DDS.
"""

import json
import os
import re
import resource
import signal
import subprocess
import sys
import time

import numpy as np
import pyarrow.parquet
import pytest
from runs import alive, command, environment, end, pids_under, ROOT, rvd, start_rvd, wait_for

SMALL = '''
scenario: paper
seed: 5
runs: 60
set: {pilot: A}
conditions:
  manual: {/**: {mode: manual}}
  shared: {}
'''


@pytest.fixture(scope='module')
def flown(tmp_path_factory):
    """A small campaign: file and folder."""
    folder = tmp_path_factory.mktemp('campaign')
    (folder / 'small.yaml').write_text(SMALL)
    done = rvd('campaign', 'small.yaml', '--out', 'c', '--workers', '1', cwd=folder)
    assert done.returncode == 0, done.stderr
    return folder / 'c', done.stdout


def hash_of(text: str) -> str:
    return re.search(r'result hash (\w{64})', text)[1]


def test_campaign_leaves_results_summary_and_report(flown):
    folder, said = flown
    summary = json.loads((folder / 'summary.json').read_text())
    rows = pyarrow.parquet.read_table(folder / 'results.parquet').to_pydict()
    assert summary['result_hash'] == hash_of(said)
    for c in summary['conditions']:
        mine = [s for s, name in zip(rows['success'], rows['condition']) if name == c['name']]
        assert (len(mine), sum(mine)) == (c['runs'], c['successes']) and c['runs'] == 60
    assert 'runs/s' in said and str(folder.name) in said
    page = (folder / 'report.html').read_text()
    assert page.count('<svg') == 1
    outside = re.findall(r'(?:src|href)="(?!#)[^"]*"|https?://(?!www\.w3\.org)[^\s"<]+', page)
    assert not outside, outside


def test_report_can_be_made_again(flown):
    folder, _ = flown
    before = (folder / 'report.html').read_text()
    (folder / 'report.html').unlink()
    done = rvd('report', str(folder), cwd=folder.parent)
    assert done.returncode == 0, done.stderr
    assert (folder / 'report.html').read_text() == before


@pytest.mark.slow
def test_killed_at_any_moment_and_resumed_gives_the_same_hash(flown):
    folder, said = flown
    home = folder.parent
    (home / 'killed').mkdir(exist_ok=True)
    out = home / 'killed' / 'c'
    running = subprocess.Popen(
        command('campaign', '../small.yaml', '--out', 'c', '--workers', '2', '--batch', '5'),
        cwd=home / 'killed', env=environment(), stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        wait_for(lambda: len(list((out / 'parts').glob('*.parquet'))) >= 3, 'part', 120.0)
        workers = pids_under(running.pid)
    finally:
        os.kill(running.pid, signal.SIGKILL)
        running.wait()
    assert workers
    wait_for(lambda: not any(alive(pid) for pid in workers), 'end of the workers', 20.0)
    finished = len(list((out / 'parts').glob('*.parquet')))
    assert 3 <= finished < 24
    assert not (out / 'results.parquet').exists()
    again = rvd('campaign', '--resume', 'killed/c', '--workers', '3', '--batch', '7', cwd=home,
                timeout=300.0)
    assert again.returncode == 0, again.stderr
    assert f'{5*finished} of 120 runs are there already' in again.stdout
    assert hash_of(again.stdout) == hash_of(said)
    rows = pyarrow.parquet.read_table(out / 'results.parquet').to_pydict()
    assert sorted(zip(rows['condition'], rows['run'])) == [
        (name, run) for name in ('manual', 'shared') for run in range(60)]


@pytest.mark.slow
def test_ctrl_c_says_how_to_go_on(flown, tmp_path):
    (tmp_path / 'small.yaml').write_text(SMALL.replace('runs: 60', 'runs: 5000'))
    running = start_rvd('campaign', 'small.yaml', '--out', 'c', '--workers', '2', '--batch', '5',
                        cwd=tmp_path)
    try:
        wait_for(lambda: len(list((tmp_path / 'c' / 'parts').glob('*.parquet'))) >= 2, 'part',
                 120.0)
        os.killpg(running.pid, signal.SIGINT)           # as a terminal does: to all of them
        assert running.wait(30.0) == 130
    finally:
        end(running)
    said = (tmp_path / 'out').read_text()
    assert re.search(r'stopped: \d+ of 10,000 runs are finished; go on with \./rvd campaign '
                     r'--resume c', said)
    assert 'Traceback' not in said
    wait_for(lambda: not pids_under(running.pid), 'end of the workers')


@pytest.mark.slow
def test_dask_cluster_of_two_workers_gives_the_same_hash(flown, tmp_path):
    folder, said = flown
    started = []

    def start(*args):
        started.append(subprocess.Popen(
            [sys.executable, '-m', *args], cwd=tmp_path, env=environment(),
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True))
    try:
        known = tmp_path / 'scheduler.json'
        start('distributed.cli.dask_scheduler', '--host', '127.0.0.1', '--port', '0',
              '--no-dashboard', '--scheduler-file', str(known))
        wait_for(known.exists, 'scheduler', 60.0)
        address = json.loads(known.read_text())['address']
        for _ in range(2):
            start('distributed.cli.dask_worker', address, '--nthreads', '1', '--no-nanny',
                  '--no-dashboard')
        from distributed import Client
        with Client(address, timeout=30, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=60)
            done = rvd('campaign', str(folder.parent / 'small.yaml'), '--out', 'c', '--backend',
                       'dask', '--scheduler', address, '--batch', '9', cwd=tmp_path,
                       timeout=300.0)
            workers = client.scheduler_info()['workers']
    finally:
        for process in reversed(started):       # a worker leaves while its scheduler still hears it
            end(process)
    assert done.returncode == 0, done.stderr
    assert hash_of(done.stdout) == hash_of(said)
    assert len(workers) == 2


@pytest.mark.slow
@pytest.mark.parametrize('condition', ['manual', 'shared'])
def test_a_run_over_dds_is_the_row_of_the_campaign(condition, flown):
    folder, _ = flown
    rows = pyarrow.parquet.read_table(folder / 'results.parquet').to_pydict()
    failed = [run for name, run, good in zip(rows['condition'], rows['run'], rows['success'])
              if name == condition and not good]
    run = failed[0] if failed else 0
    args = ('fly', '--from', str(folder), '--condition', condition, '--run', str(run))
    expected = 1 if failed else 0
    alone = rvd(*args, '--in-process', cwd=folder.parent)
    assert alone.returncode == expected, alone.stderr
    assert 'the same as in the campaign, to the last bit' in alone.stdout
    out = folder.parent / f'dds-{condition}'
    graph = rvd(*args, '--pace', 'lockstep', '--headless', '--out', str(out), cwd=folder.parent)
    assert graph.returncode == expected, graph.stderr
    assert 'the same as in the campaign, to the last bit' in graph.stdout
    at = next(i for i, key in enumerate(zip(rows['condition'], rows['run']))
              if key == (condition, run))
    verdict = json.loads((out / 'verdict.json').read_text())
    assert (verdict['reason'], verdict['seed'], verdict['run']) == (rows['reason'][at], 5, run)
    assert verdict['duration_s'] == rows['duration_s'][at]
    for name in ('min_corridor_margin_m', 'delta_v_m_s'):
        assert verdict['measures'][name]['value'] == rows[name][at]


REFUSED = {
    'nothing': ((), 'give a campaign file'),
    'unknown campaign': (('tabel3',), "no campaign 'tabel3': give a file or one of"),
    'zero runs': (('small.yaml', '--runs', '0'), 'runs must be a whole number, at least 1, got 0'),
    'zero workers': (('small.yaml', '--workers', '0'), '--workers must be 1 to 256, got 0'),
    'zero batch': (('small.yaml', '--batch', '0'), '--batch must be at least 1, got 0'),
    'folder that holds a campaign': (('small.yaml', '--out', 'c'), 'nothing is overwritten'),
    'folder that holds something': (('small.yaml', '--out', '.'), 'nothing is overwritten'),
    'resume elsewhere': (('--resume', '.'), 'is not the folder of a campaign'),
    'resume of another campaign': (('table3', '--resume', 'c'), 'holds another campaign'),
    'resume with other seed': (('other.yaml', '--resume', 'c'), 'holds another campaign'),
    'resume into another folder': (('--resume', 'c', '--out', 'd'), 'leave out --out'),
    'dask without address': (('small.yaml', '--backend', 'dask'), 'need each other'),
    'no address': (('small.yaml', '--backend', 'dask', '--scheduler', 'nowhere'),
                   "is tcp://HOST:PORT, got 'nowhere'"),
    'no scheduler there': (('small.yaml', '--backend', 'dask', '--scheduler', 'tcp://127.0.0.1:9'),
                           'no dask cluster at tcp://127.0.0.1:9: '),
    'ray that is not installed': (('small.yaml', '--backend', 'ray', '--scheduler', 'tcp://h:1'),
                                  'needs Ray here and on the cluster'),
    'no terabytes': (('small.yaml', '--runs', '9999999'), 'the limit is 10,000,000'),
}


@pytest.mark.parametrize('case', REFUSED)
def test_refusals_are_one_line_and_change_nothing(case, flown):
    folder, _ = flown
    home = folder.parent
    (home / 'other.yaml').write_text(SMALL.replace('seed: 5', 'seed: 6'))
    args, words = REFUSED[case]
    before = {p: p.stat().st_mtime_ns for p in folder.rglob('*')}
    done = rvd('campaign', *args, cwd=home)
    assert done.returncode == 2, done.stdout + done.stderr
    assert words in done.stderr
    assert done.stderr.count('\n') == 1 and done.stderr.startswith('rvd campaign: ')
    assert {p: p.stat().st_mtime_ns for p in folder.rglob('*')} == before


FROM = {
    'no condition': (('--run', '3'), 'needs --condition NAME and --run K'),
    'unknown condition': (('--condition', 'manul', '--run', '3'), 'did you mean manual?'),
    'run that was not flown': (('--condition', 'manual', '--run', '60'), 'runs 0 to 59, not 60'),
    'a scenario as well': (('paper', '--condition', 'manual', '--run', '3'), 'leave out SCENARIO'),
    'a mode as well': (('--mode', 'auto', '--condition', 'manual', '--run', '3'), '--mode'),
}


@pytest.mark.parametrize('case', FROM)
def test_bad_choices_of_a_run_are_one_line(case, flown):
    folder, _ = flown
    args, words = FROM[case]
    done = rvd('fly', *args, '--from', str(folder), cwd=folder.parent)
    assert done.returncode == 2
    assert words in done.stderr and done.stderr.count('\n') == 1


def test_disk_that_is_full_keeps_what_is_finished(tmp_path):
    """A limit on file size stands for the full disk: writing fails in the same place."""
    (tmp_path / 'small.yaml').write_text(SMALL)
    limit = 4096

    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    env = {**environment(), 'PYTHONDONTWRITEBYTECODE': '1'}
    (tmp_path / 'c').mkdir()
    done = subprocess.run(
        command('campaign', 'small.yaml', '--out', 'c', '--workers', '1'), cwd=tmp_path, env=env,
        capture_output=True, text=True, timeout=120.0, preexec_fn=small_files)
    assert done.returncode == 2, done.stderr
    assert done.stderr.count('\n') == 1 and 'File too large' in done.stderr
    assert not list((tmp_path / 'c').rglob('*.draft'))


@pytest.mark.slow
def test_memory_stays_far_below_a_gigabyte(tmp_path):
    """Peak memory of the process and each worker; what grows with runs is the table alone."""
    (tmp_path / 'small.yaml').write_text(SMALL.replace('runs: 60', 'runs: 1500'))
    running = start_rvd('campaign', 'small.yaml', '--out', 'c', '--workers', '2', cwd=tmp_path)
    peak: dict[int, int] = {}
    try:
        while running.poll() is None:
            for pid in {running.pid, *pids_under(running.pid)}:
                try:
                    with open(f'/proc/{pid}/status') as file:
                        found = re.search(r'VmHWM:\s+(\d+) kB', file.read())
                except OSError:
                    continue
                if found:
                    peak[pid] = max(peak.get(pid, 0), int(found[1]))
            time.sleep(0.1)
    finally:
        end(running)
    assert running.returncode == 0
    # 3,000 rows are 0.6 MB of table; 100,000 add 20 MB to this.
    assert sum(peak.values()) < 900_000, peak


@pytest.mark.slow
def test_calibrate_writes_a_pilot_that_a_campaign_takes(tmp_path):
    done = rvd('calibrate', 'C', '--runs', '400', '--quick', '--out', 'mine.yaml', cwd=tmp_path,
               timeout=400.0)
    assert done.returncode == 0, done.stderr
    text = (tmp_path / 'mine.yaml').read_text()
    assert 'condition 1 of the paper only' in text and '# fitted' in text
    (tmp_path / 'check.yaml').write_text(
        'seed: 7\nset: {pilot: mine.yaml, /**: {mode: manual}}\nruns: 400\n')
    flown = rvd('campaign', 'check.yaml', '--out', 'c', cwd=tmp_path, timeout=300.0)
    assert flown.returncode == 0, flown.stderr
    made = json.loads((tmp_path / 'c' / 'summary.json').read_text())['conditions'][0]
    # the same seed and runs as the fit, so the same successes: within what the fit leaves
    assert abs(made['success_rate'] - 0.76) <= 3/400
    again = rvd('calibrate', 'C', '--out', 'mine.yaml', cwd=tmp_path)
    assert again.returncode == 2 and 'nothing is overwritten' in again.stderr


def test_shipped_campaigns_are_listed():
    listed = rvd('list', 'campaigns', cwd=ROOT)
    assert [line.split()[0] for line in listed.stdout.splitlines()] == sorted(
        file.stem for file in (ROOT / 'campaigns').glob('*.yaml'))


@pytest.mark.slow
def test_statistics_of_the_headline_conditions(tmp_path):
    """
    Success of pilot A, manual and shared, 1,500 runs each, with the seed of the shipped table.

    The seed is fixed, so the outcome is too; the bounds are those in which a fresh seed would
    fall with a probability above .9999 if the true rates are .765 and .910.
    """
    (tmp_path / 'two.yaml').write_text(
        SMALL.replace('runs: 60', 'runs: 1500').replace('seed: 5', 'seed: 1'))
    done = rvd('campaign', 'two.yaml', '--out', 'c', cwd=tmp_path, timeout=500.0)
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / 'c' / 'summary.json').read_text())
    for c, rate in zip(summary['conditions'], (0.765, 0.910)):
        reach = 4.0*np.sqrt(rate*(1.0 - rate)/1500)
        assert abs(c['success_rate'] - rate) < reach
    assert summary['differences'][0]['paired95'][0] > 0.10
