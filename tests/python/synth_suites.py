"""Suite files for tests, changed by their text."""

from pathlib import Path

from superquadric.synth import read_suite

SHIPPED = Path(__file__).parents[2] / "data_synth"

SMALL = """
name = "small"
description = "For tests"
unit = "m"
frame = "camera"
seed = 11
scenes = 2

[placement]
kind = "floating"
offset = [2.0, 5.0]

[camera]
width = 160
height = 120
fx = 150.0
fy = 140.0
cx = 70.25
cy = 66.5
depth_unit = 0.0001
fill = [0.33, 0.5]
backdrop = 2.0

[[family]]
name = "any"
size = [[0.1, 0.4], [0.1, 0.4], [0.1, 0.4]]
exponents = [[0.1, 1.9], [0.1, 1.9]]

[[level]]
name = "seen"
source = "depth-map"
sensor = "structured-light"
points = [300, 400]
"""


def changed(*changes):
    """The text with parts of it replaced, each of which must be there."""
    text = SMALL
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return text


def suite_of(folder, *changes):
    """The suite of the changed text."""
    path = folder / "suite.toml"
    path.write_text(changed(*changes), encoding="utf-8")
    return read_suite(path)


AS_WHOLE = ("depth-map", "whole"), ('sensor = "structured-light"', "noise = 0.05")
IN_WORLD = 'frame = "camera"', 'frame = "world"'
IDEAL = "structured-light", "ideal"
ON_TABLE = (
    'kind = "floating"\noffset = [2.0, 5.0]',
    'kind = "standing"\ntable = [3.0, 2.0]\nup = ["x", "y", "z"]\ncut = 0.006',
)
STRAYS = "points =", "strays = 0.25\npoints ="
