"""Routh's array in exact numbers, rows of zeros and zero pivots marked."""

from dynamics_cli.numerics.exact.rational import lowest, written
from dynamics_cli.numerics.exact.whole_polynomials import common_divisor, plus, quotient, times, trimmed
from dynamics_cli.quantities import Annotated, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import TypeAlias

    # numerator and denominator, polynomials in ε
    Element: TypeAlias = tuple[tuple[int, ...], tuple[int, ...]]

MOST_DEGREE = 20
EPSILON: "Element" = ((0, 1), (1,))
NOTHING: "Element" = ((), (1,))


@record
class Row:
    """One row of Routh's array."""

    power: Annotated[Text, "The power of s whose row it is."]
    elements: Annotated[Text, "Its elements, exactly; ε is a small positive number."]
    note: Annotated[Text, "What was done where the row or its pivot was zero."]


def array(p: "Sequence[int]", denominator: int = 1) -> "tuple[Row, ...]":
    """Routh's array of p/denominator; p is from the constant up.

    A row of zeros is replaced by the derivative of the row above. The signs of the first
    column tell stability in the regular case only: a zero pivot is written as ε.
    """
    degree = len(p) - 1
    above = [_reduced((c,), (denominator,)) for c in p[degree::-2]]
    below = [_reduced((c,), (denominator,)) for c in p[degree - 1 :: -2]] if degree else []
    rows = [Row(power=f"s^{degree}", elements=_text(above), note="")]
    for power in range(degree - 1, -1, -1):
        note = ""
        below = below[: power // 2 + 1] + [NOTHING] * (power // 2 + 1 - len(below))
        if not any(top for top, _ in below):
            below = [_reduced(times((power + 1 - 2 * k,), above[k][0]), above[k][1]) for k in range(power // 2 + 1)]
            note = "row of zeros: derivative of the row above"
        if not below[0][0]:
            below[0] = EPSILON
            note += ("; " if note else "") + "zero pivot: ε"
        rows.append(Row(power=f"s^{power}" if power else "1", elements=_text(below), note=note))
        above, below = below, _next(above, below)
    return tuple(rows)


def _next(above: "list[Element]", below: "list[Element]") -> "list[Element]":
    """(b₁·a_{k+1} − a₁·b_{k+1})/b₁ for every k."""
    ratio = _reduced(times(above[0][0], below[0][1]), times(above[0][1], below[0][0]))
    out = []
    for k in range(1, len(above)):
        a, b = above[k], below[k] if k < len(below) else NOTHING
        taken = times(ratio[0], b[0]), times(ratio[1], b[1])
        top = plus(times(a[0], taken[1]), times(taken[0], a[1]), -1)
        out.append(_reduced(top, times(a[1], taken[1])))
    return out


def _reduced(top: "Sequence[int]", bottom: "Sequence[int]") -> "Element":
    top = trimmed(top)
    if not top:
        return NOTHING
    if len(top) == 1 and len(bottom) == 1:
        a, b = lowest(top[0], bottom[0])
        return (a,), (b,)
    shared = common_divisor(top, bottom)
    # the quotients are in lowest terms: what their contents were must be kept
    one, other = quotient(top, shared), quotient(bottom, shared)
    content, below = _content(top, one, shared), _content(bottom, other, shared)
    a, b = lowest(content[0] * below[1], content[1] * below[0])
    return times((a,), one), times((b,), other)


def _content(p: "Sequence[int]", part: "Sequence[int]", shared: "Sequence[int]") -> "tuple[int, int]":
    return lowest(p[-1], part[-1] * shared[-1])


def _text(elements: "Sequence[Element]") -> str:
    return "  ".join(_limit(*element) for element in elements)


def _limit(top: "Sequence[int]", bottom: "Sequence[int]") -> str:
    """The leading term as ε goes to zero from above."""
    if not top:
        return "0"
    i, j = _first(top), _first(bottom)
    value = lowest(top[i], bottom[j])
    power = i - j
    if not power:
        return written(value)
    if power < 0:
        name = "ε" if power == -1 else f"ε^{-power}"
        return f"{value[0]}/{name}" if value[1] == 1 else f"{value[0]}/({value[1]}·{name})"
    name = "ε" if power == 1 else f"ε^{power}"
    sign = {(1, 1): "", (-1, 1): "-"}.get(value, f"{written(value)}·")
    return f"{sign}{name}"


def _first(p: "Sequence[int]") -> int:
    return next(k for k, c in enumerate(p) if c)
