"""
The node graph as a table: who writes which topic, who reads it, and who fires on what.

Nodes take their inputs and outputs from here, the start-up barrier counts its endpoints from
here, the recorder its topics. A test holds it against the graph that really comes up. It
imports no ROS, so that tools may read it.

Which node processes a run has is decided in `scripts/bringup.sh` and nowhere else.
"""

from dataclasses import dataclass, field
from typing import Iterable

TOPICS = {
    '/clock': 'rosgraph_msgs/msg/Clock',
    '/truth/relative_state': 'rvd_interfaces/msg/RelativeState',
    '/onboard/measurement': 'rvd_interfaces/msg/RelativeState',
    '/onboard/downlink': 'rvd_interfaces/msg/LinkFrame',
    '/ground/telemetry': 'rvd_interfaces/msg/LinkFrame',
    '/ground/estimate': 'rvd_interfaces/msg/RelativeState',
    '/ground/prediction': 'rvd_interfaces/msg/RelativeState',
    '/ground/prediction_score': 'rvd_interfaces/msg/PredictionScore',
    '/joy': 'sensor_msgs/msg/Joy',
    '/ground/auto_command': 'rvd_interfaces/msg/ThrustCommand',
    '/ground/command': 'rvd_interfaces/msg/ThrustCommand',
    '/ground/uplink': 'rvd_interfaces/msg/LinkFrame',
    '/onboard/command': 'rvd_interfaces/msg/LinkFrame',
    '/onboard/thruster_command': 'rvd_interfaces/msg/ThrustCommand',
    '/link/forward/status': 'rvd_interfaces/msg/LinkStatus',
    '/link/back/status': 'rvd_interfaces/msg/LinkStatus',
    '/run/scenario': 'std_msgs/msg/String',
    '/run/ready': 'std_msgs/msg/String',
    '/run/pause': 'std_msgs/msg/Bool',
    '/run/end': 'std_msgs/msg/UInt64',
    '/run/recorded_step': 'std_msgs/msg/UInt64',
    '/run/verdict': 'rvd_interfaces/msg/Verdict',
    '/run/events': 'rvd_interfaces/msg/RunEvent',
    '/diagnostics': 'diagnostic_msgs/msg/DiagnosticArray',
}

RECORDER_LEAD = 64              # [steps] in lock step the recorder is never further behind

# Written by any node whenever it has something to say; nobody waits for them at the start.
COMMON = ('/run/ready', '/run/events', '/diagnostics')


@dataclass(frozen=True)
class Spec:
    """
    Wiring of one node.

    `fires_on` lists (topic, lag): to fire for step k the node needs the message of step
    k - lag. `emits` are written exactly once per step. `watches` and `writes` are outside the
    synchronous ring.
    """

    fires_on: tuple[tuple[str, int], ...] = ()
    emits: tuple[str, ...] = ()
    watches: tuple[str, ...] = ()
    writes: tuple[str, ...] = ()
    everything: bool = field(default=False)     # the recorder

    @property
    def reads(self) -> frozenset[str]:
        """Topics this node subscribes to."""
        fired_on = [topic for topic, _ in self.fires_on]
        topics = TOPICS if self.everything else [*fired_on, *self.watches, '/run/end']
        return frozenset(topics) - self.publishes

    @property
    def publishes(self) -> frozenset[str]:
        """Topics this node writes, the common ones aside."""
        return frozenset(self.emits + self.writes)


NODES = {
    'spacecraft_dynamics': Spec(
        fires_on=(('/onboard/thruster_command', 1),),
        emits=('/truth/relative_state', '/clock'),
        watches=('/run/ready', '/run/recorded_step', '/run/pause'),
        writes=('/run/end', '/run/scenario')),
    'relative_sensor': Spec(
        fires_on=(('/truth/relative_state', 0), ('/onboard/thruster_command', 1)),
        emits=('/onboard/measurement', '/onboard/downlink')),
    'link_back': Spec(
        fires_on=(('/onboard/downlink', 0),),
        emits=('/ground/telemetry', '/link/back/status')),
    'state_predictor': Spec(
        fires_on=(('/ground/telemetry', 0), ('/ground/command', 1)),
        emits=('/ground/estimate', '/ground/prediction', '/ground/prediction_score')),
    'operator_model': Spec(
        fires_on=(('/ground/estimate', 0), ('/ground/prediction', 0)),
        emits=('/joy',)),
    'joystick_replay': Spec(
        fires_on=(('/ground/prediction', 0),),
        emits=('/joy',)),
    'auto_controller': Spec(
        fires_on=(('/ground/prediction', 0),),
        emits=('/ground/auto_command',)),
    'command_blender': Spec(
        fires_on=(('/joy', 0), ('/ground/auto_command', 0)),
        emits=('/ground/command', '/ground/uplink'),
        writes=('/run/pause',)),
    'link_forward': Spec(
        fires_on=(('/ground/uplink', 0),),
        emits=('/onboard/command', '/link/forward/status')),
    'onboard_guard': Spec(
        fires_on=(('/onboard/command', 0),),
        emits=('/onboard/thruster_command',)),
    'console': Spec(                            # never the truth: what came down the link
        watches=('/ground/telemetry', '/ground/estimate', '/ground/prediction',
                 '/ground/prediction_score', '/ground/auto_command', '/ground/command',
                 '/link/back/status', '/run/pause', '/run/events', '/run/verdict'),
        writes=('/joy',)),
    'mission_monitor': Spec(
        watches=('/truth/relative_state',),
        writes=('/run/verdict',)),
    'bag_recorder': Spec(everything=True, writes=('/run/recorded_step',)),
    'markers': Spec(
        watches=('/truth/relative_state', '/ground/estimate', '/ground/prediction'),
        writes=()),
}

# The pilot is one of these, or any node that publishes sensor_msgs/Joy, or nobody.
PILOT_NODES = {'model': 'operator_model', 'replay': 'joystick_replay', 'console': 'console',
               'joy': 'joy_node', 'none': None}
RING = ('spacecraft_dynamics', 'relative_sensor', 'link_back', 'state_predictor',
        'auto_controller', 'command_blender', 'link_forward', 'onboard_guard')


def spec_of(name: str, operator: str, joy_input: str, law_uses_stick: bool = False) -> Spec:
    """
    Return the wiring of node `name` in a run with this pilot.

    The blender fires on the stick only when the pilot is stepped; a held stick is watched and
    a missing one is not. So it is with a law that uses the stick.

    Raises
    ------
    ValueError
        If no node of that name is known.
    """
    if name not in NODES:
        raise ValueError(f'no node named {name!r} in the graph; it has {", ".join(NODES)}')
    spec = NODES[name]
    stepped = joy_input == 'stepped' and operator != 'none'
    if name == 'command_blender' and not stepped:
        joy = () if operator == 'none' else ('/joy',)
        return Spec((('/ground/auto_command', 0),), spec.emits, joy, spec.writes)
    if name == 'auto_controller' and law_uses_stick and operator != 'none':
        if stepped:
            return Spec(spec.fires_on + (('/joy', 0),), spec.emits)
        return Spec(spec.fires_on, spec.emits, ('/joy',))
    return spec


def ring(operator: str) -> tuple[str, ...]:
    """Return the names of the nodes without which a run with this pilot cannot step."""
    pilot = PILOT_NODES[operator]
    return RING + ((pilot,) if pilot in NODES else ())


def expected(topic: str, nodes: Iterable[str], operator: str, joy_input: str) -> tuple[int, int]:
    """Return how many (writers, readers) of `topic` are among `nodes`, by their specs."""
    specs = [spec_of(name, operator, joy_input) for name in nodes if name in NODES]
    return (sum(topic in spec.publishes for spec in specs),
            sum(topic in spec.reads for spec in specs))


def who_owes(last: dict[str, int], nodes: Iterable[str], operator: str,
             joy_input: str, law_uses_stick: bool = False) -> list[str]:
    """
    Name the nodes whose inputs are complete and whose output is missing.

    `last` is the last step seen on each topic (-1: nothing yet). In lock step the world also
    waits for a recorder that is RECORDER_LEAD steps behind: then that one owes.
    """
    def seen(topic: str) -> int:
        return last.get(topic, -1)

    names = list(nodes)
    if ('bag_recorder' in names
            and seen('/truth/relative_state') - seen('/run/recorded_step') >= RECORDER_LEAD):
        return ['bag_recorder']
    owing = []
    for name in names:
        if name not in NODES or not NODES[name].emits:
            continue
        spec = spec_of(name, operator, joy_input, law_uses_stick)
        stepped = [topic for topic in spec.emits if topic != '/clock']
        due = min(seen(topic) for topic in stepped) + 1
        if all(seen(topic) >= due - lag for topic, lag in spec.fires_on):
            owing.append(name)
    return owing
