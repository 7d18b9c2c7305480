"""The few geometric problems that inverse kinematics of common arms comes down to, in doubles."""

from cmath import exp, phase
from math import atan2, hypot, pi, sqrt

from dynamics_cli.numerics.orientation.rotations import Matrix, transposed
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, scale, subtract, times
from dynamics_cli.records import record

# Rounding of lengths, as a share of them: a target no farther beyond the reach counts as at its edge.
EDGE = 2e-15


@record
class Gap:
    """How far a target is out of reach, and what of."""

    size: float
    what: str
    """A template with a place `{gap}`."""


def turned_about(axis: Vector, cosine: float, sine: float, v: Vector) -> Vector:
    """A vector turned about a unit axis."""
    along = scale(dot(axis, v), axis)
    return add(along, add(scale(cosine, subtract(v, along)), scale(sine, cross(axis, v))))


def angle_about(axis: Vector, start: Vector, end: Vector) -> float:
    """The angle about a unit axis from one vector to another."""
    across = subtract(start, scale(dot(axis, start), axis))
    return atan2(dot(axis, cross(start, end)), dot(across, end))


class Plane:
    """The plane across a unit vector; its vectors as complex numbers."""

    def __init__(self, normal: Vector) -> None:
        self.normal = normal
        # the axis that is least along the normal makes the first axis of the plane
        least = min(range(3), key=lambda k: abs(normal[k]))
        start = (0.0, 1.0, 0.0) if least == 1 else (1.0, 0.0, 0.0) if least == 0 else (0.0, 0.0, 1.0)
        start = subtract(start, scale(dot(normal, start), normal))
        self.first: Vector = scale(1.0 / sqrt(dot(start, start)), start)
        self.second: Vector = cross(normal, self.first)

    def flat(self, v: Vector) -> complex:
        """The part of a vector in the plane."""
        return complex(dot(self.first, v), dot(self.second, v))


@record
class Elbow:
    """One way for two links in a plane to reach a point."""

    first: float
    """Turn of the first link from where it was."""
    second: float
    """Turn of the second link against the first."""
    margin: float
    """Angle at the elbow from straight or folded."""
    left: bool
    """Whether the elbow is to the left of the line to the point."""
    free: bool = False
    """Whether any first angle would do: the point is on the first axis."""


def two_links(first: complex, second: complex, target: complex) -> "list[Elbow] | Gap":
    """Turns of two links in a plane, given where they are at zero, that bring the end of the second to a point.

    The elbow's angle is 2·atan2(√((l₁ + l₂ − r)(l₁ + l₂ + r)), √((r − |l₁ − l₂|)(r + |l₁ − l₂|))), which keeps its
    digits at the edges of the reach, where the arc cosine loses half of them.
    """
    l1, l2, r = abs(first), abs(second), abs(target)
    outer = (max(l1, l2) - r) + min(l1, l2)
    inner = r - abs(l1 - l2)
    tiny = EDGE * (l1 + l2)
    if outer < -tiny:
        return Gap(-outer, "the target is {gap} beyond the reach of the stretched arm")
    if inner < -tiny:
        return Gap(-inner, "the target is {gap} too near: the folded arm does not reach back so far")
    outer, inner = max(outer, 0.0), max(inner, 0.0)
    bend = 2.0 * atan2(sqrt(outer * (l1 + l2 + r)), sqrt((r + abs(l1 - l2)) * inner))
    if not outer or not inner:
        bend = 0.0 if not outer else pi
    ways = [bend, -bend] if outer and inner else [bend]
    elbows = []
    for delta in ways:
        ahead = phase(target) - phase(l1 + l2 * exp(1j * delta)) if r > tiny else 0.0
        elbows.append(
            Elbow(
                first=ahead - phase(first),
                second=delta + phase(first) - phase(second),
                margin=min(bend, pi - bend),
                left=delta < 0.0,
                free=r <= tiny,
            )
        )
    return elbows


@record
class Shoulder:
    """One angle of the first joint."""

    angle: float
    margin: float
    """Distance from where both angles fall together [m]."""
    free: bool = False


def shoulder_angles(axis: Vector, level: Vector, way: Vector, offset: float, size: float) -> "list[Shoulder] | Gap":
    """Angles q about an axis that leave a point's component along another one: level·R(axis, −q)·way = offset."""
    tilt = dot(level, axis)
    along = dot(axis, way)
    a = dot(level, way) - tilt * along
    b = -dot(level, cross(axis, way))
    wanted = offset - tilt * along
    radius = hypot(a, b)
    tiny = EDGE * size
    if radius < tiny and abs(wanted) < tiny:
        return [Shoulder(0.0, 0.0, free=True)]
    over = abs(wanted) - radius
    if over > tiny:
        return Gap(over, "the wrist centre is {gap} too near the first axis for the arm's offset from it")
    root = sqrt(max((radius - wanted) * (radius + wanted), 0.0))
    middle, side = atan2(b, a), atan2(root, wanted)
    return [Shoulder(middle + side, root), Shoulder(middle - side, root)][: 2 if root > tiny else 1]


@record
class Wrist:
    """One set of angles of three axes that give a rotation."""

    angles: tuple[float, float, float]
    margin: float
    """Angle of the middle joint from where the outer axes are in line."""
    total: float | None = None
    """In line: the one number that is determined, first angle plus (or minus, by `opposed`) the last."""
    opposed: bool = False


def wrist_angles(
    axes: "tuple[Vector, Vector, Vector]", wanted: Matrix, free: "tuple[float | None, float | None]"
) -> "list[Wrist] | Gap":
    """Angles about three axes whose turns give a rotation; where the outer ones are in line, one of them is `free`."""
    first, middle, last = axes
    moved = times(wanted, last)
    skew, lean = dot(first, middle), dot(middle, last)
    a = dot(first, last) - skew * lean
    b = dot(first, cross(middle, last))
    level = dot(first, moved) - skew * lean
    radius = hypot(a, b)
    across = cross(first, moved)
    square = dot(across, across) if max(abs(skew), abs(lean)) < EDGE else (radius - level) * (radius + level)
    if square < -4.0 * EDGE:
        return Gap(sqrt(-square), "the wrist's axes do not reach the orientation: {gap} is missing")
    root = sqrt(max(square, 0.0))
    centre, side = atan2(b, a), atan2(root, level)
    wrists = []
    for sign in (1.0, -1.0) if root > EDGE else (1.0,):
        bend = centre + sign * side
        cosine, sine = _unit(bend)
        if root > EDGE:
            start = angle_about(first, turned_about(middle, cosine, sine, last), moved)
            end = _last_angle(axes, wanted, start, (cosine, sine))
            wrists.append(Wrist(angles=(start, bend, end), margin=min(side, pi - side)))
            continue
        opposed = dot(first, turned_about(middle, cosine, sine, last)) < 0.0
        sense = -1.0 if opposed else 1.0
        end = _last_angle(axes, wanted, 0.0, (cosine, sine))
        total = sense * end
        if free[0] is not None:
            start, end = free[0], sense * (total - free[0])
        else:
            end = free[1] or 0.0
            start = total - sense * end
        wrists.append(Wrist(angles=(start, bend, end), margin=0.0, total=total, opposed=opposed))
    return wrists


def _last_angle(
    axes: "tuple[Vector, Vector, Vector]", wanted: Matrix, start: float, bend: "tuple[float, float]"
) -> float:
    """The last angle once the others are known, from a vector across the last axis: errors of the first go with it."""
    first, middle, last = axes
    across = Plane(last).first
    cosine, sine = _unit(start)
    back = turned_about(first, cosine, -sine, times(wanted, across))
    back = turned_about(middle, bend[0], -bend[1], back)
    return angle_about(last, across, back)


def _unit(angle: float) -> "tuple[float, float]":
    turn = exp(1j * angle)
    return turn.real, turn.imag


def turned_back(axis: Vector, angle: float, matrix: Matrix) -> Matrix:
    """R(axis, −angle)·matrix."""
    cosine, sine = _unit(angle)
    x, y, z = (turned_about(axis, cosine, -sine, column) for column in transposed(matrix))
    return transposed((x, y, z))
