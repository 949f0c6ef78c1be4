"""
Parameters of a node from the settings classes: declared once, with meaning and limits.
"""

from dataclasses import Field
from typing import Any

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException
from rclpy.node import Node

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import build, default_of, leaves


def declare(node: Node, cls: type, prefix: str = '') -> Any:
    """
    Declare every parameter of the settings class `cls` on `node` and return the settings object.

    `prefix` stands before every key, with its dot.

    An integer is accepted where a float is meant (`step_s: 1`), which ROS itself refuses.

    Raises
    ------
    ValueError
        If a value has the wrong type or is refused by the settings; names key and value.
    """
    values = {}
    for key, field in leaves(cls):
        default = default_of(field)
        if hasattr(cls, 'preset'):              # its first parameters decide about the others
            default = cls.preset(values).get(key, default)
        if isinstance(default, tuple):
            default = list(default)
        try:
            values[key] = node.declare_parameter(prefix + key, default, descriptor_of(field)).value
        except InvalidParameterValueException:
            # Out of range. Taken all the same, for `build` to refuse it in our own words.
            anything = ParameterDescriptor(dynamic_typing=True, read_only=True)
            values[key] = node.declare_parameter(prefix + key, default, anything).value
        except InvalidParameterTypeException as error:      # pragma: no cover - dynamic typing
            raise BadInput(f'{prefix}{key}: {error}') from None
    return build(cls, values, label=prefix)


def descriptor_of(field: Field) -> ParameterDescriptor:
    """
    Return what `ros2 param describe` shows of a parameter that `leaves` yielded.

    A number between two bounds gets a range. For all else ROS has no form: choices, open bounds
    and lists are said in words.
    """
    bounds = field.metadata['bounds']
    descriptor = ParameterDescriptor(
        description=field.metadata['doc'], dynamic_typing=True, read_only=True)
    if not bounds.closed:
        descriptor.additional_constraints = bounds.meaning
    elif bounds.kind is int:
        descriptor.integer_range = [
            IntegerRange(from_value=int(bounds.low), to_value=int(bounds.high))]
    else:
        descriptor.floating_point_range = [
            FloatingPointRange(from_value=float(bounds.low), to_value=float(bounds.high))]
    return descriptor
