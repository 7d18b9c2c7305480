"""The radius of a yaw mark from surveyed points: fitted circle, its deviation, and whether the mark tightens."""

from dynamics_cli.errors import judge, require, worded
from dynamics_cli.numerics.elementary import hypot, only_in_doubles, over_array
from dynamics_cli.numerics.exact.typed import TypedNumber
from dynamics_cli.numerics.fitting.circle import Circle, circle_through, settled_radius
from dynamics_cli.numerics.number import is_array, is_tracked, plain
from dynamics_cli.quantities import Annotated, Distance, InputFile, Length, SurveyCoordinate
from dynamics_cli.records import Advice, record
from dynamics_cli.skid.curved.file import read_points

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# A radius known no better, or a height of the arc that may be scatter, decides nothing.
MOST_OF_RADIUS = 0.25
LEAST_SAGITTA = 3.0
ROUNDING = 2.0**-53


@record
class Points:
    """A mark surveyed point by point."""

    points: Annotated[
        tuple[SurveyCoordinate, ...],
        "Points along the mark, x1, y1, x2, y2, … in order of travel, e.g. 0, 0, 10, 4.3, 20, 7.53, 30, 9.65 m [m].",
    ]
    point_deviation: Annotated[
        Distance | None, "Standard deviation of a point across the mark; from the scatter unless given, e.g. 3 cm [m]."
    ] = None


@record
class SurveyFile:
    """A mark surveyed point by point, in a file."""

    survey: Annotated[
        InputFile, "CSV with x[m],y[m] or easting[ft],northing[ft] of points along the mark, e.g. survey.csv."
    ]
    point_deviation: Annotated[
        Distance | None, "Standard deviation of a point across the mark; from the scatter unless given, e.g. 3 cm [m]."
    ] = None

    @property
    def points(self) -> tuple[float, ...]:
        """The points, as those of a list."""
        return read_points(self.survey)


@record
class Survey:
    """Result of the survey: the radius, its deviation, and those of both halves."""

    radius: Annotated[Distance, "Radius of the circle nearest to the points [m]."]
    deviation: Annotated[Distance | None, "Its standard deviation from the points, where they show it [m]."]
    residual: Annotated[Distance | None, "Scatter of the points about the circle; needs four [m]."]
    sagitta: Annotated[Distance | None, "Height of the arc over the chord of its ends [m]."]
    centre: Annotated[tuple[Length, Length] | None, "Centre of the circle [m]."]
    first_half: Annotated[Distance | None, "Radius of the first half of the points; needs five [m]."]
    second_half: Annotated[Distance | None, "Radius of their second half; needs five [m]."]
    advice: tuple[Advice, ...] = ()


def surveyed(path: Points | SurveyFile) -> Survey:
    """The circle of least squares through the points, refused where they do not decide its radius."""
    points = path.points
    count = len(points) // 2
    require(
        len(points) % 2 == 0 and count >= 3,
        "{given} numbers are not three points or more: each has an x and a y",
        given=len(points), code="too-few-points", hint="write x1, y1, x2, y2, x3, y3, … with the unit at the end",
    )  # fmt: skip
    if any(is_array(number) for number in points):
        radius = over_array(_radius_alone, *points)
        return Survey(radius, None, None, None, None, None, None)
    only_in_doubles(*points)
    origin, x, y = _from_first(points)
    circle = circle_through([plain(a) for a in x], [plain(b) for b in y])
    if circle is None:
        _refuse_line(count)
        raise AssertionError
    stated = None if path.point_deviation is None else plain(path.point_deviation)
    sigma = max((part for part in (stated, circle.residual) if part is not None), default=None)
    _judge(circle, sigma)
    radius = settled_radius(x, y, circle)
    halves = _halves([plain(a) for a in x], [plain(b) for b in y])
    return Survey(
        radius=radius,
        deviation=None if sigma is None else circle.factor * sigma,
        residual=circle.residual,
        sagitta=circle.sagitta,
        centre=(origin[0] + circle.x, origin[1] + circle.y),
        first_half=halves[0].radius if halves else None,
        second_half=halves[1].radius if halves else None,
        advice=_advice(sigma, halves),
    )


def _from_first(points: "tuple[Any, ...]") -> "tuple[tuple[float, float], list[Any], list[Any]]":
    """The first point, and all from it: differences of large coordinates are taken in the decimals as typed."""
    return (plain(points[0]), plain(points[1])), _less_first(points[0::2]), _less_first(points[1::2])


def _less_first(part: "tuple[Any, ...]") -> "list[Any]":
    """Numbers less their first."""
    less = [number - part[0] for number in part]
    if not all(isinstance(plain(number), TypedNumber) for number in part):
        return less
    ratios = [plain(number).as_integer_ratio() for number in part]
    top, bottom = ratios[0]
    exact = [(a * bottom - top * b) / (b * bottom) for a, b in ratios]
    return [
        type(offset)(number, ROUNDING * abs(number), offset.slopes) if is_tracked(offset) else number
        for number, offset in zip(exact, less, strict=True)
    ]


def _radius_alone(*numbers: float) -> float:
    """The radius of one of many sets of points; of points on a line, one of a circle without end."""
    _, x, y = _from_first(numbers)
    circle = circle_through(x, y)
    return float(settled_radius(x, y, circle)) if circle is not None else 1e12


def _refuse_line(count: int) -> None:
    require(
        False, "the {count} points lie on a line or at one place: no circle goes through them",
        count=count, code="no-circle", hint="check the order x1, y1, x2, y2, …",
    )  # fmt: skip


def _judge(circle: Circle, sigma: "float | None") -> None:
    """Refuse, by judgement, a radius that the scatter of the points does not determine."""
    if sigma is None:
        return
    spread = circle.factor * sigma
    judge(
        spread <= MOST_OF_RADIUS * circle.radius,
        "the points do not decide the radius: {radius} with a standard deviation of {spread}",
        radius=(circle.radius, Distance), spread=(spread, Distance), results=("speed",),
        hint="survey a longer part of the mark, or more points",
    )  # fmt: skip
    judge(
        circle.sagitta >= LEAST_SAGITTA * sigma,
        "the mark is bent by {sagitta} only, and its points scatter by {sigma}",
        sagitta=(circle.sagitta, Distance), sigma=(sigma, Distance), results=("speed",),
        hint="survey a longer part of the mark",
    )  # fmt: skip


def _halves(x: "list[float]", y: "list[float]") -> "tuple[Circle, Circle] | None":
    """Circles through the first and the second half of the points, which share the middle one."""
    count = len(x)
    half = (count + 1) // 2
    if half < 3:
        return None
    first, second = circle_through(x[:half], y[:half]), circle_through(x[-half:], y[-half:])
    return (first, second) if first is not None and second is not None else None


def _advice(sigma: "float | None", halves: "tuple[Circle, Circle] | None") -> tuple[Advice, ...]:
    if sigma is None:
        message = "three points always lie on a circle: they do not show how well the radius is known"
        return (Advice(code="no-scatter", message=message, remedy="give --point-deviation, or a fourth point"),)
    if halves is None:
        return ()
    first, second = halves
    spread = hypot(first.factor, second.factor) * sigma
    rise = second.radius - first.radius
    if rise <= spread:
        return ()
    message = worded(
        "the mark opens: {first:4} in its first half, {second:4} in its second (σ of the difference {spread:2}); the "
        "mark of a vehicle at its limit tightens as it slows",
        first=(first.radius, Distance), second=(second.radius, Distance), spread=(spread, Distance),
    )  # fmt: skip
    return (
        Advice(
            code="opening-mark", message=message, remedy="not a yaw at the limit, or driven: look at the striations"
        ),
    )


def yaw_scatter(speed: float, radius: float, survey: "Survey | None") -> "float | None":
    """Standard deviation of a critical speed by its points: half the relative one of the path's radius."""
    if survey is None or survey.deviation is None:
        return None
    # the fit's deviation is known to few digits, so this carries no bound
    return plain(speed) * (0.5 * survey.deviation / plain(radius))
