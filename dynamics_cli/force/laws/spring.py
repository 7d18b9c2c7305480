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
from dynamics_cli.records import Choice, record


@record
class Ends:
    """A spring between two points."""

    first_end: Annotated[LoadPoint, "Where one end is, e.g. 0, 0 m."]
    second_end: Annotated[LoadPoint, "Where the other end is, e.g. 0.3, 0.4 m."]


@record
class Span:
    """A spring by its length."""

    length: Annotated[Size, "Its length now, e.g. 120 mm."]


class Group(Choice):
    """How several springs are put together."""

    __slots__ = ()
    names = ("parallel", "series")


@record
class Member:
    """One spring of a group."""

    stiffness: Annotated[Stiffness, "Its stiffness [N/m]."]
    force: Annotated[Force, "What it pulls with; negative where it pushes [N]."]
    stretch: Annotated[Length, "Its stretch [m]."]
    energy: Annotated[PotentialEnergy, "Energy stored in it [J]."]


@record
class Spring:
    """What a spring does to its ends."""

    state: Annotated[Text, "Stretched, compressed or at its free length."]
    tension: Annotated[Force, "What it pulls its ends together with; negative where it pushes [N]."]
    spring_force: Annotated[Force | None, "The spring's part of it, beside a damper [N]."]
    damper_force: Annotated[Force | None, "The damper's part [N]."]
    stiffness: Annotated[Stiffness | None, "Stiffness of the group [N/m]."]
    length: Annotated[Size, "Its length [m]."]
    stretch: Annotated[Length, "Its length beyond the free one [m]."]
    energy: Annotated[PotentialEnergy, "Energy stored [J]."]
    first_force: Annotated[ForceVector | None, "Force on the body at the first end [N]."]
    second_force: Annotated[ForceVector | None, "Force on the body at the second end [N]."]
    members: Annotated[tuple[Member, ...] | None, "The springs of a group."]


def spring(
    *,
    place: Annotated[Ends | Span, "Two ends, or the length."],
    stiffness: Annotated[Stiffness | tuple[Stiffness, ...], "Force per length, of a group of each, e.g. 20 N/mm."],
    free_length: Annotated[Size, "Length without force, of a group that of the whole, e.g. 100 mm."],
    group: Annotated[Group | None, "How several springs are put together: side by side, or one behind another."] = None,
    damping: Annotated[Damping | None, "Of a damper beside it, e.g. 50 N*s/m."] = None,
    rate: Annotated[Speed | None, "Speed at which it lengthens, e.g. 0.2 m/s."] = None,
) -> Spring:
    """Force and energy of a linear spring or a group, with a damper beside it, between two points or at a length.

    Equation
    --------
    T = k·(ℓ − ℓ₀) + c·dℓ/dt along the line of the ends; ℓ − ℓ₀ = (ℓ² − ℓ₀²)/(ℓ + ℓ₀), ℓ² and ℓ₀² as typed. Parallel
    springs k = Σkᵢ, springs in series 1/k = Σ1/kᵢ.

    Returns
    -------
    Spring
        Tension, stretch, energy, and with two ends the forces on them.

    Raises
    ------
    InadmissibleError
        When both ends are one point, of damping and rate only one is given, a group is not said to be parallel or in
        series, or has a spring without stiffness.

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
    several = stiffness if isinstance(stiffness, tuple) else (stiffness,)
    whole = _grouped(several, group)
    pull = whole * stretch
    drag = None if damping is None or rate is None else damping * rate
    tension = pull if drag is None else pull + drag
    first = None if way is None else tuple(tension * part / length for part in way)
    sign = plain(stretch)
    return Spring(
        state="stretched" if sign > 0.0 else "compressed" if sign < 0.0 else "at its free length",
        tension=tension,
        spring_force=None if drag is None else pull,
        damper_force=drag,
        stiffness=whole if len(several) > 1 else None,
        length=length,
        stretch=stretch,
        energy=0.5 * pull * stretch,
        first_force=first,  # type: ignore[arg-type]
        second_force=None if first is None else tuple(0.0 - part for part in first),  # type: ignore[arg-type]
        members=_members(several, group, pull, stretch) if len(several) > 1 else None,
    )


def _grouped(several: "tuple[float, ...]", group: "Group | None") -> float:
    """The stiffness of the group."""
    require(
        (group is None) == (len(several) == 1),
        "{count} stiffnesses, and not how the springs are put together"
        if len(several) > 1
        else "a group of one spring",
        code="group",
        hint="add --group parallel (side by side) or --group series (one behind another)"
        if len(several) > 1
        else 'give several, such as --stiffness "20, 30 N/mm"',
        count=str(len(several)),
    )
    require(all(plain(one) > 0.0 for one in several) or group is None, "a spring of the group has no stiffness",
            code="no-stiffness", hint="give each above zero")  # fmt: skip
    if group == "series":
        return 1.0 / sum(1.0 / one for one in several)
    return sum(several[1:], several[0])


def _members(several: "tuple[float, ...]", group: "Group | None", pull: float, stretch: float) -> "tuple[Member, ...]":
    if group == "series":
        return tuple(Member(one, pull, pull / one, 0.5 * pull * (pull / one)) for one in several)
    return tuple(Member(one, one * stretch, stretch, 0.5 * one * stretch * stretch) for one in several)
