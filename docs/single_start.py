"""A plain fit to compare with: one descent, from the principal axes."""

import time
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from superquadric import Superellipsoid

MOST_POINTS = 500
MOST_STEPS = 200
EXPONENTS = 0.1, 1.9
SIZES = 1e-3, 1e3


@dataclass(frozen=True)
class SingleStart:
    """The model found, and the wall-clock seconds it took."""

    model: Superellipsoid
    seconds: float


def fit(points):
    """Minimise the radial distance over all eleven parameters, with numeric derivatives.

    Of points of shape (n, 3) at most 500, evenly spread over their order, are looked at. The
    start is an ellipsoid at the centroid, along the principal axes, the longest as z.
    """
    begin = time.perf_counter()
    points = points[:: -(-len(points) // MOST_POINTS)]
    centroid = points.mean(axis=0)
    scale = np.sqrt(np.mean(np.sum((points - centroid) ** 2, axis=1)))
    normal = (points - centroid) / scale
    free, bound = np.full(6, np.inf), np.ones(3)
    found = least_squares(
        lambda parameters: _model(parameters).radial_distance(normal),
        _start(normal).parameters,
        bounds=(
            [*SIZES[0] * bound, *[EXPONENTS[0]] * 2, *-free],
            [*SIZES[1] * bound, *[EXPONENTS[1]] * 2, *free],
        ),
        method="trf",
        max_nfev=MOST_STEPS,
    )
    size, exponents, angles, centre = np.split(found.x, [3, 5, 8])
    model = Superellipsoid(
        scale * size, exponents, euler_zyz=angles, translation=scale * centre + centroid
    )
    return SingleStart(model, time.perf_counter() - begin)


def _start(points):
    variances, axes = np.linalg.eigh(np.cov(points.T))
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    # On the surface of a sphere the variance along an axis is a third of the squared radius.
    size = np.clip(np.sqrt(3 * np.maximum(variances, 0)), 10 * SIZES[0], None)
    return Superellipsoid(size, [1, 1], rotation=axes)


def _model(parameters):
    size, exponents, angles, centre = np.split(parameters, [3, 5, 8])
    return Superellipsoid(size, exponents, euler_zyz=angles, translation=centre)
