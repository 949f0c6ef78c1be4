"""
How much of a flight its bag holds, held against the steps that are known to have been flown.

The recorder counts what it knows to be missing. One that was stopped, or killed, has not heard how
far the run came, so this is counted from the other side: from the last step of the run.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from mcap.exceptions import McapError
from mcap.reader import make_reader

from rvd_dynamics.recording.messages import files_of, MessageFile

LOST = 'rvd_lost'               # metadata record: topic -> messages that the disk did not take


class Kept(NamedTuple):
    """
    What the bag of a run holds.

    Attributes
    ----------
    flown, stored : int
        Steps of the run, and those of them whose truth is in the bag.
    missing : dict
        Firings that are not in the bag and were not given up for want of disk, by topic; topics
        of which all is there are left out.
    """

    flown: int
    stored: int
    missing: dict[str, int]

    @property
    def complete(self) -> bool:
        """Whether everything that was published once a step reached the recorder."""
        return not self.missing

    def in_words(self) -> str:
        """Return one sentence."""
        return (f'the recording is incomplete: it holds {self.stored} of {self.flown} steps, and '
                f'{sum(self.missing.values())} messages of {len(self.missing)} topics never '
                'reached it')

    def as_dict(self) -> dict[str, Any]:
        """Return what `verdict.json` says of it."""
        return {'complete': self.complete, 'steps_flown': self.flown,
                'steps_stored': self.stored, 'missing': self.missing}


def kept(run_dir: Path, owed: Mapping[str, int], truth: str, last_step: int,
         given_up: int = 0) -> Kept:
    """
    Return what the bag of a run holds.

    Parameters
    ----------
    run_dir : Path
    owed : mapping
        Topics with one message at each firing of their node: its period [steps].
    truth : str
        The topic of the truth.
    last_step : int
        Of the run, as the plant or the judge knows it.
    given_up : int
        Messages that the recorder says the disk did not take; the bag may have no room for a note.
    """
    stored: dict[str, int] = {}
    lost: dict[str, int] = {}
    try:
        files = files_of(run_dir)
    except ValueError:                          # no bag at all
        files = []
    for file in files:
        counts, notes = _content(file)
        for topic, count in counts.items():
            stored[topic] = stored.get(topic, 0) + count
        for topic, count in notes.get(LOST, {}).items():
            lost[topic] = lost.get(topic, 0) + int(count)
    gaps = {topic: last_step // period + 1 - stored.get(topic, 0) - lost.get(topic, 0)
            for topic, period in owed.items()}
    missing = {topic: gap for topic, gap in gaps.items() if gap > 0}
    if not lost and sum(missing.values()) <= given_up:
        missing = {}
    return Kept(last_step + 1, min(stored.get(truth, 0), last_step + 1), missing)


def _content(path: Path) -> tuple[dict[str, int], dict[str, dict[str, str]]]:
    """Return how many messages of each topic a file has, and its notes."""
    try:
        with path.open('rb') as stream:
            reader = make_reader(stream)
            summary = reader.get_summary()
            if summary is not None and summary.statistics is not None:
                counts = summary.statistics.channel_message_counts
                return ({channel.topic: counts.get(number, 0)
                         for number, channel in summary.channels.items()},
                        {note.name: note.metadata for note in reader.iter_metadata()})
    except (McapError, ValueError, EOFError, OSError):
        pass                                    # it has no index: cut off, or the disk is full
    content = MessageFile(path)
    for _ in content:
        pass
    return {source.topic: source.count for source in content.sources}, content.notes
