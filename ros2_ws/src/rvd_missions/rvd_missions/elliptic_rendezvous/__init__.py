"""
Rendezvous on elliptic orbits by range-rate control: an approach along a corridor, and a fly-around.

Source  Yu Shaohua, Yang Linna, J. Astronautics 1998 no. 3. Its equations are lost in the scan;
        what was derived and what was assumed in their place is in docs/missions.
"""

HERE = 'rvd_missions.elliptic_rendezvous'
