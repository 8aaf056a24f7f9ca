"""What a careful Python user would write: SciPy's trust-region fit with an analytic Jacobian."""

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from superquadric import Superellipsoid

LEAST_SHARE = 1e-100
LOG_FLOOR = -690.0
BOUNDS = np.array([[1e-3] * 3 + [0.1] * 2 + [-np.inf] * 6, [6.0] * 3 + [1.9] * 2 + [np.inf] * 6])
AXIS_ORDERS = [[1, 2, 0], [2, 0, 1], [0, 1, 2]]


def fit(points):
    """Minimise the radial distance (JLS Eq. 2.43) from each principal axis as z; the best of three.

    Args:
        points: of shape (n, 3).

    Returns:
        The model.
    """
    centroid = points.mean(axis=0)
    scale = np.sqrt(np.mean(np.sum((points - centroid) ** 2, axis=1)))
    normal = (points - centroid) / scale
    runs = [
        least_squares(
            lambda p: rows(p, normal)[0],
            start,
            jac=lambda p: rows(p, normal)[1],
            bounds=BOUNDS,
            method="trf",
            x_scale="jac",
            max_nfev=200,
        )
        for start in _starts(normal)
    ]
    size, exponents, angles, centre = np.split(min(runs, key=lambda run: run.cost).x, [3, 5, 8])
    return Superellipsoid(
        scale * size, exponents, euler_zyz=angles, translation=scale * centre + centroid
    )


def _starts(points):
    variances, axes = np.linalg.eigh(np.cov(points.T))
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    size = np.clip(np.sqrt(3 * np.maximum(variances, 0)), 1e-2, 5)
    for order in AXIS_ORDERS:
        yield Superellipsoid(size[order], [1, 1], rotation=axes[:, order]).parameters


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
