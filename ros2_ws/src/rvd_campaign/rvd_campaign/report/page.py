"""
How pages are written: templates, and their look (`templates/`).
"""

from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from rvd_dynamics.bad_input import one_line

TEMPLATES = Path(__file__).with_name('templates')


class Drawn(NamedTuple):
    """A figure of a page."""

    title: str
    svg: str                    # trusted: it goes into the page as it is
    caption: str
    tall: bool = False          # may be broken between two printed pages


def render(template: str, **content: Any) -> str:
    """Return a page of `templates/`; all text in `content` is escaped, control characters too."""
    return _environment().get_template(template).render(content)


@lru_cache(maxsize=1)
def _environment() -> Any:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined
    return Environment(loader=FileSystemLoader(TEMPLATES), autoescape=True, finalize=_harmless,
                       trim_blocks=True,
                       lstrip_blocks=True, keep_trailing_newline=True, undefined=StrictUndefined)


def _harmless(shown: Any) -> Any:
    """Return a text from a bag without what turns it round, or is no character of a page."""
    if type(shown) is not str or shown.isprintable():   # a subclass has been escaped already
        return shown
    return '\n'.join(map(one_line, shown.split('\n')))
