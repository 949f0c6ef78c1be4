"""
Start and end of a node process: one executor, clean on Ctrl-C, one line for bad settings.
"""

import sys
from typing import Callable

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor


def run(node_class: Callable, args=None) -> None:
    """
    Spin one node until its `done` future is set or the process is told to stop.

    Bad settings end the process with exit code 2 and one line that names the value.
    """
    rclpy.init(args=args)
    node = None
    try:
        node = node_class()
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        executor.spin_until_future_complete(node.done)
        if node.done.done():
            node.done.result()                  # an error in a callback ends the process
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    except RuntimeError:                        # told to stop between two waits
        if rclpy.ok():
            raise
    except ValueError as error:
        name = node.get_name() if node is not None else sys.argv[0].rsplit('/', 1)[-1]
        print(f'{name}: {error}', file=sys.stderr)
        sys.exit(2)
    finally:
        if node is not None:
            node.close()
            node.destroy_node()
        rclpy.try_shutdown()
