"""
A report after a flight or a campaign: one that cannot be made takes nothing with it.
"""

from collections.abc import Callable
from pathlib import Path
import shlex
import sys
import traceback

from rvd_dynamics.bad_input import BadInput, one_line


def attempt(write: Callable[[Path], Path], folder: Path, log: Path) -> None:
    """
    Make a report and print where it is, or say why there is none and how to make it again.

    What was flown is there either way, so that the exit code is that of the flying.

    Parameters
    ----------
    write : callable
        Makes the report of `folder` and returns where it is.
    folder : Path
        Of the run or the campaign.
    log : Path
        Gets the traceback of what is not bad input and thus an error of a program.
    """
    try:
        made = write(folder)
    except BadInput as error:
        why = str(error)
    except Exception as error:                  # of matplotlib, of the figures of a mission
        why = f'{type(error).__name__}: {" ".join(str(error).split())} (traceback in {log})'
        try:
            log.write_text(traceback.format_exc(), encoding='utf-8')
        except OSError:
            traceback.print_exc()
    else:
        print(made, flush=True)
        return
    print(f'rvd: no report: {one_line(why)}', file=sys.stderr)
    print(f'rvd: make it again with ./rvd report {shlex.quote(str(folder))}', file=sys.stderr)
