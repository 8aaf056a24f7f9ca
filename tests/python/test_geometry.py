"""The core's geometry on arrays against the oracle and the laws it must obey."""

import itertools
from collections import Counter

import numpy as np
import oracle
import pytest

import superquadric

EXPONENTS = list(itertools.product([0.1, 0.4, 1.0, 1.7, 2.0], repeat=2))
SIZE = np.array([2.0, 0.3, 5.0])
EULER = (0.7, 2.1, -1.9)
CENTRE = np.array([10.0, -20.0, 3.0])

# Powers up to 2 / 0.1 of numbers near ten, each of relative rounding 1e-16.
POWERS = 1e-12
# Coordinates near 20 are rounded to 4e-15, and powered.
WORLD = 1e-12


def posed(exponents):
    return superquadric.Superellipsoid(SIZE, exponents, euler_zyz=EULER, translation=CENTRE)


def points_around(count=200):
    return np.random.default_rng(0).normal(size=(count, 3)) * SIZE


def latitudes_and_longitudes():
    eta = np.linspace(-1.5, 1.5, 13)[:, None]
    return eta, np.linspace(-3.1, 3.1, 17)


@pytest.mark.parametrize("exponents", EXPONENTS)
def test_functions_are_those_of_the_printed_formulas(exponents):
    model = superquadric.Superellipsoid(SIZE, exponents)
    points = points_around()
    for name in ["inside_outside", "gauge", "radial_distance"]:
        found = getattr(model, name)(points)
        expected = getattr(oracle, name)(points, SIZE, exponents)
        np.testing.assert_allclose(found, expected, rtol=POWERS, atol=POWERS, err_msg=name)
    assert model.volume == pytest.approx(oracle.volume(SIZE, exponents), rel=1e-12)


@pytest.mark.parametrize("exponents", EXPONENTS)
def test_pose_takes_the_model_to_the_world(exponents):
    points = points_around()
    model = posed(exponents)
    matrix = oracle.rotation(*EULER)
    np.testing.assert_allclose(model.rotation, matrix, atol=1e-15)
    world = points @ matrix.T + CENTRE
    found = model.radial_distance(world)
    expected = oracle.radial_distance(points, SIZE, exponents)
    # A coordinate's rounding moves the distance by as much, or by more where e is 2.
    np.testing.assert_allclose(found, expected, atol=1e-9)


@pytest.mark.parametrize("exponents", EXPONENTS)
def test_positions_lie_on_the_surface_and_projections_too(exponents):
    model = posed(exponents)
    surface = model.position(*latitudes_and_longitudes())
    assert surface.shape == (13, 17, 3)
    assert np.abs(model.radial_distance(surface)).max() < 1e-6
    projected = model.radial_projection(points_around() + CENTRE)
    np.testing.assert_allclose(model.gauge(projected), 1, atol=1e-6)


@pytest.mark.parametrize("exponents", [(0.4, 0.4), (1.0, 1.0), (0.5, 1.7)])
def test_tangent_planes_support_the_solid_at_their_points(exponents):
    model = posed(exponents)
    angles = latitudes_and_longitudes()
    position, normal = model.position(*angles), model.normal(*angles)
    np.testing.assert_allclose(np.linalg.norm(normal, axis=-1), 1, atol=1e-14)
    along = np.sum(position * normal, axis=-1)
    np.testing.assert_allclose(model.support(normal), along, atol=1e-11)


@pytest.mark.parametrize("exponents", EXPONENTS)
def test_bounding_box_is_the_least_that_holds_the_samples(exponents):
    model = posed(exponents)
    low, high = model.bounding_box
    points = np.concatenate([model.sample(2000), model.sample_solid(2000)])
    assert (points >= low - WORLD).all()
    assert (points <= high + WORLD).all()
    axes = np.eye(3)
    np.testing.assert_allclose(model.support(axes), high, atol=WORLD)
    np.testing.assert_allclose(-model.support(-axes), low, atol=WORLD)


@pytest.mark.parametrize("exponents", EXPONENTS)
def test_inertia_is_that_of_points_uniform_in_the_solid(exponents):
    model = posed(exponents)
    points = model.sample_solid(20_000)
    for about, tensor in [
        (CENTRE, model.inertia_about()),
        ([1.0, 2.0, 3.0], model.inertia_about([1.0, 2.0, 3.0])),
        (CENTRE, model.rotation @ model.inertia @ model.rotation.T),
    ]:
        offsets = points - about
        squares = np.einsum("ni,nj->ij", offsets, offsets) / len(points)
        sampled = model.volume * (np.trace(squares) * np.eye(3) - squares)
        # A share of squares deviates by less than itself: a hundredth over 20 000 points.
        np.testing.assert_allclose(tensor, sampled, atol=0.03 * np.abs(sampled).max())


@pytest.mark.parametrize("exponents", EXPONENTS)
def test_surface_area_is_the_limit_of_inscribed_meshes(exponents):
    model = posed(exponents)
    vertices, triangles = model.mesh(resolution=64)
    a, b, c = vertices[triangles].transpose(1, 0, 2)
    inscribed = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    assert inscribed <= model.surface_area * (1 + 1e-9)
    assert inscribed == pytest.approx(model.surface_area, rel=1e-3)


def test_samples_are_the_same_for_the_same_seed_only(model):
    for draw in [model.sample, model.sample_solid]:
        assert np.array_equal(draw(50, seed=3), draw(50, seed=3))
        assert not np.array_equal(draw(50, seed=3), draw(50, seed=4))
        assert draw(0).shape == (0, 3)


def test_samples_are_uniform_by_area_and_by_volume():
    sphere = superquadric.Superellipsoid([2, 2, 2], [1, 1], translation=[5, 0, 0])
    surface = sphere.sample(20_000) - [5, 0, 0]
    # Archimedes: each coordinate is uniform. Standard error of the mean square: 0.0085.
    np.testing.assert_allclose((surface**2).mean(axis=0), 4 / 3, atol=0.04)
    radii = np.linalg.norm(sphere.sample_solid(20_000) - [5, 0, 0], axis=1)
    # The cube of a relative radius is uniform. Standard error of its mean: 0.002.
    assert ((radii / 2) ** 3).mean() == pytest.approx(0.5, abs=0.01)


@pytest.mark.parametrize("exponents", [(0.1, 0.1), (1.0, 1.0), (0.3, 1.8)])
def test_mesh_is_closed_outward_and_on_the_surface(exponents):
    model = posed(exponents)
    vertices, triangles = model.mesh(resolution=32)
    assert vertices.dtype == np.float64
    assert triangles.dtype == np.uint32
    assert (len(vertices), len(triangles)) == (6 * 32**2 + 2, 12 * 32**2)
    np.testing.assert_allclose(model.gauge(vertices), 1, atol=1e-9)
    edges = Counter(
        tuple(e) for t in triangles.tolist() for e in zip(t, t[1:] + t[:1], strict=True)
    )
    assert all(edges[b, a] == 1 for a, b in edges)
    a, b, c = (vertices - CENTRE)[triangles].transpose(1, 0, 2)
    enclosed = np.sum(a * np.cross(b, c)) / 6
    # Flat triangles cut off less than 2 % at this resolution.
    assert 0.98 * model.volume < enclosed <= (1 + 1e-9) * model.volume


def test_canonical_form_is_one_for_equivalent_parameters():
    model = posed((0.3, 1.2))
    phi, theta, psi = EULER
    swapped = superquadric.Superellipsoid(
        SIZE[[1, 0, 2]],
        [0.3, 1.2],
        euler_zyz=[phi, theta, psi + np.pi / 2],
        translation=CENTRE,
    )
    turned = superquadric.Superellipsoid(
        SIZE, [0.3, 1.2], euler_zyz=[phi, theta, psi + np.pi], translation=CENTRE
    )
    for other in [swapped, turned]:
        np.testing.assert_allclose(
            other.canonical().parameters, model.canonical().parameters, atol=1e-14
        )
        points = points_around() + CENTRE
        np.testing.assert_allclose(other.gauge(points), model.gauge(points), rtol=1e-9)


def test_parameters_are_in_the_documented_order(model):
    expected = [2.0, 1.0, 0.5, 0.4, 1.3, 0.3, 1.1, -0.8, 4.0, -2.0, 7.0]
    np.testing.assert_allclose(model.parameters, expected, rtol=1e-15)
    assert model.mean_semi_axis == 3.5 / 3
