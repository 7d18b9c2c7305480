"""A root between two signs and the place of a maximum: functions of one double, and arrays of them."""

from dynamics_cli.numerics.number import is_array

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

# From the largest double down to the least: more than any bracket takes.
HALVINGS = 2200
GOLDEN = 0.6180339887498949
# Two units in the last place, and which step of `sign_change` halves.
LAST_PLACES, HALVING = 4e-16, 8


def halved(
    holds: "Callable[[float], object]", low: float, high: float, halvings: int = HALVINGS
) -> "tuple[float, float]":
    """Both sides of the place where a condition that holds at `low`, and not at `high`, ends.

    They are two neighbouring doubles, unless fewer halvings are asked for. `low` may lie above `high`.
    """
    for _ in range(halvings):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low, high


def bisected(function: "Callable[[float], float]", low: float, high: float, halvings: int = HALVINGS) -> float:
    """The root between two places of opposite signs, to the last bit unless fewer halvings are asked for."""
    at_low = function(low)
    if at_low == 0.0:
        return low
    negative = at_low < 0.0
    low, high = halved(lambda x: (function(x) < 0.0) == negative, low, high, halvings)
    return low if abs(function(low)) <= abs(function(high)) else high


def sign_change(function: "Callable[[float], float]", low: float, high: float, width: float = LAST_PLACES) -> float:
    """The sign change of a function that is positive at `low` and not at `high`, to a width relative to its size.

    Chords, the value at an end that stays a second time halved; every eighth step halves the bracket instead. Fewer
    steps than `bisected` takes, for functions that are long to compute.

    References
    ----------
    M. Dowell and P. Jarratt, A modified regula falsi method, BIT 11 (1971) 168.
    """
    f_low, f_high = function(low), function(high)
    if is_array(f_low):
        from dynamics_cli.numerics.lanes import sign_changes

        return sign_changes(function, low, high, width, HALVING)  # type: ignore[no-any-return]
    before: bool | None = None
    for count in range(200):
        middle = 0.5 * (low + high)
        if count % HALVING != HALVING - 1 and f_low > 0.0 > f_high:
            trial = (low * f_high - high * f_low) / (f_high - f_low)
            if low < trial < high or high < trial < low:
                middle = trial
        if middle in (low, high) or abs(high - low) <= width * max(abs(low), abs(high)):
            break
        value = function(middle)
        above = value > 0.0
        if above:
            low, f_low, f_high = middle, value, 0.5 * f_high if before is True else f_high
        else:
            high, f_high, f_low = middle, value, 0.5 * f_low if before is False else f_low
        before = above
    return low if abs(f_low) < abs(f_high) else high


def highest(function: "Callable[[float], float]", low: float, high: float, width: float) -> float:
    """Where a function with one top between two places is greatest, by golden sections down to a width.

    References
    ----------
    W. H. Press et al., Numerical Recipes, 3rd ed., Cambridge 2007, section 10.2.
    """
    left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_left, at_right = function(left), function(right)
    while high - low > width and low < left < right < high:
        if at_left > at_right:
            high, right, at_right = right, left, at_left
            left = high - GOLDEN * (high - low)
            at_left = function(left)
        else:
            low, left, at_left = left, right, at_right
            right = low + GOLDEN * (high - low)
            at_right = function(right)
    return 0.5 * (low + high)
