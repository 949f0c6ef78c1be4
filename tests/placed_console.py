"""
The page of the lunar approach, without a graph: the craft is where the test puts it.

`PlacedConsole` serves the page with the real server and feeds it as the console's node would, with
what `state` and `ahead` say. `WaitingFor` serves the page of any scenario before its first run.
"""

import asyncio
import math

from rvd_dynamics.commands.codes import BY_AUTO, KIND_THRUST, REASON_MODE
from rvd_dynamics.diagram.display import as_data
from rvd_dynamics.diagram.scenario import parse
from rvd_groundstation.console.decode import Heard, Sample
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.provider import display_of, MissionDisplay
from toy_console import ToyConsole

SCENARIO = '''
/**: {ros__parameters: {operator: console, step_s: 0.1, forward_delay_s: 0.5, back_delay_s: 0.5}}
'''
ESTIMATE, PREDICTION, SCORE, COMMAND = (
    f'/ground/{name}' for name in ('estimate', 'prediction', 'prediction_score', 'command'))
GOOD = (-12.0, 0.1, -0.05, 0.25, 0.002, -0.001)         # x, y, z [m], rates [m/s]


class PlacedConsole(ToyConsole):
    """A page whose craft stands still wherever it is put, however fast it says it is."""

    def __init__(self) -> None:
        self.state = self.ahead = GOOD
        self.comes_down, self.reason, self.by = True, REASON_MODE, BY_AUTO
        super().__init__()

    def provider_of(self) -> MissionDisplay:
        return display_of(parse(SCENARIO, 'test'))

    def hub_of(self) -> Hub:
        return Hub(display=as_data(self.provider_of().display))

    async def _fly(self) -> None:
        facts = self.provider.facts
        self.hub.begin('placed', self.provider, self)
        for k in range(100_000):
            t, back, ahead = k*facts.step_s, facts.back_s, facts.forward_s
            if k >= facts.back_steps and self.comes_down:
                self.hub.post('telemetry', Heard(
                    Sample(k, t - back, True, self.provider.measured(list(self.state)), t, back),
                    round((t - back)*1e9), max(k - facts.back_steps - facts.forward_steps, 0), 0))
                self.hub.post('signal', ESTIMATE, state(k, t - back, self.state))
                self.hub.post('signal', PREDICTION, state(k, t + ahead, self.ahead))
                self.hub.post('signal', SCORE, Sample(k, t - back, True, {
                    'error': [0.01*math.sin(k/7 + i) for i in range(6)],
                    'sigma': [0.004*(i + 1) for i in range(6)], 'rms': [0.01]*6}))
            self.hub.post('command', Sample(k, t, True, {
                'value': [0, 0, 0], 'kind': KIND_THRUST, 'by': self.by, 'weight': math.nan,
                'reason': self.reason, 'sequence': k + 1}))
            await asyncio.sleep(facts.step_s)

    def joy(self, stick) -> list[float]:
        made = self.provider.joy(stick.deflection, stick.held)
        return [0.0]*3 if made is None else self.provider.pilot(*made)[0]

    def put(self, state, ahead=None) -> None:
        """Put the craft, as measured and as predicted."""
        self.state = tuple(state)
        self.ahead = self.state if ahead is None else tuple(ahead)


class WaitingFor(ToyConsole):
    """The page of a scenario before its first run."""

    def __init__(self, text: str) -> None:
        self._text = text
        super().__init__()

    def provider_of(self) -> MissionDisplay:
        return display_of(parse(self._text, 'test'))

    def hub_of(self) -> Hub:
        return Hub(display=as_data(self.provider_of().display))

    async def _fly(self) -> None:
        pass


def state(step: int, t: float, numbers) -> Sample:
    return Sample(step, t, True, {'position': list(numbers[:3]), 'velocity': list(numbers[3:]),
                                  'sigma': [0.02]*3 + [0.002]*3})
