"""A chain of turns: the total turn, and direction cosines between all frames."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.orientation.quaternions import Quaternion, axis_and_angle, multiply, upright
from dynamics_cli.numerics.orientation.rotations import IDENTITY, Matrix, about_axis, product, transposed
from dynamics_cli.numerics.orientation.rotations import from_quaternion as matrix_of
from dynamics_cli.numerics.turns import turned
from dynamics_cli.orient.turns.attitude import Attitude, orientation
from dynamics_cli.orient.turns.convert import TOLERANCE, distance_of
from dynamics_cli.quantities import Angle, Annotated, Direction, Ratio, RotationMatrix, Text
from dynamics_cli.quantities import Quaternion as QuaternionKind
from dynamics_cli.records import Check, Choice, record


class AxisName(Choice):
    """A coordinate axis."""

    names = ("x", "y", "z")
    aliases = {"1": "x", "2": "y", "3": "z"}  # noqa: RUF012


class About(Choice):
    """Whose axes a chain turns about."""

    names = ("body", "fixed")


BODY = About("body")


@record
class SimpleTurn:
    """A turn about a coordinate axis, which makes a new frame."""

    axis: Annotated[AxisName, "Axis of the turn: x, y, z or 1, 2, 3."]
    angle: Annotated[Angle, "Angle of the turn, e.g. 30 deg."]
    name: Annotated[Text | None, "Name of the frame after the turn, e.g. cradle."] = None


@record
class GeneralTurn:
    """A turn in any notation, which makes a new frame."""

    turn: Annotated[Attitude, "The rotation, in one of the notations."]
    name: Annotated[Text | None, "Name of the frame after the turn, e.g. tool."] = None


@record
class Cosines:
    """Direction cosines of one unit vector of a frame with those of a later one."""

    frame: Annotated[Text, "The earlier frame."]
    vector: Annotated[Text, "Its unit vector."]
    of: Annotated[Text, "The later frame."]
    x: Annotated[Ratio, "Cosine with the later frame's x [-]."]
    y: Annotated[Ratio, "Cosine with its y [-]."]
    z: Annotated[Ratio, "Cosine with its z [-]."]


@record
class Composed:
    """The total of a chain of turns."""

    rotation_angle: Annotated[Angle, "Angle of the total turn, from 0 to 180° [rad]."]
    rotation_axis: Annotated[Direction, "Unit vector along its axis [-]."]
    quaternion: Annotated[QuaternionKind, "w, x, y, z of the total turn, w ≥ 0 [-]."]
    rotation_matrix: Annotated[RotationMatrix, "Takes components of the last frame to those of the first [-]."]
    cosines: Annotated[tuple[Cosines, ...], "Direction cosines between every pair of frames."]
    frames: Annotated[Text, "The frames in order."]
    checks: tuple[Check, ...] = ()


def letter(nth: int) -> str:
    """Names of frames that were given none, which are A, B, C and so on."""
    return chr(ord("A") + nth) if nth < 26 else f"frame {nth + 1}"


def compose(
    *,
    turns: Annotated[SimpleTurn | tuple[SimpleTurn, ...], "The turns about coordinate axes, in order."] = (),
    general_turns: Annotated[tuple[GeneralTurn, ...], "Or turns in any notation, in order."] = (),
    about: Annotated[About, "Whose axes: body (each turn about the axes as they have become) or fixed."] = BODY,
    base: Annotated[Text, "Name of the first frame, e.g. A."] = "A",
) -> Composed:
    """Total of a chain of turns, and direction cosines between every pair of frames.

    Equation
    --------
    R = R₁·R₂·…·Rₙ about the body's axes, Rₙ·…·R₂·R₁ about the fixed ones.

    Raises
    ------
    InadmissibleError
        When there is no turn, turns of both kinds are given, or a turn cannot be read.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 4.3.

    Examples
    --------
    >>> quarter = 1.5707963267948966
    >>> chain = (SimpleTurn(axis=AxisName("z"), angle=quarter), SimpleTurn(axis=AxisName("x"), angle=quarter))
    >>> [round(part, 12) for part in compose(turns=chain).quaternion]
    [0.5, 0.5, 0.5, 0.5]
    """
    simple = turns if isinstance(turns, tuple) else (turns,)
    require(
        bool(simple) != bool(general_turns),
        "the order of simple and general turns is not known" if simple else "there is no turn",
        code="turns",
        hint='give --general-turn "rotation_axis=(1, 0, 0), rotation_angle=30 deg" for the simple ones'
        if simple
        else 'for example --simple-turn "axis=z, angle=30 deg"',
    )
    chain = [(turn.name, *_simple(turn)) for turn in simple] or [(turn.name, *_general(turn)) for turn in general_turns]
    frames: list[Matrix] = [IDENTITY]
    steps: list[Matrix] = []
    composed: Quaternion = (1.0, 0.0, 0.0, 0.0)
    for _, step, quaternion in chain:
        steps.append(step)
        frames.append(product(frames[-1], step) if about == "body" else product(step, frames[-1]))
        composed = multiply(composed, quaternion) if about == "body" else multiply(quaternion, composed)
    composed = upright(composed)
    rotation_axis, angle = axis_and_angle(composed)
    names = [base, *(name or letter(nth) for nth, (name, _, _) in enumerate(chain, 1))]
    alone = single(*composed)
    return Composed(
        rotation_angle=angle,
        rotation_axis=rotation_axis,
        quaternion=composed,
        rotation_matrix=frames[-1],
        cosines=_table(frames, steps if about == "body" else [], names) if alone else (),
        frames=" → ".join(names),
        checks=_checks(frames[-1], composed) if alone else (),
    )


def _simple(turn: SimpleTurn) -> tuple[Matrix, Quaternion]:
    axis = "xyz".index(turn.axis)
    cosine, sine = turned(0.5 * turn.angle)
    x, y, z = (sine if k == axis else 0.0 for k in range(3))
    return about_axis(axis, turn.angle), (cosine, x, y, z)


def _general(turn: GeneralTurn) -> tuple[Matrix, Quaternion]:
    read = orientation(turn.turn)
    return read.matrix, read.quaternion


def _table(frames: "list[Matrix]", steps: "list[Matrix]", names: "list[str]") -> tuple[Cosines, ...]:
    rows = []
    for first, earlier in enumerate(frames):
        between = IDENTITY
        for last in range(first + 1, len(frames)):
            # step by step, which keeps the zeros of simple turns
            between = product(between, steps[last - 1]) if steps else product(transposed(earlier), frames[last])
            cosines = between
            rows += [Cosines(names[first], "xyz"[k], names[last], *cosines[k]) for k in range(3)]
    return tuple(rows)


def _checks(matrix: Matrix, q: Quaternion) -> tuple[Check, ...]:
    doubles = tuple(map(plain, q))
    off = distance_of(matrix, matrix_of(doubles))  # type: ignore[arg-type]
    return (Check("quaternions give the same total", off <= TOLERANCE, off, TOLERANCE),)
