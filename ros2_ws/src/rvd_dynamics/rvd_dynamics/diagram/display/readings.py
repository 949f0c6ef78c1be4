"""A number of a display with its limits."""

from dataclasses import dataclass

from rvd_dynamics.diagram.display.parts import COLUMNS, Number, require_finite
from rvd_dynamics.diagram.params import require


@dataclass(frozen=True)
class Reading:
    """A number in the column of its role; one at or beyond `low` or `high` is marked."""

    role: str
    value: Number
    low: float | Number | None = None
    high: float | Number | None = None

    def __post_init__(self) -> None:
        require(self.role in COLUMNS, 'reading.role', f'be one of {", ".join(COLUMNS)}',
                repr(self.role))
        for name in ('low', 'high'):
            limit = getattr(self, name)
            if limit is not None and not isinstance(limit, Number):
                require_finite(f'reading.{name}', limit)
