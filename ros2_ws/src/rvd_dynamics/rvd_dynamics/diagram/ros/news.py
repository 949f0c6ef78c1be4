"""
Events that a bag is to hold though the recorder has read them on no topic.

`fly` says on the page of the run (`pulse`) what it sees of the processes, which may hear nothing
any more, and who wrote where nobody may. The monitor says the latter on /run/events, too: but a
run that has a second writer is ended at once, and the recorder may be told to stop before it has
read that. So it asks the page in the end, and stores what it has not read by then; of a topic that
is only marked there (`traces`), that there was somebody.
"""

from typing import Any, NamedTuple

from rvd_dynamics.diagram.ros.writers import MANY, Stranger
from rvd_dynamics.diagram.roster import RECORDER, SECOND_WRITER

FLY = 'rvd_fly'                 # whoever follows a run from outside, as a node
LONGEST = 4096                  # [bytes] of an event that names a second writer: ours have some 200


class Said(NamedTuple):
    """An event that is to be stored."""

    node: str
    code: str
    step: int
    text: str


class News:
    """What the recorder of a process makes of the page."""

    def __init__(self, host: Any) -> None:
        self._host = host
        self._read: list[bytes] = []            # events that name a second writer, serialised
        self._kept: list[Said] = []             # such of `fly`, of which the monitor's may yet come

    def read(self, event: bytes) -> None:
        """Be shown a serialised event that the recorder has read."""
        if SECOND_WRITER.encode() in event and len(event) < LONGEST and len(self._read) < 2*MANY:
            self._read.append(event)

    def take(self, step: int, last: bool = False) -> list[Said]:
        """Return what is to be stored now; `last`: nothing more comes, and this is step `step`."""
        new = [Said(FLY, code, at, text) for code, at, text in self._host.news()]
        self._kept += (said for said in new if said.code == SECOND_WRITER)
        new = [said for said in new if said.code != SECOND_WRITER]
        if not last:
            return new
        named, self._kept = self._kept, []
        new += (said for said in named if not self._is_stored(said.text, ()))
        marked = (Stranger(topic, '', False, True) for topic in self._host.traced)
        return new + [Said(RECORDER, SECOND_WRITER, step, stranger.words) for stranger in marked
                      if not self._is_stored(stranger.on, new)]

    def _is_stored(self, words: str, new: Any) -> bool:
        return any(words.encode() in event for event in self._read) or any(
            words in said.text for said in new)
