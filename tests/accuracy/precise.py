"""A number of 240 bits that goes through a physics function as a tracked number does.

Its arithmetic is correctly rounded MPFR (gmpy2) where that is installed, mpmath's otherwise: the same numbers, slower.
What an iteration takes from it by `value` is a double, as from a tracked number: physics that iterates in doubles and
then takes one Newton step in the numbers that came in gets a root good to the square of a double's rounding.
"""

from typing import Any

from mpmath import mp, mpf

try:
    import gmpy2
except ImportError:
    gmpy2 = None

BITS = 240
Exact = type(gmpy2.mpfr(0)) if gmpy2 else mpf
Numbers = (float, int, Exact)


def _solved_involute(value: Any) -> Any:
    """The angle whose tan φ − φ is `value`, by Newton's method from above: nothing of the program's series."""
    half_pi = exact_pi() / 2
    if value <= 0:
        if value < 0:
            raise ArithmeticError("the involute function of no angle is negative")
        return value
    # both start above the root, where the residual is convex
    phi = (3 * value) ** (Exact(1) / 3) if value < 1 else half_pi - 1 / (value + half_pi)
    for _ in range(200):
        tangent = FUNCTIONS["tan"](phi)
        step = (tangent - phi - value) / (tangent * tangent)
        phi -= step
        if abs(step) <= abs(phi) * Exact(2) ** (16 - BITS):
            return phi
    raise ArithmeticError("no involute angle found")


def exact_pi() -> Any:
    """π to all bits."""
    return gmpy2.const_pi() if gmpy2 else +mp.pi


_LIBRARY = gmpy2 or mp
FUNCTIONS: dict[str, Any] = {
    name: getattr(_LIBRARY, name)
    for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh")
} | {
    "involute": lambda x: _LIBRARY.tan(x) - x,
    "roll_less_arc": lambda x: x - _LIBRARY.atan(x),
    "pi": lambda x: exact_pi(),
    "atan2": _LIBRARY.atan2,
    "hypot": _LIBRARY.hypot,
    "maximum": max,
    "minimum": min,
    "multiply_add": lambda a, b, c: a * b + c,
    "inverse_involute": _solved_involute,
}  # fmt: skip


def many_bits() -> None:
    """Make this thread's arithmetic that of these numbers; leaving the real numbers raises ArithmeticError."""
    mp.prec = BITS
    if gmpy2:
        gmpy2.set_context(gmpy2.context(precision=BITS, trap_invalid=True, trap_divzero=True))


def exactly(number: Any) -> Any:
    """A double, a whole number, or one of these numbers as it is in the library."""
    return number.exact if type(number) is Precise else Exact(number)


class Precise:
    """A number of 240 bits; `exact` is the library's."""

    __slots__ = ("exact",)

    def __init__(self, exact: Any) -> None:
        self.exact = exact

    @classmethod
    def inputs(cls, values: list[float]) -> list["Precise"]:
        """Doubles as they are."""
        return [cls(Exact(value)) for value in values]

    @property
    def value(self) -> float:
        """The nearest double."""
        return float(self.exact)

    def apply(self, name: str, *arguments: Any) -> "Precise":
        """The elementary function `name`, by the library."""
        made = FUNCTIONS[name](*map(exactly, arguments))
        if type(made) is not Exact:
            raise ArithmeticError(f"{name} leaves the real numbers")
        return Precise(made)

    def __float__(self) -> float:
        raise TypeError("a precise number does not turn into a float by itself")

    def __bool__(self) -> bool:
        return self.exact != 0

    def __hash__(self) -> int:
        return hash(self.exact)

    def __abs__(self) -> "Precise":
        return Precise(abs(self.exact))

    def __neg__(self) -> "Precise":
        return Precise(-self.exact)

    def __pos__(self) -> "Precise":
        return self

    def __add__(self, other: Any) -> "Precise":
        return Precise(self.exact + (other.exact if type(other) is Precise else other))

    __radd__ = __add__

    def __sub__(self, other: Any) -> "Precise":
        return Precise(self.exact - (other.exact if type(other) is Precise else other))

    def __rsub__(self, other: Any) -> "Precise":
        return Precise(other - self.exact)

    def __mul__(self, other: Any) -> "Precise":
        return Precise(self.exact * (other.exact if type(other) is Precise else other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "Precise":
        return Precise(self.exact / (other.exact if type(other) is Precise else other))

    def __rtruediv__(self, other: Any) -> "Precise":
        return Precise(other / self.exact)

    def __lt__(self, other: Any) -> bool:
        return self.exact < (other.exact if type(other) is Precise else other)

    def __le__(self, other: Any) -> bool:
        return self.exact <= (other.exact if type(other) is Precise else other)

    def __gt__(self, other: Any) -> bool:
        return self.exact > (other.exact if type(other) is Precise else other)

    def __ge__(self, other: Any) -> bool:
        return self.exact >= (other.exact if type(other) is Precise else other)

    def __eq__(self, other: object) -> bool:
        return bool(self.exact == (other.exact if type(other) is Precise else other))
