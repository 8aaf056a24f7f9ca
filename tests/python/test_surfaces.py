"""Meshes within a tolerance, grids and samples of the surfaces of every family."""

from collections import Counter

import numpy as np
import pytest

import superquadric

POSE = {"euler_zyz": [0.7, 2.1, -1.9], "translation": [10.0, -20.0, 3.0]}
SIZE = [2.0, 0.7, 1.3]
EXPONENTS = [0.6, 1.4]

SHAPES = [
    superquadric.Superellipsoid(SIZE, EXPONENTS, **POSE),
    superquadric.SuperhyperboloidOneSheet(SIZE, EXPONENTS, 2.2, **POSE),
    superquadric.SuperhyperboloidTwoSheets(SIZE, EXPONENTS, 3.5, **POSE),
    superquadric.Supertoroid(SIZE, EXPONENTS, 1.6, **POSE),
    superquadric.ThreeExponent(SIZE, [1.5, 2.0, 5.0], **POSE),
]
GRIDS = ["trigonometric", "angle_centre", "explicit", "equal_distance"]


def name(value):
    return value if isinstance(value, str) else type(value).__name__


def areas(vertices, triangles):
    a, b, c = vertices[triangles].swapaxes(0, 1)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def on_boundary(shape, points):
    """Whether points are of the level F = 1 or of a cap of the clip."""
    local = (points - shape.translation) @ shape.rotation
    caps = {"SuperhyperboloidOneSheet": 2, "SuperhyperboloidTwoSheets": 0}
    axis = caps.get(type(shape).__name__)
    is_on_cap = axis is not None and np.abs(np.abs(local[:, axis]) - shape.clip) < 1e-12
    return is_on_cap | (np.abs(shape.inside_outside(points) - 1) < 1e-8)


@pytest.mark.parametrize("shape", SHAPES, ids=name)
@pytest.mark.parametrize("method", [None, "lattice", "curvature", "subdivision"])
def test_meshes_within_a_tolerance_are_closed_and_finer_where_asked_for(shape, method):
    counts = []
    for tolerance in [0.1, 0.02]:
        vertices, triangles = shape.mesh(tolerance=tolerance, method=method)
        assert on_boundary(shape, vertices).all()
        edges = Counter(
            (int(a), int(b)) for t in triangles for a, b in [t[:2], t[1:], (t[2], t[0])]
        )
        assert all(edges[edge] == 1 and edges[edge[::-1]] == 1 for edge in edges)
        missing = shape.surface_area - areas(vertices, triangles).sum()
        assert abs(missing) < 10 * tolerance * np.sqrt(shape.surface_area)
        counts.append(len(triangles))
    assert counts[1] > counts[0]


@pytest.mark.parametrize("shape", SHAPES, ids=name)
def test_what_no_mesh_can_be_is_refused(shape):
    for wrong, message in [
        ({"tolerance": 0}, "positive"),
        ({"tolerance": 1e-13}, "13 million"),
        ({"tolerance": 0.1, "resolution": 8}, "both"),
        ({"method": "lattice"}, "tolerance"),
        ({"tolerance": 0.1, "method": "guess"}, "subdivision"),
        ({"resolution": 7}, "even"),
    ]:
        with pytest.raises(superquadric.ModelError, match=message):
            shape.mesh(**wrong)


@pytest.mark.parametrize("shape", SHAPES, ids=name)
def test_samples_are_on_the_boundary_uniform_by_area_and_the_same_for_the_same_seed(shape):
    points = shape.sample(20_000, seed=3)
    assert points.shape == (20_000, 3)
    assert on_boundary(shape, points).all()
    np.testing.assert_array_equal(points, shape.sample(20_000, seed=3))
    assert not np.array_equal(points[:10], shape.sample(10, seed=4))
    vertices, triangles = shape.mesh(96)
    weights = areas(vertices, triangles)
    middles = vertices[triangles].mean(axis=1)
    # The distribution along three lines, against the mesh's: Kolmogorov and Smirnov's bound, one in
    # a million, and what a facet's width adds.
    for axis in np.eye(3):
        place, found = middles @ axis, np.sort(points @ axis)
        order = np.argsort(place)
        expected = np.interp(found, place[order], np.cumsum(weights[order]) / weights.sum())
        gap = np.abs(expected - np.linspace(0, 1, len(found))).max()
        assert gap < 2.7 / np.sqrt(len(found)) + 0.01


@pytest.mark.parametrize("shape", SHAPES, ids=name)
@pytest.mark.parametrize("parameterization", GRIDS)
def test_grids_are_rows_of_surface_points(shape, parameterization):
    points = shape.grid(8, parameterization)
    rows = {"Supertoroid": (32, 32), "SuperhyperboloidTwoSheets": (34, 17)}
    assert points.shape == (*rows.get(name(shape), (17, 32)), 3)
    np.testing.assert_allclose(shape.inside_outside(points), 1, atol=1e-8)
    local = (points - shape.translation) @ shape.rotation
    is_of_rays = name(shape) in ("Superellipsoid", "ThreeExponent")
    if parameterization == "angle_centre" and is_of_rays:
        # Rows of rays at one latitude, but at the poles.
        latitude = np.arctan2(local[..., 2], np.hypot(local[..., 0], local[..., 1]))
        assert np.ptp(latitude, axis=1).max() < 1e-13
    else:
        assert np.ptp(local[..., 2], axis=1).max() < 1e-13
    if name(shape) == "SuperhyperboloidTwoSheets":
        ends = np.abs(local[:, [0, -1], 0])
        np.testing.assert_allclose(ends, shape.clip, rtol=1e-12)


def test_grids_differ_as_their_names_say():
    sphere = superquadric.Superellipsoid([1, 1, 1], [1, 1])
    equator = {kind: sphere.grid(8, kind)[8] for kind in GRIDS}
    angle = np.arange(32) * np.pi / 16
    circle = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    np.testing.assert_allclose(equator["trigonometric"], circle, atol=1e-14)
    np.testing.assert_allclose(equator["angle_centre"], circle, atol=1e-14)
    np.testing.assert_allclose(equator["equal_distance"], circle, atol=1e-5)
    np.testing.assert_allclose(np.diff(equator["explicit"][:5, 1]), 0.5**0.5 / 4, rtol=1e-12)
    np.testing.assert_array_equal(sphere.grid(8), sphere.grid(8, "equal_distance"))


def test_names_without_a_grid_are_refused():
    with pytest.raises(superquadric.ModelError, match="angle_centre"):
        SHAPES[0].grid(4, "polar")
