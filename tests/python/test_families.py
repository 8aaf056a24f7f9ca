"""Solids of every family against the printed formulas and the laws they must obey."""

import numpy as np
import pytest

import superquadric

SIZE = np.array([2.0, 0.7, 1.3])
EXPONENTS = (0.6, 1.4)
POSE = {"euler_zyz": [0.7, 2.1, -1.9], "translation": [10.0, -20.0, 3.0]}


def shapes(**pose):
    return [
        superquadric.SuperhyperboloidOneSheet(SIZE, EXPONENTS, 2.2, **pose),
        superquadric.SuperhyperboloidTwoSheets(SIZE, EXPONENTS, 3.5, **pose),
        superquadric.Supertoroid(SIZE, EXPONENTS, 1.6, **pose),
        superquadric.ThreeExponent(SIZE, [1.5, 2.0, 5.0], **pose),
    ]


def printed(shape, points):
    """B81's and FB81's functions."""
    u, v, w = np.abs(points / SIZE).T
    e1, e2 = EXPONENTS
    match shape.family:
        case "superhyperboloid_one_sheet":
            return (u ** (2 / e2) + v ** (2 / e2)) ** (e2 / e1) - w ** (2 / e1)
        case "superhyperboloid_two_sheets":
            difference = u ** (2 / e2) - v ** (2 / e2)
            return np.sign(difference) * np.abs(difference) ** (e2 / e1) - w ** (2 / e1)
        case "supertoroid":
            around = (u ** (2 / e2) + v ** (2 / e2)) ** (e2 / 2)
            return np.abs(around - shape.ring) ** (2 / e1) + w ** (2 / e1)
        case _:
            return sum(x**n for x, n in zip([u, v, w], shape.exponents, strict=True))


def ids(shape):
    return shape.family


@pytest.mark.parametrize("shape", shapes(), ids=ids)
def test_functions_are_the_printed_ones(shape):
    points = np.random.default_rng(0).normal(size=(200, 3)) * SIZE
    expected = printed(shape, points)
    if shape.family == "superhyperboloid_two_sheets":
        expected = 2 - expected
    np.testing.assert_allclose(shape.inside_outside(points), expected, rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize("shape", shapes(**POSE), ids=ids)
def test_surface_normals_and_distances_agree(shape):
    (south, north), (west, east) = shape.domain
    eta = np.linspace(south, north, 12)[1:-1, None]
    omega = np.linspace(west, east, 14)[1:-1]
    points, normals = shape.position(eta, omega), shape.normal(eta, omega)
    assert points.shape == normals.shape == (10, 12, 3)
    np.testing.assert_allclose(shape.inside_outside(points), 1, atol=1e-8)
    gradients = shape.inside_outside_gradient(points)
    gradients /= np.linalg.norm(gradients, axis=-1, keepdims=True)
    np.testing.assert_allclose(gradients, normals, atol=1e-6)
    assert (shape.radial_distance(points + 1e-5 * normals) > 0).all()
    assert (shape.radial_distance(points - 1e-5 * normals) < 0).all()


@pytest.mark.parametrize("shape", shapes(**POSE), ids=ids)
def test_masses_are_those_counted_in_the_box(shape):
    low, high = shape.bounding_box
    points = np.random.default_rng(0).uniform(low, high, size=(100_000, 3))
    inside = points[shape.contains(points) == 1]
    share = len(inside) / len(points)
    standard_error = np.sqrt(share * (1 - share) / len(points)) / share
    counted = np.prod(high - low) * share
    assert counted == pytest.approx(shape.volume, rel=5 * standard_error)
    offset = inside - inside.mean(axis=0)
    moments = offset.T @ offset / len(inside)
    inertia = shape.volume * (np.trace(moments) * np.eye(3) - moments)
    np.testing.assert_allclose(inertia, shape.inertia_about(), atol=0.05 * inertia.max())


@pytest.mark.parametrize("shape", shapes(**POSE), ids=ids)
def test_meshes_are_closed_and_of_the_same_volume(shape):
    vertices, triangles = shape.mesh(48)
    a, b, c = (vertices[triangles[:, k]] - vertices[0] for k in range(3))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    assert volume == pytest.approx(shape.volume, rel=0.01)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    assert area == pytest.approx(shape.surface_area, rel=0.01)
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    assert {tuple(edge) for edge in edges} == {tuple(edge[::-1]) for edge in edges}


@pytest.mark.parametrize("shape", shapes(**POSE), ids=ids)
def test_shapes_come_back_as_their_kind(shape, tmp_path):
    path = tmp_path / "shape.json"
    shape.save(path)
    for again in [
        superquadric.Shape.from_dict(shape.to_dict()),
        superquadric.Shape.from_json(shape.to_json()),
        superquadric.Shape.load(path),
    ]:
        assert type(again) is type(shape)
        assert again.to_dict() == shape.to_dict()
    assert shape.to_dict()["shape"]["family"] == shape.family
    with pytest.raises(superquadric.DocumentError, match=shape.family):
        superquadric.Superellipsoid.from_dict(shape.to_dict())


def test_superellipsoids_stay_superellipsoids(model):
    assert superquadric.Shape.from_json(model.to_json()) == model


def test_superellipsoids_are_shapes_like_the_others(model):
    assert isinstance(model, superquadric.Shape)
    assert isinstance(model.dual(), superquadric.Superellipsoid)
    assert model.family == "superellipsoid"
    np.testing.assert_array_equal(model.domain, np.pi * np.array([[-0.5, 0.5], [-1, 1]]))
    points = np.random.default_rng(3).normal(size=(500, 3)) + model.translation
    inside = model.contains(points)
    np.testing.assert_array_equal(inside == 1, model.inside_outside(points) < 1)
    assert 0 < inside.sum() < 500
    with pytest.raises(TypeError):
        superquadric.Shape()


@pytest.mark.parametrize(
    ("kind", "arguments", "message"),
    [
        (superquadric.Supertoroid, ([1, 1, 1], [1, 1], 0.5), "ring"),
        (superquadric.SuperhyperboloidTwoSheets, ([2, 1, 1], [1, 1], 2), "clip"),
        (superquadric.SuperhyperboloidOneSheet, ([2, 1, 1], [1, 1], 0), "clip"),
        (superquadric.ThreeExponent, ([1, 1, 1], [1, -1, 1]), "exponents"),
    ],
)
def test_parameters_outside_their_domain_are_refused(kind, arguments, message):
    with pytest.raises(superquadric.ModelError, match=message):
        kind(*arguments)


def test_euclidean_distance_is_that_to_the_nearest_point(model):
    points = np.random.default_rng(2).normal(size=(50, 3)) * 2 + model.translation
    feet = model.nearest_point(points)
    np.testing.assert_allclose(model.inside_outside(feet), 1, atol=1e-10)
    distances = model.euclidean_distance(points)
    np.testing.assert_allclose(np.abs(distances), np.linalg.norm(points - feet, axis=1))
    sampled = model.sample(20_000)
    nearest = np.linalg.norm(points[:, None] - sampled[None], axis=2).min(axis=1)
    assert (np.abs(distances) <= nearest + 1e-12).all()
    assert (nearest < np.abs(distances) + 0.05).all()
    np.testing.assert_array_equal(distances < 0, model.inside_outside(points) < 1)


def test_curvatures_are_the_closed_forms():
    sphere = superquadric.Superellipsoid([2, 2, 2], [1, 1], **POSE)
    points = sphere.position(np.linspace(-1, 1, 5)[:, None], np.linspace(-3, 3, 7))
    curvatures = sphere.curvatures(points)
    assert curvatures.shape == (5, 7, 2)
    np.testing.assert_allclose(curvatures, 0.5, rtol=1e-12)
    normals = (points - sphere.translation) / 2
    np.testing.assert_allclose(sphere.inside_outside_gradient(points), normals, rtol=1e-11)

    torus = superquadric.Supertoroid([1, 1, 1], [1, 1], 3, **POSE)
    eta = np.linspace(-3, 3, 9)
    around = np.cos(eta) / (3 + np.cos(eta))
    curvatures = torus.curvatures(torus.position(eta, 0.4))
    np.testing.assert_allclose(curvatures, np.stack([np.ones(9), around], axis=1), atol=1e-10)


@pytest.mark.parametrize(
    "model",
    [*shapes(**POSE), superquadric.Superellipsoid(SIZE, EXPONENTS, **POSE)],
    ids=lambda model: type(model).__name__,
)
def test_derivatives_are_those_of_differences(model):
    eta, omega, step = np.array([0.3, 0.5]), 0.7, 1e-5
    around = model.position(eta + step, omega) - model.position(eta - step, omega)
    along = model.position(eta, omega + step) - model.position(eta, omega - step)
    tangents = np.stack([around, along], axis=1) / (2 * step)
    assert model.tangents(eta, omega).shape == (2, 2, 3)
    np.testing.assert_allclose(model.tangents(eta, omega), tangents, rtol=1e-6, atol=1e-6)

    change = model.tangents(eta + step, omega) - model.tangents(eta - step, omega)
    second = model.second_derivatives(eta, omega)
    assert second.shape == (2, 3, 3)
    np.testing.assert_allclose(second[:, :2], change / (2 * step), rtol=1e-6, atol=1e-6)

    points = 1.1 * (model.position(eta, omega) - model.translation) + model.translation
    hessian = model.inside_outside_hessian(points)
    assert hessian.shape == (2, 3, 3)
    for k, offset in enumerate(step * np.eye(3)):
        ahead, behind = (model.inside_outside_gradient(points + s * offset) for s in (1, -1))
        expected = (ahead - behind) / (2 * step)
        np.testing.assert_allclose(hessian[:, k], expected, rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize(
    "model",
    [*shapes(**POSE), superquadric.Superellipsoid(SIZE, EXPONENTS, **POSE)],
    ids=lambda model: type(model).__name__,
)
def test_fundamental_forms_are_those_of_differences_and_of_the_curvatures(model):
    (_, north), (_, east) = model.domain
    eta = np.array([0.13, 0.35, 0.6, 0.85])[:, None] * north
    omega = np.array([-0.8, -0.3, 0.2, 0.55, 0.9]) * east
    first, second = (
        model.first_fundamental_form(eta, omega),
        model.second_fundamental_form(eta, omega),
    )
    assert first.shape == second.shape == (4, 5, 2, 2)
    tangents = model.tangents(eta, omega)
    np.testing.assert_allclose(first, tangents @ tangents.swapaxes(-1, -2), rtol=1e-12, atol=1e-14)
    np.testing.assert_array_equal(second, second.swapaxes(-1, -2))

    # Twice the depth below the tangent plane after a small step, over its square.
    position, normal = model.position(eta, omega), model.normal(eta, omega)
    for direction in [np.array([1.0, 0.0]), np.array([0.0, 1.0]), np.array([0.6, -0.8])]:
        step = 3e-4 * direction
        ends = [model.position(eta + s * step[0], omega + s * step[1]) for s in (1, -1)]
        bend = np.sum((2 * position - ends[0] - ends[1]) * normal, axis=-1) / 9e-8
        length = np.sum(((ends[0] - ends[1]) / 6e-4) ** 2, axis=-1)
        scale = np.abs(second).max()
        np.testing.assert_allclose(
            direction @ second @ direction, bend, rtol=1e-3, atol=1e-3 * scale
        )
        np.testing.assert_allclose(direction @ first @ direction, length, rtol=1e-4)

    principal = np.linalg.eigvals(np.linalg.solve(first, second))
    principal = np.sort(principal.real, axis=-1)[..., ::-1]
    np.testing.assert_allclose(principal, model.curvatures(position), rtol=1e-7, atol=1e-7)


def test_fundamental_forms_of_a_torus_are_the_closed_forms():
    torus = superquadric.Supertoroid([1, 1, 1], [1, 1], 3, **POSE)
    eta, omega = np.linspace(-3, 3, 8)[:, None], np.linspace(-3, 3, 6)
    radius = 3 + np.cos(eta) + 0 * omega
    one, nought = np.ones_like(radius), np.zeros_like(radius)
    # E = 1, G = r^2; D = 1, D2 = r cos(eta).
    first = np.stack([np.stack([one, nought], -1), np.stack([nought, radius**2], -1)], -1)
    second = np.stack(
        [np.stack([one, nought], -1), np.stack([nought, radius * np.cos(eta)], -1)], -1
    )
    np.testing.assert_allclose(torus.first_fundamental_form(eta, omega), first, atol=1e-13)
    np.testing.assert_allclose(torus.second_fundamental_form(eta, omega), second, atol=1e-13)


@pytest.mark.parametrize("model", shapes(**POSE), ids=ids)
def test_the_dual_of_the_dual_is_the_shape_and_of_a_ring_its_tube(model):
    again = model.dual().dual().to_dict()["shape"]
    shape = model.to_dict()["shape"]
    is_ring = model.family == "supertoroid"
    assert again["family"] == ("superellipsoid" if is_ring else shape["family"])
    np.testing.assert_allclose(again["exponents"], shape["exponents"], rtol=1e-14)
    # Three exponents that differ have each an axis' scale of their own.
    if model.family != "three_exponent":
        np.testing.assert_allclose(again["size"], shape["size"], rtol=1e-14)


def test_normals_lie_on_the_dual_superellipsoid():
    model = superquadric.Superellipsoid(SIZE, EXPONENTS, **POSE)
    normals = model.inside_outside_gradient(model.position(np.linspace(-1, 1, 5), 0.4))
    on_dual = normals * EXPONENTS[0] / 2
    np.testing.assert_allclose(model.dual().inside_outside(on_dual), 1, rtol=1e-10)
