"""
The data flow of the approach among obstacles: the only place where it is written.

                    +------------------------------ thrust ------------------------------+
                    v                                                                    |
    spacecraft_dynamics -> relative_sensor -> link_back -> state_predictor          onboard_guard
                                                             |  ^       |                ^
                                                             |  +-----+ v                |
                                                             +-> auto_controller -> link_forward
"""

from rvd_dynamics.commands.form import part
from rvd_dynamics.diagram.block import Block, GROUND, last, now, ONBOARD, WATCH, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import Normals, StartNormals
from rvd_dynamics.link.leg import leg
from rvd_missions.obstacle_field import HERE, NAME
from rvd_missions.obstacle_field.signals import ESTIMATE, PREDICTION, Signals, signals


def signals_of(scenario: Scenario) -> Signals:
    """Return the signals of a scenario: their layout is that of its obstacles and commands."""
    return signals(scenario.part('obstacles').count, part(scenario.part('form')))


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run."""
    s, legs, settings = signals_of(scenario), scenario.part('legs'), scenario.mission.sections
    command = s.command.shifted(legs.forward)
    ahead = {'prediction': PREDICTION.shifted(legs.forward),
             'obstacles': s.obstacles.shifted(legs.forward)}
    alarm = s.alarm.shifted(legs.forward)
    world, noise = _draws(scenario)
    return Diagram((
        Block('spacecraft_dynamics', f'{HERE}.space:SpacecraftDynamics', WORLD,
              reads={'thrust': last(s.thrust)}, writes={'truth': s.truth},
              settings=settings['spacecraft_dynamics'], draws=world),
        Block('relative_sensor', f'{HERE}.space:RelativeSensor', WORLD,
              reads={'truth': now(s.truth)}, writes={'downlink': s.downlink},
              settings=settings['relative_sensor'], draws=noise),
        leg(scenario, 'link_back', s.downlink, s.telemetry, legs.back),
        Block('state_predictor', f'{HERE}.ground:StatePredictor', GROUND,
              reads={'telemetry': now(s.telemetry), 'command': last(command, late='late')},
              writes={'estimate': ESTIMATE.shifted(-legs.back), **ahead},
              settings=settings['state_predictor']),
        Block('auto_controller', f'{HERE}.ground:AutoController', GROUND,
              reads={name: now(signal) for name, signal in ahead.items()},
              writes={'command': command, 'uplink': s.uplink, 'alarm': alarm},
              settings=settings['auto_controller'], control=True),
        leg(scenario, 'link_forward', s.uplink, s.arrival, legs.forward),
        Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
              reads={'arrival': now(s.arrival)}, writes={'thrust': s.thrust},
              settings=settings['onboard_guard']),
        Block('columns', f'{HERE}.columns:Columns', WATCH, reads={
            'truth': now(s.truth), 'alarm': now(alarm)}, executable=''),
    ), plant='spacecraft_dynamics', guard='onboard_guard', thrust=s.thrust.name)


def _draws(scenario: Scenario) -> tuple[dict, dict]:
    """Return what plant and sensor draw: nothing where there is neither scatter nor noise."""
    count = scenario.part('obstacles').count
    plant, sensor = scenario.settings('spacecraft_dynamics'), scenario.settings('relative_sensor')
    world, noise = {}, {}
    if plant.scatter.any:
        world['scatter'] = StartNormals(f'{NAME}/spacecraft_dynamics/scatter', 6 + 3*count)
    if plant.execution_noise_fraction:
        world['execution'] = Normals(f'{NAME}/spacecraft_dynamics/execution', 3)
    if sensor.sigma(1).any():
        noise['noise'] = Normals(f'{NAME}/relative_sensor/noise', 6 + 6*count)
    return world, noise
