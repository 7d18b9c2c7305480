"""How many evaluations a search of bounds makes: few in every run, many on demand; and the searches as commands.

SEARCH_EVALUATIONS=10000 python -m pytest -n auto tests/accuracy -k search    the long search, an hour of processor time
"""

import os
import sys
from collections.abc import Callable, Iterable, Iterator
from time import process_time
from typing import Any

EVALUATIONS = int(os.environ.get("SEARCH_EVALUATIONS", "100"))
# Tasks that integrate in 240 bits, a third of a second an evaluation: in every run they make fewer, on demand all.
COSTLY = {} if "SEARCH_EVALUATIONS" in os.environ else {"path relative": 4, "path curve": 4, "motion equations": 4}


def evaluations(task: str) -> int:
    """How many evaluations the search of a task makes."""
    return EVALUATIONS // COSTLY.get(task, 1)


def told(tasks: Iterable[str], search: Callable[[str, int, int], Any]) -> Iterator[Any]:
    """Search [COUNT [TASK [SEED]]] as the command line asks, tell what was found and what broke, and give it."""
    count, only, seed = [*sys.argv[1:4], *("10000", "", "1")[len(sys.argv) - 1 :]]
    for task in tasks:
        if only and task != only:
            continue
        before = process_time()
        found = search(task, int(count), int(seed))
        print(
            f"{task:16} {found.evaluations:7} answered, {found.refused} refused, {found.compared} results compared, "
            f"{len(found.broken)} broken, looseness {found.median:.1f} in the median, {process_time() - before:.1f} s",
            flush=True,
        )
        for line in found.broken[:5]:
            print("    ! " + line[:600])
        yield found
