"""
Physical constants, each with its source, and units.

What a scenario may change (orbit, corridor, thrust) is a setting and stands with what uses it.
"""

NS_PER_S = 1_000_000_000        # [ns/s]
MU_MOON = 4902.800e9            # [m^3/s^2] Zhang, Li, Tang 2014, Table 1; GRGM1200A: 4902.8001e9
RADIUS_MOON = 1737.4e3          # [m] mean radius, IAU 2015
MU_EARTH = 3.986004418e14       # [m^3/s^2] WGS 84 with EGM2008
RADIUS_EARTH = 6378.137e3       # [m] equatorial radius, WGS 84
