"""
The folder of a run: made for one run, never written into by another.
"""

from pathlib import Path
import re
import time

from rvd_campaign.exits import CannotRun
from rvd_campaign.flight import room
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.recording import whole


def new_folder(out: str | None, name: str) -> Path:
    """
    Make the run folder; one that holds something is never written into.

    Of two commands that want the same name at the same moment one makes the folder: the other
    takes the next name, or is refused where `out` says which.
    """
    stem = f'{time.strftime("%Y%m%d-%H%M%S")}-{re.sub("[^A-Za-z0-9_-]", "_", name)}'
    folder, number = Path('runs') / stem if out is None else Path(out), 1
    while True:
        try:
            folder.mkdir(parents=True)
            return folder
        except FileExistsError:
            if out is not None:
                return _empty(folder)
        except OSError as error:
            raise CannotRun(f'cannot make the run folder {folder}: {error.strerror}') from None
        number += 1
        folder = Path('runs') / f'{stem}-{number}'


def _empty(folder: Path) -> Path:
    """Return a folder that exists if nothing is in it."""
    try:
        if not any(folder.iterdir()):
            return folder
    except NotADirectoryError:
        pass
    except OSError as error:
        raise CannotRun(f'cannot read the run folder {folder}: {error.strerror}') from None
    raise CannotRun(f'--out {folder} exists already: nothing is overwritten, '
                    'give another folder or remove it')


def keep_scenario(run_dir: Path, scenario: Scenario) -> None:
    """Write the scenario into a new run folder, unless another run has just taken that one."""
    try:
        whole.write_new(run_dir / 'scenario.yaml', scenario.dump())
    except FileExistsError:
        raise CannotRun(f'--out {run_dir} has just been taken by another run: give another '
                        'folder') from None
    except OSError as error:
        raise CannotRun(f'cannot write into the run folder {run_dir}: {error.strerror}') from None
    room.keep(run_dir)
