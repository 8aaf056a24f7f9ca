"""POV-Ray renders the exported scene: its silhouette and its depths are those of our model."""

import shutil
import subprocess

import numpy as np
import pytest

import superquadric

WIDTH, HEIGHT, FOCAL = 320, 240, 500.0
NEAR, FAR = 4.0, 12.0

# Our camera (x right, y down, z forward) at the origin; a colour proportional to depth, in 16 bits.
SCENE = f"""#version 3.7;
global_settings {{ assumed_gamma 1 }}
#declare Superquadric_Only = true;
#include "model.pov"
background {{ rgb 0 }}
camera {{
  location 0 direction z right x * {WIDTH / FOCAL} up -y * {HEIGHT / FOCAL}
}}
object {{
  Superquadric
  pigment {{
    gradient z color_map {{ [0 rgb 0] [1 rgb 1] }} scale {FAR - NEAR} translate {NEAR} * z
  }}
  finish {{ ambient 0 diffuse 0 emission 1 }}
}}
"""


@pytest.fixture(params=[(0.1, 0.1), (0.4, 1.3), (1.0, 0.2), (1.9, 1.9)], ids=str)
def model(request):
    return superquadric.Superellipsoid(
        [1.0, 2.0, 0.5], request.param, euler_zyz=[0.3, 1.1, -0.8], translation=[0.4, -0.3, 8.0]
    )


def rendered(folder, scene):
    """The picture of a scene, of 16 bits a channel."""
    cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed")
    if shutil.which("povray") is None:
        pytest.skip("POV-Ray is not installed (Debian's package povray)")
    command = ["povray", scene, f"+W{WIDTH}", f"+H{HEIGHT}", "-D", "-A", "+FN16", "File_Gamma=1.0"]
    result = subprocess.run(
        [*command, "+Opicture.png"], cwd=folder, capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stderr
    return cv2.imread(str(folder / "picture.png"), cv2.IMREAD_UNCHANGED)


def test_silhouette_and_depths_are_those_of_the_model(tmp_path, model):
    (tmp_path / "model.pov").write_text(superquadric.export_model(model, "pov"))
    (tmp_path / "scene.pov").write_text(SCENE)
    grey = rendered(tmp_path, "scene.pov")[..., 0]
    rows, columns = np.nonzero(grey)

    depth = NEAR + (FAR - NEAR) * grey[rows, columns] / 65535
    x = (columns - (WIDTH - 1) / 2) / FOCAL
    y = (rows - (HEIGHT - 1) / 2) / FOCAL
    points = depth[:, None] * np.column_stack([x, y, np.ones_like(x)])
    assert len(points) > 5000
    # Depths are rounded to 1.2e-4 along rays, POV-Ray finds its roots to 1e-4 of the unit shape.
    assert np.abs(model.radial_distance(points)).max() < 4e-4

    camera = superquadric.Camera(FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2, WIDTH, HEIGHT)
    import cv2

    outline = superquadric.contour(model, camera).polygons[0]
    column, row = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
    signed = np.array(
        [
            cv2.pointPolygonTest(outline.astype(np.float32), (float(c), float(r)), True)
            for c, r in zip(column.ravel(), row.ravel(), strict=True)
        ]
    ).reshape(HEIGHT, WIDTH)
    # Within a fiftieth of a pixel of the outline either answer is right.
    decided = np.abs(signed) > 0.02
    np.testing.assert_array_equal(grey[decided] > 0, signed[decided] > 0)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_the_scene_itself_shows_the_whole_solid_whatever_the_unit(tmp_path, scale):
    solid = superquadric.Superellipsoid(
        np.array([1.0, 2.0, 0.5]) * scale, [0.4, 1.3], translation=np.array([3.0, 5, -7]) * scale
    )
    (tmp_path / "model.pov").write_text(superquadric.export_model(solid, "pov"))
    picture = rendered(tmp_path, "model.pov")
    shown = (picture != picture[0, 0]).any(axis=2)
    assert 0.05 < shown.mean() < 0.5
    edge = np.concatenate([shown[0], shown[-1], shown[:, 0], shown[:, -1]])
    assert not edge.any()
