"""The examples in the docstrings of impact run, and give what they say."""

import doctest
import importlib
import pkgutil

import pytest

from dynamics_cli import impact

MODULES = [name for _, name, _ in pkgutil.iter_modules(impact.__path__)]


@pytest.mark.parametrize("name", MODULES)
def test_examples_give_what_they_say(name: str) -> None:
    module = importlib.import_module(f"{impact.__name__}.{name}")
    assert doctest.testmod(module).failed == 0


def test_there_are_examples() -> None:
    finder = doctest.DocTestFinder(exclude_empty=True)
    modules = (importlib.import_module(f"{impact.__name__}.{name}") for name in MODULES)
    assert sum(bool(found.examples) for module in modules for found in finder.find(module)) >= 10
