"""The task `friction`: whether a pushed block on an incline holds, slides or tips."""

from dynamics_cli.errors import MissingError, require
from dynamics_cli.numerics.elementary import absolute, cos, sin
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
    Text,
)
from dynamics_cli.records import Advice, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    Limit = tuple[float, str]

QUARTER = 1.5707963267948966
SIZES = ("width", "centre_height", "push_height")
NONE_HOLDS = "no push along the incline holds this block: it {low} under a small one and {high} under a large one"


@record
class FrictionAnswer:
    """Whether a block holds, and the pushes that it withstands."""

    verdict: Annotated[Text, "Holds, slides or tips, by whichever limit comes first."]
    margin: Annotated[Force, "How much the push may change; negative if the block does not hold [N]."]
    least_push: Annotated[Force | None, "Minimum push along the incline that holds it, uphill positive [N]."]
    below: Annotated[Text | None, "What the block does under a smaller push."]
    largest_push: Annotated[Force | None, "Maximum push that holds it [N]."]
    above: Annotated[Text | None, "What the block does under a larger push."]
    normal_force: Annotated[Force, "Normal force of the incline [N]."]
    friction_force: Annotated[Force, "Friction force needed to hold, uphill positive [N]."]
    needed_friction: Annotated[Friction, "Coefficient of friction needed to hold [-]."]
    pressure_point: Annotated[
        Length | None, "Where the normal force must act, from the middle of the base, uphill positive [m]."
    ]
    advice: tuple[Advice, ...] = ()


def friction(
    *,
    mass: Annotated[Mass, "Mass of the block, e.g. 80 kg."],
    angle: Annotated[Angle, "Angle of the incline, e.g. 15 deg."] = 0.0,
    friction: Annotated[Friction, "Coefficient of friction, e.g. 0.4."],
    width: Annotated[
        Distance | None, "Length of its base along the incline, to see whether it tips, e.g. 0.5 m."
    ] = None,
    centre_height: Annotated[Distance | None, "Height of its mass centre above the base, e.g. 0.6 m."] = None,
    push: Annotated[Force, "Push along the incline, uphill positive, e.g. 200 N."] = 0.0,
    push_height: Annotated[Distance | None, "Height of the push above the base, e.g. 1 m."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> FrictionAnswer:
    """A block on an incline, pushed at a height: whether it holds, slides or tips, and the pushes that it withstands.

    Equation
    --------
    N = W·cos α, slides at P = W·(sin α ± μ·cos α), tips at P = W·(c·sin α ± b/2·cos α)/h.

    Returns
    -------
    FrictionAnswer
        The verdict, its margin, and the minimum and the maximum push.

    Raises
    ------
    InadmissibleError
        When mass, base or height of the mass centre is zero, or the angle is not between −90 and 90 degrees.
    UsageError
        When of base, mass centre and height of the push some are given and some not.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 6.7.

    Examples
    --------
    >>> call = {"mass": 10.0, "friction": 0.5, "width": 0.2, "centre_height": 0.4, "push_height": 0.8}
    >>> friction(push=20.0, **call).verdict
    'tips uphill'
    """
    block = (width, centre_height, push_height)
    if any(size is None for size in block) and any(size is not None for size in block):
        missing = [name for name, size in zip(SIZES, block, strict=True) if size is None]
        raise MissingError("whether it tips depends on base, mass centre and push together", [tuple(missing)])
    for value, name in ((mass, "mass"), (width, "base"), (centre_height, "height of the mass centre")):
        require(value is None or plain(value) > 0.0, "the {name} is zero", name=name, hint="give a value above zero")
    require(plain(absolute(angle)) < QUARTER, "an incline cannot be at {angle}", angle=(angle, Angle), code="angle",
            hint="give an angle between -90 and 90 deg")  # fmt: skip
    weight = mass * gravity
    normal, down = weight * cos(angle), weight * sin(angle)
    lows: list[Limit] = [(down - friction * normal, "slides down")]
    highs: list[Limit] = [(down + friction * normal, "slides up")]
    point, topples = None, False
    if width is not None and centre_height is not None and push_height is not None:
        overturning, restoring = centre_height * down, 0.5 * width * normal
        if plain(push_height) > 0.0:
            lows.append(((overturning - restoring) / push_height, "tips downhill"))
            highs.append(((overturning + restoring) / push_height, "tips uphill"))
        point = (push_height * push - overturning) / normal
        topples = plain(push_height) == 0.0 and abs(plain(point)) > 0.5 * plain(width)
    low, high = max(lows, key=_value), min(highs, key=_value)
    exists = plain(low[0]) <= plain(high[0]) and not topples
    margin = min(push - low[0], high[0] - push, key=plain)
    if topples and point is not None:
        verdict = "tips uphill" if plain(point) > 0.0 else "tips downhill"
    elif plain(push) < plain(low[0]):
        verdict = low[1]
    elif plain(push) > plain(high[0]):
        verdict = high[1]
    else:
        verdict = "holds"
    needed = down - push
    return FrictionAnswer(
        verdict=verdict,
        margin=margin,
        least_push=low[0] if exists else None,
        below=low[1] if exists else None,
        largest_push=high[0] if exists else None,
        above=high[1] if exists else None,
        normal_force=normal,
        friction_force=needed,
        needed_friction=absolute(needed) / normal,
        pressure_point=point,
        advice=() if exists else (Advice("none-holds", _none(low[1], high[1], topples=topples), severity="caution"),),
    )


def _value(limit: "Limit") -> float:
    return plain(limit[0])


def _none(low: str, high: str, *, topples: bool) -> str:
    return "no push at this height keeps the block from tipping" if topples else NONE_HOLDS.format(low=low, high=high)
