"""
The data flow: the only place where it is written.

On board    attitude_dynamics -> attitude_sensors -> attitude_controller -> onboard_guard -+
                    ^                                                                      |
                    +------------------------------ torque --------------------------------+

On the ground the controller stands between the two legs: attitude_sensors -> link_back ->
attitude_controller -> link_forward -> onboard_guard.
"""

from rvd_dynamics.diagram.block import Block, GROUND, last, now, ONBOARD, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import Normals, StartNormals
from rvd_dynamics.link.leg import leg
from rvd_missions.attitude_hold import HERE
from rvd_missions.attitude_hold.signals import (
    ARRIVAL, COMMAND, DOWNLINK, LAW, MEASUREMENT, TELEMETRY, THRUST, TRUTH, UPLINK, WANTED)

PACKAGE = 'rvd_missions'


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run: where the law runs changes the edges."""
    settings = scenario.mission.sections
    ground = scenario.part('placement').law_runs == 'ground'
    middle = _on_ground(scenario) if ground else _on_board(scenario)
    return Diagram((
        Block('attitude_dynamics', f'{HERE}.space:AttitudeDynamics', WORLD, package=PACKAGE,
              reads={'thrust': last(THRUST)}, writes={'truth': TRUTH},
              settings=settings['attitude_dynamics'],
              draws={'scatter': StartNormals('attitude_hold/attitude_dynamics/scatter', 2)}),
        Block('attitude_sensors', f'{HERE}.space:AttitudeSensors', WORLD, package=PACKAGE,
              reads={'truth': now(TRUTH)},
              writes={'measurement': MEASUREMENT, 'downlink': DOWNLINK},
              settings=settings['attitude_sensors'],
              draws={'noise': Normals('attitude_hold/attitude_sensors/noise', 3)}),
        *middle,
        Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
              reads={'arrival': now(ARRIVAL if ground else WANTED)}, writes={'thrust': THRUST},
              settings=settings['onboard_guard']),
    ), plant='attitude_dynamics', guard='onboard_guard', thrust=THRUST.name)


def _on_board(scenario: Scenario) -> tuple[Block, ...]:
    return (Block('attitude_controller', f'{HERE}.onboard:OnboardController', ONBOARD,
                  package=PACKAGE, reads={'measurement': now(MEASUREMENT)},
                  writes={'wanted': WANTED, 'law': LAW},
                  settings=scenario.mission.sections['attitude_controller'], control=True),)


def _on_ground(scenario: Scenario) -> tuple[Block, ...]:
    legs = scenario.part('legs')
    return (leg(scenario, 'link_back', DOWNLINK, TELEMETRY, legs.back),
            Block('attitude_controller', f'{HERE}.ground:GroundController', GROUND,
                  package=PACKAGE, reads={'telemetry': now(TELEMETRY)},
                  writes={'command': COMMAND.shifted(legs.forward), 'uplink': UPLINK, 'law': LAW},
                  settings=scenario.mission.sections['attitude_controller'], control=True),
            leg(scenario, 'link_forward', UPLINK, ARRIVAL, legs.forward))
