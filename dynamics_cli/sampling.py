"""Whether answers are samples of thousands, whose spread drowns rounding: a second pass in many digits is then no use.

What draws samples says so; what would answer more slowly to state a bound asks.
"""

_drawing = 0


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
