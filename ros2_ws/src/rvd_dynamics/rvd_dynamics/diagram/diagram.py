"""
A diagram: the blocks and signals of one run, checked.

It is the only place where the data flow is written. The loop in one process, the wiring of the
executables, their start-up barrier, the list of processes, the recorder's topics and the random
streams are all read from it.

Rules   every signal has one writer; a cycle has a delay in it; a truth signal is written by the
        world and read by the world and the watchers alone; nothing passes between the craft and
        the ground but through a leg of the link; the guard is the only writer of the thrust
        command, which has an initial value; what a slower block writes is read with a delay of
        at least one step; two purposes of draws have two streams.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.codes import KIND_ABORT
from rvd_dynamics.diagram.block import (
    Block, External, GROUND, Leg, LINK, ONBOARD, Read, SEES_TRUTH, SEGMENTS, WATCH, WORLD)
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.diagram.streams import number_of

GROUPINGS = ('blocks', 'segments', 'one')
# Segment of a reader: segments whose signals it may read.
MAY_READ = {
    WORLD: (WORLD, ONBOARD),
    ONBOARD: (WORLD, ONBOARD, LINK),
    LINK: (WORLD, ONBOARD, GROUND),
    GROUND: (LINK, GROUND),
    WATCH: SEGMENTS,
}


class DiagramError(BadInput):
    """A diagram that breaks a rule; the text is one line that names block, signal and rule."""


class Shown(NamedTuple):
    """A value of a part of a signal that stands for something, once it is there."""

    signal: str
    part: str
    value: int


@dataclass(frozen=True)
class Diagram:
    """
    Blocks of one run.

    Attributes
    ----------
    blocks : tuple of Block
    plant : str
        Block that is the true motion; one of its signals has a part `final`, true at the last
        step of a run.
    guard : str
        Block that has the last word about thrust.
    thrust : str
        Signal that acts on the craft.
    externals : tuple of External
        Other nodes that may take part.
    abort_in : Shown, optional
        Where it shows on board that an ABORT is in force, if the guard's command does not show it.
    """

    blocks: tuple[Block, ...]
    plant: str
    guard: str
    thrust: str
    externals: tuple[External, ...] = ()
    abort_in: Shown | None = None

    def __post_init__(self) -> None:
        self._check_names()
        self._check_writers()
        self._check_reads()
        self._check_externals()
        self._check_thrust()
        self._check_draws()
        self.order                              # refuses a cycle without delay

    @cached_property
    def abort_shown(self) -> Shown | None:
        """Where it shows on board that an ABORT is in force; None where nothing shows it."""
        shown = self.abort_in or Shown(self.thrust, 'kind', KIND_ABORT)
        parts = self.signals[shown.signal].parts if shown.signal in self.signals else ()
        return shown if shown.part in (part.name for part in parts) else None

    # -- look-up ----------------------------------------------------------------------------

    @cached_property
    def by_name(self) -> dict[str, Block]:
        """Blocks by name."""
        return {block.name: block for block in self.blocks}

    @cached_property
    def writer_of(self) -> dict[str, Block]:
        """Block that writes each signal, by the signal's name."""
        return {signal.name: block for block in self.blocks for signal in block.writes.values()}

    @cached_property
    def signals(self) -> dict[str, Signal]:
        """Signals by name."""
        return {signal.name: signal for block in self.blocks for signal in block.writes.values()}

    @cached_property
    def truth(self) -> Signal:
        """The plant's signal with the part `final`."""
        return next(signal for signal in self.by_name[self.plant].writes.values()
                    if any(part.name == 'final' for part in signal.parts))

    @cached_property
    def order(self) -> tuple[Block, ...]:
        """
        The blocks so that each comes after those whose present output it reads.

        What is held comes before its readers, too, unless it waits for them.
        """
        self._sorted(held=False)                    # refuses a cycle without delay
        try:
            return self._sorted(held=True)
        except DiagramError:
            return self._sorted(held=False)

    def _sorted(self, held: bool) -> tuple[Block, ...]:
        done: dict[str, Block] = {}
        for block in self.blocks:
            self._visit(block, [], done, held)
        return tuple(done.values())

    def _visit(self, block: Block, path: list[str], done: dict[str, Block], held: bool) -> None:
        if block.name in done:
            return
        if block.name in path:
            cycle = [*path[path.index(block.name):], block.name]
            raise DiagramError(f'blocks {" -> ".join(cycle)} wait for each other: a cycle needs a '
                               'delay of at least one step')
        for read in block.reads.values():
            if read.delay == 0 and (held or not read.held) and read.signal.name in self.writer_of:
                self._visit(self.writer_of[read.signal.name], [*path, block.name], done, held)
        done[block.name] = block

    def readers_of(self, signal: str) -> list[Block]:
        """Return the blocks that read a signal."""
        return [block for block in self.blocks
                if any(read.signal.name == signal for read in block.reads.values())]

    # -- rules ------------------------------------------------------------------------------

    def _check_names(self) -> None:
        names = [part.name for part in (*self.blocks, *self.externals)]
        for name in names:
            if names.count(name) > 1:
                raise DiagramError(f'block {name} is declared twice: names are unique')
        for block in self.blocks:
            if block.segment == LINK and not isinstance(block, Leg):
                raise DiagramError(f'block {block.name} of segment {LINK} is no leg: only a leg '
                                   'of the link joins craft and ground')
        for role in ('plant', 'guard'):
            if getattr(self, role) not in self.by_name:
                raise DiagramError(f'the {role} must be one of the blocks '
                                   f'{", ".join(self.by_name)}, got {getattr(self, role)!r}')

    def _check_writers(self) -> None:
        writers = {topic: external.name for external in self.externals
                   for topic in external.writes}
        for block in self.blocks:
            for output, signal in block.writes.items():
                other = writers.setdefault(signal.name, f'{block.name}.{output}')
                if other != f'{block.name}.{output}':
                    raise DiagramError(f'block {block.name} writes {signal.name} as {output}, '
                                       f'which {other} writes too: a signal has one writer')
                if signal.truth and block.segment != WORLD:
                    raise DiagramError(f'block {block.name} of segment {block.segment} writes '
                                       f'{signal.name}: truth is written by the world')
        if not any(part.name == 'final' for signal in self.by_name[self.plant].writes.values()
                   for part in signal.parts):
            raise DiagramError(f'block {self.plant} is the plant, but no signal of it has a part '
                               'final: the plant says when a run ends')

    def _check_reads(self) -> None:
        outside = {topic for external in self.externals for topic in external.writes}
        for block in self.blocks:
            if block.in_graph and not any(not read.held for read in block.reads.values()):
                raise DiagramError(f'block {block.name} reads nothing that makes it fire: a block '
                                   'fires when its inputs are complete')
            for argument, read in block.reads.items():
                signal = read.signal
                writer = self.writer_of.get(signal.name)
                if writer is None:
                    if signal.name in outside:
                        continue
                    raise DiagramError(f'block {block.name} reads {signal.name} as {argument}, '
                                       'which nobody writes: a signal has one writer')
                self._check_read(block, read, writer)

    def _check_read(self, block: Block, read: Read, writer: Block) -> None:
        name = read.signal.name
        if self.signals[name].parts != read.signal.parts:
            raise DiagramError(f'block {block.name} reads {name} with another layout than '
                               f'{writer.name} writes: a signal has one layout')
        if self.signals[name].still:
            raise DiagramError(f'block {block.name} reads {name}, which is still: it is published '
                               'once, for viewers')
        if read.signal.truth and block.segment not in SEES_TRUTH:
            raise DiagramError(f'block {block.name} of segment {block.segment} reads {name}: truth '
                               'is for the world and the watchers alone')
        if writer.segment not in MAY_READ[block.segment]:
            raise DiagramError(f'block {block.name} of segment {block.segment} reads {name} of '
                               f'segment {writer.segment}: only a leg of the link joins them')
        if writer.period > block.period and read.delay < 1:
            raise DiagramError(f'block {block.name} (period {block.period}) reads {name} of '
                               f'{writer.name} (period {writer.period}) without delay: what a '
                               'slower block writes is read at least one step later')

    def _check_externals(self) -> None:
        for external in self.externals:
            for topic in external.reads:
                writer = self.writer_of.get(topic)      # none: what a leg says of itself
                if writer is None:
                    continue
                if self.signals[topic].truth and external.segment not in SEES_TRUTH:
                    raise DiagramError(f'{external.name} of segment {external.segment} reads '
                                       f'{topic}: truth is for the world and the watchers alone')
                if writer.segment not in MAY_READ[external.segment]:
                    raise DiagramError(
                        f'{external.name} of segment {external.segment} reads {topic} of segment '
                        f'{writer.segment}: only a leg of the link joins them')

    def _check_draws(self) -> None:
        streams: dict[int, tuple[str, str]] = {}
        for block in self.blocks:
            for name, draw in block.draws.items():
                for purpose in draw.purposes:
                    try:
                        number = number_of(purpose)
                    except ValueError as error:
                        raise DiagramError(f'block {block.name} draws {name}: {error}') from None
                    other, its = streams.setdefault(number, (block.name, purpose))
                    if its != purpose:
                        raise DiagramError(f'block {block.name} draws {name} from {purpose}, which '
                                           f'has the stream of {its} of block {other}: give it '
                                           'another name')

    def _check_thrust(self) -> None:
        writer = self.writer_of.get(self.thrust)
        if writer is None or writer.name != self.guard:
            written_by = writer.name if writer else 'nobody'
            raise DiagramError(f'{self.thrust} is written by {written_by}: '
                               f'the guard {self.guard} is the only writer of thrust')
        for part in self.signals[self.thrust].parts:
            if part.name == 'command' and not np.isfinite(part.filled(())).all():
                raise DiagramError(f'block {self.guard} writes {self.thrust}, whose command has no '
                                   'initial value: it acts where none has come in time')

    # -- processes --------------------------------------------------------------------------

    def groups(self, processes: str) -> dict[str, tuple[Block, ...]]:
        """
        Return which blocks share a process, by the name of the process.

        Raises
        ------
        ValueError
            If the grouping is not one of GROUPINGS.
        """
        nodes = [block for block in self.order if block.in_graph]
        if processes == 'blocks':
            return {block.name: (block,) for block in nodes}
        if processes == 'segments':
            return {segment: tuple(b for b in nodes if b.segment == segment)
                    for segment in SEGMENTS if any(b.segment == segment for b in nodes)}
        if processes == 'one':
            return {'one': tuple(nodes)}
        raise BadInput(f'processes must be one of {", ".join(GROUPINGS)}, got {processes!r}')

    def legs(self) -> Iterator[Leg]:
        """Yield the legs of the link."""
        return (block for block in self.blocks if isinstance(block, Leg))

    def without(self, names: Iterable[str]) -> 'Diagram':
        """Return the diagram less some watchers."""
        gone = set(names)
        return Diagram(tuple(b for b in self.blocks if b.name not in gone), self.plant, self.guard,
                       self.thrust, tuple(e for e in self.externals if e.name not in gone))
