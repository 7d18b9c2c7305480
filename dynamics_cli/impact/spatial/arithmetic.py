"""Functions of numbers for impacts in space: for doubles and for decimals of many digits.

One formula is run in both: in decimals its rounding is negligible beside that of doubles, and the difference shows
how many digits an impact costs. Constants in such formulas are integers, which work with both.
"""

from math import atan2, fsum, hypot, sqrt

from dynamics_cli.numerics.elementary import multiply_add
from dynamics_cli.numerics.turns import multiple_of, turned
from dynamics_cli.records import over_parts

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def root(x: float) -> float:
    """Square root."""
    return x.sqrt() if hasattr(x, "sqrt") else sqrt(x)


def length(x: float, y: float, z: float = 0) -> float:
    """Length of a vector."""
    return root(x * x + y * y + z * z) if hasattr(x, "sqrt") else hypot(hypot(x, y), z)


def fused(a: float, b: float, c: float) -> float:
    """a·b + c, rounded once or nearly so."""
    return a.fma(b, c) if hasattr(a, "fma") else multiply_add(a, b, c)


def total(parts: "list[float]") -> float:
    """Sum, in doubles rounded once."""
    return sum(parts) if hasattr(parts[0], "sqrt") else fsum(parts)


def angle(y: float, x: float) -> float:
    """Angle of (x, y) from the first axis, as a double."""
    return atan2(float(y), float(x))


def cosine_and_sine(heading: float) -> tuple[float, float]:
    """Cosine and sine of an angle, exact at multiples of 30 degrees."""
    if not hasattr(heading, "adjusted"):
        return turned(heading)
    from decimal import Decimal

    from dynamics_cli.numerics.exact import decimal_functions as functions

    if multiple_of(float(heading)) is None:
        return functions.cosine(heading), functions.sine(heading)  # type: ignore[arg-type, return-value]
    root = Decimal(3).sqrt() / 2
    exact_parts = (Decimal(part) for part in turned(float(heading)))
    cosine, sine = (part if part * 2 == int(part * 2) else root.copy_sign(part) for part in exact_parts)
    return cosine, sine  # type: ignore[return-value]


def widened(tree: "Any", number: "Callable[[float], Any] | None" = None) -> "Any":
    """The same records with their doubles as decimals, exactly, or as other numbers of many digits."""
    from decimal import Decimal

    number = number or Decimal
    if isinstance(tree, (int, float)) and not isinstance(tree, bool):
        return number(tree)
    return over_parts(tuple(tree) if isinstance(tree, list) else tree, lambda part: widened(part, number))
