"""Every kind of report on a phone: nothing runs out sideways, and figures have their text."""

import io
import json

import pytest
from console_page import chromium, playwright

from rvd_campaign.campaign import report as campaign_report
from rvd_campaign.campaign.engine import fly_campaign, start, Workers
from rvd_campaign.campaign.progress import Progress
from rvd_campaign.campaign.spec import parse_campaign
from rvd_campaign.campaign.summary import finish, SUMMARY
from rvd_campaign.report import run as run_report
from rvd_campaign.report.page import Drawn, render
from rvd_campaign.report.people import write_session_report
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.recording.drawing import svg
from rvd_dynamics.recording.history import everything, of_history
from rvd_missions.elliptic_rendezvous import cycle_figures
from rvd_missions.elliptic_rendezvous.gains import CycleCase

pytestmark = [pytest.mark.slow, pytest.mark.patient]

PHONE = {'width': 390, 'height': 844}
FLIGHTS = {                             # mission: short, but with all its figures
    'lunar_approach': 'timeout_s: 60.0', 'obstacle_field': 'timeout_s: 60.0',
    'docking': 'timeout_s: 10.0, limits: {from_s: 5.0}', 'elliptic_rendezvous': 'timeout_s: 600.0',
    'attitude_hold': 'timeout_s: 60.0', 'tether': '', 'tether_delay': ''}
CAMPAIGN = """
seed: 2
runs: 12
conditions:
  corridor_apf with a pilot that is named at great length: {/**: {mode: shared}}
  manual: {/**: {mode: manual}}
grid: {loop_delay_s: [4, 6, 8, 9, 10]}
compare: [['manual,loop_delay_s=10', 'manual,loop_delay_s=4']]
figures: [success, curve, landing, tracks, failures, comparison]
"""


def flight(mission, settings):
    """Return the report of a run of a mission."""
    scenario = parse(f'/**: {{ros__parameters: {{mission: {mission}, {settings}}}}}', 'short')
    return run_report.page(of_history(scenario, fly(scenario, [0], record=everything(scenario))))


def campaign(folder):
    folder.mkdir()
    asked = parse_campaign(CAMPAIGN, 'on a phone')
    start(asked, folder)
    fly_campaign(asked, folder, Workers(), Progress(io.StringIO()))
    (folder / SUMMARY).write_text(json.dumps(finish(asked, folder)))
    return campaign_report.page(campaign_report.read(folder))


def people(folder):
    """Return the report of a session of two volunteers."""
    conditions = {'manual': 'manual', 'shared': 'shared', 'with_a_longer_name': 'auto'}
    measures = {name: {'value': 0.1, 'unit': 'm', 'limit': None, 'ok': True}
                for name in ('offset_m', 'delta_v_m_s', 'min_corridor_margin_m', 'x_rate_m_s')}
    for who in ('P01', 'P02'):
        for number in range(1, 10):
            name = list(conditions)[number % 3]
            run = folder / who / f'{number:02d}-{name}'
            run.mkdir(parents=True)
            (run / 'verdict.json').write_text(json.dumps({
                'success': (number + (who == 'P02')) % 4 > 0, 'reason': 'docked',
                'duration_s': 120.0, 'measures': measures}))
            (run / 'ratings.json').write_text(json.dumps({
                'volunteer': who, 'number': number, 'condition': name, 'mode': conditions[name],
                'training': number < 4, 'seed': 1, 'cooper_harper': {'rating': number},
                'tlx': {'mean': 10.0 * number - 15.0 * (who == 'P02')}}))
    (folder / 'session.json').write_text(json.dumps({'title': 'Two', 'conditions': conditions}))
    return write_session_report(folder).read_text()


def cycles():
    """Return the page of the limit cycles, of one figure and a table of its width."""
    found = cycle_figures.cycles(CycleCase())
    row = ['0.05', *['-179.99 .. 179.99 (0.1234)'] * 6]
    return render(
        'cycles.html.j2', title='Limit cycles of range-rate control', gains='k = -0.1',
        heads=['e', *[f'form {i}' for i in range(6)]], rows=[row] * 5, events=['followed'],
        figures=[Drawn('Limit cycles', svg('cycles', lambda: cycle_figures.portraits(found)), '')])


@pytest.fixture(scope='module')
def pages(tmp_path_factory):
    """Every kind of report as a file, by a name."""
    folder = tmp_path_factory.mktemp('reports')
    made = {f'flight of {mission}': flight(mission, settings)
            for mission, settings in FLIGHTS.items()}
    made |= {'campaign': campaign(folder / 'campaign'), 'people': people(folder / 'people'),
             'limit cycles': cycles()}
    files = {name: folder / f'{name}.html' for name in made}
    for name, file in files.items():
        file.write_text(made[name])
    return files


@pytest.fixture(scope='module')
def phone():
    with playwright()() as engine:
        browser = engine.chromium.launch(executable_path=chromium(), args=['--no-sandbox'])
        yield browser.new_page(viewport=PHONE, device_scale_factor=2)
        browser.close()


WIDER = 'document.documentElement.scrollWidth - innerWidth'
CUT = """[...document.querySelectorAll('body *')].filter((e) => !e.closest('.scroll, pre, svg') &&
    e.getBoundingClientRect().right > innerWidth + 0.5).map((e) => e.outerHTML.slice(0, 80))"""


SMALLEST = """Math.min(...[...document.querySelectorAll('svg text')].map((e) => {
    const to = e.getScreenCTM();
    return parseFloat(getComputedStyle(e).fontSize) * Math.hypot(to.a, to.b);
}))"""


def test_no_report_runs_out_sideways_on_a_phone(pages, phone):
    for name, file in pages.items():
        phone.goto(file.as_uri())
        for details in phone.query_selector_all('details'):
            details.evaluate('(e) => { e.open = true; }')
        assert phone.evaluate(WIDER) <= 0, name
        assert phone.evaluate(CUT) == [], name


def test_that_is_so_because_what_is_wide_scrolls_by_itself(pages, phone):
    for name, file in pages.items():
        phone.goto(file.as_uri())
        assert phone.evaluate("""[...document.querySelectorAll('.scroll')].some((e) =>
            e.scrollWidth > e.clientWidth && e.tabIndex === 0)"""), name
        phone.add_style_tag(content='.scroll{overflow:visible!important}')
        assert phone.evaluate(WIDER) > 0, name


def test_every_figure_can_be_read_and_has_its_text(pages, phone):
    for name, file in pages.items():
        phone.goto(file.as_uri())
        texts = phone.evaluate(
            "[...document.querySelectorAll('svg')].map((e) => e.getAttribute('aria-label'))")
        assert texts and all(text and len(text) > 20 for text in texts), name
        for text in texts:
            assert phone.get_by_role('img', name=text, exact=True).count() >= 1, (name, text)
        least = phone.evaluate(SMALLEST)
        assert least > 5.0, (name, least)       # [px] of CSS; 6 pt is the least that is drawn
