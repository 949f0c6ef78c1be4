"""The report: self-contained, true to the bag, plain about what is missing."""

from dataclasses import replace
from html.parser import HTMLParser
import re
import xml.etree.ElementTree as ElementTree

import numpy as np
from numpy.testing import assert_allclose
import pytest
import small_run
from small_run import HOLD, LAST, write_run

from rvd_campaign.report import figures
from rvd_dynamics.recording.reader import read
from rvd_campaign.report.page import CAPTIONS
from rvd_campaign.report.run import page, write_report


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


def test_each_measure_has_its_row_unless_it_is_unknown_and_without_limit(html):
    table = re.search(r'<h2>Verdict</h2>\s*(<table.*?</table>)', html, re.S)[1]
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


@pytest.mark.parametrize('name', CAPTIONS)
def test_drawing_has_no_colour_of_its_own_and_its_text_is_text(recording, name):
    drawing = figures.svg(name, recording)
    root = ElementTree.fromstring(drawing.replace('xlink:href', 'href'))
    assert root.tag == 'svg' and root.get('viewBox')
    assert not re.search(r'#[0-9a-f]{6}', drawing)
    assert '[s]' in drawing or '[m]' in drawing
    assert drawing.count('<text') > 10


def test_every_figure_has_a_caption():
    assert list(CAPTIONS) == list(figures.FIGURES)


def test_prediction_is_held_against_the_truth_of_the_same_instant(recording):
    t, error, sigma = figures.prediction_error(recording)
    assert_allclose(t, np.arange(2 * HOLD, LAST + 1) * 0.5)
    assert_allclose(error, np.tile(small_run.ERROR, (len(t), 1)), atol=1e-12)
    assert_allclose(sigma, np.tile(small_run.SIGMA, (len(t), 1)), rtol=1e-12)


def line(figure, label):
    """Return the data of the first line of that label."""
    return next(artist.get_xydata() for axes in figure.axes for artist in axes.lines
                if artist.get_label() == label)


def test_the_true_track_is_drawn_where_it_was(recording):
    track = line(figures.approach(recording), 'true')
    assert_allclose(track, [[-30.0 + 0.25 * k, 0.1] for k in range(LAST + 1)])


def test_a_command_that_the_link_lost_is_marked_when_it_was_sent_and_when_it_should_act(recording):
    assert_allclose(line(figures.links(recording), 'never released'), [[20.0, 5.0]])
    assert_allclose(line(figures.prediction(recording), 'command lost')[:, 0], 25.0)


def test_pilot_levels_come_from_the_stick(recording):
    pilot = line(figures.levels(recording), 'pilot')
    assert_allclose(np.rint(pilot[:7, 1]), [-3, -2, -1, 0, 1, 2, 3])


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
    assert 'before the first step' in text and 'holds no scenario' in text


def test_what_the_disk_did_not_take_is_shown(tmp_path):
    run = write_run(tmp_path / 'full', small_run.messages(30), unstored=['/viz/ghost'] * 3)
    text = Reader(write_report(run).read_text()).text
    assert 'Received but not stored: 3 of /viz/ghost.' in text


def test_report_goes_beside_the_bag(run):
    assert write_report(run) == write_report(run / 'bag') == run / 'report.html'


def test_report_needs_a_bag(tmp_path):
    with pytest.raises(ValueError, match='holds no bag'):
        write_report(tmp_path)


def test_picture_is_written(recording, tmp_path):
    figures.approach_picture(recording, tmp_path / 'approach.png')
    assert (tmp_path / 'approach.png').read_bytes()[1:4] == b'PNG'
