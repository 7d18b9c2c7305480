"""Parts put together about their common mass centre, then once more in the principal frame."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.lump import (
    IDENTITY,
    NOTHING,
    Lump,
    added,
    less,
    outer,
    plus,
    product,
    scaled,
    times,
    turned,
)
from dynamics_cli.inertia.principal import principal
from dynamics_cli.inertia.rotation import departure
from dynamics_cli.inertia.spread import Spread, bounded, in_many_digits, plain, spread_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.lump import Matrix, Vector
    from dynamics_cli.inertia.parts import Leaf, Walk


class Composed:
    """An assembly as one lump in its own frame, its principal second moments, and the lumps of its leaves."""

    def __init__(self, walk: "Walk", lump: Lump, spread: Spread, pieces: "list[Lump]", *, asked: bool) -> None:
        self.sloped = bool(walk.width)
        # whether its numbers are floats, of which nothing has to be taken off
        self.bare = walk.width is None and type(lump.mass) is float
        self.unbounded = asked and walk.width is None
        self.leaves = walk.leaves
        self.origins = walk.origins
        self.lump = lump
        self.spread = spread
        self.pieces = pieces


def composed(walk: "Walk", *, asked: bool) -> Composed:
    """Put the leaves of a walk together.

    Raises
    ------
    InadmissibleError
        When holes leave no mass, or second moments that no body has.
    """
    leaves = walk.leaves
    base = tuple(plain(x) for x in leaves[0].origin)
    pieces = [_piece(leaf, base, IDENTITY) for leaf in leaves]  # type: ignore[arg-type]
    whole = _sum(pieces)
    centroid = plus(base, whole.centroid)  # type: ignore[arg-type]
    first = spread_of(whole.second)
    if any(not piece.mass > 0.0 for piece in pieces):
        _require_body(whole, first)
    spread = _second_pass(leaves, base, first)  # type: ignore[arg-type]
    lump = Lump(whole.mass, centroid, whole.second)
    placed = [Lump(piece.mass, plus(base, piece.centroid), piece.second) for piece in pieces]  # type: ignore[arg-type]
    return Composed(walk, lump, spread, placed, asked=asked)


def _piece(leaf: "Leaf", base: "Vector", frame: "Matrix") -> Lump:
    """A leaf from `base` in axes that are the rows of `frame`; holes are negative."""
    away = less(leaf.origin, base)
    rotation = leaf.rotation
    if frame is not IDENTITY:
        away = times(frame, away)
        rotation = frame if rotation is IDENTITY else product(frame, rotation)
    middle = leaf.lump.centroid
    centroid = plus(away, middle if rotation is IDENTITY else times(rotation, middle))
    second = turned(leaf.lump.second, rotation)
    if leaf.sign > 0.0:
        return Lump(leaf.lump.mass, centroid, second)
    return Lump(-leaf.lump.mass, centroid, scaled(-1.0, second))


def _sum(pieces: "list[Lump]") -> Lump:
    """All pieces as one, about a point near their mass centre: a mere number, so that it brings no rounding with it."""
    near = _near(pieces)
    mass, first, second = 0.0, (0.0, 0.0, 0.0), NOTHING
    for piece in pieces:
        d = less(piece.centroid, near)
        mass = piece.mass + mass
        first = plus(first, (piece.mass * d[0], piece.mass * d[1], piece.mass * d[2]))
        second = added(second, added(piece.second, outer(piece.mass, d)))
    require(
        mass > 0.0,
        "what is cut out weighs as much as all that is there: {0:.6g} kg are left",
        mass,
        code="no-mass",
        hint="check sizes and densities of the holes",
    )
    rest = (first[0] / mass, first[1] / mass, first[2] / mass)
    return Lump(mass, plus(near, rest), added(second, outer(-mass, rest)))


def _near(pieces: "list[Lump]") -> "Vector":
    """A point within rounding of the mass centre."""
    masses = [plain(piece.mass) for piece in pieces]
    require(max(masses) > 0.0, "nothing is there that something could be cut out of", code="no-mass")
    total = sum(masses)
    if not total > 0.0:
        return (0.0, 0.0, 0.0)
    x, y, z = (
        sum(mass * plain(piece.centroid[k]) for mass, piece in zip(masses, pieces, strict=True)) / total
        for k in range(3)
    )
    return x, y, z


def _require_body(whole: Lump, spread: Spread) -> None:
    """Refuse second moments below zero by more than rounding: a hole reached beyond its body."""
    least = spread.seconds[2]
    room = 2.0 * getattr(least, "error", 0.0) + 64.0 * 2.0**-53 * abs(plain(spread.seconds[0]))
    require(
        plain(least) >= -room,
        "the second moment {0:.6g} kg·m² is left along an axis: a hole is larger than its body or lies outside",
        least,
        code="hole",
        hint="check positions and sizes of what is subtracted",
    )


def _second_pass(leaves: "list[Leaf]", base: "Vector", first: Spread) -> Spread:
    """Principal second moments composed in the principal frame, where those of a needle keep their digits."""
    frame = first.axes
    if in_many_digits(frame):
        return first
    if sorted(abs(x) for row in frame for x in row) == [0.0] * 6 + [1.0] * 3:
        return first
    whole = _sum([_piece(leaf, base, frame) for leaf in leaves])
    matrix = tuple(tuple(plain(x) for x in row) for row in whole.second)
    found = principal(matrix)  # type: ignore[arg-type]
    seconds = found.seconds
    if not any(hasattr(x, "slopes") for row in whole.second for x in row):
        return Spread(seconds, product(found.axes, frame), first.degeneracy)
    seconds = bounded(whole.second, seconds, found.vectors)
    # axes that are not quite orthonormal stretch every eigenvalue by no more than this (Ostrowski)
    stretch = 3.0 * departure(frame) + 4.0 * 2.0**-53
    seconds = tuple(type(x)(x.value, x.error + stretch * abs(x.value), x.slopes) for x in seconds)  # type: ignore[attr-defined, call-arg, assignment]
    return Spread(seconds, product(found.axes, frame), first.degeneracy)
