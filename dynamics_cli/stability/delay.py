"""The task `delay`: the delays for which p(s) + q(s)·e^(−sτ) is stable."""

from decimal import Context, Decimal, localcontext
from math import atan2, pi

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.polynomial_text import read, whole
from dynamics_cli.numerics.exact.whole_polynomials import (
    common_divisor,
    isolated,
    narrowed,
    plus,
    sign_at,
    square_free,
    times,
    trimmed,
)
from dynamics_cli.quantities import AngularRate, Annotated, Count, Text, Time
from dynamics_cli.records import ErrorBound, Numerics, record
from dynamics_cli.stability.counting import count
from dynamics_cli.stability.roots import LAST, bounds_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TypeAlias

    Pair: TypeAlias = tuple[int, int]

DIGITS = 40
MOST_EVENTS = 20000
NOTHING = 1e-12
# An angle in doubles over a frequency, and multiples of it.
ANGLE = 8e-16


@record
class Crossing:
    """A frequency at which roots cross the axis, again and again as the delay grows."""

    frequency: Annotated[AngularRate, "Frequency of the pair on the axis [rad/s]."]
    first: Annotated[Time, "The smallest delay that puts it there [s]."]
    spacing: Annotated[Time, "From one such delay to the next, 2π/ω [s]."]
    direction: Annotated[Text, "Whether the pair leaves the left half plane or returns to it."]


@record
class DelayRange:
    """A stretch of delays with the same number of roots on the right."""

    low: Annotated[Time, "Where it begins [s]."]
    high: Annotated[Time | None, "Where it ends; none at infinity [s]."]
    right: Annotated[Count, "Roots in the right half plane."]
    verdict: Annotated[Text, "Whether it is stable there."]


@record
class Delay:
    """The stable delays."""

    stable: Annotated[Text, "The stable delays, in words."]
    first_unstable: Annotated[Time | None, "The smallest delay at which it is not stable [s]."]
    crossings: Annotated[tuple[Crossing, ...] | None, "Frequencies of crossing, the highest first; none without any."]
    ranges: Annotated[tuple[DelayRange, ...], "Stretches of delays, up to the last one that can be stable."]
    verdict: Annotated[Text | None, "Verdict at the delay that was given."]
    numerics: Numerics


def delay(
    polynomial: Annotated[Text, "p(s), the part without delay, e.g. s^2 + 0.4s + 1."],
    /,
    *,
    delayed: Annotated[Text, "q(s), the part with the delay, e.g. 0.5."],
    delay: Annotated[Time | None, "A delay to judge, e.g. 0.5 s."] = None,
) -> Delay:
    """The delays τ for which p(s) + q(s)·e^(−sτ) has all its roots in the left half plane.

    Equation
    --------
    |p(iω)|² = |q(iω)|², a polynomial in ω²; τ = arg(−q(iω)/p(iω))/ω modulo 2π/ω; roots cross to the right where
    |p|² − |q|² grows with ω, and to the left where it falls.

    Returns
    -------
    Delay
        The stable delays, the crossing frequencies, and the number of unstable roots over the delay.

    Raises
    ------
    UsageError
        When a text is no polynomial in s.
    InadmissibleError
        When the delayed part is of higher degree, or as large at high frequencies; when both are alike in size at all
        frequencies.

    References
    ----------
    Cooke & van den Driessche, Funkcialaj Ekvacioj 29 (1986) 77.

    Examples
    --------
    >>> round(delay("s^2 + 0.4s + 1", delayed="0.5").first_unstable, 6)
    0.98417
    """
    p, q = (trimmed(part) for part in _together(polynomial, delayed))
    _require_retarded(p, q)
    common = common_divisor(p, q)
    crossings = _crossings(p, q)
    start = count(plus(p, q))
    ranges = _ranges(crossings, start.right, always=_always(p, q, common))
    unstable = next((one for one in ranges if one.verdict != STABLE), None)
    return Delay(
        stable=_words(ranges, open_at_zero=start.axis > 0),
        first_unstable=None if unstable is None else unstable.low,
        crossings=tuple(crossings) or None,
        ranges=tuple(ranges),
        verdict=None if delay is None else _judged(ranges, delay),
        numerics=Numerics(
            "exact crossings and counts; angles in doubles",
            (
                *([] if unstable is None else [ErrorBound("first_unstable", ANGLE)]),
                *bounds_of("crossings", crossings, frequency=LAST, first=ANGLE, spacing=ANGLE),
                *bounds_of("ranges", ranges, low=ANGLE, high=ANGLE),
            ),
        ),
    )


STABLE = "asymptotically stable"
UNSTABLE = "unstable"
ALWAYS = "roots on the axis at every delay"


def _together(first: str, second: str) -> "tuple[tuple[int, ...], tuple[int, ...]]":
    """Both polynomials with one denominator."""
    (p,), below = whole(read(first))
    (q,), other = whole(read(second))
    return tuple(c * other for c in p), tuple(c * below for c in q)


def _require_retarded(p: "Sequence[int]", q: "Sequence[int]") -> None:
    require(len(p) > 1, "the part without delay is a number", code="degree", hint="give p(s), such as s^2 + 0.4s + 1")
    require(
        len(q) <= len(p), "the delayed part has the higher degree: there are unstable roots at every delay",
        code="advanced", hint="check which part is delayed",
    )  # fmt: skip
    require(
        len(q) < len(p) or abs(q[-1]) < abs(p[-1]),
        "the delayed part is as large as the other at high frequencies: endless roots lie on the right or close in on "
        "the axis", code="neutral", hint="check the leading coefficients",
    )  # fmt: skip


def _parts(p: "Sequence[int]") -> "tuple[tuple[int, ...], tuple[int, ...]]":
    """Real part of p(iω), and its imaginary part over ω, as polynomials in ω²."""
    even = tuple(-c if k % 2 else c for k, c in enumerate(p[::2]))
    odd = tuple(-c if k % 2 else c for k, c in enumerate(p[1::2]))
    return even, odd


def _size(p: "Sequence[int]") -> "tuple[int, ...]":
    """|p(iω)|² as a polynomial in ω²."""
    even, odd = _parts(p)
    return plus(times(even, even), (0, *times(odd, odd)))


def _crossings(p: "Sequence[int]", q: "Sequence[int]") -> "list[Crossing]":
    difference = plus(_size(p), _size(q), -1)
    require(bool(difference), "both parts are alike in size at every frequency: nothing is decided", code="alike",
            hint="no delay makes it asymptotically stable, or every one; see one without delay")  # fmt: skip
    simple: tuple[int, ...] = (1,)
    for factor, _ in square_free(difference):
        simple = times(simple, factor)
    common = common_divisor(p, q)
    # without delay there may be roots on the axis, from where the least delay moves them
    touches = count(plus(p, q)).axis > 0
    crossings_met = []
    for interval in isolated(simple):
        low, high = narrowed(simple, interval, DIGITS)
        if high[0] <= 0:
            continue
        before, after = _signs(difference, (low, high))
        if before == after or _shared(common, low, high):
            continue
        with localcontext(Context(prec=DIGITS)):
            squared = (Decimal(low[0]) / low[1] + Decimal(high[0]) / high[1]) / 2
            frequency = squared.sqrt()
            turn = _turn(p, q, squared, frequency)
        omega = float(frequency)
        if touches and min(turn, 2.0 * pi - turn) < NOTHING:
            turn = 0.0
        crossings_met.append(
            Crossing(
                frequency=omega,
                first=turn / omega,
                spacing=2.0 * pi / omega,
                direction="leaves" if after > before else "returns",
            )
        )
    return crossings_met[::-1]


def _shared(common: "Sequence[int]", low: "Pair", high: "Pair") -> bool:
    """Whether a frequency within the interval is a root of both parts, which no delay moves."""
    if len(common) < 2:
        return False
    size = _size(common)
    return sign_at(size, low) == 0 if low == high else len(_roots_within(size, low, high)) > 0


def _roots_within(p: "Sequence[int]", low: "Pair", high: "Pair") -> "list[tuple[Pair, Pair]]":
    within = []
    for factor, _ in square_free(p):
        for interval in isolated(factor):
            a, b = narrowed(factor, interval, DIGITS)
            if a[0] * high[1] <= high[0] * a[1] and low[0] * b[1] <= b[0] * low[1]:
                within.append((a, b))
    return within


def _signs(p: "Sequence[int]", ends: "tuple[Pair, Pair]") -> "tuple[int, int]":
    """The signs of p on both sides of a root of its."""
    (low, high) = ends
    if low != high:
        return sign_at(p, low), sign_at(p, high)
    order = [_derivative_sign(p, low, k) for k in range(len(p))]
    first = next(k for k, sign in enumerate(order) if sign)
    return (order[first] if first % 2 == 0 else -order[first]), order[first]


def _derivative_sign(p: "Sequence[int]", at: "Pair", order: int) -> int:
    """The sign of a derivative at a ratio."""
    part = tuple(p)
    for _ in range(order):
        part = tuple(k * c for k, c in enumerate(part))[1:]
    return sign_at(part, at)


def _turn(p: "Sequence[int]", q: "Sequence[int]", squared: "Decimal", frequency: "Decimal") -> float:
    """The angle of −q/p from 0 to 2π: of their product in many digits, so that small angles keep theirs."""
    (a, b), (c, d) = ([_value(part, squared) for part in _parts(one)] for one in (p, q))
    turn = atan2(float(frequency * (b * c - a * d)), float(-(a * c + squared * b * d)))
    return turn if turn >= 0.0 else turn + 2.0 * pi


def _value(p: "Sequence[int]", x: "Decimal") -> "Decimal":
    total = Decimal(0)
    for c in reversed(p):
        total = total * x + c
    return total


def _always(p: "Sequence[int]", q: "Sequence[int]", common: "Sequence[int]") -> bool:
    """Whether there are roots on the axis that no delay moves: at zero, or shared by both parts."""
    return p[0] + q[0] == 0 or count(common).axis > 0


def _ranges(crossings: "Sequence[Crossing]", right: int, *, always: bool) -> "list[DelayRange]":
    """Stretches of delays until there are more roots on the right than can return."""
    if not crossings:
        return [_range(0.0, None, right, always)]
    leaving = [one for one in crossings if one.direction == "leaves"]
    returning = [one for one in crossings if one.direction == "returns"]
    out: list[DelayRange] = []
    now, events = 0.0, 0
    counts = dict.fromkeys(range(len(crossings)), 0)
    while events < MOST_EVENTS:
        at, index = min((one.first + counts[i] * one.spacing, i) for i, one in enumerate(crossings))
        counts[index] += 1
        events += 1
        if at > now:
            out.append(_range(now, at, right, always))
            now = at
        leaves = crossings[index].direction == "leaves"
        right += 2 if leaves else -2 if at > 0.0 else 0
        least = sum((now - one.first) / one.spacing for one in leaving)
        most = sum((now - one.first) / one.spacing + 1.0 for one in returning)
        if right > 0 and least > most:
            break
    return [*out, _range(now, None, right, always)]


def _range(low: float, high: "float | None", right: int, always: bool) -> DelayRange:
    verdict = UNSTABLE if right else ALWAYS if always else STABLE
    return DelayRange(low=low, high=high, right=right, verdict=verdict)


def _judged(ranges: "Sequence[DelayRange]", delay: float) -> str:
    return next(one for one in ranges if one.high is None or delay < one.high).verdict


def _words(ranges: "Sequence[DelayRange]", *, open_at_zero: bool) -> str:
    parts = []
    for one in ranges:
        if one.verdict == STABLE:
            below = f"delay < {one.high:.6g} s" if one.high is not None else ""
            if one.low == 0.0 and not open_at_zero:
                parts.append(below or "every delay")
            else:
                parts.append(f"{one.low:.6g} s < {below}" if below else f"delay > {one.low:.6g} s")
    return "; ".join(parts) or "no delay"
