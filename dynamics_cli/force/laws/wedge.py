"""The task `wedge`: forces that drive a wedge under a load and pull it out, self-locking, efficiency."""

from dynamics_cli.errors import require
from dynamics_cli.numerics.elementary import absolute, atan, cos, sin, tan
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, Force, Fraction, Friction, Text
from dynamics_cli.records import record

QUARTER = 1.5707963267948966


@record
class Wedge:
    """Forces of a wedge between the ground and a guided load."""

    drive: Annotated[Force, "Force along the ground that drives it in [N]."]
    verdict: Annotated[Text, "Whether the wedge holds by itself when the driving force is removed."]
    release: Annotated[Force, "Force that pulls it out; negative if it must be held in [N]."]
    limit_angle: Annotated[Angle, "Largest angle at which it holds by itself [rad]."]
    efficiency: Annotated[Fraction, "Work on the load over the work of the driving force [-]."]
    face_force: Annotated[Force, "Force on the inclined face while it is driven [N]."]
    guide_force: Annotated[Force, "Force of the guide on the load while it is driven [N]."]


def wedge(
    *,
    load: Annotated[Force, "Weight, or force at right angles to the ground, that it lifts, e.g. 5 kN."],
    angle: Annotated[Angle, "Angle of the wedge, e.g. 8 deg."],
    friction: Annotated[Friction, "Coefficient of friction on its inclined face, e.g. 0.15."],
    ground_friction: Annotated[Friction | None, "Coefficient on the ground; without it the same."] = None,
    guide_friction: Annotated[Friction, "Coefficient between the load and its upright guide."] = 0.0,
) -> Wedge:
    """A wedge driven along the ground under a load that an upright guide holds in place.

    Equation
    --------
    a = α + φ, N = W·cos φ_g/cos(a + φ_g), P = N·sin(a + φ₀)/cos φ₀ with φ = atan μ; pulled out, with −φ and −φ_g. It
    holds by itself up to α = φ + φ₀.

    Returns
    -------
    Wedge
        Driving and releasing force, verdict, efficiency.

    Raises
    ------
    InadmissibleError
        When the load is not above zero, when the angle is not between 0 and 90 degrees, or when it jams: no force can
        drive it against this friction.

    References
    ----------
    Coulomb friction: the force on each face is inclined by the angle of friction against the motion.

    Examples
    --------
    >>> round(wedge(load=1000.0, angle=0.1, friction=0.0).drive, 9)
    100.334672085
    """
    require(plain(load) > 0.0, "the load is not above zero", code="no-load", hint="give the load that the wedge lifts")
    require(
        0.0 < plain(angle) < QUARTER,
        "a wedge cannot have an angle of {angle}",
        angle=(angle, Angle),
        code="angle",
        hint="give an angle between 0 and 90 deg",
    )
    face, guide = atan(friction), atan(guide_friction)
    ground = face if ground_friction is None else atan(ground_friction)
    inclination = angle + face
    require(
        plain(inclination) + max(plain(guide), plain(ground)) < QUARTER,
        "the wedge jams: at {angle} and with this friction no force drives it",
        angle=(angle, Angle),
        code="jams",
        hint="take a smaller angle or less friction",
    )
    driven_force = load * cos(guide) / cos(inclination + guide)
    drive = driven_force * sin(inclination + ground) / cos(ground)
    # pulled out, friction on all faces is reversed; the load may press on either side of its guide
    back = angle - face
    released_force = load * cos(guide) / cos(absolute(back) - guide)
    release = released_force * sin(ground - back) / cos(ground)
    slips = plain(release) < 0.0
    return Wedge(
        drive=drive,
        verdict="slips out when it is let go" if slips else "holds by itself",
        release=release,
        limit_angle=face + ground,
        efficiency=load * tan(angle) / drive,
        face_force=driven_force,
        guide_force=driven_force * sin(inclination) / cos(guide),
    )
