"""The order in which `superquadric.fit` tries its starts, with any descent."""

from dataclasses import dataclass

import numpy as np
import scipy_starts

from superquadric import Superellipsoid

WORTHWHILE = 0.99
SWITCH_ROUNDS = 4
CLEAR = 0.04
SAME_SIZE = 0.02
SAME_EXPONENT = 0.05


@dataclass(frozen=True)
class Descent:
    """Where a descent ended, and the cost there."""

    model: Superellipsoid
    cost: float


class Search:
    """Descents from one start after the other.

    Attributes:
        descents: those made so far, best first.
    """

    def __init__(self, descend):
        """`descend` makes a `Descent` of a model to start from."""
        self._descend = descend
        self.descents = []

    @property
    def best(self):
        """The descent of least cost."""
        return self.descents[0]

    def try_all(self, starts):
        """Descend from each model."""
        self.descents += map(self._descend, starts)
        self.descents.sort(key=lambda descent: descent.cost)

    def try_switches(self):
        """Descend from the switches of the best model, as long as that is worth while."""
        for _ in range(SWITCH_ROUNDS):
            before = self.best.cost
            self.try_all(scipy_starts.switches(self.best.model))
            if self.best.cost >= WORTHWHILE * before:
                return

    def has_clear_winner(self):
        """Whether the best minimum is far ahead of every other."""
        others = (d for d in self.descents if not _is_same_minimum(d.model, self.best.model))
        other = next(others, None)
        return other is not None and self.best.cost < CLEAR * other.cost


def from_principal_axes(points, descend):
    """The search by a user who knows that any of the principal axes may be z.

    Args:
        points: of shape (n, 3), normalised.
        descend: makes a `Descent` of a model to start from.
    """
    search = Search(descend)
    search.try_all(scipy_starts.principal(points))
    return search


def as_the_library(points, descend):
    """The search by the library's scheme: principal axes, switches, and frames between the axes.

    Args:
        points: of shape (n, 3), normalised.
        descend: makes a `Descent` of a model to start from.
    """
    search = from_principal_axes(points, descend)
    search.try_switches()
    if not search.has_clear_winner():
        before = search.best.cost
        search.try_all(scipy_starts.ambiguous(points))
        if search.best.cost < WORTHWHILE * before:
            search.try_switches()
    return search


def _is_same_minimum(a, b):
    a, b = a.canonical(), b.canonical()
    return bool(
        np.all(np.abs(a.size - b.size) <= SAME_SIZE * a.size)
        and np.all(np.abs(a.exponents - b.exponents) <= SAME_EXPONENT)
    )
