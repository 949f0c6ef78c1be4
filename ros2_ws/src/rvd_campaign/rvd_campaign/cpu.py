"""What processes have used of the processor."""

import os
from pathlib import Path

TICKS_PER_S = os.sysconf('SC_CLK_TCK')


def cpu_s(pid: int) -> float:
    """Return the CPU time of a process so far, user and system, all threads [s]; 0 when gone."""
    try:
        fields = Path(f'/proc/{pid}/stat').read_text(errors='replace').rsplit(')', 1)[1].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / TICKS_PER_S
