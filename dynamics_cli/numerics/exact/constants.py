"""Constants of formulas that are not doubles: π and multiples of it."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Constant(float):
    """A double that is used to all its digits beside numbers of many digits, which would take its rounding for exact.

    It has to be on the left of these, alone or times floats and other constants: ½ π r, not r·π/2. Beside any
    other number it is a plain double.
    """

    __slots__ = ("_factors",)
    _factors: "tuple[str | float, ...]"

    def __new__(cls, *factors: "str | float") -> "Constant":
        """The constant that is the product of decimal numbers and doubles."""
        value = float(factors[0])
        for factor in factors[1:]:
            value *= float(factor)
        constant = super().__new__(cls, value)
        constant._factors = factors
        return constant

    def __mul__(self, other: "Any") -> "Any":
        if isinstance(other, float):
            return Constant._of(float(self) * float(other), (*self._factors, *_factors(other)))
        if hasattr(other, "exact"):
            up, down = self.ratio()
            return other * up / down
        return float(self) * other

    def __rmul__(self, other: "Any") -> "Any":
        if isinstance(other, float):
            return Constant._of(float(other) * float(self), (*_factors(other), *self._factors))
        return other * float(self)

    @classmethod
    def _of(cls, value: float, factors: "tuple[str | float, ...]") -> "Constant":
        constant = super().__new__(cls, value)
        constant._factors = factors
        return constant

    def ratio(self) -> "tuple[int, int]":
        """The constant to all its given digits, as a ratio of integers."""
        up = down = 1
        for factor in self._factors:
            if isinstance(factor, str):
                integer, _, decimals = factor.partition(".")
                more = int(integer + decimals), 10 ** len(decimals)
            else:
                more = factor.as_integer_ratio()
            up, down = up * more[0], down * more[1]
        return up, down

    def beside(self, number: "Any") -> "Any":
        """The constant as a number like another one: of many digits, or the double."""
        if not hasattr(number, "exact"):
            return float(self)
        up, down = self.ratio()
        return (0.0 * number + up) / down


def _factors(number: "Any") -> "tuple[str | float, ...]":
    return number._factors if isinstance(number, Constant) else (float(number),)
