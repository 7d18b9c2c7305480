"""Polynomial and spline segments fitted to their neighbours: implicit boundary conditions of a program."""

from dynamics_cli.cam.laws.normalised import Law
from dynamics_cli.cam.laws.polynomials import polynomial, spline
from dynamics_cli.cam.laws.rounded_points import ANGLES, LENGTHS, decimal_step
from dynamics_cli.errors import require
from dynamics_cli.quantities import Angle

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.cam.program.segments import Step

DEGREES = (3, 5, 7, 9)


def fitted(
    index: int,
    steps: "Sequence[Step]",
    levels: "Sequence[float]",
    spans: "Sequence[float]",
    laws: "Sequence[Law | None]",
    width: float,
) -> "tuple[Law, float]":
    """Give the law of a polynomial or spline segment, and the lift that corresponds to its unit.

    `index`: which segment; `steps`: all segments; `levels`: lift at every joint; `spans`: spans of all segments [rad];
    `laws`: laws of the segments that do not depend on their neighbours; `width`: span of this one [rad]. Returns the
    law and its scale. Raises InadmissibleError when the degree is not 3, 5, 7 or 9, or a spline's points are outside
    its segment.

    A derivative that is neither given nor set by an independent neighbour is zero.
    """
    segment = steps[index].segment
    scale = levels[index + 1] - levels[index]
    count = len(steps)
    before = _state((index - 1) % count, 1.0, steps, levels, spans, laws)
    after = _state((index + 1) % count, 0.0, steps, levels, spans, laws)
    for order, start, end in (
        (1, segment.start_velocity, segment.end_velocity),
        (2, segment.start_acceleration, segment.end_acceleration),
    ):
        before[order] = before[order] if start is None else start
        after[order] = after[order] if end is None else end
    factors = [width**order / scale for order in range(5)]
    if segment.law == "spline":
        return _spline(segment, width, scale, before[1] * factors[1], after[1] * factors[1], index + 1), scale
    degree = 5 if segment.degree is None else segment.degree
    require(
        degree in DEGREES,
        "segment {number}: degree {degree}; wanted 3, 5, 7 or 9",
        number=index + 1,
        degree=degree,
        code="degree",
        hint="as many conditions at each end: velocity (3), acceleration (5), jerk (7), its rate (9)",
    )
    orders = range(1, (degree + 1) // 2)
    conditions = [(0.0, 0, 0.0), (1.0, 0, 1.0)]
    conditions += [(0.0, order, before[order] * factors[order]) for order in orders]
    conditions += [(1.0, order, after[order] * factors[order]) for order in orders]
    return polynomial(conditions), scale


def _state(
    index: int,
    x: float,
    steps: "Sequence[Step]",
    levels: "Sequence[float]",
    spans: "Sequence[float]",
    laws: "Sequence[Law | None]",
) -> "list[float]":
    """Derivatives per radian, orders 0 to 4, that a neighbour has at its end x."""
    law = laws[index]
    if law is None:
        return [0.0] * 5
    rise = levels[index + 1] - levels[index]
    return [rise * f / spans[index] ** order for order, f in enumerate(law.at(x, 4))]


def _spline(segment: "object", width: float, scale: float, first: float, last: float, number: int) -> Law:
    points = [(0.0, 0.0)]
    for point in segment.points:  # type: ignore[attr-defined]
        require(
            0.0 < point.at < width,
            "segment {number}: a point at {at} is outside its span of {width}",
            number=number,
            at=(point.at, Angle),
            width=(width, Angle),
            code="points",
        )
        points.append((point.at / width, point.lift / scale))
    knots = segment.points  # type: ignore[attr-defined]
    lifts = decimal_step([point.lift for point in knots], (*LENGTHS, *ANGLES[1:]))
    steps = decimal_step([point.at for point in knots], ANGLES) / width, lifts / abs(scale)
    return spline([*points, (1.0, 1.0)], first, last, steps)
