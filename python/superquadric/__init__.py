"""Superquadrics: recovery from range points, and their geometry.

Lengths are in the caller's own unit, angles in radians. A model's parameters are, in this order,
`a1 a2 a3 e1 e2 phi theta psi px py pz`: semi-axes, exponents, Euler angles of the rotation
`Rz(phi) Ry(theta) Rz(psi)` from model to world, and the centre.
"""

from ._core import (
    ArrayError,
    BatchError,
    Camera,
    CloudError,
    Contour,
    DepthMap,
    DocumentError,
    Fit,
    FitError,
    ImageError,
    ModelError,
    Score,
    Superellipsoid,
    SuperquadricError,
    ViewError,
    __version__,
    contour,
    fit,
    read,
    read_depth,
    rim,
    score,
    wireframe,
)
from .estimator import SuperquadricEstimator

__all__ = [
    "ArrayError",
    "BatchError",
    "Camera",
    "CloudError",
    "Contour",
    "DepthMap",
    "DocumentError",
    "Fit",
    "FitError",
    "ImageError",
    "ModelError",
    "Score",
    "Superellipsoid",
    "SuperquadricError",
    "SuperquadricEstimator",
    "ViewError",
    "__version__",
    "contour",
    "fit",
    "read",
    "read_depth",
    "rim",
    "score",
    "wireframe",
]
