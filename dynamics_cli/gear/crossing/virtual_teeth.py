"""Teeth of gears that are not cylindrical, judged by their equivalent spur gear and its rack.

Bevel gears by the spur gears on their back cones (Tredgold), the wheel of a worm by its middle plane, crossed helical
gears by their transverse sections. Lengths are in modules of that section.
"""

from math import pi

from dynamics_cli.errors import worded
from dynamics_cli.gear.single.limits import LEAST_TIP
from dynamics_cli.gear.single.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import cos, sin, sqrt, tan
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Ratio
from dynamics_cli.records import Advice


def undercut_depth(teeth: float, pressure_angle: float) -> float:
    """Maximum depth of a rack's straight flank below the pitch line without undercut: z sin²α/2."""
    sine = sin(pressure_angle)
    return 0.5 * teeth * sine * sine


def tip_land(teeth: float, pressure_angle: float, height: float, shift: float = 0.0) -> float | None:
    """Thickness of a tooth at its tip, `height` above the pitch line; None where the tip is inside the base circle."""
    tip, base = 0.5 * teeth + height, 0.5 * teeth * cos(pressure_angle)
    if tip <= base:
        return None
    half = (0.5 * pi + 2.0 * shift * tan(pressure_angle)) / teeth + roll_less_arc(tan(pressure_angle))
    return 2.0 * tip * (half - roll_less_arc(sqrt((tip - base) * (tip + base)) / base))


def tooth_advice(
    who: str, teeth: float, pressure_angle: float, height: float, depth: float, shift: float, remedy: tuple[str, str]
) -> tuple[Advice, ...]:
    """Undercut by the rack's straight flank, which reaches `depth` below the pitch line, and tips without a land."""
    teeth, angle, height, depth, shift = (plain(value) for value in (teeth, pressure_angle, height, depth, shift))
    advice = []
    deepest = undercut_depth(teeth, angle)
    if depth > deepest + 1e-9:
        message = worded(
            "the teeth of {who} are undercut: a rack's flank may reach {deepest} modules below the pitch line of "
            "{teeth} virtual teeth, and these need {depth}",
            who=who,
            deepest=(deepest, Ratio),
            teeth=(teeth, Ratio),
            depth=(depth, Ratio),
        )
        advice.append(Advice("undercut", message, "caution", remedy[0]))
    land = tip_land(teeth, angle, height, shift)
    if land is None:
        message = worded("the tips of {who} lie inside the base circle, where there is no involute", who=who)
        advice.append(Advice("no-flank", message, "serious", remedy[0]))
    elif land < 0.0:
        advice.append(
            Advice("pointed", worded("the teeth of {who} are pointed below their tips", who=who), "serious", remedy[1])
        )
    elif land < LEAST_TIP:
        message = worded(
            "the tips of {who} are {land:3} modules thick, less than {limit}",
            who=who,
            land=(land, Ratio),
            limit=(LEAST_TIP, Ratio),
        )
        advice.append(Advice("thin-tip", message, remedy=remedy[1]))
    return tuple(advice)
