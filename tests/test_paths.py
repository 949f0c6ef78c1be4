"""Paths with any sign in them reach the nodes as they are, by arguments and parameter files."""

import pytest
import rclpy
from rclpy.context import Context
from runs import ROOT, rvd, verdict_of
import yaml

from rvd_campaign.flight.domain import reserved_domain
from rvd_dynamics.diagram.ros.arguments import parsed
from rvd_dynamics.diagram.roster import scalar
from rvd_dynamics.diagram.scenario import load

NAMES = ['/a #b', "/it's \"q\": $HOME `id` *x", '/d\u00e9j\u00e0 \u2713 \U0001f680\u2028z',
         '/a: {b, [c]}',
         '~', 'y', 'Off', '1e3', '0x10', '.5', '-nan', '123', '', ' ', '# x', '/two\nlines', 'a:=b',
         "'", '/tab\there', '/' + 'long name ' * 20]
SHORT = '/**:\n  ros__parameters: {step_s: 0.5, timeout_s: 0.5}\n'


def as_rclpy_reads(arguments, node, key):
    context = Context()
    with reserved_domain() as domain:
        rclpy.init(args=['--ros-args', *arguments], context=context, domain_id=domain)
        try:
            made = rclpy.create_node(node, context=context,
                                     automatically_declare_parameters_from_overrides=True)
            return made.get_parameter(key).value
        finally:
            rclpy.try_shutdown(context=context)


def test_scalar_is_one_line_that_ros_and_we_read_as_the_text():
    for text in NAMES:
        word = f'bag_recorder:bag_dir:={scalar(text)}'
        assert '\n' not in word
        _, _, value = parsed(['recorder', '--ros-args', '-p', word]).overrides[0]
        assert value == text
    arguments = [part for i, text in enumerate(NAMES)
                 for part in ('-p', f'bag_recorder:p{i}:={scalar(text)}')]
    assert as_rclpy_reads(arguments, 'bag_recorder', 'p0') == NAMES[0]


@pytest.mark.parametrize('text', NAMES, ids=ascii)
def test_ros_reads_scalar_and_dumped_scenario_as_the_text(text, tmp_path):
    bag_dir = as_rclpy_reads(['-p', f'bag_recorder:bag_dir:={scalar(text)}'], 'bag_recorder',
                             'bag_dir')
    assert bag_dir == text
    file = tmp_path / 'short.yaml'
    file.write_text(SHORT)
    file.write_text(load(file).with_values('joystick_replay', tape=text).dump())
    assert yaml.safe_load(file.read_text())['joystick_replay']['ros__parameters']['tape'] == text
    assert load(file).settings('joystick_replay').tape == text
    assert as_rclpy_reads(['--params-file', str(file)], 'joystick_replay', 'tape') == text


@pytest.mark.slow
@pytest.mark.parametrize('name', ['a #b', "it's \"q\": $HOME \u2713"])
def test_bag_lands_in_the_run_folder_whatever_its_name(name, tmp_path):
    (tmp_path / 'short.yaml').write_text(SHORT)
    tape = tmp_path / f'{name} tape.csv'
    tape.write_bytes((ROOT / 'tapes/docking.csv').read_bytes())
    done = rvd('fly', 'short.yaml', '--processes', 'one', '--pace', 'lockstep', '--headless',
               '--tape', str(tape), '--out', str(tmp_path / name), cwd=tmp_path)
    assert done.returncode == 1, done.stderr
    assert {p.name for p in tmp_path.iterdir()} == {'short.yaml', tape.name, name}
    assert list((tmp_path / name / 'bag').glob('*.mcap')) and verdict_of(tmp_path / name)
