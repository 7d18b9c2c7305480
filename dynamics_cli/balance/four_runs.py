"""Balancing in one plane by amplitudes alone: one run as it is, three with a trial weight at known angles."""

from dynamics_cli.balance.phasors import Phasor, cross, polar, total
from dynamics_cli.balance.radii import at_radius, require_radii
from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, sqrt
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Angle, Annotated, BalanceMass, FreeNumber, FreeVector, Kind, Ratio, Size, Unbalance
from dynamics_cli.records import Advice, Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

THIRD = 2.0943951023931957
NAMES = ("initial", "first", "second", "third")
# Angles of weights closer together than this (as twice the area of their triangle on a unit circle) tell nothing.
FLAT = 1e-3
# Circles that stay apart by more than this share of the initial reading are no scatter of readings.
APART = 0.1
# A consistency this far from 1 is worth repeating the runs.
OFF = 0.1


@record
class Run:
    """One run with the trial weight."""

    weight_at: Annotated[Angle, "Where the weight was [rad]."]
    reading: Annotated[FreeNumber, "Reading of this run."]
    miss: Annotated[FreeNumber, "Distance of this run's circle from the point found, positive where it is too large."]


@record
class FourRuns:
    """The correction of four runs, and how well they agree."""

    mass: Annotated[BalanceMass, "Mass to add, at the radius of the trial weight or of the correction [kg]."]
    angle: Annotated[Angle, "Where to add it, in the sense of the trial angles [rad]."]
    unbalance: Annotated[Unbalance | None, "That mass times its radius; none without the radius [kg·m]."]
    consistency: Annotated[Ratio, "1 where the circles meet in one point: quality of the readings [-]."]
    miss: Annotated[FreeNumber, "By how much the circles miss one point at most."]
    effect: Annotated[FreeNumber, "What the trial weight alone makes the sensor read."]
    runs: Annotated[tuple[Run, ...], "The three runs with the weight."]
    advice: tuple[Advice, ...] = ()


def four_runs(
    *,
    initial: Annotated[FreeVector, "Reading without a weight, an amplitude alone, e.g. 6 mm/s."],
    first: Annotated[FreeVector, "Reading with the weight at the first angle, e.g. 4 mm/s."],
    second: Annotated[FreeVector, "Reading with it at the second angle, e.g. 9 mm/s."],
    third: Annotated[FreeVector, "Reading with it at the third angle, e.g. 7.5 mm/s."],
    trial_mass: Annotated[BalanceMass, "Mass of the trial weight, the same in all three runs, e.g. 10 g."],
    first_angle: Annotated[Angle, "Where the weight is in the first of them."] = 0.0,
    second_angle: Annotated[Angle, "Where it is in the second."] = THIRD,
    third_angle: Annotated[Angle, "Where it is in the third."] = 2.0 * THIRD,
    trial_radius: Annotated[Size | None, "Its radius, for the correction as an unbalance, e.g. 100 mm."] = None,
    correction_radius: Annotated[Size | None, "Radius of the correction, if another, e.g. 120 mm."] = None,
) -> FourRuns:
    """Correction in one plane from amplitudes without phase: the method of four runs, or of three circles.

    Equation
    --------
    Tₖ² = O² + t² + 2·z·(cos φₖ, sin φₖ) for the three runs; correction −z·W/t², and |z|/(O·t) = 1 of readings that
    agree. At 0, 120 and 240 degrees t² = ⅓ΣTₖ² − O² and z = ⅓ΣTₖ²·e^{iφₖ}.

    Returns
    -------
    FourRuns
        The correction, and how far the circles are from meeting in one point.

    Raises
    ------
    InadmissibleError
        When readings are of different kinds or have a phase, the trial weight is zero, two angles are the same, or
        the circles do not meet.

    References
    ----------
    Law of cosines. The circles have the radii Tₖ, their centres at the angles of the weight on a circle of radius O.

    Examples
    --------
    >>> runs = four_runs(initial=6.0, first=4.0, second=9.0, third=7.5, trial_mass=0.010)
    >>> round(runs.mass * 1e3, 6), round(runs.consistency, 6)
    (12.55749, 0.812831)
    """
    kind, (still, *sizes) = _amplitudes(initial, first, second, third)
    require(trial_mass > 0.0, "a trial weight of zero changes nothing", code="no-weight")
    require_radii(trial_radius, correction_radius)
    require(plain(still) > 0.0, "the initial reading is zero: there is nothing to balance", code="nothing-to-balance")
    places = [polar(1.0, angle) for angle in (first_angle, second_angle, third_angle)]
    square, response = _fitted(still, sizes, places)
    require(
        plain(square) > 0.0,
        "the circles do not meet: with the weight the readings are too small on the whole",
        code="no-circles",
        hint="repeat the runs at one speed, and check that the weight was at these angles",
    )
    _require_meeting(plain(still), [plain(size) for size in sizes], places)
    effect = sqrt(square)
    consistency = response.size / (still * effect)
    mass = trial_mass * response.size / square
    centre = -response.times(1.0 / still)
    number = Kind(kind.name, kind.unit, si=kind.si, us=kind.si)  # in the unit that was written
    misses = [size - (centre - place.times(still)).size for place, size in zip(places, sizes, strict=True)]
    return FourRuns(
        mass=at_radius(mass, trial_radius, correction_radius),
        angle=(-response).angle,
        unbalance=None if trial_radius is None else mass * trial_radius,
        consistency=consistency,
        miss=Quantity(max(map(absolute, misses), key=plain), number),
        effect=Quantity(effect, number),
        runs=tuple(
            Run(angle, *(Quantity(value, number) for value in values))
            for angle, *values in zip((first_angle, second_angle, third_angle), sizes, misses, strict=True)
        ),
        advice=_advice(plain(consistency), plain(effect) / plain(still)),
    )


def _amplitudes(*readings: "Any") -> "tuple[Any, list[Any]]":
    """The kind of the readings, and their sizes."""
    first = readings[0].kind if isinstance(readings[0], Quantity) else Kind("number", "")
    sizes = []
    for name, reading in zip(NAMES, readings, strict=True):
        value, kind = (reading.value, reading.kind) if isinstance(reading, Quantity) else (reading, first)
        parts = value if isinstance(value, tuple | list) else (value,)
        require(len(parts) == 1, "the {name} reading has a phase", code="phase", name=name,
                hint="with phases one trial run is enough: dynamics balance trial")  # fmt: skip
        require(kind.unit == first.unit, "the {name} reading is {other}, the initial one {one}",
                code="mixed-kinds", hint="give all readings in one kind of unit", name=name, one=first.one,
                other=kind.one)  # fmt: skip
        require(plain(parts[0]) >= 0.0, "the {name} reading is below zero", code="negative", name=name,
                hint="an amplitude has no sign")  # fmt: skip
        sizes.append(parts[0])
    return first, sizes


def _fitted(still: "Any", sizes: "list[Any]", places: "list[Phasor]") -> "tuple[Any, Phasor]":
    """t² and z of the plane through the squares of the readings over the places of the weight."""
    a, b, c = places
    area = cross(b - a, c - a)
    require(
        abs(plain(area)) > FLAT,
        "two runs have the weight at almost the same angle",
        code="same-angle",
        hint="put it at three angles, 0, 120 and 240 deg where that is possible",
    )
    squares = [size * size for size in sizes]
    opposite = [(b, c), (c, a), (a, b)]
    mean = sum(T * cross(*pair) for T, pair in zip(squares, opposite, strict=True)) / area
    slopes = [(p - q).times(T) for T, (p, q) in zip(squares, opposite, strict=True)]
    slope = total(slopes)
    return mean - still * still, Phasor(slope.y / (2.0 * area), -slope.x / (2.0 * area))


def _require_meeting(still: float, sizes: "list[float]", places: "list[Phasor]") -> None:
    """Refuse two circles that are outside one another, or one inside the other."""
    for i, j in ((0, 1), (1, 2), (0, 2)):
        between = still * plain((places[i] - places[j]).size)
        outside, inside = between - sizes[i] - sizes[j], abs(sizes[i] - sizes[j]) - between
        words = "too small together" if outside > inside else "too different"
        require(
            max(outside, inside) <= APART * still,
            "the circles of the {one} and {other} runs do not meet: their readings are {words}",
            code="no-circles",
            hint="repeat these runs at one speed, and check that the weight was at these angles",
            one=NAMES[1 + i], other=NAMES[1 + j], words=words,
        )  # fmt: skip


def _advice(consistency: float, share: float) -> "tuple[Advice, ...]":
    advice = []
    if abs(consistency - 1.0) > OFF:
        text = "the readings do not agree: consistency is {value}, wanted 1"
        advice.append(Advice("inconsistent", worded(text, value=(consistency, Ratio)),
                             remedy="repeat the runs at one speed, and make a trim run"))  # fmt: skip
    if share < OFF:
        text = "the trial weight makes {share} of the initial reading: its effect is mostly scatter"
        advice.append(Advice("weak-trial", worded(text, share=(share, Ratio)), remedy="take a heavier trial weight"))
    return tuple(advice)
