"""The examples in docstrings are what the functions give, and equations have their sources."""

import ast
import doctest
import importlib

import pytest
from shell import ROOT

# Modules without an example have nothing to try.
MODULES = sorted(
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
    for path in (ROOT / "dynamics_cli").rglob("*.py")
    if ">>> " in path.read_text(encoding="utf-8")
)


@pytest.mark.parametrize("name", MODULES)
def test_examples_hold(name: str) -> None:
    found = doctest.testmod(importlib.import_module(name))
    assert found.failed == 0


def test_every_equation_has_a_source() -> None:
    unsourced = [
        f"{path.name}:{node.name}"
        for path in (ROOT / "dynamics_cli").rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")
        if "\nEquation\n--" in (text := ast.get_docstring(node) or "")
        if "\nReferences\n--" not in text
    ]
    assert unsourced == []
