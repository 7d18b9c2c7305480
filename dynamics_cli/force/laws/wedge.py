"""The task `wedge`: what drives a wedge under a load, what pulls it out again, and whether it holds by itself."""

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
    verdict: Annotated[Text, "Whether it holds by itself when the drive is let go."]
    release: Annotated[Force, "Force that pulls it out; negative where it must be held in [N]."]
    limit_angle: Annotated[Angle, "It holds by itself up to this angle [rad]."]
    efficiency: Annotated[Fraction, "Work on the load over that of the drive [-]."]
    face_force: Annotated[Force, "Force on the inclined face while it is driven [N]."]
    guide_force: Annotated[Force, "Force of the guide on the load while it is driven [N]."]


def wedge(
    *,
    load: Annotated[Force, "Weight or force across the ground that it lifts, e.g. 5 kN."],
    angle: Annotated[Angle, "Angle of the wedge, e.g. 8 deg."],
    friction: Annotated[Friction, "Coefficient of friction on its inclined face, e.g. 0.15."],
    ground_friction: Annotated[Friction | None, "That on the ground; without it the same."] = None,
    guide_friction: Annotated[Friction, "That between the load and its upright guide."] = 0.0,
) -> Wedge:
    """A wedge driven along the ground under a load that an upright guide keeps from going with it.

    Equation
    --------
    a = α + φ, N = W·cos φ_g/cos(a + φ_g), P = N·sin(a + φ₀)/cos φ₀ with φ = atan μ; let go, with −φ and −φ_g. It holds
    by itself up to α = φ + φ₀.

    Returns
    -------
    Wedge
        Driving and releasing force, verdict, efficiency.

    Raises
    ------
    InadmissibleError
        When the load is not above zero, the angle is not between 0 and 90 degrees, or it jams: friction and angle
        leave no force that drives it.

    References
    ----------
    Coulomb friction: each face's force leans by its angle of friction against the motion.

    Examples
    --------
    >>> round(wedge(load=1000.0, angle=0.1, friction=0.0).drive, 9)
    100.334672085
    """
    require(plain(load) > 0.0, "the load is not above zero", code="no-load", hint="give what the wedge lifts")
    require((plain(angle) > 0.0) and (plain(angle) < QUARTER), "{angle} is no wedge", angle=(angle, Angle),
            code="angle", hint="give an angle between 0 and 90 deg")  # fmt: skip
    face, guide = atan(friction), atan(guide_friction)
    ground = face if ground_friction is None else atan(ground_friction)
    lean = angle + face
    require(
        plain(lean) + max(plain(guide), plain(ground)) < QUARTER,
        "it jams: at {angle} with this friction no force drives it",
        angle=(angle, Angle),
        code="jams",
        hint="take a smaller angle, or less friction",
    )
    pressed = load * cos(guide) / cos(lean + guide)
    drive = pressed * sin(lean + ground) / cos(ground)
    # going back, friction on all faces is the other way; the load leans on either side of its guide
    back = angle - face
    held = load * cos(guide) / cos(absolute(back) - guide)
    release = held * sin(ground - back) / cos(ground)
    loose = plain(release) < 0.0
    return Wedge(
        drive=drive,
        verdict="slips out when it is let go" if loose else "holds by itself",
        release=release,
        limit_angle=face + ground,
        efficiency=load * tan(angle) / drive,
        face_force=pressed,
        guide_force=pressed * sin(lean) / cos(guide),
    )
