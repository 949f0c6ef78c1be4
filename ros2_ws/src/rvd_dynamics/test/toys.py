"""
A mission made of toy blocks: a plant that counts, a guard, and what a test puts beside them.

`mission(blocks)` is a whole mission, with a judge that counts steps, that `in_process.fly` takes.
Blocks find their classes here, by text, as those of a real mission do.
"""

from dataclasses import dataclass

import numpy as np

from rvd_dynamics.diagram import in_process
from rvd_dynamics.diagram.block import Block, last, ONBOARD, WATCH, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.judge import Verdict
from rvd_dynamics.diagram.mission import Mission, Shared
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Part, Signal

HERE = __name__
TRUTH = Signal('/truth', (Part('state', (2,), 'm'), Part('final', (), '', '?')), truth=True)
THRUST = Signal('/thrust', (Part('command', (1,), '', 'i1'),))


def number(topic, **part):
    """Return a signal of one number."""
    return Signal(topic, (Part('value', **part),))


class Plant:
    """Counts steps; the last one is final."""

    def __init__(self, run, batch):
        self._batch, self._last = batch, run.last_step

    def step(self, k, thrust):
        return {'truth': TRUTH(state=np.full((*self._batch, 2), float(k)),
                               final=np.full(self._batch, k >= self._last))}


class Guard:
    """Never thrusts."""

    def __init__(self, batch):
        self._batch = batch

    def step(self, k, sensed):
        return {'thrust': THRUST(command=np.zeros((*self._batch, 1), dtype=np.int8))}


class Counter:
    """Says in which step it fired."""

    def __init__(self, block, batch):
        (self._name, self._signal), = block.writes.items()
        self._batch = batch

    def step(self, k, **inputs):
        return {self._name: self._signal(value=np.full(self._batch, float(k)))}


class Ear:
    """Keeps what it reads, by step."""

    heard = {}

    def __init__(self, block, batch):
        self._kept = self.heard[block.name] = {}

    def step(self, k, **inputs):
        self._kept[k] = {name: value.value[0].item() for name, value in inputs.items()}
        return {}


class Chance:
    """Keeps its draws."""

    drawn = {}

    def __init__(self, block, noise):
        self.drawn[block.name] = noise

    def step(self, k, **inputs):
        return {}


class Returns:
    """Returns whatever a test has put here."""

    what = None

    def step(self, k, **inputs):
        return type(self).what


class Judge:
    """Follows the truth and judges nothing."""

    measures, reasons = (), {'over': 'over'}

    def __init__(self, batch):
        self._batch, self._steps = batch, 0

    def follow(self, k, truth):
        assert k == self._steps
        self._steps += 1

    def verdict(self, final=False):
        full = np.full
        return Verdict(full(self._batch, True), full(self._batch, 'over'),
                       full(self._batch, float(self._steps)), {})


PLANT = Block('plant', f'{HERE}:Plant', WORLD, reads={'thrust': last(THRUST)},
              writes={'truth': TRUTH})
SENSED = number('/sensed')
SENSOR = Block('sensor', f'{HERE}:Counter', WORLD, reads={'truth': last(TRUTH)},
               writes={'sensed': SENSED})
GUARD = Block('guard', f'{HERE}:Guard', ONBOARD, reads={'sensed': last(SENSED)},
              writes={'thrust': THRUST})


def watcher(name, reads, make='Ear', **more):
    """Return a watcher, which may read all there is."""
    return Block(name, f'{HERE}:{make}', WATCH, reads=reads, executable='', **more)


@settings
class Knob:
    """A setting that counts how often it is made."""

    gain: float = param(1.0, 'A gain [1].', low=0.0, high=10.0)
    offset: int = param(0, 'An offset [1].', low=0)

    def __post_init__(self):
        counted(type(self).__name__)


@settings
class Lever(Knob):
    """Another one."""


@settings
class Common:
    """Shared by all nodes."""

    radius_m: float = param(2.0, 'A radius [m].', above=0.0)

    def __post_init__(self):
        counted('Common')


MADE = {}                       # settings objects made, by class
BESIDE = []                     # blocks that `mission` was given last


def counted(name):
    MADE[name] = MADE.get(name, 0) + 1


def mission(*blocks, parts=None, checked=(), name='toy'):
    """Return a scenario of a mission with these blocks beside plant, sensor and guard."""
    BESIDE[:] = blocks
    made = Mission(
        name=name, title='A toy.',
        shared=(Shared('run', 'rvd_dynamics.diagram.run:Run'),
                Shared('common', f'{HERE}:Common', 'common.')),
        sections={'knob': f'{HERE}:Knob', 'lever': f'{HERE}:Lever'},
        parts=parts or {}, checked=checked, diagram=f'{HERE}:diagram', judge=f'{HERE}:Judge')
    return Scenario('toy', made, {'/**': {'timeout_s': 10.0, 'mission': name}}).check()


def diagram(scenario):
    """Return the diagram of the blocks that `mission` was given last."""
    return Diagram((PLANT, SENSOR, GUARD, *BESIDE), 'plant', 'guard',
                   THRUST.name)


@dataclass
class Flown:
    """What a toy run leaves."""

    batch: object
    heard: dict


def fly(*blocks, runs=(0,), **more):
    """Fly toy blocks."""
    Ear.heard.clear()
    return Flown(in_process.fly(mission(*blocks), runs, **more), dict(Ear.heard))
