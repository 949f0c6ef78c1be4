"""What was flown, by the record: the mode of each step, whatever the run was meant to be."""


import numpy as np
import pytest

from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.recording import flown
from rvd_dynamics.recording.history import everything, of_history
from rvd_groundstation.operators.operation import MODES
from rvd_groundstation.sharing import decide, SHARING
from rvd_campaign.report.run import page

LEVELS = np.array([[0, 0, 0], [3, -3, 1], [1, 0, -2]], dtype=np.int8)


def every_decision():
    """Yield mode, who decided and why for every mode, sharing and validity of the inputs."""
    for mode in MODES:
        for make in SHARING.values():
            for valid in (True, False):
                for auto_valid in (True, False):
                    for pilot in LEVELS:
                        for auto in LEVELS:
                            d = decide(mode, make(), pilot, valid, auto, auto_valid)
                            yield mode, int(d.decided_by), int(d.reason)


def test_a_command_tells_the_mode_that_made_it():
    seen = set(every_decision())
    assert {mode for mode, _, _ in seen} == set(MODES)
    for mode, by, reason in seen:
        assert flown.mode_of(by, reason) == mode


def test_what_no_mode_makes_is_none():
    made = {(by, reason) for _, by, reason in every_decision()}
    for by in range(codes.BY_GUARD + 1):
        for reason in range(codes.REASON_ABORT):
            known = flown.mode_of(by, reason) != flown.UNKNOWN
            assert known or (by, reason) not in made
    assert flown.mode_of(codes.BY_PILOT, codes.REASON_ABORT) == flown.ABORT
    assert flown.mode_of(codes.BY_GUARD, codes.REASON_MODE) == flown.UNKNOWN


def recorded(*schedule):
    scenario = parse('/**: {ros__parameters: {mode: manual, operator: model, timeout_s: 60.0}}',
                     'test')
    batch = fly(scenario, [0], record=everything(scenario), schedule=schedule)
    return of_history(scenario, batch)


def test_a_flight_is_what_was_flown_and_not_what_was_asked_for():
    as_asked = flown.of_recording(recorded()).as_dict()
    assert as_asked['modes'] == {'manual': 1.0}
    run = recorded(Change(20, mode='auto'), Change(100, mode='manual'))
    made = flown.of_recording(run)
    assert made.modes == {'manual': 20 + made.steps - 100, 'auto': 80}
    assert sum(made.as_dict()['modes'].values()) == pytest.approx(1.0)
    assert made.decided == {'pilot': 20 + made.steps - 100, 'automatic': 80}
    assert run.scenario.part('operation').mode == 'manual'      # what alone was said before
    assert f'mode <b>manual {100 * made.modes["manual"] / made.steps:.0f} %, auto ' in page(run)


def test_steps_under_an_abort_are_of_no_mode():
    made = flown.of_recording(recorded(Change(50, abort=True)))
    assert made.aborted and made.modes == {'manual': 50, 'abort': made.steps - 50}



def test_a_mission_with_modes_of_its_own_is_known_by_its_events():
    said = [(9, 'MODE', 'mode hold'), (49, 'PAUSE', ''), (59, 'MODE', 'mode go')]
    made = flown._flown('model', said, 99)
    assert made.modes == {'model': 10, 'hold': 50, 'go': 40}
    assert made.pauses == 1 and not made.aborted
    assert flown._flown('model', [], 99).modes == {'model': 100}
    assert flown._flown('', [(5, 'ABORT', '')], 99) == flown.Flown(100, {}, {}, True, 0)
