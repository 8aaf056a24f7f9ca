"""Cameras and depth maps."""

import json
from pathlib import Path

import numpy as np
import pytest

import superquadric

RGBD = Path(__file__).parents[3] / "shared" / "data" / "rgbd"

LENS = [-0.28, 0.07, 1e-3, -5e-4, 0.01, 0.02, -0.03, 0.04]


@pytest.fixture
def camera():
    return superquadric.Camera(600, 610.5, 319.5, 239.5, 640, 480, distortion=LENS)


@pytest.fixture
def rgbd():
    if not RGBD.is_dir():
        pytest.skip(f"{RGBD} is absent")
    return RGBD


def test_projection_is_opencvs(camera):
    cv2 = pytest.importorskip("cv2")
    points = np.random.default_rng(0).uniform([-0.4, -0.3, 1], [0.4, 0.3, 2], size=(100, 3))
    matrix = np.array([[600, 0, 319.5], [0, 610.5, 239.5], [0, 0, 1]])
    expected, _ = cv2.projectPoints(points, np.zeros(3), np.zeros(3), matrix, np.array(LENS))
    pixels = camera.project(points)
    np.testing.assert_allclose(pixels, expected[:, 0], rtol=0, atol=1e-9)
    np.testing.assert_allclose(camera.rays(pixels), points / points[:, 2:], rtol=0, atol=1e-9)


def test_what_no_camera_sees_is_not_a_number(camera):
    assert np.isnan(camera.project([[0, 0, -1], [0, 0, 0], [np.nan, 0, 1]])).all()
    assert camera.project(np.empty((0, 3))).shape == (0, 2)


def test_a_camera_comes_from_its_file(tmp_path):
    path = tmp_path / "camera.json"
    numbers = {"fx": 600, "fy": 610.5, "cx": 319.5, "cy": 239.5, "width": 640, "height": 480}
    path.write_text(json.dumps({**numbers, "depth_units_m": 0.001, "distortion": LENS}))
    camera = superquadric.Camera.load(path)
    assert camera == superquadric.Camera(**numbers, distortion=LENS, depth_unit=0.001)
    assert {key: getattr(camera, key) for key in numbers} == numbers
    assert list(camera.distortion) == LENS
    path.write_text("{}")
    with pytest.raises(superquadric.ImageError, match=r"camera\.json.*fx"):
        superquadric.Camera.load(path)
    with pytest.raises(FileNotFoundError, match=r"none\.json"):
        superquadric.Camera.load(tmp_path / "none.json")


def test_what_is_no_camera_is_refused():
    with pytest.raises(superquadric.ModelError, match="fx"):
        superquadric.Camera(0, 1, 0, 0, 2, 2)
    with pytest.raises(superquadric.ModelError, match="k1 k2"):
        superquadric.Camera(1, 1, 0, 0, 2, 2, distortion=[1, 2])


def test_depth_maps_are_read_with_camera_and_mask(rgbd):
    camera = superquadric.Camera.load(rgbd / "intrinsics.json")
    depth, mask = rgbd / "sugar_depth.png", rgbd / "sugar_mask.png"
    image = superquadric.read_depth(depth, rgbd / "intrinsics.json", mask=mask)
    assert image.camera == camera
    assert image.depth.shape == (480, 640)
    points = image.object_points()
    pixels = camera.project(points)
    np.testing.assert_allclose(pixels, np.rint(pixels), rtol=0, atol=1e-9)
    columns, rows = np.rint(pixels).astype(int).T
    np.testing.assert_array_equal(image.depth[rows, columns], points[:, 2])
    assert len(image.surroundings()) > len(points) / 2

    whole = superquadric.read_depth(depth, camera, depth_unit=1e-3)
    assert len(whole.object_points()) == np.count_nonzero(image.depth)
    np.testing.assert_allclose(whole.depth, 10 * image.depth)
    assert whole.surroundings().shape == (0, 3)


def test_what_is_no_depth_map_is_refused(rgbd):
    with pytest.raises(superquadric.ImageError, match=r"sugar_mask\.png.*16 bits"):
        superquadric.read_depth(rgbd / "sugar_mask.png", rgbd / "intrinsics.json")
    with pytest.raises(FileNotFoundError, match=r"none\.png"):
        superquadric.read_depth(rgbd / "none.png", rgbd / "intrinsics.json")
    with pytest.raises(TypeError):
        superquadric.read_depth(rgbd / "sugar_mask.png", 3)


def square_camera(side=400, focal=500.0):
    middle = (side - 1) / 2
    return superquadric.Camera(focal, focal, middle, middle, side, side)


def test_contour_is_found_by_opencv_in_a_mask_cast_by_open3d():
    cv2, open3d = pytest.importorskip("cv2"), pytest.importorskip("open3d")
    random = np.random.default_rng(3)
    camera = square_camera()
    for _ in range(20):
        model = superquadric.Superellipsoid(
            random.uniform(0.1, 0.4, 3),
            random.uniform(0.1, 1.9, 2),
            euler_zyz=random.uniform(-3, 3, 3),
            translation=[*random.uniform(-0.1, 0.1, 2), 1.5],
        )
        vertices, triangles = model.mesh(200)
        scene = open3d.t.geometry.RaycastingScene()
        scene.add_triangles(vertices.astype(np.float32), triangles)
        u, v = np.meshgrid(np.arange(400), np.arange(400))
        rays = camera.rays(np.stack([u.ravel(), v.ravel()], axis=-1))
        rays = np.concatenate([np.zeros_like(rays), rays], axis=-1).astype(np.float32)
        hits = np.isfinite(scene.cast_rays(rays)["t_hit"].numpy()).reshape(400, 400)
        found, _ = cv2.findContours(hits.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        contour = superquadric.contour(model, camera)
        polygon = contour.polygon.astype(np.float32)
        edge = np.concatenate(found).reshape(-1, 2).astype(np.float64)
        distances = [cv2.pointPolygonTest(polygon, pixel, True) for pixel in edge.tolist()]
        # Pixels of the mask, so within the polygon, but nearer than a pixel to its edge.
        assert min(distances) > -0.1
        assert max(distances) <= 1.0
        assert contour.area == pytest.approx(hits.sum(), abs=len(edge))
        (low, high), box = contour.bounding_box, cv2.boundingRect(hits.astype(np.uint8))
        assert (low < np.add(box[:2], 0.1)).all()
        assert (high > np.add(box[:2], box[2:]) - 1.1).all()


def test_contour_is_the_image_of_its_rim():
    camera = square_camera()
    model = superquadric.Superellipsoid([0.1, 0.2, 0.3], [0.2, 1.5], translation=[0, 0, 2])
    contour = superquadric.contour(model, camera)
    np.testing.assert_allclose(camera.project(contour.rim), contour.polygon, atol=1e-9)
    np.testing.assert_allclose(model.gauge(contour.rim), 1, atol=1e-13)
    with pytest.raises(superquadric.ViewError, match="not outside"):
        superquadric.contour(superquadric.Superellipsoid([1, 1, 1], [1, 1]), camera)
    with pytest.raises(TypeError):
        superquadric.contour("model", camera)


def test_rim_is_where_lines_of_sight_touch():
    model = superquadric.Superellipsoid(
        [1, 2, 3], [0.7, 1.2], euler_zyz=[0.1, 0.2, 0.3], translation=[5, 6, 7]
    )
    centre = np.array([0.0, 1.0, -3.0])
    rim = superquadric.rim(model, centre=centre, n=50)
    assert rim.shape == (50, 3)
    np.testing.assert_allclose(model.gauge(rim), 1, atol=1e-13)
    assert (model.gauge(rim + 1e-3 * (rim - centre)) > 1).all()
    assert (model.gauge(rim - 1e-3 * (rim - centre)) > 1).all()
    flat = superquadric.rim(model, direction=[0, 0, 1], n=50)
    assert (model.gauge(flat + np.array([0, 0, 1e-3])) > 1).all()
    for arguments in [{}, {"centre": centre, "direction": centre}]:
        with pytest.raises(TypeError, match="either centre or direction"):
            superquadric.rim(model, **arguments)
    with pytest.raises(superquadric.ViewError):
        superquadric.rim(model, centre=[5, 6, 7])


def test_lines_of_the_surface_are_within_the_outline():
    camera = square_camera()
    model = superquadric.Superellipsoid([0.1, 0.2, 0.3], [0.2, 1.5], translation=[0, 0, 2])
    low, high = superquadric.contour(model, camera).bounding_box
    visible, hidden = superquadric.wireframe(model, camera)
    for lines in (visible, hidden):
        pixels = np.concatenate(lines)
        assert len(lines) > 10
        assert (pixels > low - 0.02).all()
        assert (pixels < high + 0.02).all()
