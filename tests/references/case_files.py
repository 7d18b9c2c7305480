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
        lines.append({"task": task, **reason, "inputs": inputs, "results": texts})
    put(name, about, lines)


def write_given(name: str, about: str, cases: Iterable[Given]) -> None:
    """The same of cases that say themselves whether they are hard, and have no zeros that are left of 90 digits."""
    lines = []
    for task, kind, title, why, inputs, results in cases:
        texts = {key: nstr(value, 40, min_fixed=-8, max_fixed=18) for key, value in results.items()}
        said = {"why": why} if why else {}
        lines.append({"task": task, "kind": kind, "name": title, **said, "inputs": inputs, "results": texts})
    put(name, about, lines)


def put(name: str, about: str, cases: "Iterable[dict[str, Any]]", margin: str = "") -> None:
    """Write whole cases, one a line after `margin`, to the file of this name, or to the one on the command line."""
    lines = ",\n".join(margin + json.dumps(case, ensure_ascii=False) for case in cases)
    target(DATA / f"{name}.json").write_text(
        f'{{"about": {json.dumps(about, ensure_ascii=False)},\n"cases": [\n{lines}\n]}}\n', "utf-8"
    )


def put_tree(file: Path, tree: Any) -> None:
    """Write anything else, indented, to a file, or to the one named on the command line."""
    target(file).write_text(json.dumps(tree, indent=1, ensure_ascii=False) + "\n", "utf-8")


def target(file: Path) -> Path:
    """The file to be written: this one, or the one named on the command line."""
    return Path(sys.argv[1]) if len(sys.argv) > 1 else file
