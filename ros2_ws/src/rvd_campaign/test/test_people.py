"""The report of a session: only what counts, counted by hand."""

import csv
import json

import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_campaign.report import people_figures
from rvd_campaign.report.people import conditions, pairs, read_flights, write_session_report


def flight(folder, who, number, condition, success, *, training=False, seed=1, offset=0.1,
           rating=3, tlx=40.0, rated=True):
    run = folder / who / f'{number:02d}-{condition}'
    run.mkdir(parents=True)
    (run / 'verdict.json').write_text(json.dumps({
        'success': success, 'reason': 'docked' if success else 'left_corridor',
        'duration_s': 120.0, 'measures': {
            'offset_m': {'value': offset, 'unit': 'm', 'limit': 0.3, 'ok': offset < 0.3},
            'delta_v_m_s': {'value': 0.2, 'unit': 'm/s', 'limit': None, 'ok': True},
            'exit_time_s': {'value': None, 'unit': 's', 'limit': None, 'ok': True},
            'of_tomorrow': {'value': 7.0, 'unit': '', 'limit': None, 'ok': True}}}))
    if rated:
        (run / 'ratings.json').write_text(json.dumps({
            'volunteer': who, 'number': number, 'condition': condition, 'mode': condition,
            'training': training, 'seed': seed, 'cooper_harper': {'rating': rating},
            'tlx': {'mean': tlx}}))


@pytest.fixture
def session(tmp_path):
    (tmp_path / 'session.json').write_text(json.dumps(
        {'title': 'A <session>', 'conditions': {'manual': 'manual', 'shared': 'shared'}}))
    flight(tmp_path, 'P01', 1, 'manual', True, training=True, offset=9.0)
    flight(tmp_path, 'P01', 2, 'manual', True, seed=1, offset=0.1, rating=4, tlx=50.0)
    flight(tmp_path, 'P01', 3, 'manual', False, seed=2, offset=0.9, rating=8, tlx=70.0)
    flight(tmp_path, 'P01', 4, 'shared', True, seed=1, offset=0.2)
    flight(tmp_path, 'P01', 5, 'shared', True, seed=2, offset=0.1)
    flight(tmp_path, 'P02', 1, 'manual', True, seed=1, rated=False)
    return tmp_path


def test_training_and_unrated_flights_do_not_count(session):
    flights, left_out = read_flights(session)
    assert len(flights) == 5 and left_out == 1
    manual, shared = conditions(flights, ['manual', 'shared'])
    assert (manual.flights, manual.successes) == (2, 1)
    assert (shared.flights, shared.successes) == (2, 2)


def test_means_are_over_successes_as_in_the_paper(session):
    manual, shared = conditions(read_flights(session)[0], ['manual', 'shared'])
    assert manual.means == pytest.approx(
        {'offset_m': 0.1, 'delta_v_m_s': 0.2, 'of_tomorrow': 7.0})
    assert shared.means['offset_m'] == pytest.approx(0.15)
    assert manual.cooper_harper == (6, 4, 8)
    assert manual.tlx == (60.0, pytest.approx(200.0 ** 0.5))


def break_into(session, run, why):
    """Let a flight have no rating but a reason, as the desk leaves one that does not count."""
    file = session / run / 'ratings.json'
    file.write_text(json.dumps({**json.loads(file.read_text()), 'counted': False, 'why': why,
                                'cooper_harper': None, 'tlx': None}))


def test_a_flight_whose_condition_was_broken_is_left_out_and_named(session):
    before = conditions(read_flights(session)[0], ['manual'])[0]
    break_into(session, 'P01/03-manual', 'the mode was changed: 88 % of the steps in mode auto')
    flights, left_out = read_flights(session)
    assert len(flights) == 4 and left_out == 1
    manual = conditions(flights, ['manual'])[0]
    assert (before.flights, before.successes) == (2, 1) and (manual.flights, manual.successes) == (
        1, 1)
    page = ' '.join(write_session_report(session).read_text().split())
    assert '<td>P01</td><td>3</td><td>manual control</td><td>the mode was changed: 88 %' in page
    assert '1 not counted' in page
    with (session / 'flights.csv').open() as file:
        rows = {row['number']: row for row in csv.DictReader(file)}
    assert [rows[n]['counted'] for n in '12345'] == ['False', 'True', 'False', 'True', 'True']
    assert rows['3']['why'].startswith('the mode') and rows['3']['cooper_harper'] == ''
    assert rows['3']['offset_m'] == '0.9' and rows['2']['why'] == ''


def test_a_session_in_which_all_counts_says_nothing_of_the_rest(session):
    page = write_session_report(session).read_text()
    assert '<h2>Not counted</h2>' not in page and '0 not counted' in page


def test_workload_is_weighted_where_the_pairs_were_asked(session):
    scales = {'mental': 80, 'physical': 20, 'temporal': 0, 'performance': 0, 'effort': 50,
              'frustration': 0}
    for file in session.glob('P01/*-shared/ratings.json'):
        made = json.loads(file.read_text())
        file.write_text(json.dumps({**made, 'tlx': {**scales, 'mean': 25.0}}))
    (session / 'P01' / 'tlx_weights.json').write_text(json.dumps({'shared': {
        'mental': 5, 'physical': 3, 'temporal': 1, 'performance': 2, 'effort': 4,
        'frustration': 0}}))
    manual, shared = conditions(read_flights(session)[0], ['manual', 'shared'])
    assert manual.tlx_weighted is None
    assert shared.tlx_weighted == (pytest.approx((5*80 + 3*20 + 4*50) / 15), 0.0)
    assert '44.0 ± 0.0' in write_session_report(session).read_text()


def test_flights_are_paired_by_volunteer_and_seed(session):
    assert pairs(read_flights(session)[0], 'manual', 'shared') == (1, 0, 1, 0)


def test_the_report_and_every_flight_are_written(session):
    page = write_session_report(session).read_text()
    assert 'A &lt;session&gt;' in page and 'only shared control 1' in page.replace('\n', ' ')
    with (session / 'flights.csv').open() as file:
        rows = list(csv.DictReader(file))
    assert [row['number'] for row in rows] == ['1', '2', '3', '4', '5']
    assert list(rows[0])[8:13] == ['duration_s', 'offset_m', 'delta_v_m_s', 'exit_time_s',
                                   'of_tomorrow']
    assert [row['offset_m'] for row in rows] == ['9.0', '0.1', '0.9', '0.2', '0.1']
    assert rows[0]['exit_time_s'] == ''


def test_the_table_has_a_column_for_each_measure_that_is_known(session):
    page = write_session_report(session).read_text()
    for head in ('lateral offset at docking<br>m<', 'delta-v<br>m/s<', 'of_tomorrow<'):
        assert f'<th>{head}/th>' in page
    assert 'left the corridor' not in page and '<td>0.1500</td>' in page


def test_a_note_of_the_session_is_printed(session):
    file = session / 'session.json'
    file.write_text(json.dumps({**json.loads(file.read_text()), 'note': 'As <known>.'}))
    assert '<p>As &lt;known&gt;.</p>' in write_session_report(session).read_text()


def test_flights_of_a_version_without_measures_are_still_reported(session):
    for file in session.glob('P*/*/verdict.json'):
        old = json.loads(file.read_text())
        del old['measures']
        file.write_text(json.dumps({**old, 'terminal': {'offset_m': 0.1}}))
    assert '<td>manual control</td><td>2</td>' in write_session_report(session).read_text()


def test_conditions_are_named_in_words_and_figures_come_before_the_table(session):
    file = session / 'session.json'
    file.write_text(json.dumps({'title': 't', 'conditions': {
        'manual': 'manual', 'shared': 'shared', 'late_auto': 'auto', 'automatic': 'auto'}}))
    flight(session, 'P03', 1, 'late_auto', True)
    flight(session, 'P03', 2, 'automatic', True)
    page = write_session_report(session).read_text()
    for words in ('manual control', 'shared control', 'late auto (automatic control)',
                  'automatic control'):
        assert f'<td>{words}</td>' in page and f'{words} <b>' in page
    assert 'late_auto' not in page
    for title in ('Success', 'Ratings', 'Learning'):
        assert page.index(f'<h2>{title}</h2>') < page.index('<table')


def test_of_one_volunteer_no_interval_is_claimed_and_of_two_a_wide_one(session):
    alone, _ = conditions(read_flights(session)[0], ['manual', 'shared'])
    assert alone.interval is None
    flight(session, 'P03', 1, 'manual', True)
    flight(session, 'P03', 2, 'manual', True)
    two, _ = conditions(read_flights(session)[0], ['manual', 'shared'])
    assert two.interval.low < 0.05 and two.interval.high > 0.95


def points(figure, panel, marker):
    return [(line.get_xdata()[0], line.get_ydata()[0]) for line in figure.axes[panel].lines
            if line.get_marker() == marker and len(line.get_xdata()) == 1]


def test_the_figure_of_success_has_each_condition_and_each_volunteer(session):
    flight(session, 'P03', 1, 'manual', False)
    flights, _ = read_flights(session)
    figure = people_figures.success(flights, {'manual': 'by hand', 'shared': 'together'})
    rows = [label.get_text() for label in figure.axes[0].get_yticklabels()]
    assert rows == ['by hand', 'P01', 'P03', 'together', 'P01']
    assert points(figure, 0, 'o') == [(pytest.approx(1/3), 0.0), (0.5, 1.0), (0.0, 2.0)]
    assert [x for x, _ in points(figure, 0, 's')] == [1.0, 1.0]
    low = [line.get_xdata() for line in figure.axes[0].lines if line.get_linewidth() == 3.0]
    assert len(low) == 1                        # over volunteers: of `manual` alone, which has two


def test_the_learning_curve_goes_by_the_number_of_the_flight(session):
    flights, _ = read_flights(session)
    figure = people_figures.learning(flights, {'manual': 'by hand', 'shared': 'together'})
    above, below = figure.axes
    curves = {line.get_label(): line for line in above.lines if len(line.get_xdata()) > 1}
    assert list(curves['by hand'].get_ydata()) == [1.0, 1.0, 0.0]         # 1 is training
    assert curves['together'].get_xdata().round().tolist() == [4, 5]
    hollow = [line for line in above.lines if line.get_markerfacecolor() == 'none'
              and len(line.get_xdata()) == 1]
    assert [round(line.get_xdata()[0]) for line in hollow] == [1]
    assert list(below.lines[0].get_ydata()) == [40.0, 50.0, 70.0]


def test_ratings_are_drawn_by_volunteer_and_condition(session):
    flights, _ = read_flights(session)
    figure = people_figures.ratings(flights, {'manual': 'by hand', 'shared': 'together'})
    assert [x for x, _ in points(figure, 0, 'D')] == [6.0, 3.0]
    assert [x for x, _ in points(figure, 1, 'D')] == [60.0, 40.0]
    assert not [line for line in figure.axes[1].lines if line.get_linewidth() == 3.0]


def test_a_session_without_a_rated_flight_is_refused(tmp_path):
    (tmp_path / 'session.json').write_text('{"title": "t", "conditions": {}}')
    with pytest.raises(ValueError, match='no rated flight'):
        write_session_report(tmp_path)


def test_a_mission_that_is_not_installed_has_its_numbers_without_words(session):
    for file in session.glob('P*/*/verdict.json'):
        file.write_text(json.dumps({**json.loads(file.read_text()), 'mission': 'of_tomorrow'}))
    page = write_session_report(session).read_text()
    assert '<th>offset_m</th>' in page and '<td>0.1500</td>' in page


@pytest.mark.parametrize('name', ['session.json', 'P01/*/verdict.json', 'P01/*/ratings.json'])
@pytest.mark.parametrize('text', ['', '{"a', '[]', '{}', '\x00'])
def test_a_damaged_file_is_refused_by_its_name(session, name, text):
    file = next(session.glob(name))
    file.write_text(text)
    with pytest.raises(BadInput, match=f'{file.parent.name}.*damaged'):
        write_session_report(session)
