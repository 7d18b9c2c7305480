"""Whether two gears run without interfering: each verdict with the length that decides it.

Along the path of contact the deciding numbers are differences of radii of curvature. For an internal gear the corner
of the pinion's tip is followed through the ring's space, and the least clearance is found where its slope changes sign,
for running (trochoid interference) and for putting the pinion in radially (trimming).
"""

from math import pi

from dynamics_cli.gear.engagement import Engagement, Path
from dynamics_cli.gear.limits import bare, bisect, plain
from dynamics_cli.gear.rounding import like
from dynamics_cli.gear.trochoid import roll_less_arc
from dynamics_cli.numerics.elementary import (
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
from dynamics_cli.quantities import Coordinate, Text
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

_SAMPLES = 48


@record
class Verdict:
    """One way to interfere.

    Parameters
    ----------
    kind : Text
        What was looked at.
    free : bool
        Whether the gears run free of it.
    margin : Coordinate
        What is left, negative by how much they interfere [m].
    """

    kind: Text
    free: bool
    margin: Coordinate


def verdicts(mesh: Engagement, path: Path) -> tuple[Verdict, ...]:
    """Every verdict that applies to the pair."""
    first, second = mesh.first, mesh.second
    clearance = mesh.centre_distance - 0.5 * (first.tip_diameter + second.root_diameter)
    other = mesh.centre_distance - 0.5 * (second.tip_diameter + first.root_diameter)
    found = [
        ("involute: the second's tip against the first's base circle", path.nominal_start),
        ("root: the second's tip against the first's root form circle", path.nominal_start - path.first_form),
        ("tip clearance of the first in the second", clearance),
        ("tip clearance of the second in the first", other),
    ]
    if path.second_form is not None:
        reach = mesh.line - path.nominal_end
        found.insert(1, ("involute: the first's tip against the second's base circle", reach))
        found.insert(3, ("root: the first's tip against the second's root form circle", reach - path.second_form))
    else:
        corner = _Corner(mesh)
        own = _Corner(_bare(mesh))
        turn = _last_turn(own)
        running, pushing = (
            _in_numbers_of(corner, at, turn) for at in (_least_after_crest(own, turn), _least_sideways(own, turn))
        )
        found.append(("trochoid: the pinion's tip past the ring's", corner.clearance(running)))
        found.append(("trimming: the pinion put in radially", corner.sideways(pushing)))
    return tuple(Verdict(kind, plain(margin) >= 0.0, margin) for kind, margin in found)


def _bare(mesh: Engagement) -> Engagement:
    return Engagement(
        bare(mesh.first),
        bare(mesh.second),
        plain(mesh.centre_distance),
        plain(mesh.angle),
        plain(mesh.tight_angle),
    )


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
        # the corner ends its contact where its pressure angle has taken it past the line of centres
        self.parting = atan(first.tip_roll) - mesh.angle - self.half
        self.ring_half = self.space - roll_less_arc(second.tip_roll)

    def _follow(self, turn: float) -> float:
        """How far the ring turns; of an exact angle nothing is rounded away in numbers of more digits."""
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
        """How the clearance grows with the turn: the radius shrinks by a·sin θ, the angles by what each is of it."""
        x, y = self._place(turn)
        radius = hypot(x, y)
        along = -self.distance * y / radius
        arc = self._follow(turn) + self._half_space(radius) - atan2(y, x)
        roll = self.second.roll(2.0 * radius) if radius > self.ring else 0.0
        round_ = self.pinion * self.pinion + self.distance * (x - self.distance)
        return along * (arc - roll) + radius * self._follow(1.0) - round_ / radius

    def sideways(self, turn: float) -> float:
        """How much nearer the line of centres the pinion's corner is than the ring's."""
        return self.ring * sin(self._follow(turn) + self.ring_half) - self.pinion * sin(turn + self.half)

    def sideways_slope(self, turn: float) -> float:
        """How that grows with the turn."""
        own = self.ring * self._follow(1.0) * cos(self._follow(turn) + self.ring_half)
        return own - self.pinion * cos(turn + self.half)

    def ahead(self, turn: float) -> float:
        """How far the pinion's corner reaches beyond the ring's along the line of centres."""
        return self._place(turn)[0] - self.ring * cos(self._follow(turn) + self.ring_half)


def _last_turn(own: _Corner) -> float:
    """The turn at which the corner crosses the ring's tip circle."""
    a, pinion, ring = own.distance, own.pinion, own.ring
    cosine = (ring * ring - pinion * pinion - a * a) / (2.0 * a * pinion)
    return acos(minimum(1.0, maximum(-1.0, cosine))) - own.half


def _in_numbers_of(corner: _Corner, turn: float, last: float) -> float:
    """A turn found in plain numbers, exact as it is: a clearance that is least there is off by the square of its error.

    Where the search ended at the last turn, that turn's rounding counts.
    """
    return _last_turn(corner) if turn == last else like(turn, corner.distance)


def _least_after_crest(own: _Corner, last: float) -> float:
    """Where the clearance is least after contact has ended and the corner has come free."""
    first = min(own.parting, last)
    crest = extremum(lambda turn: -own.clearance(turn), lambda turn: -own.clearance_slope(turn), first, last)
    return extremum(own.clearance, own.clearance_slope, crest, last)


def _least_sideways(own: _Corner, last: float) -> float:
    """Where putting the pinion in radially leaves least, among corners that must pass the ring's."""
    high = last
    step = max(0.02, 0.25 * last)
    while own.ahead(high + step) > 0.0 and high + step + own.half < 0.5 * pi:
        high += step
    return extremum(own.sideways, own.sideways_slope, 0.0, high)


def extremum(function: "Callable[[float], float]", slope: "Callable[[float], float]", low: float, high: float) -> float:
    """Where a function is least: the best of a grid, or where beside that its slope changes sign, to the last bits."""
    step = (high - low) / _SAMPLES
    places = [*(low + step * k for k in range(_SAMPLES)), high]
    values = [function(x) for x in places]
    best = values.index(min(values))
    a, b = places[max(best - 1, 0)], places[min(best + 1, _SAMPLES)]
    if slope(a) < 0.0 < slope(b):
        return bisect(lambda x: -slope(x), a, b)
    return places[best]
