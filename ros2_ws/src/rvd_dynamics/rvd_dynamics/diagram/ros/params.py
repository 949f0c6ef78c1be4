"""
Parameters of a node from the settings classes: declared once, with meaning and limits.
"""

from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.exceptions import InvalidParameterTypeException
from rclpy.node import Node

from rvd_dynamics.diagram.params import build, default_of, leaves


def declare(node: Node, settings: type, prefix: str = '') -> Any:
    """
    Declare every parameter of `settings` on `node` and return the settings object.

    `prefix` stands before every key, with its dot.

    An integer is accepted where a float is meant (`step_s: 1`), which ROS itself refuses.

    Raises
    ------
    ValueError
        If a value has the wrong type or is refused by the settings; names key and value.
    """
    values = {}
    for key, field in leaves(settings):
        default = default_of(field)
        if isinstance(default, tuple):
            default = list(default)
        descriptor = ParameterDescriptor(
            description=field.metadata['doc'], dynamic_typing=True, read_only=True)
        try:
            values[key] = node.declare_parameter(prefix + key, default, descriptor).value
        except InvalidParameterTypeException as error:      # pragma: no cover - dynamic typing
            raise ValueError(f'{prefix}{key}: {error}') from None
    return build(settings, values, label=prefix)

