"""
Codecs of two hand controllers: each a `sensor_msgs/Joy`, both one command over the link.
"""

from functools import lru_cache
from typing import Any

import numpy as np
from sensor_msgs.msg import Joy

from rvd_dynamics.commands.hand import fault, HandForm, HandParams, joy, read
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.ros.codecs import Codec, Event, too_many
from rvd_dynamics.diagram.ros.frame_codecs import Arrival, Uplink
from rvd_dynamics.diagram.ros.wire import Layout
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.diagram.signal import Signal


class Controller(Codec):
    """
    One hand controller as `sensor_msgs/Joy`: axes 0 to 2, buttons 0 to 2 as `commands.hand` says.

    A Joy has no step: its stamp is the step's instant.
    """

    def __init__(self, signal: Signal, run: Run, hand: HandParams) -> None:
        super().__init__(signal, run)
        self._hand = hand

    def encode(self, k: int, value: Any) -> bytes:
        """Return the serialised message of a value."""
        axes, buttons = joy(value, self._hand)
        return _layout(len(axes), len(buttons)).pack(
            *divmod(k*self.run.step_ns, NS_PER_S), *axes, *buttons)

    def decode(self, k: int, message: Joy) -> Any:
        """Return the value in a message."""
        return self.signal(**read(message.axes, message.buttons, self._hand)._asdict())

    def wired(self, value: Any) -> Any:
        """Return what a reader in the same process gets: a tape has one row for all."""
        return self.signal.type(*(np.asarray(given) for given in value))

    def odd(self, k: int, message: Joy) -> str:
        """Return what is wrong with the numbers of axes and buttons."""
        return too_many(message)

    def fault(self, message: Joy) -> str:
        """Return why a controller is nobody's; nothing if somebody holds it."""
        return too_many(message) or fault(message.axes, message.buttons, self._hand)


@lru_cache(maxsize=4)
def _layout(axes: int, buttons: int) -> Layout:
    return Layout(Joy, {'header.frame_id': 'joy'}, {'axes': axes, 'buttons': buttons})


class HandUplink(Uplink):
    """The command of both hands, as LinkFrame."""

    def __init__(self, signal: Signal, run: Run, hand_form: HandForm) -> None:
        super().__init__(signal, run, hand_form)


class HandArrival(Arrival):
    """The same where it comes in, through a gate."""

    def __init__(self, signal: Signal, run: Run, hand_form: HandForm, legs: Legs, event: Event
                 ) -> None:
        super().__init__(signal, run, hand_form, legs, event)
