"""Diagnostics of skid calculations: checks, and numbers beyond the range of doubles."""

from dynamics_cli.errors import worded
from dynamics_cli.numerics.elementary import multiply_add
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import Time
from dynamics_cli.records import Advice, Check

# A failed residual check is an internal error, so the tolerance allows for long sums of roundings.
TOLERANCE = 1e-12
# Between these, products and quotients of a few numbers keep all their digits.
SMALLEST, LARGEST = 1e-70, 1e70
DEGREES = 57.29577951308232
# Published times of reaction end at 2.5 s.
LONGEST_REACTION = 4.0


def balance(name: str, left: float, right: float, scale: float, *operands: float) -> tuple[Check, ...]:
    """Check that two sides agree relative to `scale`, within their rounding error where it is known.

    No check for arrays, or where an operand is so small or large that digits may be lost.
    """
    if not single(left, right, scale, *operands):
        return ()
    size = abs(plain(scale))
    sizes = [abs(plain(operand)) for operand in operands]
    if not 1e-280 < size < 1e280 or not all(x == 0.0 or SMALLEST < x < LARGEST for x in sizes):
        return ()
    # the sides are equal in exact arithmetic, so they cannot differ by more than both their errors
    error: float = (getattr(left, "error", 0.0) + getattr(right, "error", 0.0)) / size
    if not error < 1.0:
        return ()
    tolerance = max(TOLERANCE, 1.01 * error)
    residual = abs(plain(left) - plain(right)) / size
    return (Check(name=name, passed=residual <= tolerance, value=residual, tolerance=tolerance),)


def split_product(x: float, y: float) -> tuple[float, float]:
    """The product as a constant plus its rounding error, which alone carries derivatives: their sum is exact to u²."""
    head = plain(x * y)
    return head, multiply_add(x, y, -head)


def reaction_advice(time: float) -> tuple[Advice, ...]:
    """Advice when a reaction time is far beyond published ones."""
    if not single(time) or not plain(time) > LONGEST_REACTION:
        return ()
    message = worded("a reaction of {time} is far beyond published ones, which end at 2.5 s", time=(time, Time))
    return (Advice(code="long-reaction", message=message, remedy="see dynamics skid values reaction"),)
