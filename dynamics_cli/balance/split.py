"""A correction split onto two places: given angles, or the holes of a pattern on either side of it."""

from itertools import product
from math import floor

from dynamics_cli.balance.phasors import Phasor, cross, polar, total
from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import pi_beside
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, BalanceMass, Count, Fraction
from dynamics_cli.records import Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Two places nearer to one line than this cannot hold a correction of any other direction.
FLAT = 1e-9
CLOSED = 1e-12


@record
class Angles:
    """Two places by their angles."""

    first_angle: Annotated[Angle, "Angle of the first place, e.g. 20 deg."]
    second_angle: Annotated[Angle, "Angle of the second place, e.g. 65 deg."]


@record
class Holes:
    """Equally spaced holes."""

    holes: Annotated[Count, "Number of equally spaced holes, e.g. 12."]
    first_hole: Annotated[Angle, "Angle of hole 1; the others follow it."] = 0.0


@record
class Split:
    """The two masses."""

    first_mass: Annotated[BalanceMass, "Mass at the first place [kg]."]
    first_angle: Annotated[Angle, "Angle of the first place [rad]."]
    first_hole: Annotated[int | None, "Number of the first hole [-]."]
    second_mass: Annotated[BalanceMass, "Mass at the second place [kg]."]
    second_angle: Annotated[Angle, "Angle of the second place [rad]."]
    second_hole: Annotated[int | None, "Number of the second hole [-]."]
    residual: Annotated[BalanceMass, "What the masses leave of the correction [kg]."]
    residual_share: Annotated[Fraction, "That over the correction [-]."]
    checks: tuple[Check, ...] = ()


def split(
    *,
    mass: Annotated[BalanceMass, "Mass of the correction at the balancing radius, e.g. 10 g."],
    angle: Annotated[Angle, "Its angle, e.g. 37 deg."],
    places: Annotated[Angles | Holes, "Two angles, or a pattern of holes."],
    stock: Annotated[BalanceMass | None, "Step of the weights in stock, e.g. 0.5 g; without it any mass."] = None,
) -> Split:
    """Split of a correction onto two angles, or onto the two holes beside it.

    Equation
    --------
    m₁ = m·sin(β − φ)/sin(β − α), m₂ = m·sin(φ − α)/sin(β − α).

    Returns
    -------
    Split
        Both masses with their places, and what weights from stock leave.

    Raises
    ------
    InadmissibleError
        When the places lie on one line through the axis, the correction does not lie between them, or there are fewer
        than three holes.

    References
    ----------
    The law of sines.

    Examples
    --------
    >>> made = split(mass=0.01, angle=0.6435011087932844, places=Angles(0.0, 1.5707963267948966))
    >>> round(made.first_mass, 12), round(made.second_mass, 12)
    (0.008, 0.006)
    """
    wanted = polar(mass, angle)
    require(mass > 0.0, "the correction is zero: there is nothing to split", code="zero")
    holes: tuple[int | None, int | None] = (None, None)
    if isinstance(places, Holes):
        first, second, holes = _beside(angle, places)
    else:
        first, second = places.first_angle, places.second_angle
    ways = polar(1.0, first), polar(1.0, second)
    sine = cross(*ways)
    require(
        abs(plain(sine)) > FLAT,
        "the places at {first} and {second} lie on one line through the axis",
        code="one-line",
        hint="give two angles that are neither equal nor opposite",
        first=(first, Angle),
        second=(second, Angle),
    )
    sizes = [cross(wanted, ways[1]) / sine, cross(ways[0], wanted) / sine]
    tiny = CLOSED * plain(mass)
    require(
        min(map(plain, sizes)) >= -tiny,
        "the correction at {angle} does not lie between {first} and {second}: a mass would be negative",
        code="outside",
        hint="give the two places on either side of it",
        angle=(angle, Angle),
        first=(first, Angle),
        second=(second, Angle),
    )
    sizes = [size if plain(size) > tiny else 0.0 * size for size in sizes]
    if stock is not None:
        require(stock > 0.0, "the step of the weights in stock is zero", code="no-step")
        sizes = _from_stock(wanted, ways, sizes, stock)
    left = (total(way.times(size) for way, size in zip(ways, sizes, strict=True)) - wanted).size
    closed = plain(left) / plain(mass)
    return Split(
        first_mass=sizes[0], first_angle=first, first_hole=holes[0],
        second_mass=sizes[1], second_angle=second, second_hole=holes[1],
        residual=left if stock is not None else 0.0, residual_share=left / mass if stock is not None else 0.0,
        checks=() if stock is not None else (Check("both add up to the correction", closed <= CLOSED, closed, CLOSED),),
    )  # fmt: skip


def _beside(angle: float, pattern: Holes) -> "tuple[Any, Any, tuple[int, int]]":
    """The holes on either side of the correction."""
    count = pattern.holes
    require(count >= 3, "{count} holes cannot hold a correction of every direction", code="holes", count=count)
    step = 2.0 * pi_beside(pattern.first_hole) / count
    turn = plain(angle - pattern.first_hole) / plain(step)
    # a correction at a hole, up to rounding, is at that hole
    before = round(turn) if abs(turn - round(turn)) < FLAT else floor(turn)
    one, other = before % count, (before + 1) % count
    return pattern.first_hole + one * step, pattern.first_hole + other * step, (one + 1, other + 1)


def _from_stock(wanted: Phasor, ways: "tuple[Phasor, Phasor]", sizes: "list[Any]", stock: float) -> "list[Any]":
    """The weights next to the exact ones that leave least."""
    near = [(floor(plain(size / stock) + FLAT), floor(plain(size / stock) + FLAT) + 1) for size in sizes]
    best = min(
        product(*near),
        key=lambda counts: plain(
            (total(way.times(n * stock) for way, n in zip(ways, counts, strict=True)) - wanted).size
        ),
    )
    return [n * stock for n in best]
