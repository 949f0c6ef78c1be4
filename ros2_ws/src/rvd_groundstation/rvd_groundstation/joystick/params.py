"""
Settings of `joystick`: names and defaults of `joy_node` of the package joy
(docs.ros.org/en/jazzy/p/joy).
"""

from rvd_dynamics.diagram.params import param, settings


@settings
class JoystickParams:
    """Settings of `joystick`, the driver of a stick on this machine; those of `joy_node`."""

    device_id: int = param(0, 'Number of the device, counted from 0.', low=0, high=63)
    device_name: str = param(
        '', 'Name of the device as `./rvd stick` shows it; counts before device_id if given.')
    deadzone: float = param(
        0.05, 'Deflection up to which an axis is sent as 0, as a fraction of full deflection; '
        'beyond, it rises from 0.', low=0.0, below=1.0)
    autorepeat_rate: float = param(
        20.0, 'Rate at which a stick that does not change is sent again [Hz], 0 for never.',
        low=0.0, high=1000.0)
    sticky_buttons: bool = param(
        False, 'Whether a press of a button switches it over instead of holding it down.')
    coalesce_interval_ms: int = param(
        1, 'Time after a change in which further changes go into the same message [ms].',
        low=0, high=1000)
