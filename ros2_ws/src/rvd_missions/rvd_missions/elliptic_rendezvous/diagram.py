"""
The data flow of the rendezvous: the only place where it is written.

    spacecraft_dynamics -> relative_sensor -> link_back -> state_predictor -> auto_controller
            ^                                                    ^                 |    |
            |                                                    +---- command ----+    |
            +------- thrust ------- onboard_guard <- link_forward <------- uplink ------+
"""

from rvd_dynamics.commands.form import part
from rvd_dynamics.diagram.block import Block, GROUND, last, now, ONBOARD, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import Normals, StartNormals
from rvd_dynamics.link.leg import leg
from rvd_missions.elliptic_rendezvous import HERE, signals
from rvd_missions.elliptic_rendezvous.signals import DOWNLINK, TELEMETRY, TRUTH

NAME = 'elliptic_rendezvous'


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run."""
    legs, settings = scenario.part('legs'), scenario.mission.sections
    s = signals.command_signals(part(scenario.part('form')))
    command = s.command.shifted(legs.forward)
    prediction = signals.PREDICTION.shifted(legs.forward)
    guidance = signals.GUIDANCE.shifted(legs.forward)
    return Diagram((
        Block('spacecraft_dynamics', f'{HERE}.space:SpacecraftDynamics', WORLD,
              reads={'thrust': last(s.thrust)}, writes={'truth': TRUTH},
              settings=settings['spacecraft_dynamics'],
              draws={'scatter': StartNormals(f'{NAME}/spacecraft_dynamics/scatter', 2),
                     'execution': Normals(f'{NAME}/spacecraft_dynamics/execution', 3)}),
        Block('relative_sensor', f'{HERE}.space:RelativeSensor', WORLD,
              reads={'truth': now(TRUTH)}, writes={'downlink': DOWNLINK},
              settings=settings['relative_sensor'],
              draws={'noise': Normals(f'{NAME}/relative_sensor/noise', 6)}),
        leg(scenario, 'link_back', DOWNLINK, TELEMETRY, legs.back),
        Block('state_predictor', f'{HERE}.ground:StatePredictor', GROUND,
              reads={'telemetry': now(TELEMETRY), 'command': last(command)},
              writes={'prediction': prediction}),
        Block('auto_controller', f'{HERE}.ground:AutoController', GROUND,
              reads={'prediction': now(prediction)},
              writes={'command': command, 'uplink': s.uplink, 'guidance': guidance},
              settings=settings['auto_controller'], control=True),
        leg(scenario, 'link_forward', s.uplink, s.arrival, legs.forward),
        Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
              reads={'arrival': now(s.arrival)}, writes={'thrust': s.thrust},
              settings=settings['onboard_guard']),
    ), 'spacecraft_dynamics', 'onboard_guard', s.thrust.name)
