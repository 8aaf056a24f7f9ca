"""Times the whole program `superquadric fit` on complete clouds, and measures its peak memory.

Usage: python3 benches/process.py   (builds the program and the clouds first; standard library)
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "target/release/superquadric"
GENERATOR = ROOT / "target/release/examples/complete_cloud"
POINTS = [1_000, 10_000, 100_000, 1_000_000]
RUNS = 7


def build() -> None:
    command = ["cargo", "build", "--release", "--example", "complete_cloud", "--bins"]
    subprocess.run(command, cwd=ROOT, check=True)


def measure(cloud: Path, threads: int) -> tuple[float, float]:
    """Wall-clock milliseconds and peak resident megabytes of one run."""
    arguments = [str(PROGRAM), "fit", str(cloud), "--threads", str(threads)]
    start = time.perf_counter()
    process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    milliseconds = 1e3 * (time.perf_counter() - start)
    if os.waitstatus_to_exitcode(status) not in (0, 1):
        sys.exit(f"{arguments} failed")
    return milliseconds, usage.ru_maxrss / 1024


def main() -> None:
    build()
    print("| points | threads | median ms | least | most | peak MB | cloud MB |")
    print("| ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        for points in POINTS:
            cloud = Path(folder) / f"{points}.ply"
            with cloud.open("wb") as file:
                subprocess.run([str(GENERATOR), str(points)], stdout=file, check=True)
            for threads in (1, 2):
                runs = [measure(cloud, threads) for _ in range(RUNS)]
                times = [milliseconds for milliseconds, _ in runs]
                peak = max(memory for _, memory in runs)
                print(
                    f"| {points} | {threads} | {statistics.median(times):.1f} | {min(times):.1f} "
                    f"| {max(times):.1f} | {peak:.1f} | {points * 24 / 1e6:.1f} |"
                )


if __name__ == "__main__":
    main()
