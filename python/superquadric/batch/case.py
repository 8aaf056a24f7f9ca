"""A picture of one scene: its points by their distance from the fit, the fit beside the truth."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .._core import Superellipsoid
from .plots import figure_of

if TYPE_CHECKING:
    from .evaluation import Evaluation

Array = NDArray[np.float64]

MOST_POINTS = 1500
COLOURED = 0.98
"""Share of the residuals that the scale of colours covers."""
LINES = 17
STEPS = 65
MARGIN = 0.35
"""Room about the true solid's bounding box, in its longest side; what is beyond is left out."""
ASIDE = (20.0, 35.0)
"""Elevation and azimuth, in degrees, from which to look, beside the side that was seen."""


def case(evaluation: Evaluation, scene: str) -> Any:
    """The scene's points coloured by |residual|, and the recovered and the true wireframe.

    Args:
        evaluation: what the scene is of.
        scene: name of a scene that was fitted.

    Returns:
        The matplotlib figure.

    Raises:
        MissingExtraError: without matplotlib.
        KeyError: if there is no model of that scene.
        OSError: if the scene cannot be read.
    """
    found, truth = evaluation.models[scene], evaluation.truth(scene)
    points = evaluation.points(scene)
    points = points[:: 1 + len(points) // MOST_POINTS]
    box, view = _box(truth), _view(points, truth)

    figure = figure_of(9.0, 4.2)
    left, right = figure.subplots(1, 2, subplot_kw={"projection": "3d"})
    for axes in (left, right):
        _frame(axes, box, view)
    residual = np.abs(found.radial_distance(points))
    marks = left.scatter(
        *_within(box, points).T,
        c=residual,
        vmin=0,
        vmax=np.quantile(residual, COLOURED),
        s=4,
        cmap="viridis",
        depthshade=False,
    )
    figure.colorbar(marks, ax=left, shrink=0.7, extend="max", label="|radial residual|")
    _wireframe(right, box, truth, "C0", "true")
    _wireframe(right, box, found, "C1", "recovered")
    right.legend(loc="upper left", fontsize="small", frameon=False)
    return figure


def _box(truth: Superellipsoid) -> Array:
    """A cube about the true solid, corners of shape (2, 3)."""
    low, high = truth.bounding_box
    half = (0.5 + MARGIN) * float(np.max(high - low))
    centre = (low + high) / 2
    return np.stack([centre - half, centre + half])


def _view(points: Array, truth: Superellipsoid) -> tuple[float, float]:
    """Elevation and azimuth, in degrees, from which to look at the side that was seen."""
    x, y, z = np.mean(points, axis=0) - truth.translation
    elevation = np.degrees(np.arctan2(z, np.hypot(x, y)))
    azimuth = np.degrees(np.arctan2(y, x))
    # Towards the horizon, where there is room for it.
    aside = -ASIDE[0] if elevation > 0 else ASIDE[0]
    return float(elevation + aside), float(azimuth + ASIDE[1])


def _frame(axes: Any, box: Array, view: tuple[float, float]) -> None:
    for name, low, high in zip("xyz", *box, strict=True):
        axes.set(**{f"{name}lim": (low, high)})
    axes.set_box_aspect((1, 1, 1), zoom=1.5)
    axes.set_proj_type("ortho")
    axes.set_axis_off()
    axes.view_init(*view)


def _wireframe(axes: Any, box: Array, model: Superellipsoid, colour: str, label: str) -> None:
    """Lines of equal latitude and of equal longitude."""
    eta, omega = np.linspace(-0.5, 0.5, LINES) * np.pi, np.linspace(-1, 1, LINES) * np.pi
    fine_eta = np.linspace(-0.5, 0.5, STEPS)[:, None] * np.pi
    fine_omega = np.linspace(-1, 1, STEPS)[:, None] * np.pi
    for lines in (model.position(eta, fine_omega), model.position(fine_eta, omega)):
        for line in np.moveaxis(_within(box, lines), 1, 0):
            axes.plot(*line.T, color=colour, linewidth=0.7, alpha=0.8)
    axes.plot([], [], [], color=colour, label=label)


def _within(box: Array, points: Array) -> Array:
    """Points of shape (..., 3), not numbers in place of those outside the box."""
    outside = np.any((points < box[0]) | (points > box[1]), axis=-1, keepdims=True)
    return np.where(outside, np.nan, points)
