"""Fits from Python: what they hold, and that they leave the interpreter free."""

import json
import signal
import threading
from pathlib import Path

import numpy as np
import pytest

import superquadric

SCHEMA = Path(__file__).parents[2] / "schema" / "fit-1.schema.json"


def test_a_fit_recovers_the_model_with_its_evidence(model, points, fit):
    assert superquadric.score(model, fit).volume_iou > 0.98
    assert (fit.trusted, fit.doubts, fit.status) == (True, [], "converged")
    assert (fit.points, fit.points_skipped, fit.seed) == (500, 0, 0)
    rms = np.sqrt(np.mean(fit.model.radial_distance(points) ** 2))
    # The sum over points far from the origin, in another order.
    assert fit.rms_radial == pytest.approx(rms, rel=1e-9)
    assert fit.relative_rms == pytest.approx(rms / fit.model.mean_semi_axis, rel=1e-9)
    assert 0 < fit.rms_geometric <= fit.rms_radial
    assert fit.model == fit.model.canonical()
    assert fit.evaluations >= fit.starts > 0
    assert repr(fit.model) in repr(fit)


def test_dictionary_has_what_the_schema_asks_for(fit):
    schema = json.loads(SCHEMA.read_text())
    document = fit.to_dict()
    assert document["schema"] == schema["title"]
    assert set(document) == set(schema["required"])
    for name in ["model", "fit"]:
        assert set(document[name]) == set(schema["$defs"][name]["required"])
    evidence = document["fit"]
    for name in set(evidence) - {"doubts", "uncertainty"}:
        assert evidence[name] == getattr(fit, name)
    assert np.array_equal(evidence["uncertainty"]["covariance"], fit.covariance)
    assert np.array_equal(evidence["uncertainty"]["standard_errors"], fit.standard_errors)
    assert document["model"] == fit.model.to_dict()


def test_a_doubtful_fit_says_why():
    grid = np.stack(np.meshgrid(np.arange(20.0), np.arange(10.0), [0.0]), axis=-1).reshape(-1, 3)
    fit = superquadric.fit(grid)
    assert not fit.trusted
    assert "flat" in dict(fit.doubts)
    doubts = fit.to_dict()["fit"]["doubts"]
    assert [(doubt["kind"], doubt["message"]) for doubt in doubts] == fit.doubts
    assert "not trusted" in repr(fit)


def test_seed_and_threads_are_passed_on(points):
    assert superquadric.fit(points, seed=7).seed == 7
    many = np.tile(points, (50, 1))
    fits = [superquadric.fit(many, threads=threads) for threads in (1, 2, None)]
    assert all(fit.model == fits[0].model for fit in fits)
    with pytest.raises(ValueError, match="zero"):
        superquadric.fit(points, threads=0)
    with pytest.raises(OverflowError):
        superquadric.fit(points, seed=-1)
    with pytest.raises(TypeError):
        superquadric.fit(points, speed=3)


def test_each_distance_is_least_where_it_is_minimised(points):
    radial, geometric = (superquadric.fit(points, distance=d) for d in ("radial", "geometric"))
    assert radial.rms_radial < geometric.rms_radial
    assert geometric.rms_geometric < radial.rms_geometric
    with pytest.raises(ValueError, match="'radial' or 'geometric', found 'vertical'"):
        superquadric.fit(points, distance="vertical")


def test_single_precision_loses_nothing_beside_the_noise(points):
    double, single = (superquadric.fit(points, precision=p) for p in ("double", "single"))
    assert double.model == superquadric.fit(points).model
    # The last step may be the same, but not what it leaves.
    assert single.rms_geometric != double.rms_geometric
    difference = np.abs(np.subtract(single.model.size, double.model.size))
    assert (difference < 0.1 * double.standard_errors[:3]).all()
    with pytest.raises(ValueError, match="'double' or 'single', found 'half'"):
        superquadric.fit(points, precision="half")


@pytest.mark.parametrize(
    ("points", "message"),
    [
        (np.ones((50, 3)), "coincide"),
        (np.arange(50.0)[:, None] * [1, 2, 3], "one line"),
        (np.eye(3), "3 finite points are too few"),
    ],
)
def test_clouds_that_determine_no_solid_are_fit_errors(points, message):
    with pytest.raises(superquadric.FitError, match=message):
        superquadric.fit(points)


class InterruptError(Exception):
    """What the signal handler of a test raises."""


@pytest.fixture(scope="module")
def long_cloud():
    """A cloud that one thread takes many times the interval between checks for signals to fit."""
    model = superquadric.Superellipsoid([2, 1, 0.5], [0.4, 1.3])
    return np.tile(model.sample(100_000), (30, 1))


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs the timers of Unix")
def test_signals_are_handled_during_a_fit_and_can_end_it(long_cloud):
    handled, completed = [], []

    def fit_for_ever():
        while True:
            completed.append(superquadric.fit(long_cloud, threads=1))

    def interrupt(signal_number, frame):
        handled.append(signal_number)
        if len(handled) == 3:
            raise InterruptError

    previous = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.001, 0.001)
    try:
        with pytest.raises(InterruptError):
            fit_for_ever()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)
    # Were signals left until a fit returns, each would follow a fit of its own.
    assert len(completed) < len(handled) - 1


def test_other_threads_run_during_a_fit(long_cloud):
    stop = threading.Event()
    turns = 0

    def count():
        nonlocal turns
        while not stop.wait(0.001):
            turns += 1

    counter = threading.Thread(target=count)
    counter.start()
    before = turns
    superquadric.fit(long_cloud, threads=1)
    during = turns - before
    stop.set()
    counter.join()
    # Held up by the interpreter's lock, it would run once before and once after.
    assert during > 3


def test_fits_on_several_threads_are_the_same(points, fit):
    results = []
    threads = [
        threading.Thread(target=lambda: results.append(superquadric.fit(points))) for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 4
    assert all(result.model == fit.model for result in results)
