"""The curve interface that fitting and its proof use."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Protocol

    from dynamics_cli.numerics.discs import Disc

    class Path(Protocol):
        """A closed curve of smooth pieces over one parameter, with enclosures of itself and of its acceleration.

        `starts` and `ends` are arrays, one place for each piece; `still` says which pieces are circles that run against
        `turn`, `straight` which are always drawn as lines. Refusals name the `parameter`; `sharp` is their hint where
        the acceleration has no bound.
        """

        starts: Any
        ends: Any
        still: Any
        straight: Any
        turn: float
        parameter: str
        sharp: str

        def at(self, theta: Any, piece: int | None = None) -> tuple[Any, ...]:
            """Point, unit direction of travel and speed, five arrays."""

        def on(self, piece: int) -> "OnPiece":
            """The curve seen from within one piece."""

        def points(self, theta: Any, piece: int) -> tuple[Disc, Disc]:
            """Discs that hold the coordinates."""

        def acceleration(self, theta: Any, half: Any, piece: int) -> tuple[Any, Any]:
            """Bounds of |z″| and |z′| on cells of middle `theta` and half width `half`."""


class OnPiece:
    """A curve seen from within one of its pieces, which is all that fitting needs."""

    def __init__(self, path: "Path", piece: int) -> None:
        self.path = path
        self.piece = piece

    def at(self, theta: "Any") -> "tuple[Any, ...]":
        """Point, unit direction and speed, from within the piece."""
        return self.path.at(theta, self.piece)
