"""Modules of this package read straight from their compiled files: a call imports some sixty, and looks for none.

Python's own way lists folders, tries endings and asks for the time of each file in Python code: a quarter of a start.
Where a compiled file is missing, stale or of another sort, Python's own way is taken, which writes it anew.
"""

import sys
from _frozen_importlib_external import MAGIC_NUMBER
from marshal import loads
from os import stat

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.machinery import ModuleSpec
    from types import CodeType, ModuleType

PACKAGE = __name__.partition(".")[0]
_Spec = type(__spec__)
_Loader = type(__spec__.loader)


def install() -> None:
    """Let the modules of this package be found so for the rest of the process, where they are plain files."""
    if _Loader.__name__ == "SourceFileLoader" and not sys.flags.optimize and sys.pycache_prefix is None:
        sys.meta_path.insert(0, _Finder)


class _Compiled(_Loader):  # type: ignore[misc, valid-type]
    """Python's loader of source files, given the code."""

    code: "CodeType"

    def get_code(self, fullname: str) -> "CodeType":
        return self.code


class _Finder:
    @staticmethod
    def find_spec(name: str, path: "Sequence[str] | None", target: "ModuleType | None" = None) -> "ModuleSpec | None":
        if path is None or not name.startswith(PACKAGE):
            return None
        folder, last = path[0], name.rpartition(".")[2]
        inside = None
        try:
            times = stat(source := f"{folder}/{last}.py")
        except OSError:
            inside, last = [folder := f"{folder}/{last}"], "__init__"
        try:
            if inside:
                times = stat(source := f"{folder}/__init__.py")
            with open(cached := f"{folder}/__pycache__/{last}.{sys.implementation.cache_tag}.pyc", "rb", 0) as file:
                data = file.read()
        except OSError:
            return None
        # magic number, no flags, time and size of the source
        made = MAGIC_NUMBER + bytes(4) + (int(times.st_mtime) & 0xFFFFFFFF).to_bytes(4, "little")
        if data[:16] != made + (times.st_size & 0xFFFFFFFF).to_bytes(4, "little"):
            return None
        loader = _Compiled(name, source)
        loader.code = loads(memoryview(data)[16:])
        spec = _Spec(name, loader, origin=source)
        spec.submodule_search_locations = inside
        spec.cached = cached
        spec.has_location = True
        return spec
