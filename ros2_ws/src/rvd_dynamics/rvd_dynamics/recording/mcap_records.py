"""
The records of an MCAP file from anywhere: cut off, damaged or made to do harm.

A file that was cut off gives its whole records. Of a damaged one what can be read is read: a record
or chunk that cannot be is left out, and where it cannot be told any more where the next one begins,
the file ends. Each loss is told to the caller.

Source  MCAP specification, version 0.
"""

from collections.abc import Callable, Iterator
import io
import os
from pathlib import Path
import struct
from typing import BinaryIO
import zlib

from mcap.data_stream import ReadDataStream
from mcap.records import (
    Channel, DataEnd, Footer, Header, McapRecord, Message, Metadata, Schema, Statistics)

from rvd_dynamics.given import opened
from rvd_dynamics.recording.limits import (
    Allowance, Damage, MAX_RECORD, PIECE, read_up_to, unpacked, zstd_stream)

MAGIC = b'\x89MCAP0\r\n'
HEAD = struct.Struct('<BQ')                     # opcode, length
MESSAGE, CHUNK, FOOTER = 5, 6, 2
PARSED = {1: Header, FOOTER: Footer, 3: Schema, 4: Channel, 11: Statistics, 12: Metadata,
          15: DataEnd}
KNOWN = frozenset(range(1, 16))
PRIVATE = 0x80                                  # opcodes from here on are anybody's
_MESSAGE = struct.Struct('<HIQQ')               # channel, sequence, log time, publish time
_CHUNK = struct.Struct('<QQQII')                # first, last, size, checksum, length of a name
_LENGTH = struct.Struct('<Q')
_FOOTER = struct.Struct('<BQQQI')               # opcode, length, summary, offsets, checksum
Damaged = Callable[[str], None]


class _CutOff(Exception):
    """The file ends within a record."""


def ignored(why: str) -> None:
    """Take no notice of damage."""


def records(path: Path, damaged: Damaged = ignored) -> Iterator[McapRecord]:
    """
    Yield the records of a file, which zstd may have compressed (.zstd); of indexes none.

    Parameters
    ----------
    path : Path
        Of the file.
    damaged : callable
        Is told in a few words what cannot be read; it may raise. A file that was merely cut off
        is not damaged: its last record is no `Footer`.

    Raises
    ------
    BadInput, OSError
        If it is no regular file or cannot be opened.
    """
    with opened(path) as file:
        stream = _Stream(file, path.suffix == '.zstd')
        try:
            if stream.read(len(MAGIC)) != MAGIC:
                raise Damage('it does not begin as one')
            yield from _records(stream, damaged)
        except _CutOff:
            if stream.has_its_end:
                damaged(f'{stream.place}: a length leads beyond the end of the file')
        except Damage as error:
            damaged(f'{stream.place}: {error}' if stream.begun else str(error))
        except (OSError, MemoryError) as error:
            damaged(f'{stream.place}: {error or type(error).__name__}')


class _Stream:
    """The bytes of a file, or what it unpacks to, and where in them its records are."""

    def __init__(self, file: BinaryIO, packed: bool) -> None:
        self.allowance = Allowance(file)
        self.at = self._at = 0                  # [B] where a record begins, and where we are
        self._packed, self._left = packed, self.allowance.size
        self._bytes = zstd_stream(file) if packed else file
        self.has_its_end = not packed and _ends_well(file)

    @property
    def begun(self) -> bool:
        """Whether the file has begun as one."""
        return self.at > 0

    @property
    def place(self) -> str:
        """Where the record is that is read, in words."""
        return f'byte {self.at}'

    def read(self, size: int) -> bytes:
        """Return so many bytes; raises where there are fewer, and where they are too many."""
        if self._packed:
            self.allowance.unpack(size)
        elif size > self._left:
            raise _CutOff
        if size > MAX_RECORD:
            raise Damage(f'a record of {size} bytes')
        try:
            data = read_up_to(self._bytes, size)
        except (OSError, MemoryError):
            raise
        except Exception as error:              # the decompressor's own
            raise Damage(f'cannot be unpacked: {error}') from None
        if len(data) < size:
            raise _CutOff
        self._left -= size
        self._at += size
        return data

    def skip(self, size: int) -> None:
        """Leave so many bytes out."""
        if not self._packed and size <= self._left:
            self._bytes.seek(size, os.SEEK_CUR)
            self._left -= size
            self._at += size
            return
        while size > 0:
            self.read(min(size, PIECE))
            size -= PIECE

    def mark(self) -> None:
        """Note that a record begins here."""
        self.at = self._at


def _ends_well(file: BinaryIO) -> bool:
    """Say whether a file ends as a closed one does."""
    try:
        file.seek(-len(MAGIC), os.SEEK_END)
        found = file.tell() > len(MAGIC) and file.read() == MAGIC
        file.seek(0)
        return found
    except OSError:                             # shorter than that
        file.seek(0)
        return False


def _records(stream: _Stream, damaged: Damaged) -> Iterator[McapRecord]:
    while True:
        stream.mark()
        stream.allowance.met()
        opcode, length = HEAD.unpack(stream.read(HEAD.size))
        if opcode == MESSAGE:
            yield _message(stream.read(length))
        elif opcode == CHUNK:
            try:
                yield from _of_chunk(stream.read(length), stream.allowance, damaged)
            except Damage as error:
                stream.allowance.look()         # its limits end the file
                damaged(f'{stream.place}: a chunk of messages: {error}')
        elif opcode in PARSED:
            record = _parsed(opcode, stream.read(length), damaged, stream.place)
            if record is not None:
                yield record
            if opcode == FOOTER:
                return
        elif opcode in KNOWN or opcode >= PRIVATE:
            stream.skip(length)
        else:
            raise Damage('no record begins here')


def _message(body: bytes) -> Message:
    if len(body) < _MESSAGE.size:
        raise Damage('a message without its head')
    channel, sequence, log_ns, publish_ns = _MESSAGE.unpack_from(body)
    return Message(channel_id=channel, data=body[_MESSAGE.size:], log_time=log_ns,
                   publish_time=publish_ns, sequence=sequence)


def _parsed(opcode: int, body: bytes, damaged: Damaged, place: str) -> McapRecord | None:
    try:
        return PARSED[opcode].read(ReadDataStream(io.BytesIO(body)))
    except Exception as error:                  # of made-up bytes: no text, too short and more
        damaged(f'{place}: a {PARSED[opcode].__name__.lower()} that is none: '
                f'{error or type(error).__name__}')
        return None


def _of_chunk(body: bytes, allowance: Allowance, damaged: Damaged) -> Iterator[McapRecord]:
    """Yield the records of a chunk; Damage where it cannot be read on, or is not what it was."""
    try:
        first, last, size, checksum, length = _CHUNK.unpack_from(body)
        at = _CHUNK.size + length
        kind = body[_CHUNK.size:at].decode()
        packed = body[at + 8:at + 8 + _LENGTH.unpack_from(body, at)[0]]
    except (struct.error, UnicodeDecodeError):
        raise Damage('no head') from None
    if size > MAX_RECORD:
        raise Damage(f'{size} bytes')
    if kind:
        allowance.unpack(size)
    data = unpacked(kind, packed, size)
    times = f'from {first / 1e9:.3f} to {last / 1e9:.3f} s'
    if len(data) != size:
        raise Damage(f'{times}: {len(data)} bytes of {size}')
    at = 0
    while at < len(data):
        allowance.met()
        if at + HEAD.size > len(data):
            raise Damage(f'{times}: cut off')
        opcode, length = HEAD.unpack_from(data, at)
        body = data[at + HEAD.size:at + HEAD.size + length]
        if len(body) < length:
            raise Damage(f'{times}: cut off')
        if opcode == MESSAGE:
            yield _message(body)
        elif opcode in (3, 4):                  # schemas and channels
            record = _parsed(opcode, body, damaged, times)
            if record is not None:
                yield record
        at += HEAD.size + length
    if checksum and zlib.crc32(data) != checksum:
        raise Damage(f'{times}: its checksum does not match: numbers in it may be wrong')


def last_time(path: Path) -> int | None:
    """Return the log time [ns] of the last message that a closed file says it holds; else None."""
    tail = _FOOTER.size + len(MAGIC)
    try:
        with opened(path) as file:
            size = file.seek(0, os.SEEK_END)
            file.seek(max(size - tail, 0))
            end = file.read()
            if len(end) < tail or end[-len(MAGIC):] != MAGIC:
                return None
            start = _FOOTER.unpack_from(end)[2]
            if not 0 < start < size - tail or size - start > MAX_RECORD:
                return None
            file.seek(start)
            summary, at = file.read(size - tail - start), 0
    except (OSError, ValueError):
        return None
    while at + HEAD.size <= len(summary):
        opcode, length = HEAD.unpack_from(summary, at)
        if opcode == 11 and length >= 42:
            return int(struct.unpack_from('<Q', summary, at + HEAD.size + 34)[0])
        at += HEAD.size + length
    return None
