"""The estimator follows scikit-learn's conventions without importing it."""

import inspect

import numpy as np
import pytest

import superquadric
from superquadric import SuperquadricEstimator


def clone(estimator):
    """What `sklearn.base.clone` does and asserts."""
    parameters = estimator.get_params(deep=False)
    again = type(estimator)(**parameters)
    assert all(again.get_params(deep=False)[name] is parameters[name] for name in parameters)
    return again


def test_parameters_are_those_of_the_constructor():
    names = list(inspect.signature(SuperquadricEstimator).parameters)
    assert list(SuperquadricEstimator().get_params()) == names
    options = inspect.signature(superquadric.fit).parameters
    assert names == [name for name in options if name != "points"]
    for name in names:
        parameters = [
            inspect.signature(f).parameters for f in (SuperquadricEstimator, superquadric.fit)
        ]
        assert parameters[0][name].default == parameters[1][name].default


def test_fitted_attributes_are_those_of_the_fit(points, fit):
    estimator = SuperquadricEstimator()
    assert estimator.fit(points, y=None) is estimator
    assert estimator.model_ == fit.model
    assert estimator.fit_.rms_radial == fit.rms_radial
    assert estimator.n_features_in_ == 3
    assert estimator.score(points) == pytest.approx(-fit.relative_rms, rel=1e-9)
    assert estimator.score(points + 0.1) < estimator.score(points)


def test_inliers_are_finite_rows_next_to_the_model(points):
    rows = np.vstack([points, [[np.nan, 0, 0]], [[0, 0, 0]]])
    mask = SuperquadricEstimator().fit(np.vstack([points, points, rows])).inlier_mask_[-502:]
    assert mask.dtype == bool
    assert mask[:500].mean() > 0.98
    assert not mask[500:].any()


def test_score_leaves_out_rows_that_are_not_finite(points):
    estimator = SuperquadricEstimator().fit(points)
    rows = np.vstack([points, [[np.nan, 0, 0]]])
    assert estimator.score(rows) == estimator.score(points)
    assert np.isnan(estimator.score(rows[-1:]))


def test_an_estimator_can_be_cloned_and_changed(points):
    estimator = clone(SuperquadricEstimator(seed=3, threads=1))
    assert repr(estimator) == ("SuperquadricEstimator(seed=3, threads=1)")
    assert estimator.set_params(seed=4) is estimator
    assert estimator.fit(points).fit_.seed == 4
    assert not hasattr(clone(estimator), "model_")
    with pytest.raises(ValueError, match="no option 'speed'"):
        estimator.set_params(speed=1)


def test_an_unfitted_estimator_has_no_model(points):
    with pytest.raises(AttributeError):
        SuperquadricEstimator().score(points)
