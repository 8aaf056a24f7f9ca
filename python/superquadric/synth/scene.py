"""One scene of a suite: a model, what a sensor made of it, and the truth about both."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.random import PCG64, Generator, SeedSequence

from .._core import Superellipsoid
from .cloud import Cloud, sampled, split, thinned, with_strays
from .errors import SynthError
from .photograph import DepthImage, photograph, table_plane
from .pose import inverse, moved, moved_model
from .shapes import draw_model
from .suite import DepthMap, Level, Standing, Suite, Whole


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
    name = f"{level.name}-{index:04d}"
    model_world = draw_model(family, suite.placement, streams.model)
    count = _count(level, streams.points)
    try:
        made = _made(suite, level, model_world, count, streams)
    except SynthError as error:
        raise SynthError(f"{suite.name}, scene {name}: {error}") from error
    truth = {
        "suite": suite.name,
        "scene": name,
        "level": level.name,
        "family": family.name,
        "unit": suite.unit,
        "frame": suite.frame,
        "model": made.model.to_dict(),
        "points": len(made.cloud.points),
        "inliers": int(made.cloud.is_inlier.sum()),
        "noise": _noise(level.source, model_world),
        "stray_share": level.strays,
        **_surroundings(suite, made.image),
    }
    return Scene(name, level.name, family.name, made.cloud, made.image, truth)


class _Made(NamedTuple):
    """A model and its cloud in the suite's frame, with the depth map that the cloud is of."""

    model: Superellipsoid
    cloud: Cloud
    image: DepthImage | None


def _made(
    suite: Suite, level: Level, model_world: Superellipsoid, count: int, streams: _Streams
) -> _Made:
    image, model = None, model_world
    if isinstance(level.source, Whole):
        measured, strays = split(count, level.strays, count)
        deviation = level.source.noise * model.mean_semi_axis
        cloud = sampled(model, measured, deviation, streams.measurement)
    else:
        image, cloud = photograph(
            suite, level.source.sensor, model_world, streams.viewpoint, streams.measurement
        )
        measured, strays = split(count, level.strays, len(cloud.points))
        cloud = thinned(cloud, measured, streams.measurement)
        if suite.frame == "camera":
            model = moved_model(image.camera_from_world, model_world)
        else:
            world_from_camera = inverse(image.camera_from_world)
            cloud = Cloud(moved(world_from_camera, cloud.points), cloud.is_inlier)
    return _Made(model, with_strays(cloud, model, suite.stray_box, strays, streams.strays), image)


def _count(level: Level, rng: Generator) -> int:
    least, greatest = level.points
    return int(rng.integers(least, greatest, endpoint=True))


def _noise(source: Whole | DepthMap, model: Superellipsoid) -> dict[str, Any]:
    if isinstance(source, DepthMap):
        return {"kind": "sensor", "preset": source.preset, "sensor": asdict(source.sensor)}
    sigma = source.noise * model.mean_semi_axis
    return {"kind": "isotropic", "mean_semi_axes": source.noise, "sigma": sigma}


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
