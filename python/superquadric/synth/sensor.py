"""What a range sensor makes of an ideal camera's image.

Pixels at depth jumps mix the depths of both sides, or are lost; the depth gets noise that grows
with its square, along the ray; then it is rounded to a step of the disparity; pixels that see
the surface at a grazing angle are lost. Each part can be switched off.

Unlike those of real sensors, errors of neighbouring pixels are independent, and there are no
shadows, where one of two eyes sees nothing.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.random import Generator

from .arrays import BoolArray, FloatArray
from .view import View

STEEPEST_NOISE = math.radians(80.0)
"""Angle of incidence from which the noise grows no more: its law has a pole at 90 degrees."""


@dataclass(frozen=True)
class Sensor:
    """Parameters of a range sensor; lengths are in metres, angles in radians.

    Attributes:
        noise_floor: least standard deviation of the depth.
        noise_growth: what it grows by with the square of the depth beyond `noise_from`, per metre.
        noise_from: depth up to which it does not grow.
        noise_disparity: standard deviation of the disparity, in pixels.
        noise_grazing: what it grows by with the angle of incidence, per `z^(-1/2)`.
        baseline: distance of the two eyes of the stereo that finds the depth.
        disparity_step: what disparities are rounded to, in pixels; 0 for no rounding.
        grazing: angles of incidence at which the first and the last pixels are lost; None if none.
        jump: difference of the depths of neighbouring pixels that counts as a jump, in depths.
        jump_mixed: share of the pixels at jumps that mix the depths of both sides.
        jump_lost: share of the pixels at jumps that are lost.
    """

    noise_floor: float = 0.0
    noise_growth: float = 0.0
    noise_from: float = 0.0
    noise_disparity: float = 0.0
    noise_grazing: float = 0.0
    baseline: float = 1.0
    disparity_step: float = 0.0
    grazing: tuple[float, float] | None = None
    jump: float = 0.02
    jump_mixed: float = 0.0
    jump_lost: float = 0.0

    def without(self, parts: Collection[str]) -> Sensor:
        """The sensor with some of `PARTS` switched off."""
        off: dict[str, Any] = {key: value for part in parts for key, value in PARTS[part].items()}
        return replace(self, **off)

    def noise(self, depth: FloatArray, incidence: FloatArray, focal_length: float) -> FloatArray:
        """Standard deviation, in metres, of depths in metres seen at angles of incidence.

        The focal length is in pixels.
        """
        beyond = np.maximum(depth - self.noise_from, 0.0)
        angle = np.minimum(incidence, STEEPEST_NOISE)
        steepness = (angle / (0.5 * math.pi - angle)) ** 2
        return (
            self.noise_floor
            + self.noise_growth * beyond**2
            + self.noise_disparity * depth**2 / (focal_length * self.baseline)
            + self.noise_grazing / np.sqrt(depth) * steepness
        )


PARTS: dict[str, dict[str, Any]] = {
    "noise": {
        "noise_floor": 0.0,
        "noise_growth": 0.0,
        "noise_disparity": 0.0,
        "noise_grazing": 0.0,
    },
    "quantisation": {"disparity_step": 0.0},
    "dropout": {"grazing": None, "jump_lost": 0.0},
    "flying": {"jump_mixed": 0.0},
}
"""Parts of a sensor, and what they are when switched off."""

PRESETS: dict[str, Sensor] = {
    "ideal": Sensor(),
    # The first Kinect, Xtion. Noise: Nguyen, Izadi and Lovell, "Modeling Kinect sensor noise for
    # improved 3D reconstruction and tracking", 3DIMPVT 2012, equations 2 and 3, whose last term
    # holds from 60 degrees and is small before; they find no depth beyond some 70 to 80 degrees.
    # Steps of 1/8 pixel at a baseline of 75 mm: Khoshelham and Elberink, "Accuracy and resolution
    # of Kinect depth data", Sensors 12, 2012. Shares of pixels at jumps: chosen so that outlines
    # are as frayed as in such cameras' images; no source is known.
    "structured-light": Sensor(
        noise_floor=0.0012,
        noise_growth=0.0019,
        noise_from=0.4,
        noise_grazing=0.0001,
        baseline=0.075,
        disparity_step=1.0 / 8.0,
        grazing=(math.radians(70.0), math.radians(85.0)),
        jump_mixed=0.3,
        jump_lost=0.3,
    ),
    # RealSense D435, whose eyes are 50 mm apart. The disparity's error of 0.08 pixels is from
    # Intel's "Tuning depth cameras for best performance"; the depth's is z^2 / (f b) of it. Steps
    # of 1/32 pixel: Intel's "Subpixel linearity improvement". Angles and shares of pixels as
    # above, with more mixing: stereo matches whole windows.
    "active-stereo": Sensor(
        noise_disparity=0.08,
        baseline=0.050,
        disparity_step=1.0 / 32.0,
        grazing=(math.radians(75.0), math.radians(88.0)),
        jump_mixed=0.5,
        jump_lost=0.2,
    ),
}
"""Sensors by name."""


@dataclass(frozen=True)
class Reading:
    """A sensor's image, its arrays of shape (height, width).

    Attributes:
        depth: z in the camera's frame, in the suite's unit; infinite where there is none.
        is_mixed: whether the depth lies between those of both sides of a jump.
    """

    depth: FloatArray
    is_mixed: BoolArray


def read(
    sensor: Sensor, view: View, focal_length: float, metres_per_unit: float, rng: Generator
) -> Reading:
    """The reading of a view; the same numbers are drawn whatever is switched off.

    Args:
        sensor: reads.
        view: what there is to be read.
        focal_length: of the camera, in pixels along the baseline.
        metres_per_unit: what the sensor takes a length of 1 for.
        rng: draws noise and losses.
    """
    chance, share, keep = rng.random((3, *view.depth.shape))
    noise = rng.normal(size=view.depth.shape)

    seen = np.isfinite(view.depth)
    depth = np.where(seen, view.depth * metres_per_unit, math.inf)
    step = greatest_step(depth)
    is_jump = seen & (np.abs(step) > sensor.jump * depth)
    is_mixed = is_jump & np.isfinite(step) & (chance < sensor.jump_mixed)
    is_lost = is_jump & (chance >= 1.0 - sensor.jump_lost)
    is_lost |= _is_grazing(view.incidence, sensor.grazing, keep)

    depth = depth + np.where(is_mixed, share * np.where(is_mixed, step, 0.0), 0.0)
    finite = np.where(seen, depth, 1.0)
    finite = finite + sensor.noise(finite, view.incidence, focal_length) * noise
    finite = _rounded(finite, sensor, focal_length)
    depth = np.where(seen & ~is_lost & (finite > 0.0), finite / metres_per_unit, math.inf)
    return Reading(depth=depth, is_mixed=is_mixed)


def greatest_step(depth: FloatArray) -> FloatArray:
    """From each pixel to that of its four neighbours whose depth differs most: the difference.

    Depths are of shape (height, width); it is 0 where pixel and neighbours see nothing.
    """
    padded = np.pad(depth, 1, mode="edge")
    neighbours = [padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]]
    with np.errstate(invalid="ignore"):
        steps = np.nan_to_num(
            np.stack(neighbours) - depth, nan=0.0, posinf=math.inf, neginf=-math.inf
        )
    most = np.abs(steps).argmax(axis=0)
    greatest: FloatArray = np.take_along_axis(steps, most[None], axis=0)[0]
    return greatest


def _is_grazing(
    incidence: FloatArray,
    grazing: tuple[float, float] | None,
    keep: FloatArray,
) -> BoolArray:
    """Whether pixels are lost, for `keep` uniform in 0..1: more and more between two angles."""
    if grazing is None:
        return np.zeros(incidence.shape, dtype=bool)
    first, last = grazing
    return keep < (incidence - first) / (last - first)


def _rounded(depth: FloatArray, sensor: Sensor, focal_length: float) -> FloatArray:
    """Depths in metres whose disparities are whole steps, one at least."""
    if sensor.disparity_step == 0.0:
        return depth
    step_depth = focal_length * sensor.baseline / sensor.disparity_step
    positive = np.where(depth > 0.0, depth, math.inf)
    rounded: FloatArray = step_depth / np.maximum(np.rint(step_depth / positive), 1.0)
    return rounded
