"""Depth maps of models in the world."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from .._core import Superellipsoid
from .arrays import BoolArray, FloatArray
from .camera import Camera
from .cloud import Cloud
from .errors import SynthError
from .pose import moved, moved_model
from .render import render
from .sensor import Sensor, read
from .suite import Standing, Suite, Viewpoint
from .view import View
from .viewpoint import draw_camera_from_world

LEAST_PIXELS = 200
"""Fewest pixels of the object, before the sensor loses any; other viewpoints are tried."""
VIEWPOINTS = 20
"""Viewpoints tried before giving up."""
LEAST_POINTS = 20
"""Fewest measured points of a cloud: some more than a model's eleven parameters."""


@dataclass(frozen=True)
class DepthImage:
    """A depth map.

    Attributes:
        counts: depths, of shape (height, width), 0 where there is none.
        mask: of shape (height, width), true where an ideal camera sees the object.
        camera_from_world: of shape (4, 4).
    """

    counts: NDArray[np.uint16]
    mask: BoolArray
    camera_from_world: FloatArray


def photograph(
    suite: Suite,
    sensor: Sensor,
    model_world: Superellipsoid,
    viewpoint_rng: Generator,
    sensor_rng: Generator,
) -> tuple[DepthImage, Cloud]:
    """A depth map, and the points of the object's pixels in the camera's frame.

    Raises:
        SynthError: if the suite has no camera, or too little of the object is seen.
    """
    if suite.camera is None or suite.viewpoint is None:
        raise SynthError("there is no camera")
    camera = suite.camera
    view, camera_from_world = _good_view(suite, camera, suite.viewpoint, model_world, viewpoint_rng)
    reading = read(sensor, view, camera.fx, suite.metres_per_unit, sensor_rng)
    image = DepthImage(camera.counts(reading.depth), view.is_object, camera_from_world)
    is_kept = (image.counts > 0) & image.mask
    points_camera = (camera.rays() * camera.depth(image.counts)[..., None])[is_kept]
    cloud_camera = Cloud(points_camera, ~reading.is_mixed[is_kept])
    if isinstance(suite.placement, Standing):
        cloud_camera = _above_table(cloud_camera, suite.placement, camera_from_world)
    if len(cloud_camera.points) < LEAST_POINTS:
        raise SynthError(f"the sensor sees no more than {len(cloud_camera.points)} points")
    return image, cloud_camera


def _above_table(cloud_camera: Cloud, table: Standing, camera_from_world: FloatArray) -> Cloud:
    """The points that are not taken for the table's."""
    normal, offset = table_plane(camera_from_world)
    is_above = cloud_camera.points @ normal + offset >= table.cut
    return Cloud(cloud_camera.points[is_above], cloud_camera.is_inlier[is_above])


def _good_view(
    suite: Suite,
    camera: Camera,
    viewpoint: Viewpoint,
    model_world: Superellipsoid,
    rng: Generator,
) -> tuple[View, FloatArray]:
    """The first view that shows all of the object in pixels enough, and `camera_from_world`."""
    for view, camera_from_world in _views(suite, camera, viewpoint, model_world, rng):
        if _is_within(view.is_object) and view.is_object.sum() >= LEAST_PIXELS:
            return view, camera_from_world
    raise SynthError(
        f"none of {VIEWPOINTS} viewpoints shows the whole object in {LEAST_PIXELS} pixels"
    )


def _views(
    suite: Suite,
    camera: Camera,
    viewpoint: Viewpoint,
    model_world: Superellipsoid,
    rng: Generator,
) -> Iterator[tuple[View, FloatArray]]:
    for _ in range(VIEWPOINTS):
        camera_from_world = draw_camera_from_world(
            model_world, suite.placement, viewpoint, camera, rng
        )
        model_camera = moved_model(camera_from_world, model_world)
        backdrop, table = math.inf, None
        if viewpoint.backdrop is not None:
            backdrop = rng.uniform(*viewpoint.backdrop) * model_camera.translation[2]
        if isinstance(suite.placement, Standing):
            table = moved(camera_from_world, table_corners(suite.placement))
        yield render(model_camera, camera, table_camera=table, backdrop=backdrop), camera_from_world


def table_corners(placement: Standing) -> FloatArray:
    """Corners of a table's top, of shape (4, 3), in the world's frame."""
    corners = np.array([[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [0.5, 0.5, 0.0], [-0.5, 0.5, 0.0]])
    return corners * [*placement.table, 1.0]


def _is_within(mask: BoolArray) -> bool:
    """Whether no pixel at the image's border is set."""
    return not (mask[[0, -1]].any() or mask[:, [0, -1]].any())


def table_plane(frame_from_world: FloatArray) -> tuple[FloatArray, float]:
    """Unit normal n, upwards, and offset d of the table's plane `n.x + d = 0` in a frame."""
    normal = frame_from_world[:3, 2]
    return normal, float(-normal @ frame_from_world[:3, 3])
