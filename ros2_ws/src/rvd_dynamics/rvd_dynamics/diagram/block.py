"""
Blocks: the pieces of computation of a diagram, and what each reads, writes and draws.

A `Block` is a declaration, made of plain data: the class that computes is named as text and is
imported by the process that runs the block and by no other, so that a process of the ground
never loads the true world. The class has

    step(k, **inputs) -> {output: value}

over arrays with leading batch axes. It keeps its state to itself, reads no clock and knows no
ROS. Its constructor names what it needs (`diagram.build`): its `settings`, shared settings of
the scenario, parts that the mission builds, the `batch`, its `draws`, and what is `wanted`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.signal import Signal

WORLD, ONBOARD, LINK, GROUND, WATCH = SEGMENTS = ('world', 'onboard', 'link', 'ground', 'watch')
SEES_TRUTH = (WORLD, WATCH)
# The node's name, its executable and where it is found, unless a block says otherwise.
PACKAGES = {WORLD: 'rvd_dynamics', ONBOARD: 'rvd_dynamics', LINK: 'rvd_dynamics',
            GROUND: 'rvd_groundstation', WATCH: 'rvd_dynamics'}


@dataclass(frozen=True)
class Read:
    """
    One input of a block: a signal, some base steps ago.

    `held` inputs do not make the block wait: it takes the newest message of the last half second
    of wall time (a hand on a stick). `optional` names the optional parts that the block uses.
    `late` names an argument of `step` that gets, in a graph, what came after the firing that was
    to have it: a dict of values by the step in which they were written.
    """

    signal: Signal
    delay: int = 0
    held: bool = False
    optional: tuple[str, ...] = ()
    late: str = ''

    def __post_init__(self) -> None:
        if self.delay < 0:
            raise BadInput(f'{self.signal.name}: a delay must not be negative, got {self.delay}')


def now(signal: Signal, *optional: str) -> Read:
    """Read a signal of the same step."""
    return Read(signal, 0, optional=optional)


def last(signal: Signal, *optional: str, late: str = '') -> Read:
    """Read a signal of the step before."""
    return Read(signal, 1, optional=optional, late=late)


def held(signal: Signal) -> Read:
    """Read the newest message of a signal, whenever it came."""
    return Read(signal, held=True)


@dataclass(frozen=True)
class Block:
    """
    Declaration of a block.

    Attributes
    ----------
    name : str
        Name of the node.
    make : str
        'module:Class' of what computes.
    segment : str
        One of SEGMENTS: where it runs and what it may read.
    reads : mapping of str to Read
        Inputs of `step` by argument name.
    writes : mapping of str to Signal
        Outputs of `step` by name.
    settings : str
        'module:Class' of its settings; empty: it has none.
    section : str
        Section of the parameter file; its name unless given.
    period : int
        It fires at steps that this divides.
    draws : mapping of str to draw
        Random blocks that it uses, by the name under which it gets them (`diagram.streams`).
    control : bool
        Whether `step` also gets `control`: the mode, and whether an abort was asked for.
    package, executable : str
        Where `ros2 run` finds it; empty executable: it runs in process only.
    """

    name: str
    make: str
    segment: str
    reads: Mapping[str, Read] = field(default_factory=dict)
    writes: Mapping[str, Signal] = field(default_factory=dict)
    settings: str = ''
    section: str = ''
    period: int = 1
    draws: Mapping[str, Any] = field(default_factory=dict)
    control: bool = False
    package: str = ''
    executable: str | None = None

    def __post_init__(self) -> None:
        if self.segment not in SEGMENTS:
            raise BadInput(f'block {self.name}: segment must be one of {", ".join(SEGMENTS)}, '
                           f'got {self.segment!r}')
        if self.period < 1:
            raise BadInput(f'block {self.name}: period must be at least 1, got {self.period}')
        put = object.__setattr__
        put(self, 'section', self.section or self.name)
        put(self, 'package', self.package or PACKAGES[self.segment])
        put(self, 'executable', self.name if self.executable is None else self.executable)

    @property
    def in_graph(self) -> bool:
        """Whether it has a node of its own."""
        return bool(self.executable)


@dataclass(frozen=True)
class Leg(Block):
    """
    One direction of the space link.

    In one process it hands the arrays of `content` on after its delay, with a mask of what came
    through (`link.leg`). In a graph it is a node that sees frames of bytes: the sender's codec
    packs `content` into one, the receiver's makes `arrival` of the one that is released.
    """

    status: Signal | None = None        # what it counts; graph only


@dataclass(frozen=True)
class External:
    """
    A node that is not a block: a console, a stick's driver, a viewer. Never grouped.

    A foreign one is not ours: it says nothing on /run/ready, and who reads it waits for its topics
    alone. With `started` false it is not the run's to start: somebody else does.
    """

    name: str
    package: str
    executable: str
    segment: str
    reads: tuple[str, ...] = ()         # topics
    writes: tuple[str, ...] = ()        # topics
    foreign: bool = False
    started: bool = True
    viewer: bool = True                 # shows the run: hears pauses, events and the verdict
