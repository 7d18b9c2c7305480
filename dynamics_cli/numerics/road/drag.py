"""Drag factor of a road (deceleration over gravity), and limits of plausible values."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, multiply_add, sqrt
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import DragFactor, Friction, RoadSpeed, Slope
from dynamics_cli.records import Advice

# Above this the square of a grade leaves the range of doubles.
STEEPEST = 1e150
STEEPEST_ROAD = 0.3
HIGHEST_FRICTION = 1.5
FASTEST = 300.0 / 3.6


def level(grade: float) -> bool:
    """Whether this is a single grade of exactly zero, tracked or not: then nothing is rounded."""
    return single(grade) and plain(grade) == 0.0 and getattr(grade, "error", 0.0) == 0.0


def secant(grade: float) -> float:
    """1/cos θ = √(1 + G²) of a road whose grade is G = tan θ."""
    if level(grade):
        return 1.0
    require(absolute(grade) <= STEEPEST, "a grade of {grade} is too steep", code="grade", grade=(grade, Slope))
    return sqrt(1.0 + grade * grade)


def along_the_road(resistance: float, grade: float) -> float:
    """Drag factor (μ + G)/√(1 + G²) of a resistance μ per normal force on a grade G.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10; on a grade by Newton's second
    law.
    """
    return resistance + grade if level(grade) else (resistance + grade) / secant(grade)


def drag_along(friction: float, grade: float, braking: float) -> float:
    """Drag factor (ημ + G)/√(1 + G²), its numerator rounded once even where it nearly cancels.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10; on a grade by Newton's second
    law.
    """
    if level(grade):
        return braking * friction + grade
    return multiply_add(braking, friction, grade) / secant(grade)


def require_drag(drag: float, where_: str = "") -> float:
    """`drag`, refused unless it slows the vehicle down."""
    require(
        drag > 0.0,
        "{where}the drag factor of {drag} is not above zero: friction cannot hold the vehicle against this grade",
        code="no-drag",
        hint="uphill grades are positive; check the sign of grade, and friction and braking",
        where=where_,
        drag=(drag, DragFactor),
    )
    return drag


def drag_advice(friction: float, grade: float, braking: float, name: str = "") -> tuple[Advice, ...]:
    """Advice when friction or grade is implausible, and when drag is their small difference."""
    absurd = friction_advice(friction, name + "friction") + grade_advice(grade, name + "grade")
    if not single(friction, grade, braking) or not plain(grade) < 0.0:
        return absurd
    grip = plain(braking) * plain(friction)
    rest = plain(multiply_add(braking, friction, grade))
    if not 0.0 < rest < 0.2 * grip:
        return absurd
    return (
        *absurd,
        Advice(
            code="drag-by-difference",
            message=worded(
                "{name}friction of {grip} hardly exceeds the downhill grade of {grade}: an error of 1 % in friction "
                "becomes {percent} in the drag factor",
                name=name,
                grip=(grip, Friction),
                grade=(-plain(grade), Slope),
                percent=f"{grip / rest:.3g} %",
            ),
            severity="caution" if grip < 50.0 * rest else "serious",
            remedy="measure friction and grade together, as a deceleration on the same road",
        ),
    )


def friction_advice(friction: float, name: str = "friction", remedy: str = "write 0.7 or 70 %") -> tuple[Advice, ...]:
    """Advice when a coefficient of friction is higher than any tyre's."""
    if not single(friction) or not plain(friction) > HIGHEST_FRICTION:
        return ()
    message = worded(
        "{name} of {friction} is more than tyres reach on any road", name=name, friction=(friction, Friction)
    )
    return (Advice(code="high-friction", message=message, remedy=remedy),)


def grade_advice(grade: float, name: str = "grade") -> tuple[Advice, ...]:
    """Advice when a slope is steeper than any road."""
    if not single(grade) or not abs(plain(grade)) > STEEPEST_ROAD:
        return ()
    message = worded("{name} of {grade} is steeper than roads are", name=name, grade=(grade, Slope))
    return (Advice(code="steep-grade", message=message, remedy="write 3 % for three percent"),)


def speed_advice(speed: float, name: str, remedy: str) -> tuple[Advice, ...]:
    """Advice when a speed is beyond any vehicle's on a road: most often a wrong unit."""
    if not single(speed) or not plain(speed) > FASTEST:
        return ()
    message = worded("{name} of {speed:5} is beyond nearly all vehicles on roads", name=name, speed=(speed, RoadSpeed))
    return (Advice(code="high-speed", message=message, remedy=remedy),)
