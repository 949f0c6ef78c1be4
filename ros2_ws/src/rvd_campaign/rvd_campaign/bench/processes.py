"""
Processes under measurement: their CPU time, the machine they ran on.
"""

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

TICKS_PER_S = os.sysconf('SC_CLK_TCK')


def cpu_s(pid: int) -> float:
    """Return the CPU time of a process so far, user and system, all threads [s]; 0 when gone."""
    try:
        fields = Path(f'/proc/{pid}/stat').read_text(errors='replace').rsplit(')', 1)[1].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / TICKS_PER_S


def machine() -> dict[str, object]:
    """Return what the figures depend on besides the code."""
    return {'cpu': _cpu_name(), 'cores': len(os.sched_getaffinity(0)),
            'load_1_min': os.getloadavg()[0], 'system': platform.platform(terse=True),
            'python': platform.python_version(), 'numpy': version('numpy'),
            'rclpy': _rclpy_version()}


def _cpu_name() -> str:
    for line in Path('/proc/cpuinfo').read_text().splitlines():
        if line.startswith('model name'):
            return line.split(':', 1)[1].strip()
    return platform.machine()


def _rclpy_version() -> str:
    for name in ('ros-jazzy-rclpy', 'rclpy'):
        try:
            return version(name)
        except PackageNotFoundError:
            continue
    return 'unknown'
