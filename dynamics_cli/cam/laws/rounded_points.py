"""Effect of rounded points on a spline's derivatives: points of a table are rounded to some decimal."""

from itertools import pairwise
from math import floor, pi

from dynamics_cli.cam.laws.peaks import extremes
from dynamics_cli.errors import worded
from dynamics_cli.quantities import Fraction, Ratio
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.cam.laws.normalised import Law

# Fewer points than this were chosen, not read from a table.
FEWEST = 4
MOST_DECIMALS = 9
# No advice below the first share of the peak acceleration, a caution from the second on.
SMALL, LARGE = 1e-4, 1e-2
# Units that lifts and angles may be written in, besides SI.
LENGTHS = (1.0, 0.0254)
ANGLES = (1.0, pi / 180.0)


def decimal_step(values: "Sequence[float]", units: "Sequence[float]" = (1.0,)) -> float:
    """The largest decimal step, in one of the units, of which all values are multiples; zero if there is no such step.

    `units`: units they may have been written in. Returns the step.

    Examples
    --------
    >>> decimal_step([0.25, 0.5, 0.125]), decimal_step([0.1, 1 / 3])
    (0.001, 0.0)
    """
    largest = 0.0
    for unit in units:
        for decimals in range(MOST_DECIMALS + 1):
            counts = [value / unit * 10.0**decimals for value in values]
            if all(abs(count - floor(count + 0.5)) <= 1e-5 for count in counts):
                largest = max(largest, unit / 10.0**decimals)
                break
    return largest


def effects(law: "Law", place_step: float, lift_step: float) -> "tuple[float, float, float]":
    """Maximum errors of velocity, acceleration and jerk of a spline with rounded points.

    `law`: a clamped cubic spline; `place_step`, `lift_step`: steps that the places and the lifts of its points are
    rounded to. Returns bounds to first order of the changes at the joints, in units of the rise.

    A spline is linear in its lifts: each counts half a step. A place error δ counts as a lift error f′δ.
    Slopes and second derivatives solve systems whose diagonals dominate: with the least favourable signs they give
    bounds of both. Errors that alternate up and down reach the bounds for equally spaced points.
    """
    places = [0.0, *law.breaks, 1.0]
    wide = [b - a for a, b in pairwise(places)]
    # both ends are the ends of the rise
    off = [0.0, *(0.5 * (lift_step + place_step * abs(law.at(x, 1)[1])) for x in law.breaks), 0.0]
    chords = [(a + b) / h for a, b, h in zip(off[:-1], off[1:], wide, strict=True)]
    inner = range(1, len(wide))
    spread = [2.0 * (wide[i - 1] + wide[i]) for i in inner]
    slopes = _dominated(
        [0.0, *wide[1:], 0.0], [1.0, *spread, 1.0], [0.0, *wide[:-1], 0.0],
        [0.0, *(3.0 * (wide[i] * chords[i - 1] + wide[i - 1] * chords[i]) for i in inner), 0.0],
    )  # fmt: skip
    bends = _dominated(
        [0.0, *wide], [2.0 * wide[0], *spread, 2.0 * wide[-1]], [*wide, 0.0],
        [6.0 * chords[0], *(6.0 * (chords[i - 1] + chords[i]) for i in inner), 6.0 * chords[-1]],
    )  # fmt: skip
    return max(slopes), max(bends), max((a + b) / h for a, b, h in zip(bends[:-1], bends[1:], wide, strict=True))


def _dominated(left: "list[float]", middle: "list[float]", right: "list[float]", rhs: "list[float]") -> "list[float]":
    """Bounds of the solution of a tridiagonal system for right sides of any sign within `rhs` (Thomas)."""
    upper, solution = [right[0] / middle[0]], [rhs[0] / middle[0]]
    for i in range(1, len(rhs)):
        pivot = middle[i] - left[i] * upper[-1]
        upper.append(right[i] / pivot)
        solution.append((rhs[i] + left[i] * solution[-1]) / pivot)
    for i in range(len(rhs) - 2, -1, -1):
        solution[i] += upper[i] * solution[i + 1]
    return solution


def rounding_advice(law: "Law", where: str = "") -> "tuple[Advice, ...]":
    """Advice on a law through points of a table; none for any other.

    `where`: its name in the message. The advice gives the largest possible changes by rounding, relative to the peaks.
    """
    if law.steps is None or len(law.breaks) < FEWEST or not law.steps[1]:
        return ()
    place_step, lift_step = law.steps
    # places with as few digits as the lifts are rounded too; others were chosen
    changes = effects(law, place_step if place_step <= lift_step else 0.0, lift_step)
    peaks = [max(abs(value) for _, value in extremes(law, order)) for order in (1, 2, 3)]
    relative = [change / top if top else 0.0 for change, top in zip(changes, peaks, strict=True)]
    if max(relative[:2]) < SMALL:
        return ()
    v, a, j = ((ratio, Fraction) for ratio in relative)
    message = worded(
        where + "the lifts of the points are multiples of {step:3} of the rise: if they are rounded to that, velocity, "
        "acceleration and jerk are off by up to {v:2}, {a:2} and {j:2} of their peaks; the error bounds hold for the "
        "points as given",
        step=(lift_step, Ratio), v=v, a=a, j=j,
    )  # fmt: skip
    remedy = "give the points with more digits"
    return (Advice("rounded-points", message, "caution" if relative[1] >= LARGE else "note", remedy),)
