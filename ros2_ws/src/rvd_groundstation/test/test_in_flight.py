"""What commands in flight count for, against all outcomes written out with their probabilities."""

from itertools import product

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal
from paper import Paper
import pytest
from scipy.linalg import expm

from rvd_groundstation.prediction.in_flight import IN_FLIGHT, Loss, PRIOR, reach, thrust_noise
from rvd_groundstation.prediction.predictor import PredictorParams

P, LOOP = 0.3, 7
RNG = np.random.default_rng(1)
COMMANDS = RNG.normal(scale=0.01, size=(LOOP, 3))


def model():
    """Return Phi and Gamma by the matrix exponential of the augmented system."""
    n, a = Paper().orbit.mean_motion, np.zeros((9, 9))
    a[:3, 3:6] = a[3:6, 6:] = np.eye(3)
    a[3, 4], a[4, 3], a[4, 1], a[5, 2] = -2*n, 2*n, 3*n*n, -n*n
    big = expm(a * 0.5)
    return big[:6, :6], big[:6, 6:]


PHI, GAMMA = model()


def outcomes(commands, phi, start=None, gains=None):
    """Yield (probability, state) of each way in which commands may act; `gains` filter it."""
    for acted in product((0.0, 1.0), repeat=len(commands)):
        state = np.zeros(6) if start is None else start
        for i, (acts, command) in enumerate(zip(acted, commands)):
            state = phi @ state + GAMMA @ (acts*command)
            if gains is not None:
                state = state - gains[i] @ state
        yield np.prod([1 - P if acts else P for acts in acted]), state


def square_about(centre, found):
    """Return the mean square (6, 6) of outcomes about a state."""
    return sum(p * np.outer(state - centre, state - centre) for p, state in found)


def in_flight(name, batch=()):
    return IN_FLIGHT[name](Loss(P, False, batch), PHI, GAMMA, LOOP, batch)


def test_expected_is_mean_and_covariance_of_all_outcomes():
    found, made = list(outcomes(COMMANDS, PHI)), in_flight('expected')
    mean = sum(p * state for p, state in found)
    counted = np.zeros(6)
    for command in COMMANDS:
        counted = PHI @ counted + GAMMA @ made.mean(command, np.array(P))
    assert_allclose(counted, mean, atol=1e-15)
    assert_allclose(made.scatter(COMMANDS), square_about(mean, found), rtol=1e-9, atol=1e-18)


def test_as_sent_is_the_mean_square_about_the_commands_as_they_were_sent():
    """In flight, and in a filter that took them as sent: any gains, and samples left out."""
    made, gains = in_flight('as_sent'), []
    past = RNG.normal(scale=0.01, size=(5, 3))
    for i, command in enumerate(past):
        gain = RNG.normal(scale=0.1, size=(6, 6)) + 0.3*np.eye(6)
        taken = np.bool_(i != 2)
        gains.append(gain if taken else np.zeros((6, 6)))
        made.updated(command, gain, taken)
        assert_array_equal(made.mean(command, np.array(P)), command)
    # what is off: what acted minus what was counted, carried through the same filter
    def off(commands, start, gains=None):
        for p, state in outcomes(commands, PHI, start, gains):
            sent = np.zeros(6) if start is None else start
            for n, command in enumerate(commands):
                sent = PHI @ sent + GAMMA @ command
                sent = sent if gains is None else sent - gains[n] @ sent
            yield p, state - sent
    before = list(off(past, None, gains))
    assert_allclose(made.estimate_scatter(), square_about(np.zeros(6), before),
                    rtol=1e-9, atol=1e-18)
    after = [(p*q, np.linalg.matrix_power(PHI, LOOP) @ a + b)
             for p, a in before for q, b in off(COMMANDS, None)]
    assert_allclose(made.scatter(COMMANDS), square_about(np.zeros(6), after), rtol=1e-9,
                    atol=1e-18)


def test_where_telemetry_has_told_nothing_is_guessed():
    made, own = in_flight('expected', (3,)), np.array([[0.01, -0.02, 0.005]]*3)
    accel, spread = made.past(made.mean(own, np.full(3, P)), own, np.array([True, False, True]),
                              np.array([True, True, False]), np.full(3, P))
    assert_array_equal(accel[0], own[0])
    assert_array_equal(accel[1], 0.0)
    assert_allclose(accel[2], (1 - P)*own[2])
    assert not spread[:2].any()
    assert_allclose(spread[2], P*(1 - P)*np.array([1e-4, 4e-4, 2.5e-5, -2e-4]))


@pytest.mark.parametrize('batch', [(), (1,), (300,)])
def test_rows_have_the_same_bits_alone_and_in_a_batch(batch):
    own = RNG.normal(scale=0.01, size=(LOOP, *batch, 3))
    for name in IN_FLIGHT:
        whole = in_flight(name, batch)
        whole.updated(own[0], 0.2*np.eye(6), np.ones(batch, dtype=bool))
        for row in list(np.ndindex(batch))[::37]:
            alone = in_flight(name)
            at = (slice(None), *row)
            alone.updated(own[at][0], 0.2*np.eye(6), np.bool_(True))
            assert_array_equal(alone.mean(own[at], np.array(P)),
                               whole.mean(own, np.full(batch, P))[at])
            assert_array_equal(alone.scatter(own[at]),
                               whole.scatter(own)[row])


def test_noise_of_the_thrust_is_that_of_its_components():
    """By brute force: independent errors of each component of each command."""
    draws = np.random.default_rng(2).normal(size=(40_000, LOOP, 3))
    errors = np.einsum('lij,rlj->ri', reach(PHI, GAMMA, LOOP), 0.05*COMMANDS*draws)
    expected = np.einsum('ri,rj->ij', errors, errors) / len(draws)
    scale = np.sqrt(np.diagonal(expected))
    found = thrust_noise(reach(PHI, GAMMA, LOOP), COMMANDS, 0.05)
    assert_allclose(found / np.outer(scale, scale), expected / np.outer(scale, scale), atol=0.03)


def test_the_loss_that_telemetry_tells_wins_over_the_settings():
    rng, loss = np.random.default_rng(3), Loss(0.01, True, (2,))
    for k in range(4000):
        loss.hear(rng.random(2) < 0.7, np.array([True, k < 10]))
    assert loss.probability[0] == pytest.approx(0.3, abs=4*np.sqrt(0.21/4000))
    assert loss.probability[1] < 0.15           # ten are few against those the settings count for
    fixed = Loss(0.01, False, ())
    fixed.hear(np.bool_(False), np.bool_(True))
    assert fixed.probability == 0.01
    first = Loss(0.01, True, ())
    first.hear(np.bool_(False), np.bool_(True))
    assert first.probability == pytest.approx((0.01*PRIOR + 1) / (PRIOR + 1))


def test_unknown_ways_are_refused_by_name():
    with pytest.raises(ValueError, match='in_flight must be one of expected, as_sent, got hoped'):
        PredictorParams(in_flight='hoped')
    with pytest.raises(ValueError, match='loss_probability'):
        PredictorParams(loss_probability=1.5)
