"""Clouds and depth maps of superquadrics whose truth is known, made from suite files.

`python -m superquadric.synth SUITE.toml -o DIR` makes a suite. Depth maps need open3d, which is
imported only then: `pip install 'superquadric[synth]'`.

Frames are in names: `model`, `world`, and `camera` with x to the right, y down and z forward.
"""

from .errors import MissingExtraError, SuiteError, SynthError
from .generate import generate
from .suite import Suite
from .suite_file import read_suite

__all__ = ["MissingExtraError", "Suite", "SuiteError", "SynthError", "generate", "read_suite"]
