"""Writes manifest.json: every file of references, what made it, and each case with its difficulty and its source.

Run: python tests/references/generate_manifest.py [FILE], after any generator. The same bytes every time.
"""

import hashlib
import json
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from manifest_sources import FILES, SOURCES

ACCURACY = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy"
DATA = ACCURACY / "data"
ABOUT = (
    "Written by generate_manifest.py. Results have 40 digits, or fewer where they are exact in fewer. Cases are added "
    "by the generator named, or to tests/references/found_cases.json (see found_cases.py) where a search finds them."
)


def entry(name: str) -> dict[str, Any]:
    """A file's entry."""
    origin, path = FILES[name], DATA / f"{name}.json"
    content = path.read_bytes()
    cases = json.loads(content)["cases"]
    made = {
        "file": path.name, "family": origin.family, "generator": f"tests/references/generate_{name}_references.py",
        "method": origin.method, "digits": 40, "working": origin.working,
        **({"search": origin.search} if any(origin.source(case).startswith("search") for case in cases) else {}),
        "sha256": hashlib.sha256(content).hexdigest(), "count": len(cases),
        "hard": sum(case["kind"] == "hard" for case in cases),
    }  # fmt: skip
    return {**made, "cases": [listed(name, case) for case in cases]}


def listed(name: str, case: dict[str, Any]) -> dict[str, str]:
    """A case: its task, the command that it asks, name, difficulty, why it is hard, and where it comes from."""
    origin = FILES[name]
    why = {"why": case["why"]} if case.get("why") else {}
    return {
        "task": case["task"], "command": origin.command(case["task"]), "name": case["name"],
        "kind": case["kind"], **why, "source": origin.source(case),
    }  # fmt: skip


def text() -> str:
    """The manifest: a line for each case."""
    files = []
    for name in FILES:
        made = entry(name)
        cases = ",\n".join("  " + json.dumps(case, ensure_ascii=False) for case in made.pop("cases"))
        head = json.dumps(made, ensure_ascii=False)[:-1]
        files.append(f'{head}, "cases": [\n{cases}\n]}}')
    head = f'{{"about": {json.dumps(ABOUT)},\n"sources": {json.dumps(SOURCES, ensure_ascii=False)},\n"files": [\n'
    return head + ",\n".join(files) + "\n]}\n"


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else ACCURACY / "manifest.json"
    target.write_text(text(), encoding="utf-8")
