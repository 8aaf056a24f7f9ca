"""Depth maps of `superquadric render`, against open3d's rays at a fine mesh."""

import json
import subprocess

import numpy as np
import pytest

RESOLUTION = 64
"""Segments along an edge of the mesh's lattice."""

FINER = 3
"""Times as many has the mesh that tells how far the first is from the surface."""

MARGIN = 1.25
"""What the finer mesh's vertices show of that distance is a little less than the whole."""

CAMERA = {
    "kind": "pinhole",
    "fx": 300,
    "fy": 300,
    "cx": 99.5,
    "cy": 74.5,
    "width": 200,
    "height": 150,
}

MODELS = {
    "round": ({"size": [1.0, 0.6, 0.8], "exponents": [1.0, 1.0]}, []),
    "boxy": ({"size": [1.0, 0.6, 0.8], "exponents": [0.1, 0.1]}, []),
    "deformed": (
        {"size": [0.4, 1.0, 0.25], "exponents": [0.5, 0.7]},
        [
            {
                "kind": "twist",
                "profile": {"form": "line", "at_zero": 0, "slope": 0.6},
                "axis": {"direction": [0, 1, 0]},
            },
            {"kind": "bend", "rate": 0.8, "center": 0, "range": [-0.8, 0.8]},
        ],
    ),
}


def run(binary, folder, *arguments):
    subprocess.run([binary, *map(str, arguments)], cwd=folder, check=True, capture_output=True)


def mesh(open3d, binary, folder, resolution):
    run(binary, folder, "mesh", "scene.json", "-o", "mesh.ply", "--resolution", resolution)
    legacy = open3d.io.read_triangle_mesh(str(folder / "mesh.ply"))
    return open3d.t.geometry.TriangleMesh.from_legacy(legacy)


@pytest.mark.parametrize("name", MODELS)
def test_depths_are_those_of_open3d_at_a_fine_mesh(name, binary, tmp_path):
    open3d = pytest.importorskip(
        "open3d", reason="open3d is absent: nothing casts rays at the mesh"
    )
    shape, deformations = MODELS[name]
    pose = {"euler_zyz": [0.4, 1.0, -0.7], "translation": [0.1, -0.1, 4.0]}
    model = {
        "shape": {"family": "superellipsoid", **shape},
        "deformations": deformations,
        "pose": pose,
    }
    scene = {"solids": [{"solid": model}], "camera": CAMERA}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    run(binary, tmp_path, "render", "scene.json", "--depth", "depth.npy")
    depth = np.load(tmp_path / "depth.npy")

    caster = open3d.t.geometry.RaycastingScene()
    caster.add_triangles(mesh(open3d, binary, tmp_path, RESOLUTION))
    on_surface = mesh(open3d, binary, tmp_path, FINER * RESOLUTION).vertex.positions
    error = MARGIN * caster.compute_distance(on_surface).numpy().max()
    assert error < 2e-3
    columns, rows = np.meshgrid(np.arange(CAMERA["width"]), np.arange(CAMERA["height"]))
    x, y = (columns - CAMERA["cx"]) / CAMERA["fx"], (rows - CAMERA["cy"]) / CAMERA["fy"]
    directions = np.stack([x, y, np.ones_like(x)], axis=-1)
    rays = np.concatenate([np.zeros_like(directions), directions], axis=-1).astype(np.float32)
    cast = caster.cast_rays(rays)
    expected, normals = cast["t_hit"].numpy(), cast["primitive_normals"].numpy()

    hit = depth > 0
    assert hit.sum() > 3000
    # Every point that is seen lies on the mesh.
    seen = (depth[..., None] * directions)[hit].astype(np.float32)
    assert caster.compute_distance(seen).numpy().max() < error
    # What one hits and the other does not is at the outline: there the ray all but touches.
    differs = hit != np.isfinite(expected)
    assert differs.sum() <= 0.002 * hit.sum()
    # Where both hit, the rays end as far apart as the surfaces are, seen aslant.
    both = hit & np.isfinite(expected)
    facing = np.abs((normals * directions).sum(axis=-1))[both]
    apart = np.abs(depth - expected)[both]
    assert (facing > 0.2).mean() > 0.9
    assert (apart * facing)[facing > 0.2].max() < 2 * error
