"""One scene of a suite: a model, what a sensor made of it, and the truth about both."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.random import PCG64, Generator, SeedSequence
from numpy.typing import NDArray

from .._core import Superellipsoid
from .arrays import BoolArray, FloatArray
from .camera import Camera
from .cloud import Cloud, sampled, split, thinned, with_strays
from .errors import SynthError
from .pose import inverse, moved, moved_model
from .render import render
from .sensor import read
from .shapes import draw_model
from .suite import DepthMap, Level, Standing, Suite, Viewpoint, Whole
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


@dataclass(frozen=True)
class Scene:
    """What is written of a scene.

    Attributes:
        name: of its folder.
        level: name of its level.
        family: name of its family.
        cloud: in the suite's frame.
        image: None for whole surfaces.
        truth: the document.
    """

    name: str
    level: str
    family: str
    cloud: Cloud
    image: DepthImage | None
    truth: dict[str, Any]


class _Streams(NamedTuple):
    """Random numbers of a scene's parts: what one part draws does not change the others."""

    points: Generator
    model: Generator
    viewpoint: Generator
    measurement: Generator
    strays: Generator


def _streams(seed: int, index: int) -> _Streams:
    parts = SeedSequence([seed, index]).spawn(len(_Streams._fields))
    return _Streams(*(Generator(PCG64(part)) for part in parts))


def make_scene(suite: Suite, level: Level, index: int) -> Scene:
    """Scene `index` of a level; it depends on nothing but the arguments.

    Raises:
        SynthError: if no viewpoint shows enough of the object.
    """
    streams = _streams(suite.seed, index)
    family = suite.families[index % len(suite.families)]
    model_world = draw_model(family, suite.placement, streams.model)
    name = f"{level.name}-{index:04d}"
    if isinstance(level.source, Whole):
        image, model, noise = None, model_world, _isotropic(level.source, model_world)
        measured, strays = split(_count(level, streams.points), level.strays, level.points[1])
        cloud = sampled(model, measured, noise["sigma"], streams.measurement)
    else:
        image, pixels = _photograph(suite, level.source, model_world, streams, name)
        frame_from_world = image.camera_from_world if suite.frame == "camera" else np.eye(4)
        model, noise = moved_model(frame_from_world, model_world), _of_sensor(level.source)
        available = len(pixels.points)
        measured, strays = split(_count(level, streams.points), level.strays, available)
        cloud = thinned(pixels, measured, streams.measurement)
    cloud = with_strays(cloud, model, suite.stray_box, strays, streams.strays)
    truth = {
        "suite": suite.name,
        "scene": name,
        "level": level.name,
        "family": family.name,
        "unit": suite.unit,
        "frame": suite.frame,
        "model": model.to_dict(),
        "points": len(cloud.points),
        "inliers": int(cloud.is_inlier.sum()),
        "noise": noise,
        "stray_share": level.strays,
        **_surroundings(suite, image),
    }
    return Scene(name, level.name, family.name, cloud, image, truth)


def _count(level: Level, rng: Generator) -> int:
    least, greatest = level.points
    return int(rng.integers(least, greatest, endpoint=True))


def _isotropic(source: Whole, model: Superellipsoid) -> dict[str, Any]:
    return {
        "kind": "isotropic",
        "mean_semi_axes": source.noise,
        "sigma": source.noise * model.mean_semi_axis,
    }


def _of_sensor(source: DepthMap) -> dict[str, Any]:
    return {"kind": "sensor", "preset": source.preset, "sensor": asdict(source.sensor)}


def _surroundings(suite: Suite, image: DepthImage | None) -> dict[str, Any]:
    """The keys about the camera and the table, where there are any."""
    found: dict[str, Any] = {}
    frame_from_world = np.eye(4)
    if image is not None:
        found["camera_from_world"] = image.camera_from_world.tolist()
        if suite.frame == "camera":
            frame_from_world = image.camera_from_world
    if isinstance(suite.placement, Standing):
        normal, offset = table_plane(frame_from_world)
        found["support_plane"] = {"normal": normal.tolist(), "offset": offset}
    return found


def table_plane(frame_from_world: FloatArray) -> tuple[FloatArray, float]:
    """Unit normal n, upwards, and offset d of the table's plane `n.x + d = 0` in a frame."""
    normal = frame_from_world[:3, 2]
    return normal, float(-normal @ frame_from_world[:3, 3])


def _photograph(
    suite: Suite, source: DepthMap, model_world: Superellipsoid, streams: _Streams, name: str
) -> tuple[DepthImage, Cloud]:
    """A depth map, and the points of the object's pixels in the suite's frame."""
    if suite.camera is None or suite.viewpoint is None:
        raise SynthError(f"{name}: there is no camera")
    camera = suite.camera
    view, camera_from_world = _good_view(
        suite, camera, suite.viewpoint, model_world, streams.viewpoint, name
    )
    reading = read(source.sensor, view, camera.fx, suite.metres_per_unit, streams.measurement)
    image = DepthImage(camera.counts(reading.depth), view.is_object, camera_from_world)
    is_kept = (image.counts > 0) & image.mask
    points_camera = back_projected(camera, image.counts)[is_kept]
    is_inlier = ~reading.is_mixed[is_kept]
    if isinstance(suite.placement, Standing):
        normal, offset = table_plane(camera_from_world)
        is_above = points_camera @ normal + offset >= suite.placement.cut
        points_camera, is_inlier = points_camera[is_above], is_inlier[is_above]
    if len(points_camera) < LEAST_POINTS:
        raise SynthError(f"{name}: the sensor sees no more than {len(points_camera)} points")
    if suite.frame == "world":
        points_camera = moved(inverse(camera_from_world), points_camera)
    return image, Cloud(points_camera, is_inlier)


def back_projected(camera: Camera, counts: NDArray[np.uint16]) -> FloatArray:
    """Points of the pixels, of shape (height, width, 3), in the camera's frame."""
    return camera.rays() * camera.depth(counts)[..., None]


def _good_view(
    suite: Suite,
    camera: Camera,
    viewpoint: Viewpoint,
    model_world: Superellipsoid,
    rng: Generator,
    name: str,
) -> tuple[View, FloatArray]:
    """The first view that shows all of the object in pixels enough, and `camera_from_world`."""
    for view, camera_from_world in _views(suite, camera, viewpoint, model_world, rng):
        if _is_within(view.is_object) and view.is_object.sum() >= LEAST_PIXELS:
            return view, camera_from_world
    raise SynthError(
        f"{name}: none of {VIEWPOINTS} viewpoints shows the whole object in {LEAST_PIXELS} pixels"
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
