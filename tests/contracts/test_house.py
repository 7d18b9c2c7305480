"""How large files, folders and functions may be. What exceeds a budget is named here; the lists only get shorter."""

import ast
import re
from pathlib import Path

import dynamics_cli

PACKAGE = Path(dynamics_cli.__file__).parent
FILES = sorted(PACKAGE.rglob("*.py"))
MOST_LINES, MOST_IN_A_FOLDER, MOST_OF_A_FUNCTION = 350, 14, 50
LONG_FILES = {"quantities.py"}  # one table of kinds
LONG_FUNCTIONS = {
    "impact/planar/path.py:travel",
    "numerics/chebyshev/proxies.py:extremes",
}


def place(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix()


def test_exceptions_are_few() -> None:
    assert len(LONG_FILES) + len(LONG_FUNCTIONS) <= 10


def test_the_map_names_what_there_is() -> None:
    text = (PACKAGE.parent / "docs" / "developers" / "architecture.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`((?:core|skid)/[\w/]+(?:\.py|/))`", text))
    assert [name for name in sorted(named) if not (PACKAGE / name).exists()] == []
    listing = text.partition("```text")[2].partition("```")[0]
    modules = {path.name for path in PACKAGE.iterdir() if path.suffix == ".py" or (path / "__init__.py").exists()}
    modules -= {"__init__.py", "__main__.py", "version.py"}
    assert [name for name in sorted(modules) if not re.search(rf"\b{name}\b", listing)] == []


def test_files_are_short() -> None:
    long = {place(path) for path in FILES if path.read_text(encoding="utf-8").count("\n") > MOST_LINES}
    assert long <= LONG_FILES


def test_folders_are_small() -> None:
    counts = {place(folder): len(list(folder.glob("*.py"))) for folder in {path.parent for path in FILES}}
    assert {folder: count for folder, count in counts.items() if count > MOST_IN_A_FOLDER} == {}


def test_functions_are_short() -> None:
    long = set()
    for path in FILES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef):
                body = node.body[1:] if ast.get_docstring(node) else node.body
                if body and (body[-1].end_lineno or 0) - body[0].lineno + 1 > MOST_OF_A_FUNCTION:
                    long.add(f"{place(path)}:{node.name}")
    assert long <= LONG_FUNCTIONS
