"""Numbers of formulas that a double only comes near to: π, and what is made of it."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Constant(float):
    """A double, known to all its digits beside numbers of many digits, which would take its rounding for exact.

    It has to stand on the left of these, alone or times floats and other constants: ½ π r, not r·π/2. Beside any other
    number it is the double that it is.
    """

    __slots__ = ("_factors",)
    _factors: "tuple[str | float, ...]"

    def __new__(cls, *factors: "str | float") -> "Constant":
        """The constant that is the product of numbers in digits and of doubles."""
        value = float(factors[0])
        for factor in factors[1:]:
            value *= float(factor)
        made = super().__new__(cls, value)
        made._factors = factors
        return made

    def __mul__(self, other: "Any") -> "Any":
        if isinstance(other, float):
            return Constant._of(float(self) * float(other), (*self._factors, *_factors(other)))
        return other * self.exact() if hasattr(other, "many_digits") else float(self) * other

    def __rmul__(self, other: "Any") -> "Any":
        if isinstance(other, float):
            return Constant._of(float(other) * float(self), (*_factors(other), *self._factors))
        return other * float(self)

    @classmethod
    def _of(cls, value: float, factors: "tuple[str | float, ...]") -> "Constant":
        made = super().__new__(cls, value)
        made._factors = factors
        return made

    def exact(self) -> "Any":
        """The constant as a decimal of as many digits as arithmetic has at the moment."""
        from decimal import Decimal

        total = Decimal(1)
        for factor in self._factors:
            total *= Decimal(factor)
        return total

    def beside(self, number: "Any") -> "Any":
        """The constant as a number like another one: of many digits, or the double."""
        return number * 0.0 + self.exact() if hasattr(number, "many_digits") else float(self)


def _factors(number: "Any") -> "tuple[str | float, ...]":
    return number._factors if isinstance(number, Constant) else (float(number),)
