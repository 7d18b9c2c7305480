"""Writes a file of reference cases, as the generators of closed forms do: results to 40 digits."""

import json
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from mpmath import nstr

DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"
# Task, name, why it is hard (nothing: it is not), inputs, results.
Case = tuple[str, str, str, dict[str, Any], dict[str, Any]]
# The same with the kind, hard or ordinary, after the task.
Given = tuple[str, str, str, str, dict[str, Any], dict[str, Any]]


# What 90 digits leave of a zero.
NOTHING = 1e-70


def _text(value: Any) -> str:
    return nstr(value, 40, min_fixed=-8, max_fixed=18) if abs(value) > NOTHING else "0.0"


def write(name: str, about: str, cases: Iterable[Case]) -> None:
    """Write the cases to the file of this name, or to the one named on the command line."""
    lines = []
    for task, title, why, inputs, results in cases:
        reason = {"kind": "hard", "name": title, "why": why} if why else {"kind": "ordinary", "name": title}
        texts = {key: _text(value) for key, value in results.items()}
        lines.append(json.dumps({"task": task, **reason, "inputs": inputs, "results": texts}, ensure_ascii=False))
    put(name, about, lines)


def write_given(name: str, about: str, cases: Iterable[Given]) -> None:
    """The same of cases that say themselves whether they are hard, and have no zeros that are left of 90 digits."""
    lines = []
    for task, kind, title, why, inputs, results in cases:
        texts = {key: nstr(value, 40, min_fixed=-8, max_fixed=18) for key, value in results.items()}
        said = {"why": why} if why else {}
        case = {"task": task, "kind": kind, "name": title, **said, "inputs": inputs, "results": texts}
        lines.append(json.dumps(case, ensure_ascii=False))
    put(name, about, lines)


def put(name: str, about: str, lines: "Iterable[str]") -> None:
    """Write cases that are JSON already."""
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / f"{name}.json"
    text = ",\n".join(lines)
    target.write_text(f'{{"about": {json.dumps(about, ensure_ascii=False)},\n"cases": [\n{text}\n]}}\n', "utf-8")
