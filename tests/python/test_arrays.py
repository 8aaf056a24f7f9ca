"""Arrays of any type and layout give the right result or a typed error."""

import numpy as np
import pytest

import superquadric


class Cloud:
    """Something that NumPy can make an array of, as open3d's vectors."""

    def __init__(self, points):
        self.points = points

    def __array__(self, dtype=None, copy=None):
        return np.array(self.points, dtype=dtype)


def misaligned(points):
    packed = np.zeros(len(points), dtype=[("intensity", "u1"), ("xyz", "f8", 3)])
    packed["xyz"] = points
    return packed["xyz"]


def uneven(points):
    packed = np.zeros(len(points), dtype=[("xyz", "f8", 3), ("intensity", "f4")])
    packed["xyz"] = points
    return packed["xyz"]


def strided(points):
    wide = np.full((2 * len(points), 7), np.nan)
    wide[::2, 1:7:2] = points
    return wide[::2, 1:7:2]


def read_only(points):
    points = points.copy()
    points.flags.writeable = False
    return points


LAYOUTS = {
    "fortran": np.asfortranarray,
    "transposed": lambda points: np.stack(list(points.T)).T,
    "strided": strided,
    "reversed": lambda points: points[::-1].copy()[::-1],
    "mirrored": lambda points: points[:, ::-1].copy()[:, ::-1],
    "misaligned": misaligned,
    "uneven": uneven,
    "big-endian": lambda points: points.astype(">f8"),
    "little-endian": lambda points: points.astype("<f8"),
    "long": lambda points: points.astype(np.longdouble),
    "object with __array__": Cloud,
    "list": lambda points: points.tolist(),
    "read-only": read_only,
}


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS.keys())
def test_layout_does_not_matter(layout, model, points, fit):
    arranged = layout(points)
    assert superquadric.fit(arranged).model == fit.model
    assert np.array_equal(model.gauge(arranged), model.gauge(points))
    assert np.array_equal(model.radial_projection(arranged), model.radial_projection(points))


@pytest.mark.parametrize("dtype", ["f2", "f4", ">f4", "i1", "u2", ">i4", "i8", "u8"])
def test_numbers_of_other_types_are_converted(dtype):
    model = superquadric.Superellipsoid([90, 60, 30], [0.5, 1.0])
    points = model.sample(300).astype("i1" if dtype != "u2" and dtype != "u8" else "u1")
    points = points.astype(dtype)
    doubles = points.astype(np.float64)
    assert superquadric.fit(points).model == superquadric.fit(doubles).model
    assert np.array_equal(model.gauge(points), model.gauge(doubles))


def test_rows_that_are_not_finite_are_skipped_and_counted(points, fit):
    rows = [0, 100, 499]
    broken = np.insert(points, rows, [[np.nan, 0, 0], [0, np.inf, 0], [0, 0, -np.inf]], axis=0)
    found = superquadric.fit(broken)
    assert found.model == fit.model
    assert (found.points, found.points_skipped) == (500, 3)
    assert found.used_mask.dtype == bool
    assert np.array_equal(found.used_mask, np.isfinite(broken).all(axis=1))
    assert np.array_equal(broken[found.used_mask], points)


@pytest.mark.parametrize("shape", [(3,), (4, 2), (2, 4, 3), (0,), (), (3, 500)])
def test_another_shape_is_named(shape):
    with pytest.raises(superquadric.ArrayError) as error:
        superquadric.fit(np.ones(shape))
    assert f"expected an array of shape (n, 3), found {shape}" in str(error.value)


@pytest.mark.parametrize(
    "points", [np.zeros((20, 3), complex), np.full((20, 3), "1"), None, np.zeros((20, 3), bool)]
)
def test_what_is_no_real_number_is_a_type_error(points, model):
    for function in [superquadric.fit, model.gauge]:
        with pytest.raises(TypeError, match="expected an array of real numbers, found dtype"):
            function(points)


def test_an_empty_cloud_is_too_small():
    for points in [np.empty((0, 3)), np.full((50, 3), np.nan)]:
        with pytest.raises(superquadric.FitError, match="0 finite points are too few"):
            superquadric.fit(points)


def test_functions_keep_the_leading_axes(model):
    grid = np.zeros((4, 5, 3))
    for function in [model.gauge, model.inside_outside, model.radial_distance, model.support]:
        assert function(grid).shape == (4, 5)
        assert function(grid[0, 0]).shape == ()
        assert function(grid[:0]).shape == (0, 5)
    assert model.radial_projection(grid).shape == grid.shape
    with pytest.raises(superquadric.ArrayError, match=r"\(\.\.\., 3\), found \(4, 5\)"):
        model.gauge(grid[..., 0])


def test_angles_are_broadcast(model):
    eta, omega = np.linspace(-1, 1, 4)[:, None], np.float32([0.5, 1.5])
    for function in [model.position, model.normal]:
        vectors = function(eta, omega)
        assert vectors.shape == (4, 2, 3)
        assert np.array_equal(vectors[2, 1], function(eta[2, 0], omega[1]))
    with pytest.raises(ValueError, match="broadcast"):
        model.position(np.zeros(2), np.zeros(3))


def test_functions_of_what_is_not_finite_are_not_numbers(model):
    points = np.array([[np.nan, 0, 0], [0, 0, 0], [0, np.inf, 0], [0, np.nan, 1]])
    expected = [True, False, True, True]
    for function in [model.gauge, model.inside_outside, model.radial_distance, model.support]:
        assert np.array_equal(np.isnan(function(points)), expected)
    assert np.array_equal(np.isnan(model.radial_projection(points)).all(axis=1), expected)
    for function in [model.position, model.normal]:
        assert np.isnan(function(np.nan, 0)).all()
        assert np.isnan(function(0, np.nan)).any()
