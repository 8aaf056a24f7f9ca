"""Rows of scenes as a data frame, and levels for a person."""

from __future__ import annotations

import os
from typing import Any

from .extras import require

COUNTS = ["points", "points_skipped", "evaluations", "starts"]
HEADER = [
    "level",
    "scenes",
    "success, %",
    "median IoU",
    "lower quartile",
    "surface distance, %",
    "trusted, %",
    "wrongly trusted",
    "ms",
]
"""Columns of `cells`: success is an IoU of at least 0.9; surface distance and ms are medians."""


def frame(rows: list[dict[str, Any]]) -> Any:
    """A pandas DataFrame; what a failed scene has not is missing.

    Raises:
        MissingExtraError: without pandas.
    """
    pandas = require("pandas")
    # Whole numbers and truth values stay so where some are missing.
    types = dict.fromkeys(COUNTS, "Int64") | {"trusted": "boolean"}
    numbers = [name for row in rows for name, value in row.items() if isinstance(value, float)]
    return pandas.DataFrame(rows).astype(types | dict.fromkeys(numbers, "float64"))


def write_parquet(rows: list[dict[str, Any]], path: str | os.PathLike[str]) -> None:
    """Write the data frame as a Parquet file.

    Raises:
        MissingExtraError: without pandas or pyarrow.
        OSError: if the file cannot be written.
    """
    require("pyarrow")
    frame(rows).to_parquet(path, index=False)


def cells(summary: dict[str, Any]) -> list[list[str]]:
    """A row of text for each level, in the columns of `HEADER`."""
    return [_cells(level) for level in summary["levels"]]


def markdown(header: list[str], rows: list[list[str]]) -> str:
    """A Markdown table with aligned columns."""
    lines = [header, *rows]
    widths = [max(len(line[column]) for line in lines) for column in range(len(header))]
    rule = ["-" * width for width in widths]
    padded = [
        [cell.ljust(width) for cell, width in zip(line, widths, strict=True)]
        for line in [header, rule, *rows]
    ]
    return "".join(f"| {' | '.join(line)} |\n" for line in padded)


def _cells(level: dict[str, Any]) -> list[str]:
    wrongly = level["wrongly_trusted"]
    return [
        level["level"],
        str(level["scenes"]),
        _number(level["success"], 0, 100),
        _quantile(level["iou"], 2, 3),
        _quantile(level["iou"], 1, 3),
        _quantile(level["surface_distance"], 2, 2, 100),
        _number(level["trusted"], 0, 100),
        "-" if wrongly is None else str(wrongly),
        _quantile(level["seconds"], 2, 1, 1000),
    ]


def _quantile(quantiles: list[float] | None, which: int, digits: int, scale: float = 1) -> str:
    return _number(None if quantiles is None else quantiles[which], digits, scale)


def _number(value: float | None, digits: int, scale: float) -> str:
    return "-" if value is None else f"{scale * value:.{digits}f}"
