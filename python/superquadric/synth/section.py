"""Tables of a suite file whose every key must be known and of the right kind."""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import Any, NoReturn

from .errors import SuiteError

Range = tuple[float, float]
"""Least and greatest value; both are the same where there is no choice."""


class Section:
    """A table of a TOML file from which keys are taken one by one.

    Keys with a `default` may be left out, others may not. `finish` names the keys that nobody
    took.
    """

    def __init__(self, data: Any, where: str) -> None:
        """Read from `data`, which messages call `where`."""
        if not isinstance(data, dict):
            raise SuiteError(f"{where or 'the file'}: must be a table")
        self._data: dict[str, Any] = dict(data)
        self._known: list[str] = []
        self.where = where

    def name(self, key: str) -> str:
        """The key with the tables that it stands in."""
        return f"{self.where}.{key}" if self.where else key

    def fail(self, key: str, message: str) -> NoReturn:
        """Refuse the value of a key."""
        raise SuiteError(f"{self.name(key)}: {message}")

    def has(self, key: str) -> bool:
        """Whether the table holds a key that was not taken yet."""
        return key in self._data

    def text(self, key: str, default: str | None = None) -> str:
        """A text that is not empty."""
        value = self._take(key, default)
        if not isinstance(value, str) or not value:
            self.fail(key, f"must be a text, found {value!r}")
        return value

    def choice(self, key: str, choices: Collection[str], default: str | None = None) -> str:
        """One of some texts."""
        value = self.text(key, default)
        if value not in choices:
            self.fail(key, f"must be one of {', '.join(choices)}, found {value!r}")
        return value

    def choices(self, key: str, choices: Collection[str], default: list[str]) -> frozenset[str]:
        """Some of some texts."""
        values = self._take(key, default)
        if not isinstance(values, list) or any(value not in choices for value in values):
            self.fail(key, f"must be a list out of {', '.join(choices)}, found {values!r}")
        return frozenset(values)

    def whole(self, key: str, least: int) -> int:
        """A whole number, not below `least`."""
        value = self._take(key, None)
        if isinstance(value, bool) or not isinstance(value, int) or value < least:
            self.fail(key, f"must be a whole number from {least}, found {value!r}")
        return value

    def number(
        self, key: str, least: float, greatest: float = math.inf, default: float | None = None
    ) -> float:
        """A number from `least` to `greatest`."""
        return self._number(key, self._take(key, default), least, greatest)

    def span(
        self, key: str, least: float, greatest: float = math.inf, default: Range | None = None
    ) -> Range:
        """A number, or a pair of the least and the greatest, within `least` and `greatest`."""
        return self._range(key, self._take(key, default), least, greatest)

    def whole_span(self, key: str, least: int, greatest: int) -> tuple[int, int]:
        """A whole number or a pair of them, as in `span`."""
        low, high = self.span(key, least, greatest)
        if not (low.is_integer() and high.is_integer()):
            self.fail(key, f"must be whole, found {[low, high]!r}")
        return int(low), int(high)

    def spans(self, key: str, count: int, least: float, greatest: float) -> tuple[Range, ...]:
        """`count` entries, each of them as in `span`."""
        values = self._take(key, None)
        if not isinstance(values, list) or len(values) != count:
            self.fail(key, f"must be a list of {count} numbers or pairs, found {values!r}")
        return tuple(self._range(key, value, least, greatest) for value in values)

    def section(self, key: str, default: dict[str, Any] | None = None) -> Section:
        """The table under a key."""
        return Section(self._take(key, default), self.name(key))

    def sections(self, key: str) -> list[Section]:
        """The tables under a key, one at least."""
        values = self._take(key, None)
        if not isinstance(values, list) or not values:
            self.fail(key, "must be one table [[...]] at least")
        return [Section(value, f"{self.name(key)}[{i}]") for i, value in enumerate(values)]

    def finish(self) -> None:
        """Refuse keys that were not asked for."""
        if self._data:
            unknown = ", ".join(self.name(key) for key in self._data)
            raise SuiteError(f"unknown key {unknown} (known here: {', '.join(self._known)})")

    def _take(self, key: str, default: Any) -> Any:
        self._known.append(key)
        value = self._data.pop(key, default)
        if value is None:
            self.fail(key, "is missing")
        return value

    def _number(self, key: str, value: Any, least: float, greatest: float) -> float:
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if not is_number or not (least <= value <= greatest) or math.isinf(value):
            bounds = f"from {least:g}" + ("" if math.isinf(greatest) else f" to {greatest:g}")
            self.fail(key, f"must be a number {bounds}, found {value!r}")
        return float(value)

    def _range(self, key: str, value: Any, least: float, greatest: float) -> Range:
        pair = list(value) if isinstance(value, list | tuple) else [value, value]
        if len(pair) != 2:
            self.fail(key, f"must be a number or a pair of them, found {value!r}")
        low, high = (self._number(key, end, least, greatest) for end in pair)
        if low > high:
            self.fail(key, f"must be a pair in rising order, found {value!r}")
        return low, high
