"""A suite: what its file says, checked."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from .camera import Camera
from .errors import SuiteError
from .extras import require
from .section import Range, Section
from .sensor import PARTS, PRESETS, Sensor

LEAST_EXTENT = 1e-9
"""Least length that a file may give, in the suite's unit: above 0, and nothing to aim at."""
LEAST_EXPONENT = 0.01
GREATEST_EXPONENT = 2.0
EQUAL = {"none": 1, "xy": 2, "xyz": 3}
"""Semi-axes that a family may hold equal, and how many they are."""
ANY_POINTS = 10_000_000
"""Most points of a cloud, below which a file with a slip of the pen still fits in memory."""


@dataclass(frozen=True)
class Family:
    """Shapes of one kind.

    Attributes:
        name: as it stands in truth files.
        size: ranges of the semi-axes a1, a2, a3, drawn log-uniformly, in the suite's unit.
        exponents: ranges of e1 and e2, drawn uniformly.
        equal: how many of the semi-axes, from the first, are drawn as one; the ranges of the
            others among them do not matter.
    """

    name: str
    size: tuple[Range, ...]
    exponents: tuple[Range, ...]
    equal: int


@dataclass(frozen=True)
class Floating:
    """Shapes anywhere near the origin, in any rotation.

    Attributes:
        offset: range of the centre's distance from the world's origin, in mean semi-axes.
    """

    offset: Range


@dataclass(frozen=True)
class Standing:
    """Shapes on a rectangular table, whose top is the world's plane z = 0.

    Attributes:
        table: lengths of the table's sides along the world's x and y, in the suite's unit.
        up: the axes of the model, out of `xyz`, that may point upwards.
        cut: height above the table up to which points are taken for the table's, in the suite's
            unit.
    """

    table: tuple[float, float]
    up: tuple[str, ...]
    cut: float


@dataclass(frozen=True)
class Viewpoint:
    """Where cameras may stand.

    Attributes:
        chosen_by: what decides how far away the camera is, `fill`: the share of the image's width
            or height, whichever is more, that the object takes up; or `distance`: that of the
            object's centre, in the suite's unit.
        reach: range of that quantity.
        elevation: range of the angle of the line to the camera above the plane z = 0, in
            radians; directions are uniform by area in it.
        backdrop: range of the depth of a wall across the view, in depths of the object's centre;
            None if there is none.
    """

    chosen_by: Literal["fill", "distance"]
    reach: Range
    elevation: Range
    backdrop: Range | None


@dataclass(frozen=True)
class Whole:
    """Points uniform by area on the whole surface.

    Attributes:
        noise: standard deviation of each coordinate, in mean semi-axes.
    """

    noise: float


@dataclass(frozen=True)
class DepthMap:
    """Points of a depth map.

    Attributes:
        preset: name of the sensor in the suite file.
        sensor: that sensor without the parts that are switched off.
    """

    preset: str
    sensor: Sensor


@dataclass(frozen=True)
class Level:
    """A degree of difficulty.

    Attributes:
        name: as it stands in the names of scenes.
        source: where points come from.
        strays: share of all points of the cloud that are uniform in a box about the object.
        points: range of the number of points of a cloud, strays included.
    """

    name: str
    source: Whole | DepthMap
    strays: float
    points: tuple[int, int]


@dataclass(frozen=True)
class Suite:
    """All that a suite file says.

    Attributes:
        name: of the suite.
        description: one line.
        unit: `m`, or `none` if lengths have no unit.
        metres_per_unit: what a sensor takes a length of 1 for.
        frame: of clouds and truths, `world` or `camera`.
        seed: of all that is drawn.
        scenes: number of scenes of each level.
        stray_box: sides of the box of strays, in sides of the object's bounding box along the
            axes of the frame.
        families: kinds of shapes, which the scenes of a level take in turn.
        placement: of shapes in the world.
        camera: pinhole of the depth maps; None if no level has any.
        viewpoint: of that camera.
        levels: degrees of difficulty; scenes of one number differ in nothing else.
    """

    name: str
    description: str
    unit: Literal["m", "none"]
    metres_per_unit: float
    frame: Literal["world", "camera"]
    seed: int
    scenes: int
    stray_box: float
    families: tuple[Family, ...]
    placement: Floating | Standing
    camera: Camera | None
    viewpoint: Viewpoint | None
    levels: tuple[Level, ...]


def read_suite(path: Path) -> Suite:
    """The suite in a TOML file.

    Raises:
        SuiteError: if it cannot be read, or its text is not that of a suite.
    """
    toml = require("tomllib" if sys.version_info >= (3, 11) else "tomli")
    try:
        data = toml.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, toml.TOMLDecodeError) as error:
        raise SuiteError(f"{path}: {error}") from error
    try:
        return _suite(Section(data, ""))
    except SuiteError as error:
        raise SuiteError(f"{path}: {error}") from error


def _suite(top: Section) -> Suite:
    unit: Literal["m", "none"] = "m" if top.choice("unit", ("m", "none")) == "m" else "none"
    is_world = top.choice("frame", ("world", "camera")) == "world"
    placement = _placement(top.section("placement"))
    has_camera = top.has("camera")
    camera = top.section("camera", {})
    suite = Suite(
        name=_file_name(top, "name"),
        description=top.text("description"),
        unit=unit,
        metres_per_unit=_metres_per_unit(top, unit),
        frame="world" if is_world else "camera",
        seed=top.whole("seed", 0),
        scenes=top.whole("scenes", 1),
        stray_box=top.number("stray_box", 1.0, default=2.0),
        families=tuple(_family(section) for section in top.sections("family")),
        placement=placement,
        camera=_camera(camera) if has_camera else None,
        viewpoint=_viewpoint(camera, placement) if has_camera else None,
        levels=tuple(_level(section) for section in top.sections("level")),
    )
    camera.finish()
    top.finish()
    _check_levels(suite)
    return suite


def _metres_per_unit(top: Section, unit: str) -> float:
    if unit == "m":
        return 1.0
    return top.number("metres_per_unit", LEAST_EXTENT, default=1.0)


def _check_levels(suite: Suite) -> None:
    names = [level.name for level in suite.levels]
    if len(set(names)) < len(names):
        raise SuiteError(f"level: names must differ, found {', '.join(names)}")
    for level in suite.levels:
        if isinstance(level.source, DepthMap) and suite.camera is None:
            raise SuiteError(f"level {level.name}: depth maps need a table [camera]")
        if isinstance(level.source, Whole) and suite.frame == "camera":
            raise SuiteError(f'level {level.name}: whole surfaces need frame = "world"')


def _family(section: Section) -> Family:
    family = Family(
        name=_file_name(section, "name"),
        size=section.spans("size", 3, LEAST_EXTENT, math.inf),
        exponents=section.spans("exponents", 2, LEAST_EXPONENT, GREATEST_EXPONENT),
        equal=EQUAL[section.choice("equal", tuple(EQUAL), "none")],
    )
    section.finish()
    return family


def _placement(section: Section) -> Floating | Standing:
    placement: Floating | Standing
    if section.choice("kind", ("floating", "standing")) == "floating":
        placement = Floating(offset=section.span("offset", 0.0))
    else:
        (length, _), (width, _) = section.spans("table", 2, LEAST_EXTENT, math.inf)
        up = tuple(sorted(section.choices("up", ("x", "y", "z"), ["z"])))
        if not up:
            section.fail("up", "must name one axis at least")
        placement = Standing(
            table=(length, width),
            up=up,
            cut=section.number("cut", 0.0, default=0.0),
        )
    section.finish()
    return placement


def _camera(section: Section) -> Camera:
    width, height = section.whole("width", 2), section.whole("height", 2)
    return Camera(
        fx=section.number("fx", LEAST_EXTENT),
        fy=section.number("fy", LEAST_EXTENT),
        cx=section.number("cx", 0.0, width - 1.0),
        cy=section.number("cy", 0.0, height - 1.0),
        width=width,
        height=height,
        depth_unit=section.number("depth_unit", LEAST_EXTENT),
    )


def _viewpoint(section: Section, placement: Floating | Standing) -> Viewpoint:
    if section.has("fill") == section.has("distance"):
        raise SuiteError("camera: needs either fill or distance")
    has_fill = section.has("fill")
    reach = section.span("fill", 0.01, 0.9) if has_fill else section.span("distance", LEAST_EXTENT)
    lowest = 0.0 if isinstance(placement, Standing) else -90.0
    elevation = section.span("elevation_deg", lowest, 90.0, (lowest, 90.0))
    return Viewpoint(
        chosen_by="fill" if has_fill else "distance",
        reach=reach,
        elevation=(math.radians(elevation[0]), math.radians(elevation[1])),
        backdrop=section.span("backdrop", 1.0) if section.has("backdrop") else None,
    )


def _level(section: Section) -> Level:
    if section.choice("source", ("whole", "depth-map")) == "whole":
        source: Whole | DepthMap = Whole(noise=section.number("noise", 0.0, 1.0, default=0.0))
    else:
        preset = section.choice("sensor", tuple(PRESETS))
        without = section.choices("without", tuple(PARTS), [])
        source = DepthMap(preset=preset, sensor=PRESETS[preset].without(without))
    level = Level(
        name=_file_name(section, "name"),
        source=source,
        strays=section.number("strays", 0.0, 0.95, default=0.0),
        points=section.whole_span("points", 1, ANY_POINTS),
    )
    section.finish()
    return level


def _file_name(section: Section, key: str) -> str:
    """A text that can stand in the name of a folder on any system."""
    value = section.text(key)
    if not all(c.isascii() and (c.isalnum() or c in "-_.") for c in value) or value[0] in "-.":
        section.fail(key, f"must be of letters, digits, '-', '_' and '.', found {value!r}")
    return value
