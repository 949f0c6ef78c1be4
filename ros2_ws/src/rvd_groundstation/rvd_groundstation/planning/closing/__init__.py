"""
Plans for the closing of two docking faces: three planners of one task.

`task` has the motion, the cost and the limits that all of them share.
"""

from rvd_groundstation.planning.closing.polynomial import Polynomial
from rvd_groundstation.planning.closing.pseudospectral import Pseudospectral
from rvd_groundstation.planning.closing.velocity_profile import VelocityProfile

PLANNERS = {'velocity_profile': VelocityProfile, 'polynomial': Polynomial,
            'pseudospectral': Pseudospectral}
