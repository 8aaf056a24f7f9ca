"""One HTML file that needs nothing else: tables, and pictures as data in it."""

from __future__ import annotations

import base64
from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING, Any

from .. import __version__
from . import plots
from .case import case
from .table import HEADER, cells

if TYPE_CHECKING:
    from .evaluation import Evaluation

WORST = 6

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>{title}</title>
<style>
body {{ font: 15px/1.45 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; }}
table {{ border-collapse: collapse; }}
th, td {{ padding: 0.2em 0.7em; border-bottom: 1px solid #ccc; text-align: right; }}
th:first-child, td:first-child {{ text-align: left; }}
td.text {{ text-align: left; }}
img {{ max-width: 100%; }}
figure {{ margin: 1em 0; }}
</style>
</head>
<body>
{body}</body>
</html>
"""


def html(evaluation: Evaluation) -> str:
    """The text of the file.

    Raises:
        MissingExtraError: without matplotlib.
        OSError: if a scene cannot be read.
    """
    suite = evaluation.summary["suite"]
    body = (
        f"<h1>Suite {escape(suite)}</h1>\n"
        f"<p>{len(evaluation.rows)} scenes, superquadric {escape(__version__)}. A scene is "
        f"recovered if the volume overlap (IoU) with the truth is at least {plots.SUCCESS_IOU}. "
        "Surface distance is relative to the mean semi-axis; it and the time are medians.</p>\n"
        + _table(HEADER, cells(evaluation.summary))
        + _picture(plots.success(evaluation), "Success against level")
        + "<h2>Errors</h2>\n"
        + _picture(plots.histograms(evaluation), "Scenes that were fitted, by level")
        + _worst(evaluation)
        + _failures(evaluation)
    )
    return PAGE.format(title=escape(f"{suite}: superquadric"), body=body)


def _worst(evaluation: Evaluation) -> str:
    rows = evaluation.worst(WORST)
    pictures = [_picture(case(evaluation, row["scene"]), _caption(row)) for row in rows]
    return f"<h2>The {len(rows)} worst fits</h2>\n{''.join(pictures)}" if rows else ""


def _caption(row: dict[str, Any]) -> str:
    trusted = "trusted" if row["trusted"] else "not trusted"
    return (
        f"{row['scene']}: family {row['family']}, level {row['level']}, IoU {row['iou']:.3f}, "
        f"{trusted}"
    )


def _failures(evaluation: Evaluation) -> str:
    failures = [row for row in evaluation.rows if row["status"] == "failed"]
    if not failures:
        return ""
    cells = [[row["scene"], row["level"], row["error"]] for row in failures]
    return f"<h2>Without a model</h2>\n{_table(['scene', 'level', 'why'], cells, 'text')}"


def _table(header: list[str], rows: Iterable[list[str]], kind: str = "number") -> str:
    heads = "".join(f"<th>{escape(cell)}</th>" for cell in header)
    lines = ["".join(f'<td class="{kind}">{escape(cell)}</td>' for cell in row) for row in rows]
    body = "".join(f"<tr>{line}</tr>\n" for line in lines)
    return f"<table>\n<tr>{heads}</tr>\n{body}</table>\n"


def _picture(figure: Any, caption: str) -> str:
    data = base64.b64encode(plots.png(figure)).decode("ascii")
    text = escape(caption)
    source = f"data:image/png;base64,{data}"
    return f'<figure><img alt="{text}" src="{source}">\n<figcaption>{text}</figcaption></figure>\n'
