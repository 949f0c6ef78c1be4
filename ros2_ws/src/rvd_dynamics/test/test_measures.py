"""A toy judge with two measures: what it declares reaches words, files, tables and messages."""

import json

import numpy as np
import pytest

from rvd_dynamics.diagram.judge import (
    as_dict, bare_name, for_page, from_message, in_words, Judgement, judgement, Measure,
    table_columns, Verdict)
from rvd_dynamics.diagram.ros.conversions import header_at, verdict_to_msg


class Toy:
    """Judges the last of some numbers: it must lie between 1 and 2; their sum is shown."""

    measures = (Measure('end_km', 'km', 'where it ended', 1.0, 2.0, digits=1),
                Measure('sum_km2', 'km^2', 'sum of all', digits=2))
    reasons = {'there': 'came where it should', 'lost': 'came elsewhere'}

    def __init__(self, batch=()):
        self._batch, self._sum, self._end = batch, np.zeros(batch), np.full(batch, np.nan)
        self._k = 0

    @property
    def ended(self):
        return np.full(self._batch, self._k >= 3)

    def start(self, x):
        self.advance(0, x)

    def advance(self, step, x):
        self._k, self._sum = step, self._sum + x
        if step >= 3:
            self._end = np.asarray(x, dtype=float)

    def verdict(self, final=False):
        good = self.measures[0].ok(self._end)
        reason = np.where(np.isnan(self._end), '', np.where(good, 'there', 'lost'))
        return Verdict(good, reason, np.full(self._batch, 0.5*self._k),
                       {'end_km': self._end, 'sum_km2': self._sum})


def judged(*numbers):
    judge = Toy()
    judge.start(numbers[0])
    for step, x in enumerate(numbers[1:], start=1):
        judge.advance(step, x)
    return judgement(judge, judge.verdict())


def test_the_verdict_as_a_file_keeps_it():
    assert as_dict(judged(0.0, 0.5, 1.0, 1.5)) == {
        'success': True, 'reason': 'there', 'duration_s': 1.5, 'measures': {
            'end_km': {'value': 1.5, 'unit': 'km', 'limit': 2.0, 'ok': True},
            'sum_km2': {'value': 3.0, 'unit': 'km^2', 'limit': None, 'ok': True}}}


def test_what_is_unknown_is_none_in_a_file_and_not_ok_where_there_is_a_limit():
    made = as_dict(judged(0.0, 0.5))
    json.dumps(made, allow_nan=False)
    assert made['reason'] == '' and made['measures']['end_km'] == {
        'value': None, 'unit': 'km', 'limit': 2.0, 'ok': False}


def test_the_verdict_in_words():
    assert in_words(judged(0.0, 0.5, 1.0, 1.5)).splitlines() == [
        'came where it should after 1.5 s',
        '  where it ended  1.5 km     (between 1 and 2 km)',
        '  sum of all      3.00 km^2']
    assert in_words(judged(0.0, 0.0, 0.0, 2.0)).splitlines()[:2] == [
        'failed: came elsewhere; the run ended after 1.5 s',
        '  where it ended  2.0 km     (NOT between 1 and 2 km)']
    assert 'where it ended' not in in_words(judged(0.0, 0.5))


@pytest.mark.parametrize('happened, said', [
    (1.25, 'failed: came elsewhere at 1.2 s; the run ended after 9.0 s'),
    (np.nan, 'failed: came elsewhere; the run ended after 9.0 s'),
    (None, 'failed: came elsewhere; the run ended after 9.0 s')])
def test_the_headline_gives_the_time_of_what_it_names_and_not_that_of_the_end(happened, said):
    values = {'end_km': np.full(2, 3.0), 'sum_km2': np.zeros(2)}
    both = None if happened is None else np.array([happened, np.nan])
    made = Verdict(np.zeros(2, bool), np.array(['lost']*2), np.full(2, 9.0), values, both)
    assert judgement(Toy(), made, 0).headline == said
    assert judgement(Toy(), made, 1).words == 'came elsewhere'
    assert 'happened' not in table_columns(made)
    under_way = made._replace(reason=np.array(['', '']))
    assert judgement(Toy(), under_way, 0).words == ''


def test_a_flight_without_any_time_has_none_in_its_headline():
    assert Judgement(False, 'x', 'given up', np.nan, ()).headline == 'failed: given up'


def test_there_and_back_through_a_message_nothing_changes():
    for sent in (judged(0.0, 0.5, 1.0, 1.5), judged(0.0, 0.5)):
        message = verdict_to_msg(header_at(0, 'f'), 3, True, sent)
        assert repr(from_message(message)) == repr(sent)        # NaN too
        assert message.step == 3 and message.final


def test_a_verdict_of_a_version_without_measures_is_read():
    old = type('Old', (), {'success': False, 'reason': 'lost', 'duration': 2.0})()
    assert from_message(old) == (False, 'lost', 'lost', 2.0, ())


def test_the_page_is_sent_names_words_limits_and_digits():
    sent = for_page(judged(0.0, 0.5, 1.0, 1.5))
    assert list(sent) == ['success', 'reason', 'words', 'duration', 'measures']
    assert sent['words'] == 'came where it should'
    assert sent['measures'][0] == {
        'name': 'end_km', 'words': 'where it ended', 'unit': 'km', 'value': 1.5, 'low': 1.0,
        'high': 2.0, 'ok': True, 'digits': 1}


def test_a_batch_gives_columns_and_each_of_its_rows():
    judge = Toy((3,))
    for step in range(4):
        x = np.array([1.0, 1.5, 2.5])
        judge.start(x) if step == 0 else judge.advance(step, x)
    columns = table_columns(judge.verdict())
    assert list(columns) == ['success', 'reason', 'duration_s', 'end_km', 'sum_km2']
    assert columns['success'].tolist() == [False, True, False]
    row = judgement(judge, judge.verdict(), 1)
    assert (row.success, row.words, row.value('sum_km2')) == (True, 'came where it should', 6.0)
    assert np.isnan(row.value('of_another_judge'))


@pytest.mark.parametrize('low, high, good, bad', [
    (np.nan, np.nan, [0.0, -np.inf, np.nan], []), (0.0, np.nan, [1e-9], [0.0, np.nan]),
    (np.nan, 0.3, [-1.0, 0.2999], [0.3, np.nan]), (0.0, 0.3, [0.1], [0.0, 0.3, -1.0, np.nan])])
def test_a_good_value_lies_strictly_between_the_limits(low, high, good, bad):
    measure = Measure('x_m', 'm', 'x', low, high)
    assert measure.ok(good).all() and not measure.ok(bad).any()


@pytest.mark.parametrize('name, unit, low, high, words', [
    ('speed', 'm/s', 0.0, 1.0, "must be a plain word that ends in its unit, '_m_s'"),
    ('top speed_m_s', 'm/s', 0.0, 1.0, 'must be a plain word'),
    ('speed_m_s', 'm/s', 1.0, 1.0, 'no value lies between the limits 1 and 1')])
def test_a_measure_that_cannot_be_is_refused(name, unit, low, high, words):
    with pytest.raises(ValueError, match=words):
        Measure(name, unit, 'x', low, high)


def test_a_name_without_its_unit():
    assert bare_name('min_corridor_margin_m', 'm') == 'min corridor margin'
    assert bare_name('peak_acceleration_m_s2', 'm/s^2') == 'peak acceleration'
    assert bare_name('count', '') == 'count'
