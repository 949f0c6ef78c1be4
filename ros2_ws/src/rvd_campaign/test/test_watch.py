"""What the command hears of a flight, from whatever moment on."""

from pathlib import Path

from geometry_msgs.msg import TransformStamped
import pytest
from rclpy.context import Context
from rclpy.node import Node
from rvd_campaign.flight.watch import FlightWatch, step_of
from rvd_dynamics.diagram.identity import new_run, ready_words
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.host import message_type
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.pulse import Pulse
from rvd_interfaces.msg import RelativeState
from std_msgs.msg import String

SCENARIOS = Path(__file__).resolve().parents[4] / 'scenarios'


def spin_until(watch, look):
    for _ in range(100):
        watch.spin(0.1)
        if look():
            return
    raise AssertionError('nothing was heard in 10 s')


def test_a_step_heard_before_its_plant_said_that_it_is_ready_counts(own_domain):
    """A run that hangs in its first steps sends no other: it must not seem never to have begun."""
    run_id = new_run()
    context = Context()
    context.init(domain_id=own_domain)
    plant = Node('spacecraft_dynamics', context=context)
    watch = FlightWatch(Roster(load(SCENARIOS / 'paper.yaml')), own_domain, run_id)
    try:
        topic = '/truth/relative_state'
        plant.create_publisher(RelativeState, topic, qos.LATCHED).publish(RelativeState(step=3))
        spin_until(watch, lambda: watch.newest(topic))
        assert watch.steps == 0 and not watch.line()
        ready = plant.create_publisher(String, '/run/ready', qos.LATCHED)
        ready.publish(String(data=ready_words('spacecraft_dynamics', new_run())))
        watch.spin(0.5)
        assert watch.steps == 0                 # that was the plant of another run
        ready.publish(String(data=ready_words('spacecraft_dynamics', run_id)))
        spin_until(watch, lambda: watch.begun)
        assert watch.steps == 1 and watch.line()
    finally:
        watch.close()
        plant.destroy_node()
        context.try_shutdown()


def test_steps_that_the_plant_has_noted_count_though_none_is_heard(own_domain):
    """After a pause `fly` may have to find the plant again: that is no stall of the run."""
    page = Pulse()
    watch = FlightWatch(Roster(load(SCENARIOS / 'paper.yaml')), own_domain, new_run(), page=page)
    try:
        watch.spin(0.2)
        before = watch.progress_at
        watch.spin(0.2)
        assert watch.progress_at == before      # none was made
        page.flown = 7
        watch.spin(0.2)
        assert watch.progress_at > before and watch.steps == 0
    finally:
        watch.close()


@pytest.mark.parametrize('path', sorted(SCENARIOS.glob('*.yaml')), ids=lambda path: path.stem)
def test_the_step_of_every_message_of_every_scenario_is_known(path):
    """A run that hangs is explained from them, standard messages among them."""
    roster = Roster(load(path))
    for topic in {t for name in roster.names for t in roster.emits(name)} - {'/clock'}:
        message = message_type(roster.topics[topic])()
        if hasattr(message, 'transforms'):
            assert step_of(message, 10) == -1
            message.transforms.append(TransformStamped())
        stamped = message.transforms[0] if hasattr(message, 'transforms') else message
        if hasattr(message, 'step'):
            message.step = 7
        elif hasattr(message, 'data'):
            message.data = 7
        else:
            stamped.header.stamp.nanosec = 70
        assert step_of(message, 10) == 7, topic
