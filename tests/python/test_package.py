"""What the package is made of, and what it brings along."""

import subprocess
import sys

import pytest

import superquadric

IMPORTED = """
import sys
import numpy
before = set(sys.modules)
import superquadric
print(*sorted({name.partition(".")[0] for name in set(sys.modules) - before}))
"""


def run(*arguments):
    return subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=False)


def test_import_brings_nothing_but_numpy():
    modules = run("-c", IMPORTED).stdout.split()
    assert "superquadric" in modules
    foreign = set(modules) - {"superquadric", "numpy"} - set(sys.stdlib_module_names)
    assert not foreign


def test_stubs_are_those_of_the_module():
    pytest.importorskip("mypy")
    result = run("-m", "mypy.stubtest", "superquadric")
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.mark.parametrize("name", superquadric.__all__)
def test_public_names_are_documented_and_say_where_they_are(name):
    value = getattr(superquadric, name)
    if name == "__version__":
        assert value.count(".") == 2
        return
    assert value.__doc__
    assert value.__module__.split(".")[0] == "superquadric"


def test_exceptions_are_value_errors_with_one_base():
    names = [
        "ArrayError",
        "BatchError",
        "CloudError",
        "DocumentError",
        "ExchangeError",
        "FitError",
        "ImageError",
        "ModelError",
        "ViewError",
    ]
    for name in names:
        error = getattr(superquadric, name)
        assert issubclass(error, superquadric.SuperquadricError)
        assert issubclass(error, ValueError)


def test_members_are_documented():
    for kind in [
        superquadric.Camera,
        superquadric.Contour,
        superquadric.DepthMap,
        superquadric.Fit,
        superquadric.OrthographicCamera,
        superquadric.RimCurve,
        superquadric.Score,
        superquadric.Shape,
        superquadric.Superellipsoid,
        superquadric.SuperhyperboloidOneSheet,
        superquadric.SuperhyperboloidTwoSheets,
        superquadric.Supertoroid,
        superquadric.ThreeExponent,
    ]:
        for name, member in vars(kind).items():
            assert name.startswith("_") or member.__doc__, f"{kind.__name__}.{name}"
