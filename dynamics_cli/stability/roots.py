"""Roots of polynomials, each within a proved distance, and exactly on the axis where they are."""

import itertools
from decimal import Context, Decimal, getcontext, localcontext
from math import atan2, cos, isfinite, log2, pi, sin

from dynamics_cli.numerics.exact.whole_polynomials import square_free
from dynamics_cli.quantities import AngularRate, Annotated, Count, GrowthRate, Ratio, Time
from dynamics_cli.records import ErrorBound, record
from dynamics_cli.stability.counting import parted

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any, TypeAlias

    # real and imaginary part
    Complex: TypeAlias = tuple[Decimal, Decimal]
    Disc: TypeAlias = tuple[Decimal, Decimal, Decimal]

FIRST_DIGITS = 50
MOST_DIGITS = 3200
METHOD = "exact counts; roots enclosed to 25 digits"
ROUNDS = 200
# Half the last bit of a double, with room for what is beyond 25 digits.
LAST = 1.2e-16
# Corrections in doubles stop here.
NEAR = 1e-14
# Discs this small beside their roots: a double is right to its last bit.
SMALL = Decimal("1e-25")
ZERO = Decimal(0)
# Roundings of one step of Horner's rule with complex numbers, and of one factor of the product, in last digits.
EPSILON = Decimal(100)


@record
class Root:
    """One root of the characteristic polynomial; of a pair the one with positive imaginary part."""

    real: Annotated[GrowthRate, "Real part: rate of growth, negative for decay [1/s]."]
    imaginary: Annotated[AngularRate, "Imaginary part: angular frequency of the oscillation [rad/s]."]
    multiplicity: Annotated[Count, "How often it is a root."]
    pair: Annotated[bool, "Whether the conjugate is a root too."]
    natural: Annotated[AngularRate, "Distance from the origin: natural frequency [rad/s]."]
    damping: Annotated[Ratio | None, "Damping ratio −Re/|s|; none at the origin [-]."]
    time_constant: Annotated[Time | None, "Time in which it falls or grows by e; none on the axis [s]."]


def roots(p: "Sequence[int]") -> "tuple[Root, ...]":
    """The roots, those of a pair as one, the rightmost first."""
    proved: list[tuple[Disc, int]] = []
    for factor, multiplicity in square_free(p):
        proved += [(disc, multiplicity) for disc in discs(factor)]
    upper = [(disc, multiplicity) for disc, multiplicity in proved if disc[1] >= 0]
    upper.sort(key=lambda item: (-item[0][0], item[0][1]))
    return tuple(_root(disc, multiplicity) for disc, multiplicity in upper)


def root_bounds(found: "Sequence[Root]", *rightmost: str) -> "tuple[ErrorBound, ...]":
    """What the discs prove of the roots, and of results that are the rightmost real part."""
    bounds = [ErrorBound(name, relative(found[0].real, found[0].natural)) for name in rightmost]
    for nth, root in enumerate(found):
        real, imaginary = (relative(part, root.natural) for part in (root.real, root.imaginary))
        parts = {"real": real, "imaginary": imaginary, "natural": LAST, "damping": real, "time_constant": real}
        bounds += [ErrorBound(f"roots[{nth}].{name}", bound) for name, bound in parts.items()
                   if getattr(root, name) is not None]  # fmt: skip
    return tuple(bounds)


def bounds_of(table: str, rows: "Sequence[Any]", **columns: float) -> "list[ErrorBound]":
    """The same bound for each column of a table, where it has a number."""
    return [
        ErrorBound(f"{table}[{nth}].{name}", bound)
        for nth, row in enumerate(rows)
        for name, bound in columns.items()
        if getattr(row, name) is not None
    ]


def relative(part: float, size: float) -> float:
    """What a double of a real or imaginary part is off by; a zero is exact."""
    return LAST + 2.0 * float(SMALL) * size / abs(part) if part else 0.0


def _root(disc: "Disc", multiplicity: int) -> Root:
    x, y, _ = disc
    with localcontext(Context(prec=FIRST_DIGITS)):
        size = (x * x + y * y).sqrt()
        ratio = -x / size if size else None
        return Root(
            real=float(x) + 0.0,
            imaginary=float(y),
            multiplicity=multiplicity,
            pair=bool(y),
            natural=float(size),
            damping=None if ratio is None else float(ratio) + 0.0,
            time_constant=float(1 / abs(x)) if x else None,
        )


def discs(p: "Sequence[int]") -> "list[Disc]":
    """A disc about each root of a square-free polynomial: its middle and its radius; zeros are exact.

    Roots in pairs ±s are the square roots of those of a polynomial in s², so that what is on the axis has no real part.
    """
    at_zero, pairs, rest = parted(p)
    proved: list[Disc] = [(ZERO, ZERO, ZERO)] * at_zero
    for u, v, radius in _simple(pairs):
        x, y, error = _square_root(u, v, radius)
        proved += [(x, y, error), (-x, -y, error)]
        # a pair of conjugates in s² gives both signs of the imaginary part by itself
    return proved + _simple(rest)


def circle_discs(p: "Sequence[int]") -> "list[tuple[float, float, float, float]]":
    """Real and imaginary part, size and angle of the roots in z of a square-free polynomial; sizes near one are one."""
    at_zero = int(p[0] == 0)
    out = [(0.0, 0.0, 0.0, 0.0)] * at_zero
    for x, y, radius in _simple(p[at_zero:]):
        with localcontext(Context(prec=FIRST_DIGITS)):
            size = (x * x + y * y).sqrt()
            size = Decimal(1) if abs(size - 1) <= radius + SMALL else size
        out.append((float(x), float(y), float(size), atan2(float(y), float(x))))
    return out


def _square_root(u: "Decimal", v: "Decimal", radius: "Decimal") -> "Disc":
    with localcontext(Context(prec=FIRST_DIGITS)):
        size = (u * u + v * v).sqrt()
        x, y = ((size + abs(u)) / 2).sqrt(), ZERO
        y = abs(v) / (2 * x)
        if u < 0:
            x, y = y, x
        # |√a − √b| ≤ |a − b|/|√a| for numbers that near
        return x, y if v >= 0 else -y, radius / size.sqrt()


def _simple(p: "Sequence[int]") -> "list[Disc]":
    """A disc about each root of a polynomial with simple roots, all apart from one another."""
    degree = len(p) - 1
    if degree < 1:
        return []
    if degree == 1:
        with localcontext(Context(prec=FIRST_DIGITS)):
            return [(Decimal(-p[0]) / Decimal(p[1]), ZERO, ZERO)]
    places = _nearer(p, _begin(p))
    digits = FIRST_DIGITS
    while digits <= MOST_DIGITS:
        with localcontext(Context(prec=digits, Emax=10**8, Emin=-(10**8))):
            lead = Decimal(p[-1])
            coefficients = [Decimal(c) / lead for c in p]
            for _ in range(ROUNDS):
                steps = _corrections(coefficients, places)
                places = [(x - a, y - b) for (x, y), (a, b) in zip(places, steps, strict=True)]
                if all(_small(step, place, digits) for step, place in zip(steps, places, strict=True)):
                    break
            proved = _proved(coefficients, places)
            if proved is not None:
                return proved
        digits *= 2
    raise ArithmeticError("the roots did not part")


def _small(step: "Complex", place: "Complex", digits: int) -> bool:
    return max(abs(step[0]), abs(step[1])) <= max(abs(place[0]), abs(place[1])).scaleb(8 - digits)


def _proved(coefficients: "Sequence[Decimal]", places: "Sequence[Complex]") -> "list[Disc] | None":
    """The discs, when none touches another: |z − root| ≤ n·|W| with W the corrections of Weierstrass.

    A disc alone that meets the real axis holds a real root: its conjugate would lie in the same disc.
    """
    degree = len(places)
    weights = _corrections(coefficients, places)
    radii = [degree * ((a * a + b * b).sqrt() + _rounding(coefficients, places, i)) for i, (a, b) in enumerate(weights)]
    for i, (x, y) in enumerate(places):
        if radii[i] > SMALL * max(abs(x), abs(y)):
            return None
        for j in range(i):
            apart = ((x - places[j][0]) ** 2 + (y - places[j][1]) ** 2).sqrt()
            if apart <= radii[i] + radii[j]:
                return None
    return [
        (x, ZERO if abs(y) <= radius else y, radius + abs(y) if abs(y) <= radius else radius)
        for (x, y), radius in zip(places, radii, strict=True)
    ]


def _rounding(coefficients: "Sequence[Decimal]", places: "Sequence[Complex]", i: int) -> "Decimal":
    """What rounding may add to the correction at one place."""
    x, y = places[i]
    size = (x * x + y * y).sqrt()
    total = ZERO
    for c in reversed(coefficients):
        total = total * size + abs(c)
    for j, (u, v) in enumerate(places):
        if j != i:
            total /= ((x - u) ** 2 + (y - v) ** 2).sqrt() or SMALL
    return total * len(places) * EPSILON.scaleb(-getcontext().prec)


def _corrections(coefficients: "Sequence[Decimal]", places: "Sequence[Complex]") -> "list[Complex]":
    """p(z)/∏(z − the other places) at every place (Weierstrass), for a polynomial with leading coefficient one."""
    out = []
    for i, (x, y) in enumerate(places):
        a, b = Decimal(1), ZERO
        for c in coefficients[-2::-1]:
            a, b = a * x - b * y + c, a * y + b * x
        c, d = Decimal(1), ZERO
        for j, (u, v) in enumerate(places):
            if j != i:
                u, v = x - u, y - v
                c, d = c * u - d * v, c * v + d * u
        size = c * c + d * d
        out.append(((a * c + b * d) / size, (b * c - a * d) / size) if size else (x / 1000 + 1, y))
    return out


def _begin(p: "Sequence[int]") -> "list[Complex]":
    """Places to start from: on circles whose radii are the slopes of the upper hull of log |c_k| over k (Bini)."""
    points = [(k, _log2(c)) for k, c in enumerate(p) if c]
    hull: list[tuple[int, float]] = []
    for point in points:
        while len(hull) > 1 and (hull[-1][1] - hull[-2][1]) * (point[0] - hull[-1][0]) <= (point[1] - hull[-1][1]) * (
            hull[-1][0] - hull[-2][0]
        ):
            hull.pop()
        hull.append(point)
    places: list[Complex] = []
    for (k, low), (m, high) in itertools.pairwise(hull):
        exponent = (low - high) / (m - k)
        whole = int(exponent // 1)
        for j in range(m - k):
            turn = 2.0 * pi * (j / (m - k) + k / len(p)) + 0.4
            with localcontext(Context(prec=FIRST_DIGITS)):
                radius = Decimal(2) ** whole * Decimal(2.0 ** (exponent - whole))
                places.append((radius * Decimal(cos(turn)), radius * Decimal(sin(turn))))
    return places


def _nearer(p: "Sequence[int]", places: "list[Complex]") -> "list[Complex]":
    """The places after the same corrections in doubles, at a hundredth of the cost; as they were where those fail."""
    try:
        coefficients = [c / p[-1] for c in p[-2::-1]]
        z = [complex(x, y) for x, y in places]
        for _ in range(ROUNDS):
            largest = 0.0
            for i, at in enumerate(z):
                value = below = 1.0 + 0j
                for c in coefficients:
                    value = value * at + c
                for j, other in enumerate(z):
                    if j != i:
                        below *= at - other
                z[i] = at - value / below
                largest = max(largest, abs(z[i] - at) / abs(z[i]))
            if not largest > NEAR:
                break
    except (OverflowError, ZeroDivisionError):
        return places
    apart = len(set(z)) == len(z) and all(isfinite(at.real) and isfinite(at.imag) for at in z)
    return [(Decimal(at.real), Decimal(at.imag)) for at in z] if apart else places


def _log2(whole: int) -> float:
    size = abs(whole)
    shift = max(size.bit_length() - 60, 0)
    return shift + log2(size >> shift)
