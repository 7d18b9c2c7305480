"""The examples in docstrings are what the functions give."""

import doctest
import importlib
import pkgutil

import pytest

import dynamics_cli

MODULES = sorted(
    name
    for _, name, package in pkgutil.walk_packages(dynamics_cli.__path__, "dynamics_cli.")
    if not package and not name.endswith("__main__")
)


@pytest.mark.parametrize("name", MODULES)
def test_examples_hold(name: str) -> None:
    found = doctest.testmod(importlib.import_module(name))
    assert found.failed == 0
