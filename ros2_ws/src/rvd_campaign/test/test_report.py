"""The report: self-contained, true to the bag, plain about what is missing."""

from dataclasses import replace
from html.parser import HTMLParser
import re

import numpy as np
import pytest
import small_run
from small_run import LAST, write_run
from std_msgs.msg import String

from rvd_campaign.report.figures import figures_of
from rvd_campaign.report.run import page, write_report
from rvd_dynamics.commands import codes
from rvd_dynamics.recording.reader import read


@pytest.fixture(scope='module')
def run(tmp_path_factory):
    return write_run(tmp_path_factory.mktemp('runs') / 'whole')


@pytest.fixture(scope='module')
def recording(run):
    return read(run)


@pytest.fixture(scope='module')
def html(recording):
    return page(recording)


class Reader(HTMLParser):
    """Collects the text, the tags and every attribute that could make a request."""

    VOID = {'meta', 'br', 'img', 'use', 'path', 'rect'}

    def __init__(self, html: str) -> None:
        super().__init__()
        self.words, self.tags, self.links, self.open = [], [], [], []
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        if tag not in self.VOID:
            self.open.append(tag)
        self.links += [v for k, v in attrs if k in ('src', 'href', 'xlink:href', 'data')]

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in self.VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        if tag not in self.VOID:
            assert self.open.pop() == tag

    def handle_data(self, data):
        self.words.append(data)

    @property
    def text(self) -> str:
        return ' '.join(' '.join(self.words).split())


def test_page_is_whole_and_asks_for_nothing_from_anywhere(html):
    reader = Reader(html)
    assert reader.open == []
    assert all(link.startswith('#') for link in reader.links)
    assert not {'script', 'link', 'img', 'iframe', 'object'} & set(reader.tags)
    assert 'url(http' not in html and '@import' not in html and 'src=' not in html


def test_ids_are_unique_and_every_reference_has_its_target(html):
    ids = re.findall(r'\bid="([^"]+)"', html)
    assert len(ids) == len(set(ids))
    used = set(re.findall(r'(?:url\(#|href="#)([^)"]+)', html))
    assert used <= set(ids)


def test_page_says_verdict_limits_counts_and_scenario(html):
    text = Reader(html).text
    for fact in ('Docked after 60.0 s', 'scenario small', 'seed 7', '0.188 m', '0.2500 m/s',
                 'between 0 and 0.3 m/s', '0.1118 m', 'below 0.3 m', 'above 0 m',
                 f'{LAST + 1} = {LAST + 1} \u2713',
                 'pilot and automatic 121 100 %', 'guard: 1 for checksum',
                 '27.5 onboard_guard REFUSED', 'half_angle_deg: 3.0'):
        assert fact in text, fact
    assert 'class="warning"' not in html


def test_steps_of_an_abort_are_nobodys_decision(recording):
    sent = recording.of('/ground/command')
    aborted = replace(sent, reason=np.where(np.arange(len(sent.step)) < 40, sent.reason,
                                            codes.REASON_ABORT))
    series = {**recording.series, '/ground/command': aborted}
    text = Reader(page(replace(recording, series=series))).text
    assert 'pilot and automatic 40 ' in text
    assert f'the ABORT in force {len(sent.step) - 40} ' in text


def test_each_measure_has_its_row_unless_it_is_unknown_and_without_limit(html):
    table = re.search(r'<h2>Verdict</h2>\s*<div[^>]*>\s*(<table.*?</table>)', html, re.S)[1]
    names = re.findall(r'<tr><td>(.*?)</td>', table)
    assert names == ['closing rate at docking', 'lateral offset at docking',
                     'least corridor margin', 'delta-v']
    assert table.count('\u2713') == 3 and '\u2717' not in table
    assert re.findall(r'width:(\d+)%', table) == ['83', '37']


def test_a_bag_of_a_version_without_measures_still_has_its_verdict(recording):
    old = replace(recording, verdict=recording.verdict._replace(measures=(), words='docked'))
    text = Reader(page(old)).text
    assert 'Docked after 60.0 s' in text and 'has no measures' in text
    assert '60.00 s from the start to the end' in text


def test_text_from_the_bag_is_never_markup(html):
    assert '<script>alert' not in html and '&lt;script&gt;alert(1)' in html
    assert '<b>does not match</b>' not in html


def test_page_works_on_light_dark_and_paper(html):
    assert 'prefers-color-scheme:dark' in html and '@media print' in html
    names = set(re.findall(r'var\(--([a-z]+)\)', html))
    light = re.search(r':root\{color-scheme(.*?)\}', html, re.S)[1]
    dark = re.search(r'dark\)\{:root\{(.*?)\}\}', html, re.S)[1]
    for name in names:
        assert f'--{name}:' in light
        assert f'--{name}:' in dark or name == 'font'


def test_the_figures_are_those_of_the_mission_with_their_captions(recording, html):
    figures = figures_of(recording)
    assert list(figures) == ['approach', 'margin', 'levels', 'prediction', 'consistency',
                             'links']
    text = Reader(html).text
    assert html.count('<svg') == len(figures)
    for figure in figures.values():
        assert figure.title in text and ' '.join(figure.caption.split()) in text


def of_a_mission(recording, **changes):
    """Return the recording as if its mission were another."""
    mission = replace(recording.scenario.mission, **changes)
    return replace(recording, scenario=replace(recording.scenario, mission=mission))


def test_a_mission_without_figures_has_all_the_rest(recording):
    html = page(of_a_mission(recording, figures=''))
    text = Reader(html).text
    assert html.count('<svg') == 1 and 'Link delays' in text        # of every mission
    for fact in ('Docked after 60.0 s', 'mission lunar approach', '0.188 m', 'Link counts',
                 f'{LAST + 1} = {LAST + 1} \u2713', 'onboard_guard REFUSED', 'half_angle_deg: 3.0'):
        assert fact in text, fact


@pytest.mark.parametrize('table, why', [
    ('nowhere:FIGURES', "figures: nowhere:FIGURES cannot be loaded: No module named 'nowhere'"),
    ('rvd_missions.lunar_approach.figures:PLOTS', 'has no PLOTS'),
    ('rvd_missions.lunar_approach.figures:AXES', 'must be a dict of Figure by plain names')])
def test_a_table_of_figures_that_cannot_be_loaded_is_one_line(recording, table, why):
    with pytest.raises(ValueError, match=why):
        page(of_a_mission(recording, figures=table))


def test_a_bag_of_a_mission_that_is_not_installed_has_its_verdict_and_says_why_no_figures(tmp_path):
    text = small_run.SCENARIO.replace('mode: shared', 'mission: of_tomorrow')
    given = [('/run/scenario', 0, String(data=text)), *small_run.messages()[1:]]
    html = write_report(write_run(tmp_path, given)).read_text()
    text = Reader(html).text
    assert '<svg' not in html
    for fact in ('Docked after 60.0 s', 'scenario small', "no mission 'of_tomorrow' is installed",
                 '0.188 m', f'{LAST + 1} = {LAST + 1} \u2713', 'onboard_guard REFUSED',
                 'half_angle_deg: 3.0'):
        assert fact in text, fact
    assert 'Steps without a command' not in text


def test_settings_of_another_version_are_named(recording):
    text = Reader(page(replace(recording, scenario_trouble='this version does not know a: b'))).text
    assert 'Some settings were left out: this version does not know a: b.' in text


def test_a_bag_that_was_cut_off_says_so_and_is_repaired(tmp_path):
    run = write_run(tmp_path / 'cut', small_run.messages(60), close=False)
    file = run / 'bag/bag_0.mcap'
    file.write_bytes(file.read_bytes()[:-1000])
    for _ in range(2):                          # also when the report is made again
        text = Reader(write_report(run).read_text()).text
        assert 'The bag was cut off at step 59 (29.5 s)' in text
        assert 'No verdict' in text
        assert 'Steps missing from the bag' in text
    assert read(run).complete


def test_a_recording_that_was_stopped_says_so(tmp_path):
    run = write_run(tmp_path / 'stopped', small_run.messages(60))
    text = Reader(write_report(run).read_text()).text
    assert 'The recording was stopped at step 59 (29.5 s), before the run ended.' in text


def test_an_empty_bag_makes_a_page_that_says_so(tmp_path):
    text = Reader(write_report(write_run(tmp_path / 'none', [])).read_text()).text
    assert 'before the first step' in text and 'the bag holds no scenario' in text


def test_what_the_disk_did_not_take_is_shown(tmp_path):
    run = write_run(tmp_path / 'full', small_run.messages(30), unstored=['/viz/ghost'] * 3)
    text = Reader(write_report(run).read_text()).text
    assert 'Received but not stored: 3 of /viz/ghost.' in text


def test_report_goes_beside_the_bag(run):
    assert write_report(run) == write_report(run / 'bag') == run / 'report.html'


def test_report_needs_a_bag(tmp_path):
    with pytest.raises(ValueError, match='holds no bag'):
        write_report(tmp_path)
