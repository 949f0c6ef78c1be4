"""A volunteer's session end to end: the desk in the page, flights, ratings, the report."""

import json

import pytest
from console_page import Console, open_page, serious, until
from runs import rvd

pytestmark = pytest.mark.slow
SESSION = """
title: A short session
seed: 3
conditions: {shared: {mode: shared}, automatic: {mode: auto}}
training: 0
flights: 1
break_after: 1
break_s: 0
tlx: weighted
"""


def rate(page, look) -> None:
    """
    Answer the tree of Cooper and Harper, set the scales of NASA-TLX and choose in its pairs.

    `look` is called at each kind of dialog.
    """
    look()
    for answer in ('yes', 'yes', 'no'):
        page.wait_for_selector(f'[data-answer={answer}]')
        page.click(f'[data-answer={answer}]')
    look()
    page.click('[data-rating="5"]')
    page.wait_for_selector('[data-tlx]')
    look()
    assert len(page.query_selector_all('.unset')) == 6 and page.is_disabled('#desk-go')
    for scale in page.query_selector_all('[data-tlx]'):
        scale.focus()
        page.keyboard.press('ArrowRight')
    page.click('#desk-go')
    for pair in range(1, 16):
        until(page, f"document.querySelector('#dialog h3').textContent.includes('{pair} of 15')")
        if pair == 1:
            look()
        page.keyboard.press('Enter')            # the first of the two has the focus
    until(page, "document.querySelector('[data-pair]') !== null")
    look()
    assert len(page.query_selector_all('[data-pair]')) == 15
    page.click('[data-pair="6"]')               # one of them is changed, the others stay
    until(page, "document.querySelector('#dialog h3').textContent.includes('7 of 15')")
    page.click('[data-scale][aria-pressed=false]')
    page.click('#desk-go')


def test_a_volunteer_is_led_through_a_session_and_the_report_counts_it(
        browser, tmp_path, console_web):
    (tmp_path / 'session.yaml').write_text(SESSION)
    console = Console(tmp_path, 'barrier', '--pace', '20', '--session', 'session.yaml',
                      '--out', 'people')
    try:
        page = open_page(browser, console, look='plain', bypass_csp=True)     # for axe

        def look():
            assert serious(page, console_web) == []
        page.keyboard.press('t')
        page.wait_for_selector('#volunteer')
        look()
        page.fill('#volunteer', '7')
        page.keyboard.press('Enter')
        for flight in (1, 2):
            heading = "document.querySelector('#dialog h3').textContent"
            until(page, f"{heading}.includes('{flight} of 2')")
            page.click('#desk-go')
            page.wait_for_selector('[data-answer=yes]', timeout=120_000)
            rate(page, look)
            if flight == 1:
                until(page, "document.querySelector('#rest-left') !== null")
                page.click('#desk-go')
        until(page, "document.querySelector('#dialog').textContent.includes('Thank you')")
        assert page.problems == []
    finally:
        console.close()
    ratings = sorted((tmp_path / 'people').glob('P07/*/ratings.json'))
    assert len(ratings) == 2
    made = [json.loads(file.read_text()) for file in ratings]
    assert {m['condition'] for m in made} == {'shared', 'automatic'}
    assert {m['seed'] for m in made} == {7003}          # paired: the same start in both
    assert made[0]['cooper_harper']['rating'] == 5 and made[0]['tlx']['mean'] == 55
    done = rvd('report', 'people', cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    weights = json.loads((tmp_path / 'people' / 'P07' / 'tlx_weights.json').read_text())
    assert {sum(w.values()) for w in weights.values()} == {15} and len(weights) == 2
    page = (tmp_path / 'people' / 'report.html').read_text()
    assert 'NASA-TLX, weighted' in page
    assert '1 volunteer, 2 rated' in page.replace('\n', ' ')
