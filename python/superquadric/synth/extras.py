"""Packages that only `superquadric[synth]` asks for, imported when they are needed."""

import importlib
from typing import Any

from .errors import MissingExtraError


def require(package: str) -> Any:
    """The module of a package of the extra `synth`.

    Raises:
        MissingExtraError: if it, or a library of the system that it loads, is not there.
    """
    try:
        return importlib.import_module(package)
    except ImportError as error:
        raise MissingExtraError(
            f"{package} cannot be imported ({error}): pip install 'superquadric[synth]'; "
            "on Debian and Ubuntu open3d also needs libusb-1.0-0, libegl1, libgl1, libx11-6 and "
            "libidn2-0 from apt"
        ) from error
