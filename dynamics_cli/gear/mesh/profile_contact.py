"""Two exact profiles turned against each other: contact, transmission error and clearances.

The frame: gear 1 at the origin, gear 2 at (a, 0); external gears are side by side, an internal gear surrounds the
other. Everything is calculated from the profiles point by point, not from the formulas of the pair.
"""

from dynamics_cli.errors import require
from dynamics_cli.gear.single.flanks import ToothForm
from dynamics_cli.numerics.elementary import absolute, acos, atan2, pi_beside, sqrt
from dynamics_cli.quantities import Annotated, Size
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]


@record
class Path:
    """The line of action, from gear 1's base circle: lengths along it."""

    start: Annotated[float, "Where contact begins, as the profiles allow [m]."]
    end: Annotated[float, "Where it ends [m]."]
    tip_start: Annotated[float, "Where the tip of gear 2 would begin it [m]."]
    tip_end: Annotated[float, "Where the tip of gear 1 would end it [m]."]
    total: Annotated[float, "Distance between the tangent points of the base circles [m]."]
    pressure_angle: Annotated[float, "Working pressure angle [rad]."]
    pitch: Annotated[float, "Base pitch [m]."]


def path_of_contact(first: ToothForm, second: ToothForm, distance: float) -> Path:
    """The stretch of the line of action where both flanks are involutes; refuses an open mesh."""
    sum_of_bases = first.base - second.base if second.internal else first.base + second.base
    reach = absolute(sum_of_bases)
    require(
        distance > reach,
        "a centre distance of {distance:9} is less than the base circles need, {reach:9}",
        distance=(distance, Size),
        reach=(reach, Size),
        code="centre-distance",
    )
    total = sqrt((distance - reach) * (distance + reach))
    around = 2.0 * pi_beside(first.base)
    pitch = around * first.base / first.teeth
    other = around * second.base / second.teeth
    require(
        absolute(pitch - other) <= 1e-12 * pitch,
        "the base pitches differ: {pitch:12} and {other:12}",
        pitch=(pitch, Size),
        other=(other, Size),
        code="base-pitch",
        hint="both gears need one module and one pressure angle",
    )
    tip_end, form_start = first.length(first.tip), _form_length(first)
    if second.internal:
        tip_start = total_of_internal(second.length(second.tip), total)
        form_end = total_of_internal(second.length(second.form), total)
    else:
        tip_start, form_end = total - second.length(second.tip), total - _form_length(second)
    return Path(
        start=max(tip_start, form_start),
        end=min(tip_end, form_end),
        tip_start=tip_start,
        tip_end=tip_end,
        total=total,
        pressure_angle=atan2(total, reach),
        pitch=pitch,
    )


def remedy_of_open_mesh(starts_at_form: bool, ends_at_form: bool) -> str:
    """The remedy for an open mesh: farther apart where roots leave no involute, nearer where tips fall short."""
    if starts_at_form and ends_at_form:
        return "raise the centre distance or the profile shifts: the roots leave no involutes that can meet"
    if starts_at_form or ends_at_form:
        which = "first" if starts_at_form else "second"
        return f"raise the profile shift of the {which} gear, or lengthen its tips: its flank ends below its root's end"
    return "lower the centre distance, or lengthen the tips"


def total_of_internal(length: float, total: float) -> float:
    """A length from the internal gear's tangent point as one from gear 1's: the two lie on one side."""
    return length - total


def _form_length(form: ToothForm) -> float:
    return form.base * form.junction.roll if form.junction is not None else form.length(form.form)


def transmission_error(
    first: ToothForm, second: ToothForm, distance: float, path: Path, count: int
) -> "tuple[Array, Array]":
    """Lengths along the path of contact, and gear 2's angle there less the ratio times gear 1's.

    At each point gear 1 is turned until its flank passes through it, then gear 2 is. Only the two profiles are used, no
    theory of involutes.
    """
    import numpy as np

    lengths = np.linspace(path.start, path.end, count)
    alpha = path.pressure_angle
    x = first.base * np.cos(alpha) + lengths * np.sin(alpha)
    y = lengths * np.cos(alpha) - first.base * np.sin(alpha)
    first_angles = np.arctan2(y, x) - _half_angles(first, np.hypot(x, y))
    if second.internal:
        x2, y2, ratio = x + distance, y, first.teeth / second.teeth
    else:
        x2, y2, ratio = distance - x, -y, -first.teeth / second.teeth
    second_angles = np.arctan2(y2, x2) - _half_angles(second, np.hypot(x2, y2))
    error = second_angles - ratio * first_angles
    return lengths, error - np.median(error)


def _half_angles(form: ToothForm, radius: "Array") -> "Array":
    """Half angle between the two involutes at each radius."""
    import numpy as np

    ratio = radius / form.base
    roll = np.sqrt(np.maximum((ratio - 1.0) * (ratio + 1.0), 0.0))
    return form.half_base - (roll - np.arctan(roll))


def half_play(first: ToothForm, second: ToothForm, path: Path) -> float:
    """Half the angle gear 2 can be turned by while gear 1 stands; negative when the teeth jam."""
    length = first.base * (path.pressure_angle + first.half_base)
    if second.internal:
        return path.pressure_angle + second.half_base - (length + path.total) / second.base
    return (
        (path.total - length) / second.base - path.pressure_angle - second.half_base + pi_beside(length) / second.teeth
    )


def tips_pass(first: ToothForm, second: ToothForm, distance: float) -> float:
    """Distance of a pinion's tip ahead of an internal gear's tip where their tip circles cross, along that circle.

    Negative when it cuts into the tooth that it should have left; infinite when the tip circles do not cross.
    """
    pinion_cosine = (second.tip**2 - first.tip**2 - distance**2) / (2.0 * first.tip * distance)
    ring_cosine = (second.tip**2 - first.tip**2 + distance**2) / (2.0 * second.tip * distance)
    if not second.internal or absolute(pinion_cosine) >= 1.0 or absolute(ring_cosine) >= 1.0:
        return float("inf")
    # the corners' angles from the line of centres, with tooth and space turned back onto it
    pinion = acos(pinion_cosine) - first.half_angle(first.roll(first.tip))
    ring = acos(ring_cosine) - second.half_angle(second.roll(second.tip))
    return second.tip * (pinion * first.teeth / second.teeth - ring)
