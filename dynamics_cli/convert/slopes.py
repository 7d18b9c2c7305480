"""Slopes as angles and angles as slopes: the arctangent and the tangent of exact numbers, rounded once.

Integers scaled by a power of ten enclose each function; more digits are taken until both ends round to one double.
"""

from math import isqrt

from dynamics_cli.core.units.conversion import nearest, pi_to
from dynamics_cli.core.units.unit import Unit
from dynamics_cli.errors import InadmissibleError

FIRST_DIGITS = 60
# Units of the last scaled digit that truncation in the series can add up to, with much to spare.
SLACK = 10**6
HALVINGS = 4


def angle_of_slope(numerator: int, denominator: int, unit: Unit) -> float:
    """The angle of a slope (rise over run), in `unit`: atan(n/d), correctly rounded.

    In units that are a rational part of a turn only slopes of 0 and ±1 have rational angles (Niven, Irrational
    Numbers, 1956, corollary 3.12), so every other one is settled by enough digits.
    """
    if not numerator:
        return 0.0
    if abs(numerator) == denominator and unit.pi == 1:
        return nearest(numerator * unit.denominator, denominator * 4 * unit.numerator)
    digits = FIRST_DIGITS
    while True:
        scale: int = 10**digits
        middle = _atan(abs(numerator), denominator, digits)
        ends = []
        for angle, step in ((middle - SLACK, 1), (middle + SLACK, 0)):
            up, down = angle * unit.denominator, scale * unit.numerator
            for _ in range(unit.pi):
                up, down = up * scale, down * (pi_to(digits) + step)
            ends.append(nearest(up, down))
        if ends[0] == ends[1]:
            return ends[0] if numerator > 0 else -ends[0]
        digits *= 2


def slope_of_angle(numerator: int, denominator: int, unit: Unit, over: int) -> float:
    """The slope of an angle as a number of 1/`over`: over·tan(n/d), correctly rounded.

    Raises InadmissibleError when the angle is a right angle or more.
    """
    if not numerator:
        return 0.0
    digits = FIRST_DIGITS
    while True:
        scale: int = 10**digits
        angle = abs(numerator) * unit.numerator * scale // (denominator * unit.denominator)
        if unit.pi == 1:
            angle = angle * pi_to(digits) // scale
        half = pi_to(digits) // 2
        right = 2 * abs(numerator) * unit.numerator >= denominator * unit.denominator
        if (unit.pi == 1 and right) or angle > half + SLACK:
            raise InadmissibleError("a slope of 90 deg or more has no rise over run", code="slope")
        sine, cosine = _sine(angle, scale), _sine(half - angle, scale)
        if cosine > SLACK:
            ends = [nearest(over * (sine + e), cosine - e) for e in (-SLACK, SLACK)]
            if ends[0] == ends[1]:
                return ends[0] if numerator > 0 else -ends[0]
        digits *= 2


def _atan(numerator: int, denominator: int, digits: int) -> int:
    """atan(n/d) · 10^digits for a positive ratio, by halving the angle and Gregory's series."""
    scale: int = 10**digits
    if numerator > denominator:
        return pi_to(digits) // 2 - _atan(denominator, numerator, digits)
    tangent = numerator * scale // denominator
    for _ in range(HALVINGS):
        tangent = tangent * scale // (scale + isqrt(scale * scale + tangent * tangent))
    square = tangent * tangent // scale
    total = term = tangent
    divisor, sign = 1, 1
    while term:
        term = term * square // scale
        divisor += 2
        sign = -sign
        total += sign * (term // divisor)
    return total << HALVINGS


def _sine(angle: int, scale: int) -> int:
    """sin(angle/scale) · scale by Taylor's series."""
    square = angle * angle // scale
    total = term = angle
    count, sign = 1, 1
    while term:
        term = term * square // (scale * (count + 1) * (count + 2))
        count += 2
        sign = -sign
        total += sign * term
    return total
