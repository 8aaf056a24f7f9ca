"""Evaluation over a suite of scenes with known truth: fit each, score it, show what came of it.

`python -m superquadric.batch SUITE_DIR -o RESULTS_DIR` evaluates a suite, as `superquadric batch`
does. Tables need pandas and pictures need matplotlib, which are imported only then:
`pip install 'superquadric[batch]'`.
"""

from .evaluation import Evaluation, evaluate
from .extras import MissingExtraError

__all__ = ["Evaluation", "MissingExtraError", "evaluate"]
