"""The physical ceiling: closed forms, brute force over histories, and no law above it."""

from itertools import product
from math import exp, inf, sqrt

import numpy as np
import pytest

from rvd_dynamics.diagram.in_process import fly, judge_of
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.world.plants.relative import Cw
from rvd_missions.lunar_approach.ceiling import (
    _draw, _of, _thrust_limits, _towards_axis, _World, best_margin, ceiling, first_steps, main,
    WAYS_HOME)
from rvd_missions.lunar_approach.signals import ARRIVAL, TRUTH

PAPER = parse('auto_controller: {ros__parameters: {law: barrier}}', 'paper')
QUIET = PAPER.with_values('spacecraft_dynamics', execution_noise_fraction=0.0)
CONE = PAPER.part('cone')


def scattered(position_m, velocity_m_s=(0.0, 0.01, 0.01)):
    return PAPER.with_values('spacecraft_dynamics', scatter__sigma_position_m=position_m,
                             scatter__sigma_velocity_m_s=velocity_m_s)


def world(state, steps=401):
    return _World(np.array([state]), np.zeros((1, steps, 3)), np.ones((1, steps), dtype=bool))


def test_each_run_is_in_exactly_one_place():
    found = ceiling(PAPER, range(400))
    assert np.array_equal(np.sum(found, axis=0), np.ones(400))


def test_share_that_starts_outside_is_the_tail_of_the_scatter():
    """rho is Rayleigh of 0.6 m, R(-30) = 1.872 m: P(outside) = exp(-R^2 / 2 sigma^2)."""
    wide = scattered((0.0, 1.0, 1.0), (0.0,)*3)
    expected, runs = exp(-1.8722**2/2.0), 2000
    got = ceiling(wide, range(runs), first_step=0).outside.mean()
    assert abs(got - expected) < 4.0*sqrt(expected*(1.0 - expected)/runs)   # 1 in 16,000


def test_a_later_command_never_saves_more():
    wide = scattered((0.0, 0.8, 0.8))
    saved = [ceiling(wide, range(150), first_step=k).docked for k in (0, 10, 30)]
    assert np.all(saved[0] >= saved[1]) and np.all(saved[1] >= saved[2])
    assert saved[0].sum() > saved[2].sum()


@pytest.mark.parametrize('given', [1.0, 0.7])
def test_upper_bound_agrees_with_a_ballistic_stop(given):
    """Lateral motion alone, orbit too slow to matter: outwards at v, the best stop needs
    v^2 / 2a, while the wall comes in by x' tan(alpha) per second. In the plane of y the
    least margin is where both move alike, at t = (v + x' tan(alpha)) / a."""
    slow = QUIET.with_values('/**', orbit__radius_m=1e9, thrust__x_m_s2=(1e-9, 2e-9, 3e-9))
    slow = slow.with_values('spacecraft_dynamics', thrust_fraction=given)
    y, v, a, narrowing = 1.2, 0.15, 0.02*given, 0.25*CONE.tan_alpha
    t = (v + narrowing)/a
    room = 0.3 + 28.0*CONE.tan_alpha
    expected = room - narrowing*t - (y + v*t - a*t*t/2.0)
    got = best_margin(slow, world([-28.0, y, 0.0, 0.25, v, 0.0]), 0)
    assert abs(got - expected) < 1e-3       # instants are sampled at 0.25 s


@pytest.mark.slow
@pytest.mark.patient
def test_upper_bound_is_above_every_history_of_levels():
    """All lateral histories of three phases of 1.5 s, held against the judge's margin."""
    state = np.array([-28.0, 1.35, 0.5, 0.25, 0.04, 0.05])
    bound = best_margin(QUIET, world(state), 0)
    pairs = list(product((-3, 0, 3), repeat=2))
    plans = np.array(list(product(pairs, repeat=3)))                # (729, 3, 2)
    truth = Cw(PAPER.part('orbit'), PAPER.run.step_s)
    judge = judge_of(PAPER, (len(plans),))
    flying = np.tile(state, (len(plans), 1))
    judge.start(flying)
    for step in range(9):
        levels = np.zeros((len(plans), 3), dtype=np.int8)
        levels[:, 1:] = plans[:, step//3]
        accel = PAPER.part('form').effect(levels)
        flying = truth.advance(flying, accel)
        judge.advance(step + 1, flying, accel)
    best = judge.verdict().values['min_corridor_margin_m'].max()
    assert best <= bound + 1e-3 and best > bound - 0.1


def test_hopeless_and_easy_runs_are_told_apart():
    hopeless = best_margin(QUIET, world([-20.0, 1.3, 0.0, 0.25, 0.4, 0.0]), 0)
    easy = best_margin(QUIET, world([-20.0, 0.3, 0.0, 0.25, 0.0, 0.0]), 0)
    assert hopeless < -0.5 and easy > 0.3


def test_thrust_that_does_not_arrive_cannot_save():
    state = [-28.0, 1.4, 0.0, 0.25, 0.08, 0.0]
    cut_off = world(state)._replace(gets_up=np.zeros((1, 401), dtype=bool))
    assert best_margin(QUIET, world(state), 0) > 0.0 > best_margin(QUIET, cut_off, 0)


def test_at_the_docking_plane_nothing_is_left_to_ask():
    assert best_margin(QUIET, world([-0.01, 0.1, 0.0, 0.25, 0.0, 0.0]), 0) == inf


def test_link_that_is_down_leaves_what_drifts_in():
    """Without any thrust the Coriolis push alone takes nearly every run out."""
    dead = PAPER.with_values('link_forward', loss_fraction=1.0)
    assert not ceiling(dead, range(8)).docked.any()


def test_a_command_before_telemetry_saves_runs_that_a_silent_ground_loses():
    """
    Found by looking for one: level -3 on x while nothing is known, then by feedback of the truth.

    It is a history of commands, so nobody may say that none could have docked these runs.
    """
    wide = scattered((0.0, 0.8, 0.8)).with_values('spacecraft_dynamics',
                                                  execution_noise_fraction=0.0)
    runs, steps = range(600), first_steps(wide)
    silent, whatever = (ceiling(wide, runs, steps[name]) for name in ('silent', 'any'))
    assert np.all(whatever.docked >= silent.docked)
    drawn, form = _draw(wide, runs), wide.part('form')
    lost = np.flatnonzero(silent.left | silent.refuted)
    world, judge = _of(drawn, lost), judge_of(wide, (len(lost),))
    state, truth = world.start, Cw(wide.part('orbit'), wide.run.step_s)
    judge.start(state)
    for step in range(wide.run.last_step):
        levels = form.quantise(_towards_axis(state, wide.part('orbit').mean_motion, WAYS_HOME[0]))
        if step < steps['silent']:
            levels[:] = (-3, 0, 0) if step >= steps['any'] else 0
        levels[~world.gets_up[:, step]] = 0
        accel = form.effect(levels)
        state = truth.advance(state, accel)
        judge.advance(step + 1, state, accel)
        if judge.ended.all():
            break
    saved = judge.verdict().success
    assert saved.sum() >= 2 and not silent.docked[lost].any()
    assert not (whatever.left | whatever.refuted | whatever.outside)[lost[saved]].any()


@pytest.mark.slow
@pytest.mark.patient
def test_no_law_docks_a_run_that_is_refuted_and_the_barrier_nearly_all_others():
    """More than twice the scatter in rate makes a hundred hopeless runs."""
    wide = scattered((0.0, 0.7, 0.7), (0.0, 0.025, 0.025)).with_values(
        'command_blender', sharing='filter')
    runs = range(1500)
    found, flown = ceiling(wide, runs), fly(wide, runs).verdict.success
    lost = found.outside | found.left | found.refuted
    assert found.refuted.sum() > 3 and lost.sum() > 50
    assert not flown[lost].any()
    assert flown[found.docked].mean() > 0.98


def test_rows_do_not_depend_on_the_batch():
    whole = ceiling(PAPER, range(60))
    for part, alone in zip(whole, ceiling(PAPER, [41])):
        assert part[41] == alone[0]
    assert _of(world([0.0]*6), [0]).start.shape == (1, 6)


def test_impossible_questions_are_refused():
    with pytest.raises(ValueError, match='first_step must not be negative, got -1'):
        ceiling(PAPER, range(3), first_step=-1)
    with pytest.raises(ValueError, match='runs must be one or more, got none'):
        ceiling(PAPER, [])


def test_shown_beside_what_a_law_reached(tmp_path, capsys):
    (tmp_path / 'own.yaml').write_text('auto_controller: {ros__parameters: {law: none}}')
    main([str(tmp_path / 'own.yaml'), '--runs', '50'])
    lines = dict(line.split(None, 1) for line in capsys.readouterr().out.splitlines())
    counts = [lines[name].split()[::2] for name in ('outside', 'left', 'refuted', 'docked',
                                                    'open')]
    assert [sum(map(int, column)) for column in zip(*counts)] == [50, 50]
    silent, whatever = (float(text.split('..')[1]) for text in lines['ceiling'].split())
    assert 0.5 < float(lines['flown']) < silent <= whatever
    with pytest.raises(SystemExit):
        main([str(tmp_path / 'absent.yaml')])
    assert 'cannot read scenario' in capsys.readouterr().err


@pytest.mark.parametrize('changes', [
    {'link_forward': {'loss_fraction': 0.1}}, {'link_forward': {'burst_fraction': 0.3}},
    {'spacecraft_dynamics': {'thrust_fraction': 0.8}}])
def test_links_and_craft_are_those_that_fly(changes):
    """The commands that the ceiling lets through, and their thrust, are those of a flight."""
    scenario = PAPER
    for section, values in changes.items():
        scenario = scenario.with_values(section, **values)
    runs, up = range(5), scenario.part('legs').forward
    drawn = _draw(scenario, runs)
    flown = fly(scenario, list(runs), record=[TRUTH.name, ARRIVAL.name]).history
    came = flown[ARRIVAL.name].received.T
    steps = min(came.shape[1], 150)             # no run has ended
    assert np.array_equal(came[:, up:steps], drawn.gets_up[:, up:steps])
    accel = np.abs(flown[TRUTH.name].acceleration[1:steps + 1])
    limit = [_thrust_limits(scenario, _of(drawn, [run]), 0, steps) for run in runs]
    assert np.all(accel.transpose(1, 0, 2).reshape(len(runs), -1) <= np.array(limit) + 1e-15)


def test_errors_that_last_for_a_burn_are_refused_in_a_line():
    with pytest.raises(ValueError, match='execution_noise_per must be step .* got burn') as refused:
        ceiling(PAPER.with_values('spacecraft_dynamics', execution_noise_per='burn'), range(2))
    assert '\n' not in str(refused.value)
