"""A model drawn over a picture of it with OpenCV (`pip install 'superquadric[overlay]'`)."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import ArrayError, axes, contour, residual, wireframe

if TYPE_CHECKING:
    from ._core import _AnyCamera, _Solid

__all__ = ["MissingExtraError", "draw"]

Color = tuple[int, int, int]

CONTOUR: Color = (0, 225, 255)
VISIBLE: Color = (255, 255, 255)
HIDDEN: Color = (255, 255, 255)
RIM: Color = (0, 150, 255)
AXES: tuple[Color, Color, Color] = ((70, 70, 255), (70, 220, 70), (255, 140, 90))
SEAM: Color = (0, 0, 0)

DASH = 4
"""Points of the hidden rim that are drawn, and as many that are not."""

SUBPIXEL_BITS = 4
"""Bits of a pixel's fraction that OpenCV draws lines with."""

FARTHEST = 1e6
"""Pixels from the image's corner beyond which nothing is drawn: OpenCV's numbers end there."""


class MissingExtraError(ImportError):
    """OpenCV cannot be imported."""


def draw(
    image: NDArray[np.uint8],
    model: _Solid,
    camera: _AnyCamera,
    *,
    points: ArrayLike | None = None,
) -> NDArray[np.uint8]:
    """Draws a model over a picture: outline, rim, lines, axes, coloured points.

    Of rim and lines what is hidden is faint, the rim dashed.

    Args:
        image: grey or blue, green, red as `cv2.imread` gives it, of shape (height, width[, 3]).
        model: the model of any family, the fit, or a list of them, in the camera's frame.
        camera: the camera that took the picture, pinhole or orthographic.
        points: points of the camera's frame, of shape (n, 3), coloured by their distance, radial
            from superellipsoids with exponents up to 2: blue within the model, white on it, red
            outside.

    Returns:
        A new picture of shape (height, width, 3).

    Raises:
        ArrayError: if the picture or the points have another shape.
        ViewError: if the model has no outline.
        MissingExtraError: if OpenCV cannot be imported.
    """
    canvas = _colored(image, camera)
    outline = contour(model, camera)
    visible, hidden = wireframe(model, camera)
    if points is not None:
        _draw_points(canvas, np.asarray(points, dtype=np.float64), model, camera)
    _draw_faintly(canvas, hidden, HIDDEN, opacity=0.25)
    _draw_faintly(canvas, visible, VISIBLE, opacity=0.6)
    rims = {
        is_hidden: [camera.project(run) for curve in outline.rim for run in curve.runs(is_hidden)]
        for is_hidden in (True, False)
    }
    _draw_faintly(canvas, _dashes(rims[True]), RIM, opacity=0.6)
    _draw_lines(canvas, rims[False], RIM, closed=False)
    _draw_lines(canvas, outline.polygons, CONTOUR, closed=True, thickness=2)
    _draw_axes(canvas, model, camera)
    return canvas


def _opencv() -> Any:
    try:
        return importlib.import_module("cv2")
    except ImportError as error:
        raise MissingExtraError(
            f"cv2 cannot be imported ({error}): pip install 'superquadric[overlay]'"
        ) from error


def _colored(image: NDArray[np.uint8], camera: _AnyCamera) -> NDArray[np.uint8]:
    """A copy in three channels."""
    image = np.asarray(image)
    size = (camera.height, camera.width)
    if image.shape not in (size, (*size, 3)) or image.dtype != np.uint8:
        raise ArrayError(
            f"image: expected uint8 of shape {size} or {(*size, 3)}, found {image.dtype} of shape "
            f"{image.shape}"
        )
    channels = image[:, :, np.newaxis] if image.ndim == 2 else image
    return np.array(np.broadcast_to(channels, (*size, 3)), dtype=np.uint8, order="C")


def _draw_faintly(
    canvas: NDArray[np.uint8], lines: list[NDArray[np.float64]], color: Color, *, opacity: float
) -> None:
    """Lines that what is behind shines through."""
    layer = canvas.copy()
    _draw_lines(layer, lines, color, closed=False)
    _opencv().addWeighted(layer, opacity, canvas, 1 - opacity, 0, canvas)


def _dashes(lines: list[NDArray[np.float64]]) -> list[NDArray[np.float64]]:
    """Every other piece of lines whose points are about a pixel apart."""
    starts = [(line, start) for line in lines for start in range(0, len(line) - 1, 2 * DASH)]
    return [line[start : start + DASH + 1] for line, start in starts]


def _draw_lines(
    canvas: NDArray[np.uint8],
    lines: list[NDArray[np.float64]],
    color: Color,
    *,
    closed: bool,
    thickness: int = 1,
) -> None:
    """Lines through pixels (column, row), with a dark seam."""
    cv2 = _opencv()
    near = [line for line in lines if np.abs(line).max() < FARTHEST]
    fixed = [np.rint(line * 2**SUBPIXEL_BITS).astype(np.int32) for line in near]
    for width, ink in [(2 * thickness, SEAM), (thickness, color)]:
        cv2.polylines(canvas, fixed, closed, ink, width, cv2.LINE_AA, SUBPIXEL_BITS)


def _draw_axes(canvas: NDArray[np.uint8], model: _Solid, camera: _AnyCamera) -> None:
    """The axes x, y, z in red, green and blue, where they are in front of the camera."""
    ends = axes(model)
    if ends is None:
        return
    for line, color in zip(ends, AXES, strict=True):
        _draw_lines(canvas, [camera.project(line)], color, closed=False, thickness=2)


def _draw_points(
    canvas: NDArray[np.uint8], points: NDArray[np.float64], model: _Solid, camera: _AnyCamera
) -> None:
    """Points coloured by their distance, and the scale."""
    distances = residual(model, points)
    pixels = camera.project(points)
    is_seen = np.isfinite(pixels).all(axis=-1) & np.isfinite(distances)
    is_seen &= (np.abs(np.nan_to_num(pixels, nan=FARTHEST)) < FARTHEST).all(axis=-1)
    if not is_seen.any():
        return
    end = _scale_end(distances[is_seen])
    cv2 = _opencv()
    for pixel, distance in zip(pixels[is_seen], distances[is_seen], strict=True):
        center = np.rint(pixel * 2**SUBPIXEL_BITS).astype(int).tolist()
        ink = _color(distance / end)
        cv2.circle(canvas, center, 2**SUBPIXEL_BITS, ink, -1, cv2.LINE_AA, SUBPIXEL_BITS)
    _draw_scale(canvas, end)


def _scale_end(distances: NDArray[np.float64]) -> float:
    """A round number that 95 % of the distances are within."""
    magnitude = float(np.quantile(np.abs(distances), 0.95))
    if magnitude == 0.0:
        return 1.0
    decade = 10.0 ** np.floor(np.log10(magnitude))
    return float(next((d * decade for d in (1, 2, 5) if d * decade >= magnitude), 10 * decade))


def _color(share: float) -> Color:
    """Blue, green, red of a distance in ends of the scale."""
    inside, middle, outside = (255.0, 90.0, 40.0), (245.0, 245.0, 245.0), (30.0, 50.0, 255.0)
    end = inside if share < 0 else outside
    weight = min(abs(share), 1.0)
    blue, green, red = (round(m + weight * (e - m)) for m, e in zip(middle, end, strict=True))
    return blue, green, red


def _draw_scale(canvas: NDArray[np.uint8], end: float) -> None:
    """The scale in the lower left corner."""
    cv2 = _opencv()
    height = canvas.shape[0]
    width = min(220, canvas.shape[1] - 20)
    cv2.rectangle(canvas, (4, height - 44), (width + 16, height - 4), SEAM, -1)
    for step in range(width):
        color = _color(2 * (step + 0.5) / width - 1)
        cv2.line(canvas, (10 + step, height - 38), (10 + step, height - 28), color, 1)
    for place, text in [(0, f"-{end:g}"), (width // 2, "0"), (width, f"+{end:g}")]:
        (letters, _), _ = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, 0.45, 1)
        left = 10 + place - letters * place // width
        at = (left, height - 11)
        cv2.putText(canvas, text, at, cv2.FONT_HERSHEY_SIMPLEX, 0.45, VISIBLE, 1, cv2.LINE_AA)
