"""Files of triangles by the form they are in: STL read here, others by trimesh where it is installed."""

import os

from dynamics_cli.errors import InadmissibleError, UsageError, require
from dynamics_cli.inertia.mesh.stl import Corners, open_stl

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.mesh.stl import Source

OTHERS = ("obj", "ply", "3mf", "glb", "gltf", "off", "dae", "amf")


def open_mesh(name: str) -> "Source":
    """A file of triangles, ready to be read as often as wanted.

    Raises
    ------
    InadmissibleError
        When the form is unknown or the file is damaged.
    UsageError
        When trimesh is needed and not installed.
    """
    ending = os.path.splitext(name)[1].lower().lstrip(".")
    if ending in OTHERS:
        return _by_trimesh(name, ending)
    require(
        ending in ("stl", "stla", "stlb", ""),
        "{0!r} is none of the endings of meshes: stl, {1}",
        "." + ending,
        ", ".join(OTHERS),
        code="form",
        hint="give the file the ending of its form",
    )
    return open_stl(name)


def _by_trimesh(name: str, ending: str) -> "Source":
    require(os.path.getsize(name) > 0, "the file is empty", code="empty")
    try:
        import trimesh
    except ImportError:
        raise UsageError(
            f"files of the form {ending} are read by trimesh, which is not installed",
            code="not-installed",
            hint="pip install 'dynamics-cli[mesh]', or export the part as STL",
        ) from None
    try:
        mesh = trimesh.load(name, force="mesh", process=False)
        vertices, faces = mesh.vertices, mesh.faces
    except Exception as error:  # its readers raise whatever their parsers do
        raise InadmissibleError(
            f"trimesh cannot read it as {ending}: {str(error) or type(error).__name__}", code="form"
        ) from None
    require(len(faces) > 0, "there are no triangles", code="empty")
    require(
        int(faces.min()) >= 0 and int(faces.max()) < len(vertices),
        "a triangle refers to corner {0} of {1}",
        int(faces.max()) + 1,
        len(vertices),
        code="form",
    )
    return Corners(name, ending.upper(), vertices, faces)
