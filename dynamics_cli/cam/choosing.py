"""The law a call asks for, by name or made to measure, and the check that its derivatives belong together."""

from dynamics_cli.cam.laws import Law, LawName, law_named
from dynamics_cli.errors import require
from dynamics_cli.quantities import (
    Fraction,
    Ratio,
)
from dynamics_cli.records import Check, record


@record
class Condition:
    """What a polynomial law is to be at one place, in units of the rise: place 0 to 1, lift 0 to 1.

    Parameters
    ----------
    place : Fraction
        Share of the span.
    lift : Ratio
        Share of the lift.
    velocity : Ratio
        First derivative by the share of the span.
    acceleration : Ratio
        Second derivative.
    jerk : Ratio
        Third derivative.
    rate_of_jerk : Ratio
        Fourth derivative.
    """

    place: Fraction
    lift: Ratio | None = None
    velocity: Ratio | None = None
    acceleration: Ratio | None = None
    jerk: Ratio | None = None
    rate_of_jerk: Ratio | None = None


@record
class SplinePoint:
    """A point a spline law goes through, in units of the rise.

    Parameters
    ----------
    place : Fraction
        Share of the span.
    lift : Ratio
        Share of the lift.
    """

    place: Fraction
    lift: Ratio


def chosen(
    name: LawName,
    shares: "tuple[float, ...]",
    constant: float | None,
    conditions: "tuple[Condition, ...]",
    points: "tuple[SplinePoint, ...]",
    start_velocity: float = 0.0,
    end_velocity: float = 0.0,
) -> Law:
    """Give the law of a name, with what belongs to it alone: shares, conditions or points.

    Parameters
    ----------
    name : LawName
        Its name.
    shares : tuple of float
        Shares of scca.
    constant : float
        Share at constant velocity.
    conditions : tuple of Condition
        What a polynomial meets.
    points : tuple of SplinePoint
        What a spline goes through.
    start_velocity, end_velocity : float
        Slopes of a spline at its ends.

    Returns
    -------
    Law
        The law.

    Raises
    ------
    InadmissibleError
        When something belongs to another law, or is missing.
    """
    require(name == "polynomial" or not conditions, "the law {0} takes no conditions", name, code="law")
    require(name == "spline" or not points, "the law {0} goes through no points", name, code="law")
    require(
        name == "spline" or (start_velocity == 0.0 and end_velocity == 0.0),
        "the law {0} has velocities of its own at its ends",
        name,
        code="law",
        hint="take a polynomial with conditions",
    )
    if name == "polynomial":
        from dynamics_cli.cam.polynomials import polynomial

        require(bool(conditions), "a polynomial needs conditions", code="conditions", hint=CONDITION_HINT)
        return polynomial([found for one in conditions for found in _conditions(one)])
    if name == "spline":
        from dynamics_cli.cam.polynomials import spline

        inner = [(point.place, point.lift) for point in points]
        return spline([(0.0, 0.0), *inner, (1.0, 1.0)], start_velocity, end_velocity)
    return law_named(name, shares or None, constant)


CONDITION_HINT = 'for example --condition "place=0, lift=0, velocity=0" --condition "place=1, lift=1, velocity=0"'


def _conditions(one: Condition) -> "list[tuple[float, int, float]]":
    values = (one.lift, one.velocity, one.acceleration, one.jerk, one.rate_of_jerk)
    found = [(one.place, order, value) for order, value in enumerate(values) if value is not None]
    require(bool(found), "the condition at {0:.6g} asks for nothing", one.place, code="conditions", hint=CONDITION_HINT)
    return found


def area_checks(law: Law) -> "tuple[Check, ...]":
    """The areas under velocity and acceleration, by Gauss's rule, are lift and gain of velocity."""
    area = [0.0, 0.0]
    size = 0.0
    for piece in law.pieces:
        start, end = piece.ends
        half = 0.5 * (end - start)
        for node, weight in GAUSS:
            for t in (start + half * (1.0 - node), start + half * (1.0 + node)):
                found = law.upright(piece, t, 2)
                area = [area[0] + weight * half * found[1], area[1] + weight * half * found[2]]
                size += weight * half * abs(found[2])
    gain = law.at(1.0, 1, -1)[1] - law.at(0.0, 1)[1]
    scale = max(abs(law.total), 1e-300)
    worst = max(abs(area[0] - law.total) / scale, abs(area[1] - gain) / max(size, 1e-300) if size else 0.0)
    return (Check(f"areas under {law.name}", worst <= 1e-12, worst, 1e-12),)


# Abscissae and weights of Gauss's rule of 16 points, the positive half.
GAUSS = (
    (0.09501250983763744, 0.1894506104550685), (0.2816035507792589, 0.18260341504492358),
    (0.45801677765722737, 0.16915651939500254), (0.6178762444026438, 0.14959598881657674),
    (0.755404408355003, 0.12462897125553388), (0.8656312023878318, 0.09515851168249279),
    (0.9445750230732326, 0.06225352393864789), (0.9894009349916499, 0.027152459411754095),
)  # fmt: skip
