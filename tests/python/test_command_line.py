"""The command line and Python give the same numbers for the same cloud, options and seed."""

import json
import subprocess

import numpy as np
import pytest

import superquadric


def run(binary, *arguments, **options):
    # The status tells whether the fit can be trusted: that too is compared.
    result = subprocess.run(
        [binary, "fit", *arguments, "-o", "-"], capture_output=True, check=False, **options
    )
    return json.loads(result.stdout)


def without_time(document):
    del document["fit"]["seconds"]
    return document


@pytest.mark.parametrize("seed", [0, 5])
@pytest.mark.parametrize("count", [200, 30_000])
def test_fits_are_the_same_to_the_last_bit(binary, tmp_path, model, count, seed):
    noise = np.random.default_rng(seed).normal(scale=0.01, size=(count, 3))
    cloud = model.sample(count, seed=seed) + noise
    cloud[7, 1] = np.nan
    np.save(tmp_path / "cloud.npy", cloud)
    expected = without_time(superquadric.fit(cloud, seed=seed).to_dict())
    found = run(binary, tmp_path / "cloud.npy", "--seed", str(seed))
    assert without_time(found) == expected


@pytest.mark.parametrize("distance", ["radial", "geometric"])
def test_distances_have_the_same_names(binary, tmp_path, points, distance):
    np.save(tmp_path / "cloud.npy", points)
    found = run(binary, tmp_path / "cloud.npy", "--distance", distance)
    expected = superquadric.fit(points, distance=distance).to_dict()
    assert without_time(found) == without_time(expected)


@pytest.mark.parametrize("precision", ["double", "single"])
def test_precisions_have_the_same_names(binary, tmp_path, points, precision):
    np.save(tmp_path / "cloud.npy", points)
    found = run(binary, tmp_path / "cloud.npy", "--precision", precision)
    expected = superquadric.fit(points, precision=precision).to_dict()
    assert without_time(found) == without_time(expected)


def test_a_cloud_from_stdin_is_the_same(binary, model):
    cloud = model.sample(300)
    text = "\n".join(" ".join(map(repr, row)) for row in cloud.tolist())
    found = run(binary, "-", input=text.encode())
    assert without_time(found) == without_time(superquadric.fit(cloud).to_dict())


def test_doubts_are_the_same(binary, tmp_path):
    plane = np.random.default_rng(0).uniform(size=(300, 3)) * [3, 2, 0]
    np.save(tmp_path / "cloud.npy", plane)
    fit = superquadric.fit(plane)
    assert not fit.trusted
    found = run(binary, tmp_path / "cloud.npy")
    assert without_time(found) == without_time(fit.to_dict())
