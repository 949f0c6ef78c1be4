"""
A mission for tests: a point mass on one axis with its sensor, law and guard on board, at any rates.

Every block notes what it was given. Settings choose periods and delays, and what a block does
wrong at which step.
"""

import time
from typing import Any

import numpy as np

from rvd_dynamics.diagram.block import Block, last, now, ONBOARD, Read, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.judge import Verdict
from rvd_dynamics.diagram.mission import Mission, Shared
from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.diagram.streams import Normals

FAULTS = ('none', 'nan', 'inf', 'shape', 'missing', 'extra', 'nothing', 'raises', 'sleeps',
          'number')
TRUTH = Signal('/truth/toy', (Part('state', (2,), 'm, m/s'), Part('final', (), '', '?')),
               truth=True)
MEASURED = Signal('/onboard/measured', (Part('state', (2,), 'm, m/s'),))
WANTED = Signal('/onboard/wanted', (Part('command', (1,), 'm/s^2'), Part('count', (), '', 'i8')))
THRUST = Signal('/onboard/thrust', (Part('command', (1,), 'm/s^2', initial=0.0),))


@settings
class Toy:
    """Rates of the blocks, and what goes wrong."""

    sensor_period: int = param(1, 'Steps between two measurements.', low=1, high=100)
    law_period: int = param(1, 'Steps between two wishes of the law.', low=1, high=100)
    guard_period: int = param(1, 'Steps between two commands of the guard.', low=1, high=100)
    measured_delay: int = param(0, 'Age of the measurement that the law sees.', low=0, high=100)
    wanted_delay: int = param(0, 'Age of the wish that the guard sees.', low=0, high=100)
    truth_delay: int = param(0, 'Age of the truth that the sensor sees.', low=0, high=100)
    fault: str = param('none', 'What goes wrong.', choices=FAULTS)
    fault_block: str = param('law', 'Where it goes wrong.')
    fault_step: int = param(0, 'When it goes wrong.', low=0)


MISSION = Mission(
    name='toy', title='A point mass comes to rest.',
    shared=(Shared('run', 'rvd_dynamics.diagram.run:Run'),
            Shared('toy', f'{__name__}:Toy', 'toy.')),
    sections={'bag_recorder': 'rvd_dynamics.recording.params:RecorderParams'},
    parts={'form': f'{__name__}:form'}, diagram=f'{__name__}:diagram', judge=f'{__name__}:Judge')
LOG: dict[tuple[str, int], bytes] = {}          # (block, step): what it was given


def form() -> None:
    """Nothing of this mission goes over the link."""


def scenario(**values: Any) -> Scenario:
    """Return a scenario; keys of `toy.` are given without the prefix."""
    keys = {key if key in ('timeout_s', 'step_s', 'seed', 'pace', 'pace_factor', 'processes',
                           'nodes')
            else f'toy.{key}': value for key, value in values.items()}
    return Scenario('toy', MISSION, {'/**': {'timeout_s': 20.0, **keys}}).check()


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks: plant -> sensor -> law -> guard -> plant."""
    toy = scenario.part('toy')
    return Diagram((
        Block('plant', f'{__name__}:Plant', WORLD, reads={'thrust': last(THRUST)},
              writes={'truth': TRUTH}, draws={'noise': Normals('toy/plant/noise', 2)}),
        Block('sensor', f'{__name__}:Sensor', WORLD, period=toy.sensor_period,
              reads={'truth': Read(TRUTH, toy.truth_delay)}, writes={'measured': MEASURED}),
        Block('law', f'{__name__}:Law', ONBOARD, period=toy.law_period,
              reads={'measured': Read(MEASURED, toy.measured_delay)}, writes={'wanted': WANTED}),
        Block('guard', f'{__name__}:Guard', ONBOARD, period=toy.guard_period,
              reads={'wanted': Read(WANTED, toy.wanted_delay), 'measured': last(MEASURED)}
              if toy.wanted_delay else {'wanted': now(WANTED)}, writes={'thrust': THRUST}),
    ), 'plant', 'guard', THRUST.name)


class Noting:
    """Notes its inputs and goes wrong as the settings say."""

    name = ''

    def __init__(self, toy: Toy, run: Run) -> None:
        self.toy, self.run, self.fired = toy, run, []

    def step(self, k: int, **inputs: Any) -> Any:
        """Note, compute, spoil."""
        numbers = [np.ravel(np.asarray(part, dtype=float)) for name in sorted(inputs)
                   for part in inputs[name]]
        LOG[self.name, k] = np.concatenate(numbers).tobytes()
        outputs = self.compute(k, **inputs)
        toy = self.toy
        spoilt = self.name == toy.fault_block and k >= toy.fault_step and toy.fault != 'none'
        return spoil(outputs, toy.fault) if spoilt else outputs


def spoil(outputs: dict[str, Any], fault: str) -> Any:
    """Return outputs that are not what the block says it writes."""
    (name, value), = outputs.items()
    first = value[0]
    if fault == 'raises':
        raise RuntimeError('the block is broken')
    if fault == 'sleeps':
        time.sleep(0.01)
        return outputs
    if fault in ('missing', 'extra', 'nothing'):
        return {'missing': {}, 'extra': {**outputs, 'more': value}, 'nothing': None}[fault]
    if fault == 'number':
        return {name: float(np.ravel(first)[0])}
    spoilt = (np.repeat(first, 2, axis=-1) if fault == 'shape'
              else np.full(first.shape, float(fault)))
    return {name: value._replace(**{value._fields[0]: spoilt})}


class Plant(Noting):
    """x'' = a, with noise."""

    name = 'plant'

    def __init__(self, toy: Toy, run: Run, noise: np.ndarray, batch: tuple) -> None:
        super().__init__(toy, run)
        self._noise = noise
        self._state = np.zeros((*batch, 2)) + (-3.0, 0.0)

    def compute(self, k: int, thrust: Any) -> dict[str, Any]:
        x, v = self._state[..., 0], self._state[..., 1]
        h, a = self.run.step_s, thrust.command[..., 0]
        if k:
            self._state = np.stack([x + h * v, v + h * a], axis=-1) + 0.01 * self._noise[..., k, :]
        over = np.full(self._state.shape[:-1], k >= self.run.last_step)
        return {'truth': TRUTH(state=self._state, final=over)}


class Sensor(Noting):
    """The truth as it is."""

    name = 'sensor'

    def compute(self, k: int, truth: Any) -> dict[str, Any]:
        return {'measured': MEASURED(state=truth.state)}


class Law(Noting):
    """Wants to be at rest at 0."""

    name = 'law'

    def compute(self, k: int, measured: Any) -> dict[str, Any]:
        known = np.where(np.isfinite(measured.state), measured.state, 0.0)
        wanted = -0.1 * known[..., :1] - 0.4 * known[..., 1:]
        return {'wanted': WANTED(command=wanted, count=np.full(wanted.shape[:-1], k))}


class Guard(Noting):
    """Lets everything through, one direction first."""

    name = 'guard'

    def compute(self, k: int, wanted: Any, measured: Any = None) -> dict[str, Any]:
        command = np.where(np.isfinite(wanted.command), wanted.command, 0.0)
        return {'thrust': THRUST(command=np.clip(command, -1.0, 1.0))}


class Judge:
    """Says that it was over."""

    measures = ()
    reasons = {'over': 'time is over'}

    def __init__(self, batch: tuple = ()) -> None:
        self._k = np.zeros(batch)

    def follow(self, k: int, truth: Any) -> None:
        self._k = np.where(truth.final, k, self._k)

    def verdict(self, final: bool = False) -> Verdict:
        return Verdict(self._k > 0, np.where(self._k > 0, 'over', ''), self._k, {})
