"""Deformed models, solids and scenes against closed forms and each other."""

import json
from pathlib import Path

import numpy as np
import pytest

import superquadric

ROOT = Path(__file__).parents[2]
TWIST = {"kind": "twist", "profile": {"form": "line", "at_zero": 0.2, "slope": 0.9}}
TAPER = {"kind": "taper", "profile": {"form": "polyline", "knots": [[-0.5, 0.7], [0.4, 1.2]]}}
BEND = {"kind": "bend", "rate": 0.4, "center": 0.1, "range": [-0.6, 0.5]}
POSE = {"euler_zyz": [0.7, 2.1, -1.9], "translation": [10.0, -20.0, 3.0]}


def ball(x, radius=1.0):
    return superquadric.Superellipsoid([radius] * 3, [1, 1], translation=[x, 0, 0])


def models():
    size, exponents = [0.8, 0.5, 0.6], [0.4, 1.2]
    return [
        superquadric.Superellipsoid(size, exponents, **POSE),
        superquadric.SuperhyperboloidOneSheet(size, exponents, 0.9, **POSE),
        superquadric.Supertoroid([0.3, 0.2, 0.3], exponents, 1.8, **POSE),
        superquadric.ThreeExponent(size, [1.5, 2.0, 5.0], **POSE),
    ]


@pytest.mark.parametrize("model", models(), ids=lambda model: type(model).__name__)
def test_a_deformed_model_is_a_shape_like_any_other(model, tmp_path):
    deformed = superquadric.Deformed(model, [TAPER, TWIST, BEND])
    assert [stage["kind"] for stage in deformed.deformations] == ["taper", "twist", "bend"]
    assert type(deformed.model) is type(model)
    eta, omega = np.array([[-0.6], [0.1], [0.5]]), np.array([-2.9, -1.0, 0.4, 2.2])
    points, normals = deformed.position(eta, omega), deformed.normal(eta, omega)
    assert points.shape == normals.shape == (3, 4, 3)
    np.testing.assert_allclose(deformed.inside_outside(points), 1, atol=1e-9)
    assert np.all(deformed.contains(points - 1e-6 * normals) == 1)
    assert np.all(deformed.contains(points + 1e-6 * normals) == 0)
    gradients = deformed.inside_outside_gradient(points)
    gradients /= np.linalg.norm(gradients, axis=-1, keepdims=True)
    np.testing.assert_allclose(gradients, normals, atol=1e-8)
    low, high = deformed.bounding_box
    vertices, triangles = deformed.mesh(48)
    assert np.all(vertices >= low)
    assert np.all(vertices <= high)
    a, b, c = vertices[triangles].swapaxes(0, 1) - vertices.mean(axis=0)
    masses = deformed.masses(1e-5)
    assert masses["error"] <= 1e-5
    assert np.linalg.det(np.stack([a, b, c], axis=1)).sum() / 6 == pytest.approx(
        masses["volume"], rel=0.01
    )
    assert np.all(masses["centroid"] > low)
    assert np.all(masses["centroid"] < high)
    deformed.save(tmp_path / "model.json")
    readers = [
        superquadric.Shape.load(tmp_path / "model.json"),
        superquadric.Shape.from_json(deformed.to_json()),
        superquadric.Deformed.from_dict(json.loads(deformed.to_json())),
    ]
    for again in readers:
        assert isinstance(again, superquadric.Deformed)
        np.testing.assert_allclose(again.position(eta, omega), points, atol=1e-12)


def test_a_twist_keeps_the_volume_and_no_deformation_keeps_the_model():
    model = models()[0]
    twisted = superquadric.Deformed(model, [TWIST])
    assert twisted.masses(1e-8)["volume"] == pytest.approx(model.volume, rel=1e-8)
    assert superquadric.Deformed.from_dict(model.to_dict()) == model
    with pytest.raises(superquadric.DocumentError, match="fold"):
        superquadric.Deformed(
            model, [{"kind": "taper", "profile": {"form": "line", "at_zero": 1, "slope": 3}}]
        )
    with pytest.raises(superquadric.DocumentError, match="shear"):
        superquadric.Deformed(model, [{"kind": "shear"}])
    with pytest.raises(TypeError):
        superquadric.Deformed(3, [])


def test_solids_are_their_parts_and_their_volumes_are_bounded():
    a, b = superquadric.Solid(ball(-0.5)), ball(0.5)
    whole, shared = 4 / 3 * np.pi, 5 / 12 * np.pi
    points = np.random.default_rng(0).uniform(-1.6, 1.6, size=(500, 3))
    in_a, in_b = (np.linalg.norm(points - [x, 0, 0], axis=1) < 1 for x in (-0.5, 0.5))
    cases = [
        (a | b, in_a | in_b, 2 * whole - shared),
        (a & b, in_a & in_b, shared),
        (a - b, in_a & ~in_b, whole - shared),
        (b - a, in_b & ~in_a, whole - shared),
        (superquadric.Solid.union([a, b]), in_a | in_b, 2 * whole - shared),
    ]
    for solid, inside, volume in cases:
        assert np.array_equal(solid.contains(points), inside)
        least, most = solid.volume_bounds(1e-3)
        assert least <= volume <= most
        assert most - least <= 1e-3 * most
        again = superquadric.Solid.from_json(solid.to_json())
        assert np.array_equal(again.contains(points), inside)
        vertices, triangles = solid.mesh(40)
        edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        assert len(np.unique(edges, axis=0)) == len(edges) == 3 * len(triangles)
        low, high = solid.bounding_box
        assert np.all(vertices > low - 1e-9)
        assert np.all(vertices < high + 1e-9)
    with pytest.raises(superquadric.ModelError, match="at least one"):
        superquadric.Solid.union([])


def test_first_hits_of_balls_are_the_quadratics():
    scene = superquadric.Scene([ball(0.0), ball(5.0, 2.0)])
    assert len(scene) == 2
    origins = np.array([[-4.0, 0.3, 0.0], [8.0, 0.0, 1.0], [0.0, 4.0, 0.0], [0.0, 0.0, 0.0]])
    directions = np.array([[2.0, 0, 0], [-1.0, 0, 0], [0.0, 1.0, 0.0], [1.0, 0, 0]])
    hits = scene.first_hits(origins, directions)
    expected = [(4 - np.sqrt(1 - 0.09)) / 2, 3 - np.sqrt(3), np.inf, 1.0]
    np.testing.assert_allclose(hits["t"], expected, rtol=1e-13)
    assert hits["solids"].tolist() == [0, 1, -1, 0]
    hit = hits["solids"] >= 0
    reached = origins[hit] + hits["t"][hit, None] * directions[hit]
    np.testing.assert_allclose(hits["positions"][hit], reached, atol=1e-13)
    assert np.all(np.isnan(hits["normals"][~hit]))
    np.testing.assert_allclose(hits["normals"][0], reached[0], atol=1e-12)
    assert scene.first_hits(np.zeros((2, 5, 3)), [1.0, 0, 0])["t"].shape == (2, 5)
    with pytest.raises(superquadric.ArrayError, match=r"\(\.\.\., 3\)"):
        scene.first_hits([0.0, 0.0], [1.0, 0.0])


def test_a_rendering_is_the_first_hits_of_the_cameras_rays():
    camera = superquadric.Camera(60, 60, 20, 15, 41, 31)
    bent = superquadric.Deformed(superquadric.Superellipsoid([0.5, 1.5, 0.4], [0.3, 0.4]), [BEND])
    scene = superquadric.Scene([bent, ball(1.0, 0.5)])
    motion = np.array([[1.0, 0, 0, -0.2], [0, 1, 0, 0.1], [0, 0, 1, 5.0]])
    images = scene.render(camera, camera_from_world=motion)
    assert images["shaded"].dtype == np.uint8
    assert images["shaded"].shape == images["normals"].shape == (31, 41, 3)
    columns, rows = np.meshgrid(np.arange(41), np.arange(31))
    rays = np.stack([(columns - 20) / 60, (rows - 15) / 60, np.ones(columns.shape)], axis=-1)
    hits = scene.first_hits(-motion[:, 3], rays)
    depth = np.where(np.isfinite(hits["t"]), hits["t"], 0)
    np.testing.assert_allclose(images["depth"], depth, atol=1e-12)
    assert np.array_equal(images["solids"], hits["solids"])
    assert set(np.unique(images["solids"])) == {-1, 0, 1}
    with pytest.raises(superquadric.ModelError, match="camera"):
        scene.render()


def test_scenes_are_read_from_files():
    for name in ["booleans.json", "table.toml"]:
        scene = superquadric.Scene.load(ROOT / "samples/solids" / name)
        assert len(scene) >= 3
    small = json.loads((ROOT / "samples/solids/booleans.json").read_text())
    small["camera"].update(fx=42, fy=42, cx=19.5, cy=14.5, width=40, height=30)
    images = superquadric.Scene.from_dict(small).render()
    assert 0.05 < np.mean(images["depth"] > 0) < 0.5


def test_deformed_models_and_solids_are_outlined():
    camera = superquadric.OrthographicCamera([20, 20], [50, 40], 100, 80)
    pose = {"translation": [0, 0, 5]}
    ball = superquadric.Superellipsoid([1, 1, 1], [1, 1], **pose)
    longer = superquadric.Deformed(ball, [{"kind": "scale", "factors": [2, 1, 1]}])
    bored = superquadric.Solid(ball) - superquadric.Superellipsoid([0.3, 0.3, 9], [1, 1], **pose)
    area = superquadric.contour(ball, camera).area
    assert superquadric.contour(longer, camera).area == pytest.approx(2 * area, rel=1e-3)
    # The needle's section is a disc of its own width where it leaves the ball.
    hole = area - superquadric.contour(bored, camera).area
    assert hole == pytest.approx(np.pi * (20 * 0.3) ** 2, rel=0.05)


def test_samples_of_a_deformed_model_are_on_its_surface_and_the_same_for_a_seed():
    shape = superquadric.Superellipsoid([1, 2, 3], [0.5, 1.2], translation=[5, 6, 7])
    twist = {"kind": "twist", "profile": {"form": "line", "at_zero": 0, "slope": 0.5}}
    twisted = superquadric.Deformed(shape, [twist])
    points = twisted.sample(500, 3)
    assert points.shape == (500, 3)
    assert np.abs(twisted.inside_outside(points) - 1).max() < 1e-9
    assert np.array_equal(points, twisted.sample(500, 3))
    assert not np.array_equal(points, twisted.sample(500, 4))
    with pytest.raises(MemoryError):
        twisted.sample(2**62)
