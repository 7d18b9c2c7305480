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

    length: Annotated[Size, "Its present length, e.g. 120 mm."]


class Group(Choice):
    """How the springs of a group are connected."""

    __slots__ = ()
    names = ("parallel", "series")


@record
class Member:
    """One spring of a group."""

    stiffness: Annotated[Stiffness, "Its stiffness [N/m]."]
    force: Annotated[Force, "Its tension; negative where it pushes [N]."]
    stretch: Annotated[Length, "Its stretch [m]."]
    energy: Annotated[PotentialEnergy, "Energy stored in it [J]."]


@record
class Spring:
    """State of a spring, and the forces on its ends."""

    state: Annotated[Text, "Stretched, compressed or at its free length."]
    tension: Annotated[Force, "Tension; negative where the spring pushes [N]."]
    spring_force: Annotated[Force | None, "Force of the spring alone, beside a damper [N]."]
    damper_force: Annotated[Force | None, "Force of the damper alone [N]."]
    stiffness: Annotated[Stiffness | None, "Stiffness of the group [N/m]."]
    length: Annotated[Size, "Length [m]."]
    stretch: Annotated[Length, "Length less free length [m]."]
    energy: Annotated[PotentialEnergy, "Energy stored [J]."]
    first_force: Annotated[ForceVector | None, "Force on the body at the first end [N]."]
    second_force: Annotated[ForceVector | None, "Force on the body at the second end [N]."]
    members: Annotated[tuple[Member, ...] | None, "The springs of a group."]


def spring(
    *,
    place: Annotated[Ends | Span, "Two ends, or the length."],
    stiffness: Annotated[
        Stiffness | tuple[Stiffness, ...], "Stiffness, or those of the springs of a group, e.g. 20 N/mm."
    ],
    free_length: Annotated[Size, "Length without force, of the whole group, e.g. 100 mm."],
    group: Annotated[
        Group | None, "How several springs are connected: parallel (side by side) or series (end to end)."
    ] = None,
    damping: Annotated[Damping | None, "Damping of a damper beside it, e.g. 50 N*s/m."] = None,
    rate: Annotated[Speed | None, "Rate at which it lengthens, e.g. 0.2 m/s."] = None,
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
        When both ends coincide, when only one of damping and rate is given, when several stiffnesses come without their
        connection, or when a spring of the group has no stiffness.

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
        "the force of a damper needs both damping and rate",
        code="missing",
        hint='for example --damping "50 N*s/m" --rate "0.2 m/s"',
    )
    line = None
    if isinstance(place, Ends):
        a, b = place.first_end, place.second_end
        line = difference(b, a)
        length = norm(line)
        require(plain(length) > 0.0, "both ends coincide: the spring has no direction", code="no-length",
                hint="give two different points")  # fmt: skip
        squares = [term for p, q in zip(a, b, strict=True) for term in ((q, q), (-2.0, p, q), (p, p))]
        stretch = sum_of_products(*squares, (-1.0, free_length, free_length)) / (length + free_length)
    else:
        length = place.length
        require(plain(length) > 0.0, "the length is zero", code="no-length", hint="give the length of the spring")
        stretch = sum_of_products((length,), (-1.0, free_length))
    several = stiffness if isinstance(stiffness, tuple) else (stiffness,)
    whole = _grouped(several, group)
    spring_force = whole * stretch
    damper_force = None if damping is None or rate is None else damping * rate
    tension = spring_force if damper_force is None else spring_force + damper_force
    first = None if line is None else tuple(tension * component / length for component in line)
    sign = plain(stretch)
    return Spring(
        state="stretched" if sign > 0.0 else "compressed" if sign < 0.0 else "at its free length",
        tension=tension,
        spring_force=None if damper_force is None else spring_force,
        damper_force=damper_force,
        stiffness=whole if len(several) > 1 else None,
        length=length,
        stretch=stretch,
        energy=0.5 * spring_force * stretch,
        first_force=first,  # type: ignore[arg-type]
        second_force=None if first is None else tuple(0.0 - component for component in first),  # type: ignore[arg-type]
        members=_members(several, group, spring_force, stretch) if len(several) > 1 else None,
    )


def _grouped(several: "tuple[float, ...]", group: "Group | None") -> float:
    """The stiffness of the group."""
    require(
        (group is None) == (len(several) == 1),
        "{count} stiffnesses are given, but not how the springs are connected"
        if len(several) > 1
        else "a group has only one spring",
        code="group",
        hint="add --group parallel (side by side) or --group series (end to end)"
        if len(several) > 1
        else 'give several stiffnesses, such as --stiffness "20, 30 N/mm"',
        count=str(len(several)),
    )
    require(
        all(plain(value) > 0.0 for value in several) or group is None,
        "a spring of the group has no stiffness",
        code="no-stiffness",
        hint="give stiffnesses above zero",
    )
    if group == "series":
        return 1.0 / sum(1.0 / value for value in several)
    return sum(several[1:], several[0])


def _members(several: "tuple[float, ...]", group: "Group | None", pull: float, stretch: float) -> "tuple[Member, ...]":
    if group == "series":
        return tuple(Member(k, pull, pull / k, 0.5 * pull * (pull / k)) for k in several)
    return tuple(Member(k, k * stretch, stretch, 0.5 * k * stretch * stretch) for k in several)
