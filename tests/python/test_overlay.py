"""Models drawn over pictures with OpenCV."""

import sys

import numpy as np
import pytest

import superquadric
from superquadric import overlay

pytest.importorskip("cv2")

CAMERA = superquadric.Camera(500, 500, 319.5, 239.5, 640, 480, distortion=[-0.1, 0.01, 0, 0])
MODEL = superquadric.Superellipsoid(
    [0.1, 0.15, 0.2], [0.4, 1.2], euler_zyz=[0.3, 1.0, 0.2], translation=[0.02, 0, 1.2]
)


def picture(level=90):
    return np.full((480, 640, 3), level, dtype=np.uint8)


FAMILIES = [
    MODEL,
    superquadric.Superellipsoid([0.2, 0.2, 0.2], [1, 2.8], translation=[0, 0, 1.2]),
    superquadric.Supertoroid(
        [0.05, 0.06, 0.04], [0.6, 1], ring=3, euler_zyz=[0.3, 1.2, 0], translation=[0, 0, 1.2]
    ),
    superquadric.SuperhyperboloidOneSheet(
        [0.05, 0.06, 0.1], [0.7, 1], clip=0.2, euler_zyz=[0.3, 1.2, 0], translation=[0, 0, 1.2]
    ),
    superquadric.SuperhyperboloidTwoSheets(
        [0.05, 0.06, 0.07], [0.7, 1], clip=0.2, euler_zyz=[0.3, 1.2, 0], translation=[0, 0, 1.2]
    ),
    superquadric.ThreeExponent(
        [0.1, 0.2, 0.15], [2, 4, 8], euler_zyz=[0.3, 1.2, 0], translation=[0, 0, 1.2]
    ),
    [MODEL, superquadric.Superellipsoid([0.1, 0.1, 0.1], [1, 1], translation=[0.15, 0, 1])],
]
PARALLEL = superquadric.OrthographicCamera([500, 500], [319.5, 239.5], 640, 480)


@pytest.mark.parametrize("camera", [CAMERA, PARALLEL])
@pytest.mark.parametrize(
    ("model", "level"), [(MODEL, 0), (MODEL, 255), *((model, 90) for model in FAMILIES)]
)
def test_the_outline_is_drawn_on_its_pixels_and_the_rest_is_left(model, camera, level):
    drawn = overlay.draw(picture(level), model, camera)
    outline = np.concatenate(superquadric.contour(model, camera).polygons)
    columns, rows = np.rint(outline).astype(int).T
    blue, green, red = drawn[rows, columns].T.astype(int)
    is_outline = (red > blue + 60) & (green > blue + 40)
    assert is_outline.mean() > 0.85
    low = np.maximum(np.array([columns.min(), rows.min()]) - 60, 0)
    high = np.array([columns.max(), rows.max()]) + 60
    drawn[low[1] : high[1], low[0] : high[0]] = level
    assert (drawn == level).all()


def test_of_the_rim_what_is_hidden_is_drawn_faintly():
    torus = FAMILIES[2]
    plain, drawn = picture(0), overlay.draw(picture(0), torus, CAMERA)
    for curve in superquadric.contour(torus, CAMERA).rim:
        assert curve.hidden.dtype == bool
        assert sum(len(run) - 1 for run in curve.runs(True)) == curve.hidden.sum()
        for run in curve.runs(True):
            columns, rows = np.rint(CAMERA.project(run)).astype(int).T
            assert (drawn[rows, columns] != plain[rows, columns]).any(axis=-1).mean() > 0.3
    hidden = sum(curve.hidden.sum() for curve in superquadric.contour(torus, CAMERA).rim)
    assert hidden > 20


def test_the_picture_given_is_left_and_a_grey_one_will_do():
    before = picture()
    drawn = overlay.draw(before, MODEL, CAMERA)
    assert (before == picture()).all()
    np.testing.assert_array_equal(overlay.draw(before[:, :, 0], MODEL, CAMERA), drawn)


@pytest.mark.parametrize("model", FAMILIES[:-1])
def test_points_are_blue_within_and_red_outside(model):
    vertices, _ = model.mesh(16)
    if hasattr(model, "clip"):
        # The function does not know of the caps.
        on_wall = np.abs(model.inside_outside(vertices) - 1) < 1e-9
        vertices = vertices[on_wall]
    surface = np.random.default_rng(1).permutation(vertices)[:400]
    normals = np.stack([_normal(model, x) for x in surface])
    plain = overlay.draw(picture(), model, CAMERA)
    for offset, is_red in [(-0.004, False), (0.004, True)]:
        points = surface + offset * normals
        drawn = overlay.draw(picture(), model, CAMERA, points=points)
        # Beside the lines, and above the scale.
        beside = (plain == picture()).all(axis=-1) & (np.arange(480) < 430)[:, np.newaxis]
        blue, _, red = drawn[beside].astype(int).T
        many, few = (red > blue + 40, blue > red + 40)[:: 1 if is_red else -1]
        assert many.sum() > 200
        assert few.sum() < 20


def _normal(model, x):
    gradient = model.inside_outside_gradient(x)
    length = np.linalg.norm(gradient)
    return gradient / length if 0 < length < np.inf else np.zeros(3)


def test_points_that_are_not_seen_are_not_drawn():
    plain = overlay.draw(picture(), MODEL, CAMERA)
    unseen = [[0.0, 0.0, -1.0], [np.nan, 0.0, 1.0]]
    np.testing.assert_array_equal(overlay.draw(picture(), MODEL, CAMERA, points=unseen), plain)


def test_a_fit_is_drawn_as_its_model():
    fit = superquadric.fit(MODEL.sample(500))
    np.testing.assert_array_equal(
        overlay.draw(picture(), fit, CAMERA), overlay.draw(picture(), fit.model, CAMERA)
    )


def test_what_cannot_be_drawn_is_refused(monkeypatch):
    for image in [picture()[:10], picture().astype(float), picture()[..., :2]]:
        with pytest.raises(superquadric.ArrayError, match="image: expected uint8"):
            overlay.draw(image, MODEL, CAMERA)
    with pytest.raises(superquadric.ViewError, match="not outside"):
        overlay.draw(picture(), superquadric.Superellipsoid([1, 1, 1], [1, 1]), CAMERA)
    monkeypatch.setitem(sys.modules, "cv2", None)
    with pytest.raises(overlay.MissingExtraError, match=r"superquadric\[overlay\]"):
        overlay.draw(picture(), MODEL, CAMERA)
