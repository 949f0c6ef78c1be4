"""
Print requirements.lock without what an installed ROS 2 brings and must stay its own.

Two copies of numpy, of the test runner or of what ROS's generators import break a ROS 2
installation, so that what its Python has is not installed again; ros-* is left out in any case.

    python3 lock_beside_ros.py requirements.lock        with the Python that ROS 2 uses
"""

from importlib.metadata import distributions
from pathlib import Path
import re
import sys

# What ROS's Python may have, and the entries of the lock which are then left out.
BROUGHT = {
    'numpy': 'numpy',
    'setuptools': 'setuptools',
    'pyyaml': 'pyyaml',
    'empy': 'empy',
    'lark': 'lark-parser',
    'lark-parser': 'lark-parser',
    'catkin-pkg': 'catkin-pkg',
    'catkin-pkg-modules': 'catkin-pkg',
    'pytest': 'pytest|pluggy|iniconfig|pytest-(cov|repeat|rerunfailures)',
    'colcon-ros': 'colcon-.*',
}


def canonical(name: str) -> str:
    """Return the name as the lock spells it."""
    return re.sub(r'[-_.]+', '-', name).lower()


def without(lock: str, left_out: str) -> str:
    """
    Return the text of a lock without the entries whose names match a pattern.

    An entry is a line that starts with its name and the indented lines after it.
    """
    entries = re.split(r'^(?=[A-Za-z])', lock, flags=re.MULTILINE)[1:]
    return ''.join(entry for entry in entries
                   if not re.fullmatch(left_out, entry.split('==')[0]))


def main() -> None:
    """Print the lock named on the command line as this Python needs it."""
    present = {canonical(found.metadata['Name']) for found in distributions()
               if found.metadata['Name']}
    patterns = ['ros-.*', *(ours for theirs, ours in BROUGHT.items() if theirs in present)]
    print(without(Path(sys.argv[1]).read_text(encoding='utf-8'), '|'.join(patterns)), end='')


if __name__ == '__main__':
    main()
