"""A suite evaluated, and what came of it."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from .._core import Superellipsoid, _evaluate_suite, read
from . import report, table

Row = dict[str, Any]


def evaluate(
    suite_dir: str | os.PathLike[str],
    results_dir: str | os.PathLike[str],
    *,
    seed: int = 0,
    distance: Literal["radial", "geometric"] = "geometric",
    precision: Literal["double", "single"] = "double",
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Evaluation:
    """Fit and score all scenes of a suite that are not yet among the results.

    It is what `superquadric batch` does, and the results are the same. What a scene's own files
    or fit do wrong becomes its row. Ctrl-C ends it; the same call then goes on from there.

    Args:
        suite_dir: folder with `suite.json` and `scenes/NAME/`.
        results_dir: folder to write `scenes.csv`, `summary.json` and `scenes/NAME.json` into: a
            new one, or one with results of the same suite and options.
        seed: chooses the points that the first, coarse fits look at.
        distance: `radial` or `geometric`, that whose squares are minimised.
        precision: `double` or `single`, that of the rows of the points.
        threads: scenes fitted at a time; by default as many as the machine offers.
        progress: is told how many scenes are done, of how many, from any thread and not
            necessarily in order.

    Raises:
        BatchError: if the suite cannot be understood, or the results are of another suite, of
            other options or of another version.
        OSError: if a file cannot be read or written.
        ValueError: if there is no such distance or precision.
    """
    suite, results = Path(suite_dir), Path(results_dir)
    _evaluate_suite(
        suite,
        results,
        seed=seed,
        distance=distance,
        precision=precision,
        threads=threads,
        on_scene=progress,
    )
    return _gather(suite, results)


@dataclass(frozen=True)
class Evaluation:
    """What came of a suite.

    Attributes:
        suite_dir: folder of the suite.
        results_dir: folder of the results.
        rows: one for each scene, with the columns of `scenes.csv`; what a failed scene has not
            is None. Lengths are in the cloud's unit, `surface_distance` and `size_error` are
            relative, `rotation_error` is in radians.
        models: the recovered model of each scene that was fitted, by the scene's name.
        summary: content of `summary.json`: the suite's name and, by level, counts, shares and
            quartiles.
    """

    suite_dir: Path
    results_dir: Path
    rows: list[Row]
    models: dict[str, Superellipsoid]
    summary: dict[str, Any]

    @property
    def table(self) -> Any:
        """The rows as a pandas DataFrame.

        Raises:
            MissingExtraError: without pandas.
        """
        return table.frame(self.rows)

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """Write the rows as a Parquet file.

        Raises:
            MissingExtraError: without pandas or pyarrow.
            OSError: if the file cannot be written.
        """
        table.write_parquet(self.rows, path)

    def write_report(self, path: str | os.PathLike[str]) -> None:
        """Write one HTML file with tables and pictures, which needs nothing else to be shown.

        Raises:
            MissingExtraError: without matplotlib.
            OSError: if the file cannot be written, or a scene cannot be read.
        """
        Path(path).write_text(report.html(self), encoding="utf-8")

    def worst(self, count: int) -> list[Row]:
        """The fitted scenes of least overlap, the worst first."""
        fitted = [row for row in self.rows if row["status"] == "fitted"]
        return sorted(fitted, key=lambda row: (row["iou"], row["scene"]))[:count]

    def truth(self, scene: str) -> Superellipsoid:
        """The true model of a scene."""
        return Superellipsoid.load(self._scene_dir(scene) / "truth.json")

    def points(self, scene: str) -> NDArray[np.float64]:
        """The cloud of a scene, of shape (n, 3)."""
        return read(self._scene_dir(scene) / "cloud.ply")

    def _scene_dir(self, scene: str) -> Path:
        return self.suite_dir / "scenes" / scene


def _gather(suite: Path, results: Path) -> Evaluation:
    with (results / "scenes.csv").open(encoding="utf-8", newline="") as lines:
        reader = csv.DictReader(lines)
        columns = list(reader.fieldnames or [])
        records = [_load(results / "scenes" / f"{line['scene']}.json") for line in reader]
    return Evaluation(
        suite_dir=suite,
        results_dir=results,
        rows=[{column: record.get(column) for column in columns} for record in records],
        models={
            record["scene"]: Superellipsoid.from_dict(record["model"])
            for record in records
            if "model" in record
        },
        summary=_load(results / "summary.json"),
    )


def _load(path: Path) -> dict[str, Any]:
    document: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return document
