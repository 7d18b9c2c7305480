"""The crank-rocker of a swing and a time ratio whose force is transmitted best."""

from math import pi

from dynamics_cli.errors import require
from dynamics_cli.linkage.fourbar.closure import frame
from dynamics_cli.linkage.fourbar.grashof import kind_of, transmission
from dynamics_cli.numerics.elementary import absolute, acos, cos, sin
from dynamics_cli.numerics.roots import highest
from dynamics_cli.quantities import Angle, Positive

# Places tried along the circle of pivots.
PLACES = 720
# Maximum length of a crank-rocker's links, in rockers: in line, longer ones are always slightly better.
LONGEST = 3.0


def crank_rocker(swing: float, time_ratio: float, rocker: float) -> "tuple[float, float, float, float]":
    """Crank, coupler, rocker and ground link with the largest smallest transmission angle.

    The crank's pivot sees both ends of the rocker's swing under the angle by which the slow stroke exceeds half a turn.
    """
    require(0.0 < swing < pi, "a swing of {swing} is not between 0 and 180 deg", swing=(swing, Angle), code="swing",
            hint="for example 60 deg")  # fmt: skip
    require(
        time_ratio >= 1.0, "a time ratio is the slow stroke's time over the quick one's: at least 1", code="ratio",
        hint="give its reciprocal",
    )  # fmt: skip
    lag = pi * (time_ratio - 1.0) / (time_ratio + 1.0)

    def quality(place: float) -> float:
        return _quality(swing, rocker, lag, place)

    best = max(range(1, PLACES), key=lambda k: quality(k / PLACES))
    position = highest(quality, (best - 1) / PLACES, (best + 1) / PLACES, 1e-12 * best / PLACES)
    require(
        quality(position) > 0.0,
        "no crank-rocker swings through {swing} with a time ratio of {ratio}",
        swing=(swing, Angle),
        ratio=(time_ratio, Positive),
        code="no-linkage",
        hint="take a smaller swing or time ratio",
    )
    return _lengths(swing, rocker, lag, position)


def smallest(lengths: "tuple[float, float, float, float]") -> float:
    """The smallest transmission angle of a whole turn, as an angle up to 90 degrees."""
    least, greatest = transmission(frame(*lengths))
    return min(least, pi - greatest)


def _lengths(swing: float, rocker: float, lag: float, share: float) -> "tuple[float, float, float, float]":
    """Links with O₂ at a place of the circle from which the rocker's ends are seen under the lag."""
    c, half = rocker, 0.5 * swing
    ends = c * complex(sin(half), cos(half)), c * complex(-sin(half), cos(half))
    chord = abs(ends[0] - ends[1])
    if lag < 1e-12:
        # in line with the ends, beyond one of them
        crank_pivot = ends[1] - chord * share / (1.0 - share)
    else:
        radius = 0.5 * chord / sin(lag)
        middle = complex(0.0, ends[0].imag - 0.5 * chord * cos(lag) / sin(lag))
        # the arc below the chord, seen from its centre
        angle = -0.5 * pi - (pi - lag) * (1.0 - 2.0 * share)
        crank_pivot = middle + radius * complex(cos(angle), sin(angle))
    far, near = abs(ends[0] - crank_pivot), abs(ends[1] - crank_pivot)
    return 0.5 * absolute(far - near), 0.5 * (far + near), c, abs(crank_pivot)


def _quality(swing: float, rocker: float, lag: float, share: float) -> float:
    """The smallest |sin μ| of a crank-rocker with this swing; nothing else counts."""
    lengths = _lengths(swing, rocker, lag, share)
    a, b, c, d = lengths
    if not 1e-9 * c < min(lengths) <= max(lengths) <= LONGEST * c or kind_of(lengths) != "crank-rocker":
        return 0.0
    far = (c * c + d * d - (a + b) * (a + b)) / (2.0 * c * d)
    near = (c * c + d * d - (b - a) * (b - a)) / (2.0 * c * d)
    if abs(far) >= 1.0 or abs(near) >= 1.0 or absolute(acos(far) - acos(near) - swing) > 1e-6:
        return 0.0
    return smallest(lengths)
