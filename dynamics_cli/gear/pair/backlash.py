"""Backlash of a pair from centre distance and thinned teeth, and the thinning and cutting for a given one."""

from dynamics_cli.errors import require
from dynamics_cli.gear.pair.engagement import Engagement, at_tight_distance, reference_distance
from dynamics_cli.gear.pair.records import Mate
from dynamics_cli.gear.single.gear import Gear
from dynamics_cli.numerics.elementary import absolute, cos, tan
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Size


def thinned_for(mesh: Engagement, first: Mate, second: Mate, backlash: float) -> tuple[Mate, Mate]:
    """Both gears, thinned equally to add what the centre distance lacks in backlash."""
    require(
        plain(first.thinning) == 0.0 and plain(second.thinning) == 0.0,
        "both backlash and thinning are given",
        code="thinning",
        hint="give one of them: each follows from the other",
    )
    require(
        backlash >= mesh.backlash,
        "the centre distance alone gives a backlash of {least:6}, which is more than {backlash:6}",
        least=(plain(mesh.backlash), Size),
        backlash=(plain(backlash), Size),
        code="backlash",
        hint="lower the centre distance, or raise a profile shift",
    )
    reach = reference_distance(mesh.first, mesh.second) / mesh.centre_distance
    half = 0.5 * (backlash - mesh.backlash) * cos(mesh.first.helix_angle) * reach
    return Mate(first.teeth, first.profile_shift, first.tip_diameter, half), Mate(
        second.teeth, second.profile_shift, second.tip_diameter, half
    )


def as_cut(gear: Gear, thinning: float) -> Gear:
    """The gear as its rack cuts thinner teeth into the same blank."""
    shift = generating_shift(gear, thinning)
    return gear if shift is None else gear.shifted(shift, gear.tip_change + (gear.shift - shift))


def generating_shift(gear: Gear, thinning: float) -> float | None:
    """The shift x_E = x − A_sn/(2 m_n tan α_n) that thins the teeth (ISO 21771)."""
    if plain(thinning) == 0.0:
        return None
    change: float = 0.5 * thinning / (gear.module * tan(gear.rack.pressure_angle))
    return gear.shift - change


def total_backlash(mesh: Engagement, mates: tuple[Mate, Mate]) -> float:
    """Backlash j_wt on the working circles, from centre distance and thinned teeth; refuses jammed teeth."""
    thinning = (mates[0].thinning + mates[1].thinning) / cos(mesh.first.helix_angle)
    reach = mesh.centre_distance / reference_distance(mesh.first, mesh.second)
    total = mesh.backlash + thinning * reach
    if plain(total) < -1e-2 * plain(mesh.first.module):
        require(
            False,
            "the teeth would overlap by {total:6}: without backlash the centre distance is {tight:9}",
            total=(-plain(total), Size),
            tight=(plain(absolute(at_tight_distance(mesh.first, mesh.second).centre_distance)), Size),
            code="jammed",
            hint="change the centre distance, a profile shift or the thinning",
        )
    return total
