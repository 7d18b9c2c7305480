"""How well the measured damage of a vehicle determines its energy, and advice."""

from dynamics_cli.errors import worded
from dynamics_cli.numerics.elementary import absolute, cos, minimum, sin, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import Angle, Annotated, Fraction, Restitution, RoadSpeed, Size, Text
from dynamics_cli.records import Advice, record

DEGREE = 0.017453292519943295
HALF_TURN = 180.0 * DEGREE
# Depths of crush are measured to some centimetres, directions of force are judged to some degrees, restitutions of
# vehicles are known to some hundredths.
GOOD_DEPTH, CAUTION_DEPTH = 0.03, 0.01
GOOD_ANGLE, CAUTION_ANGLE = 3.0 * DEGREE, 1.0 * DEGREE
GOOD_RESTITUTION = 0.05
LEVELS = ("undetermined", "caution", "good")


@record
class DamageVerdict:
    """How well the measured crush and the direction of force determine the equivalent barrier speed."""

    verdict: Annotated[Text, "good from 3 cm and 3 degrees of tolerance, caution from 1 cm and 1 degree."]
    depth_tolerance: Annotated[Size, "Error of all depths of crush that changes the speed by a tenth [m]."]
    angle_tolerance: Annotated[
        Angle, "Error of the direction of force that changes the speed by a tenth, at most half a turn [rad]."
    ]


def damage_verdict(normal: float, force: float, angle: float) -> DamageVerdict:
    """The verdict of EBS = √(2E/m), E = E_n/cos² α, with dE_n/dC the force on the face.

    EBS changes by half the relative change of the energy, and by tan α per angle.
    """
    depth = 0.2 * normal / force
    slope = absolute(sin(angle) / cos(angle))
    leans = slope > 0.0
    turn = where(leans, minimum(0.1 / where(leans, slope, 1.0), HALF_TURN), HALF_TURN)
    good = (plain(depth) >= GOOD_DEPTH) & (plain(turn) >= GOOD_ANGLE)
    fair = (plain(depth) >= CAUTION_DEPTH) & (plain(turn) >= CAUTION_ANGLE)
    level = where(good, LEVELS[2], where(fair, LEVELS[1], LEVELS[0]))  # type: ignore[arg-type]
    return DamageVerdict(level, depth, turn)  # type: ignore[arg-type]


def verdict_advice(limits: DamageVerdict | None, speed: float, name: str) -> tuple[Advice, ...]:
    """A caution where a few centimetres or degrees change the equivalent barrier speed by a tenth."""
    if limits is None or not single(limits.depth_tolerance, speed) or limits.verdict == LEVELS[2]:
        return ()
    shallow = plain(limits.depth_tolerance) / CAUTION_DEPTH < plain(limits.angle_tolerance) / CAUTION_ANGLE
    ratio = CAUTION_DEPTH / plain(limits.depth_tolerance) if shallow else CAUTION_ANGLE / plain(limits.angle_tolerance)
    text = worded(
        "the {name} vehicle: "
        + (
            "an error of {depth:2} in all depths of crush changes"
            if shallow
            else "one degree of the force angle changes"
        )
        + " its equivalent barrier speed by {change:2}",
        name=name,
        depth=(CAUTION_DEPTH, Size),
        change=(0.1 * ratio * plain(speed), RoadSpeed),
    )
    undetermined = limits.verdict == LEVELS[0]
    remedy = "measure the crush again" if shallow else "take the face that was pushed in more squarely"
    code = "undetermined-damage" if undetermined else "sensitive-damage"
    return (Advice(code, text, "serious" if undetermined else "caution", remedy),)


def restitution_tolerance(restitution: float) -> float:
    """Error of the restitution that changes ΔV, as √((1 + e)/(1 − e)), by a tenth."""
    return 0.1 * (1.0 - restitution) * (1.0 + restitution)


def restitution_advice(tolerance: float) -> tuple[Advice, ...]:
    """A caution where a few hundredths of restitution change ΔV by a tenth."""
    if not single(tolerance) or plain(tolerance) >= GOOD_RESTITUTION:
        return ()
    text = worded(
        "an error of {error:2} in the restitution changes ΔV by a tenth", error=(plain(tolerance), Restitution)
    )
    return (Advice("sensitive-restitution", text, "caution", "vehicles with visible damage have 0 to 0.3"),)


def share_advice(stated: bool, name: str, own_energy: float, energy: float) -> tuple[Advice, ...]:
    """Effect of a given energy on ΔV: an estimate may be wrong by a factor of two."""
    if not stated or not single(own_energy, energy):
        return ()
    fraction = plain(own_energy) / plain(energy)
    text = worded(
        "the {name} vehicle has {share:3} of the energy: twice its energy would raise ΔV by {change:2}",
        name=name,
        share=(fraction, Fraction),
        change=((1.0 + fraction) ** 0.5 - 1.0, Fraction),
    )
    return (Advice("energy-share", text, "note"),)
