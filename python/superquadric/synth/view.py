"""What an ideal camera sees."""

from dataclasses import dataclass

from .arrays import BoolArray, FloatArray


@dataclass(frozen=True)
class View:
    """An ideal camera's image, its arrays of shape (height, width).

    Attributes:
        depth: z in the camera's frame, in the suite's unit; infinite where there is nothing.
        is_object: whether the pixel shows the object.
        incidence: angle between the ray and the surface's normal, in radians; 0 where there is
            nothing.
    """

    depth: FloatArray
    is_object: BoolArray
    incidence: FloatArray
