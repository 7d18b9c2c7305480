"""Flywheels: how much energy a torque that varies puts in and takes out, and the inertia that keeps the speed."""

from itertools import pairwise

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, Energy, Fraction, Inertia, Mass, ShaftSpeed, Size, Text, Torque
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# What the first and the last torque of a cycle may differ by, beside the largest.
CLOSED = 1e-9


@record
class Point:
    """The torque at an angle."""

    angle: Annotated[Angle, "Angle of the shaft, e.g. 30 deg."]
    torque: Annotated[Torque, "Torque on the shaft, e.g. 400 N*m."]


@record
class Crossing:
    """Where the torque is equal to its mean: the speed is largest or smallest there."""

    angle: Annotated[Angle, "Angle of the shaft [rad]."]
    energy: Annotated[Energy, "Energy stored since the first angle [J]."]
    speed: Annotated[Text, "Whether the speed is a maximum or a minimum."]


@record
class Flywheel:
    """The flywheel of a machine."""

    mean_torque: Annotated[Torque, "Mean torque, that of a steady load [N·m]."]
    energy: Annotated[Energy, "Energy between the slowest and the fastest angle [J]."]
    inertia: Annotated[Inertia, "Moment of inertia required of all rotating parts [kg·m²]."]
    fastest: Annotated[Angle, "Angle of the largest speed [rad]."]
    slowest: Annotated[Angle, "Angle of the smallest speed [rad]."]
    rim_mass: Annotated[Mass | None, "Mass of a thin rim of the radius given with that inertia [kg]."]
    crossings: Annotated[tuple[Crossing, ...], "Where the torque crosses its mean."]


def flywheel(
    *,
    points: Annotated[tuple[Point, ...], "Torque over one cycle, linear between points."],
    speed: Annotated[ShaftSpeed, "Mean speed, e.g. 300 rpm."],
    fluctuation: Annotated[Fraction, "Coefficient of fluctuation: largest less smallest speed over the mean."] = 0.02,
    rim_radius: Annotated[Size | None, "Mean radius of the rim, e.g. 0.6 m."] = None,
) -> Flywheel:
    """Moment of inertia that keeps the speed of a shaft under a torque that varies, against a steady load.

    Equation
    --------
    ΔE = largest − smallest of ∫(T − T̄)dθ, whose extremes are where T crosses its mean; I = ΔE/(C_s·ω²).

    Returns
    -------
    Flywheel
        Mean torque, energy fluctuation, inertia, and where the shaft is fastest and slowest.

    Raises
    ------
    InadmissibleError
        When there are fewer than three points, angles do not increase, the cycle does not close, the torque does not
        vary, or speed or fluctuation is zero.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, chapter 15.

    Examples
    --------
    >>> table = [(0.0, 0.0), (1.0, 10.0), (2.0, 0.0), (3.0, -10.0), (4.0, 0.0)]
    >>> made = flywheel(points=tuple(Point(*one) for one in table), speed=10.0, fluctuation=0.1)
    >>> made.energy, made.inertia
    (10.0, 1.0)
    """
    _require_cycle(points)
    require(abs(plain(speed)) > 0.0, "a shaft at rest needs no flywheel", code="at-rest")
    require(fluctuation > 0.0, "no flywheel keeps the speed perfectly constant", code="even", hint="for example 2 %")
    require(rim_radius is None or rim_radius > 0.0, "the radius of the rim is zero", code="no-radius")
    work: Any = 0.0
    for one, other in pairwise(points):
        work = work + 0.5 * (one.torque + other.torque) * (other.angle - one.angle)
    mean = work / (points[-1].angle - points[0].angle)
    rows = _crossings(points, mean)
    high = max(rows, key=lambda row: plain(row[1]))
    low = min(rows, key=lambda row: plain(row[1]))
    span = high[1] - low[1]
    inertia = span / (fluctuation * speed * speed)
    return Flywheel(
        mean_torque=mean,
        energy=span,
        inertia=inertia,
        fastest=high[0],
        slowest=low[0],
        rim_mass=None if rim_radius is None else inertia / (rim_radius * rim_radius),
        crossings=tuple(Crossing(angle, energy, "maximum" if falls else "minimum") for angle, energy, falls in rows),
    )


def require_increasing(angles: "list[float]") -> None:
    """Refuse angles of a cycle that are not in order."""
    for before, angle in pairwise(angles):
        require(
            angle > before,
            "the angle {other} is not larger than the one before, {one}",
            code="order",
            hint="list the points by increasing angle",
            one=(before, Angle),
            other=(angle, Angle),
        )


def _require_cycle(points: "tuple[Point, ...]") -> None:
    require(
        len(points) >= 3,
        "{count} points do not make a cycle of torque",
        code="too-few",
        hint='give --point "angle=0 deg, torque=-80 N*m" for each, three or more',
        count=str(len(points)),
    )
    require_increasing([point.angle for point in points])
    first, last = points[0].torque, points[-1].torque
    largest = max(abs(plain(one.torque)) for one in points)
    require(
        abs(plain(last) - plain(first)) <= CLOSED * largest,
        "the cycle does not close: it begins with {first} and ends with {last}",
        code="open",
        hint="end it with the torque that it begins with",
        first=(first, Torque),
        last=(last, Torque),
    )
    require(
        max(plain(one.torque) for one in points) > min(plain(one.torque) for one in points),
        "the torque does not vary: no flywheel is needed",
        code="constant",
    )


def _crossings(points: "tuple[Point, ...]", mean: "Any") -> "list[tuple[Any, Any, bool]]":
    """Angle and energy of every crossing of the mean, and whether the torque falls through it."""
    energy: Any = 0.0
    rows = []
    for one, other in pairwise(points):
        before, after, width = one.torque - mean, other.torque - mean, other.angle - one.angle
        if plain(before) * plain(after) < 0.0 or (plain(before) == 0.0 != plain(after)):
            share = before / (before - after)
            rows.append((one.angle + share * width, energy + 0.5 * before * share * width, plain(before - after) > 0.0))
        energy = energy + 0.5 * (before + after) * width
    return rows
