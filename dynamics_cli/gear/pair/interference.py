"""Interference of two gears: each verdict with its decisive length.

Along the path of contact the decisive numbers are differences of radii of curvature. For an internal gear the corner
of the pinion's tip is followed through the ring's space, and the minimum clearance is where its slope changes sign, in
running (trochoid interference) and in radial assembly of the pinion (trimming).
"""

from math import pi

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.gear.pair.engagement import Engagement, Path
from dynamics_cli.gear.single.gear import Gear
from dynamics_cli.gear.single.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import (
    absolute,
    acos,
    atan,
    atan2,
    cos,
    hypot,
    maximum,
    minimum,
    pi_beside,
    sin,
)
from dynamics_cli.numerics.number import like, over_plain, plain
from dynamics_cli.numerics.roots import sign_change
from dynamics_cli.quantities import Annotated, Coordinate, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

_SAMPLES = 48
PROFILES = "profiles"


@record
class Verdict:
    """One kind of interference."""

    kind: Annotated[Text, "What was checked."]
    free: Annotated[bool, "Whether the gears are free of it."]
    margin: Annotated[Coordinate, "Margin left; negative if they interfere [m]."]


# Profiles that overlap by less than this share of a module touch.
OVERLAP = 1e-6


def verdicts(
    mesh: Engagement, path: Path, backlash: float, cut: tuple[Gear, Gear], root_radius_factor: float | None = None
) -> tuple[Verdict, ...]:
    """Every verdict that applies to the pair; `cut` are its gears as cut for the backlash."""
    first, second = mesh.first, mesh.second
    clearance = mesh.centre_distance - 0.5 * (first.tip_diameter + second.root_diameter)
    other = mesh.centre_distance - 0.5 * (second.tip_diameter + first.root_diameter)
    verdicts_of_pair = [
        ("involute: the second's tip against the first's base circle", path.nominal_start),
        ("root: the second's tip against the first's root form circle", path.nominal_start - path.first_form),
        ("tip clearance of the first in the second", clearance),
        ("tip clearance of the second in the first", other),
    ]
    verdicts_of_pair[2:2] = _profiles(mesh, path, backlash, cut, root_radius_factor)
    if path.second_form is not None:
        reach = mesh.line - path.nominal_end
        verdicts_of_pair.insert(1, ("involute: the first's tip against the second's base circle", reach))
        verdicts_of_pair.insert(
            3, ("root: the first's tip against the second's root form circle", reach - path.second_form)
        )
    else:
        corner = _Corner(mesh)
        corner_in_doubles = _Corner(over_plain(mesh))
        turn = _last_turn(corner_in_doubles)
        running, pushing = (
            _in_numbers_of(corner, place, turn)
            for place in (_least_after_crest(corner_in_doubles, turn), _least_sideways(corner_in_doubles, turn))
        )
        verdicts_of_pair.append(("trochoid: the pinion's tip past the ring's", corner.clearance(running)))
        verdicts_of_pair.append(("trimming: the pinion put in radially", corner.sideways(pushing)))
    allowed = {PROFILES: -OVERLAP * plain(first.module)}
    return tuple(
        Verdict(kind, plain(margin) >= allowed.get(kind.partition(":")[0], 0.0), margin)
        for kind, margin in verdicts_of_pair
    )


def _profiles(
    mesh: Engagement, path: Path, backlash: float, cut: tuple[Gear, Gear], root_radius_factor: float | None
) -> "list[tuple[str, float]]":
    """Minimum distances of the exact profiles, each tip from the root it turns through, as in `gear mesh`.

    Teeth cut by one rack, with its tip clearance and involutes wherever they touch, stay within the rack's teeth: their
    roots are clear, and nothing is searched.
    """
    from dynamics_cli.gear.mesh.profile_contact import path_of_contact
    from dynamics_cli.gear.mesh.root_clearance import root_gaps
    from dynamics_cli.gear.single.profile import tooth_form

    first, second = mesh.first, mesh.second
    rack_room = first.module * (first.rack.dedendum - first.rack.addendum)
    clearances = (
        mesh.centre_distance - 0.5 * (first.tip_diameter + second.root_diameter),
        mesh.centre_distance - 0.5 * (second.tip_diameter + first.root_diameter),
    )
    clipped = plain(path.end) < plain(path.nominal_end), plain(path.start) > plain(path.nominal_start)
    cramped = min(map(plain, clearances)) < plain(rack_room) - OVERLAP * plain(first.module)
    if not (second.internal or cramped or any(clipped)):
        return []
    try:
        forms = [tooth_form(gear, None, root_radius_factor) for gear in cut]
    except InadmissibleError:
        # a ring whose spaces take no fillet has no exact root to check
        return []
    play = maximum(backlash, 0.0 * backlash) / absolute(mesh.working_diameter(second))
    touch = minimum(0.5 * backlash * cos(mesh.angle), 0.0 * backlash)
    distance = absolute(mesh.centre_distance)
    line = path_of_contact(forms[0], forms[1], distance)
    touches = touch if line.end < line.tip_end else None, touch if line.start > line.tip_start else None
    inward, outward, _ = root_gaps(forms[0], forms[1], distance, play, touches)
    gaps = (("first's tip in the second's", inward), ("second's tip in the first's", outward))
    return [(f"{PROFILES}: the {which} root", gap) for which, gap in gaps if gap is not None]


class _Corner:
    """The corner of the pinion's tip in a ring's space, the pinion turned by φ from the line of centres."""

    def __init__(self, mesh: Engagement) -> None:
        first, second = mesh.first, mesh.second
        self.distance = -mesh.centre_distance
        self.pinion = 0.5 * first.tip_diameter
        self.ring = -0.5 * second.tip_diameter
        self.teeth = first.teeth, -second.teeth
        self.half = first.base_half_angle - roll_less_arc(first.tip_roll)
        self.second = second
        self.space = second.base_half_angle - pi_beside(second.base_half_angle) / second.teeth
        # the corner ends its contact where its pressure angle has carried it past the line of centres
        self.parting = atan(first.tip_roll) - mesh.angle - self.half
        self.ring_half = self.space - roll_less_arc(second.tip_roll)

    def _follow(self, turn: float) -> float:
        """Rotation of the ring; an exact angle loses nothing in numbers of more digits."""
        return turn * self.teeth[0] / self.teeth[1]

    def _place(self, turn: float) -> tuple[float, float]:
        angle = turn + self.half
        return self.distance + self.pinion * cos(angle), self.pinion * sin(angle)

    def clearance(self, turn: float) -> float:
        """Arc between the corner and the ring's flank, or its tip's corner inside the tip circle."""
        x, y = self._place(turn)
        radius = hypot(x, y)
        return radius * (self._follow(turn) + self._half_space(radius) - atan2(y, x))

    def _half_space(self, radius: float) -> float:
        if plain(radius) > plain(self.ring):
            return self.space - roll_less_arc(self.second.roll(2.0 * radius))
        return self.ring_half

    def clearance_slope(self, turn: float) -> float:
        """Derivative of the clearance by the rotation: the radius decreases by a·sin θ, and the angles with it."""
        x, y = self._place(turn)
        radius = hypot(x, y)
        along = -self.distance * y / radius
        arc = self._follow(turn) + self._half_space(radius) - atan2(y, x)
        roll = self.second.roll(2.0 * radius) if radius > self.ring else 0.0
        round_ = self.pinion * self.pinion + self.distance * (x - self.distance)
        return along * (arc - roll) + radius * self._follow(1.0) - round_ / radius

    def sideways(self, turn: float) -> float:
        """Lateral distance of the pinion's corner inside the ring's, towards the line of centres."""
        return self.ring * sin(self._follow(turn) + self.ring_half) - self.pinion * sin(turn + self.half)

    def sideways_slope(self, turn: float) -> float:
        """Its derivative by the rotation."""
        ring_slope = self.ring * self._follow(1.0) * cos(self._follow(turn) + self.ring_half)
        return ring_slope - self.pinion * cos(turn + self.half)

    def ahead(self, turn: float) -> float:
        """How far the pinion's corner reaches beyond the ring's along the line of centres."""
        return self._place(turn)[0] - self.ring * cos(self._follow(turn) + self.ring_half)


def _last_turn(corner: _Corner) -> float:
    """The turn at which the corner crosses the ring's tip circle."""
    a, pinion, ring = corner.distance, corner.pinion, corner.ring
    cosine = (ring * ring - pinion * pinion - a * a) / (2.0 * a * pinion)
    return acos(minimum(1.0, maximum(-1.0, cosine))) - corner.half


def _in_numbers_of(corner: _Corner, turn: float, last: float) -> float:
    """A rotation found in doubles, taken as exact: at a minimum its error affects the clearance only by its square.

    Where the search ended at the last rotation, the rounding of that rotation counts.
    """
    return _last_turn(corner) if turn == last else like(turn, corner.distance)


def _least_after_crest(corner: _Corner, last: float) -> float:
    """The minimum clearance after contact has ended and the corner is free."""
    first = min(corner.parting, last)
    crest = extremum(lambda turn: -corner.clearance(turn), lambda turn: -corner.clearance_slope(turn), first, last)
    return extremum(corner.clearance, corner.clearance_slope, crest, last)


def _least_sideways(corner: _Corner, last: float) -> float:
    """The minimum lateral clearance in radial assembly, among corners that must pass the ring's."""
    high = last
    step = max(0.02, 0.25 * last)
    while corner.ahead(high + step) > 0.0 and high + step + corner.half < 0.5 * pi:
        high += step
    return extremum(corner.sideways, corner.sideways_slope, 0.0, high)


def extremum(function: "Callable[[float], float]", slope: "Callable[[float], float]", low: float, high: float) -> float:
    """The minimum of a function: the best of a grid, or the adjacent sign change of its slope, to the last bits."""
    step = (high - low) / _SAMPLES
    places = [*(low + step * k for k in range(_SAMPLES)), high]
    values = [function(x) for x in places]
    best = values.index(min(values))
    a, b = places[max(best - 1, 0)], places[min(best + 1, _SAMPLES)]
    if slope(a) < 0.0 < slope(b):
        return sign_change(lambda x: -slope(x), a, b)
    return places[best]
