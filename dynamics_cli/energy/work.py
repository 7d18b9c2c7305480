"""The task `work`: what each force does along a motion, and all together."""

from itertools import pairwise

from dynamics_cli.errors import MissingError, require
from dynamics_cli.numerics.elementary import cos, summed
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Angle,
    Annotated,
    Distance,
    Force,
    Friction,
    Gravity,
    Length,
    Mass,
    PotentialEnergy,
    Stiffness,
    Torque,
)
from dynamics_cli.records import Choice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


class Between(Choice):
    """What a table's force does between two positions: it changes on a line, or keeps its value until the next."""

    __slots__ = ()
    names = ("lines", "steps")


LINES = Between("lines")


@record
class Spring:
    """A spring that is stretched, compressed or let go."""

    stiffness: Annotated[Stiffness, "Stiffness of a spring that acts on the body, e.g. 2000 N/m."]
    start_stretch: Annotated[Length, "Its stretch at the start, negative when compressed, e.g. 0.1 m."]
    end_stretch: Annotated[Length, "Its stretch at the end, e.g. 0 m."]


@record
class Measured:
    """A force that was measured along the way."""

    positions: Annotated[tuple[Length, ...], "Positions along the way, e.g. 0, 0.1, 0.3 m."]
    forces: Annotated[tuple[Force, ...], "The force along the way at each, e.g. 0, 200, 250 N."]
    between: Annotated[Between, "What the force does between two positions."] = LINES


@record
class Work:
    """The work of each force, and of all."""

    total: Annotated[PotentialEnergy, "Work of all that was given: the gain of kinetic energy [J]."]
    constant: Annotated[PotentialEnergy | None, "Work of the constant force [J]."]
    couple: Annotated[PotentialEnergy | None, "Work of the couple [J]."]
    weight: Annotated[PotentialEnergy | None, "Work of gravity [J]."]
    rubbing: Annotated[PotentialEnergy | None, "Work of friction, never above zero [J]."]
    spring: Annotated[PotentialEnergy | None, "Work of the spring on the body [J]."]
    measured: Annotated[PotentialEnergy | None, "Work of the measured force [J]."]
    mean_force: Annotated[Force | None, "Mean of the measured force over the way [N]."]


def work(
    *,
    distance: Annotated[Distance | None, "Way of the constant force and of friction, e.g. 5 m."] = None,
    force: Annotated[Force | None, "A constant force, e.g. 200 N."] = None,
    angle: Annotated[Angle, "Angle between the force and the way, e.g. 30 deg."] = 0.0,
    friction: Annotated[Friction | None, "Coefficient of sliding friction along the distance, e.g. 0.3."] = None,
    normal_force: Annotated[Force | None, "Force that presses the rubbing surfaces together, e.g. 500 N."] = None,
    torque: Annotated[Torque | None, "A constant couple in the sense of the turn, e.g. 40 N*m."] = None,
    turn: Annotated[Angle | None, "The angle turned, e.g. 90 deg."] = None,
    mass: Annotated[Mass | None, "A mass that rises or falls, e.g. 80 kg."] = None,
    rise: Annotated[Length | None, "How far it rises, negative when it falls, e.g. -2 m."] = None,
    spring: Annotated[Spring | None, "A spring between two stretches."] = None,
    measured: Annotated[Measured | None, "A force measured along the way."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Work:
    """Work of forces and couples along a motion: each by itself, and their sum.

    Equation
    --------
    W = F·s·cos α; spring ½·k·(δ₁ − δ₂)·(δ₁ + δ₂); couple M·θ; gravity −m·g·h; friction −μ·N·s; measured ∫ F dx.

    Returns
    -------
    Work
        The work of each, their sum, and the mean of a measured force.

    Raises
    ------
    UsageError
        When one of two numbers that belong together is missing.
    InadmissibleError
        When nothing is given, a measured force has fewer than two positions or unequal columns, or positions turn back.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 10.2 and 10.3.

    Examples
    --------
    >>> work(spring=Spring(2000.0, 0.0, 1e-7)).total
    -1e-11
    """
    constant = couple = weight = rubbing = sprung = area_below = mean = None
    if force is not None:
        constant = force * _beside(distance, "distance", "force") * cos(angle)
    if friction is not None:
        pressing = _beside(normal_force, "normal_force", "friction")
        require(pressing >= 0.0, "a normal force of {force} does not press the surfaces together",
                force=(pressing, Force), code="normal-force", hint="give its size")  # fmt: skip
        rubbing = -(friction * pressing * _beside(distance, "distance", "friction"))
    if distance is not None and force is None and friction is None:
        raise MissingError("along the distance no force acts", [("force",), ("friction", "normal_force")])
    for name, value, needed, there in (
        ("angle", plain(angle) or None, "force", force),
        ("normal_force", normal_force, "friction", friction),
        ("turn", turn, "torque", torque),
        ("rise", rise, "mass", mass),
    ):
        if value is not None:
            _beside(there, needed, name)
    if torque is not None:
        couple = torque * _beside(turn, "turn", "torque")
    if mass is not None:
        weight = -(mass * gravity * _beside(rise, "rise", "mass"))
    if spring is not None:
        start, end = spring.start_stretch, spring.end_stretch
        sprung = 0.5 * spring.stiffness * (start - end) * (start + end)
    if measured is not None:
        area_below = area(measured.positions, measured.forces, str(measured.between), Length, "positions")
        mean = area_below / (measured.positions[-1] - measured.positions[0])
    works = (constant, couple, weight, rubbing, sprung, area_below)
    given = [part for part in works if part is not None]
    require(bool(given), "no force or moment that does work is given", code="nothing",
            hint="give --force with --distance, --torque with --turn, or another that help names")  # fmt: skip
    return Work(summed(given), *works, mean)


def _beside(value: "float | None", name: str, other: str) -> float:
    """A number that another one needs."""
    if value is None:
        raise MissingError(f"the {other.replace('_', ' ')} is given without its {name.replace('_', ' ')}", [(name,)])
    return value


def area(places: "Sequence[float]", values: "Sequence[float]", between: str, kind: object, name: str) -> float:
    """Area below a table of values: trapezia between lines, rectangles below steps."""
    require(len(places) >= 2, "{count} {name} have nothing between them", count=len(places), name=name, code="too-few",
            hint="give two or more")  # fmt: skip
    require(len(values) == len(places), "{count} {name}, but {has} forces", count=len(places), name=name,
            has=len(values), code="lengths", hint="give a force for each")  # fmt: skip
    for before, after in pairwise(places):
        require(plain(after) > plain(before), "{after} does not come after {before}", code="order",
                after=(after, kind), before=(before, kind), hint="list them in increasing order")  # fmt: skip
    parts = []
    for (before, after), (low, high) in zip(pairwise(places), pairwise(values), strict=True):
        height = low if between == "steps" else 0.5 * (low + high)
        parts.append(height * (after - before))
    return summed(parts)
