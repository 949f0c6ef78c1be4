"""
Basilisk (`bsk`), another spacecraft simulator, and the same craft here: to compare and to race.

Basilisk asks for older numpy, matplotlib and pillow than this project has. It stands in an
environment of its own, `.rvd/basilisk/`, which is made from requirements-basilisk.lock when it is
first needed, and flies in a process (`scripts/basilisk_flights.py`) that knows nothing of ours.

The craft has two panels of one mode and two tanks, or the tanks alone. Basilisk's panel is a rigid
plate on a hinge, whose one mode here is phi = xi/sqrt(J): the same but for terms of second order in
the angle, which the plate's tip makes by moving on a circle. Its particle on a spring is our tank.
"""

import json
import os
from pathlib import Path
import platform
import subprocess
import sys
import tempfile
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_campaign import catalogue
from rvd_dynamics.world.spacecraft.effectors import Panel, Tank
from rvd_dynamics.world.spacecraft.spacecraft import Spacecraft

MACHINES = ('x86_64', 'aarch64')        # with a wheel, for Python 3.9 to 3.14 and this glibc
GLIBC = (2, 28)
STEP_S = 0.0025                         # Runge-Kutta
MASS_KG, INERTIA = 2000.0, np.diag([2200.0, 3000.0, 2800.0])
PLATE_KG, LENGTH_M, ROOT_M = 18.0, 4.0, 0.9
HINGE = PLATE_KG*LENGTH_M**2/3.0        # [kg m^2] of a plate about its hinge
OMEGA, DAMPING = 2*np.pi*0.25, 0.005    # [rad/s] of the locked hinge
TANKS = ((60.0, (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.25),   # [kg], [m], axis, [rad/s]
         (140.0, (0.3, 0.0, 0.0), (0.0, 0.0, 1.0), 0.35))
TANK_DAMPING = 0.01
RACE_S, RACE_ROWS, RACE_STEPS, RACE_CALLS = 60.0, 100, 40, 50


class Unavailable(Exception):
    """Basilisk cannot be had on this machine; says why in one line."""


def python() -> Path:
    """
    Return the Python of Basilisk's environment, which is made on first need.

    Raises
    ------
    Unavailable
        If there is no wheel for this machine, or the set-up fails.
    """
    why = missing_wheel()
    if why:
        raise Unavailable(why)
    root = catalogue.root()
    done = subprocess.run([root / 'scripts' / 'setup.sh', '--basilisk', sys.executable],
                          stdin=subprocess.DEVNULL, check=False)
    if done.returncode:
        raise Unavailable('Basilisk could not be set up, for the reason above')
    return root / '.rvd' / 'basilisk' / 'bin' / 'python'


def missing_wheel() -> str:
    """Return why there is no wheel of Basilisk for this Python and machine; nothing if there is."""
    machine, (libc, version) = platform.machine(), platform.libc_ver()
    if sys.platform != 'linux' or machine not in MACHINES:
        return f'Basilisk has no wheel for {sys.platform} on {machine}'
    if libc != 'glibc' or tuple(map(int, version.split('.')[:2])) < GLIBC:
        return f'Basilisk has no wheel for {libc or "a libc other than glibc"} {version}'.rstrip()
    return ''


def fly(flights: dict[str, dict[str, Any]]) -> dict[str, NDArray]:
    """
    Fly in Basilisk, in one process; return what each flight gives, as 'NAME/WHAT'.

    Parameters
    ----------
    flights : dict
        By name: what `scripts/basilisk_flights.py` takes.
    """
    interpreter = python()
    with tempfile.TemporaryDirectory() as folder:
        request, out = Path(folder) / 'request.json', Path(folder) / 'out.npz'
        request.write_text(json.dumps(flights), encoding='utf-8')
        ours = ('PYTHON', 'LD_LIBRARY_PATH', 'VIRTUAL_ENV')         # of the project's environment
        subprocess.run(
            [interpreter, '-I', catalogue.root() / 'scripts' / 'basilisk_flights.py', request, out],
            env={k: v for k, v in os.environ.items() if not k.startswith(ours)} | {
                'MPLBACKEND': 'agg'},
            stdin=subprocess.DEVNULL, check=True)
        with np.load(out) as found:
            return dict(found)


def theirs(panels: bool, until_s: float, recorded: bool = True, rate: tuple = (0.0, 0.0, 0.0),
           force: tuple = (0.0, 0.0, 0.0), torque: tuple = (0.0, 0.0, 0.0), push_s: float = 0.0,
           bent_rad: float = 0.0) -> dict[str, Any]:
    """Return the flight of the craft that Basilisk is asked for; one panel is bent."""
    return {
        'kind': 'craft', 'mass_kg': MASS_KG, 'inertia': INERTIA.tolist(),
        'panels': [{'mass_kg': PLATE_KG, 'length_m': LENGTH_M, 'root_m': ROOT_M, 'side': side,
                    'omega_rad_s': OMEGA, 'damping': DAMPING, 'bent_rad': bent}
                   for side, bent in ((1.0, bent_rad), (-1.0, 0.0))] if panels else [],
        'tanks': [{'mass_kg': mass, 'place': place, 'axis': axis, 'omega_rad_s': omega,
                   'damping': TANK_DAMPING} for mass, place, axis, omega in TANKS],
        'rate': rate, 'force': force, 'torque': torque, 'push_s': push_s, 'until_s': until_s,
        'step_s': STEP_S, 'recorded': recorded}


def ours(panels: bool) -> Spacecraft:
    """Return the same craft; the coordinate of a panel is its angle times the root of HINGE."""
    made = ()
    if panels:
        root = np.sqrt(HINGE)
        made = tuple(Panel((0, side*ROOT_M, 0), (0, side, 0), (0, 0, 1),
                           np.array([PLATE_KG*LENGTH_M/2/root]), np.array([root]),
                           np.array([OMEGA]), np.array([DAMPING])) for side in (1.0, -1.0))
    tanks = tuple(Tank(place, np.array([axis]), mass, omega, TANK_DAMPING)
                  for mass, place, axis, omega in TANKS)
    return Spacecraft(MASS_KG, INERTIA, np.eye(3), made, tanks)


def race(turns: int = 3) -> dict[str, float]:
    """
    Return CPU times of a Runge-Kutta step [us], ours of a row in a batch, and their ratio.

    The same craft and the same steps, nothing recorded, turn about, and the best of each: what
    others take away from a shared machine is neither's.
    """
    flight, made = theirs(True, RACE_S, recorded=False, bent_rad=1e-2), ours(True)
    state, still = made.state(RACE_ROWS), np.zeros((RACE_ROWS, 2*RACE_STEPS + 1, 6))
    made.advance(state, still, RACE_STEPS*STEP_S)           # compiled
    mine, other = [], []
    for _ in range(turns):
        other.append(float(fly({'race': flight})['race/cpu_s'])*STEP_S/RACE_S)
        began = time.process_time()
        for _ in range(RACE_CALLS):
            state = made.advance(state, still, RACE_STEPS*STEP_S).state
        mine.append((time.process_time() - began)/(RACE_CALLS*RACE_STEPS*RACE_ROWS))
    return {'basilisk_us': 1e6*min(other), 'step_us': 1e6*min(mine),
            'basilisk_ratio': min(other)/min(mine)}
