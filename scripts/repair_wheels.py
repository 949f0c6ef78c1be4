"""
Give the CMake files of the ROS wheels this machine's header directories.

The wheels export the directories of the machine that built them, `/opt/python/cp3XX-cp3XX/...`.
Run it with the Python of the environment to repair; running it again changes nothing.
"""

import os
import pathlib
import re
import sysconfig

import numpy

PYTHON_HEADERS = re.compile(r'/[^";\s]*/include/python3\.\d+(?=["; )])')
NUMPY_HEADERS = re.compile(r'/[^";\s]*/numpy/_core/include(?=["; )])')


def main() -> None:
    """Repair every CMake file below the prefix of this environment."""
    for path in pathlib.Path(sysconfig.get_path('data')).rglob('*.cmake'):
        text = path.read_text(encoding='utf-8', errors='surrogateescape')
        repaired = PYTHON_HEADERS.sub(sysconfig.get_path('include'), text)
        repaired = NUMPY_HEADERS.sub(numpy.get_include(), repaired)
        if repaired != text:
            # A new file, since the old one may be a hard link into the installer's cache.
            new = path.with_suffix('.new')
            new.write_text(repaired, encoding='utf-8', errors='surrogateescape')
            os.replace(new, path)


if __name__ == '__main__':
    main()
