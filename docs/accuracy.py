"""Makes docs/accuracy.md and docs/pictures/accuracy.png: how well shapes are recovered.

Needs `pip install '.[synth,batch]' scipy` and, on Debian, what open3d loads (data_synth/README.md).
"""

import argparse
import json
import os
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import single_start
from pages import DOCS, SAMPLES, SUCCESS_IOU, made_by

import superquadric
from superquadric.batch import evaluate
from superquadric.batch.plots import figure_of, saved
from superquadric.batch.table import HEADER, cells, markdown
from superquadric.progress import Progress
from superquadric.synth import generate, read_suite

SUITES = DOCS.parent / "data_synth"
NAMES = ["full-noise", "single-view", "boxes-and-cans", "thin", "table-top", "outliers"]
DISTANCES = ["geometric", "radial"]
TOLD = "viewpoint told"
SINGLE_START = "single start"
METHODS = ["geometric", TOLD, "radial", SINGLE_START]
QUARTILES = [0, 0.25, 0.5, 0.75, 1]

PAGE = """# How well shapes are recovered

{made}, from the suites of
[data_synth](../data_synth/README.md): {scenes} scenes of each level, known truth, seed 0.

- Success: share of the scenes whose volume overlap (IoU) with the truth is at least 0.9.
- Surface distance: symmetric mean distance of the two surfaces over the true mean semi-axis. It
  and the time are medians. Times are no benchmark: [benches/runs](../benches/runs) times fits.
- Wrongly trusted: number of scenes whose fit was trusted although its IoU is below 0.9.
- `geometric` (the default) and `radial` are `superquadric.fit` with that distance, one thread a
  fit, as many scenes at a time as there are cores.
- `viewpoint told` is the default, told where the camera stood, on views.
- `single start` is the plain fit to compare with, [single_start.py](single_start.py): SciPy's
  `least_squares` on the radial distance from the principal axes, numeric derivatives, at most 500
  points a cloud. It does not judge itself.

![Success against level, for each suite and method](pictures/accuracy.png)

## What does not work yet

{shortcomings}"""


def main():
    options = _options()
    bar = Progress("suites", sys.stderr)
    with tempfile.TemporaryDirectory() as folder:
        results = {}
        for name in NAMES:
            results[name] = _results(name, options, Path(folder) / name)
            bar(len(results), len(NAMES))
    _draw(results)
    (DOCS / "accuracy.md").write_text(_page(results, options.scenes), encoding="utf-8")


def _options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scenes", type=int, default=24, help="of each level")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="processes making clouds")
    return parser.parse_args()


def _results(name, options, folder):
    """The levels of a suite by method, as `summary.json` has them."""
    suite = read_suite(SUITES / f"{name}.toml")
    suite = replace(suite, scenes=options.scenes)
    generate(suite, folder / "suite", jobs=options.jobs)
    evaluations = {
        distance: evaluate(folder / "suite", folder / distance, distance=distance)
        for distance in DISTANCES
    }
    levels = {method: found.summary["levels"] for method, found in evaluations.items()}
    return levels | {
        TOLD: _levels(evaluations["geometric"], _fitted_from_viewpoint),
        SINGLE_START: _levels(evaluations["geometric"], _fitted_from_single_start),
    }


def _levels(evaluation, fitted):
    """The levels of the same scenes by another fit: of those that it makes something of."""
    names = [level["level"] for level in evaluation.summary["levels"]]
    levels = [(name, _scores(evaluation, name, fitted)) for name in names]
    return [_level(name, *scores) for name, scores in levels if scores]


def _scores(evaluation, level, fitted):
    """IoU, surface distance and seconds of each scene of a level, of shape (n, 3), and whether each
    fit is trusted, if it judges itself."""
    scenes = [row["scene"] for row in evaluation.rows if row["level"] == level]
    fits = [fitted(evaluation, scene) for scene in scenes]
    if None in fits:
        return None
    scores = []
    for scene, (model, seconds, _) in zip(scenes, fits, strict=True):
        score = superquadric.score(evaluation.truth(scene), model, samples=SAMPLES)
        scores.append([score.volume_iou, score.surface_distance, seconds])
    trusted = [trusted for _, _, trusted in fits]
    return np.array(scores), None if None in trusted else np.array(trusted)


def _fitted_from_single_start(evaluation, scene):
    fit = single_start.fit(evaluation.points(scene))
    return fit.model, fit.seconds, None


def _fitted_from_viewpoint(evaluation, scene):
    """The default fit, told where the camera stood; None where there was none."""
    truth = json.loads((evaluation.suite_dir / "scenes" / scene / "truth.json").read_text())
    if "camera_from_world" not in truth:
        return None
    points = evaluation.points(scene)
    begin = time.perf_counter()
    fit = superquadric.fit(points, viewpoint=_viewpoint(truth), threads=1)
    return fit.model, time.perf_counter() - begin, fit.trusted


def _viewpoint(truth):
    """Where the camera stood, in the frame of the points."""
    if truth["frame"] == "camera":
        return np.zeros(3)
    camera_from_world = np.array(truth["camera_from_world"])
    return np.linalg.inv(camera_from_world)[:3, 3]


def _level(name, scores, trusted):
    iou, surface_distance, seconds = np.quantile(scores, QUARTILES, axis=0).T.tolist()
    is_right = scores[:, 0] >= SUCCESS_IOU
    return {
        "level": name,
        "scenes": len(scores),
        "success": float(np.mean(is_right)),
        "trusted": None if trusted is None else float(np.mean(trusted)),
        "wrongly_trusted": None if trusted is None else int(np.sum(trusted & ~is_right)),
        "iou": iou,
        "surface_distance": surface_distance,
        "seconds": seconds,
    }


def _page(results, scenes):
    head = PAGE.format(
        made=made_by(f"python docs/accuracy.py --scenes {scenes}"),
        scenes=scenes,
        shortcomings=_shortcomings(results),
    )
    return head + "".join(_section(name, levels) for name, levels in results.items())


def _section(name, by_method):
    rows = {
        (row[0], method): row[1:]
        for method, levels in by_method.items()
        for row in cells({"levels": levels})
    }
    names = [level["level"] for level in by_method["geometric"]]
    lines = [
        [name, method, *rows[name, method]]
        for name in names
        for method in METHODS
        if (name, method) in rows
    ]
    return f"\n## {name}\n\n" + markdown([HEADER[0], "method", *HEADER[1:]], lines)


def _shortcomings(results):
    """What the numbers say against the default method."""
    levels = [level for by_method in results.values() for level in by_method["geometric"]]
    trusted = sum(round(level["trusted"] * level["scenes"]) for level in levels)
    wrongly = sum(level["wrongly_trusted"] for level in levels)
    poor = "".join(_poor(name, by_method["geometric"]) for name, by_method in results.items())
    below = (
        f"It recovers less than nine in ten of the scenes of these levels:\n\n{poor}"
        if poor
        else "It recovers nine in ten of the scenes of every level.\n"
    )
    count = f"Of all fits by `geometric` {trusted} are trusted, {wrongly} of these wrongly."
    return f"{count}\n\n{below}"


def _poor(suite, levels):
    names = [level["level"] for level in levels if level["success"] < 0.9]
    return f"- {suite}: {', '.join(names)}\n" if names else ""


def _draw(results):
    figure = figure_of(12.0, 6.5)
    for axes, (name, by_method) in zip(figure.subplots(2, 3).flat, results.items(), strict=True):
        names = [level["level"] for level in by_method["geometric"]]
        for index, method in enumerate(METHODS):
            offset = 0.2 * index - 0.3
            places = [names.index(level["level"]) + offset for level in by_method[method]]
            shares = [100 * level["success"] for level in by_method[method]]
            axes.bar(places, shares, 0.19, label=method, color=f"C{index}")
        labels = [name.replace("-", "\n") for name in names]
        axes.set_xticks(range(len(names)), labels, fontsize="small")
        axes.set(title=name, ylim=(0, 100), ylabel="scenes with IoU >= 0.9, %")
    # Of the first suite, of whole surfaces, no viewpoint can be told.
    handles, labels = figure.axes[1].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=4)
    saved(figure, DOCS / "pictures" / "accuracy.png")


if __name__ == "__main__":
    main()
