"""Bursts of loss against the two-state Markov chain that they are, worked out by hand."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from rvd_dynamics.diagram import streams
from rvd_dynamics.link.bursts import lost_in_bursts
from rvd_dynamics.link.channel import Channel
from rvd_dynamics.link.leg import LinkChance
from rvd_dynamics.link.models import LinkParams
from rvd_dynamics.link.play_out import Frame

STEP_NS, RUNS, STEPS = 500_000_000, 400, 1000
BURSTS = LinkParams(burst_fraction=0.15, burst_mean_s=3.0)


def lost(params=BURSTS, runs=RUNS, steps=STEPS, step_ns=STEP_NS, seed=1):
    return lost_in_bursts(params, streams.generators(seed, range(runs), 'link/test/bursts'),
                          steps, step_ns)


def chance(params=BURSTS):
    return LinkChance('link_forward', params, 10, STEP_NS)


@pytest.mark.parametrize('share', [0.02, 0.15, 0.5])
@pytest.mark.parametrize('step_ns, mean_s', [(STEP_NS, 3.0), (100_000_000, 3.0), (STEP_NS, 0.1)])
@pytest.mark.parametrize('of_a_burst', [1.0, 0.6])
def test_the_share_of_lost_frames_is_that_of_the_stationary_chain(share, step_ns, mean_s,
                                                                  of_a_burst):
    params = LinkParams(burst_fraction=share, burst_mean_s=mean_s, burst_loss_fraction=of_a_burst)
    ends = min(step_ns/1e9/mean_s, 1.0)
    stays = 1.0 - ends - ends*share/(1.0 - share)       # eigenvalue of the chain beside 1
    count, expected = RUNS*STEPS, share*of_a_burst
    # variance of a mean of correlated draws; what the chance inside a burst adds is independent
    variance = (of_a_burst**2*share*(1.0 - share)*(1.0 + stays)/(1.0 - stays)
                + share*of_a_burst*(1.0 - of_a_burst))/count
    found = lost(params, step_ns=step_ns)
    assert abs(found.mean() - expected) <= 5*np.sqrt(variance) + 1e-12
    # no run begins in a better or worse link: the first step alone
    assert abs(found[:, 0].mean() - expected) < 5*np.sqrt(expected*(1.0 - expected)/RUNS)


@pytest.mark.parametrize('step_ns, mean_s, steps', [
    (STEP_NS, 3.0, 6.0), (100_000_000, 3.0, 30.0), (STEP_NS, 0.1, 1.0)])
def test_bursts_last_as_long_as_they_should_on_average(step_ns, mean_s, steps):
    marked = lost(replace(BURSTS, burst_mean_s=mean_s), step_ns=step_ns)
    lengths = []
    for row in marked:
        edges = np.flatnonzero(np.diff(row.astype(int)))
        begins = edges[~row[edges]]                 # whole bursts, from their first step on
        for at in begins:
            end = np.flatnonzero(~row[at + 1:])
            if at < STEPS/2 and end.size:           # so far from the end hardly any is cut
                lengths.append(end[0])
    deviation = np.sqrt(steps*(steps - 1.0))        # of a geometric distribution
    assert len(lengths) > 300
    assert abs(np.mean(lengths) - steps) <= 5*deviation/np.sqrt(len(lengths)) + 1e-12


def test_the_chain_has_no_memory_beyond_one_step():
    marked = lost()
    ends, begins = 0.5/3.0, 0.5/3.0*0.15/0.85
    for before in (False, True):                    # what was two steps ago does not count
        for now, leaves in ((False, begins), (True, 1.0 - ends)):
            where = (marked[:, :-2] == before) & (marked[:, 1:-1] == now)
            found = marked[:, 2:][where].mean()
            assert abs(found - leaves) < 5*np.sqrt(leaves*(1.0 - leaves)/where.sum())


def test_a_longer_run_begins_as_a_shorter_one():
    assert_array_equal(lost(runs=20, steps=300)[:, :100], lost(runs=20, steps=100))


def test_bursts_move_no_other_draw_and_take_nothing_else():
    wild = LinkParams(loss_fraction=0.1, duplicate_fraction=0.4, corrupt_fraction=0.2)
    without, bursty = (chance(params).of_run(3, 7, 401) for params in (
        wild, replace(wild, burst_fraction=0.3)))
    for name in ('transit_ns', 'damaged', 'damage', 'duplicated', 'outage'):
        assert_array_equal(getattr(without, name), getattr(bursty, name))
    more = bursty.lost & ~without.lost
    assert np.all(bursty.lost[without.lost]) and more.any()
    both = (bursty.lost & ~without.lost).any(axis=1)
    assert bursty.lost[both].all()                  # a frame and its copy go together


def test_one_run_and_many_and_the_channel_agree():
    params = LinkParams(loss_fraction=0.05, duplicate_fraction=0.4, burst_fraction=0.3)
    link, runs = chance(params), [4, 0, 9]
    together = link.of_runs(2, runs, 200)
    for row, run in zip(together, runs):
        plan = link.of_run(2, run, 200)
        assert_array_equal(row, plan.intact_in_time)
        channel, came = Channel(plan, 10, STEP_NS), np.zeros(200, dtype=bool)
        for k in range(200):
            out = channel.advance(k, Frame(sequence=k + 1, sent_ns=k*STEP_NS, payload=b'x'*8))
            if out is not None and out.payload == b'x'*8:
                came[out.sequence - 1] = True
        assert_array_equal(came[:190], row[:190])


def test_without_bursts_their_stream_is_not_touched():
    assert chance(LinkParams()).purposes == ('link_forward',)
    assert chance(replace(BURSTS, burst_loss_fraction=0.0)).purposes == ('link_forward',)
    assert chance().purposes == ('link_forward', 'link/link_forward/bursts')


@pytest.mark.parametrize('key, value', [('burst_fraction', 0.51), ('burst_mean_s', 0.0),
                                        ('burst_loss_fraction', 1.1)])
def test_impossible_bursts_are_refused(key, value):
    with pytest.raises(ValueError, match=f'{key} must be .*, got {value}'):
        LinkParams(**{key: value})
