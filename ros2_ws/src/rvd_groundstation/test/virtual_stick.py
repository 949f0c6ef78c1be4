"""
A stick that is not there: SDL's virtual joystick, below pygame, so that it is real for the driver.

`/dev/uinput`, where it exists, would add the kernel; SDL's own device needs neither it nor root.
"""

import ctypes


def library():
    """Return the SDL that pygame has loaded into this process."""
    with open('/proc/self/maps', encoding='utf-8') as maps:
        path = next(line.split()[-1] for line in maps if 'libSDL2-2' in line)
    sdl = ctypes.CDLL(path)
    sdl.SDL_JoystickFromInstanceID.restype = ctypes.c_void_p
    return sdl


class VirtualStick:
    """Plugged in when made; `Device` must be there already, and open it before it is moved."""

    def __init__(self, axes=6, buttons=8, hats=1):
        self._sdl = library()
        self._index = self._sdl.SDL_JoystickAttachVirtual(1, axes, buttons, hats)
        assert self._index >= 0
        self._id = self._sdl.SDL_JoystickGetDeviceInstanceID(self._index)

    def _opened(self):
        return ctypes.c_void_p(self._sdl.SDL_JoystickFromInstanceID(self._id))

    def move(self, axis, value):
        """Put an axis to -32768 .. 32767."""
        assert self._sdl.SDL_JoystickSetVirtualAxis(self._opened(), axis,
                                                    ctypes.c_int16(value)) == 0

    def press(self, button, down=1):
        assert self._sdl.SDL_JoystickSetVirtualButton(self._opened(), button, down) == 0

    def push_hat(self, hat, value):
        """Put a hat to 1 up, 2 right, 4 down, 8 left, or a sum of two."""
        assert self._sdl.SDL_JoystickSetVirtualHat(self._opened(), hat, value) == 0

    def unplug(self):
        index = next(i for i in range(self._sdl.SDL_NumJoysticks())
                     if self._sdl.SDL_JoystickGetDeviceInstanceID(i) == self._id)
        assert self._sdl.SDL_JoystickDetachVirtual(index) == 0
