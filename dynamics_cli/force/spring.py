"""The task `spring`: force and energy of a spring with a damper between two points."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.exact.typed_products import difference, norm, sum_of_products
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Annotated,
    Damping,
    Force,
    ForceVector,
    Length,
    LoadPoint,
    PotentialEnergy,
    Size,
    Speed,
    Stiffness,
    Text,
)
from dynamics_cli.records import record


@record
class Ends:
    """A spring between two points."""

    first_end: Annotated[LoadPoint, "Where one end is, e.g. 0, 0 m."]
    second_end: Annotated[LoadPoint, "Where the other end is, e.g. 0.3, 0.4 m."]


@record
class Span:
    """A spring by its length."""

    length: Annotated[Size, "Its length now, e.g. 120 mm."]


@record
class Spring:
    """What a spring does to its ends."""

    state: Annotated[Text, "Stretched, compressed or at its free length."]
    tension: Annotated[Force, "What it pulls its ends together with; negative where it pushes [N]."]
    spring_force: Annotated[Force | None, "The spring's part of it, beside a damper [N]."]
    damper_force: Annotated[Force | None, "The damper's part [N]."]
    length: Annotated[Size, "Its length [m]."]
    stretch: Annotated[Length, "Its length beyond the free one [m]."]
    energy: Annotated[PotentialEnergy, "Energy stored [J]."]
    first_force: Annotated[ForceVector | None, "Force on the body at the first end [N]."]
    second_force: Annotated[ForceVector | None, "Force on the body at the second end [N]."]


def spring(
    *,
    place: Annotated[Ends | Span, "Two ends, or the length."],
    stiffness: Annotated[Stiffness, "Force per length, e.g. 20 N/mm."],
    free_length: Annotated[Size, "Its length without force, e.g. 100 mm."],
    damping: Annotated[Damping | None, "Of a damper beside it, e.g. 50 N*s/m."] = None,
    rate: Annotated[Speed | None, "Speed at which it lengthens, e.g. 0.2 m/s."] = None,
) -> Spring:
    """Force and energy of a linear spring, with a damper beside it, between two points or at a length.

    Equation
    --------
    T = k·(ℓ − ℓ₀) + c·dℓ/dt along the line of the ends; ℓ − ℓ₀ = (ℓ² − ℓ₀²)/(ℓ + ℓ₀), ℓ² and ℓ₀² as typed.

    Returns
    -------
    Spring
        Tension, stretch, energy, and with two ends the forces on them.

    Raises
    ------
    InadmissibleError
        When both ends are one point, or of damping and rate only one is given.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 6.7.

    Examples
    --------
    >>> spring(place=Span(0.12), stiffness=2000.0, free_length=0.1).tension
    40.0
    """
    require(
        (damping is None) == (rate is None),
        "a damper's force needs both damping and rate",
        code="missing",
        hint='add --damping "50 N*s/m" --rate "0.2 m/s", or neither',
    )
    way = None
    if isinstance(place, Ends):
        a, b = place.first_end, place.second_end
        way = difference(b, a)
        length = norm(way)
        require(plain(length) > 0.0, "both ends are one point: the spring has no direction", code="no-length",
                hint="give two different points")  # fmt: skip
        squares = [term for p, q in zip(a, b, strict=True) for term in ((q, q), (-2.0, p, q), (p, p))]
        stretch = sum_of_products(*squares, (-1.0, free_length, free_length)) / (length + free_length)
    else:
        length = place.length
        require(plain(length) > 0.0, "the length is zero", code="no-length", hint="give the length of the spring")
        stretch = sum_of_products((length,), (-1.0, free_length))
    pull = stiffness * stretch
    drag = None if damping is None or rate is None else damping * rate
    tension = pull if drag is None else pull + drag
    first = None if way is None else tuple(tension * part / length for part in way)
    sign = plain(stretch)
    return Spring(
        state="stretched" if sign > 0.0 else "compressed" if sign < 0.0 else "at its free length",
        tension=tension,
        spring_force=None if drag is None else pull,
        damper_force=drag,
        length=length,
        stretch=stretch,
        energy=0.5 * pull * stretch,
        first_force=first,  # type: ignore[arg-type]
        second_force=None if first is None else tuple(0.0 - part for part in first),  # type: ignore[arg-type]
    )
