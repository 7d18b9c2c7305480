"""Verdicts of the links of a crash, and the weakest of them."""

from math import inf

from dynamics_cli.impact.crash.results import LinkVerdict
from dynamics_cli.impact.reconstruction.momentum_records import MomentumResult
from dynamics_cli.impact.reconstruction.momentum_verdict import CAUTION, GOOD, LEVELS
from dynamics_cli.numerics.elementary import absolute, minimum, summed, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.road.drag import secant

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.impact.crash.ways import After, Before
    from dynamics_cli.numerics.road.leg import Leg
    from dynamics_cli.numerics.road.phases import Phase

# Friction is known to a tenth if measured on the road; never to three hundredths.
GOOD_FRICTION, CAUTION_FRICTION = 0.1, 0.03
# If this relative error of friction does not change a speed by a tenth, no error of friction matters.
NO_MATTER = 1.0


def verdicts(
    names: "list[str]", slides: "list[After]", ways: "list[Before]", meeting: MomentumResult
) -> "tuple[LinkVerdict, ...]":
    """The verdict of every link, in the order of time from the last."""
    links: list[LinkVerdict] = []
    for name, slide in zip(names, slides, strict=True):
        if slide.surfaces:
            assert slide.speed is not None
            grip = slide.gravity * summed(
                [one.braking * one.friction * one.distance / secant(one.grade) for one in slide.grounds]
            )
            links.append(_by_friction(f"slide of {name}", slide.speed, grip))
        elif slide.spinning is not None:
            links.append(_by_friction(f"slide of {name}", slide.spinning.speed, slide.gravity * slide.work))
    for name, body in zip(names, (meeting.first, meeting.second), strict=True):
        if body.determined is not None:
            verdict = body.determined
            links.append(
                LinkVerdict(
                    f"impact, {name}",
                    verdict.verdict,
                    _called(verdict.worst_heading or "", names),
                    None,
                    verdict.heading_tolerance,
                    verdict.per_degree,
                )
            )
    for name, way in zip(names, ways, strict=True):
        braked = [(leg, phase) for leg, phase in zip(way.legs, way.phases, strict=True) if phase.friction is not None]
        if braked:
            grip = summed([_grip(leg, phase, way.gravity) for leg, phase in braked])
            links.append(_by_friction(f"braking of {name}", way.start_speed, grip))
    return tuple(links)


def _called(address: "Any", names: "list[str]") -> str:
    """A heading by the vehicle's name: "Opel approach"; of arrays as it is."""
    side, _, word = str(address).partition(".")
    if side not in ("first", "second"):
        return str(address)
    return f"{names[side == 'second']} {word.removesuffix('_heading').replace('_', ' ')}"


def _grip(leg: "Leg", phase: "Phase", gravity: float) -> float:
    """Half the increase of the squared speed at the start, per relative increase of friction."""
    force = gravity * phase.braking * phase.friction / secant(phase.grade)  # type: ignore[operator]
    if leg.kind == "build-up":
        return 0.5 * force * leg.duration * leg.start
    return force * (leg.distance if phase.duration is None else leg.duration * leg.start)


def _by_friction(link: str, speed: float, grip: float) -> LinkVerdict:
    """A link whose speed v follows from v² = … + 2 grip, the grip in proportion to friction."""
    tenth = 0.1 * speed * speed
    moved = absolute(grip) > 0.0
    tolerance = where(moved, minimum(tenth / where(moved, absolute(grip), 1.0), NO_MATTER), NO_MATTER)
    number = plain(tolerance)
    level = where(number >= GOOD_FRICTION, LEVELS[2], where(number >= CAUTION_FRICTION, LEVELS[1], LEVELS[0]))  # type: ignore[arg-type]
    return LinkVerdict(link, level, "friction", tolerance, None)  # type: ignore[arg-type]


def weakest(links: "tuple[LinkVerdict, ...]") -> str:
    """The link with the smallest tolerance relative to the accuracy of its input; empty for arrays."""
    if not links or not all(single(one.friction, one.heading) for one in links):
        return ""

    def margin(one: LinkVerdict) -> float:
        if one.heading is not None:
            angle: float = plain(one.heading)
            return angle / (GOOD if angle >= CAUTION else CAUTION)
        if one.friction is None:
            return inf  # no heading affects it
        return plain(one.friction) / GOOD_FRICTION

    return str(min(links, key=margin).link)
