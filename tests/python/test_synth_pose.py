"""Motions and cameras in them."""

import math

import numpy as np
import pytest

from superquadric import Superellipsoid
from superquadric.synth.pose import inverse, motion, moved, moved_model, random_rotation
from superquadric.synth.viewpoint import looking_inwards

ROUNDING = 1e-12
"""Of numbers of about 1 after some tens of operations."""


@pytest.fixture
def b_from_a():
    rng = np.random.default_rng(4)
    return motion(random_rotation(rng), rng.normal(size=3))


@pytest.mark.parametrize("azimuth", [-3.0, 0.0, 1.0])
@pytest.mark.parametrize("elevation", [-math.pi / 2, -0.5, 0.0, 1.0, math.pi / 2])
def test_a_camera_looks_inwards_and_upright(azimuth, elevation):
    rotation = looking_inwards(azimuth, elevation)
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=ROUNDING)
    assert np.linalg.det(rotation) == pytest.approx(1.0, abs=ROUNDING)
    horizontal = [math.cos(azimuth), math.sin(azimuth)]
    towards_camera = np.array([*(math.cos(elevation) * x for x in horizontal), math.sin(elevation)])
    np.testing.assert_allclose(rotation @ towards_camera, [0.0, 0.0, -1.0], atol=ROUNDING)
    x, y, _ = rotation @ [0.0, 0.0, 1.0]
    # y points down.
    np.testing.assert_allclose([x, y], [0.0, -math.cos(elevation)], atol=ROUNDING)


def test_random_rotations_are_rotations_without_a_direction_of_their_own():
    rng = np.random.default_rng(0)
    rotations = np.stack([random_rotation(rng) for _ in range(2000)])
    products = rotations @ rotations.transpose(0, 2, 1)
    np.testing.assert_allclose(products, np.broadcast_to(np.eye(3), (2000, 3, 3)), atol=ROUNDING)
    np.testing.assert_allclose(np.linalg.det(rotations), 1.0, atol=ROUNDING)
    # Entries are uniform on -1..1, of mean 0 and mean square 1/3; to five standard errors.
    np.testing.assert_allclose(rotations.mean(axis=0), np.zeros((3, 3)), atol=0.065)
    np.testing.assert_allclose((rotations**2).mean(axis=0), np.full((3, 3), 1 / 3), atol=0.034)


def test_the_inverse_moves_back(b_from_a):
    points = np.random.default_rng(1).normal(size=(10, 3))
    np.testing.assert_allclose(moved(inverse(b_from_a), moved(b_from_a, points)), points)


def test_a_model_moves_with_its_points(b_from_a):
    model = Superellipsoid([1, 2, 3], [0.5, 1.2], euler_zyz=[0.3, 1.1, -0.8], translation=[1, 2, 3])
    points = np.random.default_rng(1).normal(size=(10, 3))
    np.testing.assert_allclose(
        moved_model(b_from_a, model).gauge(moved(b_from_a, points)),
        model.gauge(points),
        rtol=1e-10,
    )
