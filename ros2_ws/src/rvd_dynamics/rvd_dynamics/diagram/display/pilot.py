"""What a pilot is given at hand: large digits at the reticle, and what a good approach is."""

from dataclasses import dataclass

from rvd_dynamics.diagram.display.parts import Number, require_digits, require_finite
from rvd_dynamics.diagram.display.readings import Reading
from rvd_dynamics.diagram.params import require


@dataclass(frozen=True)
class Motion:
    """
    One direction at the reticle: how far, and how fast; measured, and predicted beside it.

    Numbers are written with their sign if they are `signed`.
    """

    label: str                  # of the place: "up"
    place: tuple[Reading, ...] = ()
    rate: tuple[Reading, ...] = ()
    rate_label: str = ''        # of the rate, where it is not that of the place by its own name
    signed: bool = True

    def __post_init__(self) -> None:
        require(bool(self.label), 'motion.label', 'not be empty', repr(self.label))
        require(bool(self.place or self.rate), f'motion {self.label}', 'have a reading',
                self.place)


@dataclass(frozen=True)
class Digits:
    """The large digits over the picture of a camera: places in one unit, rates in another."""

    rows: tuple[Motion, ...]
    place_unit: str = 'm'
    rate_unit: str = 'm/s'
    place_digits: int = 2
    rate_digits: int = 3

    def __post_init__(self) -> None:
        require(0 < len(self.rows) <= 4, 'digits.rows', 'be 1 to 4', len(self.rows))
        require_digits('digits.place_digits', self.place_digits)
        require_digits('digits.rate_digits', self.rate_digits)


@dataclass(frozen=True)
class Gate:
    """Where an approach is checked, and what it should be like there, in words."""

    at: float                   # distance, in the unit of the guidance
    wanted: tuple[str, ...]     # "within 0.9 m of the axis", "0.25 m/s"

    def __post_init__(self) -> None:
        require_finite('gate.at', self.at)
        require(len(self.wanted) > 0, 'gate.wanted', 'be one or more', self.wanted)


@dataclass(frozen=True)
class Guidance:
    """
    What a good approach is: gates from far to near, and the limits at contact.

    `distance` tells which gate comes next: the first of its numbers that is known.
    """

    gates: tuple[Gate, ...]
    contact: tuple[str, ...]
    distance: tuple[Number, ...]
    unit: str = 'm'
    contact_label: str = 'contact'

    def __post_init__(self) -> None:
        stations = [gate.at for gate in self.gates]
        require(stations == sorted(stations, reverse=True), 'guidance.gates',
                'lead from far to near', stations)
        require(bool(self.gates or self.contact), 'guidance', 'say something', self.gates)
