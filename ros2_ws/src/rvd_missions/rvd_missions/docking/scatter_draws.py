"""
The draws of a scattered craft: how many there are, and of which stream.
"""

from rvd_dynamics.diagram.streams import StartNormals
from rvd_missions.docking.commands import COUNT

CANDIDATES = 8
# normals of one candidate: mass, inertia, products, both panels' modes (frequency, participation),
# tanks (mass, frequency), centre, camera (turn, place), thrusters
MODES, WIDTH = 8, 1 + 3 + 3 + 4*8 + 4 + 3 + 6 + COUNT
PROPERTIES = StartNormals('docking/dynamics/properties', CANDIDATES*WIDTH)
