"""The worst inputs that the searches of tests/accuracy found, by the file of references that they belong to.

To ship what a search has found: add a line to found_cases.json with the file's name, the task, a name that no other
case of the task has, `why` ("found by search: …": which result, by how much, and what makes it hard there) and the
inputs with doubles as text; then run regenerate.py with the name of the file, which adds the results. Files whose
generators call `found` take cases so. Those of inertia and of impact stand in inertia_found.py, impact_found.py and
their like.
"""

import json
from collections import Counter
from pathlib import Path
from typing import Any

PLACE = Path(__file__).resolve().with_suffix(".json")


def found(file: str) -> list[dict[str, Any]]:
    """Task, name, why, inputs (doubles as text) and choices of each."""
    cases = json.loads(PLACE.read_text(encoding="utf-8"))["cases"]
    return [{key: value for key, value in case.items() if key != "file"} for case in cases if case["file"] == file]


def doubles(tree: Any) -> Any:
    """An input tree with its texts as doubles."""
    if isinstance(tree, dict):
        return {name: part if name == "record" else doubles(part) for name, part in tree.items()}
    if isinstance(tree, list):
        return [doubles(part) for part in tree]
    return float(tree) if isinstance(tree, str) else tree


def numbered(cases: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The same cases, each with a name of its own within its task: those that share one are counted."""
    often = Counter((case["task"], case["name"]) for case in cases)
    seen: Counter[tuple[str, str]] = Counter()
    made = []
    for case in cases:
        key = (case["task"], case["name"])
        seen[key] += 1
        made.append({**case, "name": f"{case['name']}, {seen[key]}"} if often[key] > 1 else case)
    return made
