"""Composition of parts about their common mass centre, then once more in the principal frame."""

from dynamics_cli.errors import require
from dynamics_cli.inertia.bodies.mass_moments import NOTHING, Lump, added, each, outer, scaled, turned
from dynamics_cli.inertia.bodies.principal import principal
from dynamics_cli.inertia.bodies.principal_tracked import (
    Spread,
    bounded,
    determined,
    error_of,
    in_many_digits,
    spread_of,
    tilts_of,
)
from dynamics_cli.numerics.number import is_tracked, plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY, departure, product
from dynamics_cli.numerics.vectors import add, subtract, times
from dynamics_cli.quantities import Inertia, Mass

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.inertia.assembly.parts import Leaf, Walk
    from dynamics_cli.inertia.bodies.mass_moments import Matrix, Vector


class Composed:
    """An assembly as one lump in its own frame, its principal second moments, and the lumps of its leaves."""

    def __init__(self, walk: "Walk", lump: Lump, spread: Spread, pieces: "list[Lump]", *, asked: bool) -> None:
        self.sloped = bool(walk.width)
        # whether its numbers are plain floats
        self.bare = walk.width is None and type(lump.mass) is float
        self.unbounded = asked and walk.width is None
        self.leaves = walk.leaves
        self.origins = walk.origins
        self.lump = lump
        self.spread = spread
        self.pieces = pieces


def composed(walk: "Walk", *, asked: bool) -> Composed:
    """Put the leaves of a walk together.

    Raises InadmissibleError when holes leave no mass, or second moments that no body has.
    """
    leaves = walk.leaves
    base: Vector = tuple(plain(x) for x in leaves[0].origin)  # type: ignore[assignment]
    pieces = [_piece(leaf, base, IDENTITY) for leaf in leaves]
    total = _sum(pieces)
    first = spread_of(total.second)
    if any(not piece.mass > 0.0 for piece in pieces):
        _require_body(first)
    spread = _second_pass(leaves, base, first)
    properties = Lump(total.mass, add(base, total.centroid), total.second)
    placed = [Lump(piece.mass, add(base, piece.centroid), piece.second) for piece in pieces]
    return Composed(walk, properties, spread, placed, asked=asked)


def _piece(leaf: "Leaf", base: "Vector", frame: "Matrix") -> Lump:
    """A body from `base` in axes that are the rows of `frame`; holes are negative."""
    own, rotation, away = leaf.lump, leaf.rotation, subtract(leaf.origin, base)
    if frame is not IDENTITY:
        rotation = frame if rotation is IDENTITY else product(frame, rotation)
        away = times(frame, away)
    centroid = add(away, own.centroid if rotation is IDENTITY else times(rotation, own.centroid))
    mass, second = own.mass, turned(own.second, rotation)
    return Lump(-mass, centroid, scaled(-1.0, second)) if leaf.sign < 0.0 else Lump(mass, centroid, second)


def _sum(pieces: "Sequence[Lump]") -> Lump:
    """All pieces as one, about a plain point near their mass centre, which brings no rounding."""
    near = _near(pieces)
    mass, first, second = 0.0, (0.0, 0.0, 0.0), NOTHING
    for piece in pieces:
        d = subtract(piece.centroid, near)
        mass = piece.mass + mass
        first = add(first, (piece.mass * d[0], piece.mass * d[1], piece.mass * d[2]))
        second = added(second, added(piece.second, outer(piece.mass, d)))
    require(
        mass > 0.0,
        "the holes remove all mass: {mass:6} remains",
        code="no-mass",
        hint="check sizes and densities of the holes",
        mass=(mass, Mass),
    )
    rest = (first[0] / mass, first[1] / mass, first[2] / mass)
    return Lump(mass, add(near, rest), added(second, outer(-mass, rest)))


def _near(pieces: "Sequence[Lump]") -> "Vector":
    """A point within rounding of the mass centre."""
    masses = [plain(piece.mass) for piece in pieces]
    require(max(masses) > 0.0, "there is no body to cut a hole out of", code="no-mass")
    total = sum(masses)
    if not total > 0.0:
        return (0.0, 0.0, 0.0)
    x, y, z = (
        sum(mass * plain(piece.centroid[k]) for mass, piece in zip(masses, pieces, strict=True)) / total
        for k in range(3)
    )
    return x, y, z


def _require_body(spread: Spread) -> None:
    """Refuse second moments below zero by more than rounding: a hole reached beyond its body."""
    least = spread.seconds[2]
    tolerance = 2.0 * getattr(least, "error", 0.0) + 64.0 * 2.0**-53 * abs(plain(spread.seconds[0]))
    require(
        plain(least) >= -tolerance,
        "the holes leave a second moment of {least:6} along an axis: a hole is larger than its body or lies outside it",
        code="hole",
        hint="check positions and sizes of what is subtracted",
        least=(least, Inertia),
    )


def _second_pass(leaves: "Sequence[Leaf]", base: "Vector", first: Spread) -> Spread:
    """Principal second moments composed in the principal frame, where those of a needle keep their digits."""
    frame = first.axes
    if in_many_digits(frame):
        return first
    if sorted(abs(x) for row in frame for x in row) == [0.0] * 6 + [1.0] * 3:
        return first
    total = _sum([_piece(leaf, base, frame) for leaf in leaves])
    matrix = tuple(tuple(plain(x) for x in row) for row in total.second)
    axes = principal(matrix)  # type: ignore[arg-type]
    seconds = axes.seconds
    if not any(is_tracked(x) for row in total.second for x in row):
        return Spread(seconds, product(axes.axes, frame), first.degeneracy)
    seconds = bounded(total.second, seconds, axes.vectors)
    # axes that are not exactly orthonormal change an eigenvalue at most by this factor (Ostrowski)
    stretch = 3.0 * departure(frame) + 4.0 * 2.0**-53
    seconds = tuple(type(x)(x.value, x.error + stretch * abs(x.value), x.slopes) for x in seconds)  # type: ignore[attr-defined, call-arg, assignment]
    axes = principal(matrix, each(error_of, seconds))  # type: ignore[arg-type]
    words = axes.degeneracy if determined(first.degeneracy) else first.degeneracy
    # the product with the frame rounds every component
    tilts = each(lambda tilt: tilt + 4.0 * 2.0**-53, tilts_of(total.second, axes.axes, stretch))
    return Spread(seconds, product(axes.axes, frame), words, tilts)
