"""Draws docs/pictures/overlay.png: a made photograph of a rounded box, and the fit drawn over it.

Usage: python docs/pictures/overlay.py   (needs the package with its extras synth and overlay)
"""

from pathlib import Path

import cv2
import numpy as np
import open3d

import superquadric
from superquadric import overlay

PICTURE = Path(__file__).with_suffix(".png")
WIDTH, HEIGHT, FOCAL = 640, 400, 620.0
FINER = 3  # rays along each side of a pixel of the photograph
NOISE = 0.001  # metres along the rays
BOX = ([0.055, 0.085, 0.11], [0.2, 0.35])
TILT = np.radians(30.0)  # of the camera, down to the table
LIGHT = np.array([-0.5, -0.75, -0.45])  # towards it, in the camera's frame
WOOD, PAINT = np.array([0.42, 0.55, 0.68]), np.array([0.80, 0.56, 0.30])  # blue, green, red


def camera(finer: int) -> superquadric.Camera:
    """The camera, with so many rays along each side of a pixel."""
    middle = [(finer * side - 1) / 2 for side in (WIDTH, HEIGHT)]
    focal = finer * FOCAL
    return superquadric.Camera(focal, focal, *middle, finer * WIDTH, finer * HEIGHT)


def world() -> tuple[superquadric.Superellipsoid, np.ndarray, np.ndarray]:
    """The box in the camera's frame, the table's upward normal, and a point of the table."""
    up = np.array([0.0, -np.cos(TILT), -np.sin(TILT)])
    across = np.array([1.0, 0.0, 0.0])
    turn = np.radians(35.0)
    side = np.cos(turn) * across + np.sin(turn) * np.cross(up, across)
    rotation = np.stack([side, np.cross(up, side), up], axis=1)
    centre = np.array([0.0, 0.02, 0.75])
    box = superquadric.Superellipsoid(*BOX, rotation=rotation, translation=centre)
    return box, up, centre - BOX[0][2] * up


def cast(origins: np.ndarray, directions: np.ndarray, box: superquadric.Superellipsoid) -> dict:
    """Where rays of shape (n, 3) hit the box, and its normals there."""
    vertices, triangles = box.mesh(160)
    scene = open3d.t.geometry.RaycastingScene()
    scene.add_triangles(vertices.astype(np.float32), triangles)
    rays = np.concatenate([origins, directions], axis=1).astype(np.float32)
    return {key: value.numpy() for key, value in scene.cast_rays(rays).items()}


def rays_of(view: superquadric.Camera) -> np.ndarray:
    u, v = np.meshgrid(np.arange(view.width), np.arange(view.height))
    return view.rays(np.stack([u.ravel(), v.ravel()], axis=1))


def photograph() -> np.ndarray:
    """The box on a wooden table in lamplight, with its shadow."""
    box, up, foot = world()
    light = LIGHT / np.linalg.norm(LIGHT)
    directions = rays_of(camera(FINER))
    hits = cast(np.zeros_like(directions), directions, box)
    to_table = (foot @ up) / np.minimum(directions @ up, -1e-6)
    table = directions * to_table[:, None]
    grain = 0.04 * np.sin(120 * (table[:, 0] + 0.1 * np.sin(9 * table[:, 2])))
    shadow = np.isfinite(cast(table + 1e-4 * up, np.broadcast_to(light, table.shape), box)["t_hit"])
    wood = WOOD * (0.75 + grain - 0.3 * shadow)[:, None]
    shade = 0.35 + 0.65 * np.clip(hits["primitive_normals"] @ light, 0, 1)
    colors = np.where(np.isfinite(hits["t_hit"])[:, None], PAINT * shade[:, None], wood)
    finer = colors.reshape(HEIGHT, FINER, WIDTH, FINER, 3).mean(axis=(1, 3))
    return np.rint(255 * np.clip(finer, 0, 1)).astype(np.uint8)


def measured_points() -> np.ndarray:
    """What a range camera in the same place measures of the box."""
    box, _, _ = world()
    directions = rays_of(camera(1))
    depth = cast(np.zeros_like(directions), directions, box)["t_hit"].astype(float)
    depth += np.random.default_rng(0).normal(scale=NOISE, size=depth.shape)
    return (directions * depth[:, None])[np.isfinite(depth)]


def main() -> None:
    points = measured_points()
    fit = superquadric.fit(points)
    shown = np.random.default_rng(1).choice(points, size=700, replace=False)
    drawn = overlay.draw(photograph(), fit, camera(1), points=shown)
    cv2.imwrite(str(PICTURE), drawn)


if __name__ == "__main__":
    main()
