"""Suite files: the shipped ones are sound, and slips are named."""

import pytest
from synth_suites import AS_WHOLE, SHIPPED, changed, suite_of

from superquadric.synth import SuiteError, read_suite
from superquadric.synth.sensor import PRESETS

EXPECTED = {
    "boxes-and-cans",
    "full",
    "full-noise",
    "outliers",
    "single-view",
    "smoke",
    "table-top",
    "thin",
}


def test_shipped_suites_are_named_after_their_files():
    suites = {path.stem: read_suite(path) for path in SHIPPED.glob("*.toml")}
    assert set(suites) == EXPECTED
    assert all(suite.name == stem for stem, suite in suites.items())


def test_shipped_suites_draw_different_numbers():
    seeds = [read_suite(path).seed for path in SHIPPED.glob("*.toml")]
    assert len(set(seeds)) == len(seeds) == len(EXPECTED)


def test_levels_of_noise_and_strays_are_as_promised():
    noise = read_suite(SHIPPED / "full-noise.toml").levels
    assert [level.source.noise for level in noise] == [0.0, 0.01, 0.02, 0.05]
    assert [level.strays for level in read_suite(SHIPPED / "outliers.toml").levels] == [
        0.2,
        0.4,
        0.6,
    ]


def test_a_level_has_the_sensor_without_what_is_switched_off(tmp_path):
    suite = suite_of(tmp_path, ("points =", 'without = ["noise", "flying"]\npoints ='))
    sensor = suite.levels[0].source.sensor
    whole = PRESETS["structured-light"]
    assert sensor.noise_floor == sensor.noise_growth == sensor.jump_mixed == 0.0
    assert sensor.disparity_step == whole.disparity_step
    assert sensor.jump_lost == whole.jump_lost


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("scenes = 2", "scenes = 2\nsceens = 3"), "unknown key sceens (known here: "),
        (("cx = 70.25", "cx = 70.25\nzoom = 2"), "unknown key camera.zoom"),
        (("[300, 400]", "[300, 400]\nnoise = 0.1"), r"unknown key level[0].noise"),
        (("scenes = 2", ""), "scenes: is missing"),
        (("scenes = 2", "scenes = 2.5"), "scenes: must be a whole number from 1, found 2.5"),
        (("seed = 11", "seed = true"), "seed: must be a whole number from 0, found True"),
        (('unit = "m"', 'unit = "inch"'), "unit: must be one of m, none, found 'inch'"),
        (("[300, 400]", "[300, 400.5]"), "level[0].points: must be whole"),
        (("[300, 400]", "[400, 300]"), "level[0].points: must be a pair in rising order"),
        (("[[0.1, 1.9], [0.1, 1.9]]", "[0.1, 2.5]"), "from 0.01 to 2, found 2.5"),
        (("[[0.1, 1.9], [0.1, 1.9]]", "[0.1]"), "family[0].exponents: must be a list of 2"),
        (("[[0.1, 1.9], [0.1, 1.9]]", "[nan, 1]"), "must be a number from 0.01 to 2, found nan"),
        (("fill = [0.33, 0.5]", "fill = 0.4\ndistance = 1"), "needs either fill or distance"),
        (("fill = [0.33, 0.5]", ""), "needs either fill or distance"),
        (("structured-light", "sonar"), "level[0].sensor: must be one of ideal, "),
        (('name = "seen"', 'name = "../seen"'), "level[0].name: must be of letters"),
        (("[300, 400]", '[300, 400]\nwithout = [["noise"]]'), "level[0].without: must be a list"),
        (("depth-map", "whole"), "unknown key level[0].sensor"),
        (('name = "small"', "name = small"), "suite.toml: "),
        (("[[level]]", "[level]"), "level: must be one table [[...]] at least"),
        (("offset = [2.0, 5.0]", "offset = [2.0, 5.0, 7.0]"), "a number or a pair of them"),
    ],
)
def test_slips_are_named(tmp_path, change, message):
    with pytest.raises(SuiteError) as refusal:
        suite_of(tmp_path, change)
    assert message in str(refusal.value)
    assert str(tmp_path / "suite.toml") in str(refusal.value)


def test_whole_surfaces_are_not_in_a_camera_frame(tmp_path):
    with pytest.raises(SuiteError, match='whole surfaces need frame = "world"'):
        suite_of(tmp_path, *AS_WHOLE)


def test_depth_maps_need_a_camera(tmp_path):
    text = changed()
    start, end = text.index("[camera]"), text.index("[[family]]")
    (tmp_path / "suite.toml").write_text(text[:start] + text[end:], encoding="utf-8")
    with pytest.raises(SuiteError, match=r"depth maps need a table \[camera\]"):
        read_suite(tmp_path / "suite.toml")


def test_names_of_levels_differ(tmp_path):
    level = changed()[changed().index("[[level]]") :]
    with pytest.raises(SuiteError, match="names must differ, found seen, seen"):
        suite_of(tmp_path, (level, level + level))


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(SuiteError, match="nowhere"):
        read_suite(tmp_path / "nowhere.toml")
