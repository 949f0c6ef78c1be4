"""Figures are functions of a recording: of a bag and of an in-process history alike."""

from dataclasses import replace
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
import pytest
import small_run
from small_run import HOLD, LAST, write_run

from rvd_campaign.report.figures import figures_of, LINKS
from rvd_campaign.report.run import page
from rvd_dynamics.diagram import in_process
from rvd_dynamics.diagram.block import Block, now, WATCH
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.display import Flat
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.recording.drawing import png, svg
from rvd_dynamics.recording.history import everything, of_history
from rvd_dynamics.recording.reader import read
from rvd_groundstation.console.provider import display_of
from rvd_missions.lunar_approach.diagram import diagram as lunar_diagram
from rvd_missions.lunar_approach.figures import FIGURES, prediction_error
from rvd_missions.lunar_approach.signals import TRUTH

ALL = {**FIGURES, 'links': LINKS}
SHORT = '''
/**: {ros__parameters: {seed: 4, timeout_s: 40.0}}
link_forward:
  ros__parameters: {loss_fraction: 0.1, corrupt_fraction: 0.1, duplicate_fraction: 0.2}
'''


@pytest.fixture(scope='module')
def bag(tmp_path_factory):
    return read(write_run(tmp_path_factory.mktemp('runs') / 'whole'))


@pytest.fixture(scope='module')
def scenario():
    return parse(SHORT, 'short')


@pytest.fixture(scope='module')
def history(scenario):
    """The second of three runs, with all that can be recorded."""
    return of_history(scenario, in_process.fly(scenario, [0, 7, 8], record=everything(scenario)), 1)


@pytest.fixture(params=['bag', 'history'])
def recording(request):
    return request.getfixturevalue(request.param)


def line(figure, label):
    """Return the data of the first line of that label."""
    return next(artist.get_xydata() for axes in figure.axes for artist in axes.lines
                if artist.get_label() == label)


# -- of either kind --------------------------------------------------------------------------------

@pytest.mark.parametrize('name', ALL)
def test_drawing_has_no_colour_of_its_own_and_its_text_is_text(recording, name):
    drawing = svg(name, lambda: ALL[name].draw(recording))
    root = ElementTree.fromstring(drawing.replace('xlink:href', 'href'))
    assert root.tag == 'svg' and root.get('viewBox')
    assert not re.search(r'#[0-9a-f]{6}', drawing)
    assert '[s]' in drawing or '[m]' in drawing
    assert drawing.count('<text') > 10


@pytest.mark.parametrize('name', ALL)
def test_every_figure_has_a_text_for_those_who_do_not_see_it(recording, name):
    drawing = svg(name, lambda: ALL[name].draw(recording))
    text = re.match(r'<svg viewBox="[^"]*" role="img" aria-label="([^"]*)">', drawing)[1]
    assert text.count('Panel ') >= 2 and ' from ' in text and '[' in text


def test_views_are_those_of_the_console(bag):
    side, top, end = FIGURES['approach'].draw(bag).axes
    shown = display_of(bag.scenario).display
    console = {view.label: view for view in shown.views if isinstance(view, Flat)}
    for axes, name in ((side, 'Side'), (top, 'Top')):
        view = console[name]
        assert axes.get_title().startswith(name)
        assert axes.get_ylabel()[0] == view.up[1]
        assert axes.yaxis_inverted() == (view.up[0] == '-')
        assert view.right == '+x' and not axes.xaxis_inverted()
    section = shown.section
    assert ['+' + end.get_xlabel()[0], '+' + end.get_ylabel()[0]] == [section.right, section.up]
    state = bag.of(TRUTH).state
    near = state[state[:, 0] > -2.0]
    assert len(near) > 4 and not end.xaxis_inverted() and not end.yaxis_inverted()
    assert_array_equal(end.lines[0].get_xydata(), near[:, [2, 1]])


def test_every_figure_is_drawn_of_either(recording):
    assert list(figures_of(recording)) == list(ALL)


@pytest.mark.parametrize('name', ALL)
def test_a_figure_names_signals_that_there_are_and_says_how_to_read_it(scenario, name):
    figure, signals = ALL[name], scenario.diagram.signals
    for named in (*figure.signals, *figure.also):
        topic, _, part = named.partition('.')
        assert topic in signals
        assert not part or part in {p.name for p in signals[topic].parts}
    assert figure.title and figure.caption.endswith('.')


@pytest.mark.parametrize('name', FIGURES)
def test_a_figure_is_left_out_without_a_signal_that_it_needs_and_drawn_without_the_others(
        scenario, name):
    figure = FIGURES[name]
    needed = of_history(scenario, in_process.fly(scenario, [0], record=figure.signals))
    assert name in figures_of(needed) and 'links' not in figures_of(needed)
    svg(name, lambda: figure.draw(needed))
    for gone in figure.signals:
        kept = {topic: s for topic, s in needed.series.items() if topic != gone}
        assert name not in figures_of(replace(needed, series=kept))
        assert figure.missing(replace(needed, series=kept)) == (gone,)


@pytest.mark.parametrize('name', FIGURES)
def test_what_a_figure_names_is_all_that_it_draws(scenario, history, name):
    figure = FIGURES[name]
    batch = in_process.fly(scenario, [7], record=(*figure.signals, *figure.also))
    alone = of_history(scenario, batch)
    assert svg(name, lambda: figure.draw(alone)) == svg(name, lambda: figure.draw(history))


@pytest.mark.parametrize('steps', [1, 2, HOLD + 1, 60])
@pytest.mark.parametrize('name', ALL)
def test_a_recording_that_was_cut_short_is_drawn_as_far_as_it_goes(tmp_path, name, steps):
    cut = read(write_run(tmp_path, small_run.messages(steps), close=False))
    assert name in figures_of(cut)
    svg(name, lambda: ALL[name].draw(cut))


def test_nothing_is_drawn_of_an_empty_bag(tmp_path):
    assert figures_of(read(write_run(tmp_path, []))) == {}


def test_a_picture_is_written(bag, tmp_path):
    png(tmp_path / 'approach.png', lambda: FIGURES['approach'].draw(bag))
    assert (tmp_path / 'approach.png').read_bytes()[1:4] == b'PNG'


# -- what is drawn, of a run of known numbers ------------------------------------------------------

def test_prediction_is_held_against_the_truth_of_the_same_instant(bag):
    t, error, covariance = prediction_error(bag)
    assert_allclose(t, np.arange(2 * HOLD, LAST + 1) * 0.5)
    assert_allclose(error, np.tile(small_run.ERROR, (len(t), 1)), atol=1e-12)
    assert_allclose(covariance, np.tile(np.diag(np.square(small_run.SIGMA)), (len(t), 1, 1)),
                    rtol=1e-12)


def test_a_consistent_prediction_has_the_sum_of_its_squared_ratios(bag):
    expected = np.square(np.divide(small_run.ERROR, small_run.SIGMA)).sum()
    figure = FIGURES['consistency'].draw(bag)
    assert_allclose(line(figure, 'of each prediction')[:, 1], expected, rtol=1e-9)
    assert f'Mean {expected:.1f}' in figure.axes[0].get_title()


def test_the_true_track_is_drawn_where_it_was(bag):
    track = line(FIGURES['approach'].draw(bag), 'true')
    assert_allclose(track, [[-30.0 + 0.25 * k, 0.1] for k in range(LAST + 1)])


def test_a_command_that_the_link_lost_is_marked_when_it_was_sent_and_when_it_should_act(bag):
    assert_allclose(line(LINKS.draw(bag), 'never released'), [[20.0, 5.0]])
    assert_allclose(line(FIGURES['prediction'].draw(bag), 'command lost')[:, 0], 25.0)


def test_pilot_levels_come_from_the_stick(bag):
    pilot = line(FIGURES['levels'].draw(bag), 'pilot')
    assert_allclose(np.rint(pilot[:7, 1]), [-3, -2, -1, 0, 1, 2, 3])


# -- the recording of a history --------------------------------------------------------------------

def test_a_history_is_that_of_one_run_with_its_verdict(scenario, history):
    alone = of_history(scenario, in_process.fly(scenario, [7], record=['/truth/relative_state']))
    truth = '/truth/relative_state'
    assert_array_equal(alone.of(truth).state, history.of(truth).state)
    assert repr(alone.verdict) == repr(history.verdict) and history.verdict.reason == 'timeout'
    assert history.scenario.run.run == 7 and 'run: 7\n' in history.scenario_text
    assert history.judged and history.ended and history.last_step == 80
    assert history.counts[truth] == 81 and not any(history.missing.values())


def test_what_was_not_recorded_is_not_there_and_what_nobody_asked_for_is_unknown(scenario):
    run = of_history(scenario, in_process.fly(scenario, [0], record=[
        '/ground/prediction', '/onboard/thruster_command', '/onboard/command']))
    assert not run.has('/truth/relative_state') and len(run.of('/joy')) == 0
    assert np.isnan(run.of('/ground/prediction').covariance).all()
    thrust = run.of('/onboard/thruster_command')
    assert thrust.reason is None and thrust.levels.shape == (81, 3) and thrust.valid[10:].any()
    assert len(run.of('/onboard/command')) == 0     # nobody can tell which frames were expedited


def test_frames_come_out_of_the_link_of_a_history_as_the_loop_received_them(scenario):
    """Through losses, damage and copies, and with an ABORT, whose frames are expedited."""
    batch = in_process.fly(scenario, range(20), record=everything(scenario),
                           schedule=[Change(30, abort=True)])
    damaged = 0
    for row in range(20):
        run = of_history(scenario, batch, row)
        frames = run.of('/onboard/command')
        received = batch.history['/onboard/command'].received[:len(frames), row]
        assert not (received & frames.empty).any()
        damaged += (~received & ~frames.empty).sum()
        assert (frames.sent[frames.expedited] >= 15.0).all() and frames.expedited.any()
        released = np.cumsum(~frames.empty)
        assert_array_equal(run.links['forward'].history.counts['delivered'], released)
    assert damaged > 20


def test_a_flight_without_a_history_is_refused(scenario):
    with pytest.raises(ValueError, match='a recording needs a history: fly with record=True'):
        of_history(scenario, in_process.fly(scenario, [0]))


def test_the_report_and_the_table_of_figures_are_loaded_without_the_library_that_draws():
    done = subprocess.run(
        [sys.executable, '-c', 'import sys, rvd_campaign.report.run, '
         'rvd_missions.lunar_approach.figures; print("matplotlib" in sys.modules)'],
        capture_output=True, text=True)
    assert done.stdout.strip() == 'False', done.stderr


def test_the_stick_of_a_tape_is_recorded_as_the_tape_has_it(tmp_path):
    """Its axes, not the levels that they stand for; Joy holds 32 bits of them."""
    tape = tmp_path / 'tape.csv'
    tape.write_text('t_s,axis_0,axis_1,axis_2,axis_3,axis_4,button_0,button_1,button_2,button_3,'
                    'button_4\n0.0,0.4,-0.9,0,0,0.2,0,1,0,0,1\n2.0,0,0,0,0,0,0,0,0,0,0\n')
    scenario = parse('/**: {ros__parameters: {operator: replay, timeout_s: 5.0}}\n'
                     f'joystick_replay: {{ros__parameters: {{tape: {tape}}}}}', 'tape')
    run = of_history(scenario, in_process.fly(scenario, [0, 1], record=everything(scenario)), 1)
    sticks = run.of('/joy')
    assert_array_equal(sticks.axes[3], np.float32([0.4, -0.9, 0.0, 0.0, 0.2]))
    assert_array_equal(sticks.buttons[3], [0, 1, 0, 0, 1])
    assert_array_equal(sticks.axes[4], np.zeros(5))


def test_a_report_can_be_made_of_a_history(history):
    html = page(history)
    assert html.count('<svg') == len(ALL) and 'class="warning"' not in html
    assert 'Failed: did not reach the docking plane in time; the run ended after 40.0 s' in html
    assert 'pilot and automatic' in html and 'Steps without a command' not in html


OTHER = Signal('/watch/other', (Part('place', (3,), 'm'), Part('done', (), '', '?'),
                                Part('spread', (2, 2), optional=True),
                                Part('code', (), '', 'u1', optional=True)))


class Other:
    """Looks on, every fourth step, and says so in a signal without a message of its own."""

    def step(self, k, truth):
        return {'other': OTHER(place=truth.state[..., :3], done=truth.final)}


def with_another(scenario):
    """Return the diagram of the approach and a slow watcher."""
    d = lunar_diagram(scenario)
    other = Block('other', f'{__name__}:Other', WATCH, reads={'truth': now(TRUTH)},
                  writes={'other': OTHER}, period=4)
    return Diagram((*d.blocks, other), d.plant, d.guard, d.thrust)


def test_a_slow_signal_without_a_message_of_its_own_is_a_table_of_its_firings(scenario):
    mission = replace(scenario.mission, diagram=f'{__name__}:with_another')
    other = replace(scenario, mission=mission, _settings={}, _parts={})
    run = of_history(other, in_process.fly(other, [0], record=True))
    table = run.of(OTHER)
    assert_array_equal(table.step, range(0, 81, 4))
    assert_array_equal(table['place'], run.of(TRUTH).state[::4, :3])
    assert_array_equal(table['done'], [0.0]*20 + [1.0])
    assert np.isnan(table['spread']).all() and table['spread'].shape == (21, 2, 2)
    assert 'code' not in table.parts                # nobody knows it, and no number says so
