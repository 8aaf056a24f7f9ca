"""Times `superquadric batch`, in scenes a second a thread, and one fit of a million points, on one
thread and on more.

Usage: python3 benches/scaling.py [THREADS ...]   (default: 1 2; builds the program and what makes
the cloud first; needs the package with what its `synth` needs for whole surfaces, and numpy)

The scenes are those of data_synth/full-noise.toml, whole surfaces of 1,000 points.
"""

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import superquadric

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "target/release/superquadric"
GENERATOR = ROOT / "target/release/examples/complete_cloud"
SUITE = ROOT / "data_synth/full-noise.toml"
POINTS = 1_000_000
RUNS = 7


def build() -> None:
    command = ["cargo", "build", "--release", "--example", "complete_cloud", "--bins"]
    subprocess.run(command, cwd=ROOT, check=True)


def make_data(folder: Path) -> tuple[Path, Path]:
    """A suite and a cloud."""
    suite, cloud = folder / "suite", folder / "cloud.ply"
    maker = [sys.executable, "-m", "superquadric.synth", str(SUITE), "-o", str(suite)]
    subprocess.run(maker, check=True)
    with cloud.open("wb") as file:
        subprocess.run([GENERATOR, str(POINTS)], stdout=file, check=True)
    return suite, cloud


def seconds(action: Callable[[], object]) -> float:
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


def evaluate(suite: Path, threads: int) -> None:
    with tempfile.TemporaryDirectory() as results:
        command = [PROGRAM, "batch", suite, "-o", results, "--threads", str(threads)]
        subprocess.run(command, check=True, capture_output=True)


def measure(counts: list[int], action: Callable[[int], object]) -> list[list[float]]:
    """Milliseconds of each run for each number of threads, in turn, so that what else the machine
    does strikes all alike."""
    runs = [[1e3 * seconds(lambda n=n: action(n)) for n in counts] for _ in range(RUNS)]
    return [list(times) for times in zip(*runs, strict=True)]


def print_table(work: str, scenes: int, counts: list[int], columns: list[list[float]]) -> None:
    print(f"\n| {work}, threads | median ms | least | most | speed-up | a second a thread |")
    print("| ---: | ---: | ---: | ---: | ---: | ---: |")
    first = statistics.median(columns[0])
    for threads, times in zip(counts, columns, strict=True):
        median = statistics.median(times)
        print(
            f"| {threads} | {median:.0f} | {min(times):.0f} | {max(times):.0f} "
            f"| {first / median:.2f} | {1e3 * scenes / median / threads:.0f} |"
        )


def main() -> None:
    counts = [int(count) for count in sys.argv[1:]] or [1, 2]
    build()
    with tempfile.TemporaryDirectory() as folder:
        suite, cloud = make_data(Path(folder))
        scenes = sum(1 for _ in (suite / "scenes").iterdir())
        points = superquadric.read(cloud)
        batch = measure(counts, lambda threads: evaluate(suite, threads))
        fit = measure(counts, lambda threads: superquadric.fit(points, threads=threads))
    print_table(f"batch of {scenes} scenes", scenes, counts, batch)
    print_table(f"fit of {POINTS} points", 1, counts, fit)


if __name__ == "__main__":
    main()
