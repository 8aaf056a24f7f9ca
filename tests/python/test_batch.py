import base64
import csv
import html
import json
import re
import subprocess
import sys

import numpy as np
import pytest

import superquadric
from superquadric.batch import MissingExtraError, evaluate
from superquadric.batch.__main__ import main

LEVELS = ["clean", "5 $^$ <i>"]
SCENES = {"plain": "clean", "other": "clean", "<b>&bold": "5 $^$ <i>", "lost": "clean"}
PLY = """ply
format ascii 1.0
element vertex {}
property double x
property double y
property double z
end_header
"""


def write_scene(folder, model, points):
    folder.mkdir(parents=True)
    model.save(folder / "truth.json")
    rows = "".join(" ".join(map(repr, row)) + "\n" for row in points.tolist())
    (folder / "cloud.ply").write_text(PLY.format(len(points)) + rows)


@pytest.fixture(scope="module")
def suite(tmp_path_factory, model):
    """Three scenes that can be fitted, on two levels, and one without files."""
    folder = tmp_path_factory.mktemp("suite")
    for seed, (name, level) in enumerate(SCENES.items()):
        if name != "lost":
            noise = 0.05 if level == LEVELS[1] else 0.0
            points = model.sample(300, seed=seed)
            points += np.random.default_rng(seed).normal(scale=noise, size=points.shape)
            write_scene(folder / "scenes" / name, model, points)
    scenes = [{"name": name, "level": level, "family": "any"} for name, level in SCENES.items()]
    document = {"name": "small & <made>", "levels": LEVELS, "scenes": scenes}
    (folder / "suite.json").write_text(json.dumps(document))
    return folder


@pytest.fixture(scope="module")
def evaluation(suite, tmp_path_factory):
    return evaluate(suite, tmp_path_factory.mktemp("results"))


def value_of(cell, like):
    """The value of a CSV file's cell, of the type of another one."""
    if like is None:
        return cell or None
    return cell == "true" if isinstance(like, bool) else type(like)(cell)


def rows_of(path):
    """The rows of a CSV file without their times."""
    with path.open(newline="") as lines:
        rows = list(csv.DictReader(lines))
    return [{name: cell for name, cell in row.items() if name != "seconds"} for row in rows]


def assert_same(rows, cells):
    assert [row["scene"] for row in rows] == [line["scene"] for line in cells]
    for row, line in zip(rows, cells, strict=True):
        assert row == {"seconds": row["seconds"]} | {
            name: value_of(cell, row[name]) for name, cell in line.items()
        }


def test_rows_are_those_of_the_table_that_is_kept(evaluation):
    assert_same(evaluation.rows, rows_of(evaluation.results_dir / "scenes.csv"))
    assert list(evaluation.rows[0])[:4] == ["scene", "level", "family", "status"]


def test_the_command_line_gives_the_same_numbers(evaluation, suite, binary, tmp_path):
    subprocess.run([binary, "batch", suite, "-o", tmp_path], check=True, capture_output=True)
    assert_same(evaluation.rows, rows_of(tmp_path / "scenes.csv"))


def test_models_are_kept_and_fit_the_truth(evaluation):
    assert set(evaluation.models) == set(SCENES) - {"lost"}
    found = superquadric.score(evaluation.truth("plain"), evaluation.models["plain"])
    assert found.volume_iou > 0.99
    assert evaluation.points("plain").shape == (300, 3)


def test_a_model_is_that_of_the_fit(evaluation):
    expected = superquadric.fit(evaluation.points("plain")).model
    assert evaluation.models["plain"].parameters == pytest.approx(expected.parameters, rel=1e-12)


def test_failures_are_rows_and_count(evaluation):
    lost = evaluation.rows[-1]
    assert (lost["scene"], lost["status"], lost["iou"]) == ("lost", "failed", None)
    assert "truth.json" in lost["error"]
    clean, noisy = evaluation.summary["levels"]
    assert (clean["level"], clean["scenes"], clean["failed"]) == ("clean", 3, 1)
    assert (noisy["level"], noisy["failed"]) == (LEVELS[1], 0)
    assert evaluation.worst(9)[0]["scene"] == "<b>&bold"


def test_what_a_progress_raises_ends_it_and_the_next_call_goes_on(suite, tmp_path):
    def stop(done, total):
        raise RuntimeError(f"{done} of {total}")

    with pytest.raises(RuntimeError, match="1 of 4"):
        evaluate(suite, tmp_path, threads=1, progress=stop)
    kept = {path: path.stat().st_mtime_ns for path in (tmp_path / "scenes").iterdir()}
    assert len(kept) == 1
    calls = []
    evaluate(suite, tmp_path, threads=1, progress=lambda *call: calls.append(call))
    assert calls == [(done, 4) for done in range(1, 5)]
    assert kept == {path: path.stat().st_mtime_ns for path in kept}


def test_results_of_other_options_are_refused(evaluation, suite):
    with pytest.raises(superquadric.BatchError, match=r"seed 0.*seed 1"):
        evaluate(suite, evaluation.results_dir, seed=1)


def test_what_is_no_suite_is_refused(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"suite\.json"):
        evaluate(tmp_path, tmp_path / "results")
    (tmp_path / "suite.json").write_text("[]")
    with pytest.raises(superquadric.BatchError, match="expected a suite"):
        evaluate(tmp_path, tmp_path / "results")
    with pytest.raises(ValueError, match="distance"):
        evaluate(tmp_path, tmp_path / "results", distance="vertical")


def test_the_table_has_a_row_a_scene_and_types(evaluation):
    pytest.importorskip("pandas")
    table = evaluation.table
    assert table.shape == (4, len(evaluation.rows[0]))
    assert [str(table[name].dtype) for name in ["iou", "points", "trusted"]] == [
        "float64",
        "Int64",
        "boolean",
    ]
    assert table["iou"].isna().tolist() == [False, False, False, True]


def test_parquet_comes_back(evaluation, tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    evaluation.to_parquet(tmp_path / "scenes.parquet")
    pandas.testing.assert_frame_equal(
        pandas.read_parquet(tmp_path / "scenes.parquet"), evaluation.table
    )


def test_the_report_is_one_file_with_all_in_it(evaluation, tmp_path):
    pytest.importorskip("matplotlib")
    path = tmp_path / "report.html"
    evaluation.write_report(path)
    assert list(tmp_path.iterdir()) == [path]
    text = path.read_text(encoding="utf-8")
    assert "://" not in text
    assert "<script" not in text
    for name in [*SCENES, *LEVELS, "small & <made>"]:
        assert html.escape(name) in text
    assert "<b>" not in text
    assert "<i>" not in text
    sources = re.findall(r'<img alt="[^"]*" src="([^"]*)"', text)
    assert len(sources) == 2 + 3
    for source in sources:
        kind, data = source.split(",")
        assert kind == "data:image/png;base64"
        assert base64.b64decode(data).startswith(b"\x89PNG\r\n")


def test_plots_are_saved(evaluation, tmp_path):
    pytest.importorskip("matplotlib")
    from superquadric.batch import plots

    for draw in [plots.success, plots.histograms]:
        path = tmp_path / f"{draw.__name__}.png"
        figure = draw(evaluation, path)
        assert path.read_bytes() == plots.png(figure)


@pytest.mark.parametrize("package", ["pandas", "matplotlib.figure", "pyarrow"])
def test_a_missing_package_is_named_with_the_extra(evaluation, monkeypatch, tmp_path, package):
    monkeypatch.setitem(sys.modules, package, None)
    acts = {
        "pandas": lambda: evaluation.table,
        "pyarrow": lambda: evaluation.to_parquet(tmp_path / "x"),
        "matplotlib.figure": lambda: evaluation.write_report(tmp_path / "x"),
    }
    with pytest.raises(MissingExtraError, match=rf"{package}.*superquadric\[batch\]"):
        acts[package]()


def test_import_brings_neither_pandas_nor_matplotlib():
    code = "import sys, superquadric.batch; print(*sys.modules)"
    modules = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout
    assert "superquadric.batch" in modules.split()
    assert not {"pandas", "matplotlib"} & set(modules.split())


def test_the_command_prints_a_table_and_no_bar(suite, tmp_path, capsys):
    assert main([str(suite), "-o", str(tmp_path / "results"), "--threads", "1"]) == 0
    printed = capsys.readouterr()
    assert printed.err == ""
    assert len(printed.out.splitlines()) == 2 + len(LEVELS)
    assert (tmp_path / "results" / "scenes.csv").exists()


def test_the_command_writes_what_it_is_asked_for(suite, tmp_path):
    for package in ["pandas", "pyarrow", "matplotlib"]:
        pytest.importorskip(package)
    files = {"--report": tmp_path / "report.html", "--parquet": tmp_path / "scenes.parquet"}
    asked = [str(word) for pair in files.items() for word in pair]
    assert main([str(suite), "-o", str(tmp_path / "results"), *asked]) == 0
    assert all(path.stat().st_size for path in files.values())


def test_the_command_tells_what_is_wrong(tmp_path, capsys):
    assert main([str(tmp_path), "-o", str(tmp_path / "results")]) == 2
    assert "suite.json" in capsys.readouterr().err
    with pytest.raises(SystemExit) as ended:
        main([str(tmp_path), "-o", "x", "--threads", "0"])
    assert ended.value.code == 2
    assert "whole number" in capsys.readouterr().err
