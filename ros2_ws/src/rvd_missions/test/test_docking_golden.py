"""
The golden-section law in place of the attitude's PID loops in the mission docking.
"""

from pathlib import Path

import numpy as np
import pytest

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.onboard.control.pseudo_rate import ModulatorParams
from rvd_dynamics.onboard.control.six_loops import AttitudeLoopParams, LoopParams, SixLoops
from rvd_missions.docking.golden import GoldenLoopParams, GoldenLoops

ROOT = Path(__file__).resolve().parents[4]
ACCELERATION = 16.0/np.array([2200.0, 3000.0, 2800.0])
H = 0.01


def test_a_rigid_axis_comes_to_rest_whatever_its_thrusters_really_give():
    """Double integrators, 1.5 degrees off, with half to twice the thrust that the law knows of."""
    gain = np.array([[0.5], [1.0], [2.0]])
    loops = GoldenLoops(GoldenLoopParams(), SixLoops(LoopParams(), AttitudeLoopParams(), H, (3,)),
                        ModulatorParams(), ACCELERATION, H, 3)
    turn, spin = np.tile(np.radians([1.5, -1.5, 1.0]), (3, 1)), np.zeros((3, 3))
    furthest, still = 0.0, np.zeros((3, 3))
    for k in range(7000):
        u = loops.step(np.concatenate([still, -turn], -1), np.concatenate([still, -spin], -1))
        assert not u[:, :3].any()
        push = gain*ACCELERATION*u[:, 3:]
        turn, spin = turn + H*spin + 0.5*H*H*push, spin + H*push
        furthest = max(furthest, np.abs(turn).max() if k > 5000 else 0.0)
    assert np.degrees(furthest) < 0.3


@pytest.mark.slow
@pytest.mark.patient
def test_the_craft_hovers_with_it_and_its_attitude_is_closer_than_with_pid():
    made = load(ROOT / 'scenarios' / 'docking.yaml').with_values(
        '/**', timeout_s=45.0, seeing__camera='simple', limits__from_s=35.0, aim__nominal_s=30.0,
        start__position_m=[-3.4, 0.05, -0.04])
    flown = fly(made.with_values('docking_controller', attitude_law='golden_section',
                                 profile__fast_m_s=0.02, profile__dock_m_s=0.005), range(1))
    assert flown.verdict.success.all(), (flown.verdict.reason, flown.verdict.values)
    assert np.all(flown.verdict.values['attitude_deg'] < 0.25)
    assert np.all(flown.columns['safety_state'] == 0)
