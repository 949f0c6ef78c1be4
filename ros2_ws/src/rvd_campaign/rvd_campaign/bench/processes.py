"""
The machine that measurements are made on.
"""

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path


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
