"""Conversion that rounds once: exact ratios and powers of π in, the nearest double out.

`int / int` is correctly rounded in Python, and so is everything here: rational factors directly, factors with π by
dividing with a lower and an upper bound of π and going to more digits until both give the same double.
"""

from dynamics_cli.errors import FaultError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.units.unit import Unit

# The first 75 decimals of π, cut (not rounded): π lies between PI and PI + 1, over 10**PI_DIGITS.
PI = 3141592653589793238462643383279502884197169399375105820974944592307816406286
PI_DIGITS = 75
LARGEST = "beyond the range of a double (about 1.8e308)"
SMALLEST = "too close to zero for a double (less than about 5e-324)"


def nearest(numerator: int, denominator: int, pi: int = 0) -> float:
    """Give the double nearest to numerator/denominator · π^pi; refuse a value beyond the range of doubles."""
    if not numerator:
        return 0.0
    value = _nearest_with_pi(numerator, denominator, pi) if pi else _ratio(numerator, denominator)
    if value in (INFINITY, -INFINITY):
        raise UsageError(f"the value is {LARGEST}", code="range", hint="use a larger unit")
    if not value:
        raise UsageError(f"the value is {SMALLEST}", code="range", hint="use a smaller unit")
    return value


def to_si(numerator: int, denominator: int, unit: "Unit") -> float:
    """Give the SI value of an exact number of `unit`, rounded once."""
    shift, over = unit.offset
    if shift:
        return nearest(
            numerator * unit.numerator * over + shift * denominator * unit.denominator,
            denominator * unit.denominator * over,
        )
    return nearest(numerator * unit.numerator, denominator * unit.denominator, unit.pi)


def from_si(value: float, unit: "Unit") -> float:
    """Give the number of `unit` in an SI value, rounded once from the very double given."""
    numerator, denominator = ratio_of(value)
    shift, over = unit.offset
    if shift:
        numerator, denominator = numerator * over - shift * denominator, denominator * over
    return nearest(numerator * unit.denominator, denominator * unit.numerator, -unit.pi)


def convert(numerator: int, denominator: int, source: "Unit", target: "Unit") -> tuple[int, int, int]:
    """Convert an exact number between conformable units: the answer is n/d · π^k, in lowest terms.

    The caller checks that the units are conformable (`units.conformable`).
    """
    if target.offset[0] or source.offset[0]:
        return _convert_with_offset(numerator, denominator, source, target)
    numerator, denominator = lowest(
        numerator * source.numerator * target.denominator, denominator * source.denominator * target.numerator
    )
    return numerator, denominator, source.pi - target.pi if numerator else 0


def is_offset(unit: "Unit") -> bool:
    """Whether the unit's zero is not the SI unit's zero: degC and degF, for which differences need other units."""
    return unit.offset[0] != 0


def lowest(numerator: int, denominator: int) -> tuple[int, int]:
    """Reduce a ratio to lowest terms, the denominator positive."""
    a, b = numerator, denominator
    while b:
        a, b = b, a % b
    if (a < 0) != (denominator < 0):
        a = -a
    return numerator // a, denominator // a


def ratio_of(value: float) -> tuple[int, int]:
    """Give the exact ratio that a finite double is."""
    try:
        return value.as_integer_ratio()
    except (OverflowError, ValueError):
        raise FaultError(f"{value} reached the conversion of units; only finite numbers can be converted") from None


INFINITY = float("inf")


def _ratio(numerator: int, denominator: int) -> float:
    try:
        return numerator / denominator
    except OverflowError:
        return INFINITY if (numerator < 0) == (denominator < 0) else -INFINITY


def _nearest_with_pi(numerator: int, denominator: int, pi: int) -> float:
    power, digits, low = abs(pi), PI_DIGITS, PI
    while True:
        scale = 10 ** (digits * power)
        if pi > 0:
            low_ratio = _ratio(numerator * low**power, denominator * scale)
            high_ratio = _ratio(numerator * (low + 1) ** power, denominator * scale)
        else:
            low_ratio = _ratio(numerator * scale, denominator * low**power)
            high_ratio = _ratio(numerator * scale, denominator * (low + 1) ** power)
        # π is transcendental, so the exact value is neither a double nor a tie: the loop ends.
        if low_ratio == high_ratio:
            return low_ratio
        digits *= 2
        low = pi_to(digits)


def pi_to(digits: int) -> int:
    """Give π · 10^digits, cut, by Machin's 16 atan(1/5) − 4 atan(1/239) in integers with ten spare digits."""
    scale: int = 10 ** (digits + 10)

    def arctangent(inverse: int) -> int:
        term = total = scale // inverse
        square, divisor, sign = inverse * inverse, 1, 1
        while term:
            term //= square
            divisor += 2
            sign = -sign
            total += sign * (term // divisor)
        return total

    return (16 * arctangent(5) - 4 * arctangent(239)) // 10**10


def _convert_with_offset(numerator: int, denominator: int, source: "Unit", target: "Unit") -> tuple[int, int, int]:
    if source.pi or target.pi:
        raise FaultError(f"{source.text} to {target.text}: a shifted zero with a factor of π")
    shift, over = source.offset
    up = numerator * source.numerator * over + shift * denominator * source.denominator
    down = denominator * source.denominator * over
    shift, over = target.offset
    up, down = (up * over - shift * down) * target.denominator, down * over * target.numerator
    return (*lowest(up, down), 0)
