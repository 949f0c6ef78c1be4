"""
Tapes: recorded sticks, played in simulation time.

CSV     header `t_s,axis_0,axis_1,...,button_0,...`, one row per sample; lines that begin with
        `#` are comments. UTF-8, with or without a byte-order mark. Axes are rounded to float32,
        in which a Joy carries them.
bag     a rosbag2 folder, or one file of it: MCAP or SQLite, also compressed, with a topic of
        sensor_msgs/Joy. The stamps of its headers count; where the publisher left them at zero
        or repeated them, the log times of the bag do, and the tape's `note` says so.
Time    0 is the first stamp. A sample holds until the next one; the last stamp is the end of
        the tape. After that the tape gives no axes and no buttons, which is invalid under every
        stick map: a pilot who has let go of the stick is not one who holds it neutral.

A malformed tape is refused as a whole, with file and line. Only a bag that was cut off while it
was recorded is played, as far as it goes.
"""

from array import array
from bisect import bisect_right
import codecs
from dataclasses import dataclass
from decimal import Decimal
from math import isfinite
from pathlib import Path
import shlex
from typing import TYPE_CHECKING

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.given import bytes_of, rows_of

if TYPE_CHECKING:
    from rvd_dynamics.recording.messages import Source

LATEST_S = 9e9                          # [s] instants beyond do not fit into a stamp in ns
LONGEST_GAP_NS = 10**6 * NS_PER_S       # [ns] no stick rests for longer: a stamp was left at zero
TOPIC, MESSAGE = '/joy', 'sensor_msgs/msg/Joy'
MARKS = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)      # that of UTF-32 begins with the first


@dataclass(frozen=True)
class Tape:
    """A recorded stick; entry i of each field is sample i."""

    stamps_ns: tuple[int, ...]          # [ns] since the first sample, rising from 0
    axes: tuple[tuple[float, ...], ...]
    buttons: tuple[tuple[int, ...], ...]
    note: str = ''                      # what to tell who flies it, one sentence

    @property
    def end_ns(self) -> int:
        """Last instant of the tape [ns]."""
        return self.stamps_ns[-1]

    def at(self, t_ns: int) -> tuple[tuple[float, ...], tuple[int, ...]]:
        """Return axes and buttons at `t_ns` [ns]; empty ones outside the tape."""
        if not 0 <= t_ns <= self.end_ns:
            return (), ()
        i = bisect_right(self.stamps_ns, t_ns) - 1
        return self.axes[i], self.buttons[i]


def read_tape(path: str | Path, topic: str = TOPIC) -> Tape:
    """
    Read a tape.

    Parameters
    ----------
    path : str or Path
        A folder, or a file with a bag's ending (.mcap, .db3, either of them with .zstd), is a bag;
        anything else is CSV.
    topic : str
        Of the bag; CSV has none.

    Returns
    -------
    Tape

    Raises
    ------
    ValueError
        If there is no such tape or it cannot be played; the text is one line that names the
        file and, if possible, the line or message.
    """
    from rvd_dynamics.recording.messages import is_bag      # where there is a tape at all
    path = Path(path)
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            raise BadInput(f'{path}: a pipe or a device is no tape: it is read more than once, '
                           'write it to a file first')
        if is_bag(path):
            return _read_bag(path, topic)
        if topic != TOPIC:
            raise BadInput(f'{path}: a topic ({topic}) can be picked from a bag only: CSV has '
                           'none')
        if path.suffix == '.bag':
            raise BadInput(
                f'{path}: a bag of ROS 1; convert it with: ./rvd shell rosbags-convert --src '
                f'{shlex.quote(str(path))} --dst {shlex.quote(str(path.with_suffix("")))}')
        return _read_csv(path)
    except OSError as error:
        raise BadInput(f'cannot read tape {path}: {error.strerror or error}') from None


class _Samples:
    """Collects samples and refuses the first one that does not fit."""

    def __init__(self) -> None:
        self._wheres: list[str] = []
        self._axes: list[tuple] = []
        self._buttons: list[tuple] = []

    def add(self, where: str, axes: tuple, buttons: tuple) -> None:
        """Take one sample; `where` names it in a refusal."""
        for i, value in enumerate(axes):
            if not isfinite(value):
                raise BadInput(f'{where}: axis_{i} must be finite, got {value}')
        self._wheres.append(where)
        self._axes.append(axes)
        self._buttons.append(buttons)

    def tape(self, stamps_ns: list[int], note: str = '') -> Tape:
        """Return the tape with a stamp [ns] for each sample, or refuse stamps that do not rise."""
        at = fault(stamps_ns)
        if at:
            what = 'time must rise' if stamps_ns[at] <= stamps_ns[at - 1] else (
                f'time must rise by at most {LONGEST_GAP_NS / NS_PER_S:g} s')
            raise BadInput(f'{self._wheres[at]}: {what}, got {stamps_ns[at] / NS_PER_S:.12g} s '
                           f'after {stamps_ns[at - 1] / NS_PER_S:.12g} s')
        return Tape(tuple(t - stamps_ns[0] for t in stamps_ns), tuple(self._axes),
                    tuple(self._buttons), note)


def fault(stamps_ns: list[int]) -> int:
    """Return the index of the first stamp that cannot follow the one before; 0 if all can."""
    return next((i for i in range(1, len(stamps_ns))
                 if not 0 < stamps_ns[i] - stamps_ns[i - 1] <= LONGEST_GAP_NS), 0)


def _read_csv(path: Path) -> Tape:
    samples, stamps, axes = _Samples(), [], -1
    for number, row in rows_of(_text_of(path), str(path)):
        where = f'{path}, line {number}'
        if not row or row[0].lstrip().startswith('#'):
            continue
        if axes < 0:
            header = [name.strip() for name in row]
            axes = _axes_of(header, where)
            continue
        if len(row) != len(header):
            raise BadInput(f'{where}: {len(header)} columns expected, got {len(row)}')
        if not abs(_number(row[0], 't_s', where)) <= LATEST_S:
            raise BadInput(f'{where}: t_s must be within {LATEST_S:g} s, got {row[0]}')
        stamps.append(int((Decimal(row[0].strip()) * NS_PER_S).to_integral_value()))
        samples.add(
            where,
            tuple(array('f', [_number(text, name, where)])[0]       # as a Joy carries it
                  for name, text in zip(header[1:axes + 1], row[1:axes + 1])),
            tuple(_button(text, name, where)
                  for name, text in zip(header[axes + 1:], row[axes + 1:])))
    if axes < 0:
        raise BadInput(f'{path}: the tape has no header t_s,axis_0,...,button_0,...')
    if not stamps:
        raise BadInput(f'{path}: the tape holds no sample')
    return samples.tape(stamps)


def _text_of(path: Path) -> str:
    """Return a CSV file as text without a byte-order mark, or refuse it by its encoding."""
    data = bytes_of(path, 'tape')
    if data.startswith(MARKS) or b'\0' in data[:64]:
        raise BadInput(
            f'{path}: the tape is UTF-16 or binary, not UTF-8: save it as "CSV UTF-8", or convert '
            f'it with: iconv -f UTF-16 -t UTF-8 {shlex.quote(str(path))} > tape.csv')
    try:
        return data.decode('utf-8-sig')
    except UnicodeDecodeError as error:
        raise BadInput(f'{path}, line {data.count(10, 0, error.start) + 1}: the byte '
                       f'0x{data[error.start]:02x} is not UTF-8: save the tape as "CSV UTF-8"'
                       ) from None


def _axes_of(header: list[str], where: str) -> int:
    """Return the number of axes that a header names, or refuse it."""
    for mark, name, cure in ((';', 'semicolons', "sed 's/,/./g; s/;/,/g'"),
                             ('\t', 'tabs', "sed 's/,/./g; s/\\t/,/g'")):
        if header[0].partition(mark)[0].strip() == 't_s' and mark in header[0]:
            raise BadInput(
                f'{where}: the columns are separated by {name}, as spreadsheets do where the '
                'decimal mark is a comma; a tape has commas between columns and decimal points: '
                f'convert it with: {cure} OLD > NEW')
    axes = sum(name.startswith('axis_') for name in header)
    expected = ['t_s', *(f'axis_{i}' for i in range(axes)),
                *(f'button_{i}' for i in range(len(header) - 1 - axes))]
    if header != expected or axes == 0:
        raise BadInput(f'{where}: the header must be t_s,axis_0,...,button_0,..., '
                       f'got {",".join(header)}')
    return axes


def _number(text: str, name: str, where: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise BadInput(f'{where}: {name} must be a number, got {text.strip()!r}') from None


def _button(text: str, name: str, where: str) -> int:
    value = _number(text, name, where)
    if value not in (0.0, 1.0):
        raise BadInput(f'{where}: {name} must be 0 or 1, got {text.strip()}')
    return int(value)


def _read_bag(path: Path, topic: str) -> Tape:
    from rvd_dynamics.recording.messages import files_of, MessageFile, stamp_ns
    samples, stamps, logged = _Samples(), [], []
    sources: list['Source'] = []
    for file in files_of(path):
        content = MessageFile(file, {topic}, refuse_damage=True)
        for stored in content:
            _check_type(file, stored.source)
            where, joy = f'{file}, {topic} message {stored.number}', stored.message
            try:
                axes, buttons = tuple(map(float, joy.axes)), tuple(map(int, joy.buttons))
                stamps.append(stamp_ns(joy.header.stamp))
            except (AttributeError, TypeError, ValueError):     # by the bag's own definition
                raise BadInput(f'{where}: the bag defines {MESSAGE} otherwise than ROS does'
                               ) from None
            samples.add(where, axes, buttons)
            logged.append(stored.log_ns)
        for source in content.sources:          # also one without messages
            if source.topic == topic:
                _check_type(file, source)
        sources += content.sources
    if not stamps:
        raise BadInput(f'{path}: the tape holds no sample on {topic}; {_choice(sources)}')
    if fault(stamps) and not fault(logged):
        return samples.tape(logged, f'{path}: header stamps of {topic} are zero or repeated: '
                                    'the log times of the bag are used')
    return samples.tape(stamps)


def _choice(sources: list['Source']) -> str:
    """Say which topics a bag has that could be played."""
    sticks = {source.topic: 0 for source in sources if source.kind == MESSAGE}
    for source in sources:
        if source.topic in sticks:
            sticks[source.topic] += source.count
    played = [f'{topic} ({count} messages)' for topic, count in sticks.items() if count]
    if played:
        return f'{MESSAGE} is on {", ".join(played)}: pick one with --tape-topic'
    return f'the bag has no messages of {MESSAGE}'


def _check_type(file: Path, source: 'Source') -> None:
    if (source.kind, source.encoding) != (MESSAGE, 'cdr'):
        raise BadInput(f'{file}: {source.topic} must be {MESSAGE} in cdr, got '
                       f'{source.kind or "no schema"} in {source.encoding}')
