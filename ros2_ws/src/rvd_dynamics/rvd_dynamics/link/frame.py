"""
Payloads of the space link: fixed little-endian structures that end in a CRC-32.

    command    version u8, key u16, session u64, sequence u64, generated i64 ns, kind u8,
               levels 3 x i8, CRC u32: 35 bytes
    downlink   version u8, key u16, session u64, sequence u64, generated i64 ns, kind u8,
               state 6 x f64 [m, m/s], accepted sequence u64, refusal u8, CRC u32: 89 bytes

`unpack_*` checks the length, then the checksum, and only then parses; it does not raise for any
bytes. CRC-32 detects every burst of up to 32 flipped bits (bits numbered from the least
significant of each byte). It does not keep a stranger out: that takes keys, and key 0 says
that there are none.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from struct import Struct
from zlib import crc32

from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.params import require

VERSION = 1
KEY = 0                         # no key yet: a CRC takes the place of a signature
SESSION = 0                     # no sessions yet
STATE = 0                       # kind of a downlink: a measured relative state
LEVELS = range(-3, 4)           # those of the thrusters

_COMMAND = Struct('<BHQQqB3b')
_DOWNLINK = Struct('<BHQQqB6dQB')
_CRC = Struct('<I')
COMMAND_BYTES = _COMMAND.size + _CRC.size
DOWNLINK_BYTES = _DOWNLINK.size + _CRC.size


class Refusal(IntEnum):
    """Why a frame was refused; a subset of the REASON codes."""

    LENGTH = codes.REASON_LENGTH
    CHECKSUM = codes.REASON_CHECKSUM
    ORDER = codes.REASON_ORDER
    AGE = codes.REASON_AGE
    RANGE = codes.REASON_RANGE


@dataclass(frozen=True, slots=True)
class Command:
    """A command as sent; `kind` and `levels` are not yet checked."""

    sequence: int               # rising by one per frame, the first is 1
    generated_ns: int           # [ns] instant of the step it was made in
    kind: int                   # one of codes.KIND_*, or unknown
    levels: tuple               # along x, y, z; to be in [-3..3]


@dataclass(frozen=True, slots=True)
class Downlink:
    """A measurement as sent, and what the guard last did."""

    sequence: int               # rising by one per frame, the first is 1
    generated_ns: int           # [ns] instant the state was measured
    state: tuple                # x, y, z, vx, vy, vz [m, m/s], NaN when unknown
    accepted_sequence: int      # last command that the guard accepted, 0 when none
    refusal: int                # last refusal code of the guard, 0 when none


def pack_command(sequence: int, generated_ns: int, levels: Sequence[int],
                 kind: int = codes.KIND_THRUST) -> bytes:
    """
    Return the 35 bytes of a command.

    Raises
    ------
    ValueError
        If a field does not fit, `kind` is unknown or a level is not -3..3.
    """
    _require_head(sequence, generated_ns)
    require(codes.KIND_THRUST <= kind <= codes.KIND_RESUME, 'kind', 'be 0 to 4', kind)
    levels = tuple(levels)
    require(len(levels) == 3 and levels_in_range(levels), 'levels',
            'be three whole numbers from -3 to 3', levels)      # before int(): NaN has no int
    return _sealed(_COMMAND.pack(VERSION, KEY, SESSION, sequence, generated_ns, kind,
                                 *(int(level) for level in levels)))


def unpack_command(payload: bytes) -> Command | Refusal:
    """Return the command in `payload`, or LENGTH, CHECKSUM, or RANGE for an unknown version."""
    broken = _broken(payload, COMMAND_BYTES)
    if broken is not None:
        return broken
    version, key, session, sequence, generated_ns, kind, *levels = _COMMAND.unpack(
        payload[:_COMMAND.size])
    if (version, key, session) != (VERSION, KEY, SESSION):
        return Refusal.RANGE
    return Command(sequence, generated_ns, kind, tuple(levels))


def pack_downlink(sequence: int, generated_ns: int, state: Sequence[float],
                  accepted_sequence: int = 0, refusal: int = 0) -> bytes:
    """
    Return the 89 bytes of a downlink; `state` (6,) may hold NaN.

    Raises
    ------
    ValueError
        If a field does not fit.
    """
    _require_head(sequence, generated_ns)
    require(len(state) == 6, 'state', 'have six components', len(state))
    require(0 <= accepted_sequence < 1 << 64, 'accepted_sequence', 'fit 64 bits',
            accepted_sequence)
    require(0 <= refusal < 1 << 8, 'refusal', 'fit 8 bits', refusal)
    return _sealed(_DOWNLINK.pack(VERSION, KEY, SESSION, sequence, generated_ns, STATE, *state,
                                  accepted_sequence, refusal))


def unpack_downlink(payload: bytes) -> Downlink | Refusal:
    """Return the downlink in `payload`, or LENGTH, CHECKSUM, or RANGE for an unknown kind."""
    broken = _broken(payload, DOWNLINK_BYTES)
    if broken is not None:
        return broken
    version, key, session, sequence, generated_ns, kind, *rest = _DOWNLINK.unpack(
        payload[:_DOWNLINK.size])
    if (version, key, session, kind) != (VERSION, KEY, SESSION, STATE):
        return Refusal.RANGE
    return Downlink(sequence, generated_ns, tuple(rest[:6]), *rest[6:])


def levels_in_range(levels: tuple) -> bool:
    """Say whether every level is one that the thrusters have (NaN and 1.5 are not)."""
    return all(level in LEVELS for level in levels)


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
