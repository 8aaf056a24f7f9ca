"""Times `superquadric.read` of binary PLY beside what a NumPy user would write for a known layout:
a memory map of the bytes, and from it a float64 column for each of x, y and z.

Usage: python3 benches/reading.py [POINTS]   (needs numpy and the package, built with --release)

Both read the same file in turn, in one process, from the page cache. The medians of the processor's
time for it are compared, which other work on the machine changes little.
"""

import functools
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

import superquadric

POINTS = 5_000_000
RUNS = 15
FORMATS = {"<": "binary_little_endian", ">": "binary_big_endian"}
KINDS = {"f8": "double", "f4": "float"}
REMITTANCE = [("remittance", "u1")]
"""What stands beside the coordinates in rows that are not packed."""


def fields(order: str, kind: str) -> list[tuple[str, str]]:
    return [(axis, order + kind) for axis in "xyz"]


def write_ply(path: Path, points: np.ndarray, order: str, layout: list[tuple[str, str]]) -> int:
    """Writes a binary PLY and tells how long its header is."""
    names = {**KINDS, "u1": "uchar"}
    properties = [f"property {names[kind.lstrip('<>')]} {name}" for name, kind in layout]
    vertex = f"element vertex {len(points)}"
    lines = ["ply", f"format {FORMATS[order]} 1.0", vertex, *properties, "end_header", ""]
    rows = np.zeros(len(points), dtype=layout)
    for index, axis in enumerate("xyz"):
        rows[axis] = points[:, index]
    header = "\n".join(lines).encode()
    path.write_bytes(header + rows.tobytes())
    return len(header)


def plain(path: Path, header: int, layout: list[tuple[str, str]]) -> list[np.ndarray]:
    rows = np.memmap(path, dtype=layout, mode="r", offset=header)
    return [rows[axis].astype(np.float64) for axis in "xyz"]


def milliseconds(action: Callable[[], object]) -> float:
    start = time.process_time()
    action()
    return 1e3 * (time.process_time() - start)


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else POINTS
    points = np.random.default_rng(0).normal(size=(count, 3))
    print(f"{count} points, medians of {RUNS} runs of each, in turn, processor time\n")
    print("| rows | plain ms | superquadric.read ms | ratio |")
    print("| --- | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "cloud.ply"
        for kind in KINDS:
            for order in FORMATS:
                for others in ([], REMITTANCE):
                    layout = fields(order, kind) + others
                    header = write_ply(path, points, order, layout)
                    columns = plain(path, header, layout)
                    assert np.array_equal(superquadric.read(path), np.column_stack(columns))
                    del columns
                    read = functools.partial(plain, path, header, layout)
                    runs = [
                        (milliseconds(read), milliseconds(lambda: superquadric.read(path)))
                        for _ in range(RUNS)
                    ]
                    rival, ours = map(statistics.median, zip(*runs, strict=True))
                    name = f"{KINDS[kind]}, {FORMATS[order]}{', a byte beside' if others else ''}"
                    print(f"| {name} | {rival:.1f} | {ours:.1f} | {ours / rival:.2f} |")


if __name__ == "__main__":
    main()
