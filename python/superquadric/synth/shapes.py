"""Models drawn from families and put into the world."""

from __future__ import annotations

import math

import numpy as np
from numpy.random import Generator

from .._core import Superellipsoid
from .arrays import FloatArray
from .pose import random_direction, random_rotation, turn
from .suite import Family, Floating, Standing

UPRIGHT = {
    "x": np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    "y": np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
    "z": np.eye(3),
}
"""Rotations that take an axis of the model to the world's z axis."""


def draw_model(family: Family, placement: Floating | Standing, rng: Generator) -> Superellipsoid:
    """A model of a family, in the world."""
    size = np.array(
        [math.exp(rng.uniform(math.log(low), math.log(high))) for low, high in family.size]
    )
    exponents = [rng.uniform(low, high) for low, high in family.exponents]
    size[: family.equal] = size[0]
    if isinstance(placement, Standing):
        rotation, translation = _standing(size, placement, rng)
    else:
        rotation, translation = _floating(size, placement, rng)
    return Superellipsoid(size, exponents, rotation=rotation, translation=translation)


def _floating(
    size: FloatArray, placement: Floating, rng: Generator
) -> tuple[FloatArray, FloatArray]:
    distance = rng.uniform(*placement.offset) * size.mean()
    return random_rotation(rng), distance * random_direction(rng)


def _standing(
    size: FloatArray, placement: Standing, rng: Generator
) -> tuple[FloatArray, FloatArray]:
    """Upright anywhere on the middle half of the table, which the lowest point touches."""
    up = placement.up[rng.integers(len(placement.up))]
    rotation = turn(rng.uniform(-math.pi, math.pi)) @ UPRIGHT[up]
    x, y = (rng.uniform(-0.25, 0.25) * side for side in placement.table)
    return rotation, np.array([x, y, size["xyz".index(up)]])
