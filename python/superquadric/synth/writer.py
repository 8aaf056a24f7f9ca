"""Files of a scene."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .cloud import Cloud
from .errors import SynthError
from .extras import require
from .scene import Scene
from .suite import Suite

PLY_ROW = np.dtype([("xyz", "<f8", (3,)), ("inlier", "u1")])


def write_scene(suite: Suite, scene: Scene, folder: Path) -> None:
    """Writes the files of a scene into a new folder."""
    folder.mkdir()
    comments = [f"scene {suite.name}/{scene.name}", f"frame {suite.frame}", f"unit {suite.unit}"]
    write_ply(folder / "cloud.ply", scene.cloud, comments)
    write_json(folder / "truth.json", scene.truth)
    if scene.image is not None and suite.camera is not None:
        write_png(folder / "depth.png", scene.image.counts)
        write_png(folder / "mask.png", scene.image.mask.astype(np.uint8) * 255)
        write_json(folder / "camera.json", suite.camera.to_dict(suite.unit))


def write_ply(path: Path, cloud: Cloud, comments: list[str]) -> None:
    """A binary little-endian PLY of `double x y z` and `uchar inlier`."""
    rows = np.empty(len(cloud.points), dtype=PLY_ROW)
    rows["xyz"], rows["inlier"] = cloud.points, cloud.is_inlier
    header = [
        "ply",
        "format binary_little_endian 1.0",
        *(f"comment {comment}" for comment in comments),
        f"element vertex {len(rows)}",
        *(f"property double {axis}" for axis in "xyz"),
        "property uchar inlier",
        "end_header",
        "",
    ]
    path.write_bytes("\n".join(header).encode("ascii") + rows.tobytes())


def write_json(path: Path, document: dict[str, Any]) -> None:
    """A JSON file of numbers that come back as they were."""
    text = json.dumps(document, indent=2, allow_nan=False, ensure_ascii=False)
    path.write_bytes(f"{text}\n".encode())


def write_png(path: Path, image: NDArray[np.uint8] | NDArray[np.uint16]) -> None:
    """A PNG of one channel with 8 or 16 bits, as the array has.

    Raises:
        SynthError: if it cannot be written.
    """
    open3d = require("open3d")
    if not open3d.io.write_image(str(path), open3d.geometry.Image(np.ascontiguousarray(image))):
        raise SynthError(f"{path}: cannot be written")
