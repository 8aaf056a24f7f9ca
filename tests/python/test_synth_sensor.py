"""Each part of the sensors, on images without open3d."""

import math

import numpy as np
import pytest

from superquadric.synth.sensor import PARTS, PRESETS, Sensor, greatest_step, read
from superquadric.synth.view import View

FOCAL_LENGTH = 525.0
SHAPE = (100, 200)
SPREAD = 0.03
"""Relative error of a standard deviation of 20,000 numbers: six times 1 / sqrt(40,000)."""


def wall(depth, incidence=0.0):
    return View(
        depth=np.full(SHAPE, depth),
        is_object=np.ones(SHAPE, dtype=bool),
        incidence=np.full(SHAPE, incidence),
    )


def edge(near=1.0, far=2.0):
    """A near left half before a far right half."""
    view = wall(near)
    view.depth[:, 100:] = far
    return view


def reading(sensor, view, *, metres_per_unit=1.0, seed=0):
    rng = np.random.default_rng(seed)
    return read(sensor, view, FOCAL_LENGTH, metres_per_unit, rng)


def test_an_ideal_sensor_changes_nothing():
    view = edge()
    view.depth[:10] = math.inf
    found = reading(PRESETS["ideal"], view)
    np.testing.assert_array_equal(found.depth, view.depth)
    assert not found.is_mixed.any()


@pytest.mark.parametrize("name", PRESETS)
def test_a_sensor_without_its_parts_is_ideal(name):
    view = edge()
    np.testing.assert_array_equal(reading(PRESETS[name].without(PARTS), view).depth, view.depth)


# Nguyen et al. by hand: 1.2 mm + 1.9 mm (z - 0.4)^2.
@pytest.mark.parametrize(("depth", "deviation"), [(0.4, 0.0012), (1.4, 0.0031), (2.4, 0.0088)])
def test_noise_grows_with_the_square_of_the_depth(depth, deviation):
    sensor = PRESETS["structured-light"].without(["quantisation"])
    found = reading(sensor, wall(depth)).depth
    assert found.std() == pytest.approx(deviation, rel=SPREAD)
    # The mean of 20,000 numbers, to five standard errors.
    assert found.mean() == pytest.approx(depth, abs=5.0 * deviation / math.sqrt(20_000))


def test_noise_of_a_stereo_is_that_of_its_disparity():
    sensor = PRESETS["active-stereo"].without(["quantisation"])
    disparity = FOCAL_LENGTH * 0.050 / reading(sensor, wall(1.0)).depth
    assert disparity.std() == pytest.approx(0.08, rel=SPREAD)


def test_noise_grows_at_grazing_angles():
    sensor = PRESETS["structured-light"].without(["quantisation", "dropout"])
    steep = reading(sensor, wall(0.4, math.radians(75.0))).depth.std()
    # 0.1 mm / sqrt(0.4) * (75 / 15)^2 on top.
    assert steep == pytest.approx(0.0012 + 0.0001 / math.sqrt(0.4) * 25.0, rel=SPREAD)


def test_disparities_are_whole_steps():
    sensor = PRESETS["structured-light"]
    steps = FOCAL_LENGTH * 0.075 / reading(sensor, wall(1.3)).depth * 8.0
    np.testing.assert_allclose(steps, np.rint(steps), atol=1e-9)
    assert len(np.unique(np.rint(steps))) > 3


def test_pixels_at_jumps_mix_both_depths_or_are_lost():
    sensor = Sensor(jump_mixed=0.4, jump_lost=0.25)
    found = reading(sensor, edge())
    is_jump = np.zeros(SHAPE, dtype=bool)
    is_jump[:, 99:101] = True
    is_lost = np.isinf(found.depth)
    assert not (found.is_mixed | is_lost)[~is_jump].any()
    # Of 200 pixels; 0.2 is more than five standard deviations.
    assert found.is_mixed[is_jump].mean() == pytest.approx(0.4, abs=0.2)
    assert is_lost[is_jump].mean() == pytest.approx(0.25, abs=0.2)
    mixed = found.depth[found.is_mixed]
    assert ((mixed > 1.0) & (mixed < 2.0)).all()
    assert np.ptp(mixed) > 0.8


def test_nothing_is_mixed_with_nothing():
    found = reading(Sensor(jump_mixed=1.0), edge(far=math.inf))
    assert not found.is_mixed.any()
    np.testing.assert_array_equal(found.depth, edge(far=math.inf).depth)


@pytest.mark.parametrize(("degrees", "share"), [(69.0, 0.0), (77.5, 0.5), (86.0, 1.0)])
def test_grazing_pixels_are_lost(degrees, share):
    found = reading(PRESETS["structured-light"], wall(1.0, math.radians(degrees)))
    # Of 20,000 pixels: five standard deviations.
    assert np.isinf(found.depth).mean() == pytest.approx(share, abs=0.02)


def test_a_unit_is_scaled_for_the_sensor():
    sensor = PRESETS["structured-light"]
    metres = reading(sensor, edge()).depth
    tenths = reading(sensor, edge(10.0, 20.0), metres_per_unit=0.1).depth
    # Rounding of the units; a disparity at the edge of a step may fall to either side.
    is_same = np.isclose(tenths, 10.0 * metres, rtol=1e-12)
    assert is_same.mean() > 0.999


def test_switching_a_part_off_draws_the_same_numbers():
    sensor = PRESETS["structured-light"].without(["quantisation"])
    with_jumps, without = (
        reading(s, edge()) for s in (sensor, sensor.without(["flying", "dropout"]))
    )
    np.testing.assert_array_equal(with_jumps.depth[:, :99], without.depth[:, :99])


def test_the_greatest_step_is_that_to_any_neighbour():
    depth = np.array([[1.0, 1.0, 1.0], [1.0, 2.0, 5.0], [1.0, math.inf, math.inf]])
    expected = [[0.0, 1.0, 4.0], [1.0, math.inf, math.inf], [math.inf, -math.inf, -math.inf]]
    np.testing.assert_array_equal(greatest_step(depth), expected)
