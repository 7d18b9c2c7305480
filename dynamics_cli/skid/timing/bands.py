"""Bands about the curves of uncertain parties: what most fair cases of the inputs do at every time."""

from dynamics_cli.errors import DynamicsError
from dynamics_cli.pictures import Curve
from dynamics_cli.quantities import STANDARD_GRAVITY
from dynamics_cli.skid.timing.courses import Course
from dynamics_cli.skid.timing.meet import Party, course_to_impact, motion_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    from dynamics_cli.pictures import Spreads

    States = Callable[[float], tuple[float, float]]


def bands_of(
    spreads: "Spreads | None", times: "list[float]", states_of: "Callable[[Mapping[str, Any]], States]", role: int
) -> "tuple[list[Any], list[Any]]":
    """The bands that hold place and speed of a party over time; none of what does not vary."""
    bands: tuple[list[Any], list[Any]] = ([], [])
    cases = []
    for case in () if spreads is None else spreads.cases():
        try:
            cases.append([*map(states_of(case), times)])
        except DynamicsError:  # as the answer leaves it out
            continue
    if spreads is None or len(cases) < 2:
        return bands
    tail = 0.5 * (1.0 - spreads.coverage) * (len(cases) - 1)
    for which, band in enumerate(bands):
        ordered = [sorted(case[step][which] for case in cases) for step in range(len(times))]
        low, high = ([_between(values, at) for values in ordered] for at in (tail, len(cases) - 1 - tail))
        if any(a < b for a, b in zip(low, high, strict=True)):
            band.append(Curve([*times, *reversed(times)], [*high, *reversed(low)], style="fill", role=role))
    return bands


def party_in(name: str) -> "Callable[[Mapping[str, Any]], States]":
    """Distance left and speed of one of two parties over the time left."""
    return lambda case: before_impact(case[name], case.get("gravity", STANDARD_GRAVITY))


def before_impact(party: Party, gravity: float) -> "States":
    """Distance left and speed of a party over the time left."""
    course = course_to_impact(motion_of(party, gravity, ""))

    def state(left: float) -> "tuple[float, float]":
        way, speed, _ = course.at(-left)
        return -way, speed

    return state


def _between(values: "list[float]", at: float) -> float:
    """The value at a place between two of a list."""
    below = min(int(at), len(values) - 2)
    return values[below] + (at - below) * (values[below + 1] - values[below])


def in_lane(name: str) -> "Callable[[Mapping[str, Any]], States]":
    """Place and speed of one of two parties in a lane over time."""

    def states_of(case: "Mapping[str, Any]") -> "States":
        ahead = case["gap"] if name == "leader" else 0.0
        course = Course(motion_of(case[name], case.get("gravity", STANDARD_GRAVITY), ""), 0.0, ahead)
        return lambda time: course.at(time)[:2]

    return states_of


def held(spreads: "Spreads | None", what: str = "bands") -> str:
    """What the bands of a picture are, for below its title."""
    return "" if spreads is None else f"{what} hold {100.0 * spreads.coverage:.4g} %"
