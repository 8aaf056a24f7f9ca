"""open3d's depth maps against the core's own geometry, and where pixels and depths lie."""

import math

import numpy as np
import pytest

from superquadric import Superellipsoid
from superquadric.synth.camera import Camera
from superquadric.synth.render import render

open3d = pytest.importorskip("open3d", reason="depth maps need open3d: superquadric[synth]")

CAMERA = Camera(fx=150.0, fy=140.0, cx=70.25, cy=66.5, width=160, height=120, depth_unit=1e-4)

MESH = 1e-3
"""Of the mean semi-axis: thrice what the mesh was measured to err by at worst."""


def seen_points(model):
    view = render(model, CAMERA)
    return (CAMERA.rays() * np.where(view.is_object, view.depth, 0.0)[..., None])[view.is_object]


@pytest.mark.parametrize("exponents", [(0.1, 0.1), (0.1, 1.9), (1.9, 0.1), (1.9, 1.9), (1.0, 0.5)])
@pytest.mark.parametrize("size", [(1.0, 1.0, 1.0), (1.0, 0.25, 0.5), (0.05, 0.07, 1.0)])
def test_depth_maps_lie_on_the_surface(size, exponents):
    for angles in ([0.3, 1.1, -0.8], [2.0, 0.2, 0.5]):
        model = Superellipsoid(size, exponents, euler_zyz=angles, translation=[0.3, -0.2, 5.0])
        points_camera = seen_points(model)
        assert len(points_camera) > 20
        distance = np.abs(model.radial_distance(points_camera))
        assert distance.max() < MESH * model.mean_semi_axis


@pytest.mark.parametrize("centre", [(0.0, 0.0, 4.0), (1.0, -0.8, 4.0)])
def test_depth_is_z_and_not_the_length_of_the_ray(centre):
    view = render(Superellipsoid([1.0] * 3, [1.0, 1.0], translation=centre), CAMERA)
    rays = CAMERA.rays()
    # The nearer root of |z ray - centre|^2 = 1.
    a, b, c = (rays**2).sum(-1), rays @ centre, np.dot(centre, centre) - 1.0
    with np.errstate(invalid="ignore"):
        expected = (b - np.sqrt(b * b - a * c)) / a
    is_steep = view.is_object & (view.incidence < math.radians(60.0))
    # At 60 degrees a mesh inside the surface is met at twice its distance from it.
    np.testing.assert_allclose(view.depth[is_steep], expected[is_steep], rtol=0, atol=2 * MESH)
    # Lengths along the rays differ by far more.
    assert (expected * np.sqrt(a) - expected)[is_steep].max() > 20 * MESH


def test_integers_are_the_centres_of_pixels():
    view = render(Superellipsoid([1.0] * 3, [1.0, 1.0], translation=[0.0, 0.0, 4.0]), CAMERA)
    rows, columns = np.nonzero(view.is_object)
    # A disc of 2,900 pixels; its centre is found to some hundredths of one, not to a half.
    assert columns.mean() == pytest.approx(CAMERA.cx, abs=0.1)
    assert rows.mean() == pytest.approx(CAMERA.cy, abs=0.1)


def test_rays_are_those_of_open3d_half_a_pixel_aside():
    matrix = np.array([[CAMERA.fx, 0, CAMERA.cx + 0.5], [0, CAMERA.fy, CAMERA.cy + 0.5], [0, 0, 1]])
    tensors = open3d.core.Tensor(matrix), open3d.core.Tensor(np.eye(4))
    rays = open3d.t.geometry.RaycastingScene.create_rays_pinhole(
        *tensors, CAMERA.width, CAMERA.height
    ).numpy()
    # Single precision.
    np.testing.assert_allclose(rays[..., 3:], CAMERA.rays(), atol=1e-6)


def test_projection_is_that_of_opencv():
    cv2 = pytest.importorskip("cv2", reason="compares with OpenCV: superquadric[synth]")
    points = np.random.default_rng(0).uniform([-1, -1, 2], [1, 1, 5], (50, 3))
    matrix = np.array([[CAMERA.fx, 0, CAMERA.cx], [0, CAMERA.fy, CAMERA.cy], [0, 0, 1]])
    expected = cv2.projectPoints(points, np.zeros(3), np.zeros(3), matrix, None)[0][:, 0]
    np.testing.assert_allclose(CAMERA.project(points), expected, rtol=1e-12)


def test_rays_undo_the_projection():
    columns, rows = np.meshgrid(np.arange(CAMERA.width), np.arange(CAMERA.height))
    pixels = CAMERA.project((3.0 * CAMERA.rays()).reshape(-1, 3))
    expected = np.stack([columns.ravel(), rows.ravel()], axis=-1)
    np.testing.assert_allclose(pixels, expected, atol=1e-10)


def test_incidence_is_the_angle_to_the_normal():
    view = render(Superellipsoid([1.0] * 3, [1.0, 1.0], translation=[0.0, 0.0, 4.0]), CAMERA)
    points = CAMERA.rays() * np.where(view.is_object, view.depth, 1.0)[..., None]
    normals = points - [0.0, 0.0, 4.0]
    cosine = -(normals * points).sum(-1)
    cosine /= np.linalg.norm(normals, axis=-1) * np.linalg.norm(points, axis=-1)
    expected = np.arccos(cosine[view.is_object])
    # Triangles of a sphere with 512 of them around are tilted by half of 360 / 512 degrees, more
    # where the cube's corners stretch them.
    np.testing.assert_allclose(view.incidence[view.is_object], expected, atol=math.radians(1.5))


def test_a_table_and_a_wall_are_seen_behind_the_object():
    table = np.array([[-3.0, 1.0, 2.0], [3.0, 1.0, 2.0], [3.0, 1.0, 7.0], [-3.0, 1.0, 7.0]])
    model = Superellipsoid([0.5] * 3, [1.0, 1.0], translation=[0.0, 0.5, 4.0])
    view = render(model, CAMERA, table_camera=table, backdrop=9.0)
    height = (CAMERA.rays() * view.depth[..., None])[..., 1]
    is_table = ~view.is_object & (view.depth < 8.9)
    assert is_table.sum() > 1000
    # Single precision.
    np.testing.assert_allclose(height[is_table], 1.0, atol=1e-6)
    assert np.isin(view.depth[~view.is_object & ~is_table], 9.0).all()


def test_counts_of_depths_come_back_to_half_a_count():
    depth = np.array([[0.5, 6.5535, 6.56, math.inf]])
    counts = CAMERA.counts(depth)
    assert counts.dtype == np.uint16
    np.testing.assert_array_equal(counts, [[5000, 65535, 0, 0]])
    np.testing.assert_allclose(CAMERA.depth(counts), [[0.5, 6.5535, 0.0, 0.0]])
