"""An estimator after the conventions of scikit-learn, which it does not import."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ._core import Fit, Superellipsoid, fit

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike, NDArray

_OPTIONS = (
    "seed",
    "distance",
    "precision",
    "threads",
    "viewpoint",
    "free_rays",
    "support",
    "shape",
    "fix",
    "size_range",
    "exponent_range",
    "tie",
)


class SuperquadricEstimator:
    """Recovers a superellipsoid by `fit`, its options being parameters of the estimator.

    Args:
        seed: chooses the points that the first, coarse fits look at.
        distance: `radial` or `geometric`, that whose squares are minimised.
        precision: `double` or `single`, that of the rows of the points.
        threads: how many to use; by default as many as the machine offers.
        viewpoint: where the sensor stood, of shape (3,).
        free_rays: rays beside the object that came through, of shape (n, 4).
        support: the plane that the object stands on, (a, b, c, d).
        shape: `any`, `box`, `cylinder`, `ellipsoid` or `sphere`.
        fix: values of parameters that are known, by name.
        size_range: least and greatest semi-axis.
        exponent_range: least and greatest exponent.
        tie: semi-axes that are equal: `none`, `equator` or `all`.

    Attributes:
        model_: the recovered model.
        fit_: the model with the evidence for it.
        inlier_mask_: bool of shape (n,), true for finite rows that are more likely of the surface
            than strays.
        n_features_in_: 3.
    """

    model_: Superellipsoid
    fit_: Fit
    inlier_mask_: NDArray[np.bool_]
    n_features_in_: int

    def __init__(
        self,
        *,
        seed: int = 0,
        distance: Literal["radial", "geometric"] = "geometric",
        precision: Literal["double", "single"] = "double",
        threads: int | None = None,
        viewpoint: ArrayLike | None = None,
        free_rays: ArrayLike | None = None,
        support: ArrayLike | None = None,
        shape: Literal["any", "box", "cylinder", "ellipsoid", "sphere"] = "any",
        fix: Mapping[str, float] | None = None,
        size_range: tuple[float, float] | None = None,
        exponent_range: tuple[float, float] | None = None,
        tie: Literal["none", "equator", "all"] | None = None,
    ) -> None:
        """Store the options as they are; `fit` checks them."""
        self.seed = seed
        self.distance = distance
        self.precision = precision
        self.threads = threads
        self.viewpoint = viewpoint
        self.free_rays = free_rays
        self.support = support
        self.shape = shape
        self.fix = fix
        self.size_range = size_range
        self.exponent_range = exponent_range
        self.tie = tie

    def fit(self, X: ArrayLike, y: object = None) -> SuperquadricEstimator:  # noqa: N803
        """Fit points of shape (n, 3); `y` is ignored.

        Returns:
            The estimator itself.

        Raises:
            ArrayError: if the shape is not (n, 3).
            FitError: if the points do not determine a solid.
        """
        self.fit_ = fit(X, **self.get_params())
        self.model_ = self.fit_.model
        self.inlier_mask_ = self.fit_.inlier_mask
        self.n_features_in_ = 3
        return self

    def score(self, X: ArrayLike, y: object = None) -> float:  # noqa: N803
        """Rate how well the model explains points of shape (n, 3): 0 at best, else negative.

        Returns:
            Minus the root mean square of the radial distances of the finite rows, over the mean
            semi-axis; NaN without finite rows.
        """
        distance = self.model_.radial_distance(X)
        distance = distance[np.isfinite(distance)]
        if distance.size == 0:
            return float("nan")
        return -float(np.sqrt(np.mean(distance**2))) / self.model_.mean_semi_axis

    def get_params(self, deep: bool = True) -> dict[str, Any]:
        """Return the options by name; `deep` makes no difference."""
        return {name: getattr(self, name) for name in _OPTIONS}

    def set_params(self, **params: Any) -> SuperquadricEstimator:
        """Change options by name.

        Returns:
            The estimator itself.

        Raises:
            ValueError: if there is no option of that name.
        """
        for name, value in params.items():
            if name not in _OPTIONS:
                raise ValueError(f"no option {name!r}; there are {', '.join(_OPTIONS)}")
            setattr(self, name, value)
        return self

    def __repr__(self) -> str:
        """Show the options that are not the usual ones."""
        usual = SuperquadricEstimator().get_params()
        options = ", ".join(
            f"{name}={value!r}"
            for name, value in self.get_params().items()
            if value is not usual[name]
        )
        return f"SuperquadricEstimator({options})"
