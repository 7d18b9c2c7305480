"""Peaks of rise laws, where they are, and how smooth the laws are."""

from math import inf

from dynamics_cli.cam.laws.normalised import Law, Piece
from dynamics_cli.numerics.roots import bisected
from dynamics_cli.numerics.tracked import Tracked

DERIVATIVES = ("lift", "velocity", "acceleration", "jerk", "rate of jerk")
STILL = 2.0**-53
# a slope below this share of the greatest is rounding
NOISE = 1e-13


def extremes(law: Law, order: int) -> "list[tuple[float, float]]":
    """(x, value) of every stationary point and one-sided end of that derivative (0 to 3), piece by piece.

    `order`: which derivative: 0 for f, 3 for jerk. Returns places and values; a jump gives two values at one place.

    Sign changes of the next derivative between the places of a grid, 16 to a piece (64 where a law is not monotone),
    bisected to the last bit.
    """
    if order not in law.known:
        law.known[order] = _extremes(law, order)
    return law.known[order]  # type: ignore[no-any-return]


def _extremes(law: Law, order: int) -> "list[tuple[float, float]]":
    extremes: list[tuple[float, float]] = []
    turned: dict[tuple[int, float], list[float]] = {}
    for piece in law.pieces:
        # Measured from its own end, a piece and its mirror image turn at the same places.
        ends = piece.ends
        key = (id(piece.shape), ends[0])
        if key not in turned:
            turned[key] = _turning(piece, order, *ends, 16 if law.monotone else 64)
        extremes.extend(
            (1.0 - t if piece.far else t, law.upright(piece, t, order)[order]) for t in (ends[0], *turned[key], ends[1])
        )
    return sorted(extremes)


def _turning(piece: Piece, order: int, low: float, high: float, steps: int) -> "list[float]":
    """Where the next derivative changes its sign between places of a grid; a sign within rounding does not count."""

    def slope(t: float) -> float:
        return piece.shape(t, order + 1)[order + 1]  # type: ignore[no-any-return]

    grid = [low + (high - low) * i / steps for i in range(steps + 1)]
    values = [slope(t) for t in grid]
    least = NOISE * max(map(abs, values))
    turning = [t for t, value in zip(grid[1:-1], values[1:-1], strict=True) if value == 0.0]
    for start, end, a, b in zip(grid, grid[1:], values, values[1:], strict=False):
        if a * b < 0.0 and max(abs(a), abs(b)) > least:
            turning.append(_settled(piece, order, bisected(slope, start, end)))
    return sorted(turning)


def _settled(piece: Piece, order: int, t: float) -> float:
    """The plain fraction beside t, where the curve is too flat for bisection to find it."""
    plain = round(t * 64.0) / 64.0
    at_plain, at_t = (piece.shape(u, order)[order] for u in (plain, t))
    return plain if abs(plain - t) < 1e-3 and abs(at_plain - at_t) <= 4e-16 * abs(at_t) else t


def peak(law: Law, order: int, step: int = 1) -> tuple[float, float]:
    """Maximum magnitude of that derivative, infinite where one below it jumps, and its first place, or last (-1)."""
    key = ("peak", order, step)
    if key not in law.known:
        law.known[key] = _peak(law, order, step)
    return law.known[key]  # type: ignore[no-any-return]


def _peak(law: Law, order: int, step: int) -> tuple[float, float]:
    values = extremes(law, order)[::step]
    top = max(abs(value) for _, value in values)
    # Equal peaks differ in their last bits; the first of them is named.
    place = next(x for x, value in values if abs(value) >= top * (1.0 - 1e-12))
    for x in (0.0, *law.breaks, 1.0)[::step]:
        if any(jump(law, x, below) for below in range(order)):
            return inf, x
    return top, place


def errors_of(piece: Piece, t: float, off: float, derivatives: int) -> "list[float]":
    """Rounding error bounds of a piece and its derivatives at a place that is off by so much."""
    return [number.error for number in piece.shape(Tracked(t, off, ()), derivatives)]


def value_error(law: Law, x: float, order: int) -> float:
    """Error bound of a derivative's extremum at x, as `extremes` gives it: the larger of both sides of a joint.

    Its rounding there, and that the function moves by less than a rounding of its size between distinct places.
    """
    bound = 0.0
    for piece in law.pieces:
        if piece.low <= x <= piece.high:
            t = min(max(1.0 - x if piece.far else x, piece.ends[0]), piece.ends[1])
            # a place within a rounding is equivalent, and an end may be rounded
            error = errors_of(piece, t, 4.0 * STILL * t, order)[order]
            value = abs(law.upright(piece, t, order)[order])
            bound = max(bound, error + 3.0 * STILL * value)
    return bound


def peak_bound(law: Law, order: int) -> float:
    """Bound of the error of the peak of a derivative, as a share of it."""
    if ("bound", order) not in law.known:
        law.known["bound", order] = _peak_bound(law, order)
    return law.known["bound", order]  # type: ignore[no-any-return]


def _peak_bound(law: Law, order: int) -> float:
    values = extremes(law, order)
    top = max(abs(value) for _, value in values)
    if not top:
        return 0.0
    # of peaks equal within rounding any may be the true one
    alike = {x for x, value in values if abs(value) >= top * (1.0 - 1e-9)}
    return max(value_error(law, x, order) for x in alike) / top


def jump(law: Law, x: float, order: int) -> float:
    """How much that derivative jumps at x, from rest at an end; zero where it is only rounding."""
    if (x == 0.0 and not law.rests[0]) or (x == 1.0 and not law.rests[1]):
        return 0.0
    before = 0.0 if x == 0.0 else _at_end(law, next(piece for piece in law.pieces if piece.high == x), order, 1)
    rest = 0.0 if order else law.total
    after = rest if x == 1.0 else _at_end(law, next(piece for piece in law.pieces if piece.low == x), order, 0)
    step = after - before
    return step if step and abs(step) > 1e-11 * _size(law, order) else 0.0


def _size(law: Law, order: int) -> float:
    """The size of a derivative: the greatest of its values at 33 places."""
    if ("size", order) not in law.known:
        law.known["size", order] = max(abs(law.at(i / 32.0, order)[order]) for i in range(33))
    return law.known["size", order]  # type: ignore[no-any-return]


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
