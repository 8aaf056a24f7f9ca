"""Makes docs/profile.md: what the time of a fit is spent on, by `perf`, one thread.

Usage: python3 benches/profile.py   (Linux; needs `perf`; builds the benchmark `fit` by itself, in
target/profile, with frame pointers, and without the link-time optimisation that would merge stages)
"""

import collections
import datetime
import json
import os
import re
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/profile.md"
SECONDS = 5
FREQUENCY = 1999
CLOUDS = {
    "1,000 points": "complete cloud/geometric, double, Mean/1000$",
    "10,000 points": "complete cloud/geometric, double, Mean/10000$",
    "1,000,000 points": "complete cloud/geometric, double, Mean/1000000$",
    "2,000 points of one side, 20 % of them strays": (
        "hard clouds/geometric/one side, 20 % of strays$"
    ),
}
FIT = "recover::fit::"

# Patterns of functions; whichever of these comes first counts.
STAGES = {
    "survey: neighbours, clutter, area": "survey::Survey::of",
    "strays: the mixture, settled and searched again": "strays::fit_among_clutter",
    "a look for outliers": "strays::set_outliers_apart",
    "coarse search, 256 points": "search::Search::coarse",
    "the best few minima, on more points and on all": "recover::found::",
    "uncertainty": "recover::uncertainty|fit::uncertainty_of",
    "moments and the rest": FIT,
}

# The same; whichever the innermost function has counts.
WORKS = {
    "passes: rows and their products": "recover::kernel::gram",
    "distances without derivatives": "geometric_distances",
    "optimiser: factors, steps, charts": "levenberg_marquardt::|recover::compressed|recover::chart",
    "neighbours": "recover::neighbours",
    "mixture: densities and weights": "recover::mixture|recover::alternation",
    "clutter statistics": "recover::clutter",
    "everything else": FIT,
}

TEXT = """# What the time of a fit is spent on

Made on {date} by `python3 benches/profile.py` on {cpu}: shares of the samples that `perf` took of
`cargo bench --bench fit`, default options, one thread, in per cent.

## By stage

{stages}
## By work

{works}"""


def build() -> Path:
    """Builds the benchmark and tells where it is."""
    variables = {
        "RUSTFLAGS": "-C force-frame-pointers=yes",
        "CARGO_PROFILE_BENCH_LTO": "false",
        "CARGO_PROFILE_BENCH_CODEGEN_UNITS": "16",
    }
    command = ["cargo", "bench", "--bench", "fit", "--no-run", "--message-format=json"]
    command += ["--target-dir", "target/profile"]
    run = subprocess.run(
        command, cwd=ROOT, env={**os.environ, **variables}, check=True, stdout=subprocess.PIPE
    )
    messages = map(json.loads, run.stdout.splitlines())
    binaries = [m["executable"] for m in messages if m.get("target", {}).get("name") == "fit"]
    return Path(next(filter(None, binaries)))


def stacks(binary: Path, name: str) -> list[list[str]]:
    """The functions of each sample within a fit, the innermost first."""
    with tempfile.TemporaryDirectory() as folder:
        data = f"{folder}/perf.data"
        record = ["perf", "record", "-q", "-F", str(FREQUENCY), "--call-graph", "fp", "-o", data]
        bench = [str(binary), "--bench", "--profile-time", str(SECONDS), name]
        subprocess.run(record + bench, cwd=ROOT, check=True, capture_output=True)
        script = ["perf", "script", "-F", "ip,sym", "-i", data]
        text = subprocess.run(script, check=True, capture_output=True, text=True).stdout
    samples = [block.splitlines() for block in text.split("\n\n")]
    return [sample for sample in samples if any(FIT in frame for frame in sample)]


def stage_of(sample: list[str]) -> str:
    """The first of the stages that is anywhere in a sample's stack."""
    return next(
        name
        for name, pattern in STAGES.items()
        if any(re.search(pattern, frame) for frame in sample)
    )


def work_of(sample: list[str]) -> str:
    """The work of the innermost frame in a sample's stack that tells it."""
    return next(
        name for frame in sample for name, pattern in WORKS.items() if re.search(pattern, frame)
    )


def shares(of: collections.Counter, classes: dict[str, str]) -> list[float]:
    """The share of the samples in each class, in per cent."""
    return [100 * of[name] / of.total() for name in classes]


def table(columns: dict[str, list[float]], rows: list[str]) -> str:
    head = f"| | {' | '.join(columns)} |\n|---|{'---:|' * len(columns)}\n"
    values = zip(*columns.values(), strict=True)
    numbers = [" | ".join(f"{value:.0f}" for value in of) for of in values]
    lines = [f"| {row} | {of} |\n" for row, of in zip(rows, numbers, strict=True)]
    return head + "".join(lines)


def cpu() -> str:
    names = re.findall(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    return names[0] if names else "an unknown processor"


def main() -> None:
    binary = build()
    samples = {name: stacks(binary, bench) for name, bench in CLOUDS.items()}
    count = collections.Counter
    stages = {name: shares(count(map(stage_of, of)), STAGES) for name, of in samples.items()}
    works = {name: shares(count(map(work_of, of)), WORKS) for name, of in samples.items()}
    page = TEXT.format(
        date=datetime.date.today().isoformat(),
        cpu=cpu(),
        stages=table(stages, list(STAGES)),
        works=table(works, list(WORKS)),
    )
    PAGE.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
