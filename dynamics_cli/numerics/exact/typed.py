"""Doubles that remember the decimals they were typed as, for sums formed in exact ratios."""

from math import gcd


class TypedNumber(float):
    """The double nearest to an exact ratio, which keeps the ratio; arithmetic gives plain doubles.

    >>> TypedNumber(1, 10).as_integer_ratio(), (0.1).as_integer_ratio()[1] == 2**55
    ((1, 10), True)
    """

    __slots__ = ("ratio",)
    ratio: tuple[int, int]

    def __new__(cls, numerator: int, denominator: int) -> "TypedNumber":
        """Reduce the ratio and round it."""
        common = gcd(numerator, denominator)
        number = super().__new__(cls, numerator / denominator)
        number.ratio = numerator // common, denominator // common
        return number

    def __getnewargs__(self) -> tuple[int, int]:  # type: ignore[override]
        """The ratio, for copies."""
        return self.ratio

    def as_integer_ratio(self) -> tuple[int, int]:
        """The typed ratio, not the ratio of the double."""
        return self.ratio
