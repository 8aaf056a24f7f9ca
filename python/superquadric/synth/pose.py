"""Rigid motions `b_from_a`, written as matrices of shape (4, 4), and models moved by them."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator

from .._core import Superellipsoid
from .arrays import FloatArray


def motion(rotation: FloatArray, translation: FloatArray) -> FloatArray:
    """The motion `x -> rotation x + translation`."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, translation
    return matrix


def inverse(b_from_a: FloatArray) -> FloatArray:
    """The motion `a_from_b`."""
    rotation = b_from_a[:3, :3].T
    return motion(rotation, -rotation @ b_from_a[:3, 3])


def moved(b_from_a: FloatArray, points_a: FloatArray) -> FloatArray:
    """Points of shape (n, 3), moved from frame a to frame b."""
    points_b: FloatArray = points_a @ b_from_a[:3, :3].T + b_from_a[:3, 3]
    return points_b


def moved_model(b_from_a: FloatArray, model_a: Superellipsoid) -> Superellipsoid:
    """A model of frame a in frame b."""
    return Superellipsoid(
        model_a.size,
        model_a.exponents,
        rotation=b_from_a[:3, :3] @ model_a.rotation,
        translation=b_from_a[:3, :3] @ model_a.translation + b_from_a[:3, 3],
    )


def random_direction(rng: Generator) -> FloatArray:
    """A unit vector, of shape (3,), uniform on the sphere."""
    vector = rng.normal(size=3)
    direction: FloatArray = vector / np.linalg.norm(vector)
    return direction


def random_rotation(rng: Generator) -> FloatArray:
    """A rotation matrix, uniform over all: that of a quaternion uniform on its sphere."""
    quaternion = rng.normal(size=4)
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )


def turn(angle: float) -> FloatArray:
    """Rotation matrix about the z axis."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
