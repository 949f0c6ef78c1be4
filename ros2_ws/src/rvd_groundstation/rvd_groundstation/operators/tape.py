"""
Tapes: recorded sticks, played in simulation time.

CSV     header `t_s,axis_0,axis_1,...,button_0,...`, one row per sample; lines that begin with
        `#` are comments. Axes are rounded to float32, in which a Joy carries them.
bag     a rosbag2 folder with MCAP files, or one .mcap file, with `/joy` (sensor_msgs/Joy);
        the stamps of its headers count, not the log times.
Time    0 is the first stamp. A sample holds until the next one; the last stamp is the end of
        the tape. After that the tape gives no axes and no buttons, which is invalid under every
        stick map: a pilot who has let go of the stick is not one who holds it neutral.

A malformed tape is refused as a whole, with file and line. Only a bag that was cut off while it
was recorded is played, as far as it goes.
"""

from array import array
from bisect import bisect_right
import csv
from dataclasses import dataclass
from math import isfinite
from pathlib import Path

from rvd_dynamics.constants import NS_PER_S

LATEST_S = 1e6                          # [s] stamps beyond lose digits in float seconds
TOPIC, MESSAGE = '/joy', 'sensor_msgs/msg/Joy'


@dataclass(frozen=True)
class Tape:
    """A recorded stick; entry i of each field is sample i."""

    stamps_ns: tuple[int, ...]          # [ns] since the first sample, rising from 0
    axes: tuple[tuple[float, ...], ...]
    buttons: tuple[tuple[int, ...], ...]

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


def read_tape(path: str | Path) -> Tape:
    """
    Read a tape.

    Parameters
    ----------
    path : str or Path
        A folder or a file ending in .mcap is a bag, anything else CSV.

    Returns
    -------
    Tape

    Raises
    ------
    ValueError
        If there is no such tape or it cannot be played; the text is one line that names the
        file and, if possible, the line or message.
    """
    path = Path(path)
    try:
        if path.is_dir() or path.suffix == '.mcap':
            return _read_bag(path)
        return _read_csv(path)
    except OSError as error:
        raise ValueError(f'{path}: cannot read the tape: {error.strerror or error}') from None
    except (UnicodeDecodeError, csv.Error):
        raise ValueError(f'{path}: the tape is not a CSV text file') from None


class _Samples:
    """Collects samples and refuses the first one that does not fit."""

    def __init__(self) -> None:
        self._stamps: list[int] = []
        self._axes: list[tuple] = []
        self._buttons: list[tuple] = []

    def add(self, where: str, stamp_ns: int, axes: tuple, buttons: tuple) -> None:
        """Take one sample; `where` names it in a refusal."""
        for i, value in enumerate(axes):
            if not isfinite(value):
                raise ValueError(f'{where}: axis_{i} must be finite, got {value}')
        if self._stamps and stamp_ns <= self._stamps[-1]:
            raise ValueError(f'{where}: time must rise, got {stamp_ns / NS_PER_S:.9g} s after '
                             f'{self._stamps[-1] / NS_PER_S:.9g} s')
        self._stamps.append(stamp_ns)
        self._axes.append(axes)
        self._buttons.append(buttons)

    def tape(self, path: Path) -> Tape:
        if not self._stamps:
            raise ValueError(f'{path}: the tape holds no sample')
        first = self._stamps[0]
        return Tape(tuple(t - first for t in self._stamps), tuple(self._axes),
                    tuple(self._buttons))


def _read_csv(path: Path) -> Tape:
    samples, axes = _Samples(), -1
    with path.open(newline='', encoding='utf-8') as file:
        rows = csv.reader(file)
        for row in rows:
            where = f'{path}, line {rows.line_num}'
            if not row or row[0].lstrip().startswith('#'):
                continue
            if axes < 0:
                header = [name.strip() for name in row]
                axes = _axes_of(header, where)
                continue
            if len(row) != len(header):
                raise ValueError(f'{where}: {len(header)} columns expected, got {len(row)}')
            time_s = _number(row[0], 't_s', where)
            if not abs(time_s) <= LATEST_S:
                raise ValueError(f'{where}: t_s must be within {LATEST_S:g}, got {row[0]}')
            samples.add(
                where, round(time_s * NS_PER_S),
                tuple(array('f', [_number(text, name, where)])[0]       # as a Joy carries it
                      for name, text in zip(header[1:axes + 1], row[1:axes + 1])),
                tuple(_button(text, name, where)
                      for name, text in zip(header[axes + 1:], row[axes + 1:])))
    if axes < 0:
        raise ValueError(f'{path}: the tape has no header t_s,axis_0,...,button_0,...')
    return samples.tape(path)


def _axes_of(header: list[str], where: str) -> int:
    """Return the number of axes that a header names, or refuse it."""
    axes = sum(name.startswith('axis_') for name in header)
    expected = ['t_s', *(f'axis_{i}' for i in range(axes)),
                *(f'button_{i}' for i in range(len(header) - 1 - axes))]
    if header != expected or axes == 0:
        raise ValueError(f'{where}: the header must be t_s,axis_0,...,button_0,..., '
                         f'got {",".join(header)}')
    return axes


def _number(text: str, name: str, where: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise ValueError(f'{where}: {name} must be a number, got {text.strip()!r}') from None


def _button(text: str, name: str, where: str) -> int:
    value = _number(text, name, where)
    if value not in (0.0, 1.0):
        raise ValueError(f'{where}: {name} must be 0 or 1, got {text.strip()}')
    return int(value)


def _read_bag(path: Path) -> Tape:
    from rvd_dynamics.recording.messages import files_of, MessageFile, stamp_ns
    samples = _Samples()
    for file in files_of(path):
        content = MessageFile(file, {TOPIC}, refuse_damage=True)
        for stored in content:
            _check_type(file, stored.source.kind, stored.source.encoding)
            joy = stored.message
            samples.add(f'{file}, {TOPIC} message {stored.number}',
                        stamp_ns(joy.header.stamp), tuple(joy.axes), tuple(joy.buttons))
        for source in content.sources:          # also one without messages
            if source.topic == TOPIC:
                _check_type(file, source.kind, source.encoding)
    return samples.tape(path)


def _check_type(file: Path, kind: str, encoding: str) -> None:
    if (kind, encoding) != (MESSAGE, 'cdr'):
        raise ValueError(f'{file}: {TOPIC} must be {MESSAGE} in cdr, got {kind or "no schema"} in '
                         f'{encoding}')
