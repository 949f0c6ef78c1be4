"""
The data flow: the only place where it is written.

    docking_dynamics -> inertial_unit ----------------> docking_navigation -> docking_controller -+
      ^      |                                            ^                                        |
      |      +-> camera -> vision (pinhole alone) --------+                     onboard_guard <----+
      +------------------------------- valves --------------------------------------+
"""

from rvd_dynamics.diagram.block import Block, last, now, ONBOARD, Read, WATCH, WORLD
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import Normals, StartNormals
from rvd_missions.docking import HERE
from rvd_missions.docking.commands import COUNT
from rvd_missions.docking.scatter import PROPERTIES
from rvd_missions.docking.signals import (
    ESTIMATE, FEATURES, GUIDANCE, INERTIAL, MARKERS, POSE, THRUST, TRUTH, WANTED)

PACKAGE = 'rvd_missions'
PULSE_DRAWS = COUNT*130                 # reaction_control.DRAWS for each thruster
VIEW_DRAWS = 2*MARKERS + 1              # space.VIEW_DRAWS


def diagram(scenario: Scenario) -> Diagram:
    """Return the blocks of a run; the camera changes the edges."""
    settings = scenario.mission.sections
    period, late = scenario.part('period'), scenario.part('late')
    views = scenario.run.last_step//period + 1
    pinhole = scenario.part('seeing').camera == 'pinhole'

    def block(name: str, make: str, segment: str, **more) -> Block:
        return Block(name, f'{HERE}.{make}', segment, package=PACKAGE,
                     settings=settings[name], **more)

    seen = {'draws': {'views': StartNormals('docking/camera/views', views*VIEW_DRAWS),
                      'properties': PROPERTIES},
            'reads': {'truth': Read(TRUTH, late)}, 'period': period}
    camera = (
        block('camera', 'space:Camera', WORLD, writes={'features': FEATURES}, **seen),
        block('vision', 'onboard:Vision', ONBOARD, reads={'features': now(FEATURES)},
              writes={'pose': POSE}, period=period),
    ) if pinhole else (
        block('camera', 'space:SimpleCamera', WORLD, writes={'pose': POSE}, **seen),)
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
        *camera,
        block('docking_navigation', 'onboard:Navigation', ONBOARD,
              reads={'inertial': now(INERTIAL), 'pose': last(POSE)},
              writes={'estimate': ESTIMATE}),
        block('docking_controller', 'onboard:Controller', ONBOARD,
              reads={'estimate': now(ESTIMATE)},
              writes={'wanted': WANTED, 'guidance': GUIDANCE}, control=True),
        Block('onboard_guard', 'rvd_dynamics.onboard.guard.block:Guard', ONBOARD,
              reads={'arrival': now(WANTED)}, writes={'thrust': THRUST},
              settings=settings['onboard_guard']),
        Block('columns', f'{HERE}.columns:Columns', WATCH, reads={
            'truth': now(TRUTH), 'estimate': now(ESTIMATE), 'guidance': now(GUIDANCE)},
            draws={'properties': PROPERTIES}, executable=''),
    ), plant='docking_dynamics', guard='onboard_guard', thrust=THRUST.name)
