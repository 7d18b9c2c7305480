"""A displacement of a body as a screw: a turn about a line and a travel along it."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.orientation.quaternions import axis_and_angle, unit
from dynamics_cli.numerics.orientation.rotations import from_quaternion
from dynamics_cli.numerics.vectors import add, cross, dot, length, scale, subtract
from dynamics_cli.numerics.vectors import times as rotated
from dynamics_cli.orient.turns.attitude import Attitude, orientation
from dynamics_cli.quantities import Angle, Annotated, Direction, Length, Position
from dynamics_cli.records import Advice, record

ORIGIN = (0.0, 0.0, 0.0)
TURN = 6.283185307179586
# Below this angle [rad] the line is far away and not well known.
SMALL = 1e-6


@record
class Screw:
    """A displacement as a screw."""

    rotation_angle: Annotated[Angle, "Angle of the turn, from 0 to 180° [rad]."]
    axis: Annotated[Direction, "Unit vector along the screw axis [-]."]
    point: Annotated[Position | None, "The point of the axis nearest to the origin; of a pure translation none [m]."]
    travel: Annotated[Length, "Travel along the axis [m]."]
    lead: Annotated[Length | None, "Travel for a whole turn; absent for a pure translation [m]."]
    displacement: Annotated[Position, "Displacement of the body's point that was at the origin [m]."]
    advice: tuple[Advice, ...] = ()


def screw(
    *,
    turn: Annotated[Attitude, "The turn of the body, in one of the notations."],
    displacement: Annotated[Position, "Displacement of a point of the body, e.g. 0.2, -0.1, 0.3 m."],
    of_point: Annotated[Position, "That point before the displacement; the origin unless given."] = ORIGIN,
) -> Screw:
    """Screw of a displacement: axis, turn, travel and lead.

    Equation
    --------
    travel n·d, point ½·(d⊥ + cot(θ/2)·n × d⊥) for the displacement d of the point at the origin, d⊥ its part across n.

    Raises
    ------
    InadmissibleError
        When the turn cannot be read, or nothing moves.

    References
    ----------
    Chasles' theorem.

    Examples
    --------
    >>> from dynamics_cli.numerics.orientation.rotations import AxisAngle
    >>> half = AxisAngle(rotation_axis=(0.0, 0.0, 1.0), rotation_angle=3.141592653589793)
    >>> screw(turn=half, displacement=(2.0, 0.0, 0.5)).point
    (1.0, 0.0, 0.0)
    """
    rotation = orientation(turn)
    matrix = from_quaternion(rotation.quaternion)
    d = subtract(add(of_point, displacement), rotated(matrix, of_point))
    w, *rest = rotation.quaternion
    half_sine = length((rest[0], rest[1], rest[2]))
    axis, angle = axis_and_angle(rotation.quaternion)
    alone = single(half_sine, *d)
    if alone and half_sine == 0.0:
        return _translation(d, angle)
    require(half_sine > 0.0, "a row is a pure translation")
    travel = dot(axis, d)
    across = subtract(d, scale(travel, axis))
    point = scale(0.5, add(across, scale(w / half_sine, cross(axis, across))))
    return Screw(
        rotation_angle=angle,
        axis=axis,
        point=point,
        travel=travel,
        lead=travel * (TURN / angle),
        displacement=d,
        advice=_advice(angle) if alone else (),
    )


def _translation(d: "tuple[float, float, float]", angle: float) -> Screw:
    require(
        plain(length(d)) > 0.0,
        "nothing moves: there is neither a rotation nor a displacement",
        code="no-motion",
        hint="give a turn or a displacement",
    )
    note = Advice(
        "translation", "a pure translation: the axis shown is its direction; its place is arbitrary", severity="note",
        result="point",
    )  # fmt: skip
    return Screw(angle, unit(d), None, length(d), None, d, advice=(note,))


def _advice(angle: float) -> tuple[Advice, ...]:
    if plain(angle) > SMALL:
        return ()
    message = "the rotation is tiny: the axis is far away, and its relative uncertainty is that of the angle"
    return (Advice("tiny-turn", message),)
