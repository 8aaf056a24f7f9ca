"""The printed formulas in NumPy, independent of the core that they check.

Points are of shape (n, 3), in the model's own frame. B81 is Barr 1981; JLS is Jaklic, Leonardis
and Solina 2000.
"""

import math

import numpy as np


def inside_outside(points, size, exponents):
    """The inside-outside function (B81; JLS Eq. 2.16)."""
    e1, e2 = exponents
    x, y, z = np.abs(np.asarray(points) / size).T
    return (x ** (2 / e2) + y ** (2 / e2)) ** (e2 / e1) + z ** (2 / e1)


def gauge(points, size, exponents):
    """The gauge `F^(e1/2)`."""
    return inside_outside(points, size, exponents) ** (exponents[0] / 2)


def radial_distance(points, size, exponents):
    """The signed radial Euclidean distance `|x| (1 - F^(-e1/2))` (JLS Eq. 2.43)."""
    return np.linalg.norm(points, axis=-1) * (1 - 1 / gauge(points, size, exponents))


def beta(a, b):
    """Euler's Beta function."""
    return math.exp(math.lgamma(a) + math.lgamma(b) - math.lgamma(a + b))


def volume(size, exponents):
    """The volume (JLS Eq. 2.59)."""
    e1, e2 = exponents
    return 2 * math.prod(size) * e1 * e2 * beta(e1 / 2, e1 + 1) * beta(e2 / 2, e2 / 2 + 1)


def rotation(phi, theta, psi):
    """The rotation `Rz(phi) Ry(theta) Rz(psi)` (JLS Eq. 2.34)."""

    def about_z(angle):
        c, s = math.cos(angle), math.sin(angle)
        return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])

    c, s = math.cos(theta), math.sin(theta)
    about_y = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return about_z(phi) @ about_y @ about_z(psi)
