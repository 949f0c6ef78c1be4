"""
A diagram in one process: N runs at once, one row each.

It calls the blocks in the order of the diagram, so that a row is equal to the bit to the same run
over DDS, alone or in any batch. A row ends at the first step that the plant calls final; it is
carried along until the last one has ended, and no longer counts. Before the first firing of its
writer, a signal has its initial value.

Control, which in a graph comes from `/run/control`, comes from a schedule here.
"""

import inspect
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.build import made, needs
from rvd_dynamics.diagram.control import Change, Control
from rvd_dynamics.diagram.diagram import DiagramError
from rvd_dynamics.diagram.judge import aborted
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Signal

CONTROL = 'control'             # argument of a step that is told of mode and abort
COLUMNS = 'columns'             # the block that makes the mission's own columns of a table


@dataclass(frozen=True)
class Draws:
    """All chance of N runs, whatever is flown with it."""

    key: tuple                          # what the draws depend on
    steps: int
    of: dict[tuple[str, str], Any]      # by block and the name it uses


@dataclass(frozen=True)
class Batch:
    """N flown runs."""

    runs: NDArray[np.int64]             # (N,) numbers of the runs
    end_step: NDArray[np.int64]         # (N,) step of the last truth
    verdict: Any                        # the judge's, fields (N,)
    columns: dict[str, NDArray]         # the mission's own, (N,)
    history: dict[str, Any] | None      # by signal: its value with (steps, N, ...), when recorded


def fly(scenario: Scenario, runs: Sequence[int], record: bool | Sequence[str] = False,
        draws: Draws | None = None, schedule: Sequence[Change] = ()) -> Batch:
    """
    Fly runs to their end.

    Parameters
    ----------
    scenario : Scenario
        Its seed counts, its run number does not.
    runs : sequence of int
        Numbers of the runs; each is the same whichever others fly with it.
    record : bool or sequence of str
        Keep the history of all signals, or of these (0.3 kB per step and run: leave it out of
        campaigns). 'NAME.PART' asks for an optional part.
    draws : Draws, optional
        What `draw` returned for these runs. Drawing takes more time than flying, and conditions
        that share seed, links and time grid share the draws.
    schedule : sequence of Change
        Changes of mode, and an abort.

    Returns
    -------
    Batch

    Raises
    ------
    ValueError
        If there is no run, `draws` are of other runs or settings, or a block returns something
        of the wrong form.
    """
    if len(runs) == 0:
        raise BadInput('runs must name at least one run, got none')
    check(scenario)
    if draws is None or record:                     # a history is of whole runs
        draws = draw(scenario, runs, whole=bool(record))
    if draws.key != draws_key(scenario, runs):
        raise BadInput('draws are of other runs, seed, links, delays or time grid')
    loop = Loop(scenario, runs, draws, record, schedule)
    for step in range(draws.steps):
        loop.advance(step)
        if loop.ended.all():
            break
    batch = loop.result()
    return batch if loop.ended.all() else _with_late_ones(scenario, batch, loop.ended, schedule)


def _with_late_ones(scenario: Scenario, batch: Batch, ended: NDArray[np.bool_],
                    schedule: Sequence[Change]) -> Batch:
    """Fly again, with all the draws there are, the few runs that outlast the usual ones."""
    late = np.flatnonzero(~ended)
    runs = batch.runs[late].tolist()
    whole = fly(scenario, runs, draws=draw(scenario, runs, whole=True), schedule=schedule)

    def merged(mine: Any, theirs: Any) -> Any:
        if isinstance(mine, dict):
            return {name: merged(mine[name], theirs[name]) for name in mine}
        if isinstance(mine, tuple):
            return type(mine)(*map(merged, mine, theirs))
        mine = mine.astype(np.result_type(mine, theirs))    # the longest reason is the widest
        mine[late] = theirs
        return mine

    return Batch(batch.runs, merged(batch.end_step, whole.end_step),
                 merged(batch.verdict, whole.verdict), merged(batch.columns, whole.columns), None)


def check(scenario: Scenario) -> None:
    """
    Build what the blocks of a scenario ask for, without flying.

    Raises
    ------
    ValueError
        If a part is refused (a tape, for instance), or something from outside takes part, which
        only a graph has.
    """
    diagram = scenario.diagram
    for block in diagram.blocks:
        for read in block.reads.values():
            if read.signal.name not in diagram.writer_of:
                outside = ', '.join(external.name for external in diagram.externals
                                    if read.signal.name in external.writes)
                raise BadInput(f'{_operator(scenario)}{block.name} reads {read.signal.name} '
                               f'from {outside}, which takes a graph and a wall clock: in one '
                               'process only blocks take part')
        for name in needs(block.make, f'block {block.name}'):
            if name in scenario.mission.parts:
                scenario.part(name)


def _operator(scenario: Scenario) -> str:
    """Return the beginning of a refusal: the operator, where the mission has one."""
    if not scenario.has_shared('operator'):
        return ''
    return f'operator {scenario.part("operation").operator}: '


def judge_of(scenario: Scenario, batch: tuple = (), runs: Sequence[int] | None = None) -> Any:
    """Return a judge of the scenario's mission for a batch; None: of the scenario's own run."""
    own = {'batch': batch, 'runs': runs}
    return made(scenario.mission.judge, lambda name: own[name] if name in own else
                scenario.part(name), f'judge of mission {scenario.mission.name}')


# -- chance ----------------------------------------------------------------------------------

def draw(scenario: Scenario, runs: Sequence[int], whole: bool = False) -> Draws:
    """
    Draw what every block will use in runs; see `fly`.

    Enough for the steps that few runs outlast; `whole` for all that a run may take. The shorter
    blocks are the beginning of the longer ones.
    """
    steps = scenario.run.last_step + 1
    if not whole and scenario.mission.usual_steps:
        steps = min(steps, made(scenario.mission.usual_steps, scenario.part, 'usual_steps'))
    seed = scenario.run.seed
    return Draws(draws_key(scenario, runs), steps, {
        (block.name, name): wanted.of_runs(seed, runs, steps)
        for block in scenario.diagram.blocks for name, wanted in block.draws.items()})


def draws_key(scenario: Scenario, runs: Sequence[int]) -> tuple:
    """Return what must be equal for scenarios to share the draws of runs."""
    run = scenario.run
    return (tuple(runs), scenario.mission.name, run.seed, run.last_step, run.step_ns,
            tuple((block.name, *item) for block in scenario.diagram.blocks
                  for item in block.draws.items()))


# -- the loop --------------------------------------------------------------------------------

class _Slot:
    """A signal under way: a cell with its newest value, and as many before as somebody reads."""

    def __init__(self, signal: Signal, depth: int, batch: tuple) -> None:
        self.signal = signal
        self.now = [signal.initial(batch)]
        self.before = deque(self.now*depth, maxlen=depth)


class Loop:
    """The blocks of a scenario and what is on its way between them."""

    def __init__(self, scenario: Scenario, runs: Sequence[int], draws: Draws,
                 record: bool | Sequence[str], schedule: Sequence[Change]) -> None:
        self._batch = (len(runs),)
        self._runs = np.asarray(runs, dtype=np.int64)
        self._scenario, self._diagram = scenario, scenario.diagram
        self._record = _recorded(self._diagram, record)
        self._schedule = {change.step: change for change in schedule}
        self._control = [Control(*_mode_of(scenario))]
        self._control[0] = self._control_of(0)
        self._aborts = min((c.step for c in schedule if c.abort), default=None)
        delays: dict[str, list[int]] = {}
        for block in self._diagram.blocks:
            for read in block.reads.values():
                delays.setdefault(read.signal.name, []).append(read.delay)
        self._slots = {name: _Slot(signal, max(delays.get(name, [0])), self._batch)
                       for name, signal in self._diagram.signals.items()}
        self._blocks = {block.name: self._made(block, runs, draws) for block in self._diagram.order}
        self._plan = [self._planned(block) for block in self._diagram.order]
        self._delayed = [slot for slot in self._slots.values() if slot.before.maxlen]
        self.judge = judge_of(scenario, self._batch, runs)
        self._plant = self._diagram.by_name[self._diagram.plant]
        self._truth = self._slots[self._diagram.truth.name].now
        self.ended = np.zeros(len(runs), dtype=bool)
        self.end_step = np.full(len(runs), -1, dtype=np.int64)
        self._abort_since = np.full(len(runs), np.nan)      # [s] as `aborts` says
        self._history: dict[str, list] = {name: [] for name in self._record}

    def _made(self, block: Block, runs: Sequence[int], draws: Draws) -> Any:
        own = {name: draws.of[block.name, name] for name in block.draws}
        own |= {'runs': runs, 'steps': draws.steps, 'block': block, 'abort_step': self._aborts,
                'wanted': wanted(self._diagram, block, self._record)}
        if block.settings:
            own['settings'] = self._scenario.settings(block.section)
        return made(block.make, self._available(own), f'block {block.name}')

    def _available(self, own: dict[str, Any]) -> Any:
        own = {'batch': self._batch, **own}

        def available(name: str) -> Any:
            return own[name] if name in own else self._scenario.part(name)
        return available

    def _planned(self, block: Block) -> tuple:
        """
        Return what `advance` needs of a block.

        Where each argument of `step` is found is settled here, as a container and an index: that
        halves what a firing costs besides the block's own work.
        """
        fire, parameters = self._blocks[block.name].step, {}
        for name, parameter in list(inspect.signature(fire).parameters.items())[1:]:
            if parameter.kind in (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.KEYWORD_ONLY):
                fire, parameters = _by_name(fire, block), dict.fromkeys(_arguments(block))
                break
            parameters[name] = parameter
        for name in _arguments(block):
            if name not in parameters:
                raise DiagramError(f'block {block.name} reads {name}, which its step does not take')
        sources = [self._source(block, *item) for item in parameters.items()]
        outputs = [(name, self._slots[signal.name].now) for name, signal in block.writes.items()]
        return block, fire, block.period, sources, outputs

    def _source(self, block: Block, name: str, parameter: inspect.Parameter | None
                ) -> tuple[Any, int]:
        """Return where an argument of a block's step is found."""
        if name == CONTROL and block.control:
            return self._control, 0
        read = block.reads.get(name)
        if read is not None:
            slot = self._slots[read.signal.name]
            return (slot.before, -read.delay) if read.delay else (slot.now, 0)
        if parameter is None or parameter.default is inspect.Parameter.empty:
            raise DiagramError(f'block {block.name}: step takes {name}, which the block does not '
                               'read')
        return [parameter.default], 0

    def advance(self, step: int) -> None:
        """Do everything that happens in one step."""
        if step in self._schedule or step + 1 in self._schedule:
            self._control[0] = self._control_of(step)
        for block, fire, period, sources, outputs in self._plan:
            if step % period:
                continue
            made_now = fire(step, *[where[at] for where, at in sources])
            if step == 0:
                self._check(block, made_now)
            for name, cell in outputs:
                if name in made_now:
                    cell[0] = made_now[name]
            if block is self._plant:                # at once: the truth is still in the cache
                self.judge.follow(step, self._truth[0])
        for slot in self._delayed:
            slot.before.append(slot.now[0])
        for name, kept in self._history.items():
            kept.append(self._slots[name].now[0])
        final = self._truth[0].final
        if np.count_nonzero(final):
            self.end_step[final & ~self.ended] = step
            self.ended |= final
        if self._aborts is not None and step >= self._aborts:
            first = self._shows_abort() & ~self.ended & np.isnan(self._abort_since)
            self._abort_since[first] = step*self._scenario.run.step_s

    def _shows_abort(self) -> NDArray[np.bool_] | bool:
        """Return in which runs it shows on board that an ABORT is in force."""
        shown = self._diagram.abort_shown
        return shown is not None and getattr(
            self._slots[shown.signal].now[0], shown.part) == shown.value

    def _control_of(self, step: int) -> Control:
        """Return what is in force in a step, by the schedule."""
        before, nothing = self._control[0], Change(step)
        change, after = self._schedule.get(step, nothing), self._schedule.get(step + 1, nothing)
        mode = change.mode or before.mode
        return Control(mode, change.abort or before.abort, after.mode or mode)

    def _check(self, block: Block, outputs: Any) -> None:
        """Refuse outputs that have not the form of their signals."""
        if not isinstance(outputs, dict):
            raise DiagramError(f'block {block.name}: step must return a value for each output by '
                               f'name, got {type(outputs).__name__}')
        for name, value in outputs.items():
            signal = block.writes.get(name)
            if signal is None:
                raise DiagramError(f'block {block.name} returns {name!r}, which it does not write; '
                                   f'it writes {", ".join(block.writes) or "nothing"}')
            complaint = signal.complaint(value, self._batch)
            if complaint:
                raise DiagramError(f'block {block.name} writes {signal.name}: {complaint}')

    def result(self) -> Batch:
        """Return what has been flown."""
        columns = {}
        if COLUMNS in self._blocks:
            columns = self._blocks[COLUMNS].table(self.judge, self.end_step)
        history = None
        if self._record:
            history = {name: _stacked(self._slots[name].signal, values, self.end_step, self._batch)
                       for name, values in self._history.items()}
        verdict = aborted(self.judge.verdict(), self._abort_since)
        return Batch(self._runs, self.end_step, verdict, columns, history)


def _arguments(block: Block) -> list[str]:
    """Return what a block's step is given besides the number of the step."""
    return [*block.reads, *([CONTROL] if block.control else [])]


def _by_name(step: Callable, block: Block) -> Callable:
    """Return a step that takes its arguments in the order of `_arguments`."""
    names = _arguments(block)
    return lambda k, *values: step(k, **dict(zip(names, values)))


def _mode_of(scenario: Scenario) -> tuple[str]:
    """Return the mode with which a run begins, where the mission has modes."""
    return (scenario.part('operation').mode,) if scenario.has_shared('mode') else ('',)


def _recorded(diagram: Any, record: bool | Sequence[str]) -> dict[str, frozenset[str]]:
    """Return the signals to keep, with the optional parts that are asked for."""
    if not record:
        return {}
    names = list(diagram.signals) if record is True else list(record)
    kept: dict[str, frozenset[str]] = {}
    for name in names:
        signal, _, part = name.partition('.')
        if signal not in diagram.signals:
            raise BadInput(f'no signal {signal} to record; there are: '
                           f'{", ".join(diagram.signals)}')
        kept[signal] = kept.get(signal, frozenset()) | ({part} if part else frozenset())
    return kept


def wanted(diagram: Any, block: Block, record: dict[str, frozenset[str]]) -> frozenset[str]:
    """Return the outputs of a block that are read or recorded, and 'output.part' likewise."""
    found = set()
    for name, signal in block.writes.items():
        readers = [read for other in diagram.blocks for read in other.reads.values()
                   if read.signal.name == signal.name]
        if readers or signal.name in record:
            found.add(name)
        parts = {part for read in readers for part in read.optional} | record.get(
            signal.name, frozenset())
        found |= {f'{name}.{part}' for part in parts}
    return frozenset(found)


def everything(block: Block) -> frozenset[str]:
    """Return all outputs of a block and all their parts: what a graph publishes."""
    return frozenset(block.writes) | {f'{name}.{part.name}' for name, signal in
                                      block.writes.items() for part in signal.parts}


def _stacked(signal: Signal, values: list, end_step: NDArray[np.int64], batch: tuple) -> Any:
    """Stack the values of the steps, and blank what lies after the end of each run."""
    after = np.arange(len(values))[:, None] > end_step
    made_of = {}
    for part in signal.parts:
        column = [getattr(value, part.name) for value in values]
        if any(v is None for v in column):
            made_of[part.name] = None
            continue
        if part.dtype == 'O':                   # the same in all rows: a list, step by step
            made_of[part.name] = column
            continue
        whole = np.empty((len(values), *batch, *part.shape), dtype=part.dtype)
        for at, v in zip(whole, column):
            at[...] = v if np.ndim(v) > len(part.shape) else np.broadcast_to(v, at.shape)
        whole[after] = np.nan if whole.dtype.kind == 'f' else 0
        made_of[part.name] = whole
    return signal.type(**made_of)
