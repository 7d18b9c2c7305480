"""Elementary functions of decimals, within some units of the last digit of the current context.

Arguments are reduced until Taylor's series needs about thirty terms; where a series would cancel, roots and angles are
calculated with as many more digits as are lost.
"""

from decimal import Decimal, getcontext, localcontext

TYPE_CHECKING = False
if TYPE_CHECKING:
    from contextlib import AbstractContextManager
    from decimal import Context

# 120 digits of π: enough to reduce angles of up to 10²⁰ radians to 60 digits, even if only 10⁻²⁴ remains.
PI = Decimal(
    "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706798214808651"
    "3282306647"
)
LARGEST_ANGLE = Decimal("1e20")
_GUARD = 12
_NEAR_QUARTERS = 24


def _more(digits: int) -> "AbstractContextManager[Context]":
    return localcontext(prec=getcontext().prec + digits)


def _reduced(x: Decimal) -> "tuple[Decimal, int]":
    """An angle reduced by quarter turns, and the number of quarter turns modulo four."""
    if abs(x) > LARGEST_ANGLE:
        raise ArithmeticError("an angle too large to reduce")
    digits = max(x.adjusted(), 0) + _NEAR_QUARTERS
    with localcontext(prec=getcontext().prec + digits):
        turns = (2 * x / PI).to_integral_value()
        return x - turns * PI / 2, int(turns) % 4


def _series(x: Decimal, term: Decimal, first: int) -> Decimal:
    """Term, −term·x²/((n+1)(n+2)), and so on, summed: a sine from x and 1, a cosine from 1 and 0."""
    square = -x * x
    total, n = term, first
    least = Decimal(10) ** -(getcontext().prec + 3)
    while abs(term) > abs(total) * least:
        term = term * square / ((n + 1) * (n + 2))
        total += term
        n += 2
    return total


def sine(x: Decimal) -> Decimal:
    """Sine of an angle in radians."""
    reduced, quarter = _reduced(x)
    value = _series(reduced, Decimal(1), 0) if quarter % 2 else _series(reduced, reduced, 1)
    return +value if quarter < 2 else -value


def cosine(x: Decimal) -> Decimal:
    """Cosine of an angle in radians."""
    reduced, quarter = _reduced(x)
    value = _series(reduced, reduced, 1) if quarter % 2 else _series(reduced, Decimal(1), 0)
    return +value if quarter in (0, 3) else -value


def tangent(x: Decimal) -> Decimal:
    """Tangent of an angle in radians."""
    reduced, quarter = _reduced(x)
    across, along = _series(reduced, reduced, 1), _series(reduced, Decimal(1), 0)
    return -along / across if quarter % 2 else across / along


def arc_tangent(x: Decimal) -> Decimal:
    """Arc tangent, in radians."""
    with _more(_GUARD):
        if abs(x) > 1:
            half = PI / 2
            return (half if x > 0 else -half) - arc_tangent(1 / x)
        halvings = 0
        while abs(x) > Decimal("0.06"):
            x = x / (1 + (1 + x * x).sqrt())
            halvings += 1
        return _odd_series(x) * Decimal(2) ** halvings


def _odd_series(x: Decimal) -> Decimal:
    """The series x − x³/3 + x⁵/5 − … of an arc tangent."""
    square, power, total, n = -x * x, x, x, 1
    least = Decimal(10) ** -(getcontext().prec + 1)
    while abs(power) > abs(total) * least:
        power *= square
        n += 2
        total += power / n
    return total


def arc_sine(x: Decimal) -> Decimal:
    """Arc sine, in radians."""
    if abs(x) > 1:
        raise ArithmeticError("arc sine beyond 1")
    if abs(x) == 1:
        return x * PI / 2
    # both factors are exact to their last digit where x is near ±1
    return arc_tangent(x / ((1 - x) * (1 + x)).sqrt())


def arc_cosine(x: Decimal) -> Decimal:
    """Arc cosine, in radians."""
    if abs(x) > 1:
        raise ArithmeticError("arc cosine beyond 1")
    return +PI if x == -1 else 2 * arc_tangent(((1 - x) / (1 + x)).sqrt())


def direction(y: Decimal, x: Decimal) -> Decimal:
    """Angle of the point (x, y), in radians, with the signs of zeros as the C library reads them."""
    if not y:
        around = PI if x.is_signed() else Decimal(0)
        return (+around).copy_sign(y)
    if abs(y) > abs(x):
        return (PI / 2).copy_sign(y) - arc_tangent(x / y)
    near = arc_tangent(y / x)
    return near if x > 0 else near + PI.copy_sign(y)


def hypotenuse(x: Decimal, y: Decimal) -> Decimal:
    """√(x² + y²)."""
    return (x * x + y * y).sqrt()


def hyperbolic_sine(x: Decimal) -> Decimal:
    """Hyperbolic sine; the exponentials cancel for small arguments and are calculated to more digits."""
    lost = max(0, -2 * x.adjusted()) if x else 0
    if lost > 20 * getcontext().prec:
        return +x
    with _more(lost + _GUARD):
        return (x.exp() - (-x).exp()) / 2


def involute(x: Decimal) -> Decimal:
    """The involute function of an angle, tan x − x."""
    with _more(_lost_beside_cubes(x)):
        return tangent(x) - x


def roll_less_arc(x: Decimal) -> Decimal:
    """The involute function of the angle whose tangent is given, x − atan x."""
    with _more(_lost_beside_cubes(x)):
        return x - arc_tangent(x)


def _lost_beside_cubes(x: Decimal) -> int:
    """How many digits cancel in a difference of the order of x³."""
    lost = max(0, -2 * x.adjusted()) if x else 0
    if lost > 20 * getcontext().prec:
        raise ArithmeticError("an angle too small to tell its involute")
    return lost + _GUARD


def inverse_involute(value: Decimal) -> Decimal:
    """The angle whose tan φ − φ is `value`, by Newton's method from above.

    References
    ----------
    Derived: Newton's method on tan φ − φ, convex, so that the steps from above decrease.
    """
    if value <= 0:
        if value < 0:
            raise ArithmeticError("the involute function of no angle is negative")
        return value
    # both starts are beyond the root, where the residual is convex
    phi = ((3 * value).ln() / 3).exp() if value < 1 else PI / 2 - 1 / (value + PI / 2)
    least = Decimal(10) ** -(getcontext().prec + 2)
    with _more(_lost_beside_cubes(phi)):
        for _ in range(200):
            tan = tangent(phi)
            step = (tan - phi - value) / (tan * tan)
            phi -= step
            if abs(step) <= abs(phi) * least:
                break
    return +phi
