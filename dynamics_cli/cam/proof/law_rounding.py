"""Running rounding error bounds of a law and its derivatives, at the places where they are computed.

Every formula of `cam.laws.components` is followed operation by operation, u = 2⁻⁵³ for each, with the magnitudes that
occur: near an end of a rise all of them are small, and so are the bounds. Sines and cosines of NumPy are taken to be
within four units in the last place, 8 u, those of the C library, which floats go through, within one, 2 u. Constants
are those of the formulas, each within `CONSTANT` roundings, amplitudes and frequencies within what the shape says
(`near`).

- Horner's rule: e ← e·|τ| + u(|v τ| + |v τ + c|), v ← v τ + c; coefficients add `CONSTANT` + k roundings of Σ |cᵢ τⁱ|.
- u − sin u: 8 u of it below one, where it is a series, one rounding and that of sin u beyond; 2 sin²(u/2) and
  2 sin(u/2) cos(u/2) within 17 u, of floats 5 u; cos u = 1 − 2 sin²(u/2). With A and w within a and b roundings, the
  angle wτ is off by b + 1, and by w times what τ is off by; the factor A wᵏ and its product count a + 1 + (b + 1)k.
- Powers of p = t(1 − t): two roundings for each factor p, one for each product.
- A place that is off by δ moves f⁽ᵏ⁾ by |f⁽ᵏ⁺¹⁾|δ, the magnitude taken over the terms and beyond the place.

All of it works on floats and on arrays.
"""

from math import pi

from dynamics_cli.cam.laws.components import Beta, EndOfDoubleHarmonic, FourthPowerOfSine, u_minus_sine
from dynamics_cli.numerics.elementary import cos, sin

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

U = 2.0**-53
UP = 1.0 + 2.0**-40
# sine and versed sine of an angle from sine and cosine of its half, of arrays and of floats
HALVES = 17.0
HALVES_OF_FLOATS = 5.0
SERIES = 8.0
CONSTANT = 3.0
# change of the constants, per deviation of the sum of the shares from 1
OFF = 8.0


def slips(shape: "Any", t: "Any", off: "Any", derivatives: int, halves: float = HALVES) -> "list[Any]":
    """Rounding error bounds of f and its derivatives at places known to within `off`.

    `shape`: shape of a law's piece; `t`: places, in the shape's own coordinate; `off`: error of the places;
    `derivatives`: how many derivatives, 0 to 4; `halves`: `HALVES`, or `HALVES_OF_FLOATS` where the shape was called
    with floats. Returns a bound for f and for each derivative, as `shape(t, derivatives)` computes them.

    See the module: proved from the order of operations, not from samples.

    Examples
    --------
    >>> from dynamics_cli.cam.laws.components import Beta
    >>> shape = Beta(2)
    >>> [bound < 1e-13 for bound in slips(shape, 0.25, 0.0, 3)]
    [True, True, True, True]
    """
    if isinstance(shape, Beta):
        return _beta(shape, t, off, derivatives)
    if isinstance(shape, FourthPowerOfSine | EndOfDoubleHarmonic):
        return _double_harmonic(shape, t, off, derivatives, halves)
    coefficients, waves, origin, _ = shape.parts
    tau = abs(t - origin)
    if origin:
        off = off + U * tau + U * abs(origin)
    off = off + shape.off
    rows = _rows(coefficients, derivatives + 1)
    signed = t - origin if not shape.backwards else origin - t
    sums = []
    for order in range(derivatives + 1):
        value, rounded = _horner(rows[order], signed)
        size = _size(rows[order], tau)
        moved = off * _size(rows[order + 1], tau + off)
        sums.append([U * (rounded + (CONSTANT + order) * size) + moved, abs(value)])
    for wave in waves:
        _add_wave(sums, wave, shape.near, tau, off, halves)
    # what remains are the additions of the parts
    spread = U * (len(waves) - (0.0 if coefficients else 1.0)) + OFF * shape.off
    return [(error + spread * size) * UP for error, size in sums]


def of_law(law: "Any", x: float) -> "list[float]":
    """Error bounds of `law.at(x)` for a float x: f and three derivatives.

    `x`: the place. Returns bounds; at a joint of pieces the more of both.

    Examples
    --------
    >>> from dynamics_cli.cam.laws.normalised import law_named
    >>> max(of_law(law_named("cycloidal"), 0.3)[:2]) < 5e-15
    True
    """
    worst = [0.0] * 4
    for piece in law.pieces:
        if piece.low <= x <= piece.high:
            t = 1.0 - x if piece.far else x
            errors = slips(piece.shape, t, U * t, 3, HALVES_OF_FLOATS)
            values = piece.shape(t, 3)
            errors[0] += U * (abs(law.total) + abs(values[0])) if piece.far else 0.0
            worst = [max(error, more) for error, more in zip(worst, errors, strict=True)]
    return worst


def of_part(part: "Any", t: "Any", halves: float = HALVES) -> "list[Any]":
    """Error bounds of lift and three derivatives by cam angle at places of a part of a motion, from cam angles.

    `part`: as `Motion.parts_of` gives them; `t`: places in the part's own coordinate: five roundings off; `halves`: as
    of `slips`. Returns bounds. A factor and its product count two roundings, each division by the span two more.

    Examples
    --------
    >>> from dynamics_cli.cam.program.reading import Program, motion_of
    >>> motion = motion_of(Program(), "rise 20 mm in 90 deg; dwell 60 deg; return in 90 deg; dwell")
    >>> of_part(motion.parts_of(0)[0], 0.25)[0] < 1e-16
    True
    """
    level = part.off
    if part.law_piece is None:
        return [level + 0.0 * t, 0.0 * t, 0.0 * t, 0.0 * t]
    shape = part.law_piece.shape
    errors = slips(shape, t, 5.0 * U * abs(t), 3, halves)
    values = shape(t, 3)
    # an error of the ends is an error of the factor
    base_error = part.off / abs(part.scales[0]) if part.scales[0] else 0.0
    bounds = [
        abs(scale) * (error + ((2.0 + 2.0 * order) * U + base_error) * abs(value)) * UP
        for order, (scale, error, value) in enumerate(zip(part.scales, errors, values, strict=False))
    ]
    bounds[0] = bounds[0] + level + U * (abs(part.base) + abs(part.scales[0] * values[0]) if part.base else 0.0)
    return bounds


def _rows(coefficients: "Sequence[float]", derivatives: int) -> "list[Sequence[float]]":
    """Coefficients of a polynomial and of its derivatives."""
    rows: list[Sequence[float]] = [coefficients]
    for _ in range(derivatives):
        rows.append([i * c for i, c in enumerate(rows[-1])][1:])
    return rows


def _horner(row: "Sequence[float]", t: "Any") -> "tuple[Any, Any]":
    """A polynomial by Horner's rule, and the roundings of it in units of u."""
    value = rounded = 0.0 * t
    first = True
    for c in reversed(row):
        product = value * t
        rounded = rounded * abs(t) + (0.0 if first else abs(product))
        value = product + c
        # adding nothing rounds nothing
        rounded = rounded + (0.0 if first or not c else abs(value))
        first = False
    return value, rounded


def _size(row: "Sequence[float]", reach: "Any") -> "Any":
    """Σ |cᵢ| reachⁱ."""
    total = 0.0 * reach
    for c in reversed(row):
        total = total * reach + abs(c)
    return total


def _add_wave(
    sums: "list[list[Any]]", wave: "tuple[float, float, int]", near: "tuple[float, float]", tau: "Any", off: "Any",
    halves: float,
) -> None:  # fmt: skip
    """Add roundings and sizes of A W(wτ) and its derivatives to the sums so far."""
    amplitude, w, start = wave
    u = w * tau
    moved = (near[1] + 1.0) * U * u + w * off * UP
    versed = 2.0 * sin(0.5 * u) * sin(0.5 * u)
    sine, cosine = abs(sin(u)) + U, abs(cos(u)) + U
    series = abs(u_minus_sine(u))
    factor = abs(amplitude)
    for order, part in enumerate(sums):
        which = start + order
        if which == 0:
            near_zero = u < 1.0
            rounded = near_zero * (SERIES * series) + (1.0 - near_zero) * (series + halves * sine)
            size, slope = series, versed
        elif which == 1:
            rounded, size, slope = halves * versed, versed, sine
        elif which % 2 == 0:
            rounded, size, slope = halves * sine, sine, cosine
        else:
            rounded, size, slope = halves * versed + cosine, cosine, sine
        error = U * (rounded + (near[0] + 1.0 + (near[1] + 1.0) * order) * size) + moved * (slope + moved)
        part[0] = part[0] + factor * error
        part[1] = part[1] + factor * size
        factor = factor * w


def _beta(shape: Beta, t: "Any", off: "Any", derivatives: int) -> "list[Any]":
    """Of the polynomials whose velocity is C pⁿ."""
    n, c = shape.n, shape.constant
    p, slope_factor = abs(t * (1.0 - t)), abs(1.0 - 2.0 * t)
    value, rounded = _horner(shape.row, t)
    lead = abs(t) ** (n + 1)
    sizes = [abs(value) * lead, c * p**n, c * n * p ** (n - 1) * slope_factor]
    # away from the place, p and its powers are larger by their error at most
    q = p + off
    grown = [
        c * q**n,
        c * n * q ** (n - 1) * (slope_factor + 2.0 * off),
        c * n * (q ** max(n - 2, 0) * abs((n - 1) - (4 * n - 2) * p) + (4 * n - 2) * q ** max(n - 2, 0) * off)
        if n > 1 else 2.0 * c,
        _fourth(n, c, q) * (slope_factor + 2.0 * off),
        _fifth(n, c, q),
    ]  # fmt: skip
    less = p ** max(n - 2, 0)
    bracket = 4.0 * (4 * n - 2) * p + 2.0 * abs((n - 1) - (4 * n - 2) * p)
    errors = [
        rounded * lead + (n + 1.0) * sizes[0],
        (3.0 * n + 1.0) * sizes[1],
        (3.0 * n + 2.0) * sizes[2],
        c * n * less * (bracket + 3.0 * n * abs((n - 1) - (4 * n - 2) * p)) if n > 1 else 3.0 * c,
        (3.0 * n + 6.0) * _fourth(n, c, p) * slope_factor,
    ]
    return [(U * error + off * slope) * UP for error, slope in zip(errors, grown, strict=True)][: derivatives + 1]


def _fourth(n: int, c: float, p: "Any") -> "Any":
    """The terms of the fourth derivative over 1 − 2t."""
    if n == 1:
        return 0.0 * p
    bent = (n - 1) * (n - 2) * p ** (n - 3) if n > 2 else 0.0 * p
    return c * n * (bent + (4 * n - 2) * (n - 1) * p ** (n - 2))


def _fifth(n: int, c: float, p: "Any") -> "Any":
    """A bound of the fifth derivative: |1 − 2t| ≤ 1 in all its terms."""
    if n == 1:
        return 0.0 * p
    first = (n - 1) * (n - 2) * ((n - 3) * p ** max(n - 4, 0) + 2.0 * p ** max(n - 3, 0))
    second = (4 * n - 2) * (n - 1) * ((n - 2) * p ** max(n - 3, 0) + 2.0 * p ** (n - 2))
    return c * n * (first + second)


def _double_harmonic(shape: "Any", t: "Any", off: "Any", derivatives: int, halves: float) -> "list[Any]":
    """Of the fourth power of a sine with its complement: products of versed sines, sines and cosines."""
    u = pi * abs(t)
    # the angle has an error of two roundings: counted as an error of the place
    off = off + 4.0 * U * abs(t)
    half, sine = abs(sin(0.5 * u)) + U, abs(sin(u)) + U
    versed, twice = 2.0 * half * half, 2.0 * sine * sine
    versed2, cosine = 0.5 * versed, 1.0 - versed
    values = [abs(value) for value in shape(t, 4)]
    if isinstance(shape, FourthPowerOfSine):
        first = [
            (2.0 * halves + 6.0) * values[0],
            (2.0 * halves + 6.0) * values[1],
            (2.0 * halves + 8.0) * values[2] + 1.5 * pi**2 * u * half,
        ]  # fmt: skip
        third = abs(4.0 * cosine - 1.0)
    else:
        first = [
            (halves + 3.0) * versed2 * (2.0 - versed2) + (halves + 2.0) * versed2 * versed2 + 2.0 * versed2,
            pi * sine * ((halves + 5.0) * abs(1.0 - versed2) + halves * versed2 + 2.0),
            0.5 * pi**2 * (halves * (versed + twice) + 3.0 + 5.0 * abs(cosine + 1.0 - twice)),
        ]
        third = abs(4.0 * cosine + 1.0)
    errors = [
        *first,
        0.5 * pi**3 * sine * (4.0 * (halves * versed + 1.0) + 5.0 + (halves + 7.0) * third),
        0.5 * pi**4 * (4.0 * (halves * twice + 1.0) + halves * versed + 30.0),
    ]
    # a derivative changes at most by the maximum of the next one times the error of the place
    slopes = [*values[1:], 4.5 * pi**5]
    most = [pi**2, 2.5 * pi**3, 2.5 * pi**4, 4.5 * pi**5, 0.0]
    return [
        (U * error + off * (slope + 1.1 * off * beyond)) * UP
        for error, slope, beyond in zip(errors, slopes, most, strict=True)
    ][: derivatives + 1]
