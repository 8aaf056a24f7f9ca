"""Clouds whose every point is known to be of the object or not."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator

from .._core import Superellipsoid
from .arrays import BoolArray, FloatArray

GREATEST_SEED = 2**63


@dataclass(frozen=True)
class Cloud:
    """Points with what they are.

    Attributes:
        points: of shape (n, 3), in the frame that their user says.
        is_inlier: of shape (n,), false for strays and for mixed pixels.
    """

    points: FloatArray
    is_inlier: BoolArray


def sampled(model: Superellipsoid, count: int, deviation: float, rng: Generator) -> Cloud:
    """Points uniform by area on the whole surface, each coordinate with normal noise."""
    on_surface = model.sample(count, seed=int(rng.integers(GREATEST_SEED)))
    noise = rng.normal(size=on_surface.shape)
    return Cloud(on_surface + deviation * noise, np.ones(count, dtype=bool))


def thinned(cloud: Cloud, count: int, rng: Generator) -> Cloud:
    """So many of the points, in their order; all of them if there are not so many."""
    if count >= len(cloud.points):
        return cloud
    kept = np.sort(rng.choice(len(cloud.points), count, replace=False))
    return Cloud(cloud.points[kept], cloud.is_inlier[kept])


def with_strays(
    cloud: Cloud, model: Superellipsoid, box_scale: float, count: int, rng: Generator
) -> Cloud:
    """The cloud with points uniform in a box about the model, in an order that tells nothing.

    The box is the model's bounding box along the axes of the frame, its sides scaled.
    """
    low, high = model.bounding_box
    centre, half = 0.5 * (low + high), 0.5 * box_scale * (high - low)
    strays = centre + half * rng.uniform(-1.0, 1.0, (count, 3))
    order = rng.permutation(len(cloud.points) + count)
    return Cloud(
        np.concatenate([cloud.points, strays])[order],
        np.concatenate([cloud.is_inlier, np.zeros(count, dtype=bool)])[order],
    )


def split(points: int, strays: float, available: int) -> tuple[int, int]:
    """Numbers of measured points and of strays in a cloud of `points` points.

    Fewer in all where fewer than the measured ones are available; the share of strays stays.
    """
    measured = min(points - round(strays * points), available)
    return measured, round(measured * strays / (1.0 - strays))
