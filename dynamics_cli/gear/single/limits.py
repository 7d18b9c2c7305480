"""Limits of the profile shift: undercut on one side, pointed teeth on the other."""

from math import ceil, pi

from dynamics_cli.gear.single.gear import Gear
from dynamics_cli.numerics.elementary import atan, cos, maximum, sin, sqrt, tan, where
from dynamics_cli.numerics.involute import involute
from dynamics_cli.numerics.number import is_array, like, over_plain, plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

# Tips thinner than this share of a module are usually avoided, and in hardened gears thinner than twice that.
LEAST_TIP = 0.2
# A number of teeth within this of a whole number counts as whole.
ROUNDING = 1e-13
# Newton's steps that any gear may take: six or seven are usual.
STEPS = 60


def least_shift(gear: Gear) -> float:
    """Minimum profile shift factor without undercut: x = h_fP* − ρ*(1 − sin α_n) − z sin²α_t/(2 cos β) (ISO 21771)."""
    rack = gear.rack
    reach = rack.dedendum - rack.tip_radius * (1.0 - sin(rack.pressure_angle))
    sine = sin(gear.transverse_angle)
    return reach - 0.5 * gear.teeth * sine * sine / cos(gear.helix_angle)


def least_teeth(gear: Gear) -> int:
    """Teeth without undercut at the gear's shift: z ≥ 2 cos β (h_fP* − ρ*(1 − sin α_n) − x)/sin²α_t."""
    sine = sin(gear.transverse_angle)
    # `least_shift` for zero teeth is the depth of the rack's straight flank
    reach = least_shift(gear) + 0.5 * gear.teeth * sine * sine / cos(gear.helix_angle) - gear.shift
    return max(1, ceil(2.0 * cos(gear.helix_angle) * reach / (sine * sine) * (1.0 - ROUNDING)))


def pointed_shift(gear: Gear) -> float:
    """Profile shift factor at which the tip thickness of an external gear vanishes.

    A tooth whose tip is at the reference circle has a thickness there; from it the shift is bracketed upwards, and one
    Newton step in the numbers of the input carries derivatives and rounding through.
    """
    doubles = over_plain(gear)
    base, angle = doubles.base_diameter, involute(doubles.transverse_angle) + 0.5 * pi / doubles.teeth
    widening, reach = 2.0 * tan(doubles.rack.pressure_angle) / doubles.teeth, 2.0 * doubles.module
    tip = doubles.reference_diameter + reach * (doubles.rack.addendum + doubles.tip_change)

    def half(shift: float) -> tuple[float, float]:
        ratio = (tip + reach * shift) / base
        roll = sqrt((ratio - 1.0) * (ratio + 1.0))
        return angle + widening * shift - (roll - atan(roll)), widening - roll / ratio * reach / base

    low = -doubles.rack.addendum - doubles.tip_change
    high = low + 1.0
    while half(high)[0] > 0.0:
        low, high = high, 2.0 * high - low + 1.0
    # the lower end may be pointed itself when the rack is; among tracked numbers, so that rounding of its sums counts
    root: float = like(_root_left_of(high, low, half), gear.module)
    shifted = gear.shifted(root, gear.tip_change)
    tip = shifted.tip_diameter
    remaining = shifted.tip_thickness / tip
    slope = 2.0 * tan(doubles.rack.pressure_angle) / doubles.teeth
    slope -= 2.0 * plain(shifted.tip_roll) * doubles.module / plain(tip)
    return root - remaining / slope  # type: ignore[no-any-return]


def _root_left_of(start: float, least: float, function: "Callable[[float], tuple[float, float]]") -> float:
    """Where a function of downward curvature, with its slope, comes down to zero: Newton's steps stay beyond it."""
    place = start
    for _ in range(STEPS):
        value, slope = function(place)
        step = maximum(place - value / slope, least)
        moving: Any = step < place
        place = where(moving, step, place)
        if not (moving.any() if is_array(moving) else moving):
            break
    return place
