"""
Camera, pose and inertial unit of the docking chaser.
"""

import cv2
import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.spatial.transform import Rotation

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.geometry.pinhole import CameraParams, project, require_in_view, require_markers
from rvd_dynamics.motion import attitude
from rvd_dynamics.onboard.navigation.vision import (
    _quaternion, BIG, BOTH, SMALL, solve, Vision, VisionParams)
from rvd_dynamics.world.sensors.camera import features, ImageParams
from rvd_dynamics.world.sensors.inertial import DEG_H, DRAWS, InertialParams, InertialUnit
from rvd_missions.docking import markers

CAMERA = CameraParams()
POINTS = np.concatenate([markers.BIG, markers.SMALL])
FACE_M = 0.6                        # [m] camera to the chaser's own face


def seen(distance, lateral=(0.0, 0.0), turn=(0.0, 0.0, 0.0), image=None, rng=None):
    """Return features (12, 2), port in craft axes and attitude, the faces `distance` apart."""
    q = attitude.from_rotation_vector(turn)
    port = np.array([-distance, *lateral]) + markers.TARGET_PORT       # chaser's port, target axes
    offset = port - attitude.rotate(q, markers.CHASER_PORT)
    image = ImageParams(corner_sigma_px=0.0) if image is None else image
    normals = np.zeros((12, 2)) if rng is None else rng.normal(size=(12, 2))
    pixels = features(CAMERA, image, markers.TARGET_PORT + POINTS, markers.FACING, offset, q,
                      normals, 0.5)
    return pixels, attitude.rotate_back(q, markers.TARGET_PORT - offset), q


def vision():
    return Vision(CAMERA, VisionParams(), markers.BIG, markers.SMALL, FACE_M, ())


# -- camera ---------------------------------------------------------------------------------------

def test_projection_is_that_of_opencv():
    rng = np.random.default_rng(1)
    points = rng.uniform(-0.2, 0.2, (20, 3)) + [0.0, 0.0, 2.0]
    expected = cv2.projectPoints(points, np.zeros(3), np.zeros(3), CAMERA.matrix, None)[0][:, 0]
    assert_allclose(project(CAMERA, points), expected, atol=1e-9)


def test_the_field_of_view_is_46_degrees_and_behind_the_camera_is_nothing():
    assert 2*np.degrees(np.arctan(CAMERA.half_view)) == pytest.approx(46.2, abs=0.1)
    edge = CAMERA.half_view*2.0
    found = project(CAMERA, [[0.999*edge, 0, 2.0], [1.001*edge, 0, 2.0], [0, 0, -2.0]])
    assert np.isfinite(found[0]).all() and np.isnan(found[1:]).all()


def test_right_is_right_and_down_is_down():
    """A chaser displaced to +y sees the port to the left, below it (+z) sees it higher up."""
    centre = np.nanmean(seen(3.0, (0.2, 0.1))[0], axis=0)
    assert centre[0] < 512.0 - 40.0 and centre[1] < 512.0 - 10.0


def test_markers_are_hidden_from_behind_and_lost_with_their_frame():
    q = np.array([0.0, 0.0, 0.0, 1.0])
    behind = features(CAMERA, ImageParams(), markers.TARGET_PORT + POINTS, -markers.FACING,
                      [-6.0, 0, 0], q, np.zeros((12, 2)), 0.5)
    assert np.isnan(behind).all()
    assert np.isnan(seen(3.0, image=ImageParams(drop_out=0.6))[0]).all()
    assert np.isfinite(seen(3.0, image=ImageParams(drop_out=0.4))[0]).all()


def test_the_big_markers_leave_the_view_near_the_port():
    """At 7 cm the corners are 0.285 m from the edge of the view: a lateral 4 cm is enough."""
    assert np.isfinite(seen(0.07)[0]).all()
    pixels = seen(0.07, (0.04, 0.0))[0]
    assert np.isnan(pixels[:6]).any() and np.isfinite(pixels[6:]).all()


def test_a_camera_out_of_line_sees_the_port_elsewhere():
    straight, askew = (seen(3.0, image=ImageParams(corner_sigma_px=0.0, alignment_deg=a))[0]
                       for a in ((0, 0, 0), (0, 0, 0.1)))
    assert np.nanmean(askew - straight, axis=0)[0] == pytest.approx(
        -1200*np.radians(0.1), rel=0.02)            # yaw to the right: the port moves to the left


@pytest.mark.parametrize('points, words', [
    (markers.BIG[:5], 'must not lie in one plane'), (markers.BIG[:3], 'needs 4 markers, got 3')])
def test_markers_without_a_pose_are_refused(points, words):
    require_markers('markers', markers.BIG)
    require_markers('markers', markers.SMALL)
    with pytest.raises(BadInput, match=words):
        require_markers('markers', points)


def test_a_start_without_enough_markers_in_view_is_refused():
    require_in_view('start', seen(3.0)[0][:6])
    with pytest.raises(BadInput, match='at least 4 markers must be in view at the start, got 0'):
        require_in_view('start', seen(3.0, (3.0, 0.0))[0][:6])


# -- pose -----------------------------------------------------------------------------------------

@pytest.mark.parametrize('distance', [3.0, 1.0, 0.3, 0.07])
def test_pose_without_noise_is_the_true_one(distance):
    pixels, place, q = seen(distance, (0.02, -0.01), (0.03, -0.02, 0.05))
    pose = vision().poses(pixels)
    assert_allclose(pose.place, place, atol=1e-6)
    assert abs(np.sum(pose.turn*q)) == pytest.approx(1.0, abs=1e-10)


PUBLISHED = {3.0: (0.13, 0.12, 1.5, 0.10), 1.0: (.05, .05, .26, .037), 0.07: (.02, .02, .05, .01)}


@pytest.mark.parametrize('distance', PUBLISHED)
def test_noise_of_the_pose_is_that_of_the_specification_and_of_its_covariance(distance):
    """One sigma across, across and along [mm] and of the attitude [deg], from 400 solved views."""
    rng, errors, turns = np.random.default_rng(7), [], []
    for _ in range(400):
        pixels, place, q = seen(distance, image=ImageParams(), rng=rng)
        found, turn, covariance = solve(CAMERA, markers.BIG, pixels[:6], 0.1)
        errors.append(found - place)
        turns.append(attitude.rotation_vector(attitude.multiply(attitude.conjugate(q), turn)))
    sigma = np.concatenate([np.std(errors, axis=0), np.std(turns, axis=0)])
    assert_allclose(sigma, np.sqrt(np.diag(covariance)), rtol=0.15)
    found = [1e3*sigma[1], 1e3*sigma[2], 1e3*sigma[0], np.degrees(sigma[4:]).mean()]
    print(distance, np.round(found, 3))
    assert_allclose(found, PUBLISHED[distance], rtol=0.25)
    both = np.concatenate([errors, turns], axis=1)
    normalised = np.einsum('ni,ij,nj->n', both, np.linalg.inv(covariance), both)
    assert normalised.mean() == pytest.approx(6.0, abs=0.6)       # chi squared: cross terms, too


def test_markers_are_handed_over_with_hysteresis():
    eye = vision()

    def at(distance):
        eye.poses(seen(distance)[0])
        return int(eye.mode)
    assert [at(d) for d in (3.0, 0.64, 0.59, 0.62, 0.64, 0.66)] == [BIG, BIG, BOTH, BOTH, BOTH, BIG]
    assert [at(d) for d in (0.59, 0.13, 0.11, 0.13, 0.16, 0.18)] == [
        BOTH, BOTH, SMALL, SMALL, SMALL, BOTH]


def test_between_the_hand_overs_both_sets_are_solved_and_one_alone_would_do():
    eye = vision()
    pixels = seen(0.4)[0]
    eye.poses(pixels)
    assert eye.poses(pixels).usable == 12
    assert np.isfinite(eye.poses(np.where(np.arange(12)[:, None] < 6, np.nan, pixels)).place).all()


def test_fewer_than_four_markers_give_no_pose():
    pixels = seen(3.0)[0]
    pixels[:3] = np.nan
    pose = vision().poses(pixels)
    assert np.isnan(pose.place).all() and np.isnan(pose.covariance).all() and pose.usable == 3


def test_rows_are_solved_each_for_itself():
    eye = Vision(CAMERA, VisionParams(), markers.BIG, markers.SMALL, FACE_M, (3,))
    views = [seen(d) for d in (3.0, 0.5, 1.0)]
    pose = eye.poses(np.stack([v[0] for v in views]))
    assert_allclose(pose.place, [v[1] for v in views], atol=1e-6)
    assert eye.mode.tolist() == [BIG, BOTH, BIG]


def test_attitudes_of_any_size_are_read_off_the_matrix():
    for rotation in Rotation.random(50, random_state=3):
        q = rotation.as_quat()
        assert abs(np.sum(_quaternion(rotation.as_matrix())*q)) == pytest.approx(1.0, abs=1e-12)


# -- inertial unit --------------------------------------------------------------------------------

def test_the_inertial_unit_is_exact_without_noise_and_bias():
    quiet = InertialParams(gyro_sigma_deg_s=0, gyro_bias_deg_h=0, gyro_walk_rad_s=0,
                           accel_sigma_m_s2=0, accel_bias_m_s2=0)
    rate, felt = np.array([0.1, 0.2, 0.3]), np.array([1.0, 2.0, 3.0])
    sampled = InertialUnit(InertialParams(**{**vars(quiet), 'gyro': 'sampled'}), 0.01, np.zeros(6))
    counting = InertialUnit(quiet, 0.01, np.zeros(6))
    given = (rate, felt, 0.009*rate, 0.008*felt, np.zeros(DRAWS))
    assert_allclose(sampled.measure(*given), (rate, felt))
    assert_allclose(counting.measure(*given), (0.9*rate, 0.8*felt))


def test_noise_bias_and_walk_have_their_sizes():
    rng = np.random.default_rng(2)
    unit = InertialUnit(InertialParams(gyro_walk_rad_s=1e-4), 0.01, rng.normal(size=(4000, 6)))
    still = np.zeros((4000, 3))
    assert unit.gyro_bias.std() == pytest.approx(5.0*DEG_H, rel=0.03)
    assert unit.accel_bias.std() == pytest.approx(3e-4, rel=0.03)
    first = unit.gyro_bias.copy()
    gyro, accel = unit.measure(still, still, still, still, rng.normal(size=(4000, DRAWS)))
    assert (gyro - unit.gyro_bias).std() == pytest.approx(np.radians(0.005), rel=0.03)
    assert (accel - unit.accel_bias).std() == pytest.approx(1e-3, rel=0.03)
    for _ in range(399):
        unit.measure(still, still, still, still, rng.normal(size=(4000, DRAWS)))
    assert (unit.gyro_bias - first).std() == pytest.approx(1e-4*np.sqrt(4.0), rel=0.05)
