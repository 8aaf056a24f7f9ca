"""Times rays of `superquadric render` beside open3d's at a fine mesh of the same scene.

Usage: python3 benches/rays.py   (builds the program first, unless SUPERQUADRIC_BINARY names it;
needs numpy and open3d)
"""

import json
import os
import statistics
import subprocess
import tempfile
import time
from functools import partial
from pathlib import Path

import numpy as np
import open3d

ROOT = Path(__file__).resolve().parent.parent
VARIABLE = "SUPERQUADRIC_BINARY"
PROGRAM = Path(os.environ.get(VARIABLE, ROOT / "target/release/superquadric")).resolve()
SCENES = ["moebius_band", "chair", "booleans"]
SCALE = 2
"""Times as many columns and rows as the samples have."""
RESOLUTION = 128
"""Segments of the meshes along a lattice's edge."""
RUNS = 3


def median_seconds(action) -> float:
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def enlarged(scene: dict, factor: float) -> dict:
    """The scene with a camera of so many times the columns and rows."""
    camera = dict(scene["camera"])
    for key in ("fx", "fy"):
        camera[key] *= factor
    for key in ("cx", "cy"):
        camera[key] = (camera[key] + 0.5) * factor - 0.5
    for key in ("width", "height"):
        camera[key] = max(1, round(camera[key] * factor))
    return {**scene, "camera": camera}


def seconds_of_ours(scene: dict, folder: Path, threads: int) -> float:
    """Seconds for the scene's rays, without those of a picture of a pixel: start, boxes, files."""
    environment = {**os.environ, "RAYON_NUM_THREADS": str(threads)}

    def seconds(factor: float) -> float:
        (folder / "scene.json").write_text(json.dumps(enlarged(scene, factor)))
        command = [PROGRAM, "render", "scene.json", "--depth", "depth.npy"]
        return median_seconds(
            lambda: subprocess.run(
                command, cwd=folder, env=environment, check=True, capture_output=True
            )
        )

    return seconds(SCALE) - seconds(1e-3)


def rays_of(scene: dict) -> np.ndarray:
    """Origins and directions in the world, of shape (rows, columns, 6)."""
    camera = scene["camera"]
    eye, target, up = (
        np.array(camera["view"][key], dtype=float) for key in ("eye", "target", "up")
    )
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    columns, rows = np.meshgrid(np.arange(camera["width"]), np.arange(camera["height"]))
    x, y = (columns - camera["cx"]) / camera["fx"], (rows - camera["cy"]) / camera["fy"]
    directions = forward + x[..., None] * right + y[..., None] * np.cross(forward, right)
    return np.concatenate([np.broadcast_to(eye, directions.shape), directions], axis=-1).astype(
        np.float32
    )


def caster_of(scene: Path, folder: Path) -> tuple[open3d.t.geometry.RaycastingScene, int]:
    """What open3d casts rays at, and the number of its triangles."""
    path = folder / "mesh.ply"
    command = [PROGRAM, "mesh", scene, "-o", path, "--resolution", str(RESOLUTION)]
    subprocess.run(command, check=True, capture_output=True)
    mesh = open3d.io.read_triangle_mesh(str(path))
    caster = open3d.t.geometry.RaycastingScene()
    caster.add_triangles(open3d.t.geometry.TriangleMesh.from_legacy(mesh))
    return caster, len(mesh.triangles)


def print_rows(sample: str, folder: Path, threads: list[int]) -> None:
    path = ROOT / f"samples/solids/{sample}.json"
    scene = json.loads(path.read_text())
    caster, triangles = caster_of(path, folder)
    rays = rays_of(enlarged(scene, SCALE))
    hit = np.isfinite(caster.cast_rays(rays)["t_hit"].numpy())
    for count in threads:
        ours = hit.size / seconds_of_ours(scene, folder, count)
        theirs = hit.size / median_seconds(partial(caster.cast_rays, rays, nthreads=count))
        cells = [
            sample,
            hit.size,
            triangles,
            f"{hit.mean():.0%}",
            count,
            f"{ours / 1e3:.0f}",
            f"{theirs / 1e3:.0f}",
        ]
        print("| " + " | ".join(map(str, cells)) + " |")


def main() -> None:
    if VARIABLE not in os.environ:
        subprocess.run(["cargo", "build", "--release", "--bins"], cwd=ROOT, check=True)
    processors = os.cpu_count() or 1
    print(f"open3d {open3d.__version__}, {processors} processors, load {os.getloadavg()[0]:.1f}\n")
    print("| scene | rays | triangles | hit | threads | ours, 1000/s | open3d, 1000/s |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        for sample in SCENES:
            print_rows(sample, Path(folder), [1, processors])


if __name__ == "__main__":
    main()
