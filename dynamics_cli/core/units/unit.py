"""A unit as written, with its exact meaning in SI, and which units are interchangeable.

A kind is more than a dimension: an angle has its own dimension, so rpm is not a frequency; a joule is not a
newton-metre; `lb` is a mass or a force as the context requires.
"""

NONE = (0, 0, 0, 0, 0, 0, 0, 0)


class Unit:
    """A unit as it was written, with its exact meaning: SI value = number · numerator/denominator · π^pi + offset.

    `dimension` holds powers of length, mass, time, temperature, current, amount, luminosity and angle; `tag` is
    "energy" or "torque" where the unit is one only; `notes` says how a unit with two readings, or of
    several definitions, was read.
    """

    __slots__ = ("denominator", "dimension", "notes", "numerator", "offset", "pi", "tag", "text")

    def __init__(
        self,
        text: str,
        numerator: int,
        denominator: int,
        dimension: tuple[int, ...],
        *,
        pi: int = 0,
        offset: tuple[int, int] = (0, 1),
        tag: str = "",
        notes: tuple[str, ...] = (),
    ) -> None:
        self.text = text
        self.numerator = numerator
        self.denominator = denominator
        self.dimension = dimension
        self.pi = pi
        self.offset = offset
        self.tag = tag
        self.notes = notes

    def __repr__(self) -> str:
        factor = f"{self.numerator}/{self.denominator}" + (f"·π^{self.pi}" if self.pi else "")
        return f"Unit({self.text!r}, {factor}, {self.dimension}{self.tag and ', '}{self.tag})"


NUMBER = Unit("", 1, 1, NONE)


def conformable(a: Unit, b: Unit) -> bool:
    """Whether values in the two units are of one kind: same dimension, and not a torque against an energy."""
    return a.dimension == b.dimension and not (a.tag and b.tag and a.tag != b.tag)
