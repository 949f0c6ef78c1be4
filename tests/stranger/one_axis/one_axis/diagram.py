"""
The data flow: the only place where it is written.

    plant -> sensor -> link_back -> controller -> link_forward -> onboard_guard -+
      ^                                                                          |
      +--------------------------------- thrust ---------------------------------+
"""

from rvd_dynamics.diagram.block import Block, GROUND, last, now, ONBOARD, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import Normals, StartNormals
from rvd_dynamics.link.leg import leg

from one_axis.signals import (
    ARRIVAL, COMMAND, DOWNLINK, TELEMETRY, THRUST, TRUTH, UPLINK)


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run."""
    legs, settings = scenario.part('legs'), scenario.mission.sections
    command = COMMAND.shifted(legs.forward)         # it acts that many steps later
    return Diagram((
        Block('plant', 'one_axis.space:Plant', WORLD, package='one_axis',
              reads={'thrust': last(THRUST)}, writes={'truth': TRUTH},
              settings=settings['plant'],
              draws={'scatter': StartNormals('one_axis/plant/scatter', 2)}),
        Block('sensor', 'one_axis.space:Sensor', WORLD, package='one_axis',
              reads={'truth': now(TRUTH)}, writes={'downlink': DOWNLINK},
              settings=settings['sensor'],
              draws={'noise': Normals('one_axis/sensor/noise', 2)}),
        leg(scenario, 'link_back', DOWNLINK, TELEMETRY, legs.back),
        Block('controller', 'one_axis.ground:Controller', GROUND, package='one_axis',
              reads={'telemetry': now(TELEMETRY)},
              writes={'command': command, 'uplink': UPLINK},
              settings=settings['controller'], control=True),
        leg(scenario, 'link_forward', UPLINK, ARRIVAL, legs.forward),
        Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
              reads={'arrival': now(ARRIVAL)}, writes={'thrust': THRUST},
              settings=settings['onboard_guard']),
    ), plant='plant', guard='onboard_guard', thrust=THRUST.name)
