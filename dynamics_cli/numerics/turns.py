"""Cosine, sine and tangent of an angle as the user wrote it: exact at multiples of 30 and 45 degrees.

An angle reaches physics in radians. The double nearest to a multiple of π/6 stands for that multiple: the cosine of
90 degrees is not 6e-17. The bounds of tracked numbers, which are of the double, allow for the difference, and
numbers of many digits, which check those bounds, keep to the double. Use this where an angle is an input; a
calculated angle has no such meaning.
"""

from dynamics_cli.numerics.elementary import cos, in_class_of_first, product_error, sin, tan
from dynamics_cli.numerics.number import is_carrier

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# π/6, and the rounding error of the double.
SIXTH, REST = 0.5235987755982989, -5.360408832255455e-17
# π/4.
EIGHTH = 0.7853981633974483
# Multiples beyond this are not distinguishable from neighbouring doubles.
MOST = 1e6
# Relative rounding errors of an angle and of a sine.
OFF = 2.0**-53
HALF, ROOT = 0.5, 0.8660254037844386
# Sines of multiples of 30 degrees: sign and size.
_SINES = ((0, 0.0), (1, HALF), (1, ROOT), (1, 1.0), (1, ROOT), (1, HALF), (0, 0.0), (-1, HALF), (-1, ROOT), (-1, 1.0),
          (-1, ROOT), (-1, HALF))  # fmt: skip


def turned(angle: float) -> tuple[float, float]:
    """Cosine and sine of an angle in radians.

    References
    ----------
    Derived: sines of multiples of 30 degrees are 0, ½, ½√3 and 1; of 45 degrees ½√2.
    """
    if getattr(angle, "ndim", 0):
        return _of_array(angle)
    value: float = getattr(angle, "value", angle)
    multiple = multiple_of(value)
    # numbers of many digits are taken as they are
    if multiple is None or (is_carrier(angle) and not hasattr(angle, "error")):
        return cos(angle), sin(angle)
    return _exact(angle, value, multiple + 3), _exact(angle, value, multiple)


def tangent(angle: float) -> float:
    """Tangent of an angle in radians: 1 at 45 degrees."""
    if getattr(angle, "ndim", 0):
        return _tangents(angle)  # type: ignore[no-any-return]
    value: float = getattr(angle, "value", angle)
    count = round(value / EIGHTH) if abs(value) <= MOST * EIGHTH else 2
    # half of them are right angles, which have no tangent
    if count % 4 == 2 or count * EIGHTH != value or (is_carrier(angle) and not hasattr(angle, "error")):
        return tan(angle)
    size = (0.0, 1.0, 0.0, -1.0)[count % 4]
    if type(angle) is float:
        return size
    slope = 1.0 + size * size
    change = slope * (angle - value)
    error = change.error + 2.0 * OFF * abs(value) * slope  # type: ignore[attr-defined]
    return type(angle)(size, error, change.slopes)  # type: ignore[call-arg, attr-defined]


def _tangents(angles: "Any") -> "Any":
    """Of many angles."""
    if is_carrier(angles):
        return tan(angles)
    import numpy as np

    return np.vectorize(tangent, otypes=[float])(angles)


def multiple_of(value: float) -> int | None:
    """The multiple of 30 degrees whose nearest double the angle is, if any."""
    if not abs(value) <= MOST * SIXTH:
        return None
    count = round(value / SIXTH)
    return count if _nearest(float(count)) == value else None


def _nearest(count: "Any") -> "Any":
    """The double nearest to so many times 30 degrees."""
    product = count * SIXTH
    return product + (product_error(count, SIXTH, product) + count * REST)


def _exact(angle: float, value: float, multiple: int) -> float:
    """The sine of a multiple of 30 degrees; of a tracked angle with its slope and the error of the double."""
    sine = _size(multiple)
    if type(angle) is float:
        return sine
    slope = _size(multiple + 3)
    # nothing but slope; of a positive zero, since its sign decides directions
    change = abs(slope) * (angle - value if slope >= 0.0 else value - angle)
    error = change.error + OFF * abs(value * slope) + OFF * abs(sine)  # type: ignore[attr-defined]
    return type(angle)(sine, error, change.slopes)  # type: ignore[call-arg, attr-defined]


def _size(multiple: int) -> float:
    sign, size = _SINES[multiple % 12]
    return sign * size


def _of_array(angle: "Any") -> "tuple[Any, Any]":
    cosine, sine = cos(angle), sin(angle)
    if is_carrier(angle):
        return cosine, sine
    import numpy as np

    with np.errstate(all="ignore"):
        count = np.where(np.abs(angle) <= MOST * SIXTH, np.round(angle / SIXTH), 0.0)
        same = _nearest(count) == angle
    table = np.array([_size(multiple) for multiple in range(12)])
    twelfths = count.astype(int)
    exact = np.where(same, table[(twelfths + 3) % 12], cosine), np.where(same, table[twelfths % 12], sine)
    return in_class_of_first(exact[0], angle), in_class_of_first(exact[1], angle)
