"""The course of a hand: a line, or an arc through a third point, with a steady turn of the hand, from rest to rest."""

from math import cos, hypot, pi, sin

from dynamics_cli.errors import require
from dynamics_cli.numerics.orientation.rotations import Matrix, transposed
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, scale, subtract
from dynamics_cli.records import Choice, record
from dynamics_cli.robot.inverse.subproblems import angle_about, turned_about

# Three points are in line where the sine of the angle at the first is below this.
IN_LINE = 1e-9
TURN = 2.0 * pi


class Profile(Choice):
    """How the hand moves in time."""

    names = ("smooth", "constant")
    aliases = {"quintic": "smooth", "345": "smooth", "3-4-5": "smooth", "linear": "constant", "steady": "constant"}  # noqa: RUF012

    def share(self, time: float) -> float:
        """Share of the way at a share of the time: 10τ³ − 15τ⁴ + 6τ⁵ of a smooth motion."""
        if self == "constant":
            return time
        return time * time * time * (10.0 + time * (6.0 * time - 15.0))

    def rate(self, time: float) -> float:
        """Its derivative."""
        return 1.0 if self == "constant" else 30.0 * time * time * (1.0 - time) * (1.0 - time)

    @property
    def peak(self) -> float:
        """The largest derivative."""
        return 1.0 if self == "constant" else 1.875


@record
class Course:
    """Places and orientations of the hand by the share of the way."""

    start: Vector
    end: Vector
    rotation: Matrix
    turn: Vector
    """Axis of the hand's turn on the way, times its angle."""
    centre: Vector | None = None
    axis: Vector = (0.0, 0.0, 1.0)
    angle: float = 0.0

    @property
    def length(self) -> float:
        """Length of the line, or of the arc."""
        if self.centre is None:
            return hypot(*subtract(self.end, self.start))
        return self.angle * hypot(*subtract(self.start, self.centre))

    def position(self, share: float) -> Vector:
        """The hand's place."""
        if self.centre is None:
            return add(scale(1.0 - share, self.start), scale(share, self.end))
        return add(self.centre, _about(self.axis, share * self.angle, subtract(self.start, self.centre)))

    def tangent(self, share: float) -> Vector:
        """Derivative of the place by the share of the way."""
        if self.centre is None:
            return subtract(self.end, self.start)
        return scale(self.angle, cross(self.axis, subtract(self.position(share), self.centre)))

    def orientation(self, share: float) -> Matrix:
        """The hand's orientation."""
        angle = hypot(*self.turn)
        if not angle:
            return self.rotation
        axis = scale(1.0 / angle, self.turn)
        x, y, z = (_about(axis, share * angle, column) for column in transposed(self.rotation))
        return transposed((x, y, z))


def course_of(start: Vector, end: Vector, via: Vector | None, rotation: Matrix, turn: Vector) -> Course:
    """The line, or the arc through a third point."""
    if via is None:
        require(start != end or any(turn), "the path has no length: it ends where it starts", code="no-path")
        return Course(start, end, rotation, turn)
    first, second = subtract(via, start), subtract(end, start)
    normal = cross(first, second)
    square = dot(normal, normal)
    require(
        square > IN_LINE**2 * dot(first, first) * dot(second, second),
        "the start, the point on the way and the end are in line: no arc goes through them",
        code="no-arc", hint="leave out --via for a straight line",
    )  # fmt: skip
    across = add(scale(dot(second, second), cross(normal, first)), scale(-dot(first, first), cross(normal, second)))
    centre = add(start, scale(0.5 / square, across))
    axis = scale(square**-0.5, normal)
    angle = angle_about(axis, subtract(start, centre), subtract(end, centre)) % TURN
    return Course(start, end, rotation, turn, centre, axis, angle)


def _about(axis: Vector, angle: float, v: Vector) -> Vector:
    return turned_about(axis, cos(angle), sin(angle), v)
