"""Files of triangles by format: STL is read here, others by trimesh if it is installed."""

import os

from dynamics_cli.errors import InadmissibleError, UsageError, require
from dynamics_cli.inertia.mesh.stl import Corners, open_stl

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.inertia.mesh.stl import Source

OTHERS = ("obj", "ply", "3mf", "glb", "gltf", "off")
# Bytes of a file that trimesh reads, unpacked where it is a 3MF file: a text takes about ten times as much memory.
MOST_UNPACKED = 256 << 20
# Units that 3MF files say, by our names for them.
UNITS = {"micron": "um", "millimeter": "mm", "centimeter": "cm", "inch": "in", "foot": "ft", "meter": "m"}


def open_mesh(name: str) -> "Source":
    """A file of triangles that can be read repeatedly.

    Raises InadmissibleError when the form is unknown or the file is damaged. Raises UsageError when trimesh is needed
    and not installed.
    """
    ending = os.path.splitext(name)[1].lower().lstrip(".")
    if ending in OTHERS:
        return _by_trimesh(name, ending)
    require(
        ending in ("stl", "stla", "stlb", ""),
        "cannot read a file that ends in {ending}; meshes end in .stl, .{known}",
        code="form",
        hint="export the part as STL, or rename the file to the ending of its format",
        ending=repr("." + ending),
        known=", .".join(OTHERS),
    )
    return open_stl(name)


def _require_small(size: int) -> None:
    require(
        size <= MOST_UNPACKED,
        "the file holds {size} bytes, more than the limit of {limit}",
        code="too-large",
        hint="export the part as binary STL, which is read in blocks",
        size=size,
        limit=MOST_UNPACKED,
    )


def _by_trimesh(name: str, ending: str) -> "Source":
    size = os.path.getsize(name)
    require(size > 0, "the file is empty", code="empty")
    _require_small(size)
    unit = _packed_unit(name) if ending == "3mf" else ""
    if ending == "obj":
        _require_sound_obj(name)
    try:
        import trimesh
    except ImportError:
        raise UsageError(
            f".{ending} files need the package trimesh, which is not installed",
            code="not-installed",
            hint="pip install 'dynamics-cli[mesh]', or export the part as STL",
        ) from None
    try:
        mesh: Any = trimesh.load(name, force="mesh", process=False)
        vertices, faces = mesh.vertices, mesh.faces
    except Exception as error:  # its readers raise the exceptions of their parsers
        raise InadmissibleError(
            f"the file is not a readable .{ending} file (trimesh: {str(error) or type(error).__name__})",
            code="form",
            hint="export the part again, or as STL",
        ) from None
    require(len(faces) > 0, "there are no triangles", code="empty")
    require(
        int(faces.min()) >= 0 and int(faces.max()) < len(vertices),
        "a triangle refers to vertex {vertex}, and the file has {count} vertices",
        code="form",
        vertex=int(faces.max()) + 1,
        count=len(vertices),
    )
    corners = Corners(name, ending.upper(), vertices, faces)
    corners.unit = unit
    return corners


def _packed_unit(name: str) -> str:
    """The unit of length that a 3MF file says; refuses one that unpacks to more than can be held.

    An entry is unpacked to the size that the archive's directory declares and no further.
    """
    import zipfile
    from xml.etree import ElementTree

    try:
        with zipfile.ZipFile(name) as archive:
            entries = archive.infolist()
            unpacked = sum(entry.file_size for entry in entries)
            _require_small(unpacked)
            units = set()
            for entry in entries:
                if entry.filename.lower().endswith(".model"):
                    with archive.open(entry) as file:
                        _, root = next(ElementTree.iterparse(file, events=("start",)))
                    units.add(root.get("unit", "millimeter"))
    except (zipfile.BadZipFile, ElementTree.ParseError, StopIteration, NotImplementedError, RuntimeError) as error:
        raise InadmissibleError(
            f"the file is not a readable .3mf file ({str(error) or 'it is empty'})", code="form"
        ) from None
    require(
        len(units) == 1 and units <= UNITS.keys(),
        "the models of the file are in {read}, wanted one of {known}",
        code="unit",
        read=" and ".join(sorted(units)) or "no unit",
        known=", ".join(UNITS),
    )
    return UNITS[units.pop()]


def _require_sound_obj(name: str) -> None:
    """Refuse vertices and triangles that trimesh would misread."""
    with open(name, "rb") as file:
        for number, line in enumerate(file, 1):
            words = line.split()
            if line[:2] == b"v " and len(words) not in (4, 5, 7, 8):
                require(
                    False,
                    "line {number}: a vertex has {count} numbers, wanted 3",
                    code="form",
                    number=number,
                    count=len(words) - 1,
                )
            if line[:2] == b"f " and any(word.partition(b"/")[0] == b"0" for word in words[1:]):
                require(
                    False,
                    "line {number}: a face refers to vertex 0; vertices are counted from 1",
                    code="form",
                    hint="export the file again",
                    number=number,
                )
