"""
The pair of cameras: rendered discs, their blobs, names, and the pose from both images at once.
"""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics.diagram.in_process import fly, judge_of
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.geometry.markers import RenderingParams
from rvd_dynamics.geometry.pinhole import CameraParams
from rvd_dynamics.motion import attitude
from rvd_dynamics.onboard.navigation.stereo import (
    ImageVision, named, pair, solve_together, StereoVision)
from rvd_dynamics.onboard.navigation.vision import VisionParams
from rvd_dynamics.world.sensors.camera import features, ImageParams
from rvd_dynamics.world.sensors.rendering import blobs, render
from rvd_missions.docking import markers

ROOT = Path(__file__).resolve().parents[4]
CAMERA = CameraParams()
PAIR = pair(CAMERA, 0.3)
LOOK = RenderingParams()
POINTS = np.concatenate([markers.BIG, markers.SMALL])
RADII = np.array([LOOK.big_radius_m]*6 + [LOOK.small_radius_m]*6)
NOISE = np.random.default_rng(3).standard_normal((1024, 1024))
KNOWN = VisionParams(), markers.BIG, markers.SMALL, 0.6, ()


def view(camera, offset, turn, sigma=0.0, rng=None):
    normals = rng.normal(size=(12, 2)) if rng else np.zeros((12, 2))
    return features(camera, ImageParams(corner_sigma_px=sigma), markers.TARGET_PORT + POINTS,
                    markers.FACING, offset, turn, normals, 1.0)


def at(distance, euler_deg=(0.5, -0.8, 0.6), across=(0.02, -0.015)):
    """Return offset and attitude with the faces about `distance` apart."""
    return np.array([-3.0 - distance, *across]), attitude.from_euler(np.radians(euler_deg))


def true_place(offset, turn):
    return attitude.rotate_back(turn, markers.TARGET_PORT - offset)


@pytest.mark.parametrize('distance', [3.0, 1.0, 0.3])
def test_the_centroid_of_a_rendered_disc_is_where_the_pinhole_projects_its_centre(distance):
    offset, turn = at(distance)
    image = render(CAMERA, LOOK, markers.TARGET_PORT + POINTS, RADII, markers.FACING, offset, turn,
                   NOISE)
    assert image.dtype == np.uint8 and image.shape == (1024, 1024)
    found = blobs(LOOK, image)
    for pixel in view(CAMERA, offset, turn)[:6]:
        assert np.nanmin(np.hypot(*(found[:, :2] - pixel).T)) < 0.08


def test_a_disc_hides_what_is_behind_it():
    """On the axis the small front marker is behind the big one; half aside, both make one area."""
    look = RenderingParams(noise=0.0, blur_px=0.01)
    straight = np.array([0.0, 0.0, 0.0, 1.0])

    def image(aside, points, radii):
        return render(CAMERA, look, np.array(points), radii, markers.FACING,
                      np.array([-2.0, aside, 0.0]), straight, 0.0*NOISE)
    near, far = [-0.15, 0.0, 0.0], [-0.0375, 0.0, 0.0]
    assert np.array_equal(image(0.0, [far, near], [0.005, 0.01]), image(0.0, [near], [0.01]))
    alone = [image(0.1, [near], [0.01]), image(0.1, [far], [0.01])]
    both = image(0.1, [far, near], [0.01, 0.01])                # 13 mm apart, as they look
    assert both.max() == 200 and np.all(both >= np.maximum(*alone))
    assert np.array_equal(both, image(0.1, [near, far], [0.01, 0.01]))
    # two circles of radii a, b with centres d apart share this much
    a, b, d = 12.0/0.95, 12.0/1.0625, 120.0/0.95 - 120.0/1.0625
    shared = (a*a*np.arccos((d*d + a*a - b*b)/(2*d*a)) + b*b*np.arccos((d*d + b*b - a*a)/(2*d*b))
              - 0.5*np.sqrt((a + b - d)*(d + a - b)*(d - a + b)*(d + a + b)))
    seen = (both.astype(float).sum() - 20.0*both.size)/180.0
    assert seen == pytest.approx(np.pi*(a*a + b*b) - shared, rel=0.005)


def test_an_image_without_markers_has_no_blobs():
    away = attitude.from_euler(np.radians([0.0, 0.0, 90.0]))
    image = render(CAMERA, LOOK, markers.TARGET_PORT + POINTS, RADII, markers.FACING,
                   np.array([-6.0, 0.0, 0.0]), away, NOISE)
    assert np.isnan(blobs(LOOK, image)).all()
    assert abs(image.mean() - 20.0) < 0.1 and abs(image.std() - 2.0) < 0.1


def test_two_cameras_without_noise_give_the_true_pose():
    offset, turn = at(1.0)
    pixels = np.stack([view(camera, offset, turn) for camera in PAIR])
    place, found, _, rms = solve_together(PAIR, POINTS, pixels, 0.1)
    assert_allclose(place, true_place(offset, turn), atol=1e-9)
    assert_allclose(found, turn, atol=1e-9)
    assert rms < 1e-7


def test_noise_of_the_joint_pose_is_that_of_its_covariance_and_below_that_of_one_camera():
    rng = np.random.default_rng(4)
    offset, turn = at(3.0)
    errors = []
    for _ in range(200):
        pixels = np.stack([view(camera, offset, turn, 0.1, rng) for camera in PAIR])[:, :6]
        place, found, covariance, _ = solve_together(PAIR, markers.BIG, pixels, 0.1)
        small = attitude.rotation_vector(attitude.multiply(attitude.conjugate(turn), found))
        errors.append(np.concatenate([place - true_place(offset, turn), small]))
    errors = np.array(errors)
    squares = np.einsum('ni,ij,nj->n', errors, np.linalg.inv(covariance), errors)
    assert squares.mean() == pytest.approx(6.0, rel=0.15)           # chi squared of six numbers
    assert errors[:, 0].std() < 1.2e-3                              # one camera: 1.5 mm


def test_blobs_are_named_in_any_order_also_after_the_pattern_moved():
    rng = np.random.default_rng(2)
    wanted = rng.uniform(200, 800, (6, 2))
    area = np.full(6, 40.0)
    order = rng.permutation(6)
    here = np.column_stack([wanted + 3.0, area])[order]
    assert_allclose(named(wanted, area, here, False), wanted + 3.0)
    far = np.column_stack([wanted + 60.0, area])[order]
    assert np.isnan(named(wanted, area, far, False)).all()
    assert_allclose(named(wanted, area, far, True), wanted + 60.0)
    small = np.column_stack([wanted, 0.1*area])
    assert np.isnan(named(wanted, area, small, False)).all()


def test_features_and_images_agree_on_the_pose():
    offset, turn = at(2.0)
    truly = true_place(offset, turn)
    pixels = np.stack([view(camera, offset, turn) for camera in PAIR])
    spots = np.stack([blobs(LOOK, render(camera, LOOK, markers.TARGET_PORT + POINTS, RADII,
                                         markers.FACING, offset, turn, NOISE))
                      for camera in PAIR])
    seen = StereoVision(PAIR, *KNOWN).poses(pixels)
    looked = ImageVision(PAIR, RADII, truly + [0.05, 0.04, -0.03],
                         np.array([0.0, 0.0, 0.0, 1.0]), *KNOWN).poses(spots)
    assert_allclose(seen.place, truly, atol=1e-9)
    assert_allclose(looked.place, truly, atol=1e-3)
    assert looked.usable == seen.usable == 12


def test_blobs_of_something_else_are_no_pose():
    rng = np.random.default_rng(1)
    noise = np.concatenate([rng.uniform(100, 900, (2, 24, 2)), np.full((2, 24, 1), 90.0)], axis=-1)
    offset, turn = at(2.0)
    made = ImageVision(PAIR, RADII, true_place(offset, turn), turn, *KNOWN).poses(noise)
    assert np.isnan(made.place).all()


@pytest.mark.slow
@pytest.mark.patient
def test_images_in_the_loop_from_near_the_port_keep_it_hovering():
    """From 20 cm, where both sets count, through the hand-over to the small one."""
    made = load(ROOT / 'scenarios' / 'docking_images.yaml').with_values(
        '/**', timeout_s=22.0, limits__from_s=18.0, aim__nominal_s=15.0,
        start__position_m=[-3.2, 0.02, -0.02], start__attitude_deg=[0.2, -0.2, 0.2])
    made = made.with_values('docking_controller', profile__fast_m_s=0.02, profile__dock_m_s=0.005)
    flown = fly(made, range(1))
    assert flown.verdict.success.all(), (flown.verdict.reason, flown.verdict.values)
    assert flown.columns['nav_error_m'][0] < 1e-3 and flown.columns['safety_state'][0] == 0


# -- the judge ------------------------------------------------------------------------------------

def lost(camera, places, **settings):
    """Return the time that the judge counts as blind over views from places (..., 3) of a craft."""
    made = load(ROOT / 'scenarios' / 'docking.yaml').with_values(
        '/**', seeing__camera=camera, **settings)
    judge, straight = judge_of(made), np.array([0.0, 0.0, 0.0, 1.0])
    for k, place in enumerate(places):
        judge.follow(10*k, SimpleNamespace(
            position=np.array(place), velocity=np.zeros(3), attitude=straight,
            target_attitude=straight, propellant=0.0, pulses=0.0))
    return float(judge.verdict().values['fov_lost_s'])


@pytest.mark.parametrize('camera, expected', [
    ('pinhole', 0.0), ('simple', 0.0), ('stereo', 0.1), ('rendered', 0.1)])
def test_the_judge_looks_through_the_cameras_that_there_are(camera, expected):
    """0.8 m apart they look past the port from 10 cm, where one between them sees it."""
    way = np.linspace([-6.0, 0.0, 0.0], [-3.1, 0.0, 0.0], 30)[:-1]
    wide = lost(camera, [*way, [-3.1, 0.0, 0.0]], stereo__baseline_m=0.8)
    assert wide == pytest.approx(expected)
    assert lost(camera, [*way, [-3.1, 0.0, 0.0]], stereo__baseline_m=0.3) == 0.0


def test_markers_of_the_set_that_does_not_count_do_not_count_for_the_judge():
    """0.6 m aside two big and two small ones are in view; 0.75 m away only the big ones count."""
    near, aside = [-3.55, 0.0, 0.0], [-3.75, 0.6, 0.0]
    assert lost('pinhole', [aside]) == pytest.approx(0.1)
    assert lost('pinhole', [near, aside]) == 0.0                # they still did when it came
    assert lost('pinhole', [near, aside, aside]) == pytest.approx(0.1)
