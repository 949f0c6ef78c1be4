"""The prediction over the loop against plain propagation, truth, chance, and row by row."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
from paper import Paper
import pytest

from rvd_dynamics.motion import cw
from rvd_dynamics.commands.levels import acceleration
from rvd_groundstation.prediction.predictor import Predictor, PredictorParams

PARAMS = PredictorParams(in_flight='as_sent', filter='scheduled', prior='kalman')
ADAPTIVE, LEARNED = replace(PARAMS, filter='adaptive'), PredictorParams()
KINDS = {'scheduled': PARAMS, 'adaptive': ADAPTIVE, 'learned': LEARNED}
NOMINAL = np.array([-30.0, 0.0, 0.0, 0.25, 0.0, 0.0])
GRIDS = [(0.5, 5.0, 5.0), (0.5, 0.0, 0.0), (0.5, 0.0, 5.0), (0.5, 3.0, 0.0), (0.05, 0.5, 1.0),
         (0.1, 5.0, 5.0), (1.0, 20.0, 20.0)]


def paper_of(grid):
    step_s, forward_s, back_s = grid
    return Paper(step_s=step_s, forward_delay_s=forward_s, back_delay_s=back_s)


def propagate(paper, state, levels):
    """Carry `state` over commands one by one by eq. 4."""
    n, dt = paper.orbit.mean_motion, paper.step_s
    for level in levels:
        accel = acceleration(level, paper.thrust)
        state = cw.transition(n, dt) @ state + cw.input_matrix(n, dt) @ accel
    return state


class Flight:
    """Truth by eq. 4, commands at random, and what the ground receives of it."""

    def __init__(self, paper, steps, seed=0, start=NOMINAL, noise=0.0, lost=0.0):
        self.paper, self.steps = paper, steps
        rng = np.random.default_rng(seed)
        self.commands = rng.integers(-3, 4, (steps, 3), dtype=np.int8)
        executed = np.zeros((steps, 3), dtype=np.int8)
        executed[paper.legs.forward:] = self.commands[:steps - paper.legs.forward]
        self.executed = executed
        self.truth = [np.asarray(start)]
        for level in executed[:-1]:
            self.truth.append(propagate(paper, self.truth[-1], [level]))
        self.measured = np.array(self.truth) * (1 + noise * rng.normal(size=(steps, 6)))
        self.received = rng.random(steps) >= lost

    def fly(self, predictor):
        """Yield (step, prediction) with the telemetry of each step."""
        for k in range(self.steps):
            m = k - self.paper.legs.back
            sample = (self.measured[m], self.received[m]) if m >= 0 else (None, False)
            yield k, predictor.advance(k, *sample, self.commands[k - 1] if k else None)

    def in_flight(self, k):
        """Return the commands that act between the telemetry of step k and its prediction."""
        m, end = k - self.paper.legs.back, k + self.paper.legs.forward
        first = m - self.paper.legs.forward
        sent = [self.commands[i] if i >= 0 else np.zeros(3, int) for i in range(first, k)]
        return sent[:end - m]


@pytest.mark.parametrize('grid', GRIDS, ids=str)
@pytest.mark.parametrize('params', KINDS.values(), ids=KINDS.keys())
def test_equals_the_estimate_carried_over_the_commands_in_flight(grid, params):
    paper = paper_of(grid)
    flight = Flight(paper, 60, noise=0.01, lost=0.1, start=NOMINAL + 0.3)
    compared = 0
    for k, got in flight.fly(paper.predictor(params)):
        if got.valid:
            direct = propagate(paper, got.estimate, flight.in_flight(k))
            assert_allclose(got.predicted, direct, rtol=0, atol=2e-13)  # 40 steps of 30 m, 5e-15
            compared += 1
    assert compared >= 60 - paper.legs.back - 5


@pytest.mark.parametrize('grid', GRIDS, ids=str)
def test_exact_model_without_noise_reproduces_the_truth(grid):              # P18
    paper = paper_of(grid)
    flight = Flight(paper, 80, seed=1)
    for k, got in flight.fly(paper.predictor(PARAMS)):
        ahead = k + paper.legs.forward
        if got.valid and ahead < flight.steps:
            assert_allclose(got.predicted, flight.truth[ahead], rtol=0, atol=1e-12)


def worst_error_once_settled(predictor, flight):
    error = 0.0
    for k, got in flight.fly(predictor):
        ahead = k + flight.paper.legs.forward
        if 40 <= k and ahead < flight.steps:
            error = max(error, np.abs(got.predicted - flight.truth[ahead]).max())
    return error


class FedBack(Predictor):
    """The mistake: the corrected prediction written over the open-loop history."""

    def _predict(self):
        got = super()._predict()
        if got.valid:
            self._model[-1] = got.predicted
        return got


def test_feeding_the_correction_back_would_be_seen():
    paper = Paper()
    flight = Flight(paper, 150, start=NOMINAL + np.array([0, 0.5, 0, 0, 0.01, 0]))
    right = worst_error_once_settled(paper.predictor(PARAMS), flight)
    wrong = worst_error_once_settled(paper.predictor(PARAMS, kind=FedBack), flight)
    assert right < 1e-3 and wrong > 100 * right


def test_a_correction_counts_once_however_long_it_stands():
    """An offset of the whole start is corrected by itself, not by its multiples."""
    paper = Paper()
    offset = np.array([0.0, 0.4, -0.3, 0.0, 0.0, 0.0])
    flight = Flight(paper, 100, start=NOMINAL + offset)
    flight.commands[:] = 0
    flight.truth = [propagate(paper, flight.truth[0], np.zeros((k, 3), int))
                    for k in range(100)]
    flight.measured = np.array(flight.truth)
    plain = NOMINAL + offset
    for k, got in flight.fly(paper.predictor(PARAMS)):
        if k > 60:
            plain_k = cw.propagate(plain, paper.orbit.mean_motion, (k + 10) * 0.5)
            assert_allclose(got.predicted, plain_k, atol=1e-3)


def test_lost_command_shows_a_loop_later_and_then_no_more():
    paper = Paper()
    flight = Flight(paper, 140, seed=2)
    lost_at = 40
    flight.executed[lost_at + paper.legs.forward] = 0             # the ground is not told
    flight.commands[lost_at] = [0, 3, 0]
    flight.truth = [NOMINAL]
    for level in flight.executed[:-1]:
        flight.truth.append(propagate(paper, flight.truth[-1], [level]))
    flight.measured = np.array(flight.truth)
    errors = {k: np.abs(got.predicted - flight.truth[k + 10]).max()
              for k, got in flight.fly(paper.predictor(PARAMS)) if k >= 30 and k + 10 < 140}
    assert max(errors[k] for k in range(30, 41)) < 1e-9
    assert errors[55] > 0.03                            # 0.02 m/s^2 for 0.5 s: 5 s later
    assert errors[129] < errors[55] / 10


def test_nothing_is_known_before_the_first_telemetry():
    paper = Paper()
    flight = Flight(paper, 30)
    flight.received[:3] = False
    for k, got in flight.fly(paper.predictor(PARAMS)):
        assert bool(got.valid) == (k >= paper.legs.back + 3)
        for field in got[:-1]:
            assert np.isfinite(field).all() == bool(got.valid)


def test_sample_that_is_not_finite_counts_as_lost():
    paper = Paper(back_delay_s=0.0)
    for component in range(6):
        spoiled = NOMINAL.copy()
        spoiled[component] = np.nan
        one, other = paper.predictor(PARAMS), paper.predictor(PARAMS)
        for predictor in (one, other):
            predictor.advance(0, NOMINAL + 0.1, True, None)
        got = one.advance(1, spoiled, True, [0, 0, 0])
        assert_array_equal(got.predicted, other.advance(1, None, False, [0, 0, 0]).predicted)
        assert np.isfinite(got.predicted).all()


def test_step_left_out_is_refused():
    predictor = Paper().predictor(PARAMS)
    predictor.advance(0, None, False, None)
    with pytest.raises(ValueError, match='step must be 1, got 2'):
        predictor.advance(2, None, False, None)


def test_unknown_filter_is_refused_by_name():
    with pytest.raises(ValueError, match='filter must be one of learned, .*, got best'):
        PredictorParams(filter='best')


def test_covariance_of_the_prediction_is_that_of_its_error():
    rows, paper = 4000, Paper()
    rng = np.random.default_rng(8)
    loop, n, dt = 20, paper.orbit.mean_motion, paper.step_s
    phi, gamma = cw.transition(n, dt), cw.input_matrix(n, dt)
    kalman = PARAMS.kalman
    q = np.linalg.cholesky(kalman.process_covariance(gamma, dt))
    truth = [NOMINAL + rng.normal(size=(rows, 6)) @ np.sqrt(kalman.start_covariance())]
    for _ in range(60):
        truth.append(truth[-1] @ phi.T + rng.normal(size=(rows, 6)) @ q.T)
    predictor = paper.predictor(PARAMS, (rows,))
    for k in range(50):
        m = k - paper.legs.back
        measured, received = None, False
        if m >= 0:
            nominal = NOMINAL + [0.25 * m * dt, 0, 0, 0, 0, 0]
            sigma = np.sqrt(kalman.measurement_variance(nominal))
            measured = truth[m] + sigma * rng.normal(size=(rows, 6))
            received = rng.random(rows) < 0.9
        got = predictor.advance(k, measured, received, None)
    error = got.predicted - truth[49 + paper.legs.forward]
    nees = np.einsum('ni,nij,nj->n', error, np.linalg.inv(got.covariance), error)
    assert loop == paper.legs.forward + paper.legs.back
    assert abs(nees.mean() - 6.0) < 5 * np.sqrt(12.0 / rows)


@pytest.mark.parametrize('rows', [1, 7, 300, 1000])
def test_rows_are_equal_to_single_runs_bit_for_bit(rows):
    paper = Paper()
    rng = np.random.default_rng(rows)
    measured = NOMINAL + rng.normal(scale=0.1, size=(40, rows, 6))
    received = rng.random((40, rows)) < 0.9
    sent = rng.integers(-3, 4, (40, rows, 3), dtype=np.int8)
    batch = paper.predictor(PARAMS, (rows,), track=False)
    chosen = range(0, rows, max(1, rows // 10))
    single = {row: paper.predictor(PARAMS, track=row % 2 == 0) for row in chosen}
    for k in range(40):
        whole = batch.advance(k, measured[k], received[k], sent[k])
        for row, predictor in single.items():
            got = predictor.advance(k, measured[k, row], received[k, row], sent[k, row])
            assert_array_equal(got.estimate, whole.estimate[row])
            assert_array_equal(got.predicted, whole.predicted[row])
            assert got.valid == whole.valid[row]


# Score

def test_perfect_predictions_score_zero_and_are_all_counted():
    paper = Paper()
    flight = Flight(paper, 100, seed=3)
    score = paper.score()
    for k, got in flight.fly(paper.predictor(PARAMS)):
        m = k - paper.legs.back
        sample = (flight.measured[m], flight.received[m]) if m >= 0 else (None, False)
        scored = score.advance(got, *sample)
        assert bool(scored.valid) == (k >= 30)              # first prediction at 10, loop of 20
    assert scored.scored == 70
    assert_allclose(scored.rms, 0.0, atol=1e-12)
    assert (scored.sigma > 0).all()


def test_score_is_the_root_mean_square_of_what_was_off():
    paper = Paper(forward_delay_s=0.5, back_delay_s=0.0)
    flight = Flight(paper, 40, seed=4, noise=0.01, lost=0.2)
    score, kept, errors = paper.score(), [], []
    for k, got in flight.fly(paper.predictor(PARAMS)):
        kept.append(got.predicted)
        scored = score.advance(got, flight.measured[k], flight.received[k])
        if k >= 1 and flight.received[k] and np.isfinite(kept[k - 1]).all():
            errors.append(kept[k - 1] - flight.measured[k])
            assert_array_equal(scored.error, errors[-1])
        else:
            assert not scored.valid and np.isnan(scored.error).all()
    assert scored.scored == len(errors) > 20
    assert_allclose(scored.rms, np.sqrt(np.mean(np.square(errors), axis=0)), rtol=1e-12)


def test_nothing_scored_is_not_zero():
    scored = Paper().score().advance(
        Paper().predictor(PARAMS).advance(0, None, False, None), None, False)
    assert scored.scored == 0 and np.isnan(scored.rms).all()


def test_settings_reach_the_filter():
    wide = replace(PARAMS, kalman=replace(PARAMS.kalman, measurement_fraction=0.1))
    first = Paper(back_delay_s=0.0).predictor(wide).advance(0, NOMINAL + 1.0, True, None)
    usual = Paper(back_delay_s=0.0).predictor(PARAMS).advance(0, NOMINAL + 1.0, True, None)
    assert abs(first.estimate[0] - NOMINAL[0]) < abs(usual.estimate[0] - NOMINAL[0])


# -- commands that come late -------------------------------------------------------------------

@pytest.mark.parametrize('grid', GRIDS, ids=str)
@pytest.mark.parametrize('params', KINDS.values(), ids=KINDS.keys())
@pytest.mark.parametrize('by', [1, 7, 45])
def test_a_command_that_came_late_counts_as_if_it_had_been_there(by, params, grid):
    """Every third is late: in flight, or `by` steps, beyond the loop, within the filter."""
    paper = paper_of(grid)
    flight, on_time, late = Flight(paper, 120, noise=0.01, lost=0.1), [], []
    for _, got in flight.fly(paper.predictor(params)):
        on_time.append(got.predicted)
    predictor, noticed = paper.predictor(params), 0.0
    for k in range(flight.steps):
        m = k - paper.legs.back
        sample = (flight.measured[m], flight.received[m]) if m >= 0 else (None, False)
        missing = k and k % 3 == 0 and k < 60
        came = k - by
        made_up = {came - 1: (flight.commands[came - 1], False)} \
            if came > 0 and came % 3 == 0 and came < 60 else {}
        late.append(predictor.advance(k, *sample, None if missing or not k else
                                      flight.commands[k - 1], late=made_up).predicted)
        noticed = max(noticed, np.nan_to_num(np.abs(late[-1] - on_time[k])).max())
    assert noticed > 1e-3                       # while they are missing it matters
    assert_allclose(late[60 + by:], on_time[60 + by:], rtol=0, atol=1e-12)


@pytest.mark.parametrize('by', [3, 30])         # in flight, and within the filter
def test_a_command_that_came_late_counts_by_what_was_known_of_losses_when_it_was_due(
        by, monkeypatch):
    monkeypatch.setattr(PredictorParams, 'loss', lambda self, link: 0.3)    # of the link, as set
    paper, params = paper_of((0.5, 5.0, 5.0)), LEARNED
    flight, made = Flight(paper, 100, noise=0.01, lost=0.3), [paper.predictor(params)
                                                              for _ in range(2)]
    off = []
    for k in range(flight.steps):
        m, came = k - paper.legs.back, k - by
        sample = (flight.measured[m], flight.received[m]) if m >= 0 else (None, False)
        late = {came - 1: (flight.commands[came - 1], False)} if came in (21, 41) else None
        sent = flight.commands[k - 1] if k else None
        on_time = made[0].advance(k, *sample, sent, acted=np.True_)     # none gets lost
        told = made[1].advance(k, *sample, None if k in (21, 41) else sent, late=late,
                               acted=np.True_)
        off.append(np.abs(told.predicted - on_time.predicted).max())
    assert made[0].loss.probability < 0.2               # what is known of losses changes
    assert min(off[21], off[41]) > 1e-4
    assert_allclose(off[41 + by:], 0.0, atol=1e-12)


@pytest.mark.parametrize('given', [0.0, 0.3])
def test_a_probability_of_loss_that_is_given_stays_whatever_telemetry_tells(given):
    paper = paper_of((0.5, 5.0, 5.0))
    flight = Flight(paper, 100, noise=0.01)
    predictor = paper.predictor(replace(LEARNED, loss_probability=given))
    for k in range(flight.steps):
        m = k - paper.legs.back
        sample = (flight.measured[m], flight.received[m]) if m >= 0 else (None, False)
        predictor.advance(k, *sample, flight.commands[k - 1] if k else None,
                          acted=np.bool_(k % 2))
    assert predictor.loss.probability == given
