"""
The data flow: the only place where it is written.

    gripper_dynamics -> gripper_sensors -> gripper_tracker -> onboard_guard -+
            ^                                |          ^                    |
            |                            link_back  link_forward             |
            |                                v          |                    |
            |                             mission_control                    |
            +------------------- tension, force, torque ---------------------+
"""

from rvd_dynamics.diagram.block import Block, GROUND, last, now, ONBOARD, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import Normals, StartNormals
from rvd_dynamics.link.leg import leg
from rvd_missions.tether import HERE
from rvd_missions.tether.signals import (
    ARRIVAL, COMMAND, DOWNLINK, MEASUREMENT, SITUATION, TELEMETRY, THRUST, TRACKING, TRUTH, UPLINK,
    WANTED)

PACKAGE = 'rvd_missions'


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run."""
    legs, settings = scenario.part('legs'), scenario.mission.sections
    return Diagram((
        Block('gripper_dynamics', f'{HERE}.space:GripperDynamics', WORLD, package=PACKAGE,
              reads={'thrust': last(THRUST)}, writes={'truth': TRUTH},
              settings=settings['gripper_dynamics'],
              draws={'scatter': StartNormals('tether/gripper_dynamics/scatter', 12)}),
        Block('gripper_sensors', f'{HERE}.space:GripperSensors', WORLD, package=PACKAGE,
              reads={'truth': now(TRUTH)}, writes={'measurement': MEASUREMENT},
              settings=settings['gripper_sensors'],
              draws={'noise': Normals('tether/gripper_sensors/noise', 6)}),
        # what came up in the step before: its downlink is on the same way round
        Block('gripper_tracker', f'{HERE}.onboard:GripperTracker', ONBOARD, package=PACKAGE,
              reads={'measurement': now(MEASUREMENT), 'arrival': last(ARRIVAL)},
              writes={'wanted': WANTED, 'tracking': TRACKING, 'downlink': DOWNLINK},
              settings=settings['gripper_tracker']),
        leg(scenario, 'link_back', DOWNLINK, TELEMETRY, legs.back),
        Block('mission_control', f'{HERE}.ground:MissionControl', GROUND, package=PACKAGE,
              reads={'telemetry': now(TELEMETRY)},
              writes={'command': COMMAND.shifted(legs.forward), 'uplink': UPLINK,
                      'situation': SITUATION}, control=True),
        leg(scenario, 'link_forward', UPLINK, ARRIVAL, legs.forward),
        Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
              reads={'arrival': now(WANTED)}, writes={'thrust': THRUST},
              settings=settings['onboard_guard']),
    ), plant='gripper_dynamics', guard='onboard_guard', thrust=THRUST.name)
