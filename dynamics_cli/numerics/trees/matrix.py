"""The mass matrix of a tree, and the partial velocities that it is made of."""

from dynamics_cli.numerics.trees.blocks import block_of, joined, moved_block, symmetric
from dynamics_cli.numerics.trees.newton_euler import back
from dynamics_cli.numerics.trees.tree import PRISMATIC, ZERO
from dynamics_cli.numerics.vectors import add, cross, dot, subtract, times

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.numerics.trees.tree import Pose, Tree
    from dynamics_cli.numerics.vectors import Vector


def mass_matrix(tree: "Tree", frames: "Sequence[Pose]") -> "list[list[float]]":
    """The matrix a_lp of the kinetic energy ½·Σ a_lp·y_l·y_p, by composite bodies.

    References
    ----------
    Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, chapter 6;
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 18.17.
    """
    links = tree.links
    blocks = [block_of(link) for link in links]
    matrix = [[0.0] * tree.speeds for _ in range(tree.speeds)]
    for k in range(len(links) - 1, -1, -1):
        link = links[k]
        inertia, mixed, mass = blocks[k]
        for column, axis in enumerate(link.columns):
            if link.joint == PRISMATIC:
                moment, force = times(mixed, axis), symmetric(mass, axis)
            else:
                moment, force = symmetric(inertia, axis), back(mixed, axis)
            place = link.first + column
            _felt(tree, frames, matrix, k, place, moment, force)
            matrix[place][place] = matrix[place][place] + link.rotor
        if link.parent >= 0:
            blocks[link.parent] = joined(blocks[link.parent], moved_block(blocks[k], *frames[k]))
    return matrix


def _felt(
    tree: "Tree",
    frames: "Sequence[Pose]",
    matrix: "list[list[float]]",
    k: int,
    place: int,
    moment: "Vector",
    force: "Vector",
) -> None:
    """Write the row and the column of one speed: its momentum, seen from every joint below."""
    while True:
        link = tree.links[k]
        side = force if link.joint == PRISMATIC else moment
        for column, axis in enumerate(link.columns):
            other = link.first + column
            if other <= place:
                matrix[place][other] = matrix[other][place] = dot(axis, side)
        if link.parent < 0:
            return
        rotation, position = frames[k]
        force = times(rotation, force)
        moment = add(times(rotation, moment), cross(position, force))
        k = link.parent


def partial(tree: "Tree", ground_frames: "Sequence[Pose]", k: int, point: "Vector") -> "list[tuple[Vector, Vector]]":
    """Partial angular velocity of a link and partial velocity of a point of it, for every speed, in ground axes.

    `ground_frames` are those of `placed`; the point is given in the ground's frame.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.10 and 18.13.
    """
    out = [(ZERO, ZERO)] * tree.speeds
    for n in tree.path(k):
        link = tree.links[n]
        rotation, origin = ground_frames[n]
        for column, axis in enumerate(link.columns):
            direction = times(rotation, axis)
            if link.joint == PRISMATIC:
                out[link.first + column] = (ZERO, direction)
            else:
                out[link.first + column] = (direction, cross(direction, subtract(point, origin)))
    return out
