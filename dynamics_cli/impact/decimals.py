"""What impacts in space need of numbers, for doubles and for decimals of many digits alike.

One formula is run in both: in decimals its rounding is nothing beside a double's, and the two together tell how many
digits an impact costs. Constants in such formulas are whole numbers, which go with either.
"""

from math import atan2, cos, fsum, hypot, sin, sqrt

from dynamics_cli.numerics.elementary import multiply_add

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def root(x: float) -> float:
    """Square root."""
    return x.sqrt() if hasattr(x, "sqrt") else sqrt(x)  # type: ignore[no-any-return]


def length(x: float, y: float, z: float = 0) -> float:
    """Length of a vector."""
    return root(x * x + y * y + z * z) if hasattr(x, "sqrt") else hypot(hypot(x, y), z)


def fused(a: float, b: float, c: float) -> float:
    """a·b + c, rounded once or nearly so."""
    return a.fma(b, c) if hasattr(a, "fma") else multiply_add(a, b, c)  # type: ignore[no-any-return]


def total(parts: "list[float]") -> float:
    """Sum, in doubles rounded once."""
    return sum(parts) if hasattr(parts[0], "sqrt") else fsum(parts)


def angle(y: float, x: float) -> float:
    """Angle of (x, y) from the first axis, as a double."""
    return atan2(float(y), float(x))


def cosine_and_sine(heading: float) -> tuple[float, float]:
    """Cosine and sine of an angle."""
    if not hasattr(heading, "adjusted"):
        return cos(heading), sin(heading)
    # by doubling the angle from one so small that few terms do
    halvings = max(heading.adjusted() * 4 + 40, 8)
    x = heading / 2**halvings
    term, sine, versine = x, x, x * 0
    for n in range(2, 24):
        term = term * x / n
        if n % 2:
            sine += term if n % 4 == 1 else -term
        else:
            versine += term if n % 4 == 2 else -term
    # 1 − cos and sin of twice the angle
    for _ in range(halvings):
        sine, versine = 2 * sine * (1 - versine), 2 * sine * sine
    return 1 - versine, sine


def widened(tree: "Any") -> "Any":
    """The same records with their doubles as decimals, exactly."""
    from decimal import Decimal

    if isinstance(tree, (tuple, list)):
        return tuple(map(widened, tree))
    if hasattr(tree, "fields"):
        return type(tree)(*(widened(getattr(tree, name)) for name in tree.fields))
    return Decimal(tree) if isinstance(tree, (int, float)) and not isinstance(tree, bool) else tree
