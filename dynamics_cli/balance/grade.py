"""Balance grades: the residual unbalance that a grade permits, and the grade that a measured unbalance reaches."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, maximum, minimum
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    Annotated,
    BalanceGrade,
    Distance,
    Eccentricity,
    Mass,
    Ratio,
    ShaftSpeed,
    Unbalance,
)
from dynamics_cli.records import Advice, record

# Shares of the planes are kept within these between the bearings.
LEAST, MOST = 0.3, 0.7


@record
class Permitted:
    """What a balance grade permits."""

    eccentricity: Annotated[Eccentricity, "Permissible specific unbalance e_per [m]."]
    unbalance: Annotated[Unbalance, "Permissible residual unbalance U_per [kg·m]."]
    first_unbalance: Annotated[Unbalance | None, "Share of the first plane [kg·m]."]
    second_unbalance: Annotated[Unbalance | None, "Share of the second plane [kg·m]."]
    reached: Annotated[BalanceGrade | None, "Grade that the measured unbalance reaches [m/s]."]
    permitted: Annotated[bool | None, "Whether the measured unbalance is permitted [-]."]
    usage: Annotated[Ratio | None, "Measured over permitted unbalance [-]."]
    advice: tuple[Advice, ...] = ()


def grade(
    *,
    grade: Annotated[BalanceGrade, "The grade, e.g. G6.3."],
    speed: Annotated[ShaftSpeed, "Highest service speed, e.g. 3000 rpm."],
    mass: Annotated[Mass, "Mass of the rotor, e.g. 120 kg."],
    first_distance: Annotated[Distance | None, "First plane (or bearing) to the centre of mass, e.g. 200 mm."] = None,
    second_distance: Annotated[Distance | None, "Centre of mass to the second plane, e.g. 300 mm."] = None,
    measured: Annotated[Unbalance | None, "Measured unbalance, to be compared, e.g. 1800 g*mm."] = None,
) -> Permitted:
    """Residual unbalance permitted by a balance grade, its shares by plane, and the grade reached.

    Equation
    --------
    e_per = G/Ω, U_per = e_per·M; planes between the bearings U_A = U_per·L_B/L, kept within 0.3 to 0.7 of the whole.

    Returns
    -------
    Permitted
        Permissible eccentricity and unbalance, shares of the planes, grade reached.

    Raises
    ------
    InadmissibleError
        When the speed or the mass is zero, or one distance is given without the other.

    References
    ----------
    ISO 21940-11, rigid rotors: grades and shares of the planes.

    Examples
    --------
    >>> round(grade(grade=0.0063, speed=314.1592653589793, mass=120.0).unbalance * 1e6, 4)
    2406.4227
    """
    require(absolute(speed) > 0.0, "a rotor at rest has no balance grade", code="at-rest")
    require(mass > 0.0, "the mass of the rotor is zero", code="no-mass")
    require(
        (first_distance is None) == (second_distance is None),
        "the shares of the planes need both distances from the centre of mass",
        code="missing",
        hint="give --first-distance and --second-distance",
    )
    off = grade / absolute(speed)
    most = off * mass
    first = second = None
    advice: list[Advice] = []
    if first_distance is not None and second_distance is not None:
        span = first_distance + second_distance
        require(span > 0.0, "the two planes coincide", code="same-plane", hint="give two different planes")
        share = second_distance / span
        kept = minimum(maximum(share, LEAST), MOST)
        first, second = most * kept, most * (1.0 - kept)
        if single(share) and plain(kept) != plain(share):
            text = "the share of the first plane would be {share}; it is kept within 0.3 to 0.7"
            advice.append(Advice("share", worded(text, share=(share, Ratio)), severity="note"))
    known = measured is not None
    return Permitted(
        eccentricity=off,
        unbalance=most,
        first_unbalance=first,
        second_unbalance=second,
        reached=measured / mass * absolute(speed) if known else None,  # type: ignore[operator]
        permitted=measured <= most if known else None,  # type: ignore[operator]
        usage=measured / most if known else None,  # type: ignore[operator]
        advice=tuple(advice),
    )
