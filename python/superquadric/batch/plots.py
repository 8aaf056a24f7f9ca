"""Pictures of an evaluation, drawn without a display."""

from __future__ import annotations

import io
import os
from typing import TYPE_CHECKING, Any

import numpy as np

from .extras import require

if TYPE_CHECKING:
    from .evaluation import Evaluation

SUCCESS_IOU = 0.9
BINS = 24
LEAST_ERROR = 1e-4
ERRORS = [
    ("iou", "volume overlap (IoU)", 1.0),
    ("surface_distance", "surface distance, of the mean semi-axis", 1.0),
    ("size_error", "greatest relative error of a semi-axis", 1.0),
    ("rotation_error", "rotation error, degrees", 180 / np.pi),
]


def success(evaluation: Evaluation, path: str | os.PathLike[str] | None = None) -> Any:
    """Shares of the scenes recovered, trusted and wrongly trusted, against the level.

    Args:
        evaluation: what to draw.
        path: PNG file to write, if any.

    Returns:
        The matplotlib figure.

    Raises:
        MissingExtraError: without matplotlib.
    """
    levels = [level for level in evaluation.summary["levels"] if level["scenes"]]
    figure = figure_of(1.6 + 1.5 * len(levels), 3.4)
    axes = figure.add_subplot()
    bars = [
        (f"recovered (IoU >= {SUCCESS_IOU})", "C2", [level["success"] for level in levels]),
        ("trusted", "C0", [level["trusted"] for level in levels]),
        ("trusted, not recovered", "C3", [_wrongly(level) for level in levels]),
    ]
    places = np.arange(len(levels))
    for offset, (label, colour, shares) in zip([-0.27, 0.0, 0.27], bars, strict=True):
        axes.bar(places + offset, 100 * np.array(shares), 0.25, label=label, color=colour)
    axes.set_xticks(places, [_plain(level["level"]) for level in levels])
    axes.set(ylim=(0, 100), ylabel="scenes, %")
    figure.legend(loc="outside upper center", ncols=3, fontsize="small", frameon=False)
    return saved(figure, path)


def histograms(evaluation: Evaluation, path: str | os.PathLike[str] | None = None) -> Any:
    """How the overlap and the errors of the fitted scenes are distributed, by level.

    Args:
        evaluation: what to draw.
        path: PNG file to write, if any.

    Returns:
        The matplotlib figure.

    Raises:
        MissingExtraError: without matplotlib.
    """
    figure = figure_of(9.0, 6.0)
    panels = figure.subplots(2, 2).flat
    for axes, (column, label, unit) in zip(panels, ERRORS, strict=True):
        _histogram(axes, evaluation, column, unit)
        axes.set(xlabel=label, ylabel="scenes")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=4, fontsize="small")
    return saved(figure, path)


def figure_of(width: float, height: float) -> Any:
    """An empty matplotlib figure, sizes in inches."""
    # Without pyplot there is neither a window nor a list of open figures.
    return require("matplotlib.figure").Figure((width, height), dpi=100, layout="constrained")


def saved(figure: Any, path: str | os.PathLike[str] | None) -> Any:
    """The figure itself, laid out for good, and written to a PNG file if there is a path."""
    figure.draw_without_rendering()
    # Laid out anew at every drawing, it would never look quite the same.
    figure.set_layout_engine("none")
    if path is not None:
        _write(figure, path)
    return figure


def png(figure: Any) -> bytes:
    """The bytes of the figure's PNG file."""
    content = io.BytesIO()
    _write(figure, content)
    return content.getvalue()


def _write(figure: Any, target: str | os.PathLike[str] | io.BytesIO) -> None:
    figure.savefig(target, format="png", metadata={"Software": None})


def _plain(name: str) -> str:
    """A name that matplotlib shows as it is: not as a formula."""
    return name.replace("$", r"\$")


def _wrongly(level: dict[str, Any]) -> float:
    return float(level["wrongly_trusted"] / level["scenes"])


def _histogram(axes: Any, evaluation: Evaluation, column: str, unit: float) -> None:
    bins = np.linspace(0, 1, BINS + 1)
    if column != "iou":
        axes.set_xscale("log")
        greatest = max([unit * value for value in _values(evaluation, column)], default=1.0)
        bins = np.geomspace(LEAST_ERROR, max(greatest, 1.0), BINS + 1)
    for level in evaluation.summary["levels"]:
        values = unit * np.array(_values(evaluation, column, level["level"]))
        # What is below the least bin, such as an angle of zero, stands in it.
        values = np.maximum(values, bins[0])
        axes.hist(values, bins, histtype="step", linewidth=1.5, label=_plain(level["level"]))


def _values(evaluation: Evaluation, column: str, level: str | None = None) -> list[float]:
    return [
        row[column]
        for row in evaluation.rows
        if row["status"] == "fitted" and level in (None, row["level"])
    ]
