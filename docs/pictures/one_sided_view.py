"""Draws docs/pictures/one_sided_view.png: the sample cloud, and what `superquadric fit` finds.

Usage: python docs/pictures/one_sided_view.py   (needs numpy, matplotlib, and the release build)
"""

import subprocess
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

ROOT = Path(__file__).resolve().parents[2]
CLOUD = ROOT / "samples/one_sided_view.ply"
PICTURE = Path(__file__).with_suffix(".png")
LIGHT = np.array([-0.4, -0.7, -0.6]) / np.linalg.norm([-0.4, -0.7, -0.6])
AMBIENT = 0.35


def read_cloud() -> np.ndarray:
    lines = CLOUD.read_text().splitlines()
    return np.loadtxt(lines[lines.index("end_header") + 1 :])


def recovered_mesh() -> tuple[np.ndarray, np.ndarray]:
    """Vertices (v, 3) and triangles (t, 3) of the recovered surface."""
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder) / "fit.obj"
        program = ROOT / "target/release/superquadric"
        command = [str(program), "fit", str(CLOUD), "--mesh", str(mesh), "--resolution", "24"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        lines = [line.split() for line in mesh.read_text().splitlines()]
    vertices = np.array([words[1:] for words in lines if words and words[0] == "v"], dtype=float)
    faces = [words[1:] for words in lines if words and words[0] == "f"]
    return vertices, np.array(faces, dtype=int) - 1


def draw(axes: plt.Axes, points: np.ndarray, mesh: tuple | None, from_behind: bool) -> None:
    """Draws points and mesh; from behind, the mesh covers the points and the light is there."""
    if mesh is not None:
        triangles = mesh[0][mesh[1]]
        normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        light = LIGHT * [1, 1, -1] if from_behind else LIGHT
        shade = AMBIENT + (1 - AMBIENT) * np.clip(normals @ light, 0, 1)
        colours = shade[:, None] * np.array([[0.45, 0.66, 0.86]])
        surface = Poly3DCollection(triangles[:, :, [0, 2, 1]], facecolors=colours, zorder=1)
        axes.add_collection3d(surface)
    x, y, z = points.T
    order = 0 if from_behind else 2
    axes.scatter(x, z, y, s=1.2, c="#d1495b", depthshade=False, zorder=order)


def main() -> None:
    points, mesh = read_cloud(), recovered_mesh()
    low, high = mesh[0].min(axis=0), mesh[0].max(axis=0)
    figure = plt.figure(figsize=(9, 3.2), dpi=110)
    views = [
        ("what the camera sees", -90, None),
        ("what is recovered", -90, mesh),
        ("its other side", 60, mesh),
    ]
    for k, (title, azimuth, surface) in enumerate(views, start=1):
        axes = figure.add_subplot(1, 3, k, projection="3d", computed_zorder=False)
        draw(axes, points, surface, from_behind=azimuth > 0)
        axes.set_title(title, fontsize=10)
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[2], high[2])
        axes.set_zlim(high[1], low[1])
        axes.set_box_aspect((high - low)[[0, 2, 1]])
        axes.view_init(elev=15, azim=azimuth)
        axes.set_axis_off()
    figure.subplots_adjust(left=0, right=1, bottom=0, top=0.92, wspace=0)
    figure.savefig(PICTURE)


if __name__ == "__main__":
    main()
