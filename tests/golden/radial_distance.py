"""Writes radial_distance.tsv: the radial Euclidean distance of JLS Eq. 2.43 and its derivatives,
from the printed formula in 330-digit arithmetic, at adversarial points.

Usage: python tests/golden/radial_distance.py > tests/golden/radial_distance.tsv   (needs mpmath)
"""

import random

from mpmath import diff, exp, mp, mpf

mp.dps = 330

EXPONENTS = [0.05, 0.1, 0.3, 1.0, 1.7, 1.95, 2.0]
COORDINATES = [0.0, 1e-60, -1e-12, 1e-5, -0.3, 1.0, -1.0, 0.999999, 2.5, 1e6]
SIZES = [1.0, 0.01, 100.0, 0.7, 3.0]
ROWS = 400


def distance(a, e, x):
    """d = |x| (1 - F^(-e1/2)), with F of JLS Eq. 2.16."""
    xy = abs(x[0] / a[0]) ** (2 / e[1]) + abs(x[1] / a[1]) ** (2 / e[1])
    f = xy ** (e[1] / e[0]) + abs(x[2] / a[2]) ** (2 / e[0])
    radius = (x[0] ** 2 + x[1] ** 2 + x[2] ** 2) ** mpf("0.5")
    return radius * (1 - f ** (-e[0] / 2))


def replaced(values, k, value):
    return [value if i == k else v for i, v in enumerate(values)]


def derivatives(a, e, x):
    """By ln a1, ln a2, ln a3, e1, e2, x, y, z; by a coordinate that is zero it is zero."""
    out = [diff(lambda t, k=k: distance(replaced(a, k, a[k] * exp(t)), e, x), 0) for k in range(3)]
    out += [diff(lambda t, k=k: distance(a, replaced(e, k, t), x), e[k]) for k in range(2)]
    for k in range(3):
        along = lambda t, k=k: distance(a, e, replaced(x, k, x[k] * exp(t)))
        out.append(diff(along, 0) / x[k] if x[k] else mpf(0))
    return out


def main():
    rng = random.Random(1981)
    print("# a1 a2 a3 e1 e2 x y z d d_lna1 d_lna2 d_lna3 d_e1 d_e2 d_x d_y d_z")
    for _ in range(ROWS):
        a = [mpf(rng.choice(SIZES)) for _ in range(3)]
        e = [mpf(rng.choice(EXPONENTS)) for _ in range(2)]
        x = [mpf(0)] * 3
        while not any(x):
            x = [mpf(rng.choice(COORDINATES)) for _ in range(3)]
        row = [*a, *e, *x, distance(a, e, x), *derivatives(a, e, x)]
        print("\t".join(repr(float(v)) for v in row))


if __name__ == "__main__":
    main()
