"""Modules read straight from their compiled files: the same modules, and never stale ones."""

import importlib.util
import os
import py_compile
import subprocess
import sys
from pathlib import Path

import pytest

from dynamics_cli.core import quick_import

FINDER = quick_import._Finder


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(quick_import, "PACKAGE", "parcel")
    folder = tmp_path / "parcel"
    (folder / "inner").mkdir(parents=True)
    for name in ("leaf.py", "inner/__init__.py"):
        (folder / name).write_text("number = 1\n")
        py_compile.compile(str(folder / name))
    return folder


@pytest.mark.parametrize("name", ["leaf", "inner"])
def test_a_module_is_the_one_that_python_finds(package: Path, name: str) -> None:
    spec = FINDER.find_spec(f"parcel.{name}", [str(package)])
    source = package / f"{name}.py" if name == "leaf" else package / name / "__init__.py"
    places = [str(source.parent)] if name == "inner" else None
    usual = importlib.util.spec_from_file_location(f"parcel.{name}", source, submodule_search_locations=places)
    assert spec is not None
    assert usual is not None
    for what in ("name", "origin", "cached", "has_location", "parent", "submodule_search_locations"):
        assert getattr(spec, what) == getattr(usual, what)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert (module.number, module.__file__) == (1, str(source))
    assert spec.loader.get_source(spec.name) == "number = 1\n"


def test_what_is_stale_or_missing_is_left_to_python(package: Path) -> None:
    leaf = package / "leaf.py"
    times = leaf.stat()
    leaf.write_text("number = 22\n")
    os.utime(leaf, (times.st_atime, times.st_mtime))
    assert FINDER.find_spec("parcel.leaf", [str(package)]) is None
    leaf.write_text("number = 2\n")
    os.utime(leaf, (times.st_atime, times.st_mtime + 5))
    assert FINDER.find_spec("parcel.leaf", [str(package)]) is None
    os.utime(leaf, (times.st_atime, times.st_mtime))
    assert FINDER.find_spec("parcel.leaf", [str(package)]) is not None
    py_compile.compile(str(leaf), invalidation_mode=py_compile.PycInvalidationMode.CHECKED_HASH)
    assert FINDER.find_spec("parcel.leaf", [str(package)]) is None
    assert FINDER.find_spec("parcel.absent", [str(package)]) is None
    assert FINDER.find_spec("other.leaf", [str(package)]) is None


@pytest.mark.parametrize("words", [(), ("-O",), ("-OO",), ("-X", "pycache_prefix=nowhere")], ids=" ".join)
def test_every_way_of_starting_python_works(words: tuple[str, ...]) -> None:
    call = [sys.executable, *words, "-m", "dynamics_cli", "convert", "60", "mph", "ft/s"]
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(call, capture_output=True, text=True, check=True, env=environment)
    assert done.stdout.startswith("88")
