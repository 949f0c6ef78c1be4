"""
How pages are written: templates, their look (`templates/`), and the captions of a run's figures.
"""

from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

TEMPLATES = Path(__file__).with_name('templates')

CAPTIONS = {
    'approach': (
        'Approach',
        'The track in two planes of the target orbital frame; the lateral scale is stretched. '
        'Outside the control boundary, drift can carry the chaser to the wall before a command '
        'sent now takes effect. Each panel shows the cone cut along its axis: the chaser meets '
        'the wall when its distance from the axis, not y or z alone, reaches the radius of the '
        'cone. Right: the last two metres, seen along the direction of flight, and the limit at '
        'the docking plane.'),
    'margin': (
        'Corridor margin',
        'Signed distance from the true position to the corridor wall. Shaded: the chaser was '
        'outside the control boundary.'),
    'levels': (
        'Who commanded what',
        'Thrust levels asked for by the pilot and by the automatic controller, and the command '
        'made from them, at the time they were issued on the ground. They act on board one '
        'forward delay later.'),
    'prediction': (
        'Prediction error',
        'Predicted minus true state at the same instant (line), with the band of two standard '
        'deviations that the predictor claimed. Dots: predicted state minus the measurement of '
        'that instant, which came down the link later; they contain the sensor\u2019s noise, and '
        'some may lie outside the plot. A command lost on the link shows as an error that lasts '
        'until telemetry reveals the loss.'),
    'links': (
        'Link delays',
        'Transit time of each released frame over the time it was sent, and the distribution of '
        'transit times. Dashed: the constant delay that the play-out buffer makes of them; a '
        'frame that takes longer, or is lost, is never released. In a long run only every n-th '
        'dot is drawn.'),
}


class Drawn(NamedTuple):
    """A figure of a page."""

    title: str
    svg: str                    # trusted: it goes into the page as it is
    caption: str
    tall: bool = False          # may be broken between two printed pages


def render(template: str, **content: Any) -> str:
    """Return a page of `templates/`; all text in `content` is escaped."""
    return _environment().get_template(template).render(content)


@lru_cache(maxsize=1)
def _environment() -> Any:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined
    return Environment(loader=FileSystemLoader(TEMPLATES), autoescape=True, trim_blocks=True,
                       lstrip_blocks=True, keep_trailing_newline=True, undefined=StrictUndefined)
