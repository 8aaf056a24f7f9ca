"""What a caller knows besides the points."""

import numpy as np
import pytest

import superquadric


@pytest.fixture(scope="module")
def can():
    model = superquadric.Superellipsoid([0.05, 0.05, 0.1], [0.1, 1.0], translation=[0.1, 0.0, 0.6])
    noise = np.random.default_rng(1).normal(scale=0.0005, size=(800, 3))
    return model, model.sample(800, seed=1) + noise


def test_strays_are_told_from_the_surface(can):
    _, points = can
    strays = np.random.default_rng(2).uniform([-0.1, -0.2, 0.4], [0.3, 0.2, 0.8], size=(400, 3))
    rows = np.vstack([points, [[np.nan] * 3], strays])
    fit = superquadric.fit(rows)
    assert fit.inlier_mask.shape == (1201,)
    assert fit.inlier_mask[:800].mean() > 0.98
    assert not fit.inlier_mask[800]
    assert fit.inlier_mask[801:].mean() < 0.05
    assert fit.inliers == fit.inlier_mask.sum()
    assert fit.stray_share == pytest.approx(1 / 3, abs=0.03)
    assert fit.noise == pytest.approx(0.0005, rel=0.1)


def test_noise_along_the_rays_is_told_from_noise_alike_in_all_directions(can):
    model, points = can
    assert superquadric.fit(points).range_noise is None
    surface = model.sample(4000, seed=1)
    viewpoint = np.array([0.6, 0.2, 0.1])
    rays = surface - viewpoint
    faces_sensor = np.sum(model.inside_outside_gradient(surface) * rays, axis=1) < 0.0
    seen = surface[faces_sensor]
    rays = rays[faces_sensor] / np.linalg.norm(rays[faces_sensor], axis=1, keepdims=True)
    noise = np.random.default_rng(3).normal(scale=0.001, size=(len(seen), 1))
    fit = superquadric.fit(seen + noise * rays, viewpoint=viewpoint)
    along, across = fit.range_noise
    assert along == pytest.approx(0.001, rel=0.1)
    assert across < 0.5 * along
    assert np.allclose(sorted(fit.model.size), sorted(model.size), rtol=0.01)


@pytest.mark.parametrize("shape", ["cylinder", "any"])
def test_a_cylinder_has_one_radius(can, shape):
    model, points = can
    fit = superquadric.fit(points, shape=shape)
    a1, a2, a3 = fit.model.size
    assert (a1 == a2) == (shape == "cylinder")
    assert np.allclose([a1, a2, a3], model.size, rtol=0.01)
    errors = fit.standard_errors
    assert errors.shape == (11,)
    assert (errors[4] == 0.0) == (shape == "cylinder")
    assert np.allclose(errors, np.sqrt(np.diag(fit.covariance)))


def test_fixed_parameters_keep_their_values(can):
    _, points = can
    fit = superquadric.fit(points, fix={"a3": 0.1, "e2": 1.0, "z": 0.6})
    assert fit.model.size[2] == pytest.approx(0.1, rel=1e-12)
    assert fit.model.exponents[1] == 1.0
    assert fit.model.translation[2] == pytest.approx(0.6, rel=1e-12)


def test_ranges_and_ties_are_kept(can):
    _, points = can
    fit = superquadric.fit(points, size_range=(0.06, 0.09), exponent_range=(0.5, 1.5), tie="all")
    assert len(set(fit.model.size)) == 1
    assert 0.06 <= fit.model.size[0] <= 0.09 * (1 + 1e-12)
    assert all(0.5 <= e <= 1.5 for e in fit.model.exponents)


def test_support_and_viewpoint_are_taken(can):
    model, points = can
    seen = points[model.normal(0.0, 0.0) @ np.zeros(3) + points[:, 2] < 0.62]
    fit = superquadric.fit(
        seen,
        viewpoint=[0.0, 0.0, 0.0],
        free_rays=[[1.0, 0.0, 1.0, np.inf], [0.4, 0.0, 1.0, 2.0]],
        support=[0.0, 0.0, -1.0, 0.7],
    )
    lowest = fit.model.bounding_box[1, 2]
    assert lowest == pytest.approx(0.7, abs=0.002)


@pytest.mark.parametrize(
    ("options", "error"),
    [
        ({"shape": "cone"}, "shape"),
        ({"tie": "some"}, "tie"),
        ({"fix": {"a4": 1.0}}, "a4"),
        ({"fix": {"e1": 3.0}}, "e1"),
        ({"size_range": (2.0, 1.0)}, "a1"),
        ({"support": [0.0, 0.0, 0.0, 1.0]}, "support"),
        ({"support": [1.0, 2.0]}, "support"),
        ({"free_rays": [[0.0, 0.0, 1.0, 1.0]]}, "viewpoint"),
        ({"viewpoint": [0.0, np.nan, 0.0]}, "viewpoint"),
        ({"viewpoint": [0.0, 0.0, 0.0], "free_rays": [[0.0, 0.0, 1.0, -1.0]]}, "free_rays"),
    ],
)
def test_what_cannot_be_known_is_refused(can, options, error):
    _, points = can
    with pytest.raises(ValueError, match=error):
        superquadric.fit(points, **options)
