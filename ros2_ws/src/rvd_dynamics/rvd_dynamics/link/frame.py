"""
Payloads of the space link: fixed little-endian structures that end in a CRC-32.

    command    version u8, key u16, session u64, sequence u64, generated i64 ns, kind u8,
               command as its form lays it out, CRC u32; 35 bytes for three levels i8
    downlink   version u8, key u16, session u64, sequence u64, generated i64 ns, kind u8,
               state n x f64, accepted sequence u64, refusal u8, CRC u32; 89 bytes for n = 6

`unpack_*` checks the length, then the checksum, and only then parses; it does not raise for any
bytes. CRC-32 detects every burst of up to 32 flipped bits (bits numbered from the least
significant of each byte). It does not keep a stranger out: that takes keys, and key 0 says
that there are none.

A receiver takes each frame once, by its number (`ReplayWindow`): the ground by that alone, the
guard's gate takes none that is older than the newest.

Source  of the window: IP Encapsulating Security Payload, RFC 4303, section 3.4.3 and appendix A2
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from functools import lru_cache
from struct import Struct
from zlib import crc32

from rvd_dynamics.commands import codes
from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.commands.levels import LevelForm
from rvd_dynamics.diagram.params import require

VERSION = 1
KEY = 0                         # no key yet: a CRC takes the place of a signature
SESSION = 0                     # no sessions yet
STATE = 0                       # kind of a downlink: a measured relative state

_HEAD = Struct('<BHQQqB')
_CRC = Struct('<I')
THREE_LEVELS = LevelForm()
WINDOW = 2048                   # [frames] more than come late and wait in a reader's queue


class Refusal(IntEnum):
    """Why a frame was refused; a subset of the REASON codes."""

    LENGTH = codes.REASON_LENGTH
    CHECKSUM = codes.REASON_CHECKSUM
    ORDER = codes.REASON_ORDER
    AGE = codes.REASON_AGE
    RANGE = codes.REASON_RANGE


@dataclass(frozen=True, slots=True)
class Command:
    """A command as sent; `kind` and `command` are not yet checked."""

    sequence: int               # rising by one per frame, the first is 1
    generated_ns: int           # [ns] instant of the step it was made in
    kind: int                   # one of codes.KIND_*, or unknown
    command: tuple              # numbers of the command form


@dataclass(frozen=True, slots=True)
class Downlink:
    """A measurement as sent, and what the guard last did."""

    sequence: int               # rising by one per frame, the first is 1
    generated_ns: int           # [ns] instant the state was measured
    state: tuple                # what was measured, NaN when unknown
    accepted_sequence: int      # last command that the guard accepted, 0 when none
    refusal: int                # last refusal code of the guard, 0 when none


def pack_command(sequence: int, generated_ns: int, command: Sequence,
                 kind: int = codes.KIND_THRUST, form: CommandForm = THREE_LEVELS) -> bytes:
    """
    Return the bytes of a command.

    Raises
    ------
    ValueError
        If a field does not fit, `kind` is unknown or the command is none of the form.
    """
    _require_head(sequence, generated_ns)
    require(codes.KIND_THRUST <= kind <= codes.KIND_RESUME, 'kind', 'be 0 to 4', kind)
    command = tuple(command)
    require(len(command) == len(form.neutral) and form.legal(command), 'command',
            f'be a command of {type(form).__name__}', command)  # before packing: NaN has no int
    return _sealed(_HEAD.pack(VERSION, KEY, SESSION, sequence, generated_ns, kind)
                   + form.wire.pack(*command))


def unpack_command(payload: bytes, form: CommandForm = THREE_LEVELS) -> Command | Refusal:
    """Return the command in `payload`, or LENGTH, CHECKSUM, or RANGE for an unknown version."""
    broken = _broken(payload, _HEAD.size + form.wire.size + _CRC.size)
    if broken is not None:
        return broken
    version, key, session, sequence, generated_ns, kind = _HEAD.unpack(payload[:_HEAD.size])
    if (version, key, session) != (VERSION, KEY, SESSION):
        return Refusal.RANGE
    return Command(sequence, generated_ns, kind,
                   form.wire.unpack(payload[_HEAD.size:-_CRC.size]))


@lru_cache(maxsize=None)
def _measured(width: int) -> Struct:
    """Return the layout behind the head of a downlink of `width` numbers."""
    return Struct(f'<{width}dQB')


def pack_downlink(sequence: int, generated_ns: int, state: Sequence[float],
                  accepted_sequence: int = 0, refusal: int = 0) -> bytes:
    """
    Return the bytes of a downlink; `state` (n,) may hold NaN.

    Raises
    ------
    ValueError
        If a field does not fit.
    """
    _require_head(sequence, generated_ns)
    require(len(state) >= 1, 'state', 'have a component', len(state))
    require(0 <= accepted_sequence < 1 << 64, 'accepted_sequence', 'fit 64 bits',
            accepted_sequence)
    require(0 <= refusal < 1 << 8, 'refusal', 'fit 8 bits', refusal)
    return _sealed(_HEAD.pack(VERSION, KEY, SESSION, sequence, generated_ns, STATE)
                   + _measured(len(state)).pack(*state, accepted_sequence, refusal))


def unpack_downlink(payload: bytes, width: int = 6) -> Downlink | Refusal:
    """Return the downlink of `width` numbers, or LENGTH, CHECKSUM, or RANGE of an unknown kind."""
    layout = _measured(width)
    broken = _broken(payload, _HEAD.size + layout.size + _CRC.size)
    if broken is not None:
        return broken
    version, key, session, sequence, generated_ns, kind = _HEAD.unpack(payload[:_HEAD.size])
    if (version, key, session, kind) != (VERSION, KEY, SESSION, STATE):
        return Refusal.RANGE
    rest = layout.unpack(payload[_HEAD.size:-_CRC.size])
    return Downlink(sequence, generated_ns, rest[:width], *rest[width:])


class ReplayWindow:
    """
    Numbers that have been taken, as far back as the window is long; marked by intact frames alone.

    A frame that comes after a newer one is taken, too: a link may let frames overtake each other.
    What lies before the window is refused, since nobody remembers whether it has been there.

    Parameters
    ----------
    size : int
        Length of the window [frames].
    """

    def __init__(self, size: int = WINDOW) -> None:
        require(size >= 1, 'size', 'be at least 1', size)
        self._size, self._whole = size, (1 << size) - 1
        self._newest = 0                        # highest number taken; the first frame has 1
        self._taken = 0                         # bit i: newest - i has been taken

    def takes(self, number: int) -> bool:
        """Say whether a frame is new, and note that it has been taken if so."""
        ahead = number - self._newest
        if ahead > 0:
            self._taken = (self._taken << ahead & self._whole | 1) if ahead < self._size else 1
            self._newest = number
            return True
        if number < 1 or -ahead >= self._size or self._taken >> -ahead & 1:
            return False
        self._taken |= 1 << -ahead
        return True


def _sealed(body: bytes) -> bytes:
    return body + _CRC.pack(crc32(body))


def _broken(payload: bytes, size: int) -> Refusal | None:
    if len(payload) != size:
        return Refusal.LENGTH
    if crc32(payload[:-_CRC.size]) != _CRC.unpack(payload[-_CRC.size:])[0]:
        return Refusal.CHECKSUM
    return None


def _require_head(sequence: int, generated_ns: int) -> None:
    require(1 <= sequence < 1 << 64, 'sequence', 'be 1 or more and fit 64 bits', sequence)
    require(-1 << 63 <= generated_ns < 1 << 63, 'generated_ns', 'fit 64 bits', generated_ns)
