"""Coefficient of friction from test skids: the value of each, their mean and scatter."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import maximum, minimum, multiply_add, sqrt, summed, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import drag_along, friction_advice, grade_advice, secant
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Distance,
    DragFactor,
    Fraction,
    Friction,
    Gravity,
    RoadSpeed,
    Slope,
)
from dynamics_cli.records import Advice, Check, record
from dynamics_cli.skid.diagnostics import balance

# Ice has 0.1 to 0.15, wet ice less.
LOWEST_FRICTION = 0.03


@record
class TestSkid:
    """One test skid to rest."""

    speed: Annotated[RoadSpeed, "Speed where the wheels locked [m/s]."]
    distance: Annotated[Distance, "Length of the skid along the road [m]."]
    grade: Annotated[Slope, "Rise over run of the road in the direction of travel, uphill positive [-]."] = 0.0
    braking: Annotated[
        Fraction, "Share of the full friction that the brakes used, 1 when all wheels were locked [-]."
    ] = 1.0


@record
class SkidTested:
    """The result of one test skid."""

    friction: Annotated[Friction, "Coefficient of friction [-]."]
    drag_factor: Annotated[DragFactor, "Deceleration along the road over gravity [-]."]


@record
class FrictionFound:
    """Friction from one test skid, or the mean of several with their scatter."""

    friction: Annotated[Friction, "Coefficient of friction, the mean when there are several test skids [-]."]
    standard_deviation: Annotated[
        Friction | None, "Sample standard deviation of the test skids; needs two or more [-]."
    ]
    standard_error: Annotated[Friction | None, "Standard deviation of the mean; needs two or more [-]."]
    lowest: Annotated[Friction, "Lowest friction of the test skids [-]."]
    highest: Annotated[Friction, "Highest friction of the test skids [-]."]
    tests: Annotated[tuple[SkidTested, ...], "Every test skid by itself."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def friction(
    *,
    skids: Annotated[TestSkid | tuple[TestSkid, ...], "The test skids; one may be given by its plain fields."],
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> FrictionFound:
    """Coefficient of friction from the speed and length of one or several test skids to rest.

    Equation
    --------
    f = v²/(2 g d), μ = (f √(1 + G²) − G)/η; s² = Σ(μ_i − mean)²/(n − 1), standard error s/√n.

    Returns
    -------
    FrictionFound
        The (mean) friction, sample standard deviation, standard error, lowest and highest, and each test skid's values.

    Raises
    ------
    InadmissibleError
        When a skid has no length, no speed or no braking, or when the grade alone would have stopped the vehicle
        sooner.

    Notes
    -----
    Each test vehicle is a point mass slowed uniformly to rest. Equal skids scatter by exactly
    zero. The scatter describes the test skids, not the error of the instruments.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10 (solved for friction).

    Examples
    --------
    >>> round(friction(skids=(TestSkid(speed=13.4, distance=12.9), TestSkid(speed=13.4, distance=13.3))).friction, 4)
    0.699
    """
    several = skids if isinstance(skids, tuple) else (skids,)
    require(len(several) > 0, "no test skid is given", code="no-skid")
    drags = [
        _drag(test, gravity, f"skids[{index}]: " if len(several) > 1 else "") for index, test in enumerate(several)
    ]
    values = [
        _friction(test, drag, f"skids[{index}]: " if len(several) > 1 else "")
        for index, (test, drag) in enumerate(zip(several, drags, strict=True))
    ]
    lowest = highest = mean = values[0]
    for test in values[1:]:
        lowest, highest = minimum(lowest, test), maximum(highest, test)
    spread: float | None = None
    error: float | None = None
    if len(values) > 1:
        mean = summed(values) / float(len(values))
        # the mean of equal numbers is that number, exactly
        mean = where(lowest == highest, mean + (lowest - mean), mean)
        variance = summed([(test - mean) * (test - mean) for test in values]) / float(len(values) - 1)
        spread = sqrt(variance)
        error = spread / sqrt(float(len(values)))
    return FrictionFound(
        friction=mean,
        standard_deviation=spread,
        standard_error=error,
        lowest=lowest,
        highest=highest,
        tests=tuple(SkidTested(*row) for row in zip(values, drags, strict=True)),
        checks=_check(several, values, drags),
        advice=_absurd(several, values) + _advice(spread, mean),
    )


def _drag(skid: TestSkid, gravity: float, name: str) -> float:
    require(skid.distance > 0.0, "{name}the distance of a skid must be more than zero", code="no-length", name=name)
    require(skid.speed > 0.0, "{name}the speed of a skid must be more than zero", code="no-speed", name=name)
    return skid.speed / (2.0 * gravity * skid.distance) * skid.speed


def _friction(skid: TestSkid, drag: float, name: str) -> float:
    require(skid.braking > 0.0, "{name}the braking of a test skid must be more than zero", code="no-braking", name=name)
    grip = (
        drag if type(skid.grade) is float and skid.grade == 0.0 else multiply_add(drag, secant(skid.grade), -skid.grade)
    )
    require(
        grip >= 0.0,
        "{name}the grade alone would have stopped the vehicle sooner: friction would be {friction}",
        code="negative-friction",
        hint="uphill grades are positive; check speed, distance and grade",
        name=name,
        friction=(grip / skid.braking, Friction),
    )
    return grip / skid.braking


def _check(several_skids: tuple[TestSkid, ...], frictions: list[float], drags: list[float]) -> tuple[Check, ...]:
    """Check every friction by recalculating the drag factor from it."""
    checks: tuple[Check, ...] = ()
    for skid, mu, drag in zip(several_skids, frictions, drags, strict=True):
        back = drag_along(mu, skid.grade, skid.braking)
        operands = (skid.speed, skid.distance, skid.braking, mu, drag)
        checks += balance("drag factor from the friction found", back, drag, drag + abs(skid.grade), *operands)
    worst = max(checks, key=lambda check: check.value or 0.0, default=None)
    return () if worst is None else (worst,)


def _absurd(several_skids: tuple[TestSkid, ...], frictions: list[float]) -> tuple[Advice, ...]:
    advice: tuple[Advice, ...] = ()
    for index, (skid, mu) in enumerate(zip(several_skids, frictions, strict=True)):
        name = f"skids[{index}]: " if len(several_skids) > 1 else ""
        advice += grade_advice(skid.grade, name + "grade")
        advice += friction_advice(mu, name + "the friction found", "check speed, distance, grade and their units")
        if single(mu) and 0.0 < plain(mu) < LOWEST_FRICTION:
            message = worded(
                "{name}the friction found of {friction:2} is below that of ice", name=name, friction=(mu, Friction)
            )
            advice += (Advice("low-friction", message, remedy="check speed, distance, grade and their units"),)
    return advice


def _advice(spread: float | None, mean: float) -> tuple[Advice, ...]:
    if spread is None:
        text = "one test skid shows no scatter"
        remedy = "make at least two more test skids"
        return (Advice(code="one-test-skid", message=text, severity="note", remedy=remedy),)
    if not single(spread, mean) or plain(spread) <= 0.1 * plain(mean):
        return ()
    message = worded(
        "the test skids scatter by {spread:3}, more than a tenth of their mean of {mean:3}",
        spread=(spread, Friction),
        mean=(mean, Friction),
    )
    remedy = "look for the skid that does not belong, or state the range"
    return (Advice(code="test-skids-scatter", message=message, remedy=remedy),)
