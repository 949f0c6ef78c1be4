"""The plain integers of `codes` are those of the message that travels."""

from pathlib import Path
import re

from rvd_dynamics.commands import codes

MESSAGE = Path(__file__).parents[2] / 'rvd_interfaces' / 'msg' / 'ThrustCommand.msg'


def test_every_constant_of_the_message_is_here_and_no_other():
    found = re.findall(r'^uint8 ([A-Z_]+)\s*=\s*(\d+)', MESSAGE.read_text(), re.MULTILINE)
    declared = {name: int(value) for name, value in found}
    assert len(declared) == 23
    assert declared == {k: v for k, v in vars(codes).items() if k.isupper()}
