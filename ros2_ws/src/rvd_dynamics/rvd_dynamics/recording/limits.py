"""
What reading one file of a bag may cost: bytes that it unpacks to, and time.

A bag can come from anywhere. Sixty kilobytes of zstd can mean two gigabytes, and a table of SQLite
can be a query that never ends; what takes more than these limits is damage like any other.
"""

import io
import os
import time
from typing import Any, BinaryIO

import zstandard

MAX_RECORD = 256 << 20          # [B] of one message, or of one chunk of them, unpacked
MAX_HELD = 2 << 30              # [B] of messages that are kept in memory for a report
MAX_DEFINITION = 256 << 10      # [B] of the definition of one message type with all it needs
MOST_TOPICS = 10_000            # of one file; a run has some forty
SOME, TIMES = 16 << 20, 100     # [B] anything may unpack to, and times the file's size beyond
SOME_S, PER_MB_S = 20.0, 5.0    # [s] of CPU time, and for each megabyte of the file beyond
PIECE = 1 << 20                 # [B] read at a time
EVERY = 4096                    # records between two looks at the time


class Damage(Exception):
    """A file of a bag cannot be read on from here; the text says why in a few words."""


class Allowance:
    """What is left of the limits while one file is read."""

    def __init__(self, file: BinaryIO) -> None:
        self.size = os.fstat(file.fileno()).st_size
        self._bytes = self._most = SOME + TIMES * self.size
        self._until = time.thread_time() + SOME_S + PER_MB_S * self.size / 1e6
        self._met = 0

    def unpack(self, size: int) -> None:
        """Take what something unpacks to [B]; Damage if that is more than is left."""
        self._bytes -= size
        if self._bytes < 0:
            raise Damage(f'it unpacks to more than {self._most >> 20} MiB')

    def met(self) -> None:
        """Count a record; Damage if the time for all of them is over."""
        self._met += 1
        if self._met % EVERY == 0:
            self.look()

    def look(self) -> None:
        """Raise Damage if the time is over."""
        if time.thread_time() > self._until:
            raise Damage(f'reading it takes too long: stopped after {self._met} records')


def unpacked(kind: str, data: bytes, most: int) -> bytes:
    """
    Return what bytes compressed by `kind` ('zstd', 'lz4', '' for not at all) unpack to.

    Raises
    ------
    Damage
        If they cannot be unpacked, or to more than `most` bytes.
    """
    if not kind:
        return data
    if kind not in UNPACK:
        raise Damage(f'compressed by {kind[:20]!r}, which cannot be unpacked here')
    try:
        made = UNPACK[kind](data, most + 1)
    except Exception as error:                  # each decompressor has errors of its own
        raise Damage(f'cannot be unpacked: {error or type(error).__name__}') from None
    if len(made) > most:
        raise Damage(f'it unpacks to more than {most} bytes')
    return made


def _zstd(data: bytes, most: int) -> bytes:
    return read_up_to(zstd_stream(io.BytesIO(data)), most)


def zstd_stream(file: Any) -> Any:
    """Return what a zstd stream unpacks to, as a stream."""
    return zstandard.ZstdDecompressor().stream_reader(file, read_across_frames=True)


def read_up_to(stream: Any, most: int) -> bytes:
    """Return the next bytes of a stream, `most` if there are so many."""
    if most <= PIECE:                           # most records: one piece
        data = stream.read(most)
        if len(data) == most or not data:
            return data
    else:
        data = b''
    pieces, left = [data], most - len(data)
    while left > 0:
        piece = stream.read(min(left, PIECE))
        if not piece:
            break
        pieces.append(piece)
        left -= len(piece)
    return b''.join(pieces)


def _lz4(data: bytes, most: int) -> bytes:
    import lz4.frame
    return lz4.frame.LZ4FrameDecompressor().decompress(data, max_length=most)


UNPACK = {'zstd': _zstd, 'lz4': _lz4}
