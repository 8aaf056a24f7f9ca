"""What a careful Python user would write: SciPy's trust-region fit with an analytic Jacobian."""

from dataclasses import dataclass

import numpy as np
import scipy_search
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from superquadric import Superellipsoid

LEAST_SHARE = 1e-100
LOG_FLOOR = -690.0
BOUNDS = np.array([[1e-3] * 3 + [0.1] * 2 + [-np.inf] * 6, [6.0] * 3 + [1.9] * 2 + [np.inf] * 6])
# Starts lie inside: the library, too, keeps exponents of switched models 0.05 off their bounds.
START_BOUNDS = np.array(
    [[1e-2] * 3 + [0.15] * 2 + [-np.inf] * 6, [5.0] * 3 + [1.85] * 2 + [np.inf] * 6]
)
SEARCHES = {
    "principal": scipy_search.from_principal_axes,
    "same": scipy_search.as_the_library,
}


@dataclass(frozen=True)
class Fit:
    """The best model found, and how many models were descended from."""

    model: Superellipsoid
    starts: int


def fit(points, starts="same"):
    """Minimise the radial distance (JLS Eq. 2.43) of all points from several starts.

    Args:
        points: of shape (n, 3).
        starts: `"principal"` for each principal axis as z, `"same"` for those of the library.

    Returns:
        The `Fit`.
    """
    centroid = points.mean(axis=0)
    scale = np.sqrt(np.mean(np.sum((points - centroid) ** 2, axis=1)))
    normal = (points - centroid) / scale
    search = SEARCHES[starts](normal, lambda start: _descend(normal, start))
    best = search.best.model
    model = Superellipsoid(
        scale * best.size,
        best.exponents,
        rotation=best.rotation,
        translation=scale * best.translation + centroid,
    )
    return Fit(model, len(search.descents))


def _descend(points, start):
    run = least_squares(
        lambda p: rows(p, points)[0],
        np.clip(start.parameters, *START_BOUNDS),
        jac=lambda p: rows(p, points)[1],
        bounds=BOUNDS,
        method="trf",
        x_scale="jac",
        max_nfev=200,
    )
    size, exponents, angles, centre = np.split(run.x, [3, 5, 8])
    model = Superellipsoid(size, exponents, euler_zyz=angles, translation=centre)
    return scipy_search.Descent(model, run.cost)


def rows(parameters, points):
    """Radial distances of points of shape (n, 3), and their derivatives of shape (n, 11)."""
    size, (e1, e2), angles, centre = np.split(parameters, [3, 5, 8])
    rotation = Rotation.from_euler("ZYZ", angles).as_matrix()
    x = (points - centre) @ rotation
    magnitude = np.maximum(np.abs(x), LEAST_SHARE * size)
    u, v, w = (magnitude / size).T

    greatest, least = np.maximum(u, v), np.minimum(u, v)
    y2 = np.maximum(2 / e2 * np.log(least / greatest), LOG_FLOOR)
    l2 = np.log1p(np.exp(y2))
    equator = np.exp(-l2), np.exp(y2 - l2)
    ratio = np.log(greatest / w) + e2 / 2 * l2
    y1 = np.maximum(-2 / e1 * np.abs(ratio), LOG_FLOOR)
    l1 = np.log1p(np.exp(y1))
    meridian = np.exp(-l1), np.exp(y1 - l1)

    is_equatorial, is_x = ratio >= 0, u >= v
    share, axial = np.where(is_equatorial, meridian, meridian[::-1])
    share_x, share_y = np.where(is_x, equator, equator[::-1])
    shares = np.stack([share * share_x, share * share_y, axial], axis=1)
    log_norm = e1 / 2 * l1 + np.where(is_equatorial, e2 / 2 * l2, 0)
    inverse = np.exp(-log_norm) / np.where(is_equatorial, greatest, w)

    radius = np.linalg.norm(magnitude, axis=1)
    surface = radius * inverse
    normal = x * ((1 - inverse) / radius)[:, None]
    normal += np.sign(x) * surface[:, None] * shares / magnitude
    by_size = -surface[:, None] * shares / size
    by_e1 = surface / 2 * (l1 - meridian[1] * y1)
    by_e2 = surface / 2 * share * (l2 - equator[1] * y2)
    by_angles = np.cross(normal, x) @ _body_rates(angles)
    jacobian = np.column_stack([by_size, by_e1, by_e2, by_angles, -normal @ rotation.T])
    return radius - surface, jacobian


def _body_rates(angles):
    """Rotation in the model's frame by each Euler angle, as columns."""
    _, theta, psi = angles
    return np.array(
        [
            [-np.sin(theta) * np.cos(psi), np.sin(psi), 0],
            [np.sin(theta) * np.sin(psi), np.cos(psi), 0],
            [np.cos(theta), 0, 1],
        ]
    )
