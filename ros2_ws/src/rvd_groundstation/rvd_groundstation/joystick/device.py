"""
A joystick or gamepad, through pygame-ce.

pygame-ce carries SDL 2, on which `joy_node` stands: axes, buttons and hats have the same numbers.
It has wheels for Python 3.10 to 3.13; evdev has none, and would need a compiler and the kernel's
headers. SDL's own drivers for game pads (HIDAPI) are left out: they number the axes anew, by pad
and by what the user may open.
"""

from dataclasses import dataclass
import os
from pathlib import Path
from typing import Any

INPUTS = Path('/dev/input')
FULL = 32767.0 / 32768.0                # what pygame makes of SDL's full deflection, one way
SETTINGS = {
    'SDL_VIDEODRIVER': 'dummy', 'SDL_AUDIODRIVER': 'dummy',     # neither window nor sound
    'SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS': '1',                # there is no window to have focus
    'SDL_JOYSTICK_HIDAPI': '0',
    'SDL_NO_SIGNAL_HANDLERS': '1',                              # Ctrl-C is the process's own
    'PYGAME_HIDE_SUPPORT_PROMPT': '1',
}


@dataclass(frozen=True)
class Reading:
    """Where a stick stands; hats follow the axes, two for each, as `joy_node` has them."""

    axes: tuple[float, ...]             # -1 to 1; positive forwards, left and up
    buttons: tuple[int, ...]            # 1: down


class Device:
    """
    The stick with a number or a name: there or not, plugged in and out at any moment.

    Attributes
    ----------
    name : str
        Of the device in use; empty if there is none.
    """

    def __init__(self, number: int = 0, name: str = '') -> None:
        os.environ.update(SETTINGS)
        import pygame
        self._pygame = pygame
        pygame.display.init()                   # SDL hands out no events without it
        pygame.joystick.init()
        self._number, self._wanted = number, name
        self._stick: Any = None
        self.name = ''

    def poll(self) -> Reading | None:
        """Return where the stick stands now; None if it is not there."""
        for event in self._pygame.event.get():
            if event.type == self._pygame.JOYDEVICEREMOVED and self._stick is not None \
                    and event.instance_id == self._stick.get_instance_id():
                self._stick.quit()
                self._stick, self.name = None, ''
        if self._stick is None:
            self._stick = self._found()
            if self._stick is None:
                return None
            self.name = self._stick.get_name()
        stick = self._stick
        axes = [-stick.get_axis(i) / FULL + 0.0 for i in range(stick.get_numaxes())]
        for i in range(stick.get_numhats()):
            right, up = stick.get_hat(i)
            axes += [-right + 0.0, up + 0.0]
        return Reading(tuple(max(-1.0, min(1.0, a)) for a in axes),
                       tuple(stick.get_button(i) for i in range(stick.get_numbuttons())))

    def names(self) -> list[str]:
        """Return the names of all devices, by their numbers."""
        joystick = self._pygame.joystick
        return [joystick.Joystick(i).get_name() for i in range(joystick.get_count())]

    def _found(self) -> Any:
        joystick = self._pygame.joystick
        for i in range(joystick.get_count()):
            if not self._wanted and i != self._number:
                continue
            stick = joystick.Joystick(i)
            if not self._wanted or stick.get_name() == self._wanted:
                return stick
        return None

    def why_not(self) -> str:
        """Say in one line why there is no stick, and what to do."""
        names = self.names()
        if names:
            wanted = f'named {self._wanted!r}' if self._wanted else f'with number {self._number}'
            return (f'no stick {wanted}: there is '
                    + ', '.join(f'{i} {name!r}' for i, name in enumerate(names)))
        if not INPUTS.is_dir():
            return ('no stick: this machine has no /dev/input; a container needs '
                    '--device /dev/input')
        closed = [p for p in INPUTS.glob('event*') if not os.access(p, os.R_OK)]
        if closed:
            return (f'no stick that this user may read ({len(closed)} devices in /dev/input are '
                    'closed): sudo usermod -aG input $USER, then log in again')
        return 'no stick is plugged in'

    def close(self) -> None:
        """Give the devices back."""
        self._pygame.joystick.quit()
        self._pygame.display.quit()
