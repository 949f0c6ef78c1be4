"""
The one `main` of all executables that are nodes of a run: finds the node and runs it.

`ros2 run PACKAGE NODE --ros-args --params-file SCENARIO` starts one block or watcher by its name;
the link's two legs are one executable, run under the name of each. `block_group` with `-p
group:=NAME` starts all the nodes that share the process NAME when `processes` is not `blocks`.
"""

from collections.abc import Iterator
import contextlib
import gc
import os
import sys

import rclpy

from rvd_dynamics import lifeline
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.block import Block, Leg
from rvd_dynamics.diagram.rehearsal import rehearse
from rvd_dynamics.diagram.ros.arguments import Arguments, parsed
from rvd_dynamics.diagram.ros.block_node import BlockNode
from rvd_dynamics.diagram.ros.firing import FiringNode
from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.leg_node import LegNode
from rvd_dynamics.diagram.ros.plant_node import PlantNode
from rvd_dynamics.diagram.ros.process import run
from rvd_dynamics.diagram.roster import GROUP_EXECUTABLE, MARKERS, MONITOR, RECORDER

LEG_EXECUTABLE = 'link_emulator'
NICE = 10                       # of a process that only watches, in real time


def main() -> None:
    """Run the nodes that the command line names."""
    lifeline.hold()
    try:
        arguments = parsed(sys.argv)
    except BadInput as error:
        print(f'{sys.argv[0].rsplit("/", 1)[-1]}: {error}', file=sys.stderr)
        sys.exit(2)

    def make_all(host: Host) -> None:
        names = wanted(host, arguments)
        make(host, names)
        run_of = host.scenario.run
        if run_of.pace == 'realtime' and run_of.processes != 'blocks':      # else a dozen would
            _prepare(host, names)
    run(make_all, arguments, sys.argv)


def wanted(host: Host, arguments: Arguments) -> tuple[str, ...]:
    """
    Return the names of the nodes that this process is to run.

    Raises
    ------
    ValueError
        If the run has no such node or process.
    """
    roster = host.roster
    if arguments.executable == GROUP_EXECUTABLE:
        group = arguments.process.get('group', '')
        groups = {p.name: p.nodes for p in roster.processes if p.grouped}
        if group not in groups:
            raise BadInput(
                f'group must be one of {", ".join(groups)} with processes '
                f'{host.scenario.run.processes}, got {group!r}' if groups else
                'a group needs processes segments or one, got blocks')
        return groups[group]
    legs = [block.name for block in roster.diagram.blocks if isinstance(block, Leg)]
    if arguments.executable == LEG_EXECUTABLE and arguments.name not in legs:
        raise BadInput(f'a link must be named {" or ".join(legs)}, not {arguments.name!r}: add '
                       f'--ros-args -r __node:={legs[0]}')
    if arguments.name not in roster.blocks and arguments.name not in roster.watchers:
        raise BadInput(f'mission {host.scenario.mission.name} has no node {arguments.name!r} in '
                       f'this scenario; it has {", ".join((*roster.blocks, *roster.watchers))}')
    return (arguments.name,)


def make(host: Host, names: tuple[str, ...]) -> None:
    """Make the nodes: first their publishers, then their subscriptions, then what computes."""
    blocks, watchers = [], []
    for block in host.roster.diagram.order:
        if block.name in names:
            with _named(host, block.name):
                blocks.append(node_of(host, block))
    for name in names:
        if name in host.roster.watchers:
            with _named(host, name):
                watchers.append(_watcher(host, name))
    for node in (*watchers, *blocks):           # the recorder hears what is said at the start
        with _named(host, node.get_name()):
            node.connect()
    for node in blocks:
        with _named(host, node.get_name()):
            node.make()


@contextlib.contextmanager
def _named(host: Host, name: str) -> Iterator[None]:
    """Let bad input carry the node whose settings they are, which may be half made."""
    try:
        yield
    except BadInput as error:
        error.rvd_node = host.nodes.get(name)
        raise


def _prepare(host: Host, names: tuple[str, ...]) -> None:
    """Get ready to keep the pace: nothing is left for later, and the ring goes before watchers."""
    in_ring = any(name in host.roster.blocks for name in names)
    if in_ring or MONITOR in names:
        rehearse(host.scenario, rclpy.ok)
    if not in_ring:
        os.nice(NICE)
    gc.collect()
    gc.freeze()                                 # a look through all that is loaded takes 0.1 s


def node_of(host: Host, block: Block) -> FiringNode:
    """Make the node of a block."""
    if isinstance(block, Leg):
        return LegNode(host, block)
    if block.name == host.roster.diagram.plant:
        return PlantNode(host, block)
    return BlockNode(host, block)


def _watcher(host: Host, name: str) -> object:
    if name == RECORDER:
        from rvd_dynamics.diagram.ros.recorder import BagRecorder
        return BagRecorder(host)
    if name == MONITOR:
        from rvd_dynamics.diagram.ros.monitor import MissionMonitor
        return MissionMonitor(host)
    assert name == MARKERS
    from rvd_dynamics.diagram.ros.markers import Markers
    return Markers(host)
