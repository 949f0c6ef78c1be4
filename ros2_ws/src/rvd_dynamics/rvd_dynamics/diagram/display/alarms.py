"""Alarms of a display: which reading, which limit, in which words."""

from dataclasses import dataclass

from rvd_dynamics.diagram.display.parts import is_real, require_digits
from rvd_dynamics.diagram.display.readings import Reading
from rvd_dynamics.diagram.params import require

LEVELS = ('warning', 'caution')


@dataclass(frozen=True)
class Alarm:
    """
    What a page calls out while one of some readings is at or beyond its limit.

    It is raised at once and goes when each reading has been inside its limit by `back`, in the
    reading's own unit, for a moment: a number that hovers about its limit does not flicker.
    Beside `words` the page writes `label`, the reading furthest beyond its limit, and that limit.
    """

    words: str                  # what is wrong, in capitals: "TOO FAST"
    readings: tuple[Reading, ...]
    label: str = ''             # of the number; '' where there is none that says anything
    unit: str = ''
    digits: int = 2
    back: float = 0.0
    level: str = 'warning'      # a warning asks for action at once, a caution for attention

    def __post_init__(self) -> None:
        require(bool(self.words), 'alarm.words', 'not be empty', repr(self.words))
        where = f'alarm {self.words}'
        require(len(self.readings) > 0 and all(isinstance(r, Reading) for r in self.readings),
                f'{where}: readings', 'be one or more', self.readings)
        for reading in self.readings:
            require(reading.role != 'truth', f'{where}: role',
                    'be another than truth, which no live page has', repr(reading.role))
            require(reading.low is not None or reading.high is not None, f'{where}: readings',
                    'each have a limit, low or high', reading)
        require(is_real(self.back) and 0.0 <= self.back < float('inf'), f'{where}: back',
                'be finite and not negative', self.back)
        require_digits(f'{where}: digits', self.digits)
        require(self.level in LEVELS, f'{where}: level', f'be one of {", ".join(LEVELS)}',
                repr(self.level))
