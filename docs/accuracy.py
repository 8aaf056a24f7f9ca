"""Makes docs/accuracy.md and docs/pictures/accuracy.png: how well shapes are recovered.

Needs `pip install '.[synth,batch]' scipy` and, on Debian, what open3d loads (data_synth/README.md).
"""

import argparse
import os
import sys
import tempfile
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
SINGLE_START = "single start"
METHODS = ["geometric", "radial", SINGLE_START]
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
        for distance in METHODS[:2]
    }
    levels = {method: found.summary["levels"] for method, found in evaluations.items()}
    return levels | {SINGLE_START: _single_start(evaluations["geometric"])}


def _single_start(evaluation):
    """The levels of the same scenes by the plain fit."""
    return [
        _level(level["level"], _single_start_scores(evaluation, level["level"]))
        for level in evaluation.summary["levels"]
    ]


def _single_start_scores(evaluation, level):
    """IoU, surface distance and seconds of each scene of a level: an array of shape (n, 3)."""
    scores = []
    for scene in [row["scene"] for row in evaluation.rows if row["level"] == level]:
        fit = single_start.fit(evaluation.points(scene))
        score = superquadric.score(evaluation.truth(scene), fit.model, samples=SAMPLES)
        scores.append([score.volume_iou, score.surface_distance, fit.seconds])
    return np.array(scores)


def _level(name, scores):
    iou, surface_distance, seconds = np.quantile(scores, QUARTILES, axis=0).T.tolist()
    return {
        "level": name,
        "scenes": len(scores),
        "success": float(np.mean(scores[:, 0] >= SUCCESS_IOU)),
        "trusted": None,
        "wrongly_trusted": None,
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
    rows = {method: cells({"levels": levels}) for method, levels in by_method.items()}
    lines = [
        [level[0], method, *level[1:]]
        for same_level in zip(*rows.values(), strict=True)
        for method, level in zip(rows, same_level, strict=True)
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
        for offset, method in zip([-0.27, 0.0, 0.27], METHODS, strict=True):
            shares = [100 * level["success"] for level in by_method[method]]
            axes.bar(np.arange(len(shares)) + offset, shares, 0.25, label=method)
        names = [level["level"].replace("-", "\n") for level in by_method["radial"]]
        axes.set_xticks(range(len(names)), names, fontsize="small")
        axes.set(title=name, ylim=(0, 100), ylabel="scenes with IoU >= 0.9, %")
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3)
    saved(figure, DOCS / "pictures" / "accuracy.png")


if __name__ == "__main__":
    main()
