"""
What flying by hand adds to the data flow: aboard the controllers act at once, remote by a link.

    aboard    docking_navigation -> hand_pilot -> docking_controller

    remote    docking_navigation -> docking_telemetry -> link_back -> hand_predictor -> hand_pilot
                                                                          ^                 v
              docking_controller <- link_forward <-----------------------+---------- hand_uplink
"""

from rvd_dynamics.diagram.block import Block, External, GROUND, held, last, now, ONBOARD, Read
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.link.leg import leg
from rvd_missions.docking import HERE
from rvd_missions.docking import hand_signals as hands
from rvd_missions.docking.signals import ESTIMATE, GUIDANCE, WANTED

PACKAGE = 'rvd_missions'
CONTROLLERS = {'translation': hands.TRANSLATION, 'rotation': hands.ROTATION}


def controller(scenario: Scenario) -> Block:
    """Return the controller of a craft that is flown by hand."""
    aboard = scenario.part('operation').steering == 'aboard'
    heard = _controllers(scenario) if aboard else {'hand': now(hands.ARRIVAL)}
    return Block('docking_controller', f'{HERE}.hand:HandController', ONBOARD, package=PACKAGE,
                 settings=scenario.mission.sections['docking_controller'],
                 reads={'estimate': now(ESTIMATE), **heard}, control=aboard,
                 writes={'wanted': WANTED, 'guidance': GUIDANCE, 'steering': hands.STEERING})


def others(scenario: Scenario) -> tuple[Block, ...]:
    """Return what else a craft has that is flown by hand: the operator, the link, the ground."""
    if scenario.part('operation').steering == 'aboard':
        return _operator(scenario, ONBOARD, ESTIMATE)
    legs = scenario.part('legs')
    command = hands.COMMAND.shifted(legs.forward)
    estimate = hands.ESTIMATE.shifted(-legs.back)
    prediction = hands.PREDICTION.shifted(legs.forward)
    seen = prediction
    if scenario.settings('hand_pilot').display == 'delayed':
        seen = estimate
    return (
        Block('docking_telemetry', f'{HERE}.hand:Telemetry', ONBOARD, package=PACKAGE,
              reads={'estimate': now(ESTIMATE), 'steering': last(hands.STEERING),
                     'guidance': last(GUIDANCE)}, writes={'downlink': hands.DOWNLINK}),
        leg(scenario, 'link_back', hands.DOWNLINK, hands.TELEMETRY, legs.back),
        Block('hand_predictor', f'{HERE}.hand_prediction:HandPredictor', GROUND, package=PACKAGE,
              reads={'telemetry': now(hands.TELEMETRY), 'command': last(command)},
              writes={'estimate': estimate, 'prediction': prediction},
              settings=scenario.mission.sections['hand_predictor']),
        *_operator(scenario, GROUND, seen),
        # sticks that are held make nothing fire: a command goes up with each prediction
        Block('hand_uplink', f'{HERE}.ground:HandUplink', GROUND, package=PACKAGE,
              reads={**_controllers(scenario), 'prediction': now(prediction)}, control=True,
              writes={'command': command, 'uplink': hands.UPLINK}),
        leg(scenario, 'link_forward', hands.UPLINK, hands.ARRIVAL, legs.forward))


def externals(scenario: Scenario) -> tuple[External, ...]:
    """Return who publishes the controllers from outside of the run."""
    operation = scenario.part('operation')
    writes = tuple(signal.name for signal in CONTROLLERS.values())
    drivers = {
        'joy': External('hand_controllers', '', '', GROUND, started=False, foreign=True,
                        writes=writes),
        'console': External('console', 'rvd_groundstation', 'console', GROUND, writes=writes),
    }
    driver = drivers.get(operation.operator) if operation.by_hand else None
    return () if driver is None else (driver,)


def _controllers(scenario: Scenario) -> dict[str, Read]:
    read = now if scenario.part('operation').stepped else held
    return {name: read(signal) for name, signal in CONTROLLERS.items()}


def _operator(scenario: Scenario, segment: str, display) -> tuple[Block, ...]:
    settings = scenario.mission.sections
    kinds = {'model': ('hand_pilot', 'HandPilot', PACKAGE),
             'replay': ('joystick_replay', 'HandReplay', 'rvd_groundstation')}
    operator = scenario.part('operation').operator
    if operator not in kinds:
        return ()
    name, make, package = kinds[operator]
    return (Block(name, f'{HERE}.ground:{make}', segment, package=package, settings=settings[name],
                  reads={'display': now(display)}, writes=CONTROLLERS),)
