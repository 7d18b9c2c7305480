"""A number of 60 decimal digits that goes through a physics function as a tracked number does.

A rounding bound adds up the worst of every operation; where these add up to much more than a last bit, a second pass in
many digits measures the actual error (`measured_error`). `value`, which iterations use, is a double as with a tracked
number.
"""

from decimal import Context, Decimal, DivisionByZero, InvalidOperation, Overflow, localcontext

from dynamics_cli.numerics.exact import decimal_functions as functions
from dynamics_cli.numerics.tracked import TINY, UNIT_ROUNDOFF

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

DIGITS = 60
CONTEXT = Context(prec=DIGITS, Emax=10**8, Emin=-(10**8), traps=[DivisionByZero, InvalidOperation, Overflow])


def _decimal(number: "ManyDigits | Decimal | float") -> Decimal:
    if type(number) is ManyDigits:
        return number.exact
    return number if isinstance(number, Decimal) else Decimal(number)  # type: ignore[arg-type]


class ManyDigits:
    """A number of 60 digits; `exact` is the decimal, within some units of its last digit."""

    __slots__ = ("exact",)
    # iterations in doubles refuse these (`elementary.only_in_doubles`)
    many_digits = True

    def __init__(self, exact: Decimal) -> None:
        self.exact = exact

    @classmethod
    def inputs(cls, values: "Iterable[float]") -> "list[ManyDigits]":
        """Doubles as they are."""
        return [cls(Decimal(value)) for value in values]

    @property
    def value(self) -> float:
        """The nearest double."""
        return float(self.exact)

    def apply(self, name: str, *arguments: "Any") -> "ManyDigits":
        """The elementary function `name`; leaving the real numbers raises ArithmeticError."""
        return ManyDigits(_FUNCTIONS[name](*map(_decimal, arguments)))

    def __float__(self) -> float:
        raise TypeError("a number of many digits does not turn into a float by itself")

    def __bool__(self) -> bool:
        return bool(self.exact)

    def __hash__(self) -> int:
        return hash(self.exact)

    def __abs__(self) -> "ManyDigits":
        return ManyDigits(abs(self.exact))

    def __neg__(self) -> "ManyDigits":
        # as a double's: the negative of zero is −0
        return ManyDigits(self.exact.copy_negate())

    def __pos__(self) -> "ManyDigits":
        return self

    def __add__(self, other: "ManyDigits | float") -> "ManyDigits":
        return ManyDigits(self.exact + _decimal(other))

    __radd__ = __add__

    def __sub__(self, other: "ManyDigits | float") -> "ManyDigits":
        return ManyDigits(self.exact - _decimal(other))

    def __rsub__(self, other: float) -> "ManyDigits":
        return ManyDigits(_decimal(other) - self.exact)

    def __mul__(self, other: "ManyDigits | float") -> "ManyDigits":
        return ManyDigits(self.exact * _decimal(other))

    __rmul__ = __mul__

    def __truediv__(self, other: "ManyDigits | float") -> "ManyDigits":
        return ManyDigits(self.exact / _decimal(other))

    def __rtruediv__(self, other: float) -> "ManyDigits":
        return ManyDigits(_decimal(other) / self.exact)

    def __lt__(self, other: "ManyDigits | float") -> bool:
        return self.exact < _decimal(other)

    def __le__(self, other: "ManyDigits | float") -> bool:
        return self.exact <= _decimal(other)

    def __gt__(self, other: "ManyDigits | float") -> bool:
        return self.exact > _decimal(other)

    def __ge__(self, other: "ManyDigits | float") -> bool:
        return self.exact >= _decimal(other)

    def __eq__(self, other: object) -> bool:
        return self.exact == _decimal(other)  # type: ignore[arg-type]


_FUNCTIONS: "dict[str, Callable[..., Decimal]]" = {
    "sqrt": lambda x: x.sqrt(),
    "exp": lambda x: x.exp(),
    "log": lambda x: x.ln(),
    "sinh": functions.hyperbolic_sine,
    "cosh": lambda x: (x.exp() + (-x).exp()) / 2,
    "tanh": lambda x: functions.hyperbolic_sine(x) / ((x.exp() + (-x).exp()) / 2),
    "maximum": max,
    "minimum": min,
    "multiply_add": lambda a, b, c: a.fma(b, c),
    "pi": lambda x: +functions.PI,
    "sin": functions.sine,
    "cos": functions.cosine,
    "tan": functions.tangent,
    "asin": functions.arc_sine,
    "acos": functions.arc_cosine,
    "atan": functions.arc_tangent,
    "atan2": functions.direction,
    "hypot": functions.hypotenuse,
    "involute": functions.involute,
    "roll_less_arc": functions.roll_less_arc,
    "inverse_involute": functions.inverse_involute,
}


def run(call: "Callable[[], Any]") -> "Any":
    """The result of `call` in 60-digit arithmetic."""
    with localcontext(CONTEXT):
        return call()


def measured_error(value: float, number: ManyDigits, bound: float) -> float:
    """The rounding error of `value`, from the same number in many digits; never more than `bound`, its running bound.

    The running bound of 60-digit arithmetic is that of doubles times 10⁻⁶⁰·2⁵³ and some units for its functions: far
    below 10⁻³⁰ of the bound, which is added. Two last bits of the value are added as well: for constants of a formula
    that are doubles in both passes, and for the residual of a Newton step from a double's root.

    References
    ----------
    Derived: the difference of two evaluations of one formula, the second with a far smaller running bound.
    """
    with localcontext(CONTEXT):
        apart = float(abs(Decimal(value) - number.exact))
    # a difference outside the bound has another cause: −π instead of π, or the other side of a switch
    if not apart <= bound:
        return bound
    return min(bound, apart * (1.0 + 2.0**-50) + 4.0 * UNIT_ROUNDOFF * abs(value) + 1e-30 * bound + TINY)
