"""
A rosbag2 bag (MCAP) that keeps what it was given, whatever happens to its process or disk.

Layout      DIRECTORY/metadata.yaml, written when the bag is opened and again when it is closed
            DIRECTORY/NAME_0.mcap, NAME being the directory's name as rosbag2 has it
Kill -9     every message that `write` or `write_all` accepted is in the file, which then lacks its
            end and its index; `repair` adds both
Full disk   messages of topics that are worth less are given up first, while there is still
            room for the others; each message that is not stored is counted
Times       `log_ns` is what readers sort by and what playback follows; the recorder puts
            simulation time there and wall time into `publish_ns`
"""

import os
from collections import Counter
from pathlib import Path
from typing import Any, Callable

from mcap.records import Channel, Footer, Metadata, Schema
import yaml

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.recording import mcap_file
from rvd_dynamics.recording.definitions import schema_text, type_hash
from rvd_dynamics.recording.rosbag2 import Contents, Topic, dump, write_metadata

RESERVE_BYTES = 64 * 1024 * 1024                # [B] kept free for topics worth 1, and the last
                                                # quarter of it for topics worth 2
LOOK_EVERY_BYTES = 64 * 1024                    # [B] written between two checks of the disk
NOTE_RECORDING = 'rvd_recording'                # metadata record: closed, trouble
UNKNOWN = (0, None, -1)                         # channel, entry and worth of what is no topic
NOTE_LOST = 'rvd_lost'                          # metadata record: topic -> messages not stored


class BagWriter:
    """
    Writes one bag. A bag has at most one writer, and grows only while it has one.

    Parameters
    ----------
    directory : Path
        Directory of the bag; must be empty if it exists.
    worth : callable
        Returns what a topic is worth when the disk is nearly full: 0, 1 or 2.

    Raises
    ------
    ValueError
        If the directory is not empty.
    OSError
        If it cannot be written.
    """

    def __init__(self, directory: Path, worth: Callable[[str], int] = lambda topic: 2) -> None:
        directory.mkdir(parents=True, exist_ok=True)
        if any(directory.iterdir()):
            raise BadInput(f'bag directory {directory} is not empty')
        self.directory = directory
        self.path = directory / f'{directory.name}_0.mcap'
        self.contents = Contents()
        self.lost: Counter[str] = Counter()
        self.trouble = ''                       # first thing that went wrong, one sentence
        self._worth = worth
        self._file = mcap_file.GrowingFile(self.path)
        self._schemas: dict[str, int] = {}
        self._channels: dict[str, tuple[int, Topic, int]] = {}
        self._least = 0                         # least worth that is still stored
        self._reserve = min(RESERVE_BYTES, _free(directory) // 4)
        self._look_every = min(LOOK_EVERY_BYTES, self._reserve // 16)
        self._look_at = 0
        self.describe()

    def add_topic(self, topic: str, kind: str, qos: list[dict[str, Any]]) -> None:
        """
        Open a topic; a second call for the same topic does nothing.

        Raises
        ------
        LookupError
            If the message type is not installed.
        """
        if topic in self._channels:
            return
        text, number = schema_text(kind), type_hash(kind)
        entry = Topic(topic, kind, number, qos)
        schema = self._schemas.get(kind, len(self._schemas) + 1)
        channel = Channel(
            id=len(self._channels) + 1, topic=topic, message_encoding='cdr', schema_id=schema,
            metadata={'offered_qos_profiles': yaml.safe_dump(qos, sort_keys=False),
                      'topic_type_hash': number})
        head = () if kind in self._schemas else (
            Schema(id=schema, name=kind, encoding='ros2msg', data=text.encode()),)
        try:
            self._file.append(*head, channel)
        except OSError as error:
            self._failed(error)
            return
        self._schemas[kind] = schema
        self._channels[topic] = (channel.id, entry, self._worth(topic))
        self.contents.topics[topic] = entry

    def write(self, topic: str, data: bytes, log_ns: int, publish_ns: int, sequence: int = 0
              ) -> bool:
        """Store one serialised message; False if it had to be given up, which is counted."""
        channel, entry, worth = self._channels.get(topic, UNKNOWN)
        if worth < self._least:
            self.lost[topic] += 1
            return False
        try:
            self._file.append_messages([(channel, sequence, log_ns, publish_ns, data)])
        except OSError as error:
            self.lost[topic] += 1
            self._failed(error)
            return False
        self.contents.add(entry, log_ns)
        if self._file.size >= self._look_at:
            self._look()
        return True

    def write_all(self, messages: list[tuple[str, bytes, int, int, int]]) -> None:
        """
        Store several messages, each as `write` takes it, in one go.

        What does not go in together is taken one by one, so that no more is given up than must.
        """
        rows, entries = [], []
        for topic, data, log_ns, publish_ns, sequence in messages:
            channel, entry, worth = self._channels.get(topic, UNKNOWN)
            if worth < self._least:
                break
            rows.append((channel, sequence, log_ns, publish_ns, data))
            entries.append((entry, log_ns))
        if len(rows) < len(messages) or not self._appended(rows):
            for message in messages:
                self.write(*message)
            return
        for entry, log_ns in entries:
            self.contents.add(entry, log_ns)
        if self._file.size >= self._look_at:
            self._look()

    def _appended(self, rows: list[tuple]) -> bool:
        try:
            self._file.append_messages(rows)
        except OSError:
            return False
        return True

    def _look(self) -> None:
        """On a nearly full disk, leave the rest of it to the topics that are worth most."""
        self._look_at = self._file.size + self._look_every
        free = _free(self.directory)
        if free < self._reserve:
            self._least = 1 if free > self._reserve // 4 else 2
            self._complain(f'only {free // 1024} KiB left on the disk')

    def _failed(self, error: OSError) -> None:
        self._least = max(self._least, 1)
        self._complain(f'cannot write {self.path.name}: {error.strerror}')

    def _complain(self, what: str) -> None:
        if not self.trouble:
            self.trouble = f'{what}: keeping commands and the story of the run, as far as they fit'

    def describe(self) -> None:
        """Write `metadata.yaml` for what the bag holds now."""
        try:
            write_metadata(self.directory, dump(self.contents, self.path.name))
        except OSError as error:
            self._failed(error)

    def close(self, notes: dict[str, dict[str, str]] | None = None, **said: str) -> None:
        """
        Finish the bag: write `notes` and the losses as metadata records, then the index.

        What is `said` goes into the record `rvd_recording`.

        What no longer fits on the disk is left out; what was stored stays readable.
        """
        notes = {**(notes or {}), NOTE_LOST: {t: str(n) for t, n in self.lost.items()},
                 NOTE_RECORDING: {'closed': 'true', 'trouble': self.trouble, **said}}
        try:
            self._file.append(*(Metadata(name=n, metadata=v) for n, v in notes.items()))
            self._file.finish()
            if _free(self.directory) > self._file.size + self._reserve:
                mcap_file.rewrite(self.path, {})
        except OSError as error:
            self._failed(error)
        self.describe()
        self._file.close()


def _free(directory: Path) -> int:
    disk = os.statvfs(directory)
    return disk.f_bavail * disk.f_frsize


def repair(directory: Path) -> bool:
    """
    Complete a bag that was cut off: its end, index and `metadata.yaml`; True if that was needed.

    A bag that is complete, or that a recorder is still writing, is left alone; so is one that is
    damaged, since what nobody can read today somebody may want to look at. A repaired bag still
    says that it was not closed (metadata record `rvd_recording`).

    Raises
    ------
    OSError
        If it cannot be written; the bag is then unchanged.
    """
    repaired = False
    for path in sorted(directory.glob('*.mcap')):
        if not _cut_off(path):
            continue
        handle = mcap_file.lock(path)
        if handle is None:
            continue
        try:
            notes = {NOTE_RECORDING: {'closed': 'false', 'trouble': 'cut off, then repaired'}}
            contents = mcap_file.rewrite(path, notes)
            write_metadata(directory, dump(contents, path.name))
            repaired = True
        finally:
            os.close(handle)
    return repaired


def _cut_off(path: Path) -> bool:
    """Say whether a file has no end, and is whole up to there."""
    last, damage = None, []
    try:
        for last in mcap_file.records(path, damage.append):
            pass
    except BadInput:                            # a pipe, a device
        return False
    return not damage and not isinstance(last, Footer)
