"""The task `equilibrium`: equilibria of a potential, or of states with given rates, and whether they are stable."""

import itertools
import math

from dynamics_cli.errors import UsageError, require, require_given
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.expressions.laws import law_of, parsed
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    Count,
    EnergyFormula,
    Frequency,
    GrowthRate,
    Inertia,
    Length,
    Mass,
    PotentialEnergy,
    Text,
    Variable,
)
from dynamics_cli.records import Advice, ErrorBound, Numerics, record
from dynamics_cli.sampling import cost, drawing
from dynamics_cli.stability.equilibria.autonomous import StatePlace
from dynamics_cli.stability.equilibria.multiple import distinct
from dynamics_cli.stability.equilibria.rates import State

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence
    from typing import Any

    Potential = Callable[[float, int], list[float]]
    # A place and the Taylor coefficients there.
    Sample = tuple[float, list[float]]

SAMPLES = 1200
# Those of a sample of uncertain inputs, halvings that a secant ends, and the seconds that such a sample takes.
FEWER, HALVINGS, COST = 160, 20, 0.01
ORDER = 8
# A derivative below this share of the potential's own variation is taken for zero.
NOTHING = 1e-9
# Slopes that pass zero by less than this share of the largest touch it; zeros are parted by derivatives up to this one.
TOUCH, DEEPEST = 1e-13, 4
# Angles nearer than this to an end of the turn are there.
ENDS = 1e-9
ANGLES = ("theta", "θ")
POSITION = "x"


@record
class Place:
    """One equilibrium."""

    position: Annotated[Length | None, "Where it is, of a coordinate x [m]."]
    angle: Annotated[Angle | None, "Where it is, of an angle [rad]."]
    energy: Annotated[PotentialEnergy, "Potential there [J]."]
    verdict: Annotated[Text, "Stable or unstable."]
    curvature: Annotated[float, "Second derivative of the potential, in J/m² or J/rad²."]
    frequency: Annotated[Frequency | None, "Frequency of small oscillations; of stable ones, with the inertia [Hz]."]
    growth: Annotated[GrowthRate | None, "Rate at which it leaves; of unstable ones, with the inertia [1/s]."]


@record
class Equilibria:
    """The equilibria of a potential, or of states."""

    stable: Annotated[Count, "Stable equilibria."]
    unstable: Annotated[Count, "Unstable equilibria."]
    undecided: Annotated[Count | None, "Equilibria of states that neither linear nor higher terms decide."]
    growth: Annotated[
        GrowthRate | None, "Fastest growth, at an unstable equilibrium; zero where none is unstable [1/s]."
    ]
    decay: Annotated[GrowthRate | None, "Slowest decay, at a stable equilibrium of states [1/s]."]
    frequency: Annotated[Frequency | None, "Lowest frequency of oscillations at a stable equilibrium [Hz]."]
    places: Annotated[tuple[Place, ...] | None, "The equilibria of a potential, in order."]
    points: Annotated[tuple[StatePlace, ...] | None, "The equilibria of states, in order."]
    numerics: Numerics
    advice: tuple[Advice, ...] = ()


def equilibrium(
    *,
    potential: Annotated[
        EnergyFormula | None, "Energy as a formula of x [m] or theta [rad], its unit at its end, e.g. 4*x^4 - 2*x^2 J."
    ] = None,
    states: Annotated[tuple[State, ...], "States with their rates, time in s, instead of a potential."] = (),
    let: Annotated[tuple[Variable, ...], "Variables of the formulas, e.g. k=200 N/m."] = (),
    lowest: Annotated[Length | None, "Where the range of x begins, e.g. -2 m."] = None,
    highest: Annotated[Length | None, "Where it ends, e.g. 2 m."] = None,
    mass: Annotated[Mass | None, "The mass that moves along x, for frequencies, e.g. 2 kg."] = None,
    inertia: Annotated[
        Inertia | None, "The moment of inertia about the pivot, for frequencies, e.g. 0.5 kg*m^2."
    ] = None,
) -> Equilibria:
    """Equilibria of a potential, stable where it has a minimum, or of states with any rates, by their roots.

    Equation
    --------
    V′ = 0; stable where the first derivative after it that is not zero is of even order and positive; ω = √(V″/m).
    Or ẋ = f(x) = 0; stable where all roots of det(s·1 − ∂f/∂x) lie on the left. Where one root lies at zero and
    the rest on the left, the first term along its direction decides; where one pair lies on the axis, terms of third
    order do; where they vanish too, two states without divergence have a centre.

    Returns
    -------
    Equilibria
        Every equilibrium within the range, with frequency or growth where the inertia is given.

    Raises
    ------
    UsageError
        When the formula has neither x nor theta, or both; when the range of x is missing.
    InadmissibleError
        When the potential is constant, no equilibrium lies within the ranges, or they form a curve.

    Notes
    -----
    An angle is searched through one turn. Rotating frames and the like go in by their effective potential.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 14.2 and 14.3 (Lagrange–Dirichlet).

    Examples
    --------
    >>> from dynamics_cli.records import Formula
    >>> equilibrium(potential=Formula("4*x^4 - 2*x^2", 1.0, "J"), lowest=-2.0, highest=2.0).stable
    2
    """
    if states:
        if potential is not None:
            raise UsageError("a potential is given and states too", code="ambiguous", hint="leave out one of them")
        return _of_states(states, let)
    require_given(potential is not None, "neither a potential nor states are given", ("potential",), ("states",))
    assert potential is not None
    names = parsed(potential, {*ANGLES, POSITION, *(one.name for one in let)}).names
    angular = [name for name in ANGLES if name in names]
    coordinates = [*angular, *([POSITION] if POSITION in names else [])]
    if len(coordinates) != 1:
        raise UsageError(
            f"the formula {potential.text!r} has {'x and an angle' if coordinates else 'neither x nor theta'}",
            code="coordinate", parameter="potential", hint="one coordinate: x for a length, theta for an angle",
        )  # fmt: skip
    value = _taylor(potential, let, coordinates[0])
    if angular:
        low, high = -math.pi, math.pi
    else:
        require_given(lowest is not None and highest is not None, "the range of x is missing", ("lowest", "highest"))
        assert lowest is not None
        assert highest is not None
        low, high = lowest, highest
        require(low < high, "the range ends at {high}, before it begins at {low}", high=(high, Length),
                low=(low, Length), code="range")  # fmt: skip
    found = _equilibria(value, low, high, FEWER if drawing() else SAMPLES)
    if drawing():
        cost(0.0, COST, 1)
    unit = inertia if angular else mass
    reach = 0.1 * (high - low)
    kept = distinct(lambda at, order: _slopes(value, at, order), found, reach)
    if angular and kept[0][0] < low + ENDS:
        # both ends of the turn are one place
        kept = [*kept[1:], *([] if kept[-1][0] > high - ENDS else [(high, kept[0][1])])]
    places = tuple(_place(value, one, bool(angular), unit, reach) for one in kept)
    stable = len([place for place in places if place.verdict.startswith("stable")])
    return Equilibria(
        stable=stable,
        unstable=len(places) - stable,
        undecided=None,
        growth=max(place.growth or 0.0 for place in places) if unit else None,
        decay=None,
        frequency=_smallest(place.frequency for place in places),
        places=places,
        points=None,
        numerics=Numerics(
            "roots by halving on exact derivatives", () if drawing() else tuple(_bounds(value, places, bool(angular)))
        ),
    )


def _of_states(states: "tuple[State, ...]", let: "tuple[Variable, ...]") -> Equilibria:
    from dynamics_cli.stability.equilibria.autonomous import place_bounds, state_places

    points = state_places(states, let)
    stable, undecided = ([p for p in points if p.verdict.startswith(word)] for word in ("stable", "undecided"))
    return Equilibria(
        stable=len(stable),
        unstable=len(points) - len(stable) - len(undecided),
        undecided=len(undecided),
        growth=max((point.rightmost for point in points if point.unstable_directions), default=0.0),
        decay=_smallest(-point.rightmost for point in stable if point.rightmost < 0.0),
        frequency=_smallest(point.frequency for point in stable),
        places=None,
        points=points,
        numerics=Numerics(
            "Newton's method from even starts, exact slopes; roots of the slopes enclosed",
            () if drawing() else tuple(place_bounds(points, states, let)),
        ),
        advice=_advice(points),
    )


def _advice(points: "tuple[StatePlace, ...]") -> "tuple[Advice, ...]":
    """What linear terms cannot say, where they leave an equilibrium open."""
    open_points = [point for point in points if point.verdict.startswith("undecided")]
    if not open_points:
        return ()
    if any(point.frequency for point in open_points):
        kind = "the linear motion goes round with the frequency shown and neither grows nor decays"
    else:
        kind = "in the direction of a root at zero the linear motion neither leaves nor returns"
    text = f"{kind}: the linear terms leave open whether the full equations do, and so do the terms beyond them"
    remedy = "look for a conserved energy (--potential), or integrate from beside it"
    return (Advice("undecided", text, remedy=remedy),)


def _smallest(values: "Iterable[float | None]") -> "float | None":
    return min((value for value in values if value is not None), default=None)


def _taylor(potential: EnergyFormula, let: "tuple[Variable, ...]", name: str) -> "Potential":
    law = law_of(potential, let, (name,))

    def parts(at: float, order: int) -> "list[float]":
        """Taylor coefficients of the potential; nothing where it has none."""
        try:
            taylor = law(**{name: Jet.variable(at, order)})
        except (ArithmeticError, ValueError):
            return [math.nan] * (order + 1)
        return list(taylor.parts)

    return parts


def _equilibria(value: "Potential", low: float, high: float, samples: int) -> "list[float]":
    step = (high - low) / samples
    # a third of a step off, so that symmetric potentials are not sampled at their equilibria
    places = [low + (k + 1.0 / 3.0) * step for k in range(-1, samples + 1)]
    slopes = [value(at, DEEPEST) for at in places]
    largest = max((abs(parts[1]) for parts in slopes if math.isfinite(parts[1])), default=0.0)
    require(largest > 0.0, "the potential is the same everywhere within the range", code="constant",
            hint="check the formula and its range")  # fmt: skip
    found = []
    for k, (one, other) in enumerate(itertools.pairwise(slopes)):
        if math.isfinite(one[1]) and math.isfinite(other[1]):
            found += [places[k]] if one[1] == 0.0 else []
            found += _roots(value, 1, (places[k], one), (places[k + 1], other), TOUCH * largest)
    span = high - low
    found = [0.0 if abs(at) < NOTHING * step else at for at in found]
    inside = [at for at in found if low - NOTHING * span < at <= high + NOTHING * span]
    kept = [at for at in inside if _is_zero(value, at, largest)]
    require(bool(kept), "the potential has no equilibrium within the range", code="no-equilibrium",
            hint="widen the range, or check the signs of the formula")  # fmt: skip
    return kept


def _roots(value: "Potential", order: int, low: "Sample", high: "Sample", nothing: float) -> "list[float]":
    """Where a derivative is zero between two samples: between the zeros of the next one it is monotonic.

    Zeros that it hardly passes beyond, by no more than `nothing`, are one, and one where it only touches zero.
    """
    beyond = _roots(value, order + 1, low, high, 0.0) if order < DEEPEST else []
    marks = [(low[0], low[1][order]), *((at, value(at, order)[order]) for at in beyond), (high[0], high[1][order])]
    found = []
    before, touch = marks[0], None
    for k, (at, slope) in enumerate(marks[1:], 1):
        if slope == 0.0 or (k < len(marks) - 1 and abs(slope) <= nothing):
            touch = at
            continue
        if before[1] * slope < 0.0:
            found.append(_halved(value, order, before[0], at))
        elif touch is not None and before[1] * slope > 0.0:
            found.append(touch)
        before, touch = (at, slope), None
    return found


def _is_zero(value: "Potential", at: float, largest: float) -> bool:
    """Whether the slope is small there: it also changes its sign at a pole."""
    slope = value(at, 1)[1]
    return math.isfinite(slope) and abs(slope) <= 1e-6 * largest


def _halved(value: "Potential", order: int, low: float, high: float) -> float:
    below = value(low, order)[order] < 0.0
    for _ in itertools.repeat(None, HALVINGS) if drawing() else itertools.repeat(None):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return middle
        at = value(middle, order)[order]
        if at == 0.0:
            return middle
        low, high = (middle, high) if (at < 0.0) == below else (low, middle)
    one, two = (value(at, order)[order] for at in (low, high))
    return low + (high - low) * one / (one - two)


def _bounds(value: "Potential", places: "Sequence[Place]", angular: bool) -> "Iterator[ErrorBound]":
    """Of simple places: twice the slope there and its rounding, over the curvature."""
    name = "angle" if angular else "position"
    for nth, place in enumerate(places):
        (at,) = Tracked.inputs([getattr(place, name)])
        if place.curvature:
            slope: Any = value(at, 1)[1]  # type: ignore[arg-type]
            yield ErrorBound(
                f"places[{nth}].{name}", 2.0 * (abs(slope.value) + slope.error) / abs(place.curvature), relative=False
            )


def _slopes(value: "Potential", at: float, order: int) -> "list[float]":
    """Taylor coefficients of the slope."""
    return [k * part for k, part in enumerate(value(at, order + 1)[1:], 1)]


def _place(
    value: "Potential", centred: "tuple[float, int]", angular: bool, inertia: "float | None", reach: float
) -> Place:
    at, multiplicity = centred
    parts = value(at, ORDER)
    size = max(abs(part) * reach**k for k, part in enumerate(parts[1:], 1)) or 1.0
    order = next((k for k in range(multiplicity + 1, ORDER + 1) if abs(parts[k]) * reach**k > NOTHING * size), 0)
    curvature = 2.0 * parts[2] if order == 2 else 0.0
    if order and order % 2 == 0:
        verdict = "stable" if parts[order] > 0.0 else "unstable"
    else:
        verdict = "unstable on one side" if order else "neutral"
    if order > 2:
        verdict += f", degenerate: by the derivative of order {order}"
    rate = math.sqrt(abs(curvature) / inertia) if inertia else None
    return Place(
        position=None if angular else at,
        angle=at if angular else None,
        energy=parts[0],
        verdict=verdict,
        curvature=curvature,
        frequency=rate / (2.0 * math.pi) if rate is not None and curvature > 0.0 else None,
        growth=rate if rate is not None and curvature < 0.0 else None,
    )
