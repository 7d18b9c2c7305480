"""The involute function inv φ = tan φ − φ and its inverse, to the last bit or two, without iteration.

φ(inv φ) is perfectly conditioned, but tan φ − φ is not: every method that solves it by its residual loses 3/φ² ulp.
So no equation is solved. Below 60° φ = s·P(s²) with s = ∛(3 inv φ); above, with c = inv φ + π/2, the complement
ψ = π/2 − φ obeys cot ψ + ψ = c, and is a series in 1/c. The polynomials interpolate 60-digit values at Chebyshev
points. Floats, arrays and tracked numbers get the same bits: arrays see only + − × ÷ and integer arithmetic.
"""

import math

from dynamics_cli.numerics.elementary import horner, in_class_of_first, tan
from dynamics_cli.numerics.number import is_array

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]

# inv 60°, where the two forms meet.
MEETING = 0.6848532563722796
# Below this tan φ − φ loses digits that the series keeps.
_FORWARD_LIMIT = 0.98
_HALF_PI = 1.5707963267948966
_HALF_PI_REST = 6.123233995736766e-17
# ∛: a third of the bits of a double, less than 10 % off in its cube, then a cubic in the error of that cube.
_THIRD = 3071306047985483769
_CUBIC = (1.7282232526369756, -1.294492162305515, 0.7376538587082156, -0.17138635967982363)
# Leaves 17 bits, whose cube is exact.
_SPLITTER = 68719476737.0
# Remaining error of Halley's step, relative to the cube of the step.
_FOURTH_ORDER = 2.0 / 3.0
# Below this the cube root is taken of a number scaled by 2³⁰⁰.
_SMALL = 1e-280
_UP, _DOWN = 2.0**300, 2.0**-100
# Arrays are worked in blocks that stay in cache.
_BLOCK = 8192

_LOW = (
    -0.13333333333333333, 0.017142857142857043, -0.001269841269836692, -7.915893638546071e-05, 3.8574759376296294e-05,
    -4.003942237843092e-06, -4.997225764074921e-07, 2.2317950160129234e-07, -2.361264242293939e-08,
    -3.859883695373116e-09, 1.7368088625319459e-09, -2.434611859901606e-10, 8.621708216646223e-13, 4.38277950118068e-12,
    -4.570054239772003e-13,
)  # fmt: skip
_HIGH = (
    0.6666666666666667, 0.8666666666665257, 1.3904761905619523, 2.479365058716133, 4.712268131042421, 9.347505172593612,
    19.1317241977766, 39.66178331221444, 94.82550492984474, 2.109369177918737, 3045.449300004691, -28200.283663953505,
    245983.8966499789, -1544480.6475553329, 7340083.272144027, -25096042.296934314, 59181355.05589713,
    -86005657.01826291, 59718272.00578452,
)  # fmt: skip
# (inv φ − φ³/3)/φ⁵.
_FORWARD = (
    0.13333333333333333, 0.053968253968253, 0.021869488536275926, 0.008863235523948857, 0.003592128191280107,
    0.0014558319414960143, 0.000590053038665535, 0.00023894175776774683, 9.790993136080742e-05, 3.535448883984021e-05,
    2.7606097313513984e-05, -2.0049168339061655e-05, 4.843459026954254e-05, -5.900594916529608e-05,
    5.925490535080751e-05, -4.167339946437946e-05, 2.0614551265507553e-05, -6.261566421646079e-06,
    9.405495364532011e-07,
)  # fmt: skip


def involute(phi: float) -> float:
    """Involute function tan φ − φ of an angle below 90°.

    `phi`: angle, |φ| < π/2 [rad]. Returns inv φ, within 2.1 ulp; odd in φ.

    Its condition is 3 near 0 and grows as 1/(π/2 − φ) towards 90°.

    Equation
    --------
    inv φ = tan φ − φ; below 0.98 rad φ³/3 + φ⁵ times a polynomial in φ².

    References
    ----------
    Definition: ISO 21771. The series is derived; its polynomial interpolates 60-digit values.

    Examples
    --------
    >>> round(involute(math.radians(20.0)), 12)
    0.014904383867
    """
    if type(phi) is float:
        if abs(phi) < _FORWARD_LIMIT:
            return _near(phi)
        return math.tan(phi) - phi
    if is_array(phi):
        return in_class_of_first(_involute_of_array(phi), phi)  # type: ignore[no-any-return]
    if isinstance(phi, int):
        return involute(float(phi))
    return _involute_in_other_numbers(phi)  # type: ignore[no-any-return]


def _near(phi: float) -> float:
    """φ³/3 with its cube exact in the leading part, and the rest of the series."""
    scaled = _SPLITTER * phi
    high = scaled - (scaled - phi)
    low = phi - high
    square = phi * phi
    rest = low * (high * high + low * (high + low / 3.0)) + phi * square * square * horner(_FORWARD, square)
    return high * high * high / 3.0 + rest


def _involute_of_array(phi: "Any") -> "Any":
    import numpy as np

    phi = np.asarray(phi, dtype=float)
    with np.errstate(over="ignore", invalid="ignore"):
        near = _near(phi)
    far = np.abs(phi) >= _FORWARD_LIMIT
    if not far.any():
        return near
    out = np.array(near)
    out[far] = tan(phi[far]) - phi[far]
    return out


def _involute_in_other_numbers(phi: "Any") -> "Any":
    """Tracked numbers: the slope is tan²φ, and the rounding 2.1 ulp."""
    from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked

    if not isinstance(phi, Tracked):
        # numbers that bring their own functions
        return phi.apply("involute", phi)
    value = involute(phi.value)
    end = abs(phi.value) + phi.error
    steepest = math.tan(end) ** 2 if end < _HALF_PI else math.inf
    slope = math.tan(phi.value) ** 2
    error = (steepest * phi.error if phi.error else 0.0) + 4.2 * UNIT_ROUNDOFF * abs(value)
    return Tracked(value, error * (1.0 + 1e-9), tuple(slope * part for part in phi.slopes))


def inverse_involute(value: float) -> float:
    """Angle whose involute function is `value`.

    `value`: inv φ, not negative. Returns φ, from 0 to π/2, within 1.3 ulp. Raises ValueError when a single value is
    negative or not a number; in arrays such places are NaN.

    d ln φ/d ln inv φ is at most 1/3: the problem is well-conditioned everywhere.

    Equation
    --------
    inv φ ≤ inv 60°: φ = s·P(s²), s = ∛(3 inv φ). Above: φ = π/2 − ψ, cot ψ + ψ = inv φ + π/2.

    References
    ----------
    Derived: see the module. Definition of the function: ISO 21771.

    Examples
    --------
    >>> round(math.degrees(inverse_involute(0.014904383867336446)), 12)
    20.0
    """
    if type(value) is float:
        return _inverse(value)
    if is_array(value):
        return in_class_of_first(_inverse_of_array(value), value)  # type: ignore[no-any-return]
    if isinstance(value, int):
        return _inverse(float(value))
    return _inverse_in_other_numbers(value)  # type: ignore[no-any-return]


def _inverse(value: float) -> float:
    if not value >= 0.0:
        raise ValueError(f"the involute function of no angle is {value!r}")
    if value > MEETING:
        c = value + _HALF_PI
        x = 1.0 / (c * c)
        return (_HALF_PI - (1.0 + x * horner(_HIGH, x)) / c) + _HALF_PI_REST
    if value < _SMALL:
        return _DOWN * _inverse(_UP * value) if value else 0.0
    high, low = _cube_root(3.0 * value)
    s = high + low
    w = s * s
    bend = w * horner(_LOW, w)
    return high + (low + s * bend)


def _cube_root(y: float) -> tuple[float, float]:
    """∛y as a number of 17 bits and the rest."""
    mantissa, exponent = math.frexp(y)
    bits = int((2.0 * mantissa - 1.0) * 4503599627370496.0) + ((exponent + 1022) << 52)
    bits = bits // 3 + _THIRD
    guess = math.ldexp(1.0 + (bits & 4503599627370495) / 4503599627370496.0, (bits >> 52) - 1023)
    return _polished(guess, y)


def _polished(guess: float, y: float) -> tuple[float, float]:
    ratio = guess * guess * (guess / y)
    root = guess * horner(_CUBIC, ratio)
    scaled = _SPLITTER * root
    high = scaled - (scaled - root)
    cube = high * high * high
    step = (y - cube) / (cube + cube + y)
    return high, high * (step + step * step * step * _FOURTH_ORDER)


def _inverse_of_array(value: "Any") -> "Any":
    import numpy as np

    value = np.asarray(value, dtype=float)
    flat = np.ascontiguousarray(value).ravel()
    out = np.empty_like(flat)
    workspace = np.empty((7, min(_BLOCK, flat.size)))
    with np.errstate(all="ignore"):
        for start in range(0, flat.size, _BLOCK):
            _inverse_of_block(flat[start : start + _BLOCK], out[start : start + _BLOCK], workspace)
    return out.reshape(value.shape)


def _inverse_of_block(value: "Array", out: "Array", room: "Array") -> None:
    import numpy as np

    above = value > MEETING
    if not above.any():
        _low_block(value, out, room)
        return
    if above.all():
        _high_block(value, out, room)
        return
    # evaluating both forms everywhere costs less than selecting and merging
    _low_block(value, out, room)
    other = room[6][: value.size]
    _high_block(value, other, room)
    np.copyto(out, other, where=above)


def _high_block(value: "Array", out: "Array", room: "Array") -> None:
    import numpy as np

    c, x, total = (row[: value.size] for row in room[:3])
    np.add(value, _HALF_PI, out=c)
    np.multiply(c, c, out=x)
    np.divide(1.0, x, out=x)
    _horner_block(_HIGH, x, total)
    total *= x
    total += 1.0
    total /= c
    np.subtract(_HALF_PI, total, out=out)
    out += _HALF_PI_REST


def _low_block(value: "Array", out: "Array", room: "Array") -> None:
    """As `_inverse` does, with the same operations in the same order."""
    import numpy as np

    near_zero = value < _SMALL
    if near_zero.any():
        # negative values and NaN give NaN
        scaled = np.where(value == 0.0, 0.0, _UP * value)
        scaled[~(scaled >= 0.0)] = np.nan
        part = np.where(near_zero, np.where(scaled == 0.0, 1.0, scaled), value)
        _low_block(part, out, room)
        np.copyto(out, np.where(scaled == 0.0, 0.0, _DOWN * out), where=near_zero)
        return
    y, guess, high, cube, total, s = (row[: value.size] for row in room[:6])
    np.multiply(value, 3.0, out=y)
    bits = guess.view(np.int64)
    np.floor_divide(y.view(np.int64), 3, out=bits)
    bits += _THIRD
    np.divide(guess, y, out=cube)
    np.multiply(guess, guess, out=s)
    cube *= s
    _horner_block(_CUBIC, cube, total)
    total *= guess
    np.multiply(total, _SPLITTER, out=s)
    np.subtract(s, total, out=high)
    np.subtract(s, high, out=high)
    np.multiply(high, high, out=cube)
    cube *= high
    np.subtract(y, cube, out=total)
    np.add(cube, cube, out=s)
    s += y
    total /= s
    np.multiply(total, total, out=s)
    s *= total
    s *= _FOURTH_ORDER
    total += s
    total *= high
    np.add(high, total, out=s)
    np.multiply(s, s, out=cube)
    _horner_block(_LOW, cube, y)
    y *= cube
    y *= s
    y += total
    np.add(high, y, out=out)


def _horner_block(coefficients: "tuple[float, ...]", x: "Array", total: "Array") -> None:
    import numpy as np

    np.multiply(x, coefficients[-1], out=total)
    total += coefficients[-2]
    for coefficient in coefficients[-3::-1]:
        total *= x
        total += coefficient


def _inverse_in_other_numbers(value: "Any") -> "Any":
    """Tracked numbers: concave, so an error has its largest effect on the side of zero; the rounding is 1.5 ulp."""
    from dynamics_cli.numerics.tracked import UNIT_ROUNDOFF, Tracked

    if not isinstance(value, Tracked):
        # numbers that bring their own functions
        return value.apply("inverse_involute", value)
    phi = _inverse(value.value)
    spread = phi - _inverse(max(value.value - value.error, 0.0)) if value.error else 0.0
    if value.error:
        spread += value.error / max(math.tan(phi) ** 2, 1e-300) * 1e-9 + 4.0 * UNIT_ROUNDOFF * phi * 1e-3
    tangent = math.tan(phi)
    slope = 1.0 / (tangent * tangent) if tangent > 1e-150 else math.inf
    if value.error and value.error < 1e-6 * value.value:
        # the difference of two roots has no correct digits here; the slope has
        spread = slope * value.error * (1.0 + 2.0 * value.error / value.value)
    error = (spread + 3.0 * UNIT_ROUNDOFF * phi) * (1.0 + 1e-9)
    return Tracked(phi, error, tuple(slope * part if part else 0.0 for part in value.slopes))
