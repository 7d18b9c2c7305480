"""Speed of a light vehicle from how it turned the heavy one it struck: momentum of rotation."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    AngularSpeed,
    Annotated,
    Distance,
    Gravity,
    Impulse,
    Inertia,
    Mass,
    RoadSpeed,
    RoadVelocity,
)
from dynamics_cli.records import Advice, record

# So far the line of the impulse is out where a contact patch is judged by eye.
BY_EYE = 0.1


@record
class Turned:
    """Speed of the light vehicle from the rotation of the heavy one."""

    speed: Annotated[RoadVelocity, "Speed of the light vehicle before the impact, along the impulse [m/s]."]
    impulse: Annotated[Impulse, "Impulse between the two [N·s]."]
    light_change: Annotated[RoadSpeed, "Change of the light vehicle's speed, ΔV [m/s]."]
    heavy_change: Annotated[RoadSpeed | None, "ΔV of the heavy vehicle; needs its mass [m/s]."]
    advice: tuple[Advice, ...] = ()


def rotation(
    *,
    heavy_inertia: Annotated[Inertia, "Yaw moment of inertia of the heavy vehicle, e.g. 1800 kg*m^2 [kg·m²]."],
    heavy_spin: Annotated[
        AngularSpeed, "Change of its yaw rate in the impact, in its amount, e.g. 1.15 rad/s [rad/s]."
    ],
    lever: Annotated[Distance, "From its mass centre to the line of the impulse, e.g. 1.6 m [m]."],
    light_mass: Annotated[Mass, "Mass of the light vehicle with its rider, e.g. 250 kg [kg]."],
    exit_speed: Annotated[
        RoadVelocity, "Speed of the light vehicle after the impact along its approach, e.g. 2 m/s [m/s]."
    ] = 0.0,
    heavy_mass: Annotated[Mass | None, "Mass of the heavy vehicle, for its ΔV, e.g. 1500 kg [kg]."] = None,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Turned:
    """Approach speed of a light vehicle along the impulse, from the spin it gave the heavy vehicle.

    Equation
    --------
    p = J₁ Δω₁/h, v₂ = p/m₂ + exit speed along the impulse.

    Returns
    -------
    Turned
        The speed, the impulse, and the velocity changes of both vehicles.

    Raises
    ------
    InadmissibleError
        When lever, mass or inertia is zero, or the spin change is less than zero.

    Notes
    -----
    Momentum from headings hardly determines a light vehicle's speed; the spin of the heavy one is more sensitive than
    its heading. The impulse is taken along the light vehicle's approach; tyres that hold the heavy one against the turn
    make the speed too low.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.4 (angular impulse and momentum).

    Examples
    --------
    >>> rotation(heavy_inertia=1800.0, heavy_spin=1.15, lever=1.6, light_mass=250.0, exit_speed=2.0).speed
    7.175
    """
    del gravity
    require(lever > 0.0, "an impulse through the mass centre turns nothing", code="no-lever")
    require(
        (light_mass > 0.0) & (heavy_inertia > 0.0), "mass and moment of inertia must be more than zero", code="no-mass"
    )
    require(
        heavy_spin >= 0.0, "a spin change of {spin} is less than zero: give its amount",
        spin=(heavy_spin, AngularSpeed), code="negative-spin",
    )  # fmt: skip
    require(heavy_mass is None or heavy_mass > 0.0, "the mass must be more than zero", code="no-mass")
    impulse = heavy_inertia * heavy_spin / lever
    change = impulse / light_mass
    return Turned(
        speed=change + exit_speed,
        impulse=impulse,
        light_change=change,
        heavy_change=None if heavy_mass is None else impulse / heavy_mass,
        advice=_lever_advice(lever, change, change + exit_speed),
    )


def _lever_advice(lever: float, change: float, speed: float) -> tuple[Advice, ...]:
    """Effect on the speed of a contact point estimated by eye."""
    if not single(lever, change, speed) or plain(lever) <= BY_EYE or plain(speed) == 0.0:
        return ()
    ratio = float(plain(change)) * BY_EYE / (float(plain(lever)) - BY_EYE) / abs(float(plain(absolute(speed))))
    message = worded(
        "if the impulse passed {by} nearer to the mass centre, the speed is {share} higher",
        by=(BY_EYE, Distance), share=f"{100.0 * ratio:.2g} %",
    )  # fmt: skip
    return (
        Advice(
            code="lever-by-eye", message=message, severity="note" if ratio < 0.15 else "caution",
            remedy="give lever, spin and inertia with their ranges",
        ),
    )  # fmt: skip
