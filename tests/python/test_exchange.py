"""Other programs judge what is written for them: they build or read the same surfaces."""

import runpy
import subprocess
import sys

import numpy as np
import pytest

import superquadric

BOTH_WAYS = ["ovito", "liggghts", "lammps", "mercury", "ems", "supercompose"]
POSE = {"euler_zyz": [0.3, 1.1, -0.8], "translation": [4.0, -2.0, 7.0]}


@pytest.fixture(params=[(0.1, 1.0), (0.4, 0.7), (1.0, 1.0)], ids=str)
def convex(request):
    """A solid that every program can express."""
    return superquadric.Superellipsoid([2.0, 1.0, 0.5], request.param, **POSE)


@pytest.fixture(params=[(0.1, 1.0), (0.4, 1.3), (1.9, 0.3)], ids=str)
def solid(request):
    return superquadric.Superellipsoid([2.0, 1.0, 0.5], request.param, **POSE)


@pytest.mark.parametrize("program", BOTH_WAYS)
def test_what_is_written_and_read_is_the_same_solid(convex, program):
    (read,) = superquadric.import_models(superquadric.export_model(convex, program), program)
    low, high = convex.bounding_box
    points = np.random.default_rng(0).uniform(low, high, size=(1000, 3))
    expected = convex.inside_outside(points)
    np.testing.assert_allclose(read.inside_outside(points), expected, rtol=1e-12, atol=1e-12)


def test_errors_name_the_program_the_place_and_the_choice(model):
    with pytest.raises(
        superquadric.ExchangeError, match=r"LAMMPS takes exponents from 0 to 1, .*1\.3"
    ):
        superquadric.export_model(model, "lammps")
    with pytest.raises(superquadric.ExchangeError, match="line 2: expected a number"):
        superquadric.import_models("1 1 1 1 1 0 0 0 0 0 0\n1 1 x\n", "ems")
    toroid = superquadric.Supertoroid([1, 1, 1], [1, 1], 2)
    with pytest.raises(superquadric.ExchangeError, match=r"POV-Ray cannot express .* supertoroid"):
        superquadric.export_model(toroid, "pov")
    with pytest.raises(ValueError, match="vtk, ovito"):
        superquadric.export_model(model, "blender")
    with pytest.raises(ValueError, match="ovito, liggghts"):
        superquadric.import_models("", "vtk")


@pytest.mark.parametrize("source", ["superquadric_source", "parametric_super_ellipsoid"])
def test_vtk_builds_points_of_the_surface(solid, tmp_path, source):
    pytest.importorskip("vtkmodules", reason="VTK is not installed")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    program = tmp_path / "model.py"
    program.write_text(superquadric.export_model(solid, "vtk"))
    built = runpy.run_path(str(program))[source](resolution=64)
    built.Update()
    points = vtk_to_numpy(built.GetOutput().GetPoints().GetData()).astype(float)
    assert len(points) > 3000
    # VTK computes points in floats about the centre, rounded to 6e-8, and moves them in doubles.
    np.testing.assert_allclose(solid.gauge(points), 1.0, atol=1e-6)
    low, high = solid.bounding_box
    np.testing.assert_allclose(points.min(axis=0), low, atol=0.1)
    np.testing.assert_allclose(points.max(axis=0), high, atol=0.1)


@pytest.mark.parametrize("source", ["superquadric_source", "parametric_super_toroid"])
def test_vtk_builds_points_of_a_supertoroid(tmp_path, source):
    pytest.importorskip("vtkmodules", reason="VTK is not installed")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    size, (e1, e2), ring, centre = np.array([1.0, 0.7, 0.4]), (0.4, 1.3), 2.5, [4.0, -2.0, 7.0]
    toroid = superquadric.Supertoroid(size, [e1, e2], ring, translation=centre)
    program = tmp_path / "model.py"
    program.write_text(superquadric.export_model(toroid, "vtk"))
    built = runpy.run_path(str(program))[source](resolution=64)
    built.Update()
    points = vtk_to_numpy(built.GetOutput().GetPoints().GetData()) - centre
    x, y, z = (np.abs(points) / size).T
    from_ring = np.abs((x ** (2 / e2) + y ** (2 / e2)) ** (e2 / 2) - ring)
    # JLS Eq. 2.27, by its gauge.
    gauge = (from_ring ** (2 / e1) + z ** (2 / e1)) ** (e1 / 2)
    np.testing.assert_allclose(gauge, 1.0, atol=1e-6)


def test_the_program_for_vtk_writes_a_file(solid, tmp_path):
    pytest.importorskip("vtkmodules", reason="VTK is not installed")
    program = tmp_path / "model.py"
    program.write_text(superquadric.export_model(solid, "vtk"))
    subprocess.run([sys.executable, program, tmp_path / "model.vtp"], check=True)
    assert "PolyData" in (tmp_path / "model.vtp").read_text(errors="replace")


def test_ovito_takes_the_columns_for_its_properties(solid, tmp_path, monkeypatch):
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    pytest.importorskip("ovito", reason="OVITO is not installed")
    from ovito.io import import_file

    dump = tmp_path / "model.dump"
    dump.write_text(superquadric.export_model(solid, "ovito"))
    particles = import_file(str(dump)).compute().particles
    # It keeps all but positions in floats.
    expected = {
        "Position": solid.translation,
        "Aspherical Shape": solid.size,
        "Superquadric Roundness": solid.exponents[::-1],
    }
    for name, value in expected.items():
        np.testing.assert_allclose(np.array(particles[name])[0], value, rtol=1e-7)
    x, y, z, w = np.array(particles["Orientation"])[0].astype(float)
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    np.testing.assert_allclose(rotation, solid.rotation, atol=1e-6)
