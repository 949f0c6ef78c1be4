"""
The node `joystick`: the stick that is plugged into this machine, as `joy_node` would publish it.

Publishes   /joy    sensor_msgs/Joy
Parameters  the fields of JoystickParams, those of `joy_node`

It may start before the stick is plugged in, and the stick may be unplugged and plugged in again:
that is said in an event and in /diagnostics. Without a stick it publishes nothing, so that the
readers find theirs too old.

In a run stamps are simulation instants, so that a recorded stick is a tape with the run's own
time; by itself (`./rvd node rvd_groundstation joystick`) it stamps the wall clock.
"""

import sys
import time
from typing import Any

from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Joy

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.arguments import parsed
from rvd_dynamics.diagram.ros.conversions import header_at, ns_of
from rvd_dynamics.diagram.ros.horizon import Horizon
from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.node import RunNode
from rvd_dynamics.diagram.ros.process import run
from rvd_groundstation.joystick.device import Device, Reading
from rvd_groundstation.joystick.messages import Messages
from rvd_groundstation.joystick.params import JoystickParams

NAME = 'joystick'
POLL_S = 0.005                  # [s] wall time between two looks at the device
DIAGNOSE_EVERY = 20             # looks


class Joystick(RunNode):
    """Publishes a device as Joy."""

    def __init__(self, host: Host) -> None:
        super().__init__(host, NAME)
        settings: JoystickParams = self.scenario.settings(NAME)
        self._device = Device(settings.device_id, settings.device_name)
        self._messages = Messages(settings)
        self._joy = self.writer('/joy', Joy, qos.HELD_STICK)
        self._horizon = Horizon(self.run, self.run.last_step)
        self._in_a_run = NAME in self.roster.names
        self._heard_clock: tuple[int, float] | None = None    # [ns], wall time at which it came [s]
        self._stamp_ns = -1
        self._there: bool | None = None
        self._looks = 0
        if self._in_a_run:
            self.watch('/clock', Clock, self._on_clock)
        self.create_timer(POLL_S, self.guarded(self._look))

    def _on_clock(self, message: Any) -> None:
        step = ns_of(message.clock)//self.run.step_ns
        if step < self.step or not self._horizon.believes(step, self.step):
            self.refuse('/clock', self._horizon.words(step, self.step))
            return
        self._heard_clock = (ns_of(message.clock), time.monotonic())
        self.step = step

    def _look(self) -> None:
        reading = self._device.poll()
        if (reading is not None) != self._there:
            self._say(reading)
        if reading is not None:
            due = self._messages.due(reading, time.monotonic())
            if due is not None:
                self._joy.publish(Joy(header=header_at(self._stamp(), 'joy'), axes=due.axes,
                                      buttons=due.buttons))
        self._looks += 1
        if self._looks % DIAGNOSE_EVERY == 0:
            self.host.diagnose()

    def _say(self, reading: Reading | None) -> None:
        """Say that the stick has come or gone."""
        first, self._there = self._there is None, reading is not None
        if reading is not None:
            self.trouble.pop('device', None)
            text, code = (f'stick {self._device.name!r}: {len(reading.axes)} axes, '
                          f'{len(reading.buttons)} buttons'), 'DEVICE'
        else:
            self._messages.lost()
            lost = self._device.why_not()
            self.trouble['device'] = lost if first else f'the stick has gone: {lost}'
            text, code = self.trouble['device'], 'DEVICE_LOST'
        self.event(code, text)
        print(f'{NAME}: {text}', flush=True)

    def _stamp(self) -> int:
        """Return the instant of a Joy [ns], after that of the one before."""
        if not self._in_a_run:
            now = time.time_ns()
        elif self._heard_clock is None:
            now = 0
        else:
            since = (time.monotonic() - self._heard_clock[1]) * self.run.pace_factor
            now = self._heard_clock[0] + int(min(since * NS_PER_S, 0.999 * self.run.step_ns))
        self._stamp_ns = max(now, self._stamp_ns + 1)
        return self._stamp_ns

    def close(self) -> None:
        """Give the device back."""
        self._device.close()


def main() -> None:
    """Drive the stick of this machine until the run is over."""
    try:
        arguments = parsed(sys.argv)
    except BadInput as error:
        print(f'{NAME}: {error}', file=sys.stderr)
        sys.exit(2)
    run(Joystick, arguments, sys.argv)


if __name__ == '__main__':
    main()
