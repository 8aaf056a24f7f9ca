"""The models that `superquadric.fit` starts from, made again in NumPy.

All are in normalised coordinates: the centroid at the origin, the RMS radius one.
"""

import itertools

import numpy as np
from scipy.spatial.transform import Rotation

from superquadric import Superellipsoid

AXIS_ORDERS = [[1, 2, 0], [2, 0, 1], [0, 1, 2]]
AMBIGUOUS_RATIO = 0.63
LEAST_ASPECT = 1e-3
EIGHTH_TURN = np.pi / 4
DIAGONALS = np.array([[1, 1, 1], [1, -1, 1]]) / np.sqrt(3)


def principal(points):
    """An ellipsoid along the principal axes, each in turn as z.

    Args:
        points: of shape (n, 3), normalised.

    Returns:
        Three models.
    """
    return _each_axis_as_z(*_principal_frame(points))


def ambiguous(points):
    """The same in the frames between those principal axes that the scatter hardly tells apart.

    Args:
        points: of shape (n, 3), normalised.

    Returns:
        Three models a frame, of up to five frames.
    """
    axes, deviations = _principal_frame(points)
    frames = [_turned(axes, deviations, turn) for turn in _turns(*deviations)]
    return list(itertools.chain.from_iterable(_each_axis_as_z(*frame) for frame in frames))


def switches(model):
    """The models that hide a superellipsoid: each other axis as z, and the dual.

    Of another axis the exponents are exchanged; the dual is turned by 45 degrees about z.
    """
    return [*(_axis_switch(model, order) for order in AXIS_ORDERS[:2]), _dual_switch(model)]


def _principal_frame(points):
    """Axes as columns, right-handed, and standard deviations along them, falling."""
    variances, axes = np.linalg.eigh(np.cov(points.T, bias=True))
    first, second = axes[:, 2], axes[:, 1]
    axes = np.column_stack([first, second, np.cross(first, second)])
    return axes, np.sqrt(np.maximum(variances[::-1], 0))


def _turns(first, second, third):
    """Rotations within the principal frame that its deviations leave open."""

    x, y, z = np.eye(3)
    axes = []
    if second > AMBIGUOUS_RATIO * first:
        axes += [z]
    if third > AMBIGUOUS_RATIO * second:
        axes += [x]
    if third > AMBIGUOUS_RATIO * first:
        axes += [y, *DIAGONALS]
    return [Rotation.from_rotvec(EIGHTH_TURN * axis).as_matrix() for axis in axes]


def _turned(axes, deviations, turn):
    return axes @ turn, np.sqrt(deviations**2 @ turn**2)


def _each_axis_as_z(axes, deviations):
    # On the surface of a sphere the variance along an axis is a third of the squared radius.
    size = np.sqrt(3) * np.maximum(deviations, LEAST_ASPECT * deviations.max())
    return [Superellipsoid(size[order], [1, 1], rotation=axes[:, order]) for order in AXIS_ORDERS]


def _axis_switch(model, order):
    return Superellipsoid(
        model.size[order],
        model.exponents[::-1],
        rotation=model.rotation[:, order],
        translation=model.translation,
    )


def _dual_switch(model):
    """`e2 -> 2 - e2`, `a1, a2 -> sqrt(a1 a2) 2^((1 - e2)/2)`: nearly the same square section."""
    (a1, a2, a3), (e1, e2) = model.size, model.exponents
    side = np.sqrt(a1 * a2) * 2 ** ((1 - e2) / 2)
    turn = Rotation.from_rotvec([0, 0, EIGHTH_TURN]).as_matrix()
    return Superellipsoid(
        [side, side, a3],
        [e1, 2 - e2],
        rotation=model.rotation @ turn,
        translation=model.translation,
    )
