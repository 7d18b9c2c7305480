"""What each file of references was made from: a digest of its generator and of every module and list that it reads.

As long as the sources are the same, so is the file; `regenerate.py` makes files again and renews their digests here.
"""

import ast
import hashlib
import json
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PLACES = (HERE, HERE.parent, HERE.parent / "accuracy", ROOT)
# Of the program itself only this counts: its shapes are what some references are of.
SHAPES = ROOT / "dynamics_cli" / "accuracy"
DIGESTS = HERE / "made_from.json"


def sources(generator: Path) -> set[Path]:
    """The generator and what it imports of the tests, with what that imports."""
    found, open_files = set[Path](), [generator]
    while open_files:
        file = open_files.pop()
        if file in found:
            continue
        found.add(file)
        if file.with_suffix(".json").exists():
            found.add(file.with_suffix(".json"))
        if not file.is_relative_to(HERE.parent):
            continue
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            names = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            names += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            paths = [place / f"{name.replace('.', '/')}.py" for name in names for place in PLACES]
            own = [path for path in paths if path.is_relative_to(HERE.parent) or path.is_relative_to(SHAPES)]
            open_files += [path for path in own if path.exists()]
    return found


def digest(name: str) -> str:
    """A digest of what a file of references is made from."""
    made = hashlib.sha256()
    for file in sorted(sources(HERE / f"generate_{name}_references.py")):
        made.update(file.read_bytes())
    return made.hexdigest()


def known() -> dict[str, str]:
    """The digests at the last making."""
    return json.loads(DIGESTS.read_text(encoding="utf-8")) if DIGESTS.exists() else {}


def renew(names: list[str]) -> None:
    """Note what these files are made from."""
    digests = known() | {name: digest(name) for name in names}
    DIGESTS.write_text(json.dumps(digests, indent=0, sort_keys=True) + "\n", encoding="utf-8")
