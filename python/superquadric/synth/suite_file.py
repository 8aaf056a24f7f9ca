"""Suite files, read and checked."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Literal

from .camera import Camera
from .errors import SuiteError
from .extras import require
from .section import Section
from .sensor import PARTS, PRESETS
from .suite import DepthMap, Family, Floating, Level, Standing, Suite, Viewpoint, Whole

LEAST_EXTENT = 1e-9
"""Least length that a file may give, in the suite's unit: above 0, and nothing to aim at."""
LEAST_EXPONENT = 0.01
GREATEST_EXPONENT = 2.0
EQUAL = {"none": 1, "xy": 2, "xyz": 3}
"""Semi-axes that a family may hold equal, and how many they are."""
ANY_POINTS = 10_000_000
"""Most points of a cloud, below which a file with a slip of the pen still fits in memory."""


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
