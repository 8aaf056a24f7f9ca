"""Clouds from files."""

import numpy as np
import pytest

import superquadric


def test_points_are_read_with_what_was_skipped(tmp_path):
    points = np.array([[1, 2, 3], [np.nan, 0, 0], [4, 5, 6], [0, np.inf, 0]])
    np.save(tmp_path / "cloud.npy", points)
    found = superquadric.read(tmp_path / "cloud.npy")
    assert found.dtype == np.float64
    assert np.array_equal(found, points[[0, 2]])
    found, skipped = superquadric.read(str(tmp_path / "cloud.npy"), return_skipped=True)
    assert np.array_equal(found, points[[0, 2]])
    assert np.array_equal(skipped, [1, 3])
    assert skipped.dtype == np.int64


@pytest.mark.parametrize("dtype", ["<f4", ">f8"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_numpy_files_of_any_layout_are_read(tmp_path, points, dtype, order):
    stored = np.array(points, dtype=dtype, order=order)
    np.save(tmp_path / "cloud.npy", stored)
    assert np.array_equal(superquadric.read(tmp_path / "cloud.npy"), stored)


def test_a_cloud_without_finite_rows_is_empty(tmp_path):
    (tmp_path / "cloud.xyz").write_text("nan nan nan\n")
    assert superquadric.read(tmp_path / "cloud.xyz").shape == (0, 3)


def test_what_is_wrong_with_a_file_is_named(tmp_path):
    (tmp_path / "cloud.xyz").write_text("1 2 3\n1 2 x\n")
    with pytest.raises(superquadric.CloudError, match=r"cloud\.xyz.*line 2"):
        superquadric.read(tmp_path / "cloud.xyz")
    with pytest.raises(FileNotFoundError, match=r"none\.ply"):
        superquadric.read(tmp_path / "none.ply")
    with pytest.raises(IsADirectoryError):
        superquadric.read(tmp_path)
    with pytest.raises(TypeError):
        superquadric.read(3)
