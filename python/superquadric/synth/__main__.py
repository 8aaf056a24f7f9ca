"""The command `python -m superquadric.synth`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from ..progress import Progress
from .errors import SynthError
from .generate import generate
from .suite import Suite
from .suite_file import read_suite

SHIPPED = Path("data_synth")
"""Where the suites stand, seen from the root of the repository."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; its exit code: 0, 2 for what the user can mend, 130 if interrupted."""
    parser = _parser()
    options = parser.parse_args(arguments)
    try:
        if options.list is not None:
            _list(options.list)
        elif options.suite is None or options.output is None:
            parser.error("needs a suite file and -o DIR, or --list")
        else:
            suite = read_suite(options.suite)
            bar = Progress(suite.name, sys.stderr)
            generate(suite, options.output, jobs=options.jobs, on_scene=bar)
    except (SynthError, OSError) as error:
        print(f"superquadric.synth: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m superquadric.synth",
        description="Makes clouds and depth maps of superquadrics whose truth is known.",
    )
    parser.add_argument("suite", nargs="?", type=Path, metavar="SUITE.toml", help="what to make")
    parser.add_argument(
        "-o", dest="output", type=Path, metavar="DIR", help="folder to write, new or empty"
    )
    parser.add_argument(
        "--jobs", type=_jobs, default=1, metavar="N", help="processes (default: %(default)s)"
    )
    parser.add_argument(
        "--list",
        nargs="?",
        type=Path,
        const=SHIPPED,
        metavar="FOLDER",
        help=f"list the suites of a folder (default: {SHIPPED}) and end",
    )
    return parser


def _jobs(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"must be a whole number from 1, found {text!r}")
    return int(text)


def _list(folder: Path) -> None:
    paths = sorted(folder.glob("*.toml"))
    if not paths:
        raise SynthError(f"{folder}: holds no suite files")
    for path in paths:
        print(_line(path, read_suite(path)))


def _line(path: Path, suite: Suite) -> str:
    return f"{path}: {suite.scenes * len(suite.levels)} scenes. {suite.description}"


if __name__ == "__main__":
    sys.exit(main())
