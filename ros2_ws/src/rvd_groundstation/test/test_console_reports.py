"""The list of runs and their reports: what a row says, which address opens which report."""

import json
import os

import pytest
from test_console_server import House, run

from rvd_groundstation.console import reports, review
from rvd_groundstation.console.reports import MOST_TICKETS, Reports, TICKET_S

VERDICT = {'success': True, 'reason': 'docked', 'mode': 'manual', 'operator': 'console',
           'scenario': 'hand', 'seed': 12, 'duration_s': 119.5}
PAGE = '<!DOCTYPE html><title>docked</title>'


@pytest.fixture
def runs(tmp_path):
    """A folder of runs: one with a report, one without, and a report that is no run's."""
    folder = tmp_path / 'runs'
    for name, has_report in (('good', True), ('P01/03', True), ('bare', False)):
        (folder / name).mkdir(parents=True)
        (folder / name / 'verdict.json').write_text(json.dumps(VERDICT))
        if has_report:
            (folder / name / 'report.html').write_text(PAGE)
    (tmp_path / 'secret').mkdir()
    for name in ('report.html', 'verdict.json'):
        (tmp_path / 'secret' / name).write_text('{}')
    (folder / 'half').mkdir()
    (folder / 'half' / 'report.html').write_text(PAGE)          # no verdict: not finished
    return folder


def test_a_row_says_when_what_and_how_a_run_was_flown(runs):
    os.utime(runs / 'good' / 'verdict.json', (2e9, 2e9))
    rows = review.listing(runs)
    assert rows[0] == {'name': 'good', 'ended': 2e9, 'report': True, 'modes': {}, **VERDICT}
    assert {row['name']: row['report'] for row in rows} == {
        'good': True, 'P01/03': True, 'bare': False}


def test_a_verdict_that_is_written_anew_is_read_anew(runs):
    verdict = runs / 'good' / 'verdict.json'
    os.utime(verdict, (2e9, 2e9))
    assert review.listing(runs)[0]['reason'] == 'docked'
    verdict.write_text(json.dumps({**VERDICT, 'reason': 'missed', 'success': False}))
    os.utime(verdict, (2e9 + 1.0, 2e9 + 1.0))
    assert review.listing(runs)[0]['reason'] == 'missed'


@pytest.mark.parametrize('flown, modes', [
    ({'modes': {'manual': 0.125, 'auto': 0.875}}, {'manual': 0.125, 'auto': 0.875}),
    ({'modes': {'manual': 0.5, 'abort': 0.3, 'unknown': 0.2}, 'steps': 9}, {'manual': 0.5}),
    ({'modes': {'manual': 'mostly', 'auto': 0.5}}, {}), ({'steps': 9}, {}),
    ({'modes': ['manual']}, {}), ([], {}), (None, {})])
def test_a_row_says_what_a_run_was_really_flown_in(flown, modes, runs):
    verdict = runs / 'good' / 'verdict.json'
    verdict.write_text(json.dumps({**VERDICT, 'flown': flown}))
    os.utime(verdict, (2e9, 2e9))
    assert review.listing(runs)[0]['modes'] == modes


def test_a_verdict_that_has_not_changed_is_read_once(runs, monkeypatch):
    read = []
    monkeypatch.setattr(review, 'object_of',
                        lambda path, *_: read.append(path) or dict(VERDICT))
    assert len(review.listing(runs)) == len(review.listing(runs)) == 3
    assert len(read) == len(set(read)) <= 3


def test_a_ticket_opens_its_report_and_no_other_is_guessed(runs):
    made = Reports(runs)
    ticket = made.ticket('good', 0.0)
    assert len(ticket) >= 22                    # 128 bits
    assert made.ticket('good', 0.0) != ticket
    assert made.read(ticket, 1.0) == made.read(ticket, 2.0) == PAGE.encode()
    for guess in ('', 'good', ticket[:-1], ticket + 'A'):
        assert made.read(guess, 1.0) is None


def test_a_ticket_is_good_for_a_while(runs):
    made = Reports(runs)
    ticket = made.ticket('P01/03', 5.0)
    assert made.read(ticket, 5.0 + TICKET_S - 1.0)
    assert made.read(ticket, 5.0 + TICKET_S) is None
    assert made.read(ticket, 5.0) is None       # and stays closed


def test_of_too_many_tickets_the_oldest_goes(runs):
    made = Reports(runs)
    tickets = [made.ticket('good', 0.0) for _ in range(MOST_TICKETS + 1)]
    assert made.read(tickets[0], 1.0) is None
    assert made.read(tickets[1], 1.0) and made.read(tickets[-1], 1.0)


@pytest.mark.parametrize('name', [
    'bare', 'half', 'none', '..', '../secret', '/etc', 'good/../../secret', 'go\0od', '', '.'])
def test_what_is_no_report_of_a_finished_run_gets_no_ticket(runs, name):
    with pytest.raises(FileNotFoundError):
        Reports(runs).ticket(name, 0.0)


def test_a_report_that_points_out_of_the_runs_gets_no_ticket(runs):
    (runs / 'bare' / 'report.html').symlink_to(runs.parent / 'secret' / 'report.html')
    with pytest.raises(FileNotFoundError):
        Reports(runs).ticket('bare', 0.0)
    with pytest.raises(FileNotFoundError):
        Reports(None).ticket('good', 0.0)


def test_a_report_that_was_removed_meanwhile_is_none(runs):
    made = Reports(runs)
    ticket = made.ticket('good', 0.0)
    (runs / 'good' / 'report.html').unlink()
    assert made.read(ticket, 1.0) is None


def test_a_report_is_shown_by_its_ticket_alone_and_may_run_nothing(runs):
    async def work():
        async with House(runs) as house:
            bearer = {'Authorization': f'Bearer {house.server.access.token}'}

            async def get(path, headers=bearer):
                async with house.session.get(house.base + path, headers=headers) as answer:
                    return answer.status, answer.headers, await answer.text()
            assert (await get('/api/reports/good', {}))[0] == 403
            assert (await get('/api/reports/bare'))[0] == 404
            assert (await get('/api/reports/%2e%2e%2fsecret'))[0] == 404
            url = json.loads((await get('/api/reports/good'))[2])['url']
            assert house.server.access.token not in url
            status, headers, text = await get(f'/{url}', {})    # a tab shows no token
            assert (status, text) == (200, PAGE)
            assert headers['Content-Security-Policy'] == reports.POLICY
            assert "default-src 'none'" in reports.POLICY and 'sandbox' in reports.POLICY
            assert 'script' not in reports.POLICY
            assert headers['Cache-Control'] == 'no-store'
            assert (await get('/report/guessed', {}))[0] == 404
    run(work())


def test_a_run_under_way_has_no_report_yet(runs):
    async def work():
        async with House(runs) as house:
            house.hub.run_name = 'good'
            bearer = {'Authorization': f'Bearer {house.server.access.token}'}
            async with house.session.get(house.base + '/api/reports/good',
                                         headers=bearer) as answer:
                assert answer.status == 409
    run(work())
