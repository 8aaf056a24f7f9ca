"""The command `python -m superquadric.batch`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from .._core import SuperquadricError
from ..progress import Progress
from .evaluation import evaluate
from .extras import MissingExtraError, require
from .table import HEADER, cells, markdown


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; its exit code: 0, 2 for what the user can mend, 130 if interrupted."""
    options = _parser().parse_args(arguments)
    try:
        _run(options)
    except (SuperquadricError, MissingExtraError, OSError) as error:
        print(f"superquadric.batch: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130
    return 0


def _run(options: argparse.Namespace) -> None:
    # What is missing is told before the fits, not after.
    if options.report is not None:
        require("matplotlib")
    if options.parquet is not None:
        require("pandas")
        require("pyarrow")
    evaluation = evaluate(
        options.suite,
        options.output,
        seed=options.seed,
        distance=options.distance,
        precision=options.precision,
        threads=options.threads,
        progress=Progress("scenes", sys.stderr),
    )
    print(markdown(HEADER, cells(evaluation.summary)), end="")
    if options.parquet is not None:
        evaluation.to_parquet(options.parquet)
    if options.report is not None:
        evaluation.write_report(options.report)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m superquadric.batch",
        description="Fits all scenes of a suite and scores them against the truth.",
    )
    parser.add_argument("suite", type=Path, metavar="SUITE_DIR", help="folder of the suite")
    parser.add_argument(
        "-o",
        dest="output",
        type=Path,
        required=True,
        metavar="RESULTS_DIR",
        help="folder of the results, new or of the same suite and options",
    )
    parser.add_argument("--report", type=Path, metavar="FILE", help="HTML file to write")
    parser.add_argument("--parquet", type=Path, metavar="FILE", help="table to write")
    parser.add_argument("--distance", choices=["radial", "geometric"], default="geometric")
    parser.add_argument("--precision", choices=["double", "single"], default="double")
    parser.add_argument("--seed", type=_seed, default=0, metavar="N")
    parser.add_argument(
        "--threads", type=_threads, metavar="N", help="scenes at a time (default: all cores)"
    )
    return parser


def _seed(text: str) -> int:
    if not text.isdecimal() or int(text) >= 2**64:
        raise argparse.ArgumentTypeError(f"must be a whole number below 2^64, found {text!r}")
    return int(text)


def _threads(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"must be a whole number from 1, found {text!r}")
    return int(text)


if __name__ == "__main__":
    sys.exit(main())
