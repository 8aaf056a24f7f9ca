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


@pytest.mark.parametrize("level", [0, 90, 255])
def test_the_outline_is_drawn_on_its_pixels_and_the_rest_is_left(level):
    drawn = overlay.draw(picture(level), MODEL, CAMERA)
    columns, rows = np.rint(superquadric.contour(MODEL, CAMERA).polygon).astype(int).T
    blue, green, red = drawn[rows, columns].T.astype(int)
    is_outline = (red > blue + 60) & (green > blue + 40)
    assert is_outline.mean() > 0.9
    low = np.array([columns.min(), rows.min()]) - 60
    high = np.array([columns.max(), rows.max()]) + 60
    drawn[low[1] : high[1], low[0] : high[0]] = level
    assert (drawn == level).all()


def test_the_picture_given_is_left_and_a_grey_one_will_do():
    before = picture()
    drawn = overlay.draw(before, MODEL, CAMERA)
    assert (before == picture()).all()
    np.testing.assert_array_equal(overlay.draw(before[:, :, 0], MODEL, CAMERA), drawn)


def test_points_are_blue_within_and_red_outside():
    surface = MODEL.sample(400, seed=1)
    centre = MODEL.translation
    for factor, is_red in [(0.95, False), (1.05, True)]:
        points = centre + factor * (surface - centre)
        drawn = overlay.draw(picture(), MODEL, CAMERA, points=points)
        plain = overlay.draw(picture(), MODEL, CAMERA)
        above_scale = (drawn != plain).any(axis=-1) & (np.arange(480) < 430)[:, np.newaxis]
        blue, _, red = drawn[above_scale].astype(int).T
        many, few = (red > blue + 40, blue > red + 40)[:: 1 if is_red else -1]
        assert many.sum() > 200
        assert few.sum() < 20
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
