"""A closed mesh as a part of an assembly."""

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix, Vector


def mesh_lump(file: str, metres: float) -> "tuple[float, Vector, Matrix]":
    """Volume, centroid and second moments of unit density of a closed mesh, `metres` being its unit of length.

    Raises
    ------
    InadmissibleError
        When the file is damaged or the surface open, inside out or without volume.
    """
    from dynamics_cli.inertia.mesh.measured import measured, require_closed

    found = measured(file, shell=False)
    require_closed(found, allowed=False)
    own = found.moments
    require(own.measure > 0.0, "the triangles of {0} enclose nothing", file, code="no-volume")
    second = own.second if own.frame is None else own.frame.T @ own.second @ own.frame
    area = metres * metres
    x, y, z = (metres * float(part) for part in own.centroid)
    scaled = tuple(
        tuple(area * (area * (metres * float(0.5 * (second[i][j] + second[j][i])))) for j in range(3)) for i in range(3)
    )
    return area * (metres * own.measure), (x, y, z), scaled  # type: ignore[return-value]
