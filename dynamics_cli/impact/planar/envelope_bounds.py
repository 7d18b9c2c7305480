"""Extremes over a grid: places from doubles, values from 60 digits.

K and the velocities of the contact are rounded once, from 60 digits, before they go over the grid. At the places of
the extremes and at the corners of the region the answers are calculated again in 60 digits; four times the error of
doubles there is taken as their error anywhere. Points of the grid that come as near to an extreme are calculated
in 60 digits too, unless they are many: then the error of doubles stays in the bound. Where digits cancel, as between
the terms of K at a very long lever, as many more are used.
"""

from decimal import Decimal, localcontext

from dynamics_cli.errors import DynamicsError
from dynamics_cli.impact.conventions import direction_of
from dynamics_cli.impact.planar.bodies import Solid, solid
from dynamics_cli.impact.planar.impact import meeting_of
from dynamics_cli.impact.planar.laws import Meeting, outcome
from dynamics_cli.impact.planar.path import Mobility
from dynamics_cli.impact.spatial.arithmetic import widened
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.numerics.exact.many_digits import CONTEXT, DIGITS, ManyDigits
from dynamics_cli.numerics.vectors import planar_cross as cross

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

    Values = dict[str, Any]

UNIT_ROUNDOFF = 2.0**-53
# The error of doubles at the extremes is at most this share of their error elsewhere.
MISSED = 4.0
# Numbers below this share of the largest are indistinguishable from zero in 60 digits.
SPARE = 1e-45
# Digits that may cancel before more are used.
GUARDS = 8


def _many(number: float) -> ManyDigits:
    return ManyDigits(Decimal(number))


class ExactContact:
    """The contact of an envelope in 60 digits, plus those that cancel."""

    __slots__ = ("bodies", "context", "inward", "meeting", "turns")

    def __init__(
        self, first: "Any", second: "Any", normal: float, contact_point: "Any", closing: "float | None", axes: "Any",
        gravity: float,
    ) -> None:  # fmt: skip
        numbers = (first, second, normal, contact_point, closing, gravity)
        self.context = CONTEXT
        self._meet(numbers, axes)
        digits = DIGITS + self._lost()
        if digits > DIGITS + GUARDS:
            self.context = CONTEXT.copy()
            self.context.prec = digits
            self._meet(numbers, axes)

    def _meet(self, numbers: "Any", axes: "Any") -> None:
        with localcontext(self.context):
            first, second, angle, point, speed, weight = widened(numbers, _many)
            self.bodies = (
                solid(first, point, axes, weight, "the first body"),
                solid(second, point, axes, weight, "the second body"),
            )
            towards = direction_of(angle, axes)
            self.inward = -towards[0], -towards[1]
            self.meeting = meeting_of(*self.bodies, self.inward, speed, 0.0, 0.0, 1.0)
            self.turns = [_turn(body, self.inward) for body in self.bodies]

    def _lost(self) -> int:
        """Digits that cancel: in k_t k_n − k_x² where a lever is long, and between velocities of unlike sizes."""
        k = self.meeting.mobility
        parts = [self.meeting.slip, self.meeting.approach]
        for body in self.bodies:
            parts += [*body.velocity, *(body.spin * part for part in body.lever)]
        sizes = [_exponent(part) for part in parts if part]
        return _exponent(k.tangential) + _exponent(k.normal) - _exponent(k.determinant) + max(sizes) - min(sizes)

    def rounded(self) -> Meeting:
        """The same in doubles, every number rounded once."""
        parts = dict(self.meeting.__dict__)
        k = parts.pop("mobility")
        mobility = Mobility(**{name: _plain(part) for name, part in k.__dict__.items()})
        along, across = map(_plain, parts.pop("arms"))
        return Meeting(mobility=mobility, arms=(along, across), **{name: _plain(part) for name, part in parts.items()})

    def rounded_turns(self) -> "list[tuple[float, float] | None]":
        """Changes of spin per unit of impulse in doubles."""
        return [None if turn is None else (_plain(turn[0]), _plain(turn[1])) for turn in self.turns]

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


def _exponent(number: "Any") -> int:
    return Decimal(getattr(number, "exact", number)).adjusted()


def _plain(number: "Any") -> float:
    return number.value if type(number) is ManyDigits else float(number)


def _turn(body: Solid, inward: "Any") -> "Any":
    """Change of spin per unit of p_n and of p_t, as it acts on this body when it acts on the first."""
    if body.inertia is None:
        return None
    across = -inward[1], inward[0]
    return cross(body.lever, inward) / body.inertia, cross(body.lever, across) / body.inertia


class Extreme:
    """The extreme of one quantity: its value, a bound on its error, its place (μ, e)."""

    __slots__ = ("error", "place", "value")

    def __init__(self, value: float, error: float, place: tuple[float, float]) -> None:
        self.value = value
        self.error = error + 2.0 * UNIT_ROUNDOFF * abs(value)
        self.place = place


class Extremes:
    """Least and greatest of every quantity, of the places known in 60 digits."""

    def __init__(self, exact: ExactContact, law: str, doubles: "Callable[[float, float], Values]") -> None:
        self.exact = exact
        self.law = law
        self.doubles = doubles
        self.known: dict[tuple[float, float], Values] = {}

    def learn(self, places: "Iterable[tuple[float, float]]") -> None:
        """Calculate these places in 60 digits."""
        for place in places:
            if place not in self.known and (values := self.exact.values(*place, self.law)) is not None:
                self.known[place] = values

    def missed(self) -> dict[str, float]:
        """Error of doubles, by quantity."""
        near = {place: self.doubles(*place) for place in self.known}
        with localcontext(self.exact.context):
            return {
                name: MISSED * max(abs(values[name] - near[place][name]).value for place, values in self.known.items())
                for name in next(iter(self.known.values()))
            }

    def end(self, name: str, *, greatest: bool, missed: float) -> Extreme:
        """The extreme of one quantity, and the amount by which another point may exceed it."""
        exact = {place: self.known[place][name].exact for place in sorted(self.known)}
        place = (max if greatest else min)(exact, key=exact.__getitem__)
        # remainder in 60 digits of a difference that is zero
        nothing = SPARE * float(max(map(abs, exact.values())))
        value = float(exact[place])
        return Extreme(0.0, missed + nothing, place) if abs(value) <= nothing else Extreme(value, missed, place)
