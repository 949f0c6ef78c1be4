"""The experiment desk: balanced orders, a volunteer's way through it, ratings beside the bag."""

from collections import Counter
from dataclasses import replace
import json

import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.recording import whole
from rvd_groundstation.console.desk import (
    cooper_harper_range, Desk, latin_square, plan, read_session, Session, TLX, tlx_pairs)

SESSION = Session('t', 5, {'manual': 'manual', 'shared': 'shared'}, 1, 2, 2, 0.0)
GOOD = {'cooper_harper': {'controllable': True, 'adequate': True, 'satisfactory': False,
                          'rating': 4}, 'tlx': dict.fromkeys(TLX, 35)}


@pytest.mark.parametrize('n', [1, 2, 3, 4, 5, 6, 7, 8])
def test_a_latin_square_is_balanced(n):
    rows = latin_square(n)
    for place in range(n):                      # each item equally often in each place
        assert set(Counter(row[place] for row in rows).values()) == {len(rows) // n}
    after = Counter((a, b) for row in rows for a, b in zip(row, row[1:]))
    assert len(after) == n * (n - 1) and len(set(after.values())) <= 1


def test_volunteers_are_dealt_different_orders_and_paired_seeds():
    first, second = plan(SESSION, 1), plan(SESSION, 2)
    assert [f.condition for f in first] == [f.condition for f in second][::-1]
    seeds = {name: [f.seed for f in first if f.condition == name and not f.training]
             for name in SESSION.conditions}
    assert seeds['manual'] == seeds['shared'] and len(set(seeds['manual'])) == 2
    assert not {f.seed for f in first} & {f.seed for f in second}
    assert plan(SESSION, 1) == first            # the same again


def flown(desk, folder, reason='docked', modes=None, **said):
    """Fly the next flight as its condition says, or otherwise, to the end of its folder."""
    order = desk.do({'act': 'fly'})
    run = folder / order['out']
    run.mkdir(parents=True)
    desk.flown({'reason': reason, 'words': 'Docked', 'success': True})
    assert desk.view()['stage'] in ('rate', 'broken')   # at once
    assert desk.view()['closing']               # its folder is still being written
    tell(run, order['mode'] if modes is None else modes, **said)
    desk.ended(order['out'])
    return run


def tell(run, modes, aborted=False, pauses=0, **more):
    """Write the verdict of a flight in one mode, or in several."""
    shares = {modes: 1.0} if isinstance(modes, str) else modes
    (run / 'verdict.json').write_text(json.dumps({'reason': 'docked', 'trusted': True, 'flown': {
        'modes': shares, 'aborted': aborted, 'pauses': pauses}, **more}))


def test_a_volunteer_is_led_through_all_flights(tmp_path):
    desk = Desk(SESSION, tmp_path)
    assert desk.view()['stage'] == 'door'
    desk.do({'act': 'begin', 'volunteer': 3})
    stages = []
    for _ in range(6):
        run = flown(desk, tmp_path)
        desk.do({'act': 'rate', **GOOD})
        made = json.loads((run / 'ratings.json').read_text())
        assert made['volunteer'] == 'P03' and made['tlx']['mean'] == 35
        stages.append(desk.view()['stage'])
        if stages[-1] == 'rest':
            desk.do({'act': 'go_on'})
    assert stages == ['ready', 'rest', 'ready', 'rest', 'ready', 'done']


def test_a_session_goes_on_where_it_was_broken_off(tmp_path):
    desk = Desk(SESSION, tmp_path)
    desk.do({'act': 'begin', 'volunteer': 1})
    flown(desk, tmp_path)
    desk.do({'act': 'rate', **GOOD})
    flown(desk, tmp_path)                       # and then the power fails: not rated
    again = Desk(SESSION, tmp_path)
    again.do({'act': 'begin', 'volunteer': 1})
    assert again.view()['number'] == 2
    order = again.do({'act': 'fly'})
    assert order['out'].endswith('.2')          # nothing is written over
    again.ended('P01/01-manual')                # word of the flight before comes late
    assert again.view()['stage'] == 'flying'
    again.ended(order['out'])
    assert again.view()['stage'] == 'ready'


def test_every_pair_of_scales_is_asked_once_in_an_order_of_its_own():
    first, second = tlx_pairs('5 P01 manual'), tlx_pairs('5 P02 manual')
    for pairs in (first, second):
        assert sorted(sorted(pair) for pair in pairs) == sorted(
            sorted([a, b]) for i, a in enumerate(TLX) for b in TLX[i + 1:])
    assert first != second and first == tlx_pairs('5 P01 manual')


def weigh(desk, favourite):
    """Choose the favourite wherever it is offered, else the first of the pair."""
    chosen = [favourite if favourite in pair else pair[0] for pair in desk.view()['pairs']]
    desk.do({'act': 'weigh', 'chosen': chosen})


def test_weights_are_asked_once_for_each_condition(tmp_path):
    desk = Desk(replace(SESSION, tlx='weighted', break_after=0), tmp_path)
    desk.do({'act': 'begin', 'volunteer': 3})
    stages = []
    for _ in range(6):
        flown(desk, tmp_path)
        desk.do({'act': 'rate', **GOOD})
        stages.append(desk.view()['stage'])
        if stages[-1] == 'weigh':
            weigh(desk, 'effort')
    assert stages == ['weigh', 'ready', 'ready', 'weigh', 'ready', 'done']
    made = json.loads((tmp_path / 'P03' / 'tlx_weights.json').read_text())
    assert set(made) == {'manual', 'shared'}
    for weights in made.values():
        assert weights['effort'] == 5 and sum(weights.values()) == 15


def test_pairs_that_were_broken_off_are_asked_again(tmp_path):
    session = replace(SESSION, tlx='weighted')
    desk = Desk(session, tmp_path)
    desk.do({'act': 'begin', 'volunteer': 1})
    flown(desk, tmp_path)
    desk.do({'act': 'rate', **GOOD})
    asked = desk.view()['pairs']
    again = Desk(session, tmp_path)
    again.do({'act': 'begin', 'volunteer': 1})
    assert again.view()['stage'] == 'weigh' and again.view()['pairs'] == asked
    weigh(again, 'mental')
    assert again.view()['stage'] == 'ready' and again.view()['number'] == 2


@pytest.mark.parametrize('chosen', [None, [], ['mental'] * 15, 'mental', [['mental']] * 15])
def test_choices_that_are_not_of_the_pairs_are_refused(tmp_path, chosen):
    desk = Desk(replace(SESSION, tlx='weighted'), tmp_path)
    desk.do({'act': 'begin', 'volunteer': 1})
    flown(desk, tmp_path)
    desk.do({'act': 'rate', **GOOD})
    with pytest.raises(ValueError, match='WEIGHTS'):
        desk.do({'act': 'weigh', 'chosen': chosen})
    assert desk.view()['stage'] == 'weigh'


@pytest.mark.parametrize('change', [
    {'cooper_harper': None}, {'tlx': {}}, {'tlx': dict.fromkeys(TLX, 33)},
    {'cooper_harper': {**GOOD['cooper_harper'], 'rating': 2}},
    {'cooper_harper': {**GOOD['cooper_harper'], 'rating': True}},
    {'cooper_harper': {**GOOD['cooper_harper'], 'controllable': 'yes'}}])
def test_an_incomplete_rating_is_refused(tmp_path, change):
    desk = Desk(SESSION, tmp_path)
    desk.do({'act': 'begin', 'volunteer': 1})
    run = flown(desk, tmp_path)
    with pytest.raises(ValueError):
        desk.do({'act': 'rate', **GOOD, **change})
    assert not (run / 'ratings.json').exists() and desk.view()['stage'] == 'rate'


def test_the_decision_tree_leaves_each_rating_in_one_branch():
    branches = [(False, False, False), (True, False, False), (True, True, False),
                (True, True, True)]
    ranges = [cooper_harper_range(*answers) for answers in branches]
    assert sorted(r for low, high in ranges for r in range(low, high + 1)) == list(range(1, 11))


@pytest.mark.parametrize('act', ['fly', 'rate', 'go_on', 'what', None])
def test_what_does_not_fit_the_stage_is_refused(tmp_path, act):
    with pytest.raises(ValueError, match='STAGE'):
        Desk(SESSION, tmp_path).do({'act': act})


@pytest.mark.parametrize('text, names', [
    ('- 1', 'not a mapping'), ('flights: 3', 'conditions'),
    ('{conditions: {a: {mode: auto}}, fly: 1}', 'fly'),
    ('{conditions: {a: {mode: no}}}', 'mode'), ('{conditions: {"../x": {mode: auto}}}', 'plain'),
    ('{conditions: {a: {mode: auto}}, flights: -1}', 'flights'),
    ('{conditions: {a: {mode: auto}}, tlx: full}', 'raw or weighted'), ('{', 'not valid YAML'),
    ('{conditions: {a: {mode: auto}, a: {mode: shared}}}', 'given twice: a'),
    ('{conditions: {a: {mode: auto}}, 1: 2, b: 3}', 'unknown key 1'),
    ('{conditions: {a: {mode: auto}}, seed: !!bool x}', 'not valid YAML'),
    ('{conditions: {a: {mode: auto}}, seed: 2026-99-99}', 'not valid YAML')])
def test_a_session_file_that_is_none_is_refused_in_one_line(tmp_path, text, names):
    file = tmp_path / 's.yaml'
    file.write_text(text)
    with pytest.raises(ValueError, match=names) as refused:
        read_session(file)
    assert '\n' not in str(refused.value)


def test_the_note_of_a_session_is_kept_for_its_report(tmp_path):
    file = tmp_path / 's.yaml'
    file.write_text('conditions: {manual: {mode: manual}}\nnote: as known from elsewhere\n')
    Desk(read_session(file), tmp_path / 'session')
    kept = json.loads((tmp_path / 'session' / 'session.json').read_text())
    assert kept['note'] == 'as known from elsewhere'


def test_a_rating_that_the_disk_does_not_take_can_be_given_again(tmp_path, monkeypatch):
    desk = Desk(SESSION, tmp_path)
    desk.do({'act': 'begin', 'volunteer': 1})
    flown(desk, tmp_path)
    before, write_text = desk.view(), whole.write_text

    def full(path, text):
        raise OSError(28, 'No space left on device')
    monkeypatch.setattr(whole, 'write_text', full)
    with pytest.raises(BadInput, match='cannot write .*ratings.json: No space left on device'):
        desk.do({'act': 'rate', **GOOD})
    assert desk.view() == before and before['stage'] == 'rate'
    monkeypatch.setattr(whole, 'write_text', write_text)
    desk.do({'act': 'rate', **GOOD})
    assert desk.view()['stage'] != 'rate'
