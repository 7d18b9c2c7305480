"""The task `shaft`: bearing loads of a rotor that is off its axis or skewed on its shaft."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import atan2, cos, hypot, sin
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Coordinate,
    CoupleUnbalance,
    Eccentricity,
    Force,
    Inertia,
    Mass,
    ShaftSpeed,
    Size,
    Torque,
    Unbalance,
)
from dynamics_cli.records import record
from dynamics_cli.spin.gyro import check_body


@record
class Shaft:
    """What a rotor out of line does to its bearings; angles are in the shaft, from the eccentricity."""

    force: Annotated[Force, "Centrifugal force of the eccentricity [N]."]
    couple: Annotated[Torque, "Couple of the skew, turning with the shaft [N*m]."]
    left_load: Annotated[Force, "Load on the left bearing, turning with the shaft [N]."]
    left_angle: Annotated[Angle, "Its direction [rad]."]
    right_load: Annotated[Force, "Load on the right bearing [N]."]
    right_angle: Annotated[Angle, "Its direction [rad]."]
    unbalance: Annotated[Unbalance, "Mass times eccentricity [kg*m]."]
    couple_unbalance: Annotated[CoupleUnbalance, "Couple of the skew by the speed squared [kg*m^2]."]


def shaft(
    *,
    mass: Annotated[Mass, "Mass of the rotor, e.g. 10 kg."],
    speed: Annotated[ShaftSpeed, "Speed of the shaft, e.g. 3000 rpm."],
    span: Annotated[Size, "From the left bearing to the right one, e.g. 400 mm."],
    position: Annotated[Coordinate, "From the left bearing to the rotor's centre; it may be overhung, e.g. 150 mm."],
    eccentricity: Annotated[Eccentricity, "From the shaft's axis to the centre of mass, e.g. 50 um."] = 0.0,
    skew: Annotated[Angle, "Angle between the rotor's axis and the shaft, e.g. 2 deg."] = 0.0,
    axial: Annotated[Inertia | None, "Of a skewed rotor, moment of inertia about its axis, e.g. 0.2 kg*m^2."] = None,
    transverse: Annotated[Inertia | None, "And across it, about its centre, e.g. 0.1 kg*m^2."] = None,
    skew_direction: Annotated[
        Angle, "Where the right end of the rotor's axis leans, from the eccentricity, e.g. 90 deg."
    ] = 0.0,
) -> Shaft:
    """Loads on two bearings from a rotor that is off its axis, skewed on its shaft, or both; the shaft is rigid.

    Equation
    --------
    F = m·e·Ω²; couple (C − A)·Ω²·sin β·cos β.

    Returns
    -------
    Shaft
        Loads that turn with the shaft, without the weight.

    Raises
    ------
    InadmissibleError
        When the span is not above zero, the moments are missing or of no body, or nothing is out of line.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 8.8 and 15.3.

    Examples
    --------
    >>> from math import pi
    >>> given = {"mass": 10.0, "speed": 100.0 * pi, "span": 0.4, "position": 0.15}
    >>> round(shaft(**given, skew=pi / 90.0, axial=0.2, transverse=0.1).couple, 9)
    344.234400135
    """
    require(span > 0.0, "the bearings are at one place", code="span", hint="give the distance between them")
    slant = 0.0 * speed
    require((axial is None) == (transverse is None), "a skewed rotor needs both its moments of inertia", code="missing",
            hint="give --axial and --transverse")  # fmt: skip
    require(plain(skew) == 0.0 or axial is not None, "a skew without moments of inertia", code="missing",
            hint="give --axial and --transverse")  # fmt: skip
    if axial is not None and transverse is not None:
        check_body(axial, transverse)
        slant = (axial - transverse) * sin(skew) * cos(skew)
    require(
        plain(eccentricity) != 0.0 or plain(slant) != 0.0, "nothing is out of line: the bearings carry the weight only",
        code="in-line", hint="give --eccentricity, or --skew with the two moments of inertia",
    )  # fmt: skip
    square = speed * speed
    static = mass * eccentricity
    share = position / span
    along, across = slant / span * cos(skew_direction), slant / span * sin(skew_direction)
    left = (static * (1.0 - share) + along, across)
    right = (static * share - along, -across)
    return Shaft(
        force=static * square,
        couple=abs(slant) * square,
        left_load=_size(left) * square,
        left_angle=_direction(left),
        right_load=_size(right) * square,
        right_angle=_direction(right),
        unbalance=static,
        couple_unbalance=abs(slant),
    )


def _size(part: "tuple[float, float]") -> float:
    if plain(part[0]) == 0.0 and plain(part[1]) == 0.0:
        return 0.0 * part[0]
    return hypot(part[0], part[1])


def _direction(part: "tuple[float, float]") -> float:
    if plain(part[0]) == 0.0 and plain(part[1]) == 0.0:
        return 0.0 * part[0]
    return atan2(part[1], part[0])
