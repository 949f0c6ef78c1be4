"""
Settings of the ground nodes whose part is picked from a table.
"""

from rvd_dynamics.params import choice
from rvd_groundstation.guidance import LAWS
from rvd_groundstation.sharing import SHARING

ControllerParams = choice('ControllerParams', 'law', LAWS, 'corridor_apf', 'Guidance law:')
BlenderParams = choice('BlenderParams', 'sharing', SHARING, 'eq25', 'Way of sharing:')
