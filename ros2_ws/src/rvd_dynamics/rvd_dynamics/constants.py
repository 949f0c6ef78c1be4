"""
Physical constants, each with its source, and units.

The mission values (orbit, corridor, thrust) are settings, not constants: see `mission`.
"""

MU_MOON = 4902.800e9            # [m^3/s^2] Zhang, Li, Tang 2014, Table 1; GRGM1200A: 4902.8001e9
NS_PER_S = 1_000_000_000         # instants are whole nanoseconds, durations seconds
