"""Writes the scenes of this folder, after B84 and B81: python samples/solids/make.py."""

import json
import math
from pathlib import Path

FOLDER = Path(__file__).parent
ALONG_Y = [0, 1, 0]
BLUE, GREEN, RED, WOOD = [0.45, 0.62, 0.85], [0.5, 0.75, 0.5], [0.85, 0.45, 0.4], [0.75, 0.6, 0.42]


def model(size, exponents, deformations=(), pose=None):
    document = {"shape": {"family": "superellipsoid", "size": size, "exponents": exponents}}
    if deformations:
        document["deformations"] = list(deformations)
    if pose:
        document["pose"] = pose
    return document


def at(x, y, z=0.0, rotation=None):
    pose = {"translation": [x, y, z]}
    if rotation:
        pose["rotation"] = rotation
    return pose


def twist(rate, origin=(0, 0, 0)):
    profile = {"form": "line", "at_zero": 0, "slope": rate}
    return {"kind": "twist", "profile": profile, "axis": {"origin": list(origin), "direction": ALONG_Y}}


def taper(*knots):
    profile = {"form": "polyline", "knots": list(knots)}
    return {"kind": "taper", "profile": profile, "axis": {"direction": ALONG_Y}}


def bend(rate, center, range_):
    return {"kind": "bend", "rate": rate, "center": center, "range": list(range_)}


def row(parts):
    """Four parts beside each other."""
    return [part(i, at(-2.4 + 1.6 * i, 0)) for i, part in enumerate(parts)]


RIBBON = ([0.5, 2.0, 0.12], [0.2, 0.2])


def tapered_ribbons():
    """B84 Fig. 2.2."""
    share = [0.0, 0.2, 0.4, 0.6]
    return row([lambda i, pose: model(*RIBBON, [taper([-2, 1 + 0.3 * share[i]], [2, 1 - share[i]])], pose)] * 4)


def twisted_ribbons():
    """B84 Fig. 2.3.1."""
    return row([lambda i, pose: model(*RIBBON, [twist(i * math.pi / 8)], pose)] * 4)


def tapered_twisted_bent():
    """B84 Fig. 2.4.4a."""
    stages = [taper([-2, 1.3], [2, 0.5]), twist(0.8), bend(0.6, 0, [-1.3, 1.3])]
    return model([0.5, 2.0, 0.3], [0.2, 0.2], stages)


def moebius_band():
    """B84 Fig. 2.4.3: a twist by half a turn and a bend by a whole one."""
    stages = [twist(0.5), bend(1.0, 0, [-math.pi, math.pi])]
    return model([0.6, math.pi, 0.06], [0.2, 0.1], stages, at(0, 0, -1))


def leg(x, y):
    """A bar downwards whose foot is bent outwards."""
    outwards = [x / math.hypot(x, y + 0.5), (y + 0.5) / math.hypot(x, y + 0.5), 0]
    down = [0, 0, -1]
    across = cross(down, outwards)
    rotation = [[across[i], down[i], outwards[i]] for i in range(3)]
    foot = bend(2.5, 0.1, [0.1, 0.3])
    return model([0.05, 0.5, 0.05], [0.2, 1.0], [foot], at(x, y, -0.5, rotation))


def chair():
    """After B84 Fig. 2.4.5: six primitives and seven bends, z upwards."""
    seat_and_back = model([0.5, 1.0, 0.06], [0.2, 0.2], [bend(3.6, -0.2, [-0.2, 0.2])])
    quarter = math.pi / 2 / 0.2
    arm_rotation = [[0, 1, 0], [0, 0, -1], [-1, 0, 0]]
    bends = [bend(quarter, 0.42, [0.42, 0.62]), bend(quarter, -0.42, [-0.62, -0.42])]
    arms = model([0.045, 1.2, 0.045], [1.0, 0.2], bends, at(0, 0.07, 0.4, arm_rotation))
    legs = [leg(x, y) for x in (-0.4, 0.4) for y in (-0.88, -0.12)]
    return [seat_and_back, arms, *legs]


def booleans():
    """After B81 Fig. 11: union, intersection and difference of the same two."""

    def parts(x):
        box = model([0.8, 0.8, 0.8], [0.2, 0.2], pose=at(x, 0))
        return [box, model([0.75, 0.75, 0.75], [1.0, 1.0], pose=at(x + 0.45, -0.45, -0.45))]

    union, intersection, difference = parts(-2.6), parts(0.0), parts(2.2)
    return [{"union": union}, {"intersection": intersection}, {"difference": difference}]


def scene(solids, eye, target, up, colors=(BLUE,)):
    """Solids on a white ground, seen from `eye`, with a sun, a lamp beside the camera and a sky."""
    camera = {"kind": "pinhole", "fx": 420, "fy": 420, "cx": 199.5, "cy": 149.5, "width": 400, "height": 300}
    side = cross([t - e for t, e in zip(target, eye)], up)
    sun = [e - t + 1.5 * u * math.dist(eye, target) - 0.7 * s for e, t, u, s in zip(eye, target, up, side)]
    lamp = [e + 0.5 * s for e, s in zip(eye, side)]
    strength = 0.4 * math.dist(lamp, target) ** 2
    return {
        "schema": "superquadric.scene/1",
        "camera": {**camera, "view": {"eye": eye, "target": target, "up": up}},
        "ambient": [0.16, 0.17, 0.2],
        "lights": [
            {"kind": "directional", "to_light": sun, "color": [1, 0.97, 0.9], "intensity": 0.75},
            {"kind": "point", "position": lamp, "color": [0.85, 0.92, 1], "intensity": strength},
        ],
        "solids": [
            {"solid": solid, "material": {"color": colors[i % len(colors)]}} for i, solid in enumerate(solids)
        ],
    }


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


SCENES = {
    "tapered_ribbons": scene(tapered_ribbons(), [2, 2.5, 9], [0, 0, 0], [0, 1, 0]),
    "twisted_ribbons": scene(twisted_ribbons(), [2, 2.5, 9], [0, 0, 0], [0, 1, 0], [GREEN]),
    "tapered_twisted_bent": scene([tapered_twisted_bent()], [6, 2, 4], [0, 0, 0.6], [0, 0, 1]),
    "moebius_band": scene([moebius_band()], [5, 2, 3.2], [0, 0, 0], [0, 0, 1], [RED]),
    "chair": scene(chair(), [2.6, -4.0, 1.6], [0, -0.4, -0.05], [0, 0, 1], [RED, WOOD, WOOD, WOOD, WOOD, WOOD]),
    "booleans": scene(booleans(), [1, -5, -8], [0, 0, 0], [0, -1, 0], [BLUE, GREEN, RED]),
}

if __name__ == "__main__":
    for name, document in SCENES.items():
        (FOLDER / f"{name}.json").write_text(json.dumps(document) + "\n")
