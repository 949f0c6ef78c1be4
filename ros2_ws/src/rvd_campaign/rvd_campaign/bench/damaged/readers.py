"""What reads bags: report, review and `--tape`, and what goes wrong in them."""

from collections.abc import Callable
from contextlib import redirect_stderr
from io import StringIO
from pathlib import Path
import time
from typing import Any
import warnings

from rvd_dynamics.bad_input import BadInput

MOST_S = 60.0                           # [s] of CPU time that one reader may take


def faults(run: Path) -> list[str]:
    """Give a run folder to every reader of bags; return what went wrong, one entry for each."""
    from rvd_campaign.report.replay import load
    from rvd_campaign.report.run import write_report
    from rvd_groundstation.operators.tape import read_tape
    tape = run / 'bag'
    readers: dict[str, Callable[[], Any]] = {
        'review': lambda: load(run.parent, run.name),
        'tape': lambda: read_tape(tape),
        'report': lambda: write_report(run),            # last: it may repair the bag
        'tape after the report': lambda: read_tape(tape)}
    return [f'{name}: {said}' for name, read in readers.items() if (said := _fault(read))]


def _fault(read: Callable[[], Any]) -> str:
    begun, said, noise, warned = time.process_time(), '', StringIO(), []
    try:
        with redirect_stderr(noise), warnings.catch_warnings(record=True) as warned:
            warnings.simplefilter('default')
            read()
    except (BadInput, FileNotFoundError) as error:
        text = str(error)
        if isinstance(error, BadInput) and (not text or not text.isprintable()):
            said = f'the refusal is no line: {text!r}'
    except Exception as error:                  # noqa: B902 - that is what is looked for
        place = error.__traceback__
        while place.tb_next is not None:
            place = place.tb_next
        said = (f'{type(error).__name__}: {error} at '
                f'{place.tb_frame.f_code.co_filename}:{place.tb_lineno}')
    spent = time.process_time() - begun
    told = noise.getvalue() + ''.join(f'{w.message} at {w.filename}:{w.lineno}' for w in warned)
    if not said and told:
        said = f'it says on its own: {told[:300]!r}'
    return said or (f'it took {spent:.0f} s' if spent > MOST_S else '')
