"""
The same rows and the same hash, however the work was split, interrupted or shared out.
"""

import errno
import io
import json
import pickle
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet
import pytest

from rvd_campaign.campaign import engine, results, software
from rvd_campaign.campaign.engine import (
    check_same, fly_campaign, KEPT, open_folder, PARTS, RESULTS, sole_writer, start, Workers)
from rvd_campaign.campaign.progress import clock, Progress
from rvd_campaign.campaign.results import Stretch
from rvd_campaign.campaign.spec import CampaignError, parse_campaign
from rvd_campaign.campaign.summary import finish
from rvd_dynamics.diagram.in_process import fly
from rvd_missions.lunar_approach import columns

TEXT = '''
seed: 8
runs: 30
set: {pilot: A}
conditions:
  manual: {/**: {mode: manual}}
  shared: {}
  rough: {link_forward: {loss_fraction: 0.3}, link_back: {loss_fraction: 0.3}}
'''


MEASURES = ['x_rate_m_s', 'offset_m', 'lateral_rate_m_s', 'min_corridor_margin_m', 'delta_v_m_s']


def flown(folder, workers=Workers(), text=TEXT, runs=None):
    """Fly the campaign into a new folder; return its summary."""
    folder.mkdir()
    campaign = parse_campaign(text, 'small', runs=runs)
    start(campaign, folder)
    fly_campaign(campaign, folder, workers, quiet())
    return finish(campaign, folder)


def quiet():
    return Progress(io.StringIO())


@pytest.fixture(scope='module')
def once(tmp_path_factory):
    """The campaign flown in one process, 30 runs at a time: folder and summary."""
    folder = tmp_path_factory.mktemp('once') / 'c'
    return folder, flown(folder)


@pytest.mark.parametrize('batch', [1, 3])
def test_batch_changes_nothing(batch, once, tmp_path):
    made = flown(tmp_path / 'c', Workers(batch=batch), runs=4)
    whole = flown(tmp_path / 'whole', runs=4)
    assert made['result_hash'] == whole['result_hash'] != once[1]['result_hash']


@pytest.mark.slow
@pytest.mark.parametrize('count', [2, 3])
def test_workers_change_nothing(count, once, tmp_path):
    made = flown(tmp_path / 'c', Workers(count, batch=11))
    assert made['result_hash'] == once[1]['result_hash']


def test_resume_adds_what_is_missing_and_nothing_twice(once, tmp_path):
    folder = tmp_path / 'c'
    shutil.copytree(once[0], folder)
    campaign, _ = open_folder(folder)
    parts = sorted((folder / PARTS).iterdir())
    parts[1].unlink()                                           # never flown
    parts[2].write_bytes(parts[2].read_bytes()[:-100])          # cut off by a crash
    (folder / PARTS / 'c0000-r0000000000-n30.parquet.draft').write_bytes(b'half')
    progress = quiet()
    fly_campaign(campaign, folder, Workers(batch=4), progress)
    assert progress.flown == 60
    assert finish(campaign, folder)['result_hash'] == once[1]['result_hash']


def test_more_runs_keep_the_first_ones(once, tmp_path):
    folder = tmp_path / 'c'
    shutil.copytree(once[0], folder)
    more = parse_campaign(TEXT, 'small', runs=34)
    progress = quiet()
    fly_campaign(more, folder, Workers(), progress)
    assert progress.flown == 3*4
    assert finish(more, folder)['result_hash'] == flown(
        tmp_path / 'new', runs=34)['result_hash']
    fewer = parse_campaign(TEXT, 'small', runs=30)
    assert finish(fewer, folder)['result_hash'] == once[1]['result_hash']


def test_rows_are_those_of_the_loop(once):
    campaign, _ = open_folder(once[0])
    for name, table in results.tables(once[0] / RESULTS):
        alone = fly(campaign.condition(name).scenario, [17])
        verdict = alone.verdict
        assert table['reason'][17] == verdict.reason[0]
        np.testing.assert_array_equal(table['duration_s'][17], verdict.duration[0])
        for column in MEASURES:
            np.testing.assert_array_equal(table[column][17], verdict.values[column][0])
        assert table['steps'][17] == alone.end_step[0]
        decided = sum(table[f'steps_{by}'] for by in ('nobody', 'pilot', 'auto', 'blend'))
        np.testing.assert_array_equal(decided, table['steps'])


def test_terminal_position_fits_the_offset_and_failures_have_time_and_place(once):
    for _, table in results.tables(once[0] / RESULTS):
        good = table['success']
        np.testing.assert_allclose(np.hypot(table['y_m'], table['z_m']), table['offset_m'])
        for column in ('failed_at_s', 'failed_x_m', 'failed_y_m', 'failed_z_m'):
            assert np.isnan(table[column][good]).all()
            assert np.isfinite(table[column][~good]).all()
        left = table['reason'] == 'left_corridor'       # on the cone: rho = d - x tan(alpha)
        wall = 0.3 - table['failed_x_m'][left]*np.tan(np.radians(3.0))
        outside = table['failed_at_s'][left] == 0.0     # those that started outside
        rho = np.hypot(table['failed_y_m'][left], table['failed_z_m'][left])
        np.testing.assert_allclose(rho[~outside], wall[~outside], atol=1e-6)


def test_columns_of_the_table_are_those_that_the_mission_orders(once):
    for _, table in results.tables(once[0] / RESULTS):
        assert list(table) == [name for name in columns.ORDER if not name.endswith('?')]
        assert [results.kind_of(*column) for column in table.items()] == (
            ['i8', '?', 'U'] + ['f8']*14 + ['i8']*6)


def test_means_of_the_summary_are_those_of_the_table(once):
    for (_, table), c in zip(results.tables(once[0] / RESULTS), once[1]['conditions']):
        good = table['success']
        for name, mean in c['means'].items():
            assert mean == pytest.approx(table[name][good].mean(), rel=1e-12)
        for name, mean in c['means_of_all_runs'].items():
            assert mean == pytest.approx(table[name].mean(), rel=1e-12)
        assert sum(c['share_of_steps'][by] for by in ('nobody', 'pilot', 'auto', 'blend')) == (
            pytest.approx(1.0))


def test_result_file_reads_as_any_parquet_file(once):
    table = pyarrow.parquet.read_table(once[0] / RESULTS).to_pydict()
    assert list(table)[:3] == ['condition', 'seed', 'run']
    assert len(table['run']) == 90
    assert set(table['seed']) == {8}
    assert hash_of(once[0] / RESULTS) == once[1]['result_hash']


def hash_of(path):
    """Return the hash of the rows that a file holds."""
    made = results.ResultFile(io.BytesIO(), seed=8)
    for name, table in results.tables(path):
        made.add(name, table)
    return made.hash


def test_hash_sees_values_and_not_the_file_format(once, tmp_path):
    again = tmp_path / 'again.parquet'
    table = pyarrow.parquet.read_table(once[0] / RESULTS)
    pyarrow.parquet.write_table(table, again, compression='gzip', row_group_size=17)
    assert hash_of(again) == once[1]['result_hash']
    at = table.column_names.index('offset_m')
    moved = table['offset_m'].to_numpy().copy()
    moved[5] = np.nextafter(moved[5], 1.0)
    pyarrow.parquet.write_table(table.set_column(at, 'offset_m', [moved]), again)
    assert hash_of(again) != once[1]['result_hash']


def test_summary_has_the_promised_shape(once):
    summary = json.loads(json.dumps(once[1]))
    for c in summary['conditions']:
        assert {'name', 'runs', 'successes', 'success_rate', 'wilson95', 'means',
                'runs_per_s'} <= set(c)
        assert list(c['means']) == list(c['standard_errors']) == MEASURES
        assert {'min_corridor_margin_m', 'delta_v_m_s'} <= set(c['means_of_all_runs'])
        low, high = c['wilson95']
        assert low <= c['success_rate'] <= high
        assert sum(c['reasons'].values()) == c['runs'] == 30
        assert c['runs_per_s'] > 0
    assert [(d['a'], d['b']) for d in summary['differences']] == [
        ('shared', 'manual'), ('rough', 'manual')]


# -- folders -----------------------------------------------------------------------------------

def test_folder_of_another_campaign_is_refused(once):
    campaign, kept = open_folder(once[0])
    check_same(once[0], kept, campaign)
    for other in ('seed: 9\n', 'set: {pilot: C}\n'):
        head = other.split(':')[0]
        text = '\n'.join(line for line in TEXT.splitlines() if not line.startswith(head))
        with pytest.raises(CampaignError, match='holds another campaign'):
            check_same(once[0], kept, parse_campaign(text + '\n' + other, 'small'))


def test_folder_of_other_sources_is_refused(once):
    campaign, kept = open_folder(once[0])
    for name, words in (('code', 'another version of this software'), ('numpy', 'numpy 0.1')):
        changed = {**kept, 'identity': {**kept['identity'], name: '0.1'}}
        with pytest.raises(CampaignError, match=words):
            check_same(once[0], changed, campaign)


def test_folder_that_is_none_or_damaged(tmp_path):
    with pytest.raises(CampaignError, match='not the folder of a campaign'):
        open_folder(tmp_path)
    (tmp_path / KEPT).write_text('{"campaign": {}}')
    with pytest.raises(CampaignError, match='damaged'):
        open_folder(tmp_path)


def test_a_folder_that_does_not_say_what_was_flown_is_refused(once):
    campaign, kept = open_folder(once[0])
    for identity in ({}, None, 'x'):
        with pytest.raises(CampaignError, match='damaged'):
            check_same(once[0], {**kept, 'identity': identity}, campaign)


def test_a_folder_whose_parts_were_removed_is_flown_anew(tmp_path):
    with sole_writer(tmp_path):
        assert not list((tmp_path / PARTS).iterdir())
    with pytest.raises(CampaignError, match='cannot write into'):
        with sole_writer(tmp_path / 'gone'):
            pass


def test_two_processes_cannot_fly_into_one_folder(once):
    with sole_writer(once[0]):
        with pytest.raises(CampaignError, match='another process'):
            with sole_writer(once[0]):
                pass


def test_disk_that_is_too_small_is_refused_at_once(once, monkeypatch):
    monkeypatch.setattr(shutil, 'disk_usage', lambda _: shutil._ntuple_diskusage(9, 8, 1 << 20))
    with pytest.raises(CampaignError, match='need about 12 MB of disk, 1 MB are free'):
        engine.check_space(once[0], 20_000)


def test_disk_that_fills_up_keeps_what_is_finished(once, tmp_path, monkeypatch):
    folder, write = tmp_path / 'c', results.write_part
    folder.mkdir()
    campaign = parse_campaign(TEXT, 'small')
    start(campaign, folder)

    def full(parts, stretch, table, seconds):
        if stretch.condition == 2:
            raise OSError(errno.ENOSPC, 'No space left on device')
        write(parts, stretch, table, seconds)
    monkeypatch.setattr(results, 'write_part', full)
    with pytest.raises(CampaignError, match='No space left on device.*--resume'):
        fly_campaign(campaign, folder, Workers(), quiet())
    assert len(results.finished(folder / PARTS)) == 2
    monkeypatch.setattr(results, 'write_part', write)
    fly_campaign(campaign, folder, Workers(), quiet())
    assert finish(campaign, folder)['result_hash'] == once[1]['result_hash']


def test_worker_with_other_sources_is_refused(once):
    campaign, _ = open_folder(once[0])
    with pytest.raises(CampaignError, match='a worker has another version'):
        engine.fly_together([(campaign.conditions[0].scenario, Stretch(0, 0, 1))], ('x',), 1)


def test_a_scenario_travels_light_and_arrives_as_it_was():
    campaign = parse_campaign(TEXT, 'small')
    for condition in campaign.conditions:
        sent = pickle.dumps(condition.scenario)
        arrived = pickle.loads(sent)
        assert len(sent) < 3000                 # names and values, nothing that is built of them
        assert arrived == condition.scenario and arrived.mission is campaign.mission
        assert arrived.resolved() == condition.scenario.resolved()


def test_sources_of_the_mission_count(monkeypatch):
    campaign = parse_campaign(TEXT, 'small')
    own = replace(campaign.mission, name='other', diagram='statistics:diagram')
    assert software.code_hash(campaign.mission) != software.code_hash(own)
    assert software.software(campaign.mission)[1:] == tuple(software.versions().values())


LOADED = """
import sys
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse
short = parse('/**: {ros__parameters: {timeout_s: 3}}', 'short')
for operator in ('model', 'replay', 'none'):
    taped = short.with_values('joystick_replay', tape=sys.argv[1])
    fly(taped.with_values('/**', operator=operator), range(2))
print(*(m.__file__ for n, m in sys.modules.items() if n.startswith('rvd_') and m.__file__))
"""


def test_every_module_that_the_loop_loads_counts(tmp_path):
    tape = tmp_path / 'tape.csv'
    tape.write_text('t_s,axis_0,axis_1,axis_2\n0,0,0,0\n')
    done = subprocess.run([sys.executable, '-c', LOADED, str(tape)], check=True,
                          capture_output=True, text=True)
    counted = {path.resolve() for _, path in
               software.sources(parse_campaign(TEXT, 'small').mission)}
    loaded = {Path(file).resolve() for file in done.stdout.split()}
    assert len(loaded) > 60 and not loaded - counted


EDITED = {
    'rvd_groundstation/console/server.py': False, 'rvd_groundstation/console/feed.py': False,
    'rvd_dynamics/diagram/ros/host.py': False, 'rvd_dynamics/recording/drawing.py': False,
    'rvd_dynamics/diagram/display/scene.py': False, 'rvd_missions/lunar_approach/figures.py': False,
    'rvd_missions/lunar_approach/display.py': False, 'rvd_missions/lunar_approach/judge.py': True,
    'rvd_dynamics/motion/cw.py': True, 'rvd_groundstation/guidance/barrier.py': True,
    'rvd_groundstation/operators/tape.py': True, 'rvd_dynamics/diagram/in_process.py': True,
    'rvd_missions/lunar_approach/columns.py': True,
    'rvd_missions/attitude_hold/judge.py': False, 'rvd_missions/obstacle_field/space.py': False}


@pytest.mark.parametrize('edited, counts', EDITED.items())
def test_a_campaign_is_another_one_after_an_edit_of_what_makes_its_numbers(
        edited, counts, monkeypatch):
    mission = parse_campaign(TEXT, 'small').mission
    before, read_bytes = software.code_hash(mission), Path.read_bytes
    met = []

    def with_edit(path):
        if path.as_posix().endswith(edited):
            met.append(path)
            return read_bytes(path) + b'# edited'
        return read_bytes(path)
    monkeypatch.setattr(Path, 'read_bytes', with_edit)
    monkeypatch.setattr(software, '_code_hash', software._code_hash.__wrapped__)
    assert (software.code_hash(mission) != before) == bool(met) == counts


def test_of_the_missions_beside_it_those_that_a_mission_names_count(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    for folder in ('', 'mine', 'named', 'other'):
        (tmp_path / 'set_of_missions' / folder).mkdir(exist_ok=True)
        (tmp_path / 'set_of_missions' / folder / '__init__.py').touch()
    (tmp_path / 'set_of_missions/mine/diagram.py').write_text(
        'from set_of_missions.named.laws import Law\n')
    (tmp_path / 'set_of_missions/named/laws.py').write_text('class Law: ...\n')
    mine = replace(parse_campaign(TEXT, 'small').mission, name='mine', figures='', display='',
                   diagram='set_of_missions.mine.diagram:diagram')
    assert {name for name, _ in software.sources(mine) if name.startswith('set_')} == {
        f'set_of_missions/{name}.py' for name in (
            '__init__', 'mine/__init__', 'mine/diagram', 'named/__init__', 'named/laws')}


@pytest.mark.parametrize('line, counts', {
    'from odd_mission.figures import SCALE': True, 'from odd_mission import figures': True,
    'import odd_mission.figures': True, 'from .figures import SCALE': True,
    'from . import figures': True, 'from another.figures import SCALE': False}.items())
def test_figures_that_the_loop_uses_count_after_all(line, counts, tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    package = tmp_path / 'odd_mission'
    package.mkdir()
    for name in ('__init__', 'figures', 'display'):
        (package / f'{name}.py').write_text('')
    (package / 'diagram.py').write_text(f'{line}\n')
    odd = replace(parse_campaign(TEXT, 'small').mission, name='odd',
                  diagram='odd_mission.diagram:diagram', figures='odd_mission.figures:FIGURES',
                  display='odd_mission.display:display')
    assert {name for name, _ in software.sources(odd) if name.startswith('odd_')} == {
        'odd_mission/__init__.py', 'odd_mission/diagram.py',
        *(['odd_mission/figures.py'] if counts else [])}


def test_conditions_share_draws_only_where_they_are_the_same():
    campaign = parse_campaign(TEXT, 'small')
    todo = engine.stretches(campaign, [Stretch(1, 0, 10)], Workers(batch=10))
    made = [[(s.condition, s.first) for _, s in task] for task in engine.tasks(campaign, todo)]
    assert made == [[(0, 0)], [(2, 0)], [(0, 10), (1, 10)], [(2, 10)], [(0, 20), (1, 20)],
                    [(2, 20)]]


def test_gaps_between_stretches():
    there = [Stretch(0, 4, 3), Stretch(0, 10, 5), Stretch(1, 0, 99), Stretch(0, 30, 5)]
    assert list(results.missing(there, 0, 20)) == [range(0, 4), range(7, 10), range(15, 20)]
    assert list(results.missing(there, 1, 20)) == []
    assert list(results.missing([], 2, 5)) == [range(0, 5)]


def test_table_with_a_run_missing_or_twice_is_refused(once, tmp_path):
    folder = tmp_path / PARTS
    shutil.copytree(once[0] / PARTS, folder)
    done = [s for s in results.finished(folder) if s.condition == 0]
    assert len(results.condition_table(folder, done, 0, 30)['run']) == 30
    for wrong in (done*2, [Stretch(0, 0, 30)]*2):
        with pytest.raises(ValueError, match='each run once'):
            results.condition_table(folder, wrong, 0, 30)
    with pytest.raises(ValueError, match='each run once'):
        results.condition_table(folder, done, 0, 31)


def test_progress_says_rate_and_time_left(monkeypatch):
    said, now = io.StringIO(), [0.0]
    monkeypatch.setattr('time.monotonic', lambda: now[0])
    progress = Progress(said)
    progress.begin(100, 1100)
    now[0] = 20.0
    progress.add(400)
    assert said.getvalue().splitlines() == [
        '100 of 1,100 runs are there already', '500 of 1,100 runs (45 %), 20 runs/s, 30 s left']
    assert [clock(s) for s in (9, 75, 7800)] == ['9 s', '1 min 15 s', '2 h 10 min']
