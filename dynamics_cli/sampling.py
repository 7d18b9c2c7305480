"""What the inputs of a calculation are: samples of thousands, or measurements with standard deviations.

Of samples the spread drowns rounding: a second pass in many digits is then no use. What draws samples says so; what
would answer more slowly to state a bound asks. What physics would solve anew for every sample it may solve over their
spread once: the first array of a calculation is a fair sample of its inputs. Of measurements, physics may ask how far a
number of its is known.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_drawings: "list[Drawing]" = []
_deviations: "tuple[float, ...]" = ()


class Drawing:
    """While inside, answers are samples of one calculation.

    `kept` is what physics solved once for all of them, `missed` what they are off by for that, in their deviations.
    Where samples are expensive physics states their cost: `spent` so far, and what the next would be.
    """

    def __init__(self) -> None:
        self.kept: dict[Any, Any] = {}
        self.missed = 0.0
        self.spent = self.once = self.each = 0.0

    def __enter__(self) -> "Drawing":
        """Begin."""
        _drawings.append(self)
        return self

    def __exit__(self, *_: object) -> None:
        """End."""
        _drawings.pop()


def drawing() -> bool:
    """Whether answers are samples now."""
    return bool(_drawings)


def kept() -> "dict[Any, Any]":
    """What was solved once for all samples of this calculation; only while drawing."""
    return _drawings[-1].kept


def missed(error: float) -> None:
    """State what samples are off by, in their deviations; only while drawing."""
    _drawings[-1].missed = max(_drawings[-1].missed, error)


def cost(once: float, each: float, cases: int) -> None:
    """State what samples have cost, in seconds of a usual processor: for all of a call, and for each case in it.

    Counted, not measured: how many samples an answer takes must not depend on the machine. Only while drawing.
    """
    now = _drawings[-1]
    now.once, now.each = once, each
    now.spent += once + each * cases


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
