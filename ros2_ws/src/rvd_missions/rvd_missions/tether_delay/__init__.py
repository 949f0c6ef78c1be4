"""
Tether behind a link: the plan is made on the ground, goes up, and is flown when the operator says.

The gripper of mission `tether`; what is new is who decides, and from what. `diagram` has the data
flow.
"""

from rvd_dynamics.diagram.mission import Mission, Shared
from rvd_missions.tether import MISSION as TETHER

HERE = 'rvd_missions.tether_delay'

MISSION = Mission(
    name='tether_delay',
    title='The gripper on its tether, planned on the ground and told go, hold and abort by a link.',
    shared=(
        *(shared for shared in TETHER.shared if shared.name != 'run'),
        Shared('operation', f'{HERE}.settings:Operation'),
        Shared('ground_work', f'{HERE}.settings:GroundParams', 'ground.'),
        Shared('standing', f'{HERE}.settings:StandingParams', 'hold.'),
    ),
    sections={
        **{name: where for name, where in TETHER.sections.items()
           if name not in ('bag_recorder', 'markers')},
        'flight_director': f'{HERE}.settings:DirectorParams',
    },
    parts={
        'legs': TETHER.parts['legs'],
        'form': f'{HERE}.commands:OrderForm',           # of the frames that go up
        'tether_form': TETHER.parts['form'],            # of what the guard lets through
        'preparation': f'{HERE}.planning:Preparation',
        'tracker': f'{HERE}.settings:tracker',          # as the ground knows it
        'checked': f'{HERE}.settings:checked',
    },
    checked=('checked', 'legs'),
    diagram=f'{HERE}.diagram:diagram',
    judge='rvd_missions.tether.judge:Judge',
    figures=f'{HERE}.figures:FIGURES',
    campaign_figures=f'{HERE}.campaign_figures:FIGURES',
    display=f'{HERE}.display:OrderedDisplay',
    modes=('model', 'hold', 'go'),
)
