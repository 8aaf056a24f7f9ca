import os
from pathlib import Path

import numpy as np
import pytest

import superquadric

ROOT = Path(__file__).parents[2]
VARIABLE = "SUPERQUADRIC_BINARY"


@pytest.fixture(scope="session")
def model():
    """A model whose parameters are all different."""
    return superquadric.Superellipsoid(
        [2.0, 1.0, 0.5], [0.4, 1.3], euler_zyz=[0.3, 1.1, -0.8], translation=[4.0, -2.0, 7.0]
    )


@pytest.fixture(scope="session")
def points(model):
    """Noisy points of its surface, of shape (500, 3)."""
    return model.sample(500, seed=1) + np.random.default_rng(1).normal(scale=0.005, size=(500, 3))


@pytest.fixture(scope="session")
def fit(points):
    return superquadric.fit(points)


@pytest.fixture(scope="session")
def binary():
    """The built command line: named by the environment, or where cargo puts it."""
    if VARIABLE in os.environ:
        return Path(os.environ[VARIABLE])
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    built = [target / profile / "superquadric" for profile in ("release", "debug")]
    for path in built:
        if path.exists():
            return path
    pytest.skip(f"no command line to compare with: build it, or set {VARIABLE}")
