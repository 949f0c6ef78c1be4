"""
The data flow of the approach: the only place where it is written.

                    +--------------------------------- thrust ---------------------------------+
                    v                                                                          |
    spacecraft_dynamics -> relative_sensor -> link_back -> state_predictor -> operator  -+     |
                                                                |  ^             |       v     |
                                                                |  +- command ---|- command_blender
                                                                v                v       |     |
                                                             auto_controller ----------->+     |
                                                                                         v     |
                                                  onboard_guard <- link_forward <- uplink      |
                                                        +--------------------------------------+
"""

from rvd_dynamics.diagram.block import (
    Block, External, GROUND, held, last, now, ONBOARD, Read, WATCH, WORLD)
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.run import Legs
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Signal
from rvd_dynamics.diagram.streams import Draw, Normals, PilotChance, StartNormals
from rvd_dynamics.link.leg import leg
from rvd_dynamics.link.signals import status
from rvd_groundstation.guidance.keep_out import uses_covariance
from rvd_missions.lunar_approach import HERE, signals
from rvd_missions.lunar_approach.signals import (
    ARRIVAL, COMMAND, DOWNLINK, MEASUREMENT, SCORE, STICK, TELEMETRY, THRUST, TRUTH, UPLINK)

CONSOLE = External('console', 'rvd_groundstation', 'console', GROUND, writes=(STICK.name,), reads=(
    TELEMETRY.name, signals.ESTIMATE.name, signals.PREDICTION.name, SCORE.name, signals.AUTO.name,
    COMMAND.name, status('link_back').name))
DRIVERS = {                             # by `joy_driver`
    'joystick': External('joystick', 'rvd_groundstation', 'joystick', GROUND, reads=('/clock',),
                         writes=(STICK.name,), viewer=False),
    'joy_node': External('joy_node', 'joy', 'joy_node', GROUND, writes=(STICK.name,), foreign=True),
    'external': External('external_stick', '', '', GROUND, writes=(STICK.name,), foreign=True,
                         started=False),
}


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run: operator, stick and law change the edges."""
    legs = scenario.part('legs')
    estimate = signals.ESTIMATE.shifted(-legs.back)
    prediction = signals.PREDICTION.shifted(legs.forward)
    blocks = [*_space(scenario),
              leg(scenario, 'link_back', DOWNLINK, TELEMETRY, legs.back, 'accepted'),
              leg(scenario, 'link_forward', UPLINK, ARRIVAL, legs.forward),
              *_ground(scenario, legs, estimate, prediction), _columns(scenario, prediction)]
    operation = scenario.part('operation')
    driver = DRIVERS['external' if operation.stepped else operation.joy_driver]
    externals = {'console': (CONSOLE,), 'joy': (driver,)}.get(operation.operator, ())
    return Diagram(tuple(blocks), 'spacecraft_dynamics', 'onboard_guard', THRUST.name, externals)


def _space(scenario: Scenario) -> list[Block]:
    settings = scenario.mission.sections
    return [
        Block('spacecraft_dynamics', f'{HERE}.space:SpacecraftDynamics', WORLD,
              reads={'thrust': last(THRUST)}, writes={'truth': TRUTH},
              settings=settings['spacecraft_dynamics'],
              draws={'scatter': StartNormals(), 'execution': Normals('execution', 3)}),
        Block('relative_sensor', f'{HERE}.space:RelativeSensor', WORLD,
              reads={'truth': now(TRUTH), 'thrust': last(THRUST)},
              writes={'measurement': MEASUREMENT, 'downlink': DOWNLINK},
              settings=settings['relative_sensor'],
              draws=_errors_of_the_sensor(scenario)),
        Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
              reads={'arrival': now(ARRIVAL)}, writes={'thrust': THRUST},
              settings=settings['onboard_guard']),
    ]


def _errors_of_the_sensor(scenario: Scenario) -> dict[str, Draw]:
    drawn: dict[str, Draw] = {'noise': Normals('measurement', 6)}
    # as given: its settings belong to the world, which processes of the ground do not load
    if scenario.sections.get('relative_sensor', {}).get('sensor') == 'additive':
        drawn |= {'added': Normals('lunar_approach/relative_sensor/added', 6),
                  'bias': StartNormals('lunar_approach/relative_sensor/bias', 6)}
    return drawn


def _ground(scenario: Scenario, legs: Legs, estimate: Signal, prediction: Signal) -> list[Block]:
    settings = scenario.mission.sections
    auto, command = signals.AUTO.shifted(legs.forward), COMMAND.shifted(legs.forward)
    stick = _stick(scenario)
    is_held = bool(stick) and stick['stick'].held
    watches_stick = bool(stick) and scenario.settings('auto_controller').selected.uses_stick
    # A law that looks at the stick shares the blender's mode, and its reading of a held stick.
    reading = {'reading': signals.READING} if is_held else {}
    law_reads = {**stick, 'mode': last(signals.MODE)} if watches_stick else {}
    law_tells, blender_hears = ({}, {}) if not watches_stick else (
        reading, {name: now(signal) for name, signal in reading.items()})
    blender_tells = {'mode': signals.MODE} if watches_stick else reading
    return [
        Block('state_predictor', f'{HERE}.ground:StatePredictor', GROUND,
              reads={'telemetry': now(TELEMETRY, 'accepted'),
                     'command': last(command, late='late')},
              writes={'estimate': estimate, 'prediction': prediction, 'score': SCORE},
              settings=settings['state_predictor']),
        *_operator(scenario, estimate, prediction),
        Block('auto_controller', f'{HERE}.ground:AutoController', GROUND,
              reads={'prediction': now(prediction, *_known_as_well(scenario)), **law_reads},
              writes={'auto': auto, **law_tells}, settings=settings['auto_controller']),
        Block('command_blender', f'{HERE}.ground:CommandBlender', GROUND,
              reads={**stick, **blender_hears, 'auto': now(auto)},
              writes={'command': command, 'uplink': UPLINK, **blender_tells},
              settings=settings['command_blender'], control=True),
    ]


def _known_as_well(scenario: Scenario) -> tuple[str, ...]:
    """Return what else of the prediction a law asks for, where there are obstacles."""
    law = scenario.settings('auto_controller').selected
    asks = scenario.part('obstacles').count and uses_covariance(law)
    return ('covariance',) if asks else ()


def _stick(scenario: Scenario) -> dict[str, Read]:
    """Return how the stick is read, if anybody has one."""
    operation = scenario.part('operation')
    if operation.operator == 'none':
        return {}
    return {'stick': now(STICK) if operation.stepped else held(STICK)}


def _operator(scenario: Scenario, estimate: Signal, prediction: Signal) -> list[Block]:
    settings = scenario.mission.sections
    operator = scenario.part('operation').operator
    if operator == 'model':
        people = scenario.settings('operator_model').runs_per_operator
        return [Block('operator_model', f'{HERE}.ground:OperatorModel', GROUND,
                      reads={'estimate': now(estimate), 'prediction': now(prediction)},
                      writes={'stick': STICK}, settings=settings['operator_model'],
                      draws={'chance': PilotChance(people)})]
    if operator == 'replay':
        return [Block('joystick_replay', f'{HERE}.ground:JoystickReplay', GROUND,
                      reads={'prediction': now(prediction)}, writes={'stick': STICK},
                      settings=settings['joystick_replay'])]
    return []


def _columns(scenario: Scenario, prediction: Signal) -> Block:
    """Return what counts, in process, who decided, and what predictions are worth."""
    operator = scenario.part('operation').operator
    reads = {'truth': now(TRUTH), 'command': now(COMMAND.shifted(scenario.part('legs').forward))}
    if operator in ('model', 'replay'):
        reads['stick'] = now(STICK)
    if scenario.part('measured').prediction:
        reads['prediction'] = now(prediction, 'covariance')
    return Block('columns', f'{HERE}.columns:Columns', WATCH, reads=reads, executable='')
