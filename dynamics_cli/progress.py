"""How far a long calculation is: physics says so here, and who shows it is set by the core.

Without anyone who shows it, saying so costs nothing.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    Shown = Callable[[float, str], "Going"]


class Going:
    """Counts work done; called with the amount so far."""

    def __enter__(self) -> "Callable[[float], None]":
        """Begin."""
        return self._done

    def __exit__(self, *_: object) -> None:
        """End."""

    def _done(self, amount: float) -> None:
        pass


_shown: "list[Shown]" = [lambda size, what: Going()]


def going(size: float, what: str) -> Going:
    """A calculation of so much work, `what` being counted."""
    return _shown[0](size, what)


def show(by: "Shown") -> None:
    """Let all that follows be shown by this."""
    _shown[0] = by
