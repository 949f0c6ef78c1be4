"""
A mission in somebody else's package, outside the workspace: built, flown, recorded, reported.

It is the package of docs/extending.md, copied to a folder of its own and built there as the page
says.
"""

from contextlib import contextmanager
import hashlib
from importlib.metadata import EntryPoint
import json
import os
from pathlib import Path
import re
import shutil
import subprocess
import sys
from zlib import crc32

import numpy as np
import pyarrow.parquet
import pytest
from console_page import chromium, Console, FLAGS, open_page, playwright, until
from runs import counts, messages, ROOT, verdict_of

from rvd_dynamics.diagram import in_process, mission, scenario, streams
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.roster import listed
from rvd_groundstation.console.provider import display_of

SOURCE = ROOT / 'tests' / 'stranger' / 'one_axis'
SCENARIO = SOURCE / 'scenarios' / 'one_axis.yaml'
PAGE = ROOT / 'docs' / 'extending.md'
TOPICS = {'/truth/state': 4, '/onboard/thruster_command': 3}    # numbers known in process, too
GROUPINGS = ('blocks', 'segments', 'one')
LANGUAGES = {'.py': 'python', '.xml': 'xml', '.cfg': 'ini', '.yaml': 'yaml'}

# Flies the scenario in one process and keeps what the bag has, in the order of the message.
IN_PROCESS = '''
import sys
from pathlib import Path
import numpy as np
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
history = fly(load(Path(sys.argv[1])), [0], record=True).history
np.savez(sys.argv[2], **{topic: np.concatenate(
    [part.reshape(len(part), -1).astype(float) for part in value if part is not None], axis=1)
    for topic, value in history.items() if topic in sys.argv[3:]})
'''


# -- the page and the package ------------------------------------------------------------------

def shown_files():
    """Return the files that the page shows: name, language of the block, text."""
    chapter = PAGE.read_text(encoding='utf-8').split('\n## A mission of your own\n')[1]
    return re.findall(r'^\*\*`([^`]+)`\*\*\n\n```(\w+)\n(.*?)^```$', chapter, re.M | re.S)


def test_the_page_shows_every_file_of_the_package_as_it_is():
    shown = shown_files()
    for name, language, text in shown:
        assert text == (SOURCE / name).read_text(encoding='utf-8'), name
        assert language == LANGUAGES[Path(name).suffix], name
    files = {str(path.relative_to(SOURCE)) for path in SOURCE.rglob('*')
             if path.is_file() and '__pycache__' not in path.parts}
    assert {name for name, *_ in shown} == files - {'resource/one_axis'}


def test_the_page_shows_no_code_that_is_not_a_file_but_the_flight_in_python():
    chapter = PAGE.read_text(encoding='utf-8').split('\n## A mission of your own\n')[1]
    blocks = re.findall(r'^```(\w+)\n(.*?)^```$', chapter, re.M | re.S)
    others = [text for language, text in blocks
              if language != 'bash' and text not in [shown for *_, shown in shown_files()]]
    assert len(others) == 1 and 'in_process import fly' in others[0]


# -- in this process, without building it ----------------------------------------------------------

@pytest.fixture
def one_axis(monkeypatch):
    """Return the scenario of the package, its mission found as if it were installed."""
    point = EntryPoint('one_axis', 'one_axis:MISSION', mission.GROUP)
    monkeypatch.setattr(mission, 'installed', lambda: {'one_axis': point})
    monkeypatch.syspath_prepend(str(SOURCE))
    yield scenario.load(SCENARIO)
    mission.find.cache_clear()


def test_its_command_form_keeps_every_command(one_axis):
    form = one_axis.part('form')
    step, most = form.thruster.step_m_s2, form.thruster.steps
    every = np.arange(-most, most + 1)[:, np.newaxis] * step
    np.testing.assert_array_equal(form.quantise(form.effect(every)), every)
    assert all(form.legal(command) for command in every.tolist())
    assert form.legal(form.neutral.tolist()) and form.legal(form.retreat.tolist())
    for illegal in (np.nan, np.inf, step / 2, (most + 1)*step):
        assert not form.legal([illegal])
    wanted = np.array([[np.nan], [np.inf], [9.0], [-9.0], [0.6*step]])
    np.testing.assert_array_equal(form.quantise(wanted),
                                  np.array([[0], [0], [most], [-most], [1]]) * step)


def test_it_berths_from_every_start_and_each_row_is_the_run_alone(one_axis):
    flown = in_process.fly(one_axis, range(50))
    assert flown.verdict.success.all() and set(flown.verdict.reason) == {'berthed'}
    assert flown.columns == {}
    alone = in_process.fly(one_axis, [37], record=True)
    assert alone.end_step[0] == flown.end_step[37]
    for name, values in flown.verdict.values.items():
        assert alone.verdict.values[name][0] == values[37]


def test_its_motion_is_the_double_integrator(one_axis):
    """By another road: sums of the commanded accelerations from the recorded start."""
    history = in_process.fly(one_axis, [3], record=True).history
    state, h = history['/truth/state'].state[:, 0], one_axis.run.step_s
    a = history['/onboard/thruster_command'].command[:-1, 0, 0]
    v = state[0, 1] + h*np.concatenate([[0.0], np.cumsum(a)])
    x = state[0, 0] + np.concatenate([[0.0], np.cumsum(h*v[:-1] + 0.5*h*h*a)])
    np.testing.assert_allclose(state, np.stack([x, v], axis=-1), atol=1e-12)


def test_its_command_acts_after_both_legs(one_axis):
    """Nothing is known on the ground before the back leg, nor on board before both."""
    history = in_process.fly(one_axis, [0], record=True).history
    back, forward = one_axis.part('legs').back, one_axis.part('legs').forward
    first = [np.flatnonzero(history[topic].command[:, 0, 0])[0]
             for topic in ('/ground/command', '/onboard/thruster_command')]
    assert first == [back, back + forward]


def test_an_abort_makes_the_guard_retreat_in_its_form(one_axis):
    form, legs = one_axis.part('form'), one_axis.part('legs')
    flown = in_process.fly(one_axis, [0, 1], schedule=[Change(50, abort=True)], record=True)
    thrust = flown.history['/onboard/thruster_command'].command
    burn = round(one_axis.settings('onboard_guard').abort_burn_s / one_axis.run.step_s)
    for row in range(2):
        away = np.flatnonzero(thrust[:, row, 0] == form.retreat[0])
        assert len(away) == burn and 50 < away[0] <= 50 + legs.forward
    assert set(flown.verdict.reason) == {'aborted'}


def test_its_chance_is_keyed_by_the_name_of_the_purpose(one_axis):
    plant = one_axis.diagram.by_name['plant']
    assert plant.draws['scatter'].purpose == 'one_axis/plant/scatter'
    number = crc32(b'one_axis/plant/scatter')
    expected = np.random.Generator(np.random.PCG64(np.random.SeedSequence(
        entropy=0, spawn_key=(7, number)))).standard_normal(2)
    np.testing.assert_array_equal(
        streams.generator(0, 7, 'one_axis/plant/scatter').standard_normal(2), expected)
    start = in_process.fly(one_axis, [7], record=['/truth/state']).history['/truth/state'].state[0]
    np.testing.assert_array_equal(start[0], [-10.0, 0.0] + np.array([0.5, 0.02])*expected)


def test_its_display_is_data(one_axis):
    display = made(one_axis.mission.display, one_axis.part, 'display')
    provider = display_of(one_axis)             # what the console makes of it
    assert provider.display == display
    assert (provider.facts.forward_s, provider.facts.back_s) == (0.6, 0.4)
    assert not provider.facts.acknowledged      # its sensor does not read what the guard says
    assert [solid.size_m for body in display.bodies for solid in body.shape] == [(1.0, 0.6, 0.6)]
    assert set(display.parts()) <= set(one_axis.diagram.signals)
    json.dumps(as_data(display))


def test_the_console_joins_it_as_a_watcher_only(one_axis):
    assert 'console' not in listed(one_axis, headless=True).names
    roster = listed(one_axis, headless=True, console=True)
    assert roster.names[:len(roster.blocks)] == tuple(roster.blocks) and 'console' in roster.names
    assert roster.writes('console') == frozenset()
    assert not [topic for topic in roster.reads('console') if not topic.startswith('/run/')]


# -- prefixes that cannot be loaded --------------------------------------------------------------

@pytest.mark.parametrize('command', [['list', 'laws'], ['shell', 'true'],
                                     ['node', 'one_axis', 'plant'], ['test', '--version']])
def test_a_prefix_that_is_missing_or_empty_is_one_line(command, tmp_path):
    for prefix, words in ((tmp_path / 'nowhere', 'no folder'), (tmp_path, 'holds no package')):
        done = subprocess.run([ROOT / 'rvd', *command], capture_output=True, text=True,
                              env={**os.environ, 'RVD_OVERLAY': f'{prefix}:'})
        assert (done.returncode, done.stdout, done.stderr.count('\n')) == (2, '', 1), done
        assert f'RVD_OVERLAY: {words}' in done.stderr.replace(f'{tmp_path} ', '')
        assert str(prefix) in done.stderr


def test_help_names_the_variable():
    done = subprocess.run([ROOT / 'rvd', 'help'], capture_output=True, text=True)
    assert 'RVD_OVERLAY' in done.stdout


# -- built and flown -----------------------------------------------------------------------------

class Stranger:
    """The package in a workspace of its own."""

    def __init__(self, place: Path) -> None:
        self.place, self.install = place, place / 'install'
        self.package = place / 'src' / 'one_axis'
        self.scenario = self.package / 'scenarios' / 'one_axis.yaml'
        self.before = project()
        shutil.copytree(SOURCE, self.package, ignore=shutil.ignore_patterns('__pycache__'))
        self.build('build', '--symlink-install')

    def build(self, *args: str) -> None:
        done = self.rvd('shell', 'colcon', *args, overlay='')
        assert done.returncode == 0, done.stderr

    def rvd(self, *args: object, overlay: object = None) -> subprocess.CompletedProcess:
        """Run `./rvd ARGS` in the workspace, with the package loaded unless told otherwise."""
        kept = {k: v for k, v in os.environ.items() if k not in ('ROS_DOMAIN_ID', 'RVD_OVERLAY')}
        overlay = self.install if overlay is None else overlay
        return subprocess.run([ROOT / 'rvd', *map(str, args)], cwd=self.place, timeout=240.0,
                              capture_output=True, text=True, stdin=subprocess.DEVNULL,
                              env={**kept, 'RVD_OVERLAY': str(overlay)})

    def fly(self, *args: object) -> subprocess.CompletedProcess:
        """Run `./rvd fly` on its scenario, as fast as possible."""
        return self.rvd('fly', self.scenario, '--pace', 'lockstep', '--headless', *args)

    @contextmanager
    def edited(self, name: str, old: str, new: str):
        """Change a file of the package for a while."""
        path = self.package / name
        text = path.read_text(encoding='utf-8')
        assert text.count(old) == 1, (name, old)
        path.write_text(text.replace(old, new), encoding='utf-8')
        try:
            yield
        finally:
            path.write_text(text, encoding='utf-8')


def project() -> dict[str, str]:
    """Return the files of the project that git would not ignore, with a hash of each."""
    names = subprocess.run(['git', 'ls-files', '-z', '--cached', '--others', '--exclude-standard'],
                           cwd=ROOT, capture_output=True, text=True, check=True).stdout.split('\0')
    return {name: hashlib.sha256((ROOT / name).read_bytes()).hexdigest()
            for name in names if (ROOT / name).is_file()}


@pytest.fixture(scope='module')
def stranger(tmp_path_factory):
    return Stranger(tmp_path_factory.mktemp('stranger'))


@pytest.fixture(scope='module')
def flights(stranger):
    """Return a run folder for each grouping of processes, all of seed 0."""
    found = {}
    for grouping in GROUPINGS:
        found[grouping] = stranger.place / grouping
        done = stranger.fly('--processes', grouping, '--out', found[grouping])
        assert done.returncode == 0, done.stderr
        assert 'at rest at the berth after' in done.stdout
    return found


def numbers(run: Path, topic: str) -> np.ndarray:
    """Return the values of a topic in a bag, as an independent reader decodes them."""
    return np.array([m.values for m in messages(run, topic)])


@pytest.mark.slow
def test_it_is_found_through_its_entry_point(stranger):
    with_it = stranger.rvd('list', 'missions')
    without = stranger.rvd('list', 'missions', overlay='')
    assert re.search(r'^one_axis +A craft comes to rest', with_it.stdout, re.M)
    assert 'one_axis' not in without.stdout and 'lunar_approach' in without.stdout


@pytest.mark.slow
def test_an_overlay_may_be_merged_or_the_prefix_of_one_package(stranger):
    stranger.build('--log-base', 'merged_log', 'build', '--merge-install',
                   '--build-base', 'merged_build', '--install-base', 'merged')
    for overlay in ('merged', 'install/one_axis', 'install', f'merged:{stranger.install}'):
        done = stranger.rvd('shell', '-c', 'cd / && python -c "import one_axis" && '
                            'echo "$AMENT_PREFIX_PATH" && "$RVD_ROOT"/rvd list missions',
                            overlay=overlay)
        assert 'A craft comes to rest' in done.stdout, done.stderr
        first = (stranger.place / overlay.split(':')[0]).resolve()
        assert done.stdout.startswith(str(first)), overlay


@pytest.mark.slow
def test_every_grouping_and_the_loop_in_one_process_give_the_same_bits(stranger, flights):
    kept = stranger.place / 'in_process.npz'
    done = stranger.rvd('shell', sys.executable, '-c', IN_PROCESS, stranger.scenario, kept, *TOPICS)
    assert done.returncode == 0, done.stderr
    for topic, width in TOPICS.items():
        flown = [numbers(run, topic) for run in flights.values()]
        assert len({values.tobytes() for values in flown}) == 1, topic
        alone = np.load(kept)[topic]
        assert alone.shape[1] == width
        assert alone.tobytes() == np.ascontiguousarray(flown[0][:, :width]).tobytes(), topic


@pytest.mark.slow
def test_its_bag_holds_every_step_of_every_topic(flights):
    for run in flights.values():
        found, truth = counts(run), messages(run, '/truth/state')
        assert truth[0].layout == 'state[2], acceleration[1], final'
        assert [m.step for m in truth] == list(range(len(truth)))
        assert [bool(m.values[-1]) for m in truth] == [False]*(len(truth) - 1) + [True]
        for topic in ('/onboard/downlink', '/ground/telemetry', '/ground/command',
                      '/ground/uplink', '/onboard/command', '/onboard/thruster_command',
                      '/link/back/status', '/link/forward/status', '/clock'):
            assert found[topic] == len(truth), topic
        text = (run / 'scenario.yaml').read_text(encoding='utf-8')
        assert messages(run, '/run/scenario')[0].data == text and 'mission: one_axis' in text


@pytest.mark.slow
def test_its_verdict_is_that_of_its_judge(flights):
    first = verdict_of(flights['blocks'])
    assert [first[key] for key in ('success', 'reason', 'mission', 'mode', 'operator')] == [
        True, 'berthed', 'one_axis', None, None]
    assert list(first['measures']) == ['overshoot_m', 'delta_v_m_s']
    assert first['measures']['overshoot_m']['limit'] == 0.2
    assert all(verdict_of(run) == first for run in flights.values())


@pytest.mark.slow
def test_its_report_has_its_figure_and_is_made_again_from_the_bag(stranger, flights):
    run = flights['one']
    flown = (run / 'report.html').read_text(encoding='utf-8')
    assert flown.count('<svg') == 2                     # its own, and that of the link
    assert 'the craft must stay below the dashed line' in ' '.join(flown.split())
    assert 'Commands refused by the onboard guard: none' in flown
    for topic in ('/truth/state', '/ground/command'):
        assert topic in flown
    done = stranger.rvd('report', run)
    assert done.returncode == 0, done.stderr
    assert (run / 'report.html').read_text(encoding='utf-8') == flown


@pytest.mark.slow
def test_its_report_without_the_package_says_why_there_is_no_figure(stranger, flights, tmp_path):
    (tmp_path / 'bag').symlink_to(flights['one'] / 'bag')
    done = stranger.rvd('report', tmp_path, overlay='')
    assert done.returncode == 0, done.stderr
    page = (tmp_path / 'report.html').read_text(encoding='utf-8')
    assert 'At rest at the berth' in page and 'There are no figures' in page
    assert '&#39;one_axis&#39; is installed' in page


@pytest.mark.slow
def test_the_console_shows_it(stranger):
    playwright_entry, browser_path = playwright(), chromium()
    console = Console(stranger.place, str(stranger.scenario), '--pace', '5', '--out',
                      str(stranger.place / 'watched'), overlay=stranger.install)
    try:
        with playwright_entry() as play:
            browser = play.chromium.launch(executable_path=browser_path, args=FLAGS)
            page = open_page(browser, console)
            words = page.inner_text('#instruments')
            assert 'position' in words and 'speed' in words         # before the first run
            page.keyboard.press('t')
            until(page, "rvd.store.status.lease === 'you'")
            page.keyboard.press('n')
            page.click('#new-start')
            until(page, 'Boolean(rvd.store.measured)')
            page.wait_for_timeout(1000)
            assert page.evaluate("rvd.scene.covers('craft')") > 20
            assert page.evaluate("rvd.scene.covers('track')") > 20
            assert page.evaluate('rvd.store.measured.parts.state.length') == 2
            assert not page.evaluate("JSON.stringify(rvd.store.frame).includes('truth')")
            for panel in ('camera', 'cut', 'strips', 'modes', 'views'):
                assert not page.is_visible(f'#{panel}'), panel
            until(page, "document.querySelector('#verdict-words') !== null")
            assert 'At rest at the berth' in page.inner_text('#verdict-words')
            assert 'farthest beyond the berth' in page.inner_text('#dialog')
            told = page.evaluate('[...rvd.store.ladder.values()].map((rung) => rung.state)')
            assert set(told) <= {0, 1, 6} and 6 in told             # sent, due; else unknown
            until(page, "rvd.store.status.phase === 'ended'")
            page.keyboard.press('Escape')
            page.keyboard.press('l')
            until(page, "document.querySelector('[data-run]') !== null")
            page.click('[data-run="watched"]')
            until(page, "document.querySelector('#dialog').open === false")
            until(page, "rvd.scene.covers('craft') > 20")
            assert page.problems == []
            browser.close()
    finally:
        console.close()


@pytest.mark.slow
def test_its_campaign_has_its_measures_as_columns(stranger):
    folder = stranger.place / 'campaign'
    done = stranger.rvd('campaign', stranger.package / 'campaigns' / 'gains.yaml', '--runs', 40,
                        '--workers', 1, '--out', folder)
    assert done.returncode == 0, done.stderr
    summary = json.loads((folder / 'summary.json').read_text(encoding='utf-8'))
    rates = {c['name']: c['success_rate'] for c in summary['conditions']}
    assert rates == {'damping_per_s=0.1': 0.0, 'damping_per_s=0.2': 0.0, 'damping_per_s=0.4': 1.0}
    table = pyarrow.parquet.read_table(folder / 'results.parquet')
    assert table.column_names == ['condition', 'seed', 'run', 'success', 'reason', 'duration_s',
                                  'overshoot_m', 'delta_v_m_s']
    assert table.num_rows == 120
    page = (folder / 'report.html').read_text(encoding='utf-8')
    assert 'farthest beyond the berth' in page
    assert stranger.rvd('report', folder).returncode == 0
    again = stranger.rvd('fly', '--from', folder, '--condition', 'damping_per_s=0.4', '--run', 3,
                         '--in-process')
    assert again.returncode == 0, again.stderr


BROKEN = {
    'the ground reads truth': (
        'one_axis/diagram.py', "reads={'telemetry': now(TELEMETRY)}",
        "reads={'telemetry': now(TELEMETRY), 'truth': now(TRUTH)}",
        'block controller of segment ground reads /truth/state: truth is for the world'),
    'a second writer of thrust': (
        'one_axis/diagram.py', "writes={'command': command, 'uplink': UPLINK}",
        "writes={'command': command, 'uplink': UPLINK, 'thrust': THRUST}",
        'block onboard_guard writes /onboard/thruster_command as thrust, which controller.thrust '
        'writes too'),
    'a thrust without an initial value': (
        'one_axis/signals.py', ', initial=0.0', '',
        'block onboard_guard writes /onboard/thruster_command, whose command has no initial value'),
    'a wrong shape': (
        'one_axis/space.py', 'DOWNLINK(state=truth.state + self._sigma*self._noise[..., k, :])',
        'DOWNLINK(state=truth.state[..., :1])',
        'block sensor writes /onboard/downlink at step 0: state must have shape (2,), got (1,)'),
    'a command that is NaN': (
        'one_axis/ground.py', 'command = self._form.quantise(wanted)', 'command = wanted',
        'block controller writes /ground/command at step 0: a command must be finite, got [nan]'),
    'a command that is none of the form': (
        'one_axis/ground.py', 'command = self._form.quantise(wanted)',
        'command = self._form.quantise(wanted) + 0.0005',
        'block controller writes /ground/uplink at step 0: command must be a command of Accele'),
    'a class that is not there': (
        'one_axis/diagram.py', 'one_axis.ground:Controller', 'one_axis.grund:Controller',
        'block controller: one_axis.grund:Controller cannot be loaded'),
    'something that nobody has': (
        'one_axis/ground.py', 'form: AccelerationForm, batch: tuple',
        'form: AccelerationForm, sharing: object, batch: tuple',
        "block controller: one_axis.ground:Controller needs 'sharing', which neither"),
    'a package without the executable': (
        'one_axis/diagram.py', "GROUND, package='one_axis'", 'GROUND',
        'package rvd_groundstation has no executable controller'),
    'a mission that is not installed': (
        'scenarios/one_axis.yaml', 'mission: one_axis', 'mission: two_axes',
        "no mission 'two_axes' is installed; there are: "),
}
NEEDS_BLOCKS = ('a package without the executable',)


@pytest.mark.slow
@pytest.mark.parametrize('what', BROKEN)
def test_what_is_broken_is_one_line_that_names_it(stranger, what, tmp_path):
    name, old, new, words = BROKEN[what]
    grouping = 'blocks' if what in NEEDS_BLOCKS else 'one'
    with stranger.edited(name, old, new):
        done = stranger.fly('--processes', grouping, '--out', tmp_path / 'run')
    assert done.returncode == 2, done
    said = done.stderr.splitlines()
    assert words in said[0]
    assert [line for line in said[1:] if 'logs are in' not in line] == []


@pytest.mark.slow
@pytest.mark.parametrize('grouping', ['blocks', 'one'])
def test_a_fault_in_its_code_is_told_from_bad_input(stranger, grouping, tmp_path):
    with stranger.edited('one_axis/ground.py', 'command = self._form.quantise(wanted)',
                         'command = self._form.quantise(wanted)[..., 7]'):
        done = stranger.fly('--processes', grouping, '--out', tmp_path / 'run')
    assert done.returncode == 3, done
    node = 'one' if grouping == 'one' else 'controller'
    log = (tmp_path / 'run' / 'logs' / f'{node}.log').read_text()
    assert 'Traceback' in log and 'ground.py' in log and 'IndexError' in log
    assert f'{node} ended with code 1' in done.stderr and 'IndexError' in done.stderr


@pytest.mark.slow
def test_all_this_has_touched_no_file_of_the_project(stranger, flights):
    assert project() == stranger.before
