"""
A node's memory does not grow with the messages that pass through it: two legs of the link.

One of them is made to leak 100 bytes a message, so that what is measured is known to show.
"""

import os
import subprocess
import sys
import time

import pytest
import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor

from rvd_campaign.bench import leak, PARTS
from rvd_campaign.flight.domain import reserved_domain
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.ros import qos
from rvd_interfaces.msg import LinkFrame

WARM_UP, MESSAGES = 4500, 9000  # the histories of DDS hold 2,000
AHEAD = 500                     # of the slower one: less than a reader believes
LEAST = 40.0                    # [bytes] a message that is a leak, not the noise of malloc
LEGS = {'link_back': ('/onboard/downlink', '/ground/telemetry'),
        'link_forward': ('/ground/uplink', '/onboard/command')}
NODE = """
import sys
from rvd_dynamics.diagram.ros import firing, main
came, kept = firing.FiringNode._came, []
def leaks(self, *arguments):
    kept.append(bytes(100))
    came(self, *arguments)
if LEAKS:
    firing.FiringNode._came = leaks
sys.argv[0] = 'link_emulator'
main.main()
"""


@pytest.mark.slow
@pytest.mark.patient
def test_a_leak_of_a_hundred_bytes_a_message_is_seen_and_there_is_none(tmp_path):
    scenario = tmp_path / 's.yaml'
    scenario.write_text(f'/**: {{ros__parameters: {{timeout_s: {0.5*(MESSAGES + 10)}}}}}')
    with reserved_domain() as domain:
        context = Context()
        rclpy.init(context=context, domain_id=domain)
        node = rclpy.create_node('feeder', context=context)
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(node)
        passed, writers, legs = dict.fromkeys(LEGS, 0), {}, {}

        def count(name):
            def heard(_):
                passed[name] += 1
            return heard
        for name, (reads, writes) in LEGS.items():
            writers[name] = node.create_publisher(LinkFrame, reads, qos.of(reads))
            node.create_subscription(LinkFrame, writes, count(name), qos.of(writes), raw=True)
            legs[name] = subprocess.Popen(
                [sys.executable, '-c', NODE.replace('LEAKS', str(name == 'link_forward')),
                 '--ros-args', '-r', f'__node:={name}', '--params-file', str(scenario),
                 '-p', f'nodes:=[{name}]'],
                env={**os.environ, 'ROS_DOMAIN_ID': str(domain), 'RVD_LEAN': '1'})
        notes = leak.Notes()

        def memory():
            return {name: leak.anonymous(leg.pid) for name, leg in legs.items()}
        try:
            deadline = time.monotonic() + 120.0
            while not all(writer.get_subscription_count() for writer in writers.values()):
                assert time.monotonic() < deadline
                time.sleep(0.05)
            for k in range(MESSAGES):
                for writer in writers.values():
                    writer.publish(LinkFrame(step=k, sequence=k, sent=500_000_000*k, empty=True))
                while k - min(passed.values()) > AHEAD:
                    assert time.monotonic() < deadline, passed
                    executor.spin_once(timeout_sec=0.1)
                if k >= WARM_UP and k % 300 == 0:
                    notes.steps.append(k)
                    notes.memory.append(memory())
        finally:
            for leg in legs.values():
                leg.kill()
                leg.wait()
            executor.shutdown()
            node.destroy_node()
            context.try_shutdown()
    grown = notes.growth()
    assert grown['link_back'] < LEAST < 100.0 < grown['link_forward'], grown


def test_growth_is_the_slope_of_each_process_after_the_warm_up(monkeypatch):
    sizes = {1: 5_000_000, 2: 7_000_000}
    monkeypatch.setattr(leak, 'anonymous', sizes.get)
    notes = leak.Notes()
    with pytest.raises(BadInput, match='too short'):
        notes.growth()
    for step in range(0, leak.WARM_UP_STEPS + 10_000, 500):
        sizes[2] += 100*500
        notes.note(step, {'a': 1, 'b': 2})
    assert notes.steps[0] == leak.WARM_UP_STEPS
    assert notes.growth() == pytest.approx({'a': 0.0, 'b': 100.0}, abs=1e-6)


def test_a_flight_for_which_the_disk_has_no_room_is_not_begun(tmp_path):
    with pytest.raises(BadInput, match=r'takes 4000000\.\d GB, and .* TMPDIR'):
        leak.fly('one', 10**12, tmp_path, 0)
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize('leaks', [0, 20])
def test_what_the_allocator_takes_at_first_is_no_growth_and_a_leak_is(leaks):
    notes = leak.Notes()
    for step in range(0, 100_000, 500):
        notes.steps.append(step)
        notes.memory.append({'one': 10_000_000 + 4096*min(step // 500, 80) + leaks*step})
    assert notes.growth()['one'] == pytest.approx(leaks, abs=0.1)
    assert notes.grown() == {'one': 4096*80 + leaks*99_500}
    found = {'steps': 99_500, 'bytes_per_step': notes.growth(), 'megabytes': {'one': 10.3},
             'kilobytes_in_all': {'one': 328}}
    assert [row.met for row in PARTS['leak'][1]({'one': found})] == [leaks == 0, None]
