"""
Missions: what can be flown, found by their entry points.

A mission is a diagram and a judge, with figures, a display and table columns. A package offers
one with an entry point in the group `rvd.missions` that names a `Mission`. The object itself is
light: everything that costs time to import, or that must not be seen by everybody, is named as
text and loaded by the process that needs it.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from importlib.metadata import entry_points
from typing import Any, NamedTuple

from rvd_dynamics.bad_input import BadInput

GROUP = 'rvd.missions'


class Shared(NamedTuple):
    """Settings that stand under `/**`, by the name under which blocks ask for them."""

    name: str
    settings: str                       # 'module:Class'
    prefix: str = ''                    # of its keys, with the dot: 'orbit.'


# What every run has, whatever is flown.
RUN = Shared('run', 'rvd_dynamics.diagram.run:Run')
RECORDER = {'bag_recorder': 'rvd_dynamics.recording.params:RecorderParams'}
MARKERS = {'markers': 'rvd_dynamics.recording.params:MarkerParams'}


@dataclass(frozen=True)
class Mission:
    """
    One mission.

    Attributes
    ----------
    name, title : str
        As a scenario names it; one sentence for people.
    shared : tuple of Shared
        Settings under `/**`, besides `run`, which every mission has.
    sections : mapping of str to str
        Settings class of each node's section, as 'module:Class'; those of the recorder and the
        markers need no mention.
    diagram : str
        'module:function' that returns the `Diagram` of a scenario.
    parts : mapping of str to str
        Objects that blocks ask for by name, each a 'module:function' called with what its
        parameters name: shared settings, other parts, `scenario`.
    judge : str
        'module:Class'; see `diagram.judge`.
    checked : tuple of str
        Parts that are built as soon as a scenario is read, because they refuse what does not
        fit together.
    modes : tuple of str
        Modes that `/run/control` may change between.
    markers : bool
        Whether the scene is drawn for RViz and Foxglove.
    scene : str
        'module:function' of a scenario that returns what the markers draw besides the craft, a
        `display.scene.Field`; empty, or None from it: the corridor and the control boundary of an
        approach.
    columns : str
        'module:NAME' of the names of all columns of a campaign's table in their order, for a
        mission that orders them ('NAME?': where there is one); empty: the verdict, the measures,
        then what the block `columns` makes.
    column_measures : str
        'module:NAME' of the measures that are among those columns and not the judge's; empty: none.
    figures, campaign_figures, display, usual_steps : str
        'module:NAME' of the figures of a recording and those of a campaign, the console's
        display, and the number of steps that few runs outlast; empty: none.
    campaign_notes : str
        'module:function' of the scenarios of a campaign, which returns sentences that its report
        must have; empty: none.
    short_words : mapping of str to str
        Words that a campaign may use for changes: 'module:function' of a value and the folder of
        the campaign file, which returns changes by section.
    """

    name: str
    title: str
    shared: tuple[Shared, ...]
    sections: Mapping[str, str]
    diagram: str
    judge: str
    parts: Mapping[str, str] = field(default_factory=dict)
    checked: tuple[str, ...] = ()
    columns: str = ''
    column_measures: str = ''
    figures: str = ''
    display: str = ''
    campaign_figures: str = ''
    campaign_notes: str = ''
    usual_steps: str = ''
    markers: bool = False
    scene: str = ''
    modes: tuple[str, ...] = ()
    short_words: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        put = object.__setattr__
        if RUN.name not in {shared.name for shared in self.shared}:
            put(self, 'shared', (RUN, *self.shared))
        ours = {**RECORDER, **(MARKERS if self.markers else {})}
        put(self, 'sections', {**self.sections, **ours})

    def __reduce__(self) -> Any:
        """Travel to another process by name: its package is installed there, too."""
        if self.name in installed() and find(self.name) is self:
            return find, (self.name,)
        return super().__reduce__()


@lru_cache(maxsize=1)
def installed() -> dict[str, Any]:
    """Return the entry points of the installed missions by name."""
    return {point.name: point for point in sorted(entry_points(group=GROUP), key=lambda p: p.name)}


@lru_cache(maxsize=None)
def find(name: str) -> Mission:
    """
    Return an installed mission.

    Raises
    ------
    ValueError
        If none of that name is installed, or its package cannot be loaded; one line.
    """
    points = installed()
    if name not in points:
        raise BadInput(f'no mission {name!r} is installed; there are: '
                       f'{", ".join(points) or "none"} (RVD_OVERLAY names further prefixes)')
    try:
        mission = points[name].load()
    except (ImportError, AttributeError) as error:
        raise BadInput(f'mission {name} cannot be loaded: {error}') from None
    if not isinstance(mission, Mission) or mission.name != name:
        raise BadInput(f'mission {name}: {points[name].value} must be a Mission of that name')
    return mission
