"""The worst inputs that the searches of tests/accuracy found, by the file of references that they belong to."""

import json
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
