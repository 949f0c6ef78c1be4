"""The text of a drawing: what is drawn, as its axes and its legend say it."""

import numpy as np

from rvd_dynamics.recording.described import described, LONGEST
from rvd_dynamics.recording.drawing import canvas, svg


def two_panels():
    figure = canvas(3.0)
    above, below = figure.subplots(2, 1)
    above.plot([0.0, 1.0, 2.0], [3.0, -4.0, np.nan], label='wall & <port>')
    above.set(xlabel='time [s]', ylabel='z [m]', xlim=(0, 2), ylim=(5, -5))
    above.set_title('From above')
    below.plot([0.5], [0.0], 'o')
    below.plot([0.0, 1.0, 1.0], [0.0, 0.5, 0.25])
    below.axhline(7.0)
    below.set_yticks([0, 1], ['by hand', 'together'])
    below.set(xlim=(0, 1))
    return figure


def test_each_panel_says_title_axes_as_they_are_oriented_and_curves():
    figure = two_panels()
    svg('x', lambda: figure)                    # names at an axis are known once it is drawn
    assert described(figure) == (
        'Panel 1: From above; z [m] from 5 to \u22125, time [s] from 0 to 2; it shows '
        'wall & <port> (\u22124 to 3, last \u22124). '
        'Panel 2: vertical axis with by hand, together, horizontal axis from 0 to 1; it shows '
        'a curve (0 to 0.5, last 0.25).')


def test_it_is_the_text_of_the_element_and_does_no_harm_there():
    drawing = svg('x', two_panels)
    text = drawing.partition('aria-label="')[2].partition('"')[0]
    assert text.startswith('Panel 1: From above;') and 'wall &amp; &lt;port&gt; (' in text
    assert drawing.startswith('<svg viewBox=') and drawing.count('aria-label') == 1


def test_one_panel_has_no_number_and_an_empty_drawing_says_so():
    figure = canvas(2.0)
    assert described(figure) == 'Nothing is drawn.'
    figure.text(0.5, 0.5, 'no obstacles')
    assert described(figure) == 'no obstacles.'
    figure = canvas(2.0)
    figure.subplots().plot([1.0, 2.0, 3.0], [np.nan]*3, label='x')
    assert described(figure).endswith('it shows x (no data).')
    assert described(figure).startswith('vertical axis from ')


def test_what_nobody_would_listen_to_is_cut():
    figure = canvas(2.0)
    for axes in figure.subplots(4, 5).flat:
        for i in range(30):
            axes.plot([1, 2, 3], [1, 2, 3], label=f'a rather long name of a curve {i}')
    text = described(figure)
    assert len(text) <= LONGEST + 2 and text.endswith(' \u2026') and 'and' not in text[-4:]
    figure = canvas(2.0)
    axes = figure.subplots()
    for i in range(15):
        axes.plot([1, 2, 3], [1, 2, 3], label=f'c{i}')
    assert 'c11 (1 to 3, last 3), 3 more.' in described(figure) and 'c12' not in described(figure)
