"""The task `gyro`: the gyroscopic torque of a rotor whose axis turns."""

from dynamics_cli.errors import MissingError, require
from dynamics_cli.numerics.elementary import cos, sin
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    AngularImpulse,
    Annotated,
    Force,
    Inertia,
    Mass,
    Ratio,
    ShaftSpeed,
    Size,
    Text,
    Torque,
    TurnRate,
)
from dynamics_cli.records import record

WAYS = [("axial",), ("mass", "gyration"), ("mass", "radius")]
QUARTER = 1.5707963267948966
# A cosine below this is that of a right angle.
RIGHT = 1e-15
# Decimals in other units are rounded on their way to SI.
ROUNDING = 1.0 + 1e-12


@record
class Gyro:
    """What a rotor whose axis turns asks of its bearings."""

    torque: Annotated[Torque, "Torque of the bearings on the rotor; above zero it tips the axis away [N*m]."]
    sense: Annotated[Text, "Which way the rotor pushes its frame."]
    bearing_force: Annotated[Force | None, "Force on each of two bearings, a pair; with their span [N]."]
    simple_torque: Annotated[Torque, "The usual C times spin times precession [N*m]."]
    simple_share: Annotated[Ratio | None, "The usual product over the torque [-]."]
    angular_momentum: Annotated[AngularImpulse, "Angular momentum about the spin axis [N*m*s]."]


def gyro(
    *,
    axial: Annotated[Inertia | None, "Moment of inertia about the spin axis, e.g. 0.03 kg*m^2."] = None,
    transverse: Annotated[
        Inertia | None, "Moment of inertia across the spin axis; not needed at 90 deg, e.g. 0.02 kg*m^2."
    ] = None,
    mass: Annotated[Mass | None, "Or the mass of the rotor, e.g. 5 kg."] = None,
    gyration: Annotated[Size | None, "With its radius of gyration about the spin axis, e.g. 90 mm."] = None,
    radius: Annotated[Size | None, "Or with its radius as a uniform thin disk, e.g. 100 mm."] = None,
    spin: Annotated[ShaftSpeed, "Speed of the rotor in its frame, e.g. 3000 rpm."],
    precession: Annotated[TurnRate, "Angular velocity of the frame, e.g. 2 rad/s."],
    angle: Annotated[Angle, "Between spin axis and precession axis, e.g. 60 deg."] = QUARTER,
    span: Annotated[Size | None, "Distance between the two bearings, e.g. 200 mm."] = None,
) -> Gyro:
    """Torque on a rotor whose frame turns steadily, with nothing left out, beside the usual product.

    Equation
    --------
    M = Ω·sin θ·(C·(s + Ω·cos θ) − A·Ω·cos θ).

    Returns
    -------
    Gyro
        Torque, its sense, forces of the bearings, the usual product.

    Raises
    ------
    InadmissibleError
        When a moment of inertia is not above zero, the axial one is above twice the transverse one or needs it, or
        the span is not above zero.

    UsageError
        When the rotor is given in no way, or in two.

    References
    ----------
    Euler's equations, with components along the spin axis and across it.

    Examples
    --------
    >>> given = {"axial": 0.03, "transverse": 0.02, "spin": 314.1592653589793, "precession": 2.0}
    >>> round(gyro(**given, angle=1.0471975511965976).torque, 9)
    16.341514786
    """
    sine, cosine = sin(angle), cos(angle)
    axial, transverse = moments_of(axial, transverse, mass, gyration, radius)
    require(transverse is not None or abs(plain(cosine)) < RIGHT, "at {angle} the moment of inertia across the spin "
            "axis counts", angle=(angle, Angle), code="missing", hint="give --transverse")  # fmt: skip
    check_body(axial, axial if transverse is None else transverse)
    require(span is None or span > 0.0, "the bearings are at one place", code="span",
            hint="give the distance between them")  # fmt: skip
    tilted = 0.0 if transverse is None else (axial - transverse) * precession * cosine
    torque = precession * sine * (axial * spin + tilted)
    simple = axial * spin * precession * sine
    sign = plain(torque)
    if sign > 0.0:
        sense = "the rotor tips its axis towards the precession axis"
    elif sign < 0.0:
        sense = "the rotor tips its axis away from the precession axis"
    else:
        sense = "no torque"
    return Gyro(
        torque=torque,
        sense=sense,
        bearing_force=None if span is None else abs(torque) / span,
        simple_torque=simple,
        simple_share=simple / torque if sign != 0.0 else None,
        angular_momentum=axial * (spin + precession * cosine),
    )


def moments_of(
    axial: "float | None", transverse: "float | None", mass: "float | None", gyration: "float | None",
    radius: "float | None",
) -> "tuple[float, float | None]":  # fmt: skip
    """Moments of inertia about the spin axis and across it, from whichever of the rotor is given."""
    sizes = [size for size in (gyration, radius) if size is not None]
    if (axial is None) == (mass is None) or len(sizes) != (mass is not None):
        raise MissingError("the inertia of the rotor is not given, or is given twice", WAYS)
    if axial is not None:
        return axial, transverse
    assert mass is not None
    if gyration is not None:
        return mass * gyration * gyration, transverse
    assert radius is not None
    quarter = 0.25 * mass * radius * radius
    return 2.0 * quarter, quarter if transverse is None else transverse


def check_body(axial: float, transverse: float) -> None:
    """Refuse moments that no body has."""
    require((axial > 0.0) & (transverse > 0.0), "a moment of inertia is not above zero", code="impossible-body",
            hint="give both moments above zero")  # fmt: skip
    require(
        axial <= 2.0 * transverse * ROUNDING,
        "no body has {axial} about its axis and {transverse} across it", code="impossible-body",
        axial=(axial, Inertia), transverse=(transverse, Inertia),
        hint="the axial moment is at most twice the transverse one, as of a thin disk",
    )  # fmt: skip
