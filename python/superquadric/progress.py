"""A bar on a terminal, and nothing elsewhere."""

from __future__ import annotations

from typing import TextIO

WIDTH = 30


class Progress:
    """Shows how many scenes are done; call it with that number and the number of all."""

    def __init__(self, label: str, stream: TextIO) -> None:
        """Show on a stream."""
        self._label, self._stream, self._done = label, stream, 0

    def __call__(self, done: int, total: int) -> None:
        """Redraw the bar, and end its line when all is done.

        Threads may call out of order: what is older than what is shown is left out.
        """
        if done < self._done or not self._stream.isatty():
            return
        self._done = done
        full = WIDTH * done // total
        bar = "#" * full + "." * (WIDTH - full)
        end = "\n" if done == total else ""
        self._stream.write(f"\r{self._label} [{bar}] {done}/{total}{end}")
        self._stream.flush()
