"""Suites as they are written: layout, truth, the same bytes, whole or not at all."""

import hashlib
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from synth_suites import AS_WHOLE, IDEAL, IN_WORLD, ON_TABLE, SHIPPED, STRAYS, changed, suite_of

import superquadric
from superquadric.synth import SynthError, generate
from superquadric.synth.__main__ import main
from superquadric.synth.generate import SCHEMA

needs_open3d = pytest.mark.usefixtures("open3d")

PLY_ROW = np.dtype([("xyz", "<f8", (3,)), ("inlier", "u1")])
WHOLE = {"cloud.ply", "truth.json"}
SEEN = WHOLE | {"depth.png", "mask.png", "camera.json"}


@pytest.fixture(scope="module")
def open3d():
    return pytest.importorskip("open3d", reason="depth maps need open3d: superquadric[synth]")


@pytest.fixture(scope="module")
def smoke(open3d, tmp_path_factory):
    """The shipped suite `smoke`, made by the command."""
    folder = tmp_path_factory.mktemp("suites") / "smoke"
    assert main([str(SHIPPED / "smoke.toml"), "-o", str(folder)]) == 0
    return folder


def load(path):
    return json.loads(path.read_text(encoding="utf-8"))


def model_of(scene):
    return superquadric.Superellipsoid.from_dict(load(scene / "truth.json")["model"])


def inliers_of(scene):
    body = (scene / "cloud.ply").read_bytes().partition(b"end_header\n")[2]
    return np.frombuffer(body, PLY_ROW)["inlier"] == 1


def hashes(folder):
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in folder.rglob("*")
        if path.is_file()
    }


def made(tmp_path, *changes):
    """The scenes of a changed suite."""
    generate(suite_of(tmp_path, *changes), tmp_path / "made")
    return sorted((tmp_path / "made" / "scenes").iterdir())


def pixels_of(open3d, scene):
    """Points of the object's pixels, of shape (n, 3), row by row, from the written images."""
    counts, mask = (
        np.asarray(open3d.io.read_image(str(scene / name))) for name in ("depth.png", "mask.png")
    )
    assert counts.dtype == np.uint16
    assert set(np.unique(mask)) == {0, 255}
    camera = load(scene / "camera.json")
    rows, columns = np.nonzero((counts > 0) & (mask > 0))
    depth = counts[rows, columns] * camera["depth_units"]
    x = (columns - camera["cx"]) / camera["fx"] * depth
    y = (rows - camera["cy"]) / camera["fy"] * depth
    return np.stack([x, y, depth], axis=-1)


def test_the_layout_is_as_documented(smoke):
    suite = load(smoke / "suite.json")
    assert suite["schema"] == SCHEMA
    assert suite["levels"] == ["whole", "ideal", "structured-light", "noiseless"]
    assert {path.name for path in (smoke / "scenes").iterdir()} == {
        scene["name"] for scene in suite["scenes"]
    }
    assert len(suite["scenes"]) == 8
    for scene in suite["scenes"]:
        names = {path.name for path in (smoke / "scenes" / scene["name"]).iterdir()}
        assert names == (WHOLE if scene["level"] == "whole" else SEEN)


def test_truths_agree_with_the_clouds_and_the_list(smoke):
    for entry in load(smoke / "suite.json")["scenes"]:
        scene = smoke / "scenes" / entry["name"]
        truth = load(scene / "truth.json")
        assert {truth[key] == entry[key] for key in ("level", "family", "points")} == {True}
        inliers = inliers_of(scene)
        assert truth["points"] == len(superquadric.read(scene / "cloud.ply")) == len(inliers)
        assert truth["inliers"] == inliers.sum()


def test_a_truth_is_a_model_for_the_core(smoke):
    truth = smoke / "scenes" / "whole-0000" / "truth.json"
    assert superquadric.Superellipsoid.load(truth) == model_of(truth.parent)


def test_the_same_suite_gives_the_same_bytes(smoke, tmp_path):
    assert main([str(SHIPPED / "smoke.toml"), "-o", str(tmp_path / "again"), "--jobs", "2"]) == 0
    assert hashes(tmp_path / "again") == hashes(smoke)


@needs_open3d
def test_another_seed_gives_another_suite(tmp_path):
    first = hashes(made(tmp_path)[0])
    (tmp_path / "other").mkdir()
    second = hashes(made(tmp_path / "other", ("seed = 11", "seed = 12"))[0])
    assert first["camera.json"] == second["camera.json"]
    assert all(first[name] != second[name] for name in SEEN - {"camera.json"})


@pytest.mark.parametrize("frame", ["camera", "world"])
def test_clouds_are_the_pixels_in_the_frame_they_name(open3d, tmp_path, frame):
    change = ('frame = "camera"', f'frame = "{frame}"')
    for scene in made(tmp_path, change, IDEAL, ("[300, 400]", "100000")):
        truth = load(scene / "truth.json")
        assert truth["frame"] == frame
        points_camera = pixels_of(open3d, scene)
        cloud = superquadric.read(scene / "cloud.ply")
        camera_from_world = np.array(truth["camera_from_world"])
        if frame == "world":
            cloud = cloud @ camera_from_world[:3, :3].T + camera_from_world[:3, 3]
        rows = np.rint(cloud[:, 1] / cloud[:, 2] * 140.0 + 66.5)
        columns = np.rint(cloud[:, 0] / cloud[:, 2] * 150.0 + 70.25)
        # Rounding of some motions of a metre.
        ordered = cloud[np.lexsort([columns, rows])]
        np.testing.assert_allclose(ordered, points_camera, rtol=0, atol=1e-12)


@needs_open3d
@pytest.mark.parametrize("change", [[], [IN_WORLD], [IN_WORLD, ON_TABLE], [ON_TABLE]])
def test_ideal_clouds_lie_on_their_truth(tmp_path, change):
    for scene in made(tmp_path, IDEAL, *change):
        model = model_of(scene)
        distance = np.abs(model.radial_distance(superquadric.read(scene / "cloud.ply")))
        # The mesh errs by 3e-4 mean semi-axes; half a count is 0.05 mm along the ray, a ray
        # within the image is no longer than 1.3 depths, and radial lengths no more than the
        # aspect times those along the normal.
        aspect = model.size.max() / model.size.min()
        assert distance.max() < 1e-3 * model.mean_semi_axis + 0.5e-4 * 1.3 * aspect
        assert inliers_of(scene).all()


@needs_open3d
def test_real_sensors_err_at_outlines_most(tmp_path):
    for scene in made(tmp_path):
        model = model_of(scene)
        distance = np.abs(model.radial_distance(superquadric.read(scene / "cloud.ply")))
        is_inlier = inliers_of(scene)
        assert 0 < (~is_inlier).sum() < is_inlier.sum()
        assert np.median(distance[is_inlier]) < 0.01 < distance[~is_inlier].max()


@needs_open3d
def test_the_object_fills_the_share_of_the_image(open3d, tmp_path):
    for scene in made(tmp_path):
        rows, columns = np.nonzero(np.asarray(open3d.io.read_image(str(scene / "mask.png"))))
        share = max((np.ptp(rows) + 1) / 120, (np.ptp(columns) + 1) / 160)
        # The outline is known to a pixel on either side.
        assert 0.33 - 2 / 120 < share < 0.5 + 2 / 120


@needs_open3d
def test_objects_stand_on_the_support_plane(tmp_path):
    for scene in made(tmp_path, ON_TABLE):
        plane, model = load(scene / "truth.json")["support_plane"], model_of(scene)
        normal = np.array(plane["normal"])
        assert np.linalg.norm(normal) == pytest.approx(1.0, rel=1e-12)
        lowest = -model.support([-normal])[0]
        # Rounding of lengths of a metre.
        assert lowest + plane["offset"] == pytest.approx(0.0, abs=1e-12)
        assert plane["offset"] > 0.0
        height = superquadric.read(scene / "cloud.ply") @ normal + plane["offset"]
        assert height.min() >= 0.006


@needs_open3d
def test_levels_differ_in_nothing_but_their_difficulty(tmp_path):
    text = changed()
    level = text[text.index("[[level]]") :]
    easy = level.replace("seen", "easy").replace("structured-light", "ideal")
    scenes = {scene.name: scene for scene in made(tmp_path, (level, easy + level))}
    for easy_scene, hard_scene in (("easy-0000", "seen-0000"), ("easy-0001", "seen-0001")):
        first, second = scenes[easy_scene], scenes[hard_scene]
        truths = [load(scene / "truth.json") for scene in (first, second)]
        for key in ("model", "camera_from_world", "family"):
            assert truths[0][key] == truths[1][key]
        assert (first / "mask.png").read_bytes() == (second / "mask.png").read_bytes()
        assert (first / "depth.png").read_bytes() != (second / "depth.png").read_bytes()


def test_whole_surfaces_have_the_noise_they_name(tmp_path):
    sphere = [
        ("size = [[0.1, 0.4], [0.1, 0.4], [0.1, 0.4]]", 'size = [2, 2, 2]\nequal = "xyz"'),
        ("[[0.1, 1.9], [0.1, 1.9]]", "[1, 1]"),
        ("[300, 400]", "5000"),
    ]
    for scene in made(tmp_path, *AS_WHOLE, IN_WORLD, *sphere):
        noise = load(scene / "truth.json")["noise"]
        assert noise == {"kind": "isotropic", "mean_semi_axes": 0.05, "sigma": 0.1}
        distance = model_of(scene).radial_distance(superquadric.read(scene / "cloud.ply"))
        # Of 5,000 points, to five standard errors.
        assert distance.std() == pytest.approx(0.1, rel=0.05)


def test_strays_have_their_share_and_their_box(tmp_path):
    changes = [*AS_WHOLE, IN_WORLD, STRAYS, ("noise = 0.05", "noise = 0")]
    for scene in made(tmp_path, *changes, ("[300, 400]", "4000")):
        cloud, is_inlier = superquadric.read(scene / "cloud.ply"), inliers_of(scene)
        model = model_of(scene)
        assert len(cloud) == 4000
        assert (~is_inlier).sum() == 1000
        # The order tells nothing: of any 1,000 points 250 are strays, give or take five times 14.
        assert (~is_inlier[:1000]).sum() == pytest.approx(250, abs=70)
        # Points made by the core lie on the surface to rounding.
        on_surface = np.abs(model.radial_distance(cloud[is_inlier]))
        assert on_surface.max() < 1e-9 * model.mean_semi_axis
        low, high = model.bounding_box
        scaled = (cloud[~is_inlier] - 0.5 * (low + high)) / (high - low)
        assert np.abs(scaled).max() <= 1.0
        # A uniform law on -1..1: deviation 0.577, known to some 1 / sqrt(5,000).
        np.testing.assert_allclose(scaled.std(axis=0), 3.0**-0.5, rtol=0.07)


@needs_open3d
def test_too_few_pixels_are_refused_and_nothing_is_left(tmp_path):
    far = [("fill = [0.33, 0.5]", "distance = 50"), ("backdrop = 2.0\n", "")]
    with pytest.raises(
        SynthError, match="small, scene seen-0000: none of 20 viewpoints shows the whole"
    ):
        made(tmp_path, *far)
    assert {path.name for path in tmp_path.iterdir()} == {"suite.toml"}


def test_other_files_are_left_alone(tmp_path):
    (tmp_path / "mine").write_text("kept", encoding="utf-8")
    with pytest.raises(SynthError, match="exists and is not an empty folder"):
        generate(suite_of(tmp_path, *AS_WHOLE, IN_WORLD), tmp_path)
    assert (tmp_path / "mine").read_text(encoding="utf-8") == "kept"


def test_an_empty_folder_is_taken(tmp_path):
    (tmp_path / "made").mkdir()
    assert len(made(tmp_path, *AS_WHOLE, IN_WORLD)) == 2


def command(*arguments, before="pass"):
    code = f"import sys; {before}; import superquadric.synth.__main__ as m; sys.exit(m.main())"
    return subprocess.run(
        [sys.executable, "-c", code, *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
    )


def test_a_run_off_a_terminal_says_nothing(tmp_path):
    result = command(SHIPPED / "full.toml", "-o", tmp_path / "full")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")


def test_a_missing_open3d_names_the_extra(tmp_path):
    hidden = "sys.modules['open3d'] = None"
    result = command(SHIPPED / "smoke.toml", "-o", tmp_path / "made", before=hidden)
    assert result.returncode == 2
    assert "pip install 'superquadric[synth]'" in result.stderr
    assert not list(tmp_path.iterdir())


def test_whole_surfaces_need_no_open3d(tmp_path):
    hidden = "sys.modules['open3d'] = sys.modules['cv2'] = None"
    assert command(SHIPPED / "full.toml", "-o", tmp_path / "made", before=hidden).returncode == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["nowhere.toml", "-o", "out"], "nowhere.toml"),
        ([SHIPPED / "full.toml"], "needs a suite file and -o DIR, or --list"),
        ([SHIPPED / "full.toml", "-o", "out", "--jobs", "0"], "must be a whole number from 1"),
        (["--list", Path(__file__).parent], "holds no suite files"),
    ],
)
def test_slips_end_with_2(arguments, message):
    result = command(*arguments)
    assert result.returncode == 2
    assert message in result.stderr
    assert not result.stdout


def test_shipped_suites_are_listed(capsys):
    assert main(["--list", str(SHIPPED)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == len(list(SHIPPED.glob("*.toml"))) > 0
    assert any("full-noise.toml: 200 scenes." in line for line in lines)
