"""What becomes of a device's readings: dead zone, sticky buttons, and when a Joy is due."""

from rvd_groundstation.joystick.device import Reading
from rvd_groundstation.joystick.params import JoystickParams


def outside(value: float, dead_zone: float) -> float:
    """Return a deflection -1 to 1 without its dead zone: 0 inside, from there on rising to 1."""
    size = abs(value) - dead_zone
    return 0.0 if size <= 0.0 else (1.0 if value > 0.0 else -1.0) * size / (1.0 - dead_zone)


class Messages:
    """Makes Joys of readings, by the wall clock of the caller."""

    def __init__(self, settings: JoystickParams) -> None:
        self._settings = settings
        self._repeat_s = 1.0 / settings.autorepeat_rate if settings.autorepeat_rate else None
        self.lost()

    def lost(self) -> None:
        """Forget the stick: the next one begins anew."""
        self._down: tuple[int, ...] = ()
        self._sticky: list[int] = []
        self._sent: Reading | None = None
        self._sent_at = 0.0
        self._changed_at: float | None = None

    def due(self, reading: Reading, now: float) -> Reading | None:
        """Return what is to be sent at `now` [s]; None if nothing is."""
        made = Reading(tuple(outside(a, self._settings.deadzone) for a in reading.axes),
                       self._buttons(reading.buttons))
        if self._sent is not None and made != self._sent:
            if self._changed_at is None:
                self._changed_at = now
            # a button is never held back
            waits = made.buttons == self._sent.buttons and \
                now - self._changed_at < self._settings.coalesce_interval_ms * 1e-3
        else:
            self._changed_at = None
            waits = self._sent is not None and not (
                self._repeat_s is not None and now - self._sent_at >= self._repeat_s)
        if waits:
            return None
        self._sent, self._sent_at, self._changed_at = made, now, None
        return made

    def _buttons(self, down: tuple[int, ...]) -> tuple[int, ...]:
        if not self._settings.sticky_buttons:
            return down
        if len(self._sticky) != len(down):
            self._sticky, self._down = [0] * len(down), (0,) * len(down)
        for i, (before, now) in enumerate(zip(self._down, down)):
            if now and not before:
                self._sticky[i] = 1 - self._sticky[i]
        self._down = down
        return tuple(self._sticky)
