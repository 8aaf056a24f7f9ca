"""What an ideal camera sees."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class View:
    """An ideal camera's image, its arrays of shape (height, width).

    Attributes:
        depth: z in the camera's frame, in the suite's unit; infinite where there is nothing.
        is_object: whether the pixel shows the object.
        incidence: angle between the ray and the surface's normal, in radians; 0 where there is
            nothing.
    """

    depth: NDArray[np.float64]
    is_object: NDArray[np.bool_]
    incidence: NDArray[np.float64]
