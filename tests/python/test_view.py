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


def pose(random):
    return {
        "euler_zyz": random.uniform(-3, 3, 3),
        "translation": [*random.uniform(-0.1, 0.1, 2), 1.5],
    }


def superellipsoid(random):
    size, exponents = random.uniform(0.1, 0.4, 3), random.uniform(0.1, 1.9, 2)
    return superquadric.Superellipsoid(size, exponents, **pose(random))


def supertoroid(random):
    size, exponents = random.uniform(0.05, 0.12, 3), random.uniform(0.3, 1.5, 2)
    return superquadric.Supertoroid(size, exponents, random.uniform(1.5, 3), **pose(random))


def one_sheet(random):
    size, exponents = random.uniform(0.08, 0.2, 3), random.uniform(0.3, 1.5, 2)
    clip = size[2] * random.uniform(0.5, 1.5)
    return superquadric.SuperhyperboloidOneSheet(size, exponents, clip, **pose(random))


def two_sheets(random):
    size, exponents = random.uniform(0.1, 0.2, 3), random.uniform(0.3, 1.5, 2)
    clip = size[0] * random.uniform(1.3, 2)
    return superquadric.SuperhyperboloidTwoSheets(size, exponents, clip, **pose(random))


def three_exponent(random):
    size, exponents = random.uniform(0.1, 0.4, 3), random.uniform(1.2, 8, 3)
    return superquadric.ThreeExponent(size, exponents, **pose(random))


@pytest.mark.parametrize(
    "drawn", [superellipsoid, supertoroid, one_sheet, two_sheets, three_exponent]
)
def test_contour_is_found_by_opencv_in_a_mask_cast_by_open3d(drawn):
    cv2, open3d = pytest.importorskip("cv2"), pytest.importorskip("open3d")
    random = np.random.default_rng(3)
    camera = square_camera()
    for _ in range(20 if drawn is superellipsoid else 6):
        model = drawn(random)
        vertices, triangles = model.mesh(200)
        scene = open3d.t.geometry.RaycastingScene()
        scene.add_triangles(vertices.astype(np.float32), triangles)
        u, v = np.meshgrid(np.arange(400), np.arange(400))
        rays = camera.rays(np.stack([u.ravel(), v.ravel()], axis=-1))
        rays = np.concatenate([np.zeros_like(rays), rays], axis=-1).astype(np.float32)
        hits = np.isfinite(scene.cast_rays(rays)["t_hit"].numpy()).reshape(400, 400)
        # Pixels of the mask next to others: of silhouettes and around holes.
        found, _ = cv2.findContours(hits.astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
        edge = np.concatenate(found).reshape(-1, 2).astype(np.float64)
        contour = superquadric.contour(model, camera)
        inside, distance = place(cv2, contour.polygons, edge)
        # They lie within the polygons, but nearer than a pixel to their edges: the mesh is a
        # hundredth off.
        assert (inside | (distance < 0.1)).all()
        assert distance.max() <= 1.01
        assert contour.area == pytest.approx(hits.sum(), abs=len(edge))
        (low, high), box = contour.bounding_box, cv2.boundingRect(hits.astype(np.uint8))
        assert (low < np.add(box[:2], 0.1)).all()
        assert (high > np.add(box[:2], box[2:]) - 1.1).all()


def place(cv2, polygons, pixels):
    """Whether pixels are within polygons, and how far from their sides."""
    signed = np.array(
        [
            [cv2.pointPolygonTest(polygon.astype(np.float32), pixel, True) for pixel in pixels]
            for polygon in polygons
        ]
    )
    return (signed > 0).sum(axis=0) % 2 == 1, np.abs(signed).min(axis=0)


def test_contour_is_the_image_of_its_rim():
    cv2 = pytest.importorskip("cv2")
    model = superquadric.Superellipsoid([0.1, 0.2, 0.3], [0.2, 1.5], translation=[0, 0, 2])
    for camera in [
        square_camera(),
        superquadric.OrthographicCamera([400, 300], [199.5, 99.5], 400, 400),
    ]:
        contour = superquadric.contour(model, camera)
        (curve,), (polygon,) = contour.rim, contour.polygons
        distances = [
            cv2.pointPolygonTest(polygon.astype(np.float32), pixel, True)
            for pixel in camera.project(curve.points)
        ]
        assert np.abs(distances).max() < 0.02
        assert not curve.hidden.any()
        np.testing.assert_allclose(model.gauge(curve.points), 1, atol=1e-13)
    with pytest.raises(superquadric.ViewError, match="not outside"):
        superquadric.contour(superquadric.Superellipsoid([1, 1, 1], [1, 1]), square_camera())
    for wrong, camera in [("model", square_camera()), (model, "camera")]:
        with pytest.raises(TypeError, match="expected a"):
            superquadric.contour(wrong, camera)


def test_cameras_of_either_kind_come_from_files(tmp_path):
    path = tmp_path / "camera.json"
    numbers = {"scale": [300, 200], "origin": [10, 20], "width": 64, "height": 48}
    path.write_text(json.dumps({"model": "orthographic", **numbers}))
    camera = superquadric.load_camera(path)
    assert camera == superquadric.OrthographicCamera(**numbers)
    assert {key: getattr(camera, key) for key in numbers} == numbers
    np.testing.assert_array_equal(camera.project([[1, 2, -5]]), [[310, 420]])
    numbers = {"fx": 600, "fy": 610.5, "cx": 319.5, "cy": 239.5, "width": 640, "height": 480}
    path.write_text(json.dumps(numbers))
    assert superquadric.load_camera(path) == superquadric.Camera(**numbers)
    with pytest.raises(superquadric.ModelError, match="a scale of two positive numbers"):
        superquadric.OrthographicCamera([300, 0], [10, 20], 64, 48)


def test_several_models_hide_each_other():
    ball = superquadric.Superellipsoid([0.1, 0.1, 0.1], [1, 1], translation=[0, 0, 1])
    behind = superquadric.Superellipsoid([0.1, 0.1, 0.1], [1, 1], translation=[0.2, 0, 2])
    contour = superquadric.contour([ball, behind], square_camera())
    front, back = contour.rim
    assert not front.hidden.any()
    assert 0.2 < back.hidden.mean() < 0.9
    apart = sum(superquadric.contour(each, square_camera()).area for each in (ball, behind))
    assert 0.5 * apart < contour.area < 0.95 * apart


def test_the_rim_of_a_ring_is_two_curves_part_of_which_it_hides():
    torus = superquadric.Supertoroid([1, 1, 1], [1, 1], 3)
    curves = superquadric.rim(torus, direction=[1, 0, 0.1], n=300)
    assert abs(sum(len(curve.points) for curve in curves) - 300) <= 2
    for curve in curves:
        np.testing.assert_allclose(torus.inside_outside(curve.points), 1, atol=1e-12)
        gradient = torus.inside_outside_gradient(curve.points)
        np.testing.assert_allclose(gradient @ [1, 0, 0.1], 0, atol=1e-9)
        steps = np.linalg.norm(curve.points - np.roll(curve.points, 1, axis=0), axis=-1)
        assert steps.max() < 1.05 * steps.min()
    assert 0 < sum(curve.hidden.sum() for curve in curves) < 300


def test_rim_is_where_lines_of_sight_touch():
    model = superquadric.Superellipsoid(
        [1, 2, 3], [0.7, 1.2], euler_zyz=[0.1, 0.2, 0.3], translation=[5, 6, 7]
    )
    centre = np.array([0.0, 1.0, -3.0])
    (curve,) = superquadric.rim(model, centre=centre, n=50)
    rim = curve.points
    assert rim.shape == (50, 3)
    np.testing.assert_allclose(model.gauge(rim), 1, atol=1e-13)
    assert (model.gauge(rim + 1e-3 * (rim - centre)) > 1).all()
    assert (model.gauge(rim - 1e-3 * (rim - centre)) > 1).all()
    (curve,) = superquadric.rim(model, direction=[0, 0, 1], n=50)
    flat = curve.points
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
