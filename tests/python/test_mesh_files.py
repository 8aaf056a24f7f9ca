"""Mesh files keep the model whose surface they hold."""

import numpy as np
import pytest

import superquadric


@pytest.mark.parametrize("extension", ["ply", "obj", "stl", "glb"])
def test_the_model_comes_back_from_its_mesh(model, tmp_path, extension):
    path = tmp_path / f"mesh.{extension}"
    superquadric.write_mesh(model, path, resolution=4)
    read = superquadric.read_mesh_model(path)
    for name in ["size", "exponents", "translation"]:
        np.testing.assert_array_equal(getattr(read, name), getattr(model, name))
    tolerance = 2e-15 if extension == "stl" else 0.0
    np.testing.assert_allclose(read.rotation, model.rotation, rtol=0.0, atol=tolerance)


def test_a_fit_is_written_as_its_model(fit, tmp_path):
    superquadric.write_mesh(fit, tmp_path / "fit.glb")
    assert superquadric.read_mesh_model(tmp_path / "fit.glb") == fit.model


@pytest.mark.parametrize("extension", ["ply", "obj", "stl", "glb"])
def test_other_families_come_back_too(tmp_path, extension):
    toroid = superquadric.Supertoroid([1, 0.7, 0.4], [0.4, 1.3], 2.5, euler_zyz=[0.3, 1.1, -0.8])
    path = tmp_path / f"mesh.{extension}"
    superquadric.write_mesh(toroid, path, resolution=4)
    read = superquadric.read_mesh_model(path)
    assert read.to_dict()["shape"] == toroid.to_dict()["shape"]
    tolerance = 2e-15 if extension == "stl" else 0.0
    np.testing.assert_allclose(read.rotation, toroid.rotation, rtol=0.0, atol=tolerance)


def test_errors_name_the_file(model, tmp_path):
    plain = tmp_path / "plain.ply"
    plain.write_text("ply\nend_header\n")
    with pytest.raises(superquadric.ExchangeError, match=r"plain\.ply: no model is inscribed"):
        superquadric.read_mesh_model(plain)
    with pytest.raises(superquadric.ExchangeError, match="ply, obj, stl or glb"):
        superquadric.write_mesh(model, tmp_path / "mesh.step")
    with pytest.raises(superquadric.ModelError):
        superquadric.write_mesh(model, tmp_path / "mesh.ply", resolution=3)
    with pytest.raises(FileNotFoundError, match="absent"):
        superquadric.read_mesh_model(tmp_path / "absent.stl")
