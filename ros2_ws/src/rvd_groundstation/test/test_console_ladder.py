"""The ladder says of each command what telemetry can have told, and no more."""

import pytest

from rvd_dynamics.commands.codes import (
    KIND_ABORT, KIND_THRUST, REASON_ABORT, REASON_CHECKSUM, REASON_NONE)
from rvd_groundstation.console.ladder import Ladder, STATES

FORWARD, BACK, STEP_S = 4, 3, 0.5


def flown(steps, lost=(), refused=(), dark=(), **ladder):
    """
    Fly a ladder against a craft of our own: sequence = step + 1, due FORWARD later.

    `lost` and `refused` are sequences that do not get through, `dark` the steps whose downlink
    is lost. As the craft does, each downlink tells why the command of the step before was refused.
    """
    ladder = Ladder(FORWARD, STEP_S, **ladder)
    accepted, code, downlinks = 0, 0, {}
    for k in range(steps):
        downlinks[k] = (accepted, code)         # of the commands up to k - 1
        due = k - FORWARD + 1
        code = REASON_CHECKSUM if due in refused else REASON_NONE
        if due >= 1 and due not in (*lost, *refused):
            accepted = due
        if k >= BACK and k - BACK not in dark:
            ladder.heard(k, k - BACK, *downlinks[k - BACK])
        ladder.sent(k, k + 1, (1, 0, 0), KIND_THRUST)
        ladder.tick(k)
    return ladder


def states(ladder):
    return {rung.sequence: STATES[rung.state] for rung in ladder.rungs}


def test_commands_climb_in_order_on_a_perfect_link():
    now = states(flown(30))
    assert now[30] == 'SENT' and now[27] == 'SENT'
    assert now[26] == 'DUE'                     # sent at 25, due at 29
    assert now[22] == 'EXECUTED'                # due at 25, told by the downlink of 26 at 29
    assert now[1] == 'SEEN'
    order = [STATES.index(now[s]) for s in range(30, 0, -1)]
    assert order == sorted(order)


def test_the_round_trip_is_the_loop_and_the_step_it_acts_in():
    assert flown(30).round_trip_steps == FORWARD + BACK + 1


def test_what_the_link_lost_is_missed_and_what_the_guard_refused_is_refused_with_its_code():
    ladder = flown(30, lost={5}, refused={9})
    now = states(ladder)
    assert now[5] == 'MISSED' and now[9] == 'REFUSED'
    assert next(r for r in ladder.rungs if r.sequence == 9).refusal == REASON_CHECKSUM
    assert now[6] == now[10] == 'SEEN'


@pytest.mark.parametrize('refused, lost', [({9, 10}, {5}), ({9, 14}, {12}), ({6, 7, 8}, ())])
def test_a_second_equal_refusal_is_a_refusal_and_a_miss_after_it_a_miss(refused, lost):
    ladder = flown(40, lost=lost, refused=refused)
    now = states(ladder)
    assert {s for s, state in now.items() if state == 'REFUSED'} == refused
    assert {s for s, state in now.items() if state == 'MISSED'} == set(lost)
    assert {r.refusal for r in ladder.rungs if r.sequence in refused} == {REASON_CHECKSUM}


def test_an_abort_that_was_lost_while_one_is_in_force_is_missed_and_not_refused():
    ladder = Ladder(FORWARD, STEP_S)
    for k, kind in enumerate((KIND_ABORT, KIND_ABORT, KIND_THRUST)):
        ladder.sent(k, k + 1, (0, 0, 0), kind)
    for k in range(3):                          # the first is in force, the others do not get in
        ladder.heard(k + 8, k + FORWARD + 1, 1, REASON_ABORT if k else REASON_NONE)
    assert [STATES[r.state] for r in ladder.rungs] == ['SEEN', 'MISSED', 'REFUSED']


def test_a_refusal_that_dark_telemetry_told_of_is_missed_since_only_the_acceptance_is_known():
    ladder = flown(20, refused={7, 8}, dark={7 - 1 + FORWARD + 1})
    assert states(ladder)[7] == 'MISSED' and states(ladder)[8] == 'REFUSED'


def test_where_the_telling_telemetry_was_lost_the_ladder_says_unknown():
    dark = flown(30, lost={7}, dark={7 - 1 + FORWARD + 1})
    assert states(dark)[7] == 'UNKNOWN'         # it was lost, but nobody on the ground can know
    assert states(dark)[8] == 'SEEN'


def test_an_abort_overtakes_what_is_on_the_way():
    ladder = Ladder(FORWARD, STEP_S)
    for k in range(6):
        ladder.sent(k, k + 1, (1, 0, 0), KIND_THRUST)
    ladder.sent(6, 7, (0, 0, 0), KIND_ABORT)
    ladder.heard(8, 8, 7, 0)                    # accepted at once, long before 6 + FORWARD
    now = {rung.sequence: rung for rung in ladder.rungs}
    assert STATES[now[7].state] == 'EXECUTED'
    assert STATES[now[6].state] == 'REFUSED' and now[6].refusal == REASON_ABORT


def test_telemetry_that_acknowledges_nothing_leaves_every_fate_unknown():
    ladder = Ladder(FORWARD, STEP_S)
    for k in range(20):
        if k >= BACK:
            ladder.heard(k, k - BACK, None, 0)
        ladder.sent(k, k + 1, (1, 0, 0), KIND_THRUST)
        ladder.tick(k)
    assert set(states(ladder).values()) == {'SENT', 'DUE', 'UNKNOWN'}
    assert ladder.round_trip_steps is None


def test_changes_come_once_and_a_late_page_gets_all():
    ladder = flown(12)
    version = ladder.version
    assert len(ladder.changes()) == 12 and ladder.changes(version) == []
    ladder.sent(12, 13, (0, 0, 0), KIND_THRUST)
    assert [row[0] for row in ladder.changes(version)] == [13]


@pytest.mark.parametrize('steps', [5, 700])
def test_the_ladder_does_not_grow_for_ever(steps):
    assert len(flown(steps).rungs) == min(steps, 600)


@pytest.mark.parametrize('archive, rungs', [(None, 20), ([], 90)])
def test_a_review_has_the_whole_ladder_and_a_flight_the_end_of_it(archive, rungs):
    ladder = flown(90, keep=20, archive=archive)
    rows = ladder.whole()
    assert len(rows) == rungs and rows[-1][0] == 90
    assert [row[0] for row in rows] == sorted(row[0] for row in rows)
    assert len(ladder.changes()) == 20          # what a page that comes late is sent
    if archive is not None:
        assert {STATES[row[4]] for row in rows[:60]} == {'SEEN'}        # fates, not just names
