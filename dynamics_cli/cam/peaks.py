"""Peaks of rise laws, where they are, and how smooth the laws are."""

from math import inf

from dynamics_cli.cam.laws import Law, Piece

DERIVATIVES = ("lift", "velocity", "acceleration", "jerk", "rate of jerk")
PEAK_BOUND = 4e-15

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable


def extremes(law: Law, order: int) -> "list[tuple[float, float]]":
    """(x, value) of every stationary point and one-sided end of that derivative (0 to 3), piece by piece.

    Parameters
    ----------
    law : Law
        The law.
    order : int
        Which derivative: 0 for f, 3 for jerk.

    Returns
    -------
    list of (float, float)
        Places and values; a jump gives two values at one place.

    Notes
    -----
    Sign changes of the next derivative, bisected to the last bit. The named laws have at most one half wave in three
    steps of the grid; a pair of stationary points of a free polynomial that falls between two of 64 steps differs from
    its neighbours only by the square of a step.
    """
    if order not in law.extremes:
        law.extremes[order] = _extremes(law, order)
    return law.extremes[order]


def _extremes(law: Law, order: int) -> "list[tuple[float, float]]":
    found: list[tuple[float, float]] = []
    turned: dict[tuple[int, float], list[float]] = {}
    for piece in law.pieces:
        # Measured from its own end, a piece and its mirror image turn at the same places.
        ends = piece.ends
        key = (id(piece.shape), ends[0])
        if key not in turned:
            turned[key] = _turning(piece, order, *ends, 16 if law.monotone else 64)
        found.extend(
            (1.0 - t if piece.far else t, law.upright(piece, t, order)[order]) for t in (ends[0], *turned[key], ends[1])
        )
    return sorted(found)


def _turning(piece: Piece, order: int, low: float, high: float, steps: int) -> "list[float]":
    def slope(t: float) -> float:
        return piece.shape(t, order + 1)[order + 1]  # type: ignore[no-any-return]

    grid = [low + (high - low) * i / steps for i in range(steps + 1)]
    values = [slope(t) for t in grid]
    found = []
    for start, end, a, b in zip(grid, grid[1:], values, values[1:], strict=False):
        if a == 0.0 and start > low:
            found.append(start)
        elif a * b < 0.0:
            found.append(_settled(piece, order, _bisected(slope, start, end, a)))
    return found


def _bisected(slope: "Callable[[float], float]", low: float, high: float, at_low: float) -> float:
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return low
        if (slope(middle) < 0.0) == (at_low < 0.0):
            low = middle
        else:
            high = middle


def _settled(piece: Piece, order: int, t: float) -> float:
    """The plain fraction beside t, where the curve is too flat for bisection to find it."""
    plain = round(t * 64.0) / 64.0
    there, here = (piece.shape(u, order)[order] for u in (plain, t))
    return plain if abs(plain - t) < 1e-3 and abs(there - here) <= 4e-16 * abs(here) else t


def peak(law: Law, order: int) -> tuple[float, float]:
    """Greatest magnitude of that derivative and the first place of it; infinite where one below it jumps."""
    values = extremes(law, order)
    top = max(abs(value) for _, value in values)
    # Equal peaks differ in their last bits; the first of them is named.
    place = next(x for x, value in values if abs(value) >= top * (1.0 - 1e-12))
    for x in (0.0, *law.breaks, 1.0):
        if any(jump(law, x, below) for below in range(order)):
            return inf, x
    return top, place


def jump(law: Law, x: float, order: int) -> float:
    """How much that derivative jumps at x, at ends that rest from rest; zero where it only rounds."""
    if (x == 0.0 and not law.rests[0]) or (x == 1.0 and not law.rests[1]):
        return 0.0
    before = 0.0 if x == 0.0 else _at_end(law, next(piece for piece in law.pieces if piece.high == x), order, 1)
    rest = 0.0 if order else law.total
    after = rest if x == 1.0 else _at_end(law, next(piece for piece in law.pieces if piece.low == x), order, 0)
    step = after - before
    # The size of a derivative is that of its values, or of the one below over a short step where it nearly vanishes.
    scale = max(abs(law.at(i / 32.0, order)[order]) for i in range(33))
    return step if abs(step) > 1e-11 * scale else 0.0


def _at_end(law: Law, piece: Piece, order: int, which: int) -> float:
    """A derivative at the lower (0) or upper (1) end of a piece, by the coordinate the piece is measured in."""
    return law.upright(piece, piece.ends[which ^ piece.far], order)[order]  # type: ignore[no-any-return]


def continuity(law: Law) -> "tuple[int, float | None]":
    """Order of the highest derivative (to 4) continuous with all below it, and where the next first jumps."""
    for order in range(5):
        for x in (0.0, *law.breaks, 1.0):
            if jump(law, x, order):
                return order - 1, x
    return 4, None
