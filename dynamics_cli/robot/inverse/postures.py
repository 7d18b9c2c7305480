"""Every posture of an arm that gives a pose, by the closed form of its structure."""

from cmath import exp, phase

from dynamics_cli.errors import require
from dynamics_cli.numerics.orientation.rotations import Matrix, product, transposed
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, subtract, times
from dynamics_cli.quantities import Ratio, Size
from dynamics_cli.records import record
from dynamics_cli.robot.inverse.structures import PARALLEL, PLANAR, POSITION, Structure, centre_for
from dynamics_cli.robot.inverse.subproblems import (
    EDGE,
    Elbow,
    Gap,
    Plane,
    Shoulder,
    Wrist,
    shoulder_angles,
    turned_about,
    turned_back,
    two_links,
    wrist_angles,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

NONE = (None, None)


@record
class Posture:
    """One set of joint positions, the names of its configuration, and its distances from singular postures."""

    coordinates: "tuple[float, ...]"
    configuration: "tuple[str, ...]"
    shoulder: "Shoulder | None" = None
    elbow: "Elbow | None" = None
    wrist: "Wrist | None" = None
    lever: float = 1.0
    """The arm's size over the shorter of its two links."""


class Branches:
    """Postures that reach the pose, and the gaps of branches that do not."""

    def __init__(self) -> None:
        self.postures: list[Posture] = []
        self.gaps: list[Gap] = []

    def open_ways(self, ways: "list[object] | Gap") -> "list[object]":
        """The ways on, none where there is a gap."""
        if isinstance(ways, Gap):
            self.gaps.append(ways)
            return []
        return ways

    def checked(self) -> "list[Posture]":
        """The postures; refuse a pose that none has."""
        if not self.postures:
            gap = min(self.gaps, key=lambda each: each.size)
            kind = Ratio if "orientation" in gap.what else Size
            require(False, gap.what, gap=(gap.size, kind), code="out-of-reach")
        return self.postures


def postures_of(
    structure: Structure, position: Vector, rotation: Matrix, near: "Sequence[float] | None"
) -> "list[Posture]":
    """Every posture of a pose. Where a pose leaves a joint open, it has its position of `near`, or zero."""
    if structure.kind == PLANAR:
        return _planar(structure, position, rotation)
    return _spatial(structure, position, rotation, near)


def _planar(structure: Structure, position: Vector, rotation: Matrix) -> "list[Posture]":
    """Two or three joints about parallel axes, and at most one slide along them."""
    axes, points, turns = structure.axes, structure.points, structure.turns
    plane = Plane(axes[0])
    lift = dot(plane.normal, subtract(position, structure.hand))
    slides = [index for index, turning in enumerate(structure.turning) if not turning]
    require(
        bool(slides) or abs(lift) <= EDGE * 100.0 * structure.size,
        "the target is {gap} out of the plane in which the arm moves",
        gap=(abs(lift), Size), code="out-of-reach",
    )  # fmt: skip
    target = plane.flat(subtract(position, points[turns[0]]))
    end = structure.centre
    if len(turns) == 3:
        # the last link's way is known from the hand's angle
        back = product(rotation, transposed(structure.rotation))
        turn = plane.flat(times(back, plane.first))
        target -= turn * plane.flat(subtract(structure.hand, points[turns[2]]))
        end = points[turns[2]]
    first = plane.flat(subtract(points[turns[1]], points[turns[0]]))
    second = plane.flat(subtract(end, points[turns[1]]))
    _require_links(structure, first, second)
    branches = Branches()
    for elbow in branches.open_ways(two_links(first, second, target)):  # type: ignore[arg-type]
        assert isinstance(elbow, Elbow)
        turned = [elbow.first, elbow.second]
        if len(turns) == 3:
            total = phase(turn)
            turned.append(total - elbow.first - elbow.second)
        values = [structure.sense(joint, plane.normal) * angle for joint, angle in zip(turns, turned, strict=True)]
        coordinates = _merged(structure, values, [structure.sense(joint, plane.normal) * lift for joint in slides])
        lever = structure.size / min(abs(first), abs(second))
        name = "straight" if elbow.margin == 0.0 else f"elbow {'left' if elbow.left else 'right'}"
        branches.postures.append(Posture(coordinates, (name,), elbow=elbow, lever=lever))
    return branches.checked()


def _merged(structure: Structure, turned: "Sequence[float]", slid: "Sequence[float]") -> "tuple[float, ...]":
    turns, travels = iter(turned), iter(slid)
    return tuple(next(turns if turning else travels) for turning in structure.turning)


def _spatial(
    structure: Structure, position: Vector, rotation: Matrix, near: "Sequence[float] | None"
) -> "list[Posture]":
    """A first axis across two parallel ones, and then a wrist, or one more parallel axis and two that meet."""
    axes, points = structure.axes, structure.points
    turned = product(rotation, transposed(structure.rotation))
    centre = centre_for(structure, rotation, position)
    way = subtract(centre, points[0])
    offset = dot(axes[1], subtract(structure.centre, points[0]))
    branches = Branches()
    for shoulder in branches.open_ways(shoulder_angles(axes[0], axes[1], way, offset, structure.size)):  # type: ignore[arg-type]
        assert isinstance(shoulder, Shoulder)
        if shoulder.free and near is not None:
            shoulder = Shoulder(near[0], 0.0, free=True)
        cosine, sine = exp(1j * shoulder.angle).real, exp(1j * shoulder.angle).imag
        placed = add(turned_about(axes[0], cosine, -sine, way), points[0])
        inner = turned_back(axes[0], shoulder.angle, turned)
        branch = _with_wrist_first if structure.kind == PARALLEL else _with_elbow_first
        branch(structure, branches, shoulder, placed, inner, near)
    return branches.checked()


def _with_elbow_first(
    structure: Structure,
    branches: Branches,
    shoulder: Shoulder,
    placed: Vector,
    inner: Matrix,
    near: "Sequence[float] | None",
) -> None:
    """The wrist centre decides the elbow, and what is left of the turn the wrist."""
    axes = structure.axes
    for elbow, second, third in _elbows(structure, branches, placed, structure.centre):
        if structure.kind == POSITION:
            _keep(structure, branches, (shoulder.angle, second, third), placed, shoulder, elbow, None)
            continue
        rest = turned_back(axes[2], third, turned_back(axes[1], second, inner))
        free = (near[3], None) if near is not None else (0.0, None)
        for wrist in branches.open_ways(wrist_angles((axes[3], axes[4], axes[5]), rest, free)):  # type: ignore[arg-type]
            assert isinstance(wrist, Wrist)
            _keep(structure, branches, (shoulder.angle, second, third, *wrist.angles), placed, shoulder, elbow, wrist)


def _with_wrist_first(
    structure: Structure,
    branches: Branches,
    shoulder: Shoulder,
    placed: Vector,
    inner: Matrix,
    near: "Sequence[float] | None",
) -> None:
    """The turn decides the last two joints and the sum of the parallel ones, and these leave a point for two links."""
    axes, points = structure.axes, structure.points
    free = (None, near[5]) if near is not None else (None, 0.0)
    for wrist in branches.open_ways(wrist_angles((axes[1], axes[4], axes[5]), inner, free)):  # type: ignore[arg-type]
        assert isinstance(wrist, Wrist)
        total = wrist.angles[0]
        turn = exp(1j * total)
        last = turned_about(axes[1], turn.real, turn.imag, subtract(structure.centre, points[3]))
        for elbow, second, third in _elbows(structure, branches, subtract(placed, last), points[3]):
            fourth = structure.sense(3, axes[1]) * (total - elbow.first - elbow.second)
            angles = (shoulder.angle, second, third, fourth, *wrist.angles[1:])
            _keep(structure, branches, angles, placed, shoulder, elbow, wrist)


def _elbows(
    structure: Structure, branches: Branches, target: Vector, end: Vector
) -> "list[tuple[Elbow, float, float]]":
    """Angles of joints 2 and 3 that bring the end of the second link to a target."""
    axes, points = structure.axes, structure.points
    plane = structure.level
    first, second = plane.flat(subtract(points[2], points[1])), plane.flat(subtract(end, points[2]))
    _require_links(structure, first, second)
    elbows = branches.open_ways(two_links(first, second, plane.flat(subtract(target, points[1]))))  # type: ignore[arg-type]
    return [(elbow, elbow.first, structure.sense(2, axes[1]) * elbow.second) for elbow in elbows]  # type: ignore[attr-defined, misc]


def _keep(
    structure: Structure,
    branches: Branches,
    angles: "tuple[float, ...]",
    placed: Vector,
    shoulder: Shoulder,
    elbow: Elbow,
    wrist: "Wrist | None",
) -> None:
    """Add a posture with the names of its configuration."""
    axes, points, plane = structure.axes, structure.points, structure.level
    forward = cross(axes[1], axes[0])
    ahead = dot(forward, subtract(structure.centre, points[0])) or dot(forward, subtract(points[2], points[1])) or 1.0
    names = ["front" if dot(forward, subtract(placed, points[0])) * ahead >= 0.0 else "back"]
    # the elbow's offset from the line to the wrist, along the first axis
    height = (plane.flat(subtract(placed, points[1])) * (1j if elbow.left else -1j)).conjugate() * plane.flat(axes[0])
    names.append("straight" if elbow.margin == 0.0 else "up" if height.real >= 0.0 else "down")
    if wrist is not None:
        if wrist.total is not None:
            names.append("in line")
        elif _wrapped(wrist.angles[1]) < 0.0:
            names.append("flip")
    end = points[3] if structure.kind == PARALLEL else structure.centre
    first, second = plane.flat(subtract(points[2], points[1])), plane.flat(subtract(end, points[2]))
    lever = structure.size / min(abs(first), abs(second))
    branches.postures.append(Posture(angles, tuple(names), shoulder, elbow, wrist, lever))


def _require_links(structure: Structure, first: complex, second: complex) -> None:
    require(
        min(abs(first), abs(second)) > EDGE * structure.size,
        "a link between parallel axes has no length: two of its joints turn about one axis",
        code="no-closed-form",
    )


def _wrapped(angle: float) -> float:
    return phase(exp(1j * angle))
