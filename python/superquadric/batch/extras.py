"""Packages that only `superquadric[batch]` asks for, imported when they are needed."""

import importlib
from typing import Any


class MissingExtraError(ImportError):
    """A package of the extra `batch` that cannot be imported."""


def require(module: str) -> Any:
    """A module of a package of the extra `batch`.

    Raises:
        MissingExtraError: if it cannot be imported.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise MissingExtraError(
            f"{module} cannot be imported ({error}): pip install 'superquadric[batch]'"
        ) from error
