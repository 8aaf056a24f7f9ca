"""Where a camera stands."""

from __future__ import annotations

import math

import numpy as np
from numpy.random import Generator

from .._core import Superellipsoid
from .arrays import FloatArray
from .camera import Camera
from .pose import motion, moved, turn
from .suite import Floating, Standing, Viewpoint

FILL_ROUNDS = 8
"""Corrections of the distance, to whose inverse the share of the image is nearly proportional."""
NEAREST = 1.2
"""Least distance from the object's centre, in radii of the sphere that holds it."""


def draw_camera_from_world(
    model_world: Superellipsoid,
    placement: Floating | Standing,
    viewpoint: Viewpoint,
    camera: Camera,
    rng: Generator,
) -> FloatArray:
    """A camera that looks at the model's centre, upright if the model stands on a table."""
    azimuth = rng.uniform(-math.pi, math.pi)
    lowest, highest = (math.sin(angle) for angle in viewpoint.elevation)
    elevation = math.asin(rng.uniform(lowest, highest))
    roll = rng.uniform(-math.pi, math.pi)
    rotation = looking_inwards(azimuth, elevation)
    if isinstance(placement, Floating):
        rotation = turn(roll) @ rotation
    centred = motion(rotation, -rotation @ model_world.translation)
    vertices = moved(centred, model_world.mesh()[0])
    radius = float(np.linalg.norm(vertices, axis=1).max())
    reach = rng.uniform(*viewpoint.reach)
    if viewpoint.chosen_by == "fill":
        reach = _distance_that_fills(reach, vertices, radius, camera)
    centred[2, 3] += max(reach, NEAREST * radius)
    return centred


def looking_inwards(azimuth: float, elevation: float) -> FloatArray:
    """Rotation `camera_from_world` of an upright camera, seen from the origin in a direction.

    Its image's vertical is the world's z axis, upwards.
    """
    horizontal = np.array([math.cos(azimuth), math.sin(azimuth), 0.0])
    up = np.array([0.0, 0.0, 1.0])
    forward = -math.cos(elevation) * horizontal - math.sin(elevation) * up
    right = np.array([-math.sin(azimuth), math.cos(azimuth), 0.0])
    return np.stack([right, np.cross(forward, right), forward])


def _distance_that_fills(fill: float, vertices: FloatArray, radius: float, camera: Camera) -> float:
    """Depth of the origin at which vertices about it take up a share of the image."""
    distance = 6.0 * radius
    for _ in range(FILL_ROUNDS):
        image = camera.project(vertices + np.array([0.0, 0.0, distance]))
        share = float((np.ptp(image, axis=0) / [camera.width, camera.height]).max())
        distance = max(distance * share / fill, NEAREST * radius)
    return distance
