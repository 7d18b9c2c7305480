"""Extremes over a grid: places from doubles, values from many digits.

K and the velocities of the contact are rounded once, from many digits, before they go over the grid. At the places of
the extremes and at the corners of the region the answers are calculated again in many digits; four times the error of
doubles there is taken as their error anywhere, by which another point may lie beyond the extreme.
"""

from decimal import Decimal, localcontext

from dynamics_cli.errors import DynamicsError
from dynamics_cli.impact.conventions import direction_of
from dynamics_cli.impact.planar.bodies import Solid, solid
from dynamics_cli.impact.planar.impact import meeting_of
from dynamics_cli.impact.planar.laws import Meeting, outcome
from dynamics_cli.impact.spatial.arithmetic import widened
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.exact.many_digits import CONTEXT, ManyDigits
from dynamics_cli.numerics.vectors import planar_cross as cross
from dynamics_cli.records import over_parts, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

    Values = dict[str, Any]

UNIT_ROUNDOFF = 2.0**-53
# The error of doubles at the extremes is at most this share of their error elsewhere.
MISSED = 4.0
# Numbers below this share of the largest are indistinguishable from zero.
SPARE = 1e-45
# Digits of which the terms of K at a very long lever may cancel most.
DIGITS = 240


class ExactContact:
    """The contact of an envelope in many digits."""

    __slots__ = ("bodies", "context", "inward", "meeting", "turns")

    def __init__(
        self, first: "Any", second: "Any", normal: float, contact_point: "Any", closing: "float | None", axes: "Any",
        gravity: float,
    ) -> None:  # fmt: skip
        self.context = CONTEXT.copy()
        self.context.prec = DIGITS
        with localcontext(self.context):
            numbers = widened(
                (first, second, normal, contact_point, closing, gravity), lambda number: ManyDigits(Decimal(number))
            )
            first, second, angle, point, speed, weight = numbers
            self.bodies = (
                solid(first, point, axes, weight, "the first body"),
                solid(second, point, axes, weight, "the second body"),
            )
            towards = direction_of(angle, axes)
            self.inward = -towards[0], -towards[1]
            self.meeting = meeting_of(*self.bodies, self.inward, speed, 0.0, 0.0, 1.0)
            self.turns = [_turn(body, self.inward) for body in self.bodies]

    def rounded(self) -> "tuple[Meeting, list[tuple[float, float] | None]]":
        """The same in doubles, every number rounded once; and the changes of spin per unit of impulse."""
        return _plain(self.meeting), [_plain(turn) for turn in self.turns]

    def values(self, mu: float, e: float, law: str) -> "Values | None":
        """Size of the impulse, energy lost and changes of spin at one point; None where the law has no answer."""
        with localcontext(self.context):
            friction, restitution = ManyDigits.inputs([mu, e])
            numbers = {**self.meeting.__dict__, "friction": friction, "restitution": restitution}
            try:
                solved = outcome(Meeting(**numbers), law)
            except (DynamicsError, ArithmeticError):
                return None
            if not solved.feasible or (law != "stronge" and solved.gains):
                return None
            pn, pt = solved.normal, solved.tangential
            quantities = {"size": sqrt(pn * pn + pt * pt), "lost": solved.lost}
            for name, turn in zip(("first", "second"), self.turns, strict=True):
                if turn is not None:
                    quantities[name] = turn[0] * pn + turn[1] * pt
            return quantities


def _plain(tree: "Any") -> "Any":
    return tree.value if type(tree) is ManyDigits else over_parts(tree, _plain)


def _turn(body: Solid, inward: "Any") -> "Any":
    """Change of spin per unit of p_n and of p_t, as it acts on this body when it acts on the first."""
    if body.inertia is None:
        return None
    across = -inward[1], inward[0]
    return cross(body.lever, inward) / body.inertia, cross(body.lever, across) / body.inertia


@record
class Extreme:
    """The extreme of one quantity: its value, a bound on its error, its place (μ, e)."""

    value: float
    error: float
    place: tuple[float, float]


def extremes(
    exact: ExactContact, law: str, places: "Iterable[tuple[float, float]]", doubles: "Callable[[float, float], Values]"
) -> dict[str, tuple[Extreme, Extreme]]:
    """Least and greatest of every quantity, of the values at these places in many digits."""
    known = {place: values for place in places if (values := exact.values(*place, law)) is not None}
    near = {place: doubles(*place) for place in known}
    results = {}
    with localcontext(exact.context):
        for name in next(iter(known.values())):
            numbers = {place: values[name].exact for place, values in sorted(known.items())}
            missed = MISSED * max(abs(float(number - Decimal(near[place][name]))) for place, number in numbers.items())
            # remainder of a difference that is zero
            nothing = SPARE * float(max(map(abs, numbers.values())))
            ends = [pick(numbers, key=numbers.__getitem__) for pick in (min, max)]
            low, high = (_extreme(numbers[place], missed, nothing, place) for place in ends)
            results[name] = low, high
    return results


def _extreme(number: Decimal, missed: float, nothing: float, place: tuple[float, float]) -> Extreme:
    value = float(number)
    if abs(value) <= nothing:
        return Extreme(0.0, missed + nothing, place)
    return Extreme(value, missed + 2.0 * UNIT_ROUNDOFF * abs(value), place)
