"""Three views of a mesh with its principal axes and the ellipsoid of the same mass and inertia."""

import os

from dynamics_cli.inertia.mesh.measurement import unit_of
from dynamics_cli.inertia.mesh.opening import open_mesh
from dynamics_cli.inertia.pictures import drawn_picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.properties import MassProperties
    from dynamics_cli.inertia.mesh.surface import LengthUnit
    from dynamics_cli.inertia.shapes.wires import Wire
    from dynamics_cli.pictures import Picture

# Triangles drawn at most: enough to recognise a part, few enough for a file that opens.
DRAWN = 1500
NAN = float("nan")


def mesh_picture(
    answer: "MassProperties", file: str, *, length_unit: "LengthUnit | None" = None, **_: object
) -> "Picture":
    """A mesh by triangles spread evenly over its file, with its axes and ellipsoid."""
    up, down = unit_of(open_mesh(file), length_unit).ratio
    return drawn_picture(answer, [([outlines(file, up / down)], False)], os.path.basename(file))


def outlines(file: str, metres: float) -> "Wire":
    """Triangles as one line, broken between them."""
    source = open_mesh(file)
    count = source.count or sum(block.shape[1] for block in source.blocks())
    step = -(-count // DRAWN)
    wire, position = [], 0
    for block in source.blocks():
        chosen = block[:, -position % step :: step]
        for numbers in (metres * chosen.T.astype(float)).tolist():
            a, b, c = (tuple(numbers[k : k + 3]) for k in (0, 3, 6))
            wire += [a, b, c, a, (NAN, NAN, NAN)]
        position += block.shape[1]
    return wire
