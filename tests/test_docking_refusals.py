"""What cannot be a docking craft: its node says so in one line and ends with code 2."""

import subprocess

import pytest
from runs import environment, ROOT

BAD = {
    'negative inertia': (
        'docking_dynamics', 'chaser: {inertia_kg_m2: [-1.0, 3000.0, 2800.0]}', '',
        'inertia: each principal moment must be positive, got -1 kg m^2'),
    'mass matrix not positive definite': (
        'docking_dynamics', 'chaser: {inertia_kg_m2: [300.0, 400.0, 500.0]}', '',
        'the mass matrix must be positive definite, that is, panels and tanks have less inertia '
        'than all of the craft; least eigenvalue -'),
    'scatter without a possible craft': (
        'docking_dynamics', 'scatter: {products_kg_m2: 1e8}', '',
        'scatter: none of 8 draws of a run is a possible craft; the last: inertia: '),
    'start out of view': (
        'docking_dynamics', 'start: {position_m: [-6.0, 5.0, 0.0]}', '',
        'start: at least 4 markers must be in view at the start, got 0'),
    'thrusters without a wrench': (
        'docking_controller', '', 'failed: [11, 12]',
        'thrusters of J2, J3 cannot produce -force z alone: 22 of them are left, their wrenches '
        'have rank 6 of 6'),
    'dead band too wide': (
        'docking_controller', '', 'position: {gain: 5.0}',
        'position.gain: the dead band on_threshold/gain must be below 0.04, got 0.06'),
    'pulses too short': (
        'docking_controller', '', 'attitude: {modulator: {off_threshold: 0.25}}',
        'attitude.modulator: its shortest pulse must not be below the least on-time of a thruster, '
        '0.04 s, got 0.02565 s'),
}


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('node, shared, own, line', BAD.values(), ids=BAD)
def test_a_node_that_cannot_work_says_why_in_one_line_and_ends_with_code_2(
        node, shared, own, line, tmp_path):
    text = f'/**: {{ros__parameters: {{mission: docking{", " + shared if shared else ""}}}}}\n'
    if own:
        text += f'{node}: {{ros__parameters: {{{own}}}}}\n'
    (tmp_path / 'bad.yaml').write_text(text)
    done = subprocess.run(
        [ROOT / 'rvd', 'node', 'rvd_missions', node, '--ros-args', '--params-file',
         tmp_path / 'bad.yaml'], env=environment(), capture_output=True, text=True, timeout=120)
    assert done.returncode == 2, (done.stdout, done.stderr)
    said = done.stderr.strip().splitlines()
    assert len(said) == 1 and said[0].startswith(f'{node}: {line}'), done.stderr
