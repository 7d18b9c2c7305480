"""Constants of rise laws composed of shares, in integer arithmetic."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_BITS = 256
_PI = (314159265358979323846264338327950288419716939937510 << _BITS) // 10**50


def constants_of(b: float, c: float, d: float, constant: float) -> "tuple[Any, ...]":
    """Constants of a rise whose acceleration is a sine, a constant and a cosine in shares of each half.

    1/2C_a = r/π − 4r²/π² + k(½ − r − k/2) + 2(½c)g/π + 4g²/π², r = bq, k = cq, g = dq, q = (1 − c)/2.

    `b`, `c`, `d`: shares of the sine, the constant and the cosine; `constant`: share of the rise at constant velocity.
    Returns C_a; the constant velocity; of the sine its amplitude, and lift and velocity at its end; lift and velocity
    at the end of the constant; the amplitude of the cosine; the rates of sine and cosine, zero for an absent part.
    Raises ZeroDivisionError when no share remains for the acceleration.

    Calculated in integers of 2⁻²⁵⁶, so that each is rounded once despite cancellation.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 16.9 and 16.11 to 16.14; laws of VDI 2143
    as commonly published.

    Examples
    --------
    >>> constants_of(0.0, 1.0, 0.0, 0.0)[0]
    4.0
    """
    ones = 1 << _BITS

    def fixed(value: float) -> int:
        above, below = value.as_integer_ratio()
        return above * ones // below

    def times(*factors: int) -> int:
        total = factors[0]
        for factor in factors[1:]:
            total = total * factor >> _BITS
        return total

    ratio = (ones * ones) // _PI
    q = (ones - fixed(constant)) >> 1
    r, k, g = (times(fixed(share), q) for share in (b, c, d))
    still = fixed(constant) >> 1
    swept, square = times(2 * r, ratio), times(ratio, ratio)
    rise = times(r, swept) - times(4 * square, r, r)
    lift = times(r, ratio) - times(4 * square, r, r) + times(k, (ones >> 1) - r - (k >> 1))
    lift += times(2 * still, g, ratio) + times(4 * square, g, g)
    peak = ones * ones // (2 * lift)
    bent = times(k, peak)
    constants = (
        peak,
        times(peak, times(2 * (r + g), ratio) + k),
        (times(4 * square, r, r, peak), times(peak, rise), times(peak, swept)),
        times(peak, rise) + times(k, times(peak, swept) + (bent >> 1)),
        times(peak, swept) + bent,
        times(4 * square, g, g, peak),
        tuple((_PI * ones) // (2 * width) if width else 0 for width in (r, g)),
    )
    return tuple(
        tuple(value / ones for value in part) if isinstance(part, tuple) else part / ones for part in constants
    )
