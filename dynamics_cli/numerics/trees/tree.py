"""A tree of links, and its local and ground frames in a state."""

from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.orientation.rotations import IDENTITY, axis_angle, from_quaternion, product
from dynamics_cli.numerics.vectors import add, times

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.numerics.vectors import Tensor, Vector

    Pose = tuple[Tensor, Vector]

REVOLUTE, PRISMATIC, BALL, FIXED = "revolute", "prismatic", "ball", "fixed"
COORDINATES = {REVOLUTE: 1, PRISMATIC: 1, BALL: 4, FIXED: 0}
SPEEDS = {REVOLUTE: 1, PRISMATIC: 1, BALL: 3, FIXED: 0}
ZERO: "Vector" = (0.0, 0.0, 0.0)
UNITS: "tuple[Vector, ...]" = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Link:
    """A rigid body with the joint that carries it (see the package)."""

    __slots__ = ("axis", "centroid", "columns", "first", "joint", "mass", "name", "parent", "place", "position",
                 "rotation", "rotor", "tensor")  # fmt: skip

    def __init__(
        self,
        name: str,
        parent: int,
        joint: str,
        *,
        axis: "Vector" = (0.0, 0.0, 1.0),
        position: "Vector" = ZERO,
        rotation: "Tensor" = IDENTITY,
        mass: float = 0.0,
        centroid: "Vector" = ZERO,
        tensor: "Tensor" = (ZERO, ZERO, ZERO),
        rotor: float = 0.0,
    ) -> None:
        size = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])
        self.name, self.parent, self.joint, self.rotor = name, parent, joint, rotor
        self.axis = (axis[0] / size, axis[1] / size, axis[2] / size)
        self.position, self.rotation = position, rotation
        self.mass, self.centroid, self.tensor = mass, centroid, tensor
        # the axes of its speeds, and where its coordinates and speeds begin
        self.columns = UNITS if joint == BALL else (self.axis,) if joint != FIXED else ()
        self.place = self.first = 0


class Tree:
    """Links in an order in which each stands after its parent."""

    def __init__(self, links: "Sequence[Link]") -> None:
        self.links = tuple(links)
        self.coordinates = self.speeds = 0
        for k, link in enumerate(self.links):
            assert link.parent < k, "a link must stand after its parent"
            link.place, link.first = self.coordinates, self.speeds
            self.coordinates += COORDINATES[link.joint]
            self.speeds += SPEEDS[link.joint]

    def path(self, k: int) -> "list[int]":
        """The link and all that carry it, down to the ground."""
        links = []
        while k >= 0:
            links.append(k)
            k = self.links[k].parent
        return links


def poses(tree: Tree, coordinates: "Sequence[float]") -> "list[Pose]":
    """Of every link the rotation that takes its axes to the parent's, and its origin in the parent's frame.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.3 to 18.6.
    """
    frames = []
    for link in tree.links:
        rotation, position, place = link.rotation, link.position, link.place
        if link.joint == PRISMATIC:
            x, y, z = link.axis
            way = coordinates[place]
            position = add(position, times(rotation, (x * way, y * way, z * way)))
        elif link.joint != FIXED:
            if link.joint == REVOLUTE:
                turn = axis_angle(link.axis, coordinates[place])
            else:
                w, x, y, z = coordinates[place : place + 4]
                turn = from_quaternion((w, x, y, z))
            rotation = turn if rotation is IDENTITY else product(rotation, turn)
        frames.append((rotation, position))
    return frames


def placed(tree: Tree, frames: "Sequence[Pose]") -> "list[Pose]":
    """Of every link the rotation that takes its axes to those of the ground, and its origin in the ground's frame."""
    out: list[Pose] = []
    for link, (rotation, position) in zip(tree.links, frames, strict=True):
        if link.parent >= 0:
            carrier, origin = out[link.parent]
            position = add(origin, times(carrier, position))
            rotation = product(carrier, rotation)
        out.append((rotation, position))
    return out


def rates(tree: Tree, coordinates: "Sequence[float]", speeds: "Sequence[float]") -> "list[float]":
    """Rates of the coordinates: the speeds, of a ball joint those of its Euler parameters.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 18.7 and 18.8.
    """
    out = []
    for link in tree.links:
        if link.joint == BALL:
            w, x, y, z = coordinates[link.place : link.place + 4]
            a, b, c = speeds[link.first : link.first + 3]
            out += [-0.5 * (x * a + y * b + z * c), 0.5 * (w * a + y * c - z * b), 0.5 * (w * b + z * a - x * c),
                    0.5 * (w * c + x * b - y * a)]  # fmt: skip
        elif link.joint != FIXED:
            out.append(speeds[link.first])
    return out
