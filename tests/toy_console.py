"""
A mission that the console has never heard of, on its page, without a graph.

A cart on a rail: one axis, a box, two instruments, a command of one component in newtons. No
corridor, no camera, no prediction. `ToyConsole` serves the page with the real server and feeds
it as the console's node would.
"""

import asyncio
from collections.abc import Iterator
from contextlib import contextmanager
import math
from pathlib import Path
import threading

from rvd_dynamics.commands.codes import KIND_THRUST
from rvd_dynamics.diagram.display import (
    as_data, Axis, Body, Box, CommandAxis, CommandRow, Commands, Controller, Display, Instrument,
    Instruments, Line, Number, Perspective, Reading, Ref, Trail)
from rvd_dynamics.diagram.scenario import parse
from rvd_groundstation.console.decode import Heard, Sample
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.provider import display_of, MissionDisplay, RunFacts
from rvd_groundstation.console.server import Address, Server

STEP_S = 0.1
BACK_STEPS, FORWARD_STEPS = 5, 10
RAIL, PUSH = '/toy/telemetry', '/toy/command'
STRONGEST = 0.5                 # [N]


class ToyDisplay(MissionDisplay):
    """What the cart's mission tells the console."""

    def __init__(self) -> None:
        facts = RunFacts(round(STEP_S * 1e9), FORWARD_STEPS, BACK_STEPS, timeout_s=60.0)
        super().__init__(facts, Display(
            measured=RAIL,
            bodies=(Body('cart', 'measured', (Box((1.0, 0.6, 0.6)),), Ref(RAIL, 'x'), axes='x',
                         label='cart'),),
            lines=(Line('rail', 'plain', ((-5.0, -0.3, 0.0), (5.0, -0.3, 0.0))),
                   Trail('been', 'measured', Ref(RAIL, 'x'), axes='x')),
            views=(Perspective('Rail', distance_m=12.0),),
            stars=False,
            instruments=Instruments('Cart', (
                Instrument('position', 'm', (Reading('plain', Number(RAIL, 'x')),)),
                Instrument('speed', 'mm/s', (Reading(
                    'plain', Number(RAIL, 'v', factor=1000.0), -400.0, 400.0),), 0))),
            commands=Commands('Force', (CommandAxis('push', STRONGEST),), PUSH,
                              (CommandRow('sent', 'sent', Ref(PUSH, 'value')),), 2, 'N'),
            controller=Controller((Axis('x', 'right', 'left', (('KeyD', 'KeyA'),)),)),
            modes=()))


def place_at(t: float) -> float:
    """Return where the cart is [m]."""
    return 2.0 * math.sin(0.2 * t)


def telemetry(step: int) -> Heard:
    """Return what comes down in `step`: the cart of BACK_STEPS ago."""
    generated = step - BACK_STEPS
    t = generated * STEP_S
    sample = Sample(step, t, True, {'x': place_at(t), 'v': 0.4 * math.cos(0.2 * t), 'hidden': 7.0},
                    received=step * STEP_S, transit=BACK_STEPS * STEP_S)
    accepted = max(generated - FORWARD_STEPS, 0)        # nothing is lost here
    return Heard(sample, round(t * 1e9), accepted, 0)


def command(step: int) -> Sample:
    """Return the command that is sent in `step`."""
    value = STRONGEST * math.sin(0.5 * step * STEP_S)
    return Sample(step, step * STEP_S, True, {
        'value': [round(value, 3)], 'kind': 0, 'by': 2, 'weight': math.nan, 'reason': 0,
        'sequence': step + 1})


VERDICT = {'success': True, 'reason': 'arrived', 'words': 'arrived at the buffer',
           'duration': 12.3, 'measures': [
               {'name': 'bump_m_s', 'words': 'speed at the buffer', 'unit': 'm/s', 'value': 0.02,
                'low': None, 'high': 0.1, 'ok': True, 'digits': 3},
               {'name': 'late_s', 'words': 'delay', 'unit': 's', 'value': None, 'low': None,
                'high': None, 'ok': True, 'digits': 1}]}


class ToyConsole:
    """The page of the cart, served by a thread; `url` is what to open."""

    stands = False                          # makes no step
    port = 0                                # any free one
    decision: dict = {}                     # parts of each command sent, in the place of its own

    def __init__(self, runs: Path | None = None) -> None:
        self._runs = runs
        self.hub, self.sticks, self.provider = self.hub_of(), [], self.provider_of()
        self.answers, self.asked = True, []
        self.kind = KIND_THRUST             # of the commands sent; telemetry falls silent at others
        self._loop = asyncio.new_event_loop()
        self._over = asyncio.Event()
        up = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(up,), daemon=True)
        self._thread.start()
        assert up.wait(10.0)

    def hub_of(self) -> Hub:
        return Hub()

    def provider_of(self) -> MissionDisplay:
        return ToyDisplay()

    def _run(self, up: threading.Event) -> None:
        self._loop.run_until_complete(self._serve(up))

    async def _serve(self, up: threading.Event) -> None:
        server = Server(self.hub, Address(port=self.port), self._runs)
        self.url = await server.start()
        self.watch_url = server.access.watch_url
        flying = asyncio.create_task(self._fly())
        up.set()
        await self._over.wait()
        flying.cancel()
        await server.stop()

    async def _fly(self) -> None:
        self.hub.begin('cart', self.provider, self)
        for step in range(100_000):
            while self.stands:
                await asyncio.sleep(STEP_S)
            sent = command(step)
            if step >= BACK_STEPS and self.kind == KIND_THRUST:
                self.hub.post('telemetry', telemetry(step))
            sent.parts |= {'kind': self.kind, **self.decision}
            self.hub.post('command', sent)
            await asyncio.sleep(STEP_S)

    # -- as the graph is for the hub --------------------------------------------------------

    def joy(self, stick) -> list[float]:
        axes, buttons = self.provider.joy(stick.deflection, stick.held)
        value, valid = self.provider.pilot(axes, buttons)
        self.sticks.append((value, valid))
        return value

    def control(self, action, mode, reply) -> None:
        self.asked.append(action)
        if self.answers:
            reply(True, action)

    def event(self, code, text) -> None:
        pass

    # -- from the test ------------------------------------------------------------------------

    @contextmanager
    def silent(self) -> Iterator[None]:
        """Let the server say and hear nothing, with all its connections open."""
        go_on = threading.Event()
        self._loop.call_soon_threadsafe(go_on.wait)
        try:
            yield
        finally:
            go_on.set()

    def finish(self) -> None:
        """Let the run end with its verdict."""
        self.hub.post('final', VERDICT)

    def cut(self) -> None:
        """Let the connection of each page break."""
        for client in list(self.hub.pages.clients):
            self._loop.call_soon_threadsafe(client.cut)

    def close(self) -> None:
        self._loop.call_soon_threadsafe(self._over.set)
        self._thread.join(10.0)


class WaitingConsole(ToyConsole):
    """The page of the lunar approach before the first run."""

    def hub_of(self) -> Hub:
        scenario = parse('/**: {ros__parameters: {}}', 'test')
        return Hub(display=as_data(display_of(scenario).display))

    async def _fly(self) -> None:
        pass
