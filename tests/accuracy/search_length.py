"""How many evaluations a search of bounds makes: few in every run, many on demand.

SEARCH_EVALUATIONS=10000 python -m pytest -n auto tests/accuracy -k search    the long search, an hour of processor time
"""

import os

EVALUATIONS = int(os.environ.get("SEARCH_EVALUATIONS", "100"))
# Tasks that integrate in 240 bits, a third of a second an evaluation: in every run they make fewer, on demand all.
COSTLY = {} if "SEARCH_EVALUATIONS" in os.environ else {"path relative": 4, "path curve": 4, "motion equations": 4}


def evaluations(task: str) -> int:
    """How many evaluations the search of a task makes."""
    return EVALUATIONS // COSTLY.get(task, 1)
