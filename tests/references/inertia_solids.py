"""Writes surfaces made by recipes as STL files."""

import struct
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from dynamics_cli.accuracy.alternatives.inertia.solids import SOLIDS, ball, prism, triangles

__all__ = ["SOLIDS", "ball", "prism", "triangles", "write_stl"]


def write_stl(path: Path, made: list[Any], *, binary: bool) -> None:
    """Write an STL file; a text keeps every bit of a double."""
    if binary:
        parts = [b"made by a recipe".ljust(80), struct.pack("<I", len(made))]
        parts += [struct.pack("<12fH", 0, 0, 0, *(x for p in t for x in p), 0) for t in made]
        path.write_bytes(b"".join(parts))
        return
    lines = ["solid recipe"]
    for t in made:
        lines += ["facet normal 0 0 0", "outer loop", *(f"vertex {x!r} {y!r} {z!r}" for x, y, z in t)]
        lines += ["endloop", "endfacet"]
    path.write_text("\n".join([*lines, "endsolid recipe", ""]), encoding="ascii")
