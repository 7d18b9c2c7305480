"""Two-plane balance of a rigid rotor whose unbalances are known, and the loads on its bearings."""

from dynamics_cli.balance.phasors import Phasor, polar, scale_of, total
from dynamics_cli.errors import require
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, CoupleUnbalance, Force, Length, ShaftSpeed
from dynamics_cli.quantities import Unbalance as Amount
from dynamics_cli.records import Check, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

CLOSED = 1e-12


@record
class Unbalance:
    """An unbalance at its place along the shaft."""

    amount: Annotated[Amount, "Mass times radius, e.g. 12 g*mm."]
    angle: Annotated[Angle, "Its angle, e.g. 30 deg."]
    position: Annotated[Length, "Its place along the shaft, e.g. 0.1 m."]


@record
class Bearing:
    """The rotating load on a bearing."""

    position: Annotated[Length, "Place of the bearing [m]."]
    load: Annotated[Force, "Rotating load before balancing [N]."]
    angle: Annotated[Angle | None, "Its angle; none without a load [rad]."]
    balanced: Annotated[Force, "Rotating load after balancing [N]."]


@record
class TwoPlanes:
    """Corrections in two planes."""

    first_unbalance: Annotated[Amount, "Unbalance to add in the first plane [kg·m]."]
    first_angle: Annotated[Angle | None, "Its angle; none of a zero amount [rad]."]
    second_unbalance: Annotated[Amount, "Unbalance to add in the second plane [kg·m]."]
    second_angle: Annotated[Angle | None, "Its angle; none of a zero amount [rad]."]
    static: Annotated[Amount, "Sum of the unbalances [kg·m]."]
    static_angle: Annotated[Angle | None, "Its angle; none of a zero sum [rad]."]
    couple: Annotated[CoupleUnbalance, "Couple of the unbalances about the middle between the planes [kg·m²]."]
    couple_angle: Annotated[Angle | None, "Its angle; none without a couple [rad]."]
    bearings: Annotated[tuple[Bearing, ...] | None, "Bearing loads, when bearings and a speed are given."]
    checks: tuple[Check, ...] = ()


def planes(
    *,
    unbalances: Annotated[Unbalance | tuple[Unbalance, ...], "The unbalances; one may be given by its plain fields."],
    first_plane: Annotated[Length, "Place of the first correction plane, e.g. 0.05 m."],
    second_plane: Annotated[Length, "Place of the second correction plane, e.g. 0.7 m."],
    first_bearing: Annotated[Length | None, "Place of the first bearing, e.g. 0 m."] = None,
    second_bearing: Annotated[Length | None, "Place of the second bearing, e.g. 0.8 m."] = None,
    speed: Annotated[ShaftSpeed | None, "Speed for the bearing loads, e.g. 3000 rpm."] = None,
) -> TwoPlanes:
    """Corrections in two planes that leave a rigid rotor without force and couple.

    Equation
    --------
    U_A = −Σ Uᵢ·(z_B − zᵢ)/(z_B − z_A), U_B = −Σ Uᵢ·(zᵢ − z_A)/(z_B − z_A); a bearing carries its share times Ω².

    Returns
    -------
    TwoPlanes
        Corrections, static and couple parts, bearing loads before and after.

    Raises
    ------
    InadmissibleError
        When no unbalance is given, or both planes or both bearings are at one place, or a bearing or the speed lacks.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 15.3 and 15.4.

    Examples
    --------
    >>> made = planes(unbalances=Unbalance(0.001, 0.0, 0.25), first_plane=0.0, second_plane=1.0)
    >>> made.first_unbalance, made.second_unbalance
    (0.00075, 0.00025)
    """
    those = unbalances if isinstance(unbalances, tuple) else (unbalances,)
    require(len(those) > 0, "no unbalance is given", code="missing")
    require(
        plain(second_plane) != plain(first_plane),
        "both planes are at {place}: one plane cannot hold a couple",
        code="same-plane",
        hint="give two planes that are apart",
        place=(first_plane, Length),
    )
    given = [(polar(one.amount, one.angle), one.position) for one in those]
    parts = _shares(given, first_plane, second_plane)
    corrections = [-total(side) for side in parts]
    scale = scale_of([one for side in parts for one in side])
    places = (first_plane, second_plane)
    static, middle = total(one for one, _ in given), 0.5 * (first_plane + second_plane)
    arms = [one.times(place - middle) for one, place in given]
    couple = total(arms)
    after = [*given, *zip(corrections, places, strict=True)]
    return TwoPlanes(
        first_unbalance=corrections[0].size,
        first_angle=corrections[0].angle_beside(scale),
        second_unbalance=corrections[1].size,
        second_angle=corrections[1].angle_beside(scale),
        static=static.size,
        static_angle=static.angle_beside(scale_of(one for one, _ in given)),
        couple=couple.size,
        couple_angle=couple.angle_beside(scale_of(arms)),
        bearings=_bearings(given, after, (first_bearing, second_bearing), speed),
        checks=_checks(after, middle),
    )


def _shares(given: "list[tuple[Phasor, Any]]", first: "Any", second: "Any") -> "tuple[list[Phasor], list[Phasor]]":
    """What each unbalance puts on two places, as a load on a beam does."""
    span = second - first
    return (
        [one.times((second - place) / span) for one, place in given],
        [one.times((place - first) / span) for one, place in given],
    )


def _bearings(
    before: "list[tuple[Phasor, Any]]",
    after: "list[tuple[Phasor, Any]]",
    places: "tuple[Any, Any]",
    speed: "Any",
) -> "tuple[Bearing, ...] | None":
    first, second = places
    if first is None and second is None and speed is None:
        return None
    require(
        first is not None and second is not None and speed is not None,
        "bearing loads need both bearings and the speed",
        code="missing",
        hint="give --first-bearing, --second-bearing and --speed",
    )
    require(plain(first) != plain(second), "both bearings are at {place}", code="same-bearing", place=(first, Length))
    rows = []
    for place, parts, left in zip(places, _shares(before, *places), _shares(after, *places), strict=True):
        load, rest = total(parts), total(left)
        still = abs(plain(rest.x)) + abs(plain(rest.y)) <= CLOSED * scale_of(left)
        rows.append(
            Bearing(
                position=place,
                load=load.size * speed * speed,
                angle=load.angle_beside(scale_of(parts)),
                balanced=0.0 if still else rest.size * speed * speed,
            )
        )
    return tuple(rows)


def _checks(after: "list[tuple[Phasor, Any]]", middle: "Any") -> "tuple[Check, ...]":
    arms = [one.times(place - middle) for one, place in after]
    checks = []
    for name, parts in (("no force is left", [one for one, _ in after]), ("no couple is left", arms)):
        off = plain(total(parts).size) / (scale_of(parts) or 1.0)
        checks.append(Check(name, off <= CLOSED, off, CLOSED))
    return tuple(checks)
