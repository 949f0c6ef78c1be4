"""
ROS shell of the browser console, and its process: rclpy on its own thread beside the web server.

Watches     what the mission's display shows of the signals on the ground,
            /link/back/status, /run/pause, /run/events, and /run/verdict once it is final
Publishes   /joy    sensor_msgs/Joy, when the pilot's page sends a stick sample and the console
            is the operator of the run
Calls       /run/control
Parameters  the fields of ConsoleParams

The truth is not among its topics: what a pilot sees came down the link.

`./rvd fly --operator console` starts this process once, with `--serve`; each run's bring-up
then starts `console` as it starts any node, and that one, finding RVD_CONSOLE set, hands its
arguments to the process that is there (`console.attach`). So pages outlive a run. Started by
hand without RVD_CONSOLE it serves the run it is given and ends with it.
"""

import asyncio
import os
import sys

from rvd_dynamics import lifeline
from rvd_dynamics.bad_input import BadInput
from rvd_groundstation.console import attach


def main(args=None) -> None:
    """Join a console that is there, or be one."""
    lifeline.hold()
    arguments = list(sys.argv[1:] if args is None else args)
    socket = os.environ.get('RVD_CONSOLE', '')
    if '--serve' not in arguments and socket:
        sys.exit(attach.join(socket, arguments))
    from rvd_groundstation.console import process
    try:
        code = asyncio.run(process.serve(arguments))
    except BadInput as error:
        print(f'console: {error}', file=sys.stderr)
        code = 2
    except KeyboardInterrupt:
        code = 0
    sys.stdout.flush()
    os._exit(code)                              # no thread of ROS holds the process up


if __name__ == '__main__':
    main()
