"""
Random streams: what they may depend on, and that they are streams apart.

Seeds are fixed, so a pass or a failure repeats. The thresholds of the statistical tests
would raise a false alarm for about one choice of seeds in 10,000 each.
"""

from itertools import combinations
from statistics import NormalDist

import numpy as np
import pytest

from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.run import LegParams, Run
from rvd_dynamics.diagram.streams import PURPOSES

STEPS = 401


def beginning(seed, run, purpose):
    return streams.generator(seed, run, purpose).integers(2**63, size=4).tobytes()


def test_purposes_keep_their_numbers():
    # part of the key of every recorded result
    assert PURPOSES == {'start': 0, 'measurement': 1, 'execution': 2, 'link_forward': 3,
                        'link_back': 4, 'pilot': 5, 'pilot_skill': 6}


def test_recorded_draws_come_again():
    # numpy keeps PCG64 and SeedSequence for ever, but not what Generator makes of their bits:
    # a failure here with a new numpy means that recorded seeds no longer give recorded runs
    assert streams.start_normals(0, 0)[:3].tolist() == [
        0.7859067677198036, -0.9199529560235964, 1.4715789384981375]
    assert streams.pilot_draws(0, 0, 5).uniforms[4, :3].tolist() == [
        0.11585170253840482, 0.4217756970189931, 0.8789194389730545]


def test_the_key_holds_seed_run_and_purpose_and_nothing_of_the_condition():
    blocks = []
    for mode in ('manual', 'shared', 'auto'):
        run, _ = Run(seed=5, run=3), (mode, LegParams(forward_delay_s=2.5))
        blocks.append(streams.measurement_normals(run.seed, run.run, run.last_step + 1))
    assert np.array_equal(blocks[0], blocks[1]) and np.array_equal(blocks[0], blocks[2])


def test_drawing_one_purpose_does_not_move_another():
    before = streams.execution_normals(1, 2, STEPS)
    streams.measurement_normals(1, 2, STEPS)
    streams.pilot_draws(1, 2, STEPS)
    assert np.array_equal(streams.execution_normals(1, 2, STEPS), before)


def test_no_two_streams_are_the_same():
    seen = {beginning(seed, run, purpose) for seed in range(20) for run in range(20)
            for purpose in PURPOSES}
    assert len(seen) == 20 * 20 * len(PURPOSES)


def test_large_seeds_and_runs_are_streams_of_their_own():
    keys = [(0, 0), (2**32, 0), (1, 0), (0, 1), (0, 2**32 - 1), (2**32 - 1, 0), (2**63, 0),
            (2**64 - 1, 2**32 - 1)]
    assert len({beginning(*key, 'start') for key in keys}) == len(keys)


@pytest.mark.parametrize('draw', [
    lambda steps: streams.measurement_normals(7, 1, steps),
    lambda steps: streams.execution_normals(7, 1, steps),
    lambda steps: streams.pilot_draws(7, 1, steps).normals,
    lambda steps: streams.pilot_draws(7, 1, steps).uniforms,
], ids=['measurement', 'execution', 'pilot normals', 'pilot uniforms'])
def test_a_longer_run_begins_like_a_shorter_one(draw):
    assert np.array_equal(draw(400)[:100], draw(100))


def test_shapes_of_a_run():
    assert streams.start_normals(0, 0).shape == (6,)
    assert streams.measurement_normals(0, 0, STEPS).shape == (STEPS, 6)
    assert streams.execution_normals(0, 0, STEPS).shape == (STEPS, 3)
    draws = streams.pilot_draws(0, 0, STEPS)
    assert [part.shape for part in draws] == [(6,), (3,), (STEPS, 10), (STEPS, 6)]


@pytest.mark.parametrize('seed', [0, 1, 2**32 - 1, 2**32, 2**64 - 1])
def test_draws_of_many_runs_are_those_of_each_run(seed):
    # single runs are seeded by NumPy itself, many runs by our copy of its arithmetic
    runs = [5, 0, 2**31, 2**32 - 1, 6]
    many = streams.pilot_draws_of_runs(seed, runs, 7)
    for i, run in enumerate(runs):
        for ours, one in zip(many, streams.pilot_draws(seed, run, 7)):
            assert np.array_equal(ours[i], one)
    for ours, one in (
            (streams.start_normals_of_runs(seed, runs),
             [streams.start_normals(seed, run) for run in runs]),
            (streams.normals_of_runs(seed, runs, 'measurement', 9, 6),
             [streams.measurement_normals(seed, run, 9) for run in runs]),
            (streams.normals_of_runs(seed, runs, 'execution', 9, 3),
             [streams.execution_normals(seed, run, 9) for run in runs]),
            (streams.skill_normals(seed, runs),
             [streams.skill_normal(seed, run) for run in runs])):
        assert np.array_equal(ours, one)


@pytest.mark.parametrize('seed, runs', [(-1, [0]), (2**64, [0]), (0, [2**32])])
def test_keys_out_of_range_are_refused_for_many_runs_too(seed, runs):
    with pytest.raises(ValueError, match='must be between'):
        streams.start_normals_of_runs(seed, runs)


def test_skill_belongs_to_the_operator():
    assert streams.skill_normal(3, 5) == streams.skill_normal(3, 5)
    assert len({streams.skill_normal(3, operator) for operator in range(50)}) == 50
    assert isinstance(streams.skill_normal(0, 0), float)


# -- statistics -------------------------------------------------------------------------------

ALARM = NormalDist().inv_cdf(1 - 0.5e-4)            # two-sided, one false alarm in 10,000


def of_every_purpose(seed, run, count):
    return {purpose: streams.generator(seed, run, purpose).standard_normal(count)
            for purpose in PURPOSES}


def test_purposes_runs_and_seeds_are_uncorrelated():
    count = 20_000
    rows = [row for seed, run in ((0, 0), (0, 1), (1, 0), (2**40, 7))
            for row in of_every_purpose(seed, run, count).values()]
    pairs = list(combinations(range(len(rows)), 2))
    scores = np.array([rows[i] @ rows[j] / np.sqrt(count) for i, j in pairs])
    # the largest of many normal scores, still one false alarm in 10,000
    assert np.abs(scores).max() < NormalDist().inv_cdf(1 - 0.5e-4/len(pairs))
    assert abs(scores.std() - 1.0) < ALARM / np.sqrt(2*len(pairs))


def test_neighbouring_runs_give_independent_first_draws():
    # what a campaign uses: one number of each of many runs
    first = np.array([streams.start_normals(0, run)[1:3] for run in range(4000)])
    lagged = first[:-1, 0] @ first[1:, 0] / np.sqrt(3999)
    across = first[:, 0] @ first[:, 1] / np.sqrt(4000)
    assert abs(lagged) < ALARM and abs(across) < ALARM


def test_normals_are_normal_and_uniforms_uniform():
    from scipy.stats import kstest
    normals = streams.normals_of_runs(9, range(20), 'measurement', STEPS, 6)
    pilots = streams.pilot_draws_of_runs(9, range(20), STEPS)
    assert kstest(normals.ravel(), 'norm').pvalue > 1e-4
    assert kstest(pilots.normals.ravel(), 'norm').pvalue > 1e-4
    assert kstest(pilots.uniforms.ravel(), 'uniform').pvalue > 1e-4
    assert pilots.uniforms.min() >= 0.0 and pilots.uniforms.max() < 1.0


def test_normals_and_uniforms_of_a_pilot_are_independent():
    draws = streams.pilot_draws_of_runs(4, range(50), STEPS)
    count = draws.uniforms[..., 0].size
    score = np.sum(draws.normals[..., 0] * (draws.uniforms[..., 0] - 0.5)) * np.sqrt(12/count)
    assert abs(score) < ALARM


# -- bad input --------------------------------------------------------------------------------

@pytest.mark.parametrize('seed, run, purpose, text', [
    (-1, 0, 'start', 'seed must be .*, got -1'),
    (2**64, 0, 'start', 'seed must be .*, got 18446744073709551616'),
    (0, -1, 'start', 'run must be .*, got -1'),
    (0, 2**32, 'start', 'run must be .*, got 4294967296'),
    (0, 0, 'shared', "purpose must be one of start, .*, got 'shared'"),
])
def test_an_impossible_key_is_refused_with_its_value(seed, run, purpose, text):
    with pytest.raises(ValueError, match=text):
        streams.generator(seed, run, purpose)
