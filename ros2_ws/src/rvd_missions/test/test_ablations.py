"""What is left out or made worse on purpose in the lunar approach, and what that does."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from approaches import approach

from rvd_dynamics.commands.levels import LevelForm
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.world.spacecraft.thrusters import execute, OfBurns
from rvd_campaign.campaign import stats

TRUTH, PREDICTION, ESTIMATE = '/truth/relative_state', '/ground/prediction', '/ground/estimate'
MEASURED, THRUST = '/onboard/measurement', '/onboard/thruster_command'
AS_SENT = {'in_flight': 'as_sent', 'filter': 'scheduled', 'prior': 'kalman'}    # the paper's
SURE = {                                        # nothing is lost, nothing is noisy
    'link_forward': {'model': 'constant'}, 'link_back': {'model': 'constant'},
    'relative_sensor': {'multiplicative__noise_fraction': 0.0}}


def paper_with(state_predictor=None, **sections):
    return approach({'state_predictor': {**AS_SENT, **(state_predictor or {})}, **sections})


def flown(record, runs=(0, 1, 2), **changes):
    return fly(paper_with(**changes), list(runs), record=record).history


def plant(**changes):
    return {'execution_noise_fraction': 0.0, **changes}


# -- thrust, and what the predictor takes it for -----------------------------------------------

@pytest.mark.parametrize('fraction', [0.7, 0.9, 1.0, 1.3])
def test_told_of_the_thrust_the_prediction_is_the_truth(fraction):
    """By the motion itself: no noise, no loss, so that only a wrong thrust can make errors."""
    def error(bias):
        history = flown([TRUTH, PREDICTION, THRUST], **SURE,
                        spacecraft_dynamics=plant(thrust_fraction=fraction),
                        state_predictor={'predictor_bias': bias})
        steps = slice(80, 160)
        ahead = history[TRUTH].state[90:170]            # a command acts ten steps later
        assert np.any(history[THRUST].command[steps])
        return np.nanmax(np.abs(history[PREDICTION].state[steps] - ahead)[..., 1:3])
    assert error(fraction) < 1e-3                       # [m] what is left of the start's error
    assert error(fraction) < 0.1*error(1.3 if fraction < 1.0 else 0.7)


def test_the_thrust_is_the_fraction_of_that_of_the_levels():
    history = flown([TRUTH, THRUST], spacecraft_dynamics=plant(thrust_fraction=0.9))
    levels = history[THRUST].command[:200]              # no run ends before
    assert_array_equal(history[TRUTH].acceleration[1:201], 0.9*LevelForm().effect(levels))
    assert np.any(levels)


@pytest.mark.parametrize('bias', [0.69, 1.31, float('nan')])
def test_a_bias_beyond_reason_is_refused_in_a_line(bias):
    with pytest.raises(ValueError, match='predictor_bias must be .*0.7.*1.3') as refused:
        paper_with(state_predictor={'predictor_bias': bias})
    assert '\n' not in str(refused.value)


# -- no prediction -----------------------------------------------------------------------------

def test_without_prediction_the_newest_sample_is_shown_as_it_came():
    history = flown([MEASURED, ESTIMATE, PREDICTION], **SURE,
                    state_predictor={'prediction': False})
    state, measured = history[PREDICTION].state, history[MEASURED].state
    assert_array_equal(state[10:200], measured[:190])   # no run ends before
    assert_array_equal(history[ESTIMATE].state[:200], state[:200])
    assert not history[PREDICTION].valid[:10].any() and history[PREDICTION].valid[10:200].all()


def test_without_prediction_a_lost_sample_leaves_the_one_before():
    history = flown([PREDICTION, MEASURED], link_back={'loss_fraction': 0.4},
                    state_predictor={'prediction': False})
    state, measured = history[PREDICTION].state, history[MEASURED].state
    live = np.isfinite(state[60:150]).all(axis=-1)
    assert live.all()
    new = (state[60:150] == measured[50:140]).all(axis=-1)
    held = (state[60:150] == state[59:149]).all(axis=-1)
    assert np.all(new | held)
    assert 0.25 < held.mean() < 0.55            # 270 samples: .40 lies 5 deviations inside


# -- for how long an error of the thrust lasts -------------------------------------------------

@pytest.mark.parametrize('step_s', [0.1, 0.5, 1.0])
def test_what_a_pulse_gives_does_not_depend_on_the_step_where_errors_last_for_the_burn(step_s):
    steps, runs = round(5.0/step_s), 20_000
    normals = np.random.default_rng(5).standard_normal((steps, runs, 3))
    nominal = np.broadcast_to(LevelForm().effect([2, -1, 3]), (runs, 3))
    burns = OfBurns((runs,))
    of_burn = sum(execute(nominal, burns.of(nominal, n), 0.01)*step_s for n in normals)
    of_steps = sum(execute(nominal, n, 0.01)*step_s for n in normals)
    whole = np.abs(nominal[0])*5.0
    # 5 standard errors of a deviation of 20,000 draws
    assert_allclose(of_burn.std(axis=0)/whole, 0.01, rtol=0.025)
    assert_allclose(of_steps.std(axis=0)/whole, 0.01*np.sqrt(step_s/5.0), rtol=0.025)


def test_a_burn_ends_where_the_command_of_its_axis_changes():
    burns, a = OfBurns(()), LevelForm().effect
    draws = np.arange(1.0, 7.0)[:, None]*np.ones(3)
    said = [burns.of(a(level), n).tolist() for level, n in zip(
        ([1, 1, 0], [1, 2, 0], [1, 2, 1], [0, 2, 1], [1, -2, 1], [1, -2, 1]), draws)]
    assert [[x, y] for x, y, _ in said] == [[1, 1], [1, 2], [1, 2], [4, 2], [5, 5], [5, 5]]
    assert [z for *_, z in said[2:]] == [3, 3, 3, 3]


def test_runs_alone_are_those_of_a_batch():
    changes = {'spacecraft_dynamics': {'execution_noise_per': 'burn', 'thrust_fraction': 0.9},
               'state_predictor': {'predictor_bias': 0.9}}
    together = flown([TRUTH], (3, 4, 5), **changes)[TRUTH].state
    alone = flown([TRUTH], (4,), **changes)[TRUTH].state
    assert_array_equal(together[:len(alone), 1], alone[:, 0])


# -- sensor and link ---------------------------------------------------------------------------

def test_a_bias_of_the_sensor_lasts_for_a_run_and_differs_between_runs():
    lasting = (0.0, 0.2, 0.2)
    history = flown([TRUTH, MEASURED], range(200), relative_sensor={
        'sensor': 'additive', 'additive__noise_fraction': 0.0, 'additive__position_bias_m': lasting,
        'additive__position_sigma_m': (0.0, 0.0, 0.0)})
    off = (history[MEASURED].state - history[TRUTH].state)[:200, :, :3]
    assert_allclose(off, np.broadcast_to(off[0], off.shape), atol=1e-12)
    assert_array_equal(off[0, :, 0], 0.0)
    assert_allclose(off[0, :, 1:].std(axis=0), 0.2, rtol=0.25)      # 200 runs: 5 deviations


def test_runs_with_bursts_and_biases_alone_are_those_of_a_batch():
    changes = {'relative_sensor': {'sensor': 'additive', 'additive__position_bias_m': (.1, .1, .1)},
               'link_forward': {'burst_fraction': 0.2}, 'link_back': {'burst_fraction': 0.2}}
    together = flown([TRUTH], (3, 4, 5), **changes)[TRUTH].state
    alone = flown([TRUTH], (4,), **changes)[TRUTH].state
    assert_array_equal(together[:len(alone), 1], alone[:, 0])


def test_the_ground_counts_bursts_among_what_gets_lost():
    reaching = [paper_with(link_forward=link).part('abort_profile').reaching for link in (
        {}, {'burst_fraction': 0.2, 'burst_loss_fraction': 0.5})]
    assert reaching[1] == pytest.approx(0.9*reaching[0])


# -- why lost commands seem to help ------------------------------------------------------------

@pytest.mark.slow
@pytest.mark.patient
def test_lost_commands_seem_to_help_because_the_predictor_overstates_them():
    """
    Fails if pulses that are weaker by a tenth help by themselves, as was said once.

    4,000 pairs of runs resolve about .01; the bounds are 95 % intervals. The last comparison was
    chosen after the results of another seed were known; the seed here was flown once, afterwards.
    """
    runs = range(4000)

    def success(**changes):
        flight = paper_with(**changes).with_values('/**', seed=1423)
        return fly(flight, list(runs)).verdict.success

    def difference(a, b):
        return stats.newcombe_paired(stats.pair(a, b))
    base = success()
    told = success(spacecraft_dynamics={'thrust_fraction': 0.9},
                   state_predictor={'predictor_bias': 0.9})
    overstated = success(state_predictor={'predictor_bias': 1/0.9})
    low, high = difference(told, base)
    assert -0.02 < low and high < 0.02                  # less thrust alone: nothing much
    low, high = difference(overstated, base)
    assert low > 0.01 and high < 0.06                   # more believed alone: the gain
    lossy = {name: {'loss_fraction': 0.1} for name in ('link_forward', 'link_back')}
    mean = {'in_flight': 'expected'}
    unbiased = success(**lossy, state_predictor=mean)
    assert difference(unbiased, success(state_predictor=mean)).high < 0.0   # losses do harm
    assert difference(success(**lossy), unbiased).low > 0.02                # the same, believed
