"""
Who flies, in words: the page's one table, over every mode, decision and reason.

What can be decided is asked of the blender's own function, and what a sentence may say follows
from what was decided, not from the table.
"""

from itertools import product
import json
import re

from console_page import in_node, WEB
import numpy as np
import pytest
from runs import ROOT

from rvd_dynamics.commands import codes
from rvd_groundstation.operators.operation import MODES
from rvd_groundstation.sharing import decide, SHARING

MESSAGE = (ROOT / 'ros2_ws/src/rvd_interfaces/msg/ThrustCommand.msg').read_text()
BY = range(5)
REASON = range(13)
ALL_MODES = (*MODES, 'go', '')                  # a mission's own, and none
EQ25, FILTER = (SHARING[name]() for name in ('eq25', 'filter'))
PUSH, OTHER = np.array([1, 0, 0]), np.array([0, -2, 0])


@pytest.fixture(scope='module')
def table():
    """The page's words for every combination, by (mode, by, reason)."""
    asked = list(product(ALL_MODES, BY, REASON))
    told = in_node(
        "import { decided, sentence } from './decided.js';"
        f'const asked = {json.dumps(asked)};'
        'console.log(JSON.stringify(asked.map((one) => {'
        ' const found = decided(...one); return { ...found, words: sentence(found) }; })));')
    return dict(zip(asked, told))


def test_the_codes_are_those_of_the_message():
    named = [line.split() for line in MESSAGE.splitlines()]
    by = {int(w[3]) for w in named if w[1:2] and w[1].startswith('BY_')}
    reason = {int(w[3]) for w in named if w[1:2] and w[1].startswith('REASON_')}
    assert by == set(BY) and reason == set(REASON)


def test_every_combination_has_a_sentence_that_names_who_decided(table):
    assert len(table) == len(ALL_MODES) * len(BY) * len(REASON)
    for (mode, by, reason), said in table.items():
        where, who, words = (mode, by, reason), said['who'], said['words']
        assert who and words.startswith(who) and 'undefined' not in words, where
        if reason == codes.REASON_ABORT:
            assert 'ABORT' in words and said['alarm'] and not said['pilot'], where
            assert ('guard' in who) == (by == codes.BY_GUARD), where
            continue
        assert ('nobody' in who) == (by == codes.BY_NOBODY), where
        assert ('guard' in who) == (by == codes.BY_GUARD), where
        assert said['pilot'] == ('pilot' in who) == (by in (codes.BY_PILOT, codes.BY_BLEND)), where
        if by not in (codes.BY_AUTO, codes.BY_BLEND):
            assert 'automatic' not in who, where
        if 'alone' in who:
            assert by in (codes.BY_PILOT, codes.BY_AUTO), where


def test_no_sentence_gives_a_reason_that_denies_who_flies(table):
    for (mode, by, reason), said in table.items():
        if by in (codes.BY_PILOT, codes.BY_BLEND):
            assert 'no valid stick' not in said['words'], (mode, by, reason)
        if 'the automatic controller flies' in said['who']:
            assert 'no valid automatic command' not in said['words'], (mode, by, reason)


def test_as_the_mode_says_is_said_only_where_the_mode_says_so(table):
    says = {'manual': {codes.BY_PILOT}, 'auto': {codes.BY_AUTO}, 'shared': set()}
    for (mode, by, reason), said in table.items():
        if 'as the mode says' in said['words'] and mode in MODES:
            assert by in says[mode] | {codes.BY_NOBODY, codes.BY_GUARD}, (mode, by, reason)


def decisions():
    """Yield each (mode, sharing, pilot valid, automatic valid) with what is decided."""
    for mode, sharing, pilot, auto, same in product(
            MODES, (EQ25, FILTER), (True, False), (True, False), (True, False)):
        made = decide(mode, sharing, PUSH, pilot, PUSH if same else OTHER, auto)
        yield (mode, sharing, pilot, auto), (mode, int(made.decided_by), int(made.reason))


def test_what_the_blender_decides_is_told_as_it_was_decided(table):
    seen = set()
    for (mode, sharing, pilot, auto), key in decisions():
        said = table[key]
        seen.add(key)
        where = (mode, sharing, pilot, auto, said['words'])
        if mode == 'manual':
            assert said['who'] == ('the pilot flies alone' if pilot else 'nobody flies'), where
        elif mode == 'auto':
            assert said['who'] == (
                'the automatic controller flies alone' if auto else 'nobody flies'), where
        elif not pilot:
            assert said['who'] == (
                'the automatic controller flies alone' if auto else 'nobody flies'), where
        elif sharing is EQ25:
            assert said['who'] == ('the pilot and the automatic controller fly together' if auto
                                   else 'the pilot flies, blended with a neutral command'), where
        assert 'does not fit' not in said['words'] and 'before the mode' not in said['words'], where
    assert len(seen) >= 10


def test_in_manual_with_the_stick_lost_nobody_flies(table):
    made = decide('manual', EQ25, PUSH, False, OTHER, True)
    said = table['manual', int(made.decided_by), int(made.reason)]
    assert said['words'] == 'nobody flies: no valid stick' and said['alarm']


@pytest.mark.parametrize('modes, mode, by, link, said', [
    ([], 'auto', 1, True, 'the pilot flies'),           # a mission whose runs have no such mode
    (['auto', 'manual'], 'auto', 1, True, 'the pilot flies: decided before the mode was changed'),
    (['go', 'hold'], 'go', None, True, None),           # its commands do not tell who decided
    ([], 'auto', 0, False, None)])                      # watched on board: nothing is decided here
def test_a_frame_says_who_flies_by_what_it_tells_and_no_more(modes, mode, by, link, said):
    display = {'link': link, 'commands': {'sent': '/c'}, 'modes': [{'name': m} for m in modes]}
    frame = {'mode': mode, 'signals': {'/c': {'parts': {'by': by, 'reason': 0}}}}
    told = in_node("import { sentence, whoFlies } from './decided.js';"
                   f'const found = whoFlies({json.dumps(display)}, {json.dumps(frame)});'
                   'console.log(JSON.stringify(found && sentence(found)));')
    assert told == said


def test_no_other_source_of_the_page_says_who_flies():
    for file in [*(WEB / 'src').glob('*.js'), WEB / 'index.html']:
        if file.name != 'decided.js':
            code = re.sub(r'//.*', '', file.read_text())
            assert not re.search(r'alone flies|flies alone|nobody flies', code), file.name
