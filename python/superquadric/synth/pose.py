"""Rigid motions `b_from_a`, written as matrices of shape (4, 4), and models moved by them."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from .._core import Superellipsoid


def motion(rotation: NDArray[np.float64], translation: NDArray[np.float64]) -> NDArray[np.float64]:
    """The motion `x -> rotation x + translation`."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, translation
    return matrix


def moved(b_from_a: NDArray[np.float64], points_a: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points of shape (n, 3), moved from frame a to frame b."""
    return points_a @ b_from_a[:3, :3].T + b_from_a[:3, 3]


def moved_model(b_from_a: NDArray[np.float64], model_a: Superellipsoid) -> Superellipsoid:
    """A model of frame a in frame b."""
    return Superellipsoid(
        model_a.size,
        model_a.exponents,
        rotation=b_from_a[:3, :3] @ model_a.rotation,
        translation=b_from_a[:3, :3] @ model_a.translation + b_from_a[:3, 3],
    )


def random_direction(rng: Generator) -> NDArray[np.float64]:
    """A unit vector, of shape (3,), uniform on the sphere."""
    vector = rng.normal(size=3)
    return vector / np.linalg.norm(vector)


def random_rotation(rng: Generator) -> NDArray[np.float64]:
    """A rotation matrix, uniform over all: that of a quaternion uniform on its sphere."""
    w, *v = (q := rng.normal(size=4)) / np.linalg.norm(q)
    cross = np.cross(np.eye(3), v)
    return (w * w - np.dot(v, v)) * np.eye(3) + 2.0 * np.outer(v, v) - 2.0 * w * cross


def turn(angle: float) -> NDArray[np.float64]:
    """Rotation matrix about the z axis."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
