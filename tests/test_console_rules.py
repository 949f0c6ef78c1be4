"""Rules of the page without a browser: when an alarm stands, which field of view a camera has."""

import json

import pytest
from console_page import in_node

from rvd_dynamics.commands.codes import (
    BY_AUTO, BY_NOBODY, BY_PILOT, REASON_ABORT, REASON_AUTO_INVALID, REASON_BOTH_INVALID,
    REASON_PILOT_INVALID)


def run(script: str, **given):
    """Run a script with the values `given` and return what it leaves in `made`."""
    return in_node(f"""
import {{ Alarms, ofDisplay, ofPage }} from './alarms.js';
import {{ decided }} from './decided.js';
import {{ fieldOf, stepsOf }} from './field.js';
const given = {json.dumps(given)};
let made;
{script}
console.log(JSON.stringify(made));
""")


SPEED = {'words': 'TOO FAST', 'level': 'warning', 'label': 'speed', 'unit': 'm/s', 'digits': 2,
         'back': 0.02, 'readings': [
             {'role': role, 'value': {'signal': role, 'part': 'v', 'index': [0], 'factor': 1},
              'low': None, 'high': 0.3} for role in ('measured', 'predicted')]}
JUDGE = """
const alarms = new Alarms();
const frame = ([measured, predicted]) => ({ signals: {
  measured: { ok: measured !== null, parts: { v: [measured] } },
  predicted: { ok: true, parts: { v: [predicted] } } } });
made = given.rows.map(({ t, v, ack }) => {
  if (ack) alarms.acknowledge();
  alarms.judge(ofDisplay(frame(v), given.display, (words) => alarms.stands(words)), t);
  return { stands: alarms.stands('TOO FAST'), loud: alarms.loud,
           role: alarms.shown[0]?.seen?.role ?? null };
});
"""


def judged(*rows, alarm=SPEED):
    """Return what stands after each of some rows (t, measured, predicted, acknowledged)."""
    return run(JUDGE, display=[alarm], rows=[
        {'t': t, 'v': [m, p], 'ack': bool(ack)} for t, m, p, *ack in rows])


def stands(made) -> list[bool]:
    return [row['stands'] for row in made]


def test_an_alarm_is_raised_at_its_limit_and_says_which_reading():
    made = judged((0, 0.2, 0.29), (1, 0.2, 0.3), (2, 0.4, 0.31))
    assert stands(made) == [False, True, True]
    assert [row['role'] for row in made] == [None, 'predicted', 'measured']


# it hovers about its limit for a while, and is inside by more than `back` in the end
HOVERING = [(i, 0.2, 0.3 + 0.01*(-1)**i) for i in range(12)] + [(i, 0.2, 0.2) for i in (12, 14)]


def test_a_reading_that_hovers_about_its_limit_does_not_flicker():
    assert stands(judged(*HOVERING)) == [True]*13 + [False]


def test_without_a_way_back_it_would():
    slow = [(4*t, m, p) for t, m, p in HOVERING]       # slower than an alarm is held
    assert stands(judged(*slow)) == [True]*12 + [False]*2
    flickers = stands(judged(*slow, alarm=SPEED | {'back': 0.0}))[:12]
    assert flickers == [True, False]*6


def test_an_alarm_that_has_gone_and_comes_again_is_a_new_one():
    made = judged((0, 0.2, 0.4), (1, 0.2, 0.4, True), (2, 0.2, 0.1), (5, 0.2, 0.1), (6, 0.2, 0.4))
    assert [row['loud'] for row in made] == ['warning', '', '', '', 'warning']
    assert stands(made) == [True, True, True, False, True]


def test_what_is_not_known_neither_raises_an_alarm_nor_ends_it():
    made = judged((0, None, None), (1, 0.4, None), (9, None, None), (20, None, None))
    assert stands(made) == [False, True, True, True]


PAGE = """
const run = { pace: 1, step_s: 0.1, back_s: 5, operator: 'console' };
const words = { telemetry: 'T', pilot: 'P', nobody: 'N' };
const facts = { run, frame: { t: 20 }, measured: { t: 15 }, silence: 0, connected: true,
  pilotLost: false, flies: decided('shared', 1, 0) };
made = given.rows.map(({ command, ...row }) => {
  const flies = command && { flies: decided(...command) };
  return ofPage({ ...facts, ...row, ...flies }, words)
    .filter(({ on }) => on).map((one) => one.words).join('');
});
"""


@pytest.mark.parametrize('said, raised', [
    ({}, ''),
    ({'measured': {'t': 13.0}}, 'T'),                   # 7 s old where 5 s are the delay's
    ({'measured': {'t': 14.1}}, ''),
    ({'measured': None, 'frame': {'t': 5.5}}, ''),      # the first is under way
    ({'measured': None, 'frame': {'t': 7.0}}, 'T'),
    ({'silence': 1.2}, 'T'), ({'silence': 0.5}, ''),
    ({'connected': False}, 'T'),
    ({'pilotLost': True}, 'P'),
    ({'command': ['shared', BY_AUTO, REASON_PILOT_INVALID]}, 'N'),
    ({'command': ['manual', BY_NOBODY, REASON_BOTH_INVALID]}, 'N'),
    ({'command': ['manual', BY_NOBODY, REASON_ABORT]}, ''),     # it is not the pilot's turn
    ({'command': ['shared', BY_PILOT, REASON_AUTO_INVALID]}, ''),
    ({'flies': None}, ''),                              # not told, or not known any more
    ({'pilotLost': True, 'command': ['manual', BY_NOBODY, REASON_BOTH_INVALID]}, 'P')])
def test_the_page_s_own_alarms(said, raised):
    assert run(PAGE, rows=[said]) == [raised]


CAMERA = {'half_field': [0.085, 0.9], 'half_height_m': 1.35}
FIELD = """
let before;
made = given.ranges.map((range) => {
  before = fieldOf(given.camera, range, before);
  return before;
});
"""


def test_the_field_of_view_has_few_steps_and_each_holds_what_it_must():
    ranges = [30.0 - 0.05*i for i in range(593)]
    fields = run(FIELD, camera=CAMERA, ranges=ranges)
    assert sorted(set(fields)) == pytest.approx([0.085, 0.17, 0.34, 0.68, 0.9])
    assert fields == sorted(fields)                     # coming nearer, it only widens
    assert all(f*r >= 1.35 - 1e-9 for f, r in zip(fields, ranges) if r > 1.5)


def test_a_range_that_hovers_about_a_step_does_not_change_it_to_and_fro():
    edge = 1.35/0.17
    fields = run(FIELD, camera=CAMERA, ranges=[8.2, *(edge + 0.2*(-1)**i for i in range(9)), 10.0])
    assert fields[0] == 0.17 and len(set(fields[2:10])) == 1
    assert fields[-1] == 0.17
