"""The task `gain`: the gains for which a closed loop is stable, exactly."""

import itertools
from decimal import Context, Decimal, localcontext

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.polynomial_text import ONE, read, read_quotient, whole
from dynamics_cli.numerics.exact.rational import total
from dynamics_cli.numerics.exact.whole_polynomials import (
    common_divisor,
    isolated,
    narrowed,
    plus,
    primitive,
    quotient,
    sign_at,
    square_free,
    times,
    trimmed,
)
from dynamics_cli.quantities import AngularRate, Annotated, Count, DampingRatio, Gain, Text
from dynamics_cli.records import Advice, Numerics, record
from dynamics_cli.stability.counting import ASYMPTOTIC, count, verdict
from dynamics_cli.stability.design import Design, designs
from dynamics_cli.stability.roots import LAST, METHOD, Root, bounds_of, discs, root_bounds, roots

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TypeAlias

    from dynamics_cli.numerics.exact.polynomial_text import Terms

    Pair: TypeAlias = tuple[int, int]
    # coefficients from the constant up, for each power of the gain
    Family: TypeAlias = list[tuple[int, ...]]

SYMBOL = "K"
MOST_DEGREE = 16
MOST_GAIN_DEGREE = 4
DIGITS = 40
SHOWN = 20
ON_AXIS = Decimal("1e-20")


@record
class GainRange:
    """A stretch of gains with the same root counts."""

    gains: Annotated[Text, "The gains, in words."]
    low: Annotated[Gain | None, "Where it begins; none at minus infinity [-]."]
    high: Annotated[Gain | None, "Where it ends; none at infinity [-]."]
    verdict: Annotated[Text, "Whether the loop is stable there."]
    left: Annotated[Count, "Roots in the left half plane."]
    right: Annotated[Count, "Roots in the right half plane."]
    axis: Annotated[Count, "Roots on the imaginary axis."]


@record
class Critical:
    """A gain at which roots cross the axis, or go through infinity."""

    gain: Annotated[Gain, "The gain [-]."]
    digits: Annotated[Text, "The same with 20 digits."]
    frequency: Annotated[AngularRate | None, "Frequency of the roots on the axis; none where the degree drops [rad/s]."]
    crossing: Annotated[Text, "What happens there."]


@record
class GainAnswer:
    """The stable gains of a loop, and what happens at their ends."""

    stable: Annotated[Text, "The stable gains, in words."]
    ranges: Annotated[tuple[GainRange, ...], "Stretches of gains between the critical ones."]
    critical: Annotated[tuple[Critical, ...] | None, "Gains at which roots cross the axis."]
    verdict: Annotated[Text | None, "Verdict at the gain that was given."]
    roots: Annotated[tuple[Root, ...] | None, "Roots at the gain that was given; of a pair the upper one."]
    designs: Annotated[tuple[Design, ...] | None, "Gains at which a pair of roots has the damping ratio given."]
    numerics: Numerics
    advice: tuple[Advice, ...] = ()


def gain(
    polynomial: Annotated[Text, "In s and the gain K, or an open loop, e.g. s(s+1)(s+2) + K."],
    /,
    *,
    gain: Annotated[Gain | None, "A gain to judge, e.g. 2.5."] = None,
    damping_ratio: Annotated[DampingRatio | None, "Damping ratio that a pair of roots shall have, e.g. 0.5."] = None,
) -> GainAnswer:
    """The gains K for which all roots of a characteristic polynomial lie in the left half plane.

    Equation
    --------
    Counts change only where Δ_{n−1}(K)·a₀(K)·a_n(K) = 0, with Δ the Hurwitz determinant; between two such gains they
    are those of any gain there.

    Returns
    -------
    GainAnswer
        The stable ranges, and the critical gains with the frequency at which the loop swings there.

    Raises
    ------
    UsageError
        When the text is no polynomial in s and K.
    InadmissibleError
        When roots lie in pairs ±s for every gain, or the degree is above 16.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 14.7; Gantmacher, The Theory of Matrices,
    volume 2, Chelsea 1959, chapter XV (Orlando's formula).

    Examples
    --------
    >>> gain("s(s+1)(s+2) + K").stable
    '0 < K < 6'
    """
    family = _family(polynomial)
    moving = _moving(family)
    critical = [mark for mark in _marks(moving) if _crossing(moving, mark)]
    ranges = _ranges(family, critical)
    at = None if gain is None else trimmed(_at(family, gain.as_integer_ratio()))
    found = None if at is None or len(at) < 2 else roots(at)
    described = tuple(_described(moving, mark) for mark in critical)
    return GainAnswer(
        stable=_words(ranges),
        ranges=ranges,
        critical=described or None,
        verdict=None if at is None else verdict(count(at)) if len(at) > 1 else "no roots at this gain",
        roots=found,
        designs=None if damping_ratio is None else designs(family, damping_ratio),
        numerics=Numerics(
            METHOD,
            (
                *bounds_of("critical", described, gain=LAST, frequency=LAST),
                *bounds_of("ranges", ranges, low=LAST, high=LAST),
                *root_bounds(found or ()),
            ),
        ),
        advice=(Advice("open-loop", "an open loop G with negative feedback: the roots are those of 1 + G = 0",
                       severity="note"),) if is_open_loop(polynomial) else (),
    )  # fmt: skip


def is_open_loop(text: str) -> bool:
    """Whether a text is an open loop, K/(s(s+1)), neither the polynomial nor 1 + K/(s(s+1))."""
    if "/" not in text or "," in text or "".join(text.split()).startswith("1+"):
        return False
    return read_quotient(text, gain=SYMBOL)[1] != ONE


def characteristic(text: str) -> "Terms":
    """The polynomial in s and K whose roots are those of the closed loop, from itself, from 1 + G or from G."""
    if "/" not in text or "," in text:
        return read(text, gain=SYMBOL)
    over, under = read_quotient(text, gain=SYMBOL)
    if under == ONE:
        return read(text, gain=SYMBOL)
    if is_open_loop(text):
        over = {key: total((over.get(key, (0, 1)), under.get(key, (0, 1)))) for key in {**over, **under}}
    return {key: over[key] for key in sorted(over, reverse=True) if over[key][0]}


def _family(text: str) -> "Family":
    family, _ = whole(characteristic(text))
    degree, highest = len(family[0]) - 1, len(family) - 1
    require(highest > 0, "{text} has no gain {symbol}", text=repr(text), symbol=SYMBOL, code="no-gain",
            hint="write the gain as K: s(s+1)(s+2) + K; without one ask `dynamics stability routh`")  # fmt: skip
    require(1 <= degree <= MOST_DEGREE, "{text} has degree {degree} in s, wanted 1 to {most}", text=repr(text),
            degree=str(degree), most=str(MOST_DEGREE), code="degree",
            hint="write the characteristic polynomial of the closed loop: s(s+1)(s+2) + K")  # fmt: skip
    require(highest <= MOST_GAIN_DEGREE, "{text} has the power {power} of the gain, the highest is {most}",
            text=repr(text), power=str(highest), most=str(MOST_GAIN_DEGREE), code="degree")  # fmt: skip
    return family


def _moving(family: "Family") -> "Family":
    """The family without the factor that it has at every gain."""
    fixed: tuple[int, ...] = ()
    for p in family:
        fixed = common_divisor(fixed, p)
    if len(fixed) < 2:
        return family
    # over the whole numbers with the fixed factor in lowest terms the quotients need no denominators
    return [_exact_quotient(trimmed(p), fixed) for p in family]


def _exact_quotient(p: "Sequence[int]", q: "Sequence[int]") -> "tuple[int, ...]":
    if not p:
        return (0,)
    part = quotient(p, q)
    return tuple(c * (p[-1] // (part[-1] * q[-1])) for c in part)


def _at(family: "Family", gain: "Pair") -> "tuple[int, ...]":
    """The polynomial at a gain, times a positive number."""
    top, bottom = gain
    total: tuple[int, ...] = ()
    for k, p in enumerate(family):
        total = plus(total, p, top**k * bottom ** (len(family) - 1 - k))
    return total


def _marks(family: "Family") -> "list[tuple[Pair, Pair]]":
    """Gains where a root may cross the axis or pass through infinity, each within an interval."""
    degree = max(len(trimmed(p)) for p in family) - 1
    parts = [trimmed(p[k] if k < len(p) else 0 for p in family) for k in (0, degree)]
    parts.append(_determinant(family, degree))
    product: tuple[int, ...] = (1,)
    for part in parts:
        require(bool(part), "roots lie in pairs ±s, or at zero, for every gain", code="symmetric",
                hint="no gain makes it asymptotically stable; see one gain by `dynamics stability routh`")  # fmt: skip
        product = times(product, part)
    simple: tuple[int, ...] = (1,)
    for factor, _ in square_free(product):
        simple = times(simple, factor)
    return [narrowed(simple, interval, DIGITS) for interval in isolated(simple)]


def _determinant(family: "Family", degree: int) -> "tuple[int, ...]":
    """Δ_{n−1} as a polynomial in the gain, from its values at whole gains by Newton's differences."""
    order = degree - 1
    most = order * (len(family) - 1)
    values = []
    for k in range(most + 1):
        p = _at(family, (k, 1))
        values.append(_value_of_determinant([*p, *[0] * (degree + 1 - len(p))], order))
    total: tuple[int, ...] = ()
    falling: tuple[int, ...] = (1,)
    scale = 1
    for k in range(1, most + 1):
        scale *= k
    weight = scale
    for k in range(most + 1):
        total = plus(total, falling, values[0] * weight)
        values = [b - a for a, b in itertools.pairwise(values)]
        falling = times(falling, (-k, 1))
        weight //= k + 1
    return primitive(total)


def _value_of_determinant(p: "Sequence[int]", order: int) -> int:
    """The Hurwitz determinant of that order, by elimination in whole numbers (Bareiss)."""
    degree = len(p) - 1
    rows = [
        [p[degree - (2 * j - i + 1)] if 0 <= 2 * j - i + 1 <= degree else 0 for j in range(order)] for i in range(order)
    ]
    sign, before = 1, 1
    for k in range(order - 1):
        pivot = next((i for i in range(k, order) if rows[i][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            rows[k], rows[pivot], sign = rows[pivot], rows[k], -sign
        for i in range(k + 1, order):
            for j in range(k + 1, order):
                rows[i][j] = (rows[i][j] * rows[k][k] - rows[i][k] * rows[k][j]) // before
        before = rows[k][k]
    return sign * rows[-1][-1] if order else 1


def _frequencies(p: "Sequence[int]") -> "list[float]":
    """Frequencies of the roots on the axis, those within rounding of it among them."""
    frequencies = set()
    for factor, _ in square_free(p):
        for x, y, _ in discs(factor):
            if y >= 0 and abs(x) <= ON_AXIS * max(y, ON_AXIS):
                frequencies.add(float(y))
    return sorted(frequencies)


def _crossing(family: "Family", mark: "tuple[Pair, Pair]") -> bool:
    """Whether something happens at a gain: roots on the axis, or one at infinity."""
    p = _at(family, mark[0])
    return _drops(family, mark) or bool(_frequencies(trimmed(p)))


def _drops(family: "Family", mark: "tuple[Pair, Pair]") -> bool:
    degree = max(len(trimmed(p)) for p in family) - 1
    leading = trimmed(p[degree] if degree < len(p) else 0 for p in family)
    low, high = (sign_at(leading, at) for at in mark)
    return low * high <= 0


def _ranges(family: "Family", marks: "Sequence[tuple[Pair, Pair]]") -> "tuple[GainRange, ...]":
    ends: list[tuple[Pair, Pair] | None] = [None, *marks, None]
    out = []
    for before, after in itertools.pairwise(ends):
        counts = count(_at(family, _between(before, after)))
        low, high = (None if end is None else _double(end) for end in (before, after))
        out.append(
            GainRange(
                gains=_named(low, high),
                low=low,
                high=high,
                verdict=verdict(counts),
                left=counts.left,
                right=counts.right,
                axis=counts.axis,
            )
        )
    return tuple(out)


def _between(before: "tuple[Pair, Pair] | None", after: "tuple[Pair, Pair] | None") -> "Pair":
    if before is not None and after is not None:
        (a, b), (c, d) = before[1], after[0]
        return a * d + c * b, 2 * b * d
    if after is not None:
        return after[0][0] - after[0][1], after[0][1]
    return (before[1][0] + before[1][1], before[1][1]) if before is not None else (0, 1)


def _described(family: "Family", mark: "tuple[Pair, Pair]") -> Critical:
    frequencies = _frequencies(trimmed(_at(family, mark[0])))
    if frequencies:
        crossing = "a root at zero" if frequencies[0] == 0.0 else "a pair on the axis"
        if len(frequencies) > 1:
            crossing = f"{len(frequencies)} roots or pairs on the axis"
    else:
        crossing = "the degree drops: a root passes through infinity"
    return Critical(
        gain=_double(mark),
        digits=_text(mark),
        frequency=frequencies[-1] if frequencies else None,
        crossing=crossing,
    )


def _double(mark: "tuple[Pair, Pair]") -> float:
    return mark[0][0] / mark[0][1]


def _text(mark: "tuple[Pair, Pair]") -> str:
    low, high = mark
    with localcontext(Context(prec=DIGITS)):
        middle = (Decimal(low[0]) / low[1] + Decimal(high[0]) / high[1]) / 2
    with localcontext(Context(prec=SHOWN)):
        return f"{(+middle).normalize():f}" if middle else "0"


def _named(low: "float | None", high: "float | None") -> str:
    if low is None:
        return f"every {SYMBOL}" if high is None else f"{SYMBOL} < {high:.6g}"
    return f"{SYMBOL} > {low:.6g}" if high is None else f"{low:.6g} < {SYMBOL} < {high:.6g}"


def _words(ranges: "Sequence[GainRange]") -> str:
    return "; ".join(one.gains for one in ranges if one.verdict == ASYMPTOTIC) or "no gain"
