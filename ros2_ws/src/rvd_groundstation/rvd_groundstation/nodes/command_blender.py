"""
ROS shell of command sharing, and the sender of the uplink.

Fires on    /joy k                   sensor_msgs/Joy, if the pilot is stepped
            /ground/auto_command k   rvd_interfaces/ThrustCommand
Watches     /joy                     if the stick is held: the newest counts
Publishes   /ground/command k        rvd_interfaces/ThrustCommand: who decided, weight, why
            /ground/uplink k         rvd_interfaces/LinkFrame
            /run/pause               std_msgs/Bool, latched
Serves      /run/control             rvd_interfaces/RunControl
Parameters  the fields of BlenderParams
"""

import numpy as np
from sensor_msgs.msg import Joy
from std_msgs.msg import Bool

from rvd_dynamics.commands.codes import BY_PILOT, KIND_ABORT, KIND_THRUST, REASON_ABORT
from rvd_dynamics.link.frame import pack_command
from rvd_dynamics.mission import MODES
from rvd_dynamics.diagram.ros.conversions import header_at
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_dynamics.commands.levels import stick_levels
from rvd_groundstation.nodes.stick import HeldStick
from rvd_groundstation.settings import BlenderParams
from rvd_groundstation.sharing import decide
from rvd_interfaces.msg import LinkFrame, ThrustCommand
from rvd_interfaces.srv import RunControl

NEUTRAL = np.zeros(3, dtype=np.int8)


class CommandBlender(StepNode):
    """Command sharing as a node."""

    def __init__(self) -> None:
        super().__init__('command_blender')
        self._sharing = self.settings(BlenderParams).selected
        self._mode = self.mission.mode
        self._abort = False
        self._stick = HeldStick()
        self._stepped = ('/joy', 0) in self.spec.fires_on
        if self._stepped:
            self.step_input('/joy', Joy)
        elif '/joy' in self.spec.watches:
            self.watch('/joy', Joy, self._stick.take)
        self.step_input('/ground/auto_command', ThrustCommand, early=self._stepped)
        self._command = self.step_output('/ground/command', ThrustCommand)
        self._uplink = self.step_output('/ground/uplink', LinkFrame)
        self._pause = self.writer('/run/pause', Bool)
        self.create_service(RunControl, '/run/control', self._control)

    def on_step(self, step: int, *inputs) -> None:
        """Blend and send."""
        joy, auto = inputs if self._stepped else (self._stick.newest(), *inputs)
        pilot, pilot_valid = NEUTRAL, False
        if joy is not None:
            pilot, pilot_valid = stick_levels(joy.axes, joy.buttons, self.mission.stick)
        auto_valid = auto is not None and auto.valid
        automatic = np.array(auto.levels, dtype=np.int8) if auto_valid else NEUTRAL
        d = decide(self._mode, self._sharing, pilot, pilot_valid, automatic, auto_valid)
        self._send(step, d)

    def _send(self, step: int, d) -> None:
        mission, kind = self.mission, KIND_ABORT if self._abort else KIND_THRUST
        levels = NEUTRAL if self._abort else d.levels
        acts_ns = (step + mission.forward_steps) * mission.step_ns
        now = step * mission.step_ns
        self._uplink.publish(LinkFrame(
            step=step, sequence=step + 1, sent=now, arrived=-1, released=-1,
            expedited=self._abort,
            payload=pack_command(sequence=step + 1, generated_ns=now, kind=kind,
                                 levels=levels.tolist())))
        self._command.publish(ThrustCommand(
            header=header_at(acts_ns, mission.frame_id), step=step, sequence=step + 1, kind=kind,
            levels=levels, valid=True,
            decided_by=BY_PILOT if self._abort else int(d.decided_by),
            pilot_weight=float(d.pilot_weight),
            reason=REASON_ABORT if self._abort else int(d.reason)))

    # -- control --------------------------------------------------------------------------

    def _control(self, request: RunControl.Request, response: RunControl.Response
                 ) -> RunControl.Response:
        response.accepted = True
        if request.action in (RunControl.Request.PAUSE, RunControl.Request.RESUME):
            pause = request.action == RunControl.Request.PAUSE
            self._pause.publish(Bool(data=pause))
            response.message = 'paused' if pause else 'resumed'
        elif request.action == RunControl.Request.MODE and request.mode in MODES:
            self._mode = request.mode
            response.message = f'mode {request.mode}'
            self.event('MODE', response.message)
        elif request.action == RunControl.Request.ABORT:
            self._abort = True
            response.message = 'abort goes out with the next frame'
            self.event('ABORT', response.message)
        else:
            response.accepted = False
            response.message = (f'mode must be one of {", ".join(MODES)}, got {request.mode!r}'
                                if request.action == RunControl.Request.MODE
                                else f'unknown action {request.action}')
        return response


def main(args=None) -> None:
    """Run the node."""
    run(CommandBlender, args)
