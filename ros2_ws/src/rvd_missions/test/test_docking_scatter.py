"""
Craft of docking that differ from run to run: sizes of the scatter, impossible draws, same craft for
plant, camera and judge; a thruster that fails by the number of the run.
"""

from types import SimpleNamespace

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import fly, judge_of
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.recording.drawing import svg
from rvd_missions.docking import scatter as scattering
from rvd_missions.docking.campaign_figures import FIGURES
from rvd_missions.docking.scatter import CANDIDATES, drawn, PROPERTIES, Scatter, WIDTH
from rvd_missions.docking.settings import Chaser

ALL = ('mass: 0.05, inertia: 0.1, products_kg_m2: 50.0, mode_frequency: 0.2, participation: 0.2, '
       'slosh_mass: 0.3, slosh_rad_s: [0.02, 0.5], centre_m: 0.03, thrust: 0.05, '
       'alignment_deg: 0.02, camera_m: 0.002')


def scenario(seconds, scatter='', **sections):
    """Return a scenario of some length, simple camera."""
    text = ('/**: {ros__parameters: {mission: docking, seeing: {camera: simple}, '
            f'timeout_s: {seconds}, limits: {{from_s: 0.1}}'
            + (f', scatter: {{{scatter}}}' if scatter else '') + '}}\n')
    for name, settings in sections.items():
        text += f'{name}: {{ros__parameters: {{{settings}}}}}\n'
    return parse(text, 'test')


@pytest.fixture(scope='module')
def craft():
    return scenario(1.0).part('craft')


def of(craft, rows=600, seed=0, **settings):
    """Return what runs have."""
    return drawn(Scatter(**settings), craft, Chaser(),
                 PROPERTIES.of_runs(seed, range(rows), 1))


def test_scatter_has_the_size_that_is_asked_for(craft):
    """Deviations and bounds of 600 runs; a standard deviation is known to 3 %."""
    own = of(craft, mass=0.05, inertia=0.1, products_kg_m2=50.0, mode_frequency=0.2,
             participation=0.2, slosh_mass=0.3, slosh_rad_s=(0.02, 0.5), centre_m=0.03,
             thrust=0.05, alignment_deg=0.02, camera_m=0.002)
    c = own.craft
    assert np.std(c.mass)/2000.0 == pytest.approx(0.05, rel=0.1)
    moments = np.diagonal(c.inertia, axis1=1, axis2=2)/np.diagonal(craft.inertia)
    assert_allclose(moments.std(axis=0), 0.1, rtol=0.1)
    products = c.inertia[:, [0, 0, 1], [1, 2, 2]]
    assert np.abs(products).max() < 50.0 and products.min() < -45.0 and products.max() > 45.0
    assert_allclose(products.std(axis=0), 50.0/np.sqrt(3.0), rtol=0.1)
    for mine, nominal in zip(c.panels, craft.panels):
        assert_allclose((mine.frequency/nominal.frequency).std(axis=0), 0.2, rtol=0.12)
        share = mine.first_moment/nominal.first_moment
        assert_allclose(share.std(axis=0), 0.2, rtol=0.12)
        assert_allclose(share, mine.second_moment/nominal.second_moment)
    for mine, nominal in zip(c.tanks, craft.tanks):
        assert np.std(mine.mass/nominal.mass) == pytest.approx(0.3, rel=0.1)
        assert mine.frequency.min() > 0.02 and mine.frequency.max() < 0.5
        assert np.mean(mine.frequency) == pytest.approx(0.26, abs=0.02)
    assert_allclose(np.abs(own.centre), 0.03)
    assert 250 < (own.centre[:, 0] > 0.0).sum() < 350
    assert_allclose(own.thrust.std(axis=0).mean(), 0.05, rtol=0.03)
    assert_allclose(own.alignment.std(axis=0), 0.02, rtol=0.1)
    assert_allclose(own.camera.std(axis=0), 0.002, rtol=0.1)
    assert abs(np.corrcoef(c.mass, moments[:, 0])[0, 1]) < 0.15


def test_without_scatter_there_is_one_craft_for_all(craft):
    own = of(craft, rows=3)
    assert own.craft is craft
    assert not own.centre.any() and not own.alignment.any() and np.all(own.thrust == 1.0)


def test_an_impossible_craft_is_drawn_again_and_counted(craft):
    """Liquid with a deviation of 60 % is below nothing in 1 - (1 - 0.0478)^2 = 9.3 % of draws."""
    own = of(craft, rows=400, slosh_mass=0.6)
    assert (own.redrawn > 0).mean() == pytest.approx(0.093, abs=0.045)
    assert min(tank.mass.min() for tank in own.craft.tanks) > 0.0
    normals = PROPERTIES.of_runs(0, range(400), 1).reshape(400, CANDIDATES, WIDTH)
    first = scattering._split(normals[:, 0])['slosh_mass']
    assert np.array_equal(own.redrawn > 0, (1.0 + 0.6*first <= 0.0).any(axis=1))


def test_a_run_without_any_possible_craft_is_refused_in_one_line(craft):
    normals = np.tile(PROPERTIES.of_runs(0, [0], 1)[:, :WIDTH], (1, CANDIDATES))
    normals[:, 1::WIDTH] = 20.0         # all about x
    with pytest.raises(BadInput, match='none of 8 draws of a run is a possible craft; the last: '
                       'inertia: no principal moment may exceed the sum of the others') as refused:
        drawn(Scatter(inertia=0.1), craft, Chaser(), normals)
    assert '\n' not in str(refused.value)


@pytest.mark.parametrize('scatter, words', [
    ('slosh_rad_s: [0.5, 0.02]', r'scatter.slosh_rad_s must be 0 and 0, or rise, got \[0.5, 0.02'),
    ('slosh_rad_s: [0.0, 0.5]', r'scatter.slosh_rad_s\[0\] must be above 0, got 0.0'),
    ('mass: -0.1', 'scatter.mass must be between 0 and 1, got -0.1'),
    ('centre: 0.1', 'centre')])
def test_scatter_that_cannot_be_is_refused_in_one_line(scatter, words):
    with pytest.raises(BadInput, match=words) as refused:
        scenario(1.0, scatter)
    assert '\n' not in str(refused.value)


@pytest.fixture(scope='module')
def flown():
    return fly(scenario(2.0, ALL), range(5), record=True)


def test_a_scattered_run_has_the_bits_of_the_run_alone(flown):
    alone = fly(scenario(2.0, ALL), [3], record=True)
    for name in ('/truth/spacecraft', '/onboard/estimate', '/onboard/thruster_command'):
        for a, b in zip(alone.history[name], flown.history[name]):
            assert a is b is None or np.array_equal(a[:, 0], b[:, 3], equal_nan=True)


def test_judge_and_plant_see_the_same_centre_of_mass(craft):
    """30 mm in each axis, with the signs that the plant's own draws give; a graph's judge, too."""
    run = scenario(2.0, ALL)
    plant = drawn(Scatter(centre_m=0.03), craft, Chaser(),
                  PROPERTIES.of_runs(run.run.seed, range(5), 1)).centre
    assert_allclose(np.abs(plant), 0.03)
    assert np.array_equal(judge_of(run, (5,), range(5))._centre, plant)
    assert np.array_equal(judge_of(run)._centre, plant[0])      # the monitor of run 0


def test_a_camera_turned_by_a_degree_shows_the_port_aside_by_its_distance():
    """Yaw of +1 degree: the port, 5.1 m ahead of the lens, seems to be 9 cm to the right."""
    seen = {}
    for turn in (0.0, 1.0):
        flown = fly(scenario(0.4, camera=f'image: {{alignment_deg: [0.0, 0.0, {turn}]}}'),
                    range(1), record=['/onboard/pose'])
        seen[turn] = flown.history['/onboard/pose'].place[-1, 0]
    ahead = seen[0.0][0] - 0.9
    assert seen[1.0][1] - seen[0.0][1] == pytest.approx(-ahead*np.sin(np.radians(1.0)), rel=0.02)


def test_each_run_fails_the_thruster_of_its_number():
    stuck = scenario(0.3, docking_dynamics='failure: stuck_on, failed_by_run: true')
    runs = [3, 36, 37]
    truth = fly(stuck, runs, record=['/truth/spacecraft']).history['/truth/spacecraft']
    open_at_first = truth.thrust[8] > 0.5               # before anything is commanded
    assert [np.flatnonzero(row).tolist() for row in open_at_first] == [[3], [36], [0]]


def test_each_run_knows_which_thruster_has_failed():
    """Thrusters 5 and 6 push along -x, +-y: known to be dead, they are never commanded."""
    known = scenario(3.0, docking_controller='failed_by_run: true')
    told = fly(known, [1, 2, 3], record=['/onboard/command']).history['/onboard/command'].command
    for row, thruster in enumerate((1, 2, 3)):
        assert not told[:, row, thruster].any() and told[:, row].any()
    assert told[:, 0, 2].any()                  # which in row 1 nobody takes to be dead


def test_a_run_that_never_comes_does_not_stretch_the_picture_of_the_margins():
    """One held at 3 m, one that touched before it was judged: one is said, neither is drawn."""
    table = {'hover_min_m': [0.04, 0.05, 3.07, np.nan], 'hover_max_m': [0.09, 0.12, 3.08, np.nan],
             'lateral_m': [0.02, 0.03, 0.3, np.nan], 'attitude_deg': [0.3, 0.31, 0.3, np.nan]}
    results = SimpleNamespace(tables={'all': table}, campaign=SimpleNamespace(
        conditions=[SimpleNamespace(scenario=scenario(1.0))]))
    drawn_on = []

    def draw():
        figure, caption = FIGURES['margins'].draw(results)
        drawn_on.append((figure, caption))
        return figure
    assert '<svg' in svg('margins', draw)
    figure, caption = drawn_on[0]
    assert caption.endswith('Not drawn: 1 of 4, never in the band meanwhile.')
    assert [axes.get_xlim()[1] < 0.5 for axes in figure.axes] == [True]*4
