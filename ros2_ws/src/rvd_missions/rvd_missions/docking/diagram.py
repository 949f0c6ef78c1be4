"""
The data flow: the only place where it is written.

    docking_dynamics -> inertial_unit ----------------> docking_navigation -> docking_controller -+
      ^      |                                            ^                                        |
      |      +-> camera -> vision (pinhole alone) --------+                     onboard_guard <----+
      +------------------------------- valves --------------------------------------+

With a planner of the ground, docking_controller -> link_back -> closing_planner -> link_forward
-> docking_controller besides.
"""

from collections.abc import Callable

from rvd_dynamics.diagram.block import Block, GROUND, last, now, ONBOARD, Read, WATCH, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import Normals, StartNormals
from rvd_dynamics.link.leg import leg
from rvd_missions.docking import hand_diagram, HERE, standard
from rvd_missions.docking.commands import COUNT
from rvd_missions.docking.plan_signals import ARRIVAL, DOWNLINK, TELEMETRY, UPLINK
from rvd_missions.docking.scatter import PROPERTIES
from rvd_missions.docking.signals import (
    ESTIMATE, FEATURES, GUIDANCE, INERTIAL, MARKERS, POSE, THRUST, TRUTH, WANTED)
from rvd_missions.docking.stereo_signals import CAMERAS, SPOTS, STEREO

PACKAGE = 'rvd_missions'
PULSE_DRAWS = COUNT*130                 # reaction_control.DRAWS for each thruster
VIEW_DRAWS = 2*MARKERS + 1              # space.VIEW_DRAWS
STEREO_DRAWS = CAMERAS*2*MARKERS + 1    # space_stereo's
RENDERED_DRAWS = CAMERAS*2 + 1


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run; the camera changes the edges."""
    settings = scenario.mission.sections

    def block(name: str, make: str, segment: str, **more) -> Block:
        return Block(name, f'{HERE}.{make}', segment, package=PACKAGE,
                     settings=settings[name], **more)

    if scenario.part('operation').by_hand:
        flown = (hand_diagram.controller(scenario), *hand_diagram.others(scenario))
    else:
        flown = _guided(scenario, block)
    return Diagram((
        block('docking_dynamics', 'space:Dynamics', WORLD, reads={'thrust': last(THRUST)},
              writes={'truth': TRUTH}, draws={
                  'start_scatter': StartNormals('docking/dynamics/scatter', 9),
                  'properties': PROPERTIES,
                  'pulses': StartNormals('docking/dynamics/pulses', PULSE_DRAWS)}),
        block('inertial_unit', 'space:Inertial', WORLD, reads={'truth': now(TRUTH)},
              writes={'inertial': INERTIAL}, draws={
                  'bias': StartNormals('docking/inertial/bias', 6),
                  'noise': Normals('docking/inertial/noise', 9)}),
        *_seeing(scenario, block),
        block('docking_navigation', 'onboard:Navigation', ONBOARD,
              reads={'inertial': now(INERTIAL), 'pose': last(POSE)},
              writes={'estimate': ESTIMATE}),
        *flown,
        Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
              reads={'arrival': now(WANTED)}, writes={'thrust': THRUST},
              settings=settings['onboard_guard']),
        Block('columns', f'{HERE}.columns:Columns', WATCH, reads={
            'truth': now(TRUTH), 'estimate': now(ESTIMATE), 'guidance': now(GUIDANCE)},
            draws={'properties': PROPERTIES}, executable=''),
        *standard.blocks(scenario),
    ), plant='docking_dynamics', guard='onboard_guard', thrust=THRUST.name,
        externals=hand_diagram.externals(scenario))


def _seeing(scenario: Scenario, block: Callable[..., Block]) -> tuple[Block, ...]:
    """Return the camera, and what makes poses of its images if it does not do so itself."""
    period, late = scenario.part('period'), scenario.part('late')
    views = scenario.run.last_step//period + 1
    kind = scenario.part('seeing').camera
    made, signal, solved, draws = {
        'simple': ('space:SimpleCamera', POSE, '', VIEW_DRAWS),
        'pinhole': ('space:Camera', FEATURES, 'onboard:Vision', VIEW_DRAWS),
        'stereo': ('space_stereo:StereoCamera', STEREO, 'onboard_stereo:Stereo', STEREO_DRAWS),
        'rendered': ('space_stereo:RenderedCamera', SPOTS, 'onboard_stereo:Images', RENDERED_DRAWS),
    }[kind]
    name = {POSE: 'pose', SPOTS: 'blobs'}.get(signal, 'features')
    camera = block('camera', made, WORLD, writes={name: signal}, reads={'truth': Read(TRUTH, late)},
                   period=period,
                   draws={'views': StartNormals('docking/camera/views', views*draws),
                          'properties': PROPERTIES})
    if not solved:
        return (camera,)
    return (camera, block('vision', solved, ONBOARD, reads={name: now(signal)},
                          writes={'pose': POSE}, period=period))


def _guided(scenario: Scenario, block: Callable[..., Block]) -> tuple[Block, ...]:
    """Return the controller, and what makes the plan that it tracks if the ground does."""
    reads, writes = {'estimate': now(ESTIMATE)}, {'wanted': WANTED, 'guidance': GUIDANCE}
    if not scenario.part('preparation').on_ground:
        return (block('docking_controller', 'onboard:Controller', ONBOARD, reads=reads,
                      writes=writes, control=True),)
    legs = scenario.part('legs')
    return (
        # what came up in the step before: its downlink is on the same way round
        block('docking_controller', 'tracking:TrackingController', ONBOARD,
              reads={**reads, 'plan': last(ARRIVAL)}, writes={**writes, 'downlink': DOWNLINK},
              control=True),
        leg(scenario, 'link_back', DOWNLINK, TELEMETRY, legs.back),
        Block('closing_planner', f'{HERE}.plan_ground:ClosingPlanner', GROUND, package=PACKAGE,
              reads={'telemetry': now(TELEMETRY)}, writes={'plan': UPLINK}),
        leg(scenario, 'link_forward', UPLINK, ARRIVAL, legs.forward))
