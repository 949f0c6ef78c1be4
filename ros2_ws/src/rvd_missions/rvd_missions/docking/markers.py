"""
The markers around the target's port, and where the docking faces are.

From the port's centre in the target's axes, whose face looks along -x. Six markers that are not in
one plane, and the same six at a quarter of the size [A: the paper has a camera and no marker]; the
one in front by 0.15 m reaches into the recess of the chaser's camera.
"""

import numpy as np

TARGET_PORT = np.array([-1.5, 0.0, 0.0])            # [m] in the target's axes
CHASER_PORT = np.array([1.5, 0.0, 0.0])             # [m] in the chaser's axes
FACING = np.array([-1.0, 0.0, 0.0])                 # of the target's face
BIG = np.array([[0.0, 0.25, 0.25], [0.0, 0.25, -0.25], [0.0, -0.25, 0.25], [0.0, -0.25, -0.25],
                [0.0, 0.0, -0.25], [-0.15, 0.0, 0.0]])
SMALL = 0.25*BIG
