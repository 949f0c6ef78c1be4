"""
What a mission tells the console: how it is displayed, and what is derived for the page.

A mission subclasses `MissionDisplay` and overrides what applies to it. Everything here runs on
the ground: it sees what came down the link and nothing else.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.block import GROUND, ONBOARD
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.display import DERIVED, Display, TRUTH
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Signal, VALUES
from rvd_dynamics.link.signals import FRAME
from rvd_groundstation.console.decode import COMMANDS, Sample
from rvd_groundstation.console.plain import plain_display
from rvd_groundstation.console.protocol import Stick

PILOT = '/joy'                  # signal of the command that the stick means


@dataclass(frozen=True)
class RunFacts:
    """What a page is told of a run once: its time grid, its delays, how it is flown."""

    step_ns: int                # base step
    forward_steps: int          # delay of the forward link
    back_steps: int             # of the back link
    timeout_s: float = 0.0      # the run ends at the latest then
    mode: str = 'auto'          # at the start
    operator: str = 'none'
    seed: int = 0
    pace: float = 1.0           # simulated seconds per second of wall time
    acknowledged: bool = True   # telemetry says which commands were accepted

    @property
    def last_step(self) -> int:
        """First step at or after the time limit: no run is longer."""
        return -(-round(self.timeout_s * 1e9) // self.step_ns)

    @property
    def step_s(self) -> float:
        """Base step [s]."""
        return self.step_ns / 1e9

    @property
    def forward_s(self) -> float:
        """Delay of the forward link [s]."""
        return self.forward_steps * self.step_ns / 1e9

    @property
    def back_s(self) -> float:
        """Delay of the back link [s]."""
        return self.back_steps * self.step_ns / 1e9


class MissionDisplay:
    """The display of one run, and what goes with it; this one derives nothing."""

    # Nodes whose events a page hears: those on the ground. What the craft or the judge says has
    # not come down the link.
    heard_nodes: tuple[str, ...] = ('console',)
    # Signals that `derive` reads although they are not displayed.
    derives_from: tuple[str, ...] = ()

    def __init__(self, facts: RunFacts, display: Display) -> None:
        self.facts, self.display = facts, display
        self._joys: dict[str, tuple[Sequence[float], Sequence[int]]] = {}

    def derive(self, newest: Mapping[str, Sample]) -> dict[str, Any]:
        """
        Return the parts of the signal `derived`: numbers, points, rows of points, words.

        `newest` holds the newest sample of each signal. Called once for each new frame, so it
        may take some tenths of a millisecond; what is unknown is None.
        """
        return {}

    def measured(self, state: list[float]) -> dict[str, Any]:
        """Return the state that came down the link as the parts that are displayed."""
        return {'state': state}

    def sent(self, sample: Sample) -> None:
        """Take in a command: called for each that is sent, where `derive` sees the newest alone."""

    def beside(self, shown: Mapping[str, Mapping[str, Any]], truth: Mapping[str, Any]
               ) -> dict[str, Any]:
        """
        Return more parts of the truth, for a frame of a review.

        `shown` holds the parts of each signal in that frame, `truth` those of the truth.
        """
        return {}

    def joy(self, deflection: Sequence[float], held: bool
            ) -> tuple[list[float], list[int]] | None:
        """Return axes and buttons of the Joy for a stick; None: nothing is to be said."""
        controller = self.display.controller
        if controller is None:
            return None
        return [float(a) for a in deflection[:len(controller.axes)]], [int(held)]

    @property
    def sticks(self) -> tuple[str, ...]:
        """Topics of the Joy that the hand controller publishes."""
        controller = self.display.controller
        return tuple(hand.topic for hand in controller.hands) if (
            controller is not None and controller.hands) else (PILOT,)

    def joys(self, stick: Stick) -> dict[str, tuple[list[float], list[int]]]:
        """Return axes and buttons of each Joy by its topic; what is not there says nothing."""
        controller = self.display.controller
        if controller is None or not controller.hands:
            made = self.joy(stick.deflection, stick.held)
            return {} if made is None else {PILOT: made}
        at = dict(zip((axis.name for axis in controller.axes), stick.deflection))
        down = dict(zip((button.name for button in controller.buttons), stick.buttons))
        return {hand.topic: ([float(at[name]) for name in hand.axes],
                             [int(stick.held), *(int(stick.held and down.get(name, False))
                                                 for name in hand.buttons)])
                for hand in controller.hands}

    def heard_joy(self, topic: str, axes: Sequence[float], buttons: Sequence[int]
                  ) -> tuple[list[float], bool]:
        """Return the command that the newest Joy of each topic mean together, as `pilot`."""
        controller = self.display.controller
        if controller is None or not controller.hands:
            return self.pilot(axes, buttons)
        self._joys[topic] = axes, buttons
        at, held = {}, False
        for hand in controller.hands:
            given, pressed = self._joys.get(hand.topic, ((), ()))
            at.update(zip(hand.axes, given))
            held = held or (len(pressed) > 0 and pressed[0] == 1)
        return self.pilot([at.get(axis.name, 0.0) for axis in controller.axes], [int(held)])

    def pilot(self, axes: Sequence[float], buttons: Sequence[int]) -> tuple[list[float], bool]:
        """Return the command that a Joy means, and whether it is valid."""
        shown = self.display.commands.axes
        if len(axes) < len(shown) or not all(-1.0 <= a <= 1.0 for a in axes) or not any(buttons):
            return [0.0] * len(shown), False
        return [axis.highest * a for axis, a in zip(shown, axes)], True


def facts_of(scenario: Scenario) -> RunFacts:
    """Return what a page is told of a run once."""
    run = scenario.run
    legs, operation = _part(scenario, 'legs'), _part(scenario, 'operation')
    return RunFacts(
        run.step_ns, getattr(legs, 'forward', 0), getattr(legs, 'back', 0), run.timeout_s,
        getattr(operation, 'mode', 'auto'), getattr(operation, 'operator', 'none'), run.seed,
        run.pace_factor, acknowledges(scenario.diagram))


def acknowledges(diagram: Diagram) -> bool:
    """
    Say whether what comes down can tell which commands were accepted.

    The guard alone knows, so who writes the downlink must read what the guard writes.
    """
    senders = [diagram.writer_of.get(read.signal.name) for leg in diagram.legs()
               for read in leg.reads.values()]
    return any(diagram.thrust in {read.signal.name for read in sender.reads.values()}
               for sender in senders if sender is not None and sender.segment != GROUND)



def _part(scenario: Scenario, name: str) -> Any:
    try:
        return scenario.part(name)
    except LookupError:                         # this mission has no such thing
        return None


def display_of(scenario: Scenario) -> MissionDisplay:
    """
    Return what the mission of a scenario tells the console.

    The mission names a `MissionDisplay`, or a function that returns one or a `Display`; either is
    given what its parameters name: `facts` (`RunFacts`), and parts of the scenario. A mission that
    names none is shown with instruments alone.

    Raises
    ------
    ValueError
        If it cannot be made, or shows what is not on the ground; one line.
    """
    mission, facts = scenario.mission, facts_of(scenario)
    if not mission.display:
        return MissionDisplay(facts, plain_display(scenario))
    provider = made(mission.display,
                    lambda name: facts if name == 'facts' else scenario.part(name),
                    f'mission {mission.name}: display')
    if isinstance(provider, Display):           # nothing is derived
        provider = MissionDisplay(facts, provider)
    _check(mission.name, provider, scenario.diagram)
    return provider


def on_ground(diagram: Diagram) -> dict[str, Signal]:
    """
    Return the signals that the ground has, by topic: what its blocks read and write.

    A mission without a ground segment is watched as over a link without delay: there it is what
    the blocks on board read and write.
    """
    segment = GROUND if has_ground(diagram) else ONBOARD
    found = {}
    for block in diagram.blocks:
        if block.segment == segment:
            found |= {read.signal.name: read.signal for read in block.reads.values()}
            found |= {signal.name: signal for signal in block.writes.values()}
    return found


def has_ground(diagram: Diagram) -> bool:
    """Say whether a diagram has a ground segment, and with it a link."""
    return any(block.segment == GROUND for block in diagram.blocks)


def _check(mission: str, provider: MissionDisplay, diagram: Diagram) -> None:
    """Refuse a display of what the ground does not have."""
    known, ground = on_ground(diagram), has_ground(diagram)
    display = provider.display
    wanted = {*display.parts(), *provider.derives_from} - {DERIVED, TRUTH, PILOT, *provider.sticks}
    for topic in sorted(wanted - set(known)):
        raise BadInput(f'mission {mission}: its display shows {topic}, which is not on the '
                       f'ground; there are: {", ".join(sorted(known))}')
    for field, topic, kinds in (('measured', display.measured, (FRAME,) if ground else (VALUES,)),
                                ('commands.sent', display.commands.sent, tuple(COMMANDS))):
        if known[topic].message not in kinds:
            raise BadInput(f'mission {mission}: its display has {topic} as {field}, which must '
                           f'be a {" or ".join(kinds)}, not a {known[topic].message}')
