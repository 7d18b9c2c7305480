"""What the inputs of a calculation are: samples of thousands, or measurements with standard deviations.

Of samples the spread drowns rounding: a second pass in many digits is then no use. What draws samples says so; what
would answer more slowly to state a bound asks. Of measurements, physics may ask how far a number of its is known.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_drawing = 0
_deviations: "tuple[float, ...]" = ()


class Drawing:
    """While inside, answers are samples."""

    def __enter__(self) -> None:
        """Begin."""
        global _drawing
        _drawing += 1

    def __exit__(self, *_: object) -> None:
        """End."""
        global _drawing
        _drawing -= 1


def drawing() -> bool:
    """Whether answers are samples now."""
    return _drawing > 0


class Measured:
    """While inside, the tracked inputs have these standard deviations, in their order."""

    def __init__(self, deviations: "tuple[float, ...]") -> None:
        self.deviations = deviations
        self.outside: tuple[float, ...] = ()

    def __enter__(self) -> None:
        """Begin."""
        global _deviations
        self.outside, _deviations = _deviations, self.deviations

    def __exit__(self, *_: object) -> None:
        """End."""
        global _deviations
        _deviations = self.outside


def deviation(x: "Any") -> float | None:
    """The standard deviation of a tracked number, to first order and for independent inputs; None when not known."""
    slopes = getattr(x, "slopes", ())
    if not _deviations or len(slopes) != len(_deviations):
        return None
    squares: float = sum((slope * std) ** 2 for slope, std in zip(slopes, _deviations, strict=True))
    return float(squares**0.5)
