"""Plane curves and their spherical products against the printed formulas."""

import numpy as np
import pytest

import superquadric

SIZE = np.array([2.0, 0.3])
THETA = np.linspace(0.2, 1.3, 24).reshape(2, 3, 4)
STEP = 1e-6
EXPONENTS = [0.3, 1.0, 1.7, 2.5]
FRACTIONS = [(8, 3), (2, 3), (5, 2), (1, 2), (3, 1), (1, 3), (-2, 1), (-3, 2), (-1, 3)]


def assert_derivatives(curve, **arc):
    """Tangents and second derivatives are difference quotients."""
    for function, derivative in [
        (curve.position, curve.tangent),
        (curve.tangent, curve.second_derivative),
    ]:
        quotient = (function(THETA + STEP, **arc) - function(THETA - STEP, **arc)) / (2 * STEP)
        np.testing.assert_allclose(derivative(THETA, **arc), quotient, rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_superellipses_and_superhyperbolas_satisfy_their_equations(exponent):
    for kind, sign in [(superquadric.Superellipse, 1), (superquadric.Superhyperbola, -1)]:
        curve = kind(SIZE, exponent)
        np.testing.assert_array_equal(curve.size, SIZE)
        assert curve.exponent == exponent
        points = curve.position(THETA)
        assert points.shape == (2, 3, 4, 2)
        u, v = np.moveaxis(np.abs(points / SIZE) ** (2 / exponent), -1, 0)
        np.testing.assert_allclose(u + sign * v, 1, atol=1e-12)
        assert_derivatives(curve)


@pytest.mark.parametrize(("kind", "fraction"), list(enumerate(FRACTIONS, start=1)))
def test_lame_curves_of_all_kinds_satisfy_their_equation(kind, fraction):
    curve = superquadric.LameCurve(SIZE, *fraction)
    numerator, denominator = fraction
    m = numerator / denominator
    assert (curve.kind, curve.exponent) == (kind, m)
    assert curve.arcs in (1, 3, 4)
    for arc in range(curve.arcs):
        ratios = curve.position(THETA, arc=arc) / SIZE
        signs = 1 if numerator % 2 == 0 else np.sign(ratios)
        powers = signs * np.abs(ratios) ** m
        np.testing.assert_allclose(powers.sum(axis=-1), 1, atol=1e-11)
        assert_derivatives(curve, arc=arc)
    with pytest.raises(IndexError, match=f"below {curve.arcs}"):
        curve.position(THETA, arc=4)


def test_the_product_of_superellipses_is_the_superellipsoid():
    north = superquadric.Superellipse([1, 0.7], 0.4)
    east = superquadric.Superellipse(SIZE, 1.3)
    eta, omega = np.linspace(-1.5, 1.5, 7)[:, None], np.linspace(-3, 3, 11)
    points = superquadric.spherical_product(north, east, eta, omega)
    solid = superquadric.Superellipsoid([2, 0.3, 0.7], [0.4, 1.3])
    np.testing.assert_allclose(points, solid.position(eta, omega), rtol=1e-13, atol=1e-14)


def test_products_of_any_two_curves_are_barrs():
    curves = [
        superquadric.Superellipse(SIZE, 0.5),
        superquadric.Superhyperbola(SIZE, 1.5),
        superquadric.LameCurve(SIZE, -1, 3),
        superquadric.Polyline([[1, 0], [0, 1], [-1, -1]]),
    ]
    for north in curves:
        for east in curves:
            m, h = north.position(THETA), east.position(THETA)
            expected = np.stack([m[..., 0] * h[..., 0], m[..., 0] * h[..., 1], m[..., 1]], axis=-1)
            found = superquadric.spherical_product(north, east, THETA, THETA)
            np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_a_polyline_is_at_its_points_and_even_between_them():
    points = np.random.default_rng(0).normal(size=(7, 2))
    for closed in [False, True]:
        line = superquadric.Polyline(points, closed=closed)
        assert line.closed is closed
        np.testing.assert_array_equal(line.points, points)
        np.testing.assert_array_equal(line.position(np.arange(7)), points)
        ends = np.roll(points, -1, axis=0)[: 7 if closed else 6]
        starts, share = points[: len(ends)], np.array([0.25, 0.5])
        t = np.arange(len(ends))[:, None] + share
        expected = starts[:, None] + share[:, None] * (ends - starts)[:, None]
        np.testing.assert_allclose(line.position(t), expected, rtol=1e-14, atol=1e-15)
        np.testing.assert_array_equal(line.tangent(t[:, 0]), ends - starts)
        np.testing.assert_array_equal(line.second_derivative(t), np.zeros((len(ends), 2, 2)))
        is_beyond = np.isnan(line.position(8.5)).all()
        assert is_beyond == (not closed)


def test_an_ellipse_crossed_with_a_star_is_the_star_at_every_height():
    """B81 Fig. 1."""
    angle = np.arange(10) * np.pi / 5
    radius = np.where(np.arange(10) % 2 == 0, 1, 0.4)
    star = superquadric.Polyline(
        np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1), closed=True
    )
    ellipse = superquadric.Superellipse([1, 0.7], 1)
    eta, t = np.linspace(-np.pi / 2, np.pi / 2, 9)[:, None], np.linspace(0, 10, 41)
    points = superquadric.spherical_product(ellipse, star, eta, t)
    np.testing.assert_allclose(points[..., 2], 0.7 * np.sin(eta) + 0 * t, atol=1e-15)
    expected = np.cos(eta)[..., None] * star.position(t)
    np.testing.assert_allclose(points[..., :2], expected, atol=1e-15)


@pytest.mark.parametrize(
    ("points", "closed", "message"),
    [
        ([[0, 0]], False, "found 1"),
        ([[0, 0], [1, 1]], True, "from 3"),
        (np.zeros((10_001, 2)), False, "10000"),
        ([[0, 0], [1, np.nan]], False, r"points\[1\] must be finite"),
        ([[0, 0], [1, 0], [0, 0]], True, r"points\[2\] must differ"),
    ],
)
def test_what_is_no_polyline_is_refused(points, closed, message):
    with pytest.raises(superquadric.ModelError, match=message):
        superquadric.Polyline(points, closed=closed)


def test_what_is_no_curve_is_refused():
    with pytest.raises(superquadric.ArrayError, match=r"points.*\(n, 2\)"):
        superquadric.Polyline([1, 2])
    with pytest.raises(superquadric.ModelError, match="size"):
        superquadric.Superellipse([1, -1], 1)
    with pytest.raises(superquadric.ModelError, match="fraction"):
        superquadric.LameCurve([1, 1], 0)
    with pytest.raises(superquadric.ArrayError, match="size"):
        superquadric.Superhyperbola([1, 1, 1], 1)
    with pytest.raises(TypeError):
        superquadric.spherical_product(1, 2, 0.1, 0.2)
