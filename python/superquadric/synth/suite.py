"""What a suite is made of."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from .camera import Camera
from .section import Range
from .sensor import Sensor


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
