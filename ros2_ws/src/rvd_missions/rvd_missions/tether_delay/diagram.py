"""
The data flow: the only place where it is written.

    gripper_dynamics -> gripper_sensors -> gripper_tracker -> onboard_guard -+
            ^                                |          ^                    |
            |                            link_back  link_forward             |
            |                                v          |                    |
            |        flight_director -> mission_control +                    |
            +------------- latch; tension, force, torque --------------------+
"""

from rvd_dynamics.diagram.block import Block, GROUND, last, now, ONBOARD, WATCH, WORLD
from rvd_dynamics.diagram.diagram import Diagram, Shown
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import Normals, StartNormals
from rvd_dynamics.link.leg import leg
from rvd_missions.tether_delay import HERE
from rvd_missions.tether_delay.signals import (
    ARRIVAL, COMMAND, CRAFT, DECISION, DOWNLINK, MEASUREMENT, NO_PLAN, SITUATION, TELEMETRY,
    THRUST, TRACKING, TRUTH, UPLINK, WANTED)

PACKAGE = 'rvd_missions'


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run."""
    legs, settings = scenario.part('legs'), scenario.mission.sections
    return Diagram((
        Block('gripper_dynamics', f'{HERE}.space:LatchedDynamics', WORLD, package=PACKAGE,
              reads={'thrust': last(THRUST), 'craft': last(CRAFT)}, writes={'truth': TRUTH},
              settings=settings['gripper_dynamics'],
              draws={'scatter': StartNormals('tether/gripper_dynamics/scatter', 12)}),
        Block('gripper_sensors', 'rvd_missions.tether.space:GripperSensors', WORLD, package=PACKAGE,
              reads={'truth': now(TRUTH)}, writes={'measurement': MEASUREMENT},
              settings=settings['gripper_sensors'],
              draws={'noise': Normals('tether/gripper_sensors/noise', 6)}),
        # what came up in the step before: its downlink is on the same way round
        Block('gripper_tracker', f'{HERE}.onboard:OrderedTracker', ONBOARD, package=PACKAGE,
              reads={'measurement': now(MEASUREMENT), 'arrival': last(ARRIVAL)},
              writes={'wanted': WANTED, 'tracking': TRACKING, 'craft': CRAFT,
                      'downlink': DOWNLINK},
              settings=settings['gripper_tracker']),
        leg(scenario, 'link_back', DOWNLINK, TELEMETRY, legs.back),
        Block('flight_director', f'{HERE}.ground:FlightDirector', GROUND, package=PACKAGE,
              reads={'situation': last(SITUATION)}, writes={'decision': DECISION},
              settings=settings['flight_director'],
              draws={'reaction': StartNormals('tether_delay/flight_director/reaction', 4)}),
        Block('mission_control', f'{HERE}.ground:MissionControl', GROUND, package=PACKAGE,
              reads={'telemetry': now(TELEMETRY), 'decision': now(DECISION)},
              writes={'command': COMMAND.shifted(legs.forward), 'uplink': UPLINK,
                      'situation': SITUATION}, control=True),
        leg(scenario, 'link_forward', UPLINK, ARRIVAL, legs.forward),
        Block('onboard_guard', f'{HERE}.onboard:TetherGuard', ONBOARD,
              reads={'arrival': now(WANTED)}, writes={'thrust': THRUST},
              settings=settings['onboard_guard']),
        Block('columns', f'{HERE}.columns:Columns', WATCH, reads={
            'truth': now(TRUTH), 'craft': now(CRAFT), 'tracking': now(TRACKING)}, executable=''),
    ), plant='gripper_dynamics', guard='onboard_guard', thrust=THRUST.name,
        # the gripper brakes by itself, or stays on the latch: the guard goes on as it was
        abort_in=Shown(CRAFT.name, 'plan', NO_PLAN))
