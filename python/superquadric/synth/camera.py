"""A pinhole camera: x to the right, y down, z forward, as in OpenCV."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arrays import FloatArray

GREATEST_COUNT = 65_535
"""Greatest value of a pixel of 16 bits; 0 stands for no depth."""


@dataclass(frozen=True)
class Camera:
    """Intrinsics of a pinhole; the centre of the pixel in column i, row j is (i, j).

    Attributes:
        fx: focal length along rows, in pixels.
        fy: focal length along columns, in pixels.
        cx: column of the principal point.
        cy: row of the principal point.
        width: number of columns.
        height: number of rows.
        depth_unit: length of one count of a depth map, in the suite's unit.
    """

    fx: float
    fy: float
    cx: float
    cy: float
    width: int
    height: int
    depth_unit: float

    def rays(self) -> FloatArray:
        """Directions of the pixels' rays, of shape (height, width, 3), z being 1.

        Along these a ray's parameter is the depth. open3d's own `create_rays_pinhole` has the
        centre of the first pixel at (0.5, 0.5).
        """
        u, v = np.meshgrid(np.arange(self.width), np.arange(self.height))
        x, y = (u - self.cx) / self.fx, (v - self.cy) / self.fy
        return np.stack([x, y, np.ones_like(x)], axis=-1)

    def project(self, points_camera: FloatArray) -> FloatArray:
        """Columns and rows, of shape (n, 2), of points of shape (n, 3) in front of the camera."""
        x, y, z = points_camera.T
        return np.stack([self.cx + self.fx * x / z, self.cy + self.fy * y / z], axis=-1)

    def counts(self, depth: FloatArray) -> NDArray[np.uint16]:
        """Depths, of shape (height, width), as counts; 0 where there is none or it is too far."""
        counts = np.rint(np.where(np.isfinite(depth), depth, 0.0) / self.depth_unit)
        return np.where(counts > GREATEST_COUNT, 0, counts).astype(np.uint16)

    def depth(self, counts: NDArray[np.uint16]) -> FloatArray:
        """Depths of counts, of shape (height, width); 0 where there is none."""
        return counts.astype(np.float64) * self.depth_unit

    def to_dict(self, unit: str) -> dict[str, Any]:
        """The camera as it is written, with the unit of lengths."""
        document = {
            "fx": self.fx,
            "fy": self.fy,
            "cx": self.cx,
            "cy": self.cy,
            "width": self.width,
            "height": self.height,
            "unit": unit,
            "depth_units": self.depth_unit,
        }
        return document | ({"depth_units_m": self.depth_unit} if unit == "m" else {})
