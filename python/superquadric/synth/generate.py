"""All scenes of a suite, in a folder that appears when it is complete."""

from __future__ import annotations

import multiprocessing
import shutil
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

from .._core import __version__
from .errors import SynthError
from .extras import require
from .scene import make_scene
from .suite import DepthMap, Level, Suite
from .writer import write_json, write_scene

SCHEMA = "superquadric.suite/1"

Task = tuple[Level, int]


def generate(
    suite: Suite,
    folder: Path,
    *,
    jobs: int = 1,
    on_scene: Callable[[int, int], None] = lambda done, total: None,
) -> None:
    """Writes a suite into a folder, which must be new or empty.

    The same suite gives the same bytes, whatever `jobs` is, on the same machine with the same
    versions of the packages.

    Args:
        suite: what to write.
        folder: gets `suite.json` and `scenes/<name>/`.
        jobs: number of processes.
        on_scene: is told how many scenes are written, of how many.

    Raises:
        SynthError: if the folder is not empty, a scene cannot be made, or open3d is missing.
        OSError: if a file cannot be written.
    """
    if any(isinstance(level.source, DepthMap) for level in suite.levels):
        require("open3d")
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise SynthError(f"{folder}: exists and is not an empty folder")
    tasks = [(level, index) for level in suite.levels for index in range(suite.scenes)]
    with _whole(folder) as unfinished:
        (unfinished / "scenes").mkdir()
        write = partial(_write, suite, unfinished / "scenes")
        entries = []
        for entry in _each(write, tasks, jobs):
            entries.append(entry)
            on_scene(len(entries), len(tasks))
        write_json(unfinished / "suite.json", _document(suite, entries))


def _write(suite: Suite, folder: Path, task: Task) -> dict[str, Any]:
    """Writes a scene; its entry in `suite.json`."""
    scene = make_scene(suite, *task)
    write_scene(suite, scene, folder / scene.name)
    return {
        "name": scene.name,
        "level": scene.level,
        "family": scene.family,
        "points": len(scene.cloud.points),
    }


def _each(
    write: Callable[[Task], dict[str, Any]], tasks: list[Task], jobs: int
) -> Iterator[dict[str, Any]]:
    """The entries in the order of the tasks."""
    if jobs == 1:
        yield from map(write, tasks)
        return
    # New processes: threads of open3d do not survive a fork.
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(jobs, mp_context=spawn) as pool:
        try:
            yield from pool.map(write, tasks)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def _document(suite: Suite, entries: list[dict[str, Any]]) -> dict[str, Any]:
    return {
        "schema": SCHEMA,
        "name": suite.name,
        "description": suite.description,
        "generator": f"superquadric.synth {__version__}",
        "unit": suite.unit,
        "frame": suite.frame,
        "seed": suite.seed,
        "levels": [level.name for level in suite.levels],
        "scenes": entries,
    }


@contextmanager
def _whole(folder: Path) -> Iterator[Path]:
    """A folder to write into, which takes the place of `folder` unless an error ends it."""
    folder.absolute().parent.mkdir(parents=True, exist_ok=True)
    place = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.absolute().parent))
    try:
        unfinished = place / "suite"
        unfinished.mkdir()
        yield unfinished
        if folder.exists():
            folder.rmdir()
        unfinished.replace(folder)
    finally:
        shutil.rmtree(place, ignore_errors=True)
