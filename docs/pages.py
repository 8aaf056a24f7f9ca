"""What the pages made here have in common: how they say by what and where they were made."""

import datetime
import os
import platform
import re
from pathlib import Path

import superquadric

DOCS = Path(__file__).parent
SUCCESS_IOU = 0.9
SAMPLES = 5000

MADE = """Made on {date} by

    {command}

with superquadric {version} on {cpu} ({cores} cores)"""


def made_by(command):
    """The beginning of a page's first sentences: date, command, version and machine."""
    return MADE.format(
        date=datetime.date.today().isoformat(),
        command=command,
        version=superquadric.__version__,
        cpu=_cpu(),
        cores=os.cpu_count(),
    )


def _cpu():
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return platform.processor()
    found = re.search(r"model name\s*:\s*(.+)", text)
    return found[1] if found else platform.machine()
