"""The driver of a joystick or gamepad on this machine: a device, its Joy, and the node."""
