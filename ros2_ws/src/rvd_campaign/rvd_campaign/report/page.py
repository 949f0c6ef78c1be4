"""
How pages are written: templates, and their look (`templates/`).
"""

from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

TEMPLATES = Path(__file__).with_name('templates')


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
