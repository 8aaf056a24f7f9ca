"""Scores compare solids, whatever their parameters."""

import math

import numpy as np
import pytest

import superquadric
from superquadric import Superellipsoid, score

SIZE = [3.0, 2.0, 1.0]
EXPONENTS = [0.3, 0.8]
EULER = [0.5, 1.0, -2.0]
CENTRE = [100.0, -50.0, 7.0]

# Rounding of coordinates near 100.
ROUNDING = 1e-11


def turned(by):
    """The Euler angles, with a further turn about the model's z axis."""
    phi, theta, psi = EULER
    return [phi, theta, psi + by]


def make(size=SIZE, exponents=EXPONENTS, euler_zyz=EULER, translation=CENTRE):
    return Superellipsoid(size, exponents, euler_zyz=euler_zyz, translation=translation)


TRUTH = make()
EQUIVALENT = {
    "itself": TRUTH,
    "x and y swapped": make(size=[2.0, 3.0, 1.0], euler_zyz=turned(math.pi / 2)),
    "half a turn about z": make(euler_zyz=turned(math.pi)),
    "flipped": make(euler_zyz=[0.5 + math.pi, math.pi - 1.0, 2.0]),
    "canonical": TRUTH.canonical(),
}


@pytest.mark.parametrize("other", EQUIVALENT.values(), ids=EQUIVALENT.keys())
def test_equivalent_parameters_are_the_same_solid(other):
    result = score(TRUTH, other)
    assert result.volume_iou == pytest.approx(1, abs=1e-3)
    assert result.surface_distance < ROUNDING
    assert result.size_error < ROUNDING
    assert result.rotation_error < ROUNDING


def test_a_smaller_model_overlaps_by_its_share_of_the_volume():
    result = score(TRUTH, make(size=0.97 * np.array(SIZE)))
    # It is inside the other: the share of its points that is common is known without error.
    assert result.volume_iou == pytest.approx(0.97**3, abs=5 * result.volume_iou_error + 1e-12)
    assert result.size_error == pytest.approx(0.03, abs=1e-12)
    assert result.rotation_error < ROUNDING


def test_a_wrong_rotation_is_seen():
    result = score(TRUTH, make(euler_zyz=turned(0.5)))
    assert result.rotation_error == pytest.approx(0.5, abs=ROUNDING)
    assert score(TRUTH, make(euler_zyz=turned(math.pi / 2))).volume_iou < 0.7
    assert result.size_error < ROUNDING


def test_disjoint_models_do_not_overlap():
    result = score(TRUTH, make(translation=[0, 0, 0]))
    assert (result.volume_iou, result.volume_iou_error) == (0, 0)


def test_concentric_spheres_are_apart_by_the_difference_of_radii():
    spheres = [Superellipsoid([r] * 3, [1, 1], translation=CENTRE) for r in (2.0, 2.5)]
    result = score(*spheres)
    assert result.surface_distance == pytest.approx(0.25, abs=1e-9)
    assert result.volume_iou == pytest.approx((2 / 2.5) ** 3, abs=1e-12)
    assert result.rotation_error == 0


def test_samples_and_seed_are_passed_on():
    other = make(size=[3.1, 1.9, 1.0], translation=[100.1, -50, 7])
    coarse, fine = score(TRUTH, other, samples=500), score(TRUTH, other, samples=50_000)
    assert fine.volume_iou_error < coarse.volume_iou_error
    assert fine.surface_distance_error < coarse.surface_distance_error
    again, reseeded = score(TRUTH, other, samples=500), score(TRUTH, other, samples=500, seed=1)
    assert again.volume_iou == coarse.volume_iou
    assert reseeded.surface_distance != coarse.surface_distance


def test_inliers_are_measured_from_the_recovered_model(model, points, fit):
    assert score(model, fit).rms_inliers is None
    result = score(model, fit, inliers=np.vstack([points, [[np.nan] * 3]]))
    assert result.rms_inliers == pytest.approx(fit.rms_radial, rel=1e-9)
    assert "rms_inliers" in repr(result)
    assert np.isnan(score(model, fit, inliers=np.empty((0, 3))).rms_inliers)
    with pytest.raises(superquadric.ArrayError, match=r"inliers: .* found \(500,\)"):
        score(model, fit, inliers=points[:, 0])


def test_what_is_no_solid_is_a_type_error(model):
    for arguments in [(model, {}), (None, model)]:
        with pytest.raises(TypeError, match="expected a Superellipsoid or a Fit, found"):
            score(*arguments)
    with pytest.raises(MemoryError):
        score(model, model, samples=2**60)
