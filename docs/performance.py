"""Makes docs/performance.md and docs/pictures/performance.png: what a fit costs.

Needs `pip install '.[batch]' scipy`. Run it on a quiet machine.
"""

import argparse
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

# One thread for SciPy too; NumPy reads this when it is imported.
os.environ["OPENBLAS_NUM_THREADS"] = "1"

import numpy as np
import scipy_fit
from pages import DOCS, SAMPLES, SUCCESS_IOU, made_by

import superquadric
from superquadric.batch.plots import figure_of, saved
from superquadric.batch.table import markdown

NOISE = 0.01
POINTS = [1_000, 10_000, 100_000, 1_000_000]
SCIPY_POINTS = 100_000
SCIPY = {"SciPy, 3 starts": "principal", "SciPy, same starts": "same"}
METHODS = ["geometric", "radial", *SCIPY]
STRAYS = [0.0, 0.2, 0.4, 0.6, 0.8]
STRAY_POINTS = 3_000
SETS = ["portable", "avx2", "avx512"]

PAGE = """# What a fit costs

{made}, load {load:.1f} before. One thread;
medians over {shapes} random shapes, 1 % of noise.

## Complete clouds, against SciPy

`geometric` (the default) and `radial` are `superquadric.fit`, all starts included.
[SciPy](scipy_fit.py) is `least_squares` on the radial distance, trust-region, with the analytic
Jacobian and default tolerances, in the same run: from the three principal axes, and from the
library's [starts](scipy_starts.py) in its [order](scipy_search.py). Each of its descents looks at
all points; the library [starts from 256](decisions/0004-search.md). Starts: mean number of models
descended from, by `geometric` also in a second look. Recovered: IoU of at least 0.9.

{complete}
## Strays

{strays} points in all, uniform in a box of twice the shape's sides.

{among_strays}
What the time goes into: [profile.md](profile.md).

## Instruction sets

`geometric`, 100,000 points, by `SUPERQUADRIC_SIMD`.

{sets}
![Cost against points, strays and starts](pictures/performance.png)
"""


def main():
    options = _options()
    if options.single:
        print(_median_ms("geometric", _clouds(options.shapes, SCIPY_POINTS, 0.0)))
        return
    load = os.getloadavg()[0]
    _assert_derivatives()
    complete = {points: _compared(options.shapes, points) for points in POINTS}
    strays = {share: _with_strays(options.shapes, share) for share in STRAYS}
    _draw(complete, strays, options.output / "pictures")
    page = PAGE.format(
        made=made_by(f"python docs/performance.py --shapes {options.shapes}"),
        load=load,
        shapes=options.shapes,
        complete=_complete_table(complete),
        strays=f"{STRAY_POINTS:,}",
        among_strays=_stray_table(strays),
        sets=_set_table(options.shapes),
    )
    (options.output / "performance.md").write_text(page, encoding="utf-8")


def _options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--shapes", type=int, default=8)
    parser.add_argument("--output", type=Path, default=DOCS, help="folder of the page")
    parser.add_argument("--single", action="store_true", help=argparse.SUPPRESS)
    return parser.parse_args()


def _clouds(shapes, points, strays):
    """Models, and the points of each, strays in the end."""
    rng = np.random.default_rng(0)
    for seed in range(shapes):
        size, exponents = 4 ** rng.uniform(size=3), rng.uniform(0.1, 1.9, size=2)
        model = superquadric.Superellipsoid(size, exponents, euler_zyz=rng.uniform(-3, 3, size=3))
        count = round((1 - strays) * points)
        surface = model.sample(count, seed=seed) + NOISE * size.mean() * rng.normal(size=(count, 3))
        low, high = model.bounding_box
        middle, half = (low + high) / 2, high - low
        outside = middle + half * rng.uniform(-1, 1, size=(points - count, 3))
        yield model, np.concatenate([surface, outside])


def _fit(method, points):
    """By SciPy or the library: both results have `model` and `starts`."""
    if method in SCIPY:
        return scipy_fit.fit(points, SCIPY[method])
    return superquadric.fit(points, distance=method, threads=1)


def _measured(method, clouds):
    """Milliseconds, recovered, and starts of each fit."""
    results = []
    for truth, points in clouds:
        begin = time.perf_counter()
        fit = _fit(method, points)
        seconds = time.perf_counter() - begin
        iou = superquadric.score(truth, fit.model, samples=SAMPLES).volume_iou
        results.append([1e3 * seconds, iou >= SUCCESS_IOU, fit.starts])
    return np.array(results)


def _median_ms(method, clouds):
    return float(np.median(_measured(method, clouds)[:, 0]))


def _compared(shapes, points):
    methods = [m for m in METHODS if m not in SCIPY or points <= SCIPY_POINTS]
    return {method: _measured(method, _clouds(shapes, points, 0.0)) for method in methods}


def _with_strays(shapes, share):
    return _measured("geometric", _clouds(shapes, STRAY_POINTS, share))


def _complete_table(complete):
    header = ["points", "method", "starts", "ms", "recovered, %", *(f"{m}, over it" for m in SCIPY)]
    lines = [
        [f"{points:,}", method, *_cells(by_method[method]), *_ratios(method, by_method)]
        for points, by_method in complete.items()
        for method in by_method
    ]
    return markdown(header, lines)


def _cells(results):
    ms, starts = np.median(results[:, 0]), results[:, 2].mean()
    return [f"{starts:.1f}", f"{ms:.1f}", _percent(results)]


def _ratios(method, by_method):
    """How many times as long as a method of the library each form of SciPy takes."""
    ms = {name: np.median(results[:, 0]) for name, results in by_method.items()}
    return [
        f"{ms[scipy] / ms[method]:.0f}" if scipy in ms and method not in SCIPY else "-"
        for scipy in SCIPY
    ]


def _stray_table(strays):
    lines = [
        [f"{100 * share:.0f} %", f"{np.median(results[:, 0]):.1f}", _percent(results)]
        for share, results in strays.items()
    ]
    return markdown(["strays", "ms", "recovered, %"], lines)


def _set_table(shapes):
    lines = []
    for name in SETS:
        command = [sys.executable, __file__, "--single", "--shapes", str(shapes)]
        environment = os.environ | {"SUPERQUADRIC_SIMD": name}
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        lines.append([name, f"{float(run.stdout):.1f}" if run.returncode == 0 else "not there"])
    return markdown(["set", "ms"], lines)


def _percent(results):
    return f"{100 * statistics.mean(results[:, 1]):.0f}"


def _assert_derivatives():
    """The comparison would be worth nothing with a wrong Jacobian."""
    parameters = np.array([1, 0.6, 1.7, 0.4, 1.3, 0.3, 0.8, -1, 0.1, 0, -0.2])
    points = np.random.default_rng(1).uniform(-2, 2, size=(50, 3))
    steps = 1e-6 * np.eye(11)
    ahead = [scipy_fit.rows(parameters + step, points)[0] for step in steps]
    behind = [scipy_fit.rows(parameters - step, points)[0] for step in steps]
    differences = (np.array(ahead) - np.array(behind)).T / 2e-6
    np.testing.assert_allclose(scipy_fit.rows(parameters, points)[1], differences, atol=1e-7)


def _draw(complete, strays, folder):
    figure = figure_of(12.0, 3.6)
    by_points, by_share, by_starts = figure.subplots(1, 3)
    for method in METHODS:
        points = [count for count in complete if method in complete[count]]
        times = [np.median(complete[count][method][:, 0]) for count in points]
        by_points.loglog(points, times, "o-", label=method)
    by_points.set(xlabel="points", ylabel="ms")
    figure.legend(loc="outside upper left", ncols=len(METHODS))
    shares = [100 * share for share in strays]
    by_share.plot(shares, [np.median(results[:, 0]) for results in strays.values()], "o-")
    by_share.set(xlabel=f"strays among {STRAY_POINTS:,} points, %", ylim=(0, None))
    results = np.concatenate([complete[POINTS[0]]["geometric"], *strays.values()])
    by_starts.plot(results[:, 2], results[:, 0], "o")
    by_starts.set(xlabel="starts of a fit", ylim=(0, None), xlim=(0, None))
    folder.mkdir(parents=True, exist_ok=True)
    saved(figure, folder / "performance.png")


if __name__ == "__main__":
    main()
