"""A process of a run from its arguments to its exit code."""

from collections.abc import Callable
import gc
import os
import re
import sys

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.signals import SignalHandlerOptions
from std_msgs.msg import UInt64

from rvd_dynamics import lifeline
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram import identity
from rvd_dynamics.diagram.ros.arguments import Arguments
from rvd_dynamics.diagram.ros.host import Host


def listen_for_the_end(host: Host) -> None:
    """Subscribe to /run/end, unless the plant is in this process."""
    if host.roster.diagram.plant not in host.nodes:
        host.lead.watch('/run/end', UInt64, host.ending.hear)


def _signals() -> SignalHandlerOptions:
    """Return what ends the process: under a bring-up, what that asks for alone."""
    return (SignalHandlerOptions.SIGTERM if os.environ.get(lifeline.PARENT)
            else SignalHandlerOptions.ALL)


def _init(argv: list[str]) -> None:
    try:
        rclpy.init(args=argv, signal_handler_options=_signals())
    except RuntimeError as error:               # RCLError: arguments that are none of ROS, no HOME
        said = re.sub(r', at \S+:\d+$', '', ' '.join(str(error).split()))
        raise BadInput(f'ROS does not start: {said}') from None
    domain = rclpy.get_default_context().get_domain_id()
    if domain > identity.LARGEST_DOMAIN:        # DDS would end the process without a word of ours
        raise BadInput(f'ROS_DOMAIN_ID={domain} must be from 0 to {identity.LARGEST_DOMAIN}')


def run(make: Callable[[Host], None], arguments: Arguments, argv: list[str]) -> None:
    """
    Make a process and its nodes, and serve them until the run is over or it is told to stop.

    Bad settings end the process with exit code 2 and one line that names the value.
    """
    host = None
    try:
        arguments.scenario                      # before rclpy finds fault with the same file
        _init(argv)
        host = Host(arguments)
        make(host)
        listen_for_the_end(host)
        gc.freeze()                             # what is loaded stays: not to be looked through
        gc.collect()                            # again, nor what garbage is small against
        host.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    except RuntimeError:                        # told to stop between two waits
        if rclpy.ok():
            raise
    except BadInput as error:
        node = getattr(error, 'rvd_node', None)
        name = node.get_name() if node is not None else arguments.name
        print(f'{name}: {error}', file=sys.stderr)
        sys.exit(2)
    finally:
        if host is not None:
            host.close()
        with lifeline.leaving():
            rclpy.try_shutdown()
