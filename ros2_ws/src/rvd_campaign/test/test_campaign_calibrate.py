"""
Calibration: the root is found, condition 2 is never flown, and blindness is called by its name.
"""

from dataclasses import replace
from math import exp, log

import joblib
import numpy as np
import pytest

from rvd_campaign import catalogue
from rvd_campaign.campaign import calibrate
from rvd_campaign.campaign.calibrate import combinations, numbers, seen, Sensitivity
from rvd_campaign.campaign.fit import Bench, fit_success, Look, MEASURES, root, STATISTICS, TARGET
from rvd_campaign.exits import CannotRun
from rvd_dynamics.diagram.scenario import load, parse, Scenario
from rvd_groundstation.operators.pilot import PERSONS
from rvd_groundstation.operators.pulses import Pulses


class FakeBench:
    """Pilots whose success rate is exp(-gain / 6), in 10,000 runs, and nothing else."""

    runs = 10_000

    def __init__(self):
        self.looks = 0

    def look(self, *pilots):
        self.looks += len(pilots)
        made = []
        for pilot in pilots:
            good = np.arange(self.runs) < self.runs*exp(-pilot.skill_gain/6.0)
            spread = np.linspace(0.5, 1.5, self.runs)
            made.append(Look(good, np.array([0.14*spread, 0.018*spread])))
        return made


@pytest.mark.parametrize('start', [0.6, 1.635, 5.0])
def test_fit_finds_the_gain_that_gives_the_success_rate(start):
    bench = FakeBench()
    pilot, look = fit_success(bench, Pulses(skill_gain=start), 'skill_gain')
    assert pilot.skill_gain == pytest.approx(-6.0*log(0.76), abs=2e-3)
    assert look.success.mean() == pytest.approx(TARGET[0], abs=2e-4)
    assert bench.looks < 20


def test_fit_refuses_what_no_value_reaches():
    with pytest.raises(ValueError, match='no skill_gain between 0.0025 and 0.04 gives'):
        fit_success(FakeBench(), Pulses(skill_gain=0.01), 'skill_gain')


@pytest.mark.parametrize('f, expected', [
    (lambda x: 3.0 - x, 3.0), (lambda x: x**3 - 2.0, 2**(1/3)), (lambda x: 0.0*x, 0.2),
    (lambda x: np.sign(x - 2.5)*0.4, 2.5)])
def test_root(f, expected):
    assert root(f, 0.2, -1.0, 6.0, 1e-4) == pytest.approx(expected, abs=0.05)


def test_root_says_when_there_is_none():
    assert root(lambda x: 1.0 + x*x, 0.2, -1.0, 6.0, 1e-4) is None


def test_numbers_that_do_nothing_or_cannot_move_are_left_out():
    assert 'no_display_trust' not in numbers(PERSONS['A'])
    assert 'display_trust' not in numbers(PERSONS['B'])
    assert 'skill_gain' in numbers(PERSONS['A'])


def test_combinations_count_what_can_be_seen():
    # Ten numbers that all act through one sum move the statistics along one line.
    direction = np.array([5.0, 2.0, 1.0])
    alike = [Sensitivity(f'n{i}', w*direction, np.full(3, 1e-3))
             for i, w in enumerate(np.linspace(0.1, 1.0, 10))]
    values, floor = combinations(alike)
    weight = np.sqrt((np.linspace(0.1, 1.0, 10)**2).sum())
    np.testing.assert_allclose(values, [weight*np.sqrt(30.0), 0.0, 0.0], atol=1e-9)
    np.testing.assert_allclose(floor, 1e-3*np.sqrt(10.0))
    assert seen(values, floor, 10) == 1


def test_noise_alone_is_not_taken_for_something_seen():
    # 200 studies of 30 blind numbers: one combination stands out of its own noise by three
    # deviations in about one of a hundred; the seed is fixed.
    rng, found = np.random.default_rng(3), 0
    for _ in range(200):
        blind = [Sensitivity(f'n{i}', rng.normal(scale=2.0, size=3), np.full(3, 2.0))
                 for i in range(30)]
        values, floor = combinations(blind)
        found += seen(values, floor, 30)
    assert found < 20


def test_only_manual_flights_are_flown():
    parser_args = type('Args', (), {
        'runs': 100, 'workers': 1, 'scenario': 'paper', 'seed': 3, 'pilot': 'A', 'free': None})()
    pilot, free, scenario = calibrate._asked(parser_args)
    assert (pilot, free) == (PERSONS['A'], ['skill_gain'])
    assert scenario.part('operation').mode == 'manual' and scenario.run.seed == 3


def test_pilots_of_another_mission_are_refused(monkeypatch):
    args = type('Args', (), {'runs': 100, 'workers': 1, 'scenario': 'paper'})()
    paper = load(catalogue.find('scenarios', 'paper', ('.yaml',)))
    other = Scenario('x', replace(paper.mission, name='other'), {})
    monkeypatch.setattr(calibrate, 'load', lambda path: other)
    with pytest.raises(CannotRun, match='--scenario paper: only pilots of lunar_approach.*other'):
        calibrate._asked(args)


def test_bench_flies_the_same_runs_for_every_pilot():
    scenario = load(catalogue.find('scenarios', 'paper', ('.yaml',))).with_values(
        '/**', mode='manual', seed=3)
    with joblib.Parallel(n_jobs=1) as pool:
        bench = Bench(scenario, 12, pool)
        a, b, c = bench.look(PERSONS['A'], PERSONS['C'], PERSONS['A'])
    for mine, again in zip(a, c):
        np.testing.assert_array_equal(mine, again)
    assert not np.array_equal(a.values[0], b.values[0])
    assert a.success.shape == (12,) and a.values.shape == (len(MEASURES), 12)


def test_what_is_fitted_is_condition_1_of_the_paper():
    assert dict(zip(STATISTICS, TARGET)) == {
        'success': 0.76, 'offset_m': 0.1444, 'lateral_rate_m_s': 0.0182}


def test_pilot_file_is_a_section_of_a_scenario():
    args = type('Args', (), {'pilot': 'A', 'runs': 100, 'scenario': 'paper', 'seed': 3})()
    pilot = Pulses(skill_gain=1e-05, display=False, skill_spread=0.123456789012345)
    text = calibrate.pilot_file(pilot, args, ['skill_gain'], ['what was found'])
    assert parse(text, 'mine').settings('operator_model').selected == pilot
    assert text.startswith('# Pilot A, skill_gain fitted') and '# what was found' in text
