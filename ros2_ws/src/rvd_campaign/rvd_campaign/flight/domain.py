"""
A DDS domain id for each run, so that runs side by side do not hear each other.
"""

import fcntl
import os
import random
import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import Iterator

# Above 101 the ports of a domain reach into the range that Linux gives to outgoing connections.
IDS = range(1, 102)


@contextmanager
def reserved_domain() -> Iterator[int]:
    """
    Yield the user's own `ROS_DOMAIN_ID`, or one that no other run of this machine holds.

    Raises
    ------
    ValueError
        If `ROS_DOMAIN_ID` is no whole number from 0 to 232, or every id is taken.
    """
    given = os.environ.get('ROS_DOMAIN_ID', '')
    if given:
        if not given.isdigit() or int(given) > 232:
            raise ValueError(f'ROS_DOMAIN_ID must be a whole number from 0 to 232, got {given!r}')
        yield int(given)
        return
    folder = Path(tempfile.gettempdir()) / f'rvd-domains-{os.getuid()}'
    folder.mkdir(mode=0o700, exist_ok=True)
    for domain in random.SystemRandom().sample(IDS, len(IDS)):
        with (folder / str(domain)).open('w') as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                continue
            yield domain
            return
    raise ValueError('every DDS domain id from 1 to 101 is taken by a run on this machine')
