"""The task `gyro`: the gyroscopic torque of a rotor whose axis turns."""

from dynamics_cli.errors import require
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

QUARTER = 1.5707963267948966
# A cosine below this is that of a right angle.
RIGHT = 1e-15
# Decimals in other units are rounded on their way to SI.
ROUNDING = 1.0 + 1e-12


@record
class Moments:
    """A rotor by its moments of inertia."""

    axial: Annotated[Inertia, "Moment of inertia about the spin axis, e.g. 0.03 kg*m^2."]
    transverse: Annotated[
        Inertia | None, "Moment of inertia across the spin axis; not needed at 90 deg, e.g. 0.02 kg*m^2."
    ] = None

    def pair(self) -> "tuple[float, float | None]":
        """About the spin axis and across it."""
        return self.axial, self.transverse


@record
class Gyration:
    """A rotor by its mass and radius of gyration."""

    mass: Annotated[Mass, "Mass of the rotor, e.g. 5 kg."]
    gyration: Annotated[Size, "Radius of gyration about the spin axis, e.g. 90 mm."]
    transverse: Annotated[Inertia | None, "Moment of inertia across the spin axis; not needed at 90 deg."] = None

    def pair(self) -> "tuple[float, float | None]":
        """About the spin axis and across it."""
        return self.mass * self.gyration * self.gyration, self.transverse


@record
class Disk:
    """A rotor that is a thin uniform disk."""

    mass: Annotated[Mass, "Mass of the rotor, e.g. 5 kg."]
    radius: Annotated[Size, "Radius of a uniform disk, e.g. 100 mm."]

    def pair(self) -> "tuple[float, float | None]":
        """About the spin axis and across it."""
        quarter = 0.25 * self.mass * self.radius * self.radius
        return 2.0 * quarter, quarter


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
    rotor: Annotated[Moments | Gyration | Disk, "The rotor."],
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

    References
    ----------
    Euler's equations, with components along the spin axis and across it.

    Examples
    --------
    >>> given = {"rotor": Moments(0.03, 0.02), "spin": 314.1592653589793, "precession": 2.0}
    >>> round(gyro(**given, angle=1.0471975511965976).torque, 9)
    16.341514786
    """
    sine, cosine = sin(angle), cos(angle)
    axial, transverse = rotor.pair()
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
