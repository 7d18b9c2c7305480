"""What closed form an arm's inverse has, seen from its axes where all joints are at zero."""

from math import atan2, hypot, sqrt

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.numerics.orientation.rotations import Matrix, product, transposed
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, scale, subtract, times
from dynamics_cli.records import record
from dynamics_cli.robot.arms.chain import Chain, Frame
from dynamics_cli.robot.inverse.subproblems import Plane

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# Axes this near to parallel, or to one point as a share of the arm's size, are meant to be so.
SAME = 1e-9

PLANAR = "all axes parallel"
POSITION = "three joints, axes 2 and 3 parallel"
SPHERICAL = "spherical wrist, axes 2 and 3 parallel"
PARALLEL = "axes 2, 3 and 4 parallel, 5 and 6 meet"
CLOSED = (
    "arms of two or three turning joints with all axes parallel; of three joints with axes 2 and 3 parallel; of six "
    "joints with axes 2 and 3 parallel and a spherical wrist, or with axes 2, 3 and 4 parallel and 5 and 6 that meet"
)


@record
class Structure:
    """The axes of an arm at zero, and what they have in common."""

    kind: str
    axes: "tuple[Vector, ...]"
    points: "tuple[Vector, ...]"
    turning: "tuple[bool, ...]"
    hand: Vector
    rotation: Matrix
    centre: Vector
    """The point whose place the first joints alone decide: the wrist centre, or the hand."""
    size: float

    @property
    def turns(self) -> "tuple[int, ...]":
        """The joints that turn."""
        return tuple(index for index, turning in enumerate(self.turning) if turning)

    @property
    def level(self) -> Plane:
        """The plane in which the two links move."""
        return Plane(self.axes[self.turns[0 if self.kind == PLANAR else 1]])

    def sense(self, joint: int, reference: Vector) -> float:
        """Whether a joint turns as another axis does, or against it."""
        return 1.0 if dot(self.axes[joint], reference) > 0.0 else -1.0


def structure_of(chain: Chain) -> Structure:
    """The structure of an arm; one without a closed form is refused."""
    structure = structure_or_none(chain)
    if structure is None:
        frames = _frames(chain)
        axes, points = tuple(frame.z for frame in frames), tuple(frame.position for frame in frames)
        require(
            False,
            "the inverse of this arm has no closed form here: {why}",
            why=_why(axes, points, chain.turning, chain.reach),
            code="no-closed-form",
            hint=f"closed forms: {CLOSED}",
        )
    assert structure is not None
    return structure


def structure_or_none(chain: Chain) -> Structure | None:
    """The structure of an arm, if it has one with a closed form."""
    chain = over_plain(chain)
    links = chain.links([0.0] * len(chain.joints))
    frames = chain.axes(links)
    axes, points = tuple(frame.z for frame in frames), tuple(frame.position for frame in frames)
    hand = chain.hand(links)
    size = chain.reach
    kind, centre = _kind(axes, points, chain.turning, hand.position, size)
    if not kind:
        return None
    return Structure(
        kind=kind, axes=axes, points=points, turning=chain.turning, hand=hand.position, rotation=hand.rotation,
        centre=centre, size=size,
    )  # fmt: skip


def _frames(chain: Chain) -> "list[Frame]":
    plain: Chain = over_plain(chain)
    return plain.axes(plain.links([0.0] * len(plain.joints)))


def _kind(
    axes: "tuple[Vector, ...]", points: "tuple[Vector, ...]", turning: "tuple[bool, ...]", hand: Vector, size: float
) -> "tuple[str, Vector]":
    count, slides = len(axes), turning.count(False)
    if turning.count(True) in (2, 3) and slides <= 1 and all(parallel(axes[0], axis) for axis in axes[1:]):
        return PLANAR, hand
    if slides:
        return "", hand
    if count == 3 and parallel(axes[1], axes[2]) and not parallel(axes[0], axes[1]):
        return POSITION, hand
    if count == 6 and parallel(axes[1], axes[2]) and not parallel(axes[0], axes[1]):
        meeting = meeting_point(axes[4], points[4], axes[5], points[5], size)
        if meeting is not None:
            if parallel(axes[2], axes[3]) and not parallel(axes[3], axes[4]):
                return PARALLEL, meeting
            if on_axis(meeting, axes[3], points[3], size) and not parallel(axes[3], axes[4]):
                return SPHERICAL, meeting
    return "", hand


def _why(axes: "tuple[Vector, ...]", points: "tuple[Vector, ...]", turning: "tuple[bool, ...]", size: float) -> str:
    """What stands against a closed form."""
    count, slides = len(axes), turning.count(False)
    if slides:
        return f"it has {slides} prismatic joint{'s' * (slides > 1)}, and its axes are not all parallel"
    if all(parallel(axes[0], axis) for axis in axes[1:]):
        return f"its {count} joints turn about parallel axes, and a pose in the plane determines three of them"
    if count != 6:
        return f"it has {count} joints, and its axes are not all parallel"
    if not parallel(axes[1], axes[2]):
        return "axes 2 and 3 are not parallel"
    if parallel(axes[0], axes[1]):
        return "axes 1 and 2 are parallel"
    return "axes 4, 5 and 6 do not meet in one point, and 2, 3 and 4 are not parallel with 5 and 6 that meet"


def parallel(first: Vector, second: Vector) -> bool:
    """Whether two unit vectors are along one line."""
    across = cross(first, second)
    return hypot(*across) < SAME


def on_axis(point: Vector, axis: Vector, through: Vector, size: float) -> bool:
    """Whether a point is on an axis."""
    return hypot(*cross(axis, subtract(point, through))) < SAME * size


def meeting_point(first: Vector, on_first: Vector, second: Vector, on_second: Vector, size: float) -> Vector | None:
    """Where two axes meet, if they do."""
    normal = cross(first, second)
    square = dot(normal, normal)
    if square < SAME:
        return None
    way = subtract(on_second, on_first)
    if abs(dot(normal, way)) > SAME * size * sqrt(square):
        return None
    return add(on_first, scale(dot(cross(way, second), normal) / square, first))


@record
class Margins:
    """How far a position is from each way of being singular; None of one that the arm does not have."""

    shoulder: float | None = None
    """Distance of the wrist centre from the plane through the first axis along the second, as a length."""
    elbow: float | None = None
    """Angle of the elbow from straight or folded."""
    wrist: float | None = None
    """Angle of the wrist from having its outer axes in line."""


def margins(structure: Structure, chain: Chain, coordinates: "Sequence[float]") -> Margins:
    """Distances from singular positions, in units of their own."""
    links = chain.links(coordinates)
    frames = chain.axes(links)
    turns = structure.turns
    axes, points = [frame.z for frame in frames], [frame.position for frame in frames]
    first = 0 if structure.kind == PLANAR else 1
    one, two = turns[first], turns[first + 1]
    hand = chain.hand(links)
    centre = centre_for(structure, hand.rotation, hand.position)
    end = points[turns[first + 2]] if structure.kind == PARALLEL or (len(turns) == 3 and first == 0) else centre
    plane = Plane(axes[one])
    upper, fore = plane.flat(subtract(points[two], points[one])), plane.flat(subtract(end, points[two]))
    bend = upper.conjugate() * fore
    elbow = atan2(abs(bend.imag), abs(bend.real))
    if first == 0:
        return Margins(elbow=elbow)
    shoulder = abs(dot(cross(axes[0], axes[one]), subtract(centre, points[0])))
    if structure.kind == POSITION:
        return Margins(shoulder=shoulder, elbow=elbow)
    before = axes[one] if structure.kind == PARALLEL else axes[3]
    across = hypot(*cross(before, axes[5]))
    return Margins(shoulder=shoulder, elbow=elbow, wrist=atan2(across, abs(dot(before, axes[5]))))


def centre_for(structure: Structure, rotation: Matrix, hand: Vector) -> Vector:
    """The wrist centre of a pose of the hand."""
    back = product(rotation, transposed(structure.rotation))
    return subtract(hand, times(back, subtract(structure.hand, structure.centre)))
