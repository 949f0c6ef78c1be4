"""The benchmarks measure what they say; how fast this machine is, is not tested."""

import json
import time

import pytest
from rclpy.context import Context
from rclpy.node import Node
from rclpy.serialization import deserialize_message, serialize_message
from rosbags.highlevel import AnyReader
from runs import ROOT, rvd, wait_for
from sensor_msgs.msg import Joy
from std_msgs.msg import Header, UInt64

from rvd_campaign.bench import against, console, graph, line, Row
from rvd_campaign.bench.bare import set_step, step_of
from rvd_campaign.bench.before import Checkout
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.host import message_type
from rvd_dynamics.diagram.roster import listed
from rvd_dynamics.diagram.scenario import load

STEP_NS = 200_000_000


def test_hollow_messages_are_as_long_as_ours_and_carry_their_step(flight):
    roster = listed(load(flight.run / 'scenario.yaml'), headless=True)
    kept = graph.sent(flight.run, roster)
    assert set(kept) == {topic for name in roster.names for topic in roster.emits(name)}
    with AnyReader([flight.run / 'bag']) as reader:
        for topic, content in kept.items():
            connections = [c for c in reader.connections if c.topic == topic]
            ours = [len(data) for _, _, data in reader.messages(connections=connections)]
            message = deserialize_message(bytes.fromhex(content),
                                          message_type(roster.topics[topic]))
            set_step(message, 200, STEP_NS)
            assert -(-len(serialize_message(message)) // 4) * 4 == max(ours)    # DDS pads to words
            if topic != '/clock':
                assert step_of(message, STEP_NS) == 200


def test_cost_is_counted_between_two_steps_in_flight(monkeypatch):
    used = {7: [3.0, 3.1, 3.5], 8: [1.0, 1.2, 1.4]}             # [s] by pid
    clock = iter([10.0, 11.0, 14.0])
    monkeypatch.setattr(graph, 'cpu_s', lambda pid: used[pid].pop(0))
    monkeypatch.setattr(graph.time, 'monotonic', lambda: next(clock))
    meter = graph.Meter()
    for step in (16, graph.WARM_UP_STEPS, graph.WARM_UP_STEPS + 400, graph.WARM_UP_STEPS + 1000):
        meter.note(step, {'a': 7, 'b': 8})
    result = meter.result(1000)
    assert result == {'steps': 1000, 'steps_per_s': 250.0, 'cpu_us_per_step': 900.0,
                      'by_node': {'a': 500.0, 'b': 400.0}}


def test_a_flight_that_is_too_short_is_refused():
    with pytest.raises(graph.Unheard, match='too short.*: 0 of at least 64 steps'):
        graph.Meter().result(64)


def test_a_flight_that_was_heard_too_late_is_refused_and_flown_again(monkeypatch):
    monkeypatch.setattr(graph, 'cpu_s', lambda pid: 1.0)

    def flown(attempt):
        meter = graph.Meter()
        for step in range(96 + 16*(6 - attempt), 96 + 144 + 1, 16):         # 48, 64, 80 ...
            meter.note(step, {'a': 7})
        return meter.result(graph.LEAST_STEPS['one']), attempt
    made, attempt = graph.heard(flown)
    assert (made['steps'], attempt) == (64, 1)


def test_steps_that_come_late_are_no_measurement():
    """Steps heard all at once, when the writer was discovered, made a flight twice as fast."""
    observer = object.__new__(graph.Observer)
    observer._steps = []
    now = time.time_ns()
    for step, age_s in ((112, 2.0), (128, 0.5), (144, 0.0)):
        observer._hear(UInt64(data=step), {'source_timestamp': now - int(age_s * 1e9)})
    assert observer._steps == [144]


def test_a_flight_that_was_not_heard_is_flown_again_but_not_for_ever():
    asked = []

    def fly(attempt):
        asked.append(attempt)
        if len(asked) < 3:
            raise graph.Unheard('too late')
        return {'steps': 1}
    assert graph.heard(fly) == {'steps': 1} and asked == [0, 1, 2]

    def never(attempt):
        asked.append(attempt)
        raise graph.Unheard('too late')
    asked.clear()
    with pytest.raises(graph.Unheard):
        graph.heard(never)
    assert asked == [0, 1, 2, 3]


def test_a_line_says_whether_the_target_is_met():
    assert line(Row('it', '3 s', '< 2 s', False)).endswith('NOT met')
    assert line(Row('it', '1 s', '< 2 s', True)).endswith('  met')
    assert line(Row('it', '1 s')).endswith('1 s')


def test_bench_leaves_its_figures_as_json(tmp_path):
    done = rvd('bench', 'loop', '--quick', '--out', 'figures.json', cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    content = json.loads((tmp_path / 'figures.json').read_text())
    assert content['machine']['cores'] >= 1
    assert content['loop']['steps'] > 200 and 0.0 < content['loop']['alone_s'] < 10.0
    assert 'one run of' in done.stdout
    lines = done.stdout.splitlines()
    assert not [text for text in lines if text.endswith(' met')]
    assert [text for text in lines if text.startswith('quick:')]


def test_the_console_is_measured_in_the_domain_of_its_flight(own_domain, monkeypatch):
    """That is another than the one that the user has, or has not."""
    monkeypatch.setenv('ROS_DOMAIN_ID', str(1 if own_domain > 1 else 2))
    context = Context()
    context.init(domain_id=int(own_domain))
    node = Node('stick', context=context)
    joy = node.create_publisher(Joy, '/joy', qos.HELD_STICK)
    listener = console.Joys(int(own_domain))
    try:
        def heard():
            joy.publish(Joy(header=Header(frame_id='console 7')))
            return 7 in listener.heard
        wait_for(heard, 'a stick sample')
    finally:
        listener.close()
        node.destroy_node()
        context.shutdown()


def test_what_needs_another_checkout_says_so():
    row = against('it', None, '<= 1', lambda ratio: ratio <= 1.0)
    assert row.met is None and '--before DIR' in row.target
    assert against('it', 0.9, '<= 1', lambda ratio: ratio <= 1.0) == ('it', '0.90', '<= 1', True)


@pytest.mark.parametrize('folder', ['nowhere', '.'])
def test_a_folder_without_a_set_up_checkout_is_refused_in_one_line(folder, tmp_path):
    done = rvd('bench', 'campaign', '--before', folder, cwd=tmp_path)
    assert done.returncode == 2 and done.stdout == ''
    assert done.stderr.count('\n') == 1 and f'--before {folder} must be a checkout' in done.stderr


def test_nothing_of_this_checkout_is_loaded_in_another(monkeypatch):
    monkeypatch.setenv('PATH', f'{ROOT}/.rvd/venv/bin:/usr/bin')
    monkeypatch.setenv('AMENT_PREFIX_PATH', str(ROOT))
    environment = Checkout(ROOT).environment(ROS_DOMAIN_ID='7')
    assert environment['PATH'] == '/usr/bin' and environment['ROS_DOMAIN_ID'] == '7'
    assert not [name for name in environment if name.startswith(('RVD_', 'AMENT_', 'PYTHON'))]


@pytest.mark.slow
def test_the_rate_of_a_checkout_is_measured_in_its_own_environment():
    assert 10.0 < Checkout(ROOT).rate_of_table(30) < 1e6


@pytest.mark.slow
def test_real_and_hollow_graph_fly_with_the_same_nodes(monkeypatch):
    """With the scenario of the benchmark: a short one is over before its observer hears of it."""
    monkeypatch.delenv('ROS_DOMAIN_ID', raising=False)
    result = graph.measure(repeats=1, before=Checkout(ROOT))
    ours, hollow = result['ours'][0], result['bare'][0]
    assert len(result['nodes']) == 12
    assert set(ours['by_node']) == set(hollow['by_node']) == set(result['nodes'])
    assert ours['steps'] >= 128 and hollow['steps'] >= 112
    assert all(cost > 0.0 for cost in (*ours['by_node'].values(), *hollow['by_node'].values()))
    assert 0.2 < result['cpu_ratio'] < 3.0
    same, = result['before']                    # this checkout, started as any other
    assert set(same['by_node']) == set(ours['by_node']) and same['steps'] >= 128
    assert result['cpu_of_before'] == pytest.approx(
        ours['cpu_us_per_step'] / same['cpu_us_per_step'], abs=0.001)
    for processes, count in (('segments', 5), ('one', 1)):
        flown, = result[processes]
        assert len(flown['by_node']) == count and flown['steps'] >= 64
        assert result['times_blocks'][processes] == pytest.approx(
            flown['steps_per_s'] / ours['steps_per_s'], abs=0.01)


@pytest.mark.slow
def test_a_flight_is_timed_in_parts_that_add_up(tmp_path):
    done = rvd('bench', 'flight', '--quick', '--out', 'figures.json', cwd=tmp_path, timeout=300.0)
    assert done.returncode == 0, done.stderr
    figures = json.loads((tmp_path / 'figures.json').read_text())['flight']
    assert figures['one']['command'] == figures['command'] + ' --processes one'
    for timed in (*figures['flights'], *figures['one']['flights']):
        parts = [timed[key] for key in ('start_up_s', 'flight_s', 'ending_s', 'report_s')]
        assert min(parts) > 0.0
        assert sum(parts) == pytest.approx(timed['wall_s'], abs=0.2)


def test_figures_of_the_laws_all_have_a_name_and_what_bounds_decide_is_most():
    from rvd_campaign.bench import _laws_rows, laws
    found = laws.measure(quick=True)
    assert set(found) < set(laws.GOALS) and found['alarm_decided_by_bounds'] > 0.7
    rows = {row.what: row for row in _laws_rows({**found, 'obstacle_flight_s': 9.0})}
    assert rows[laws.GOALS['obstacle_flight_s'].words].met is False
    assert rows[laws.GOALS['alarm_us'].words].met is None


@pytest.mark.parametrize('machine, libc, said', [
    ('x86_64', ('glibc', '2.28'), ''), ('aarch64', ('glibc', '2.39'), ''),
    ('riscv64', ('glibc', '2.39'), 'Basilisk has no wheel for linux on riscv64'),
    ('x86_64', ('glibc', '2.9'), 'Basilisk has no wheel for glibc 2.9'),
    ('x86_64', ('', ''), 'Basilisk has no wheel for a libc other than glibc')])
def test_basilisk_is_left_out_where_it_has_no_wheel_and_the_reason_is_said(
        machine, libc, said, monkeypatch, capsys):
    from rvd_campaign.bench import basilisk, docking
    monkeypatch.setattr(basilisk.platform, 'machine', lambda: machine)
    monkeypatch.setattr(basilisk.platform, 'libc_ver', lambda: libc)
    assert basilisk.missing_wheel() == said
    if said:
        assert docking._basilisk(quick=True) == {}
        assert capsys.readouterr().out == f'not raced: {said}\n'


@pytest.mark.slow
def test_figures_of_the_tether_all_have_a_name():
    from rvd_campaign.bench import _tether_rows, tether
    found = tether.measure(quick=True)
    assert set(found) < set(tether.GOALS) and 0.0 < found['replan_s'] < found['plan_s'] < 60.0
    rows = {row.what: row for row in _tether_rows({**found, 'one_real_time': 3.0})}
    assert rows[tether.GOALS['one_real_time'].words].met is False
    assert rows[tether.GOALS['plan_build_s'].words].met is None
