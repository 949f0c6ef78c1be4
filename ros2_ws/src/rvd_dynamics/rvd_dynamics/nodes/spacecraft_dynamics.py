"""
ROS shell of the true world; it owns `/clock`, the pacing and the end of the run.

Fires on    /onboard/thruster_command k-1   rvd_interfaces/ThrustCommand
Publishes   /truth/relative_state k         rvd_interfaces/RelativeState, SOURCE_TRUTH
            /clock                          rosgraph_msgs/Clock
            /run/scenario, /run/end         latched
Waits for   /run/ready of every node; in lock step also for the recorder
Parameters  the fields of DynamicsParams, `scenario_file`

lockstep    step k+1 is made when the command of step k is here: as fast as the machine can.
realtime    step k is made at k * step_s / pace_factor of wall time, whatever has come.
"""

import time

import numpy as np
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Bool, String, UInt64

from rvd_dynamics.world.plants.relative import TRUTH_MODELS
from rvd_dynamics.diagram.ros import graph
from rvd_dynamics.diagram.ros.conversions import UNKNOWN, levels_of, state_to_msg, time_at
from rvd_dynamics.diagram.ros.run import run
from rvd_dynamics.diagram.ros.step_node import StepNode
from rvd_dynamics.world.spacecraft.thrusters import execute
from rvd_dynamics.diagram.streams import execution_normals, start_normals
from rvd_dynamics.judge import ended
from rvd_dynamics.world.settings import DynamicsParams
from rvd_interfaces.msg import RelativeState, ThrustCommand

TICKS_PER_STEP = 8              # how often the wall clock is looked at in real time


class SpacecraftDynamics(StepNode):
    """The world as a node."""

    def __init__(self) -> None:
        super().__init__('spacecraft_dynamics')
        mission = self.mission
        self._params = self.settings(DynamicsParams)
        self._model = TRUTH_MODELS[self._params.truth_model](mission=mission)
        self._noise = execution_normals(mission.seed, mission.run, mission.last_step + 1)
        self._state = self._params.start(mission, start_normals(mission.seed, mission.run))
        self._started = self._paused = False
        self._recorded = None
        self._waiting_for = set(self._names)
        self.step_input('/onboard/thruster_command', ThrustCommand, lag=1)
        self._truth = self.step_output('/truth/relative_state', RelativeState)
        self._clock_out = self.step_output('/clock', Clock)
        self._end = self.writer('/run/end', UInt64)
        self.watch('/run/ready', String, self._on_ready)
        self.watch('/run/pause', Bool, self._on_pause)
        if 'bag_recorder' in self._names:
            self._recorded = -1
            self.watch('/run/recorded_step', UInt64, self._on_recorded)
        self._publish_scenario()

    def _publish_scenario(self) -> None:
        path = self.declare_parameter('scenario_file', '').value
        text = ''
        if path:
            with open(path, encoding='utf-8') as file:
                text = file.read()
        self.writer('/run/scenario', String).publish(String(data=text))

    # -- one step -------------------------------------------------------------------------

    def on_step(self, step: int, command: ThrustCommand | None) -> None:
        """Advance the truth from step - 1 to step and publish it."""
        acceleration = UNKNOWN
        if step > 0:
            acceleration = execute(levels_of(command), self.mission.thrust,
                                   self._noise[step - 1], self._params.execution_noise_fraction)
            self._state = self._model.advance(self._state, acceleration)
        final = bool(ended(step, self._state, self.mission.last_step))
        if final:
            self.final_step = step
            self._end.publish(UInt64(data=step))
        now = step * self.mission.step_ns
        self._truth.publish(state_to_msg(
            step, now, self.mission.frame_id, RelativeState.SOURCE_TRUTH, self._state,
            valid=bool(np.isfinite(self._state).all()), final=final, acceleration=acceleration))
        self._clock_out.publish(Clock(clock=time_at(now)))

    # -- pacing ---------------------------------------------------------------------------

    def _on_ready(self, message: String) -> None:
        self._waiting_for.discard(message.data)
        if self._waiting_for or self._started:
            return
        self._started = True
        if self._realtime:
            self._period = self.mission.step_s / self.mission.pace_factor
            self._origin = time.monotonic()
            self.create_timer(self._period / TICKS_PER_STEP, self._tick)
        self.advance()

    def advance(self) -> None:
        """In lock step, make every step that is due; in real time the clock alone does."""
        if self._started and not self._realtime and not self._paused and not self._too_far():
            super().advance()

    def _too_far(self) -> bool:
        behind = self._recorded is not None and self._next - self._recorded > graph.RECORDER_LEAD
        self.trouble.pop('recorder', None)
        if behind:
            self.trouble['recorder'] = f'waiting for bag_recorder, at step {self._recorded}'
        return behind

    def _tick(self) -> None:
        while (not self._paused and not self.done.done()
               and time.monotonic() - self._origin >= self._next * self._period):
            self._fire()

    def _on_recorded(self, message: UInt64) -> None:
        self._recorded = message.data
        self.advance()

    def _on_pause(self, message: Bool) -> None:
        if message.data == self._paused:
            return
        self._paused = message.data
        self.event('PAUSE' if self._paused else 'RESUME', 'simulation time '
                   + ('stands still' if self._paused else 'goes on'))
        if self._started and self._realtime and not self._paused:
            self._origin = time.monotonic() - self._next * self._period
        self.advance()


def main(args=None) -> None:
    """Run the node."""
    run(SpacecraftDynamics, args)
