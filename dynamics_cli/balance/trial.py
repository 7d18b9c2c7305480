"""Balancing from trial weights: influence coefficients from readings, and the corrections that still them best."""

from dynamics_cli.balance.influence import condition, norm, solved, solved_together
from dynamics_cli.balance.phasors import Phasor, polar, scale_of, total
from dynamics_cli.balance.radii import corrected, require_radii
from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import (
    Angle,
    Annotated,
    BalanceMass,
    Fraction,
    FreeNumber,
    FreeVector,
    Kind,
    Positive,
    Ratio,
    Size,
    Unbalance,
)
from dynamics_cli.records import Advice, Check, Choice, Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Planes told apart worse than this: errors of readings grow as much in the masses.
POOR = 10.0
# Nothing but rounding tells such planes apart.
BEYOND = 1e12
# Less of the readings than this is left by rounding.
ROUNDING = 1e-12
# A trial weight should change the readings by this share of them at least.
WEAK = 0.1


class Phase(Choice):
    """How the phase of a reading is counted beside the angles of the weights."""

    names = ("lead", "lag")


LEAD = Phase("lead")


@record
class TrialWeight:
    """A trial weight in one plane."""

    mass: Annotated[BalanceMass, "Mass of the trial weight, e.g. 1.15 g."]
    angle: Annotated[Angle, "Where it is put, e.g. 0 deg."]
    radius: Annotated[Size | None, "Its radius, for the correction as an unbalance, e.g. 100 mm."] = None
    correction_radius: Annotated[Size | None, "Radius of the correction, if another, e.g. 120 mm."] = None


@record
class Sensor:
    """The readings of one sensor at one speed, in every run."""

    initial: Annotated[FreeVector, "Reading without weights, e.g. 170 um @ 112 deg."]
    first: Annotated[FreeVector, "Reading with the weight in the first plane, e.g. 235 um @ 94 deg."]
    second: Annotated[FreeVector | None, "Reading with the weight in the second plane, e.g. 186 um @ 115 deg."] = None
    runout: Annotated[FreeVector | None, "Slow-roll reading, subtracted from all others, e.g. 4 um @ 20 deg."] = None
    weight: Annotated[Positive, "Weight of its residual relative to the others."] = 1.0
    now: Annotated[
        FreeVector | None, "Reading with weights added since, for a trim: what to add to them, e.g. 12 um @ 95 deg."
    ] = None


@record
class Coefficient:
    """What one gram in a plane does to a sensor."""

    sensor: Annotated[int, "Number of the sensor (or speed) [-]."]
    plane: Annotated[int, "Number of the plane [-]."]
    per_gram: Annotated[FreeNumber, "Change of the reading for one gram."]
    angle: Annotated[Angle, "By how much it leads the weight [rad]."]


@record
class Predicted:
    """What a sensor should read after the correction."""

    sensor: Annotated[int, "Number of the sensor (or speed) [-]."]
    initial: Annotated[FreeNumber, "Amount before, or now."]
    residual: Annotated[FreeNumber, "Expected amount afterwards."]
    share: Annotated[Fraction, "After over before [-]."]


@record
class TrialBalance:
    """Corrections from trial weights."""

    first_mass: Annotated[
        BalanceMass, "Mass to add in the first plane, at the radius of the trial weight or of the correction [kg]."
    ]
    first_angle: Annotated[Angle | None, "Where to add it; none of nothing [rad]."]
    first_unbalance: Annotated[Unbalance | None, "That mass times its radius; none without the radius [kg·m]."]
    second_mass: Annotated[BalanceMass | None, "Mass to add in the second plane; none without one [kg]."]
    second_angle: Annotated[Angle | None, "Where to add it; none of nothing [rad]."]
    second_unbalance: Annotated[Unbalance | None, "That mass times its radius; none without the radius [kg·m]."]
    condition: Annotated[
        Ratio | None,
        "How well the readings separate the planes: 1 is best, above 10 is poor; none of planes that act alike [-].",
    ]
    coefficients: Annotated[tuple[Coefficient, ...], "Influence coefficients."]
    predicted: Annotated[tuple[Predicted, ...], "Readings before, and those expected afterwards."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def trial(
    *,
    sensors: Annotated[Sensor | tuple[Sensor, ...], "Readings of each sensor at each speed."],
    first_trial: Annotated[TrialWeight, "The weight in the first plane."],
    second_trial: Annotated[
        TrialWeight | None, "The weight in the second plane; without it one plane is balanced."
    ] = None,
    left_on: Annotated[bool, "The first weight stayed on during the second trial run."] = False,
    phase: Annotated[Phase, "lead: phases are measured in the sense of the weights' angles; lag: against it."] = LEAD,
    largest_condition: Annotated[Ratio, "A worse condition of the planes than this is refused."] = 100.0,
    drop_dependent: Annotated[
        bool, "Where planes cannot be told apart, correct only what both do together (truncated SVD)."
    ] = False,
) -> TrialBalance:
    """Corrections in one or two planes from readings with trial weights, by influence coefficients.

    Equation
    --------
    α = (V₁ − V₀)/W for each plane; the corrections x make Σ|α·x + V₀|² least, exactly zero with as many readings as
    planes.

    Returns
    -------
    TrialBalance
        Corrections, influence coefficients, expected readings, condition of the planes.

    Raises
    ------
    InadmissibleError
        When a reading has no phase, kinds of readings differ, a trial weight changed nothing, readings are fewer than
        planes, or the planes cannot be told apart.

    References
    ----------
    Goodman, A least-squares method for computing balance corrections, J. Eng. Industry 86 (1964) 273.

    Examples
    --------
    >>> made = trial(sensors=Sensor((6.0, 0.0), (6.0, 3.0)), first_trial=TrialWeight(0.005, 0.0))
    >>> round(made.first_mass, 12)
    0.01
    """
    rows = sensors if isinstance(sensors, tuple) else (sensors,)
    weights = [first_trial] if second_trial is None else [first_trial, second_trial]
    kind = _kind(rows)
    require(
        len(rows) >= len(weights),
        "{rows} reading cannot balance {planes} planes",
        code="too-few",
        hint="give --sensor once for each sensor and each speed, or balance one plane",
        rows=str(len(rows)), planes=str(len(weights)),
    )  # fmt: skip
    for one in weights:
        require(one.mass > 0.0, "a trial weight of zero changes nothing", code="no-weight")
        require_radii(one.radius, one.correction_radius)
    initial, columns = _influence(rows, weights, phase, left_on=left_on)
    scales = [one.weight for one in rows]
    scaled = [[a.times(s) for a, s in zip(column, scales, strict=True)] for column in columns]
    apart = condition(scaled)
    right = [-v.times(s) for v, s in zip(initial, scales, strict=True)]
    together = apart > min(plain(largest_condition), BEYOND)
    masses = (solved_together if together else solved)(scaled, right)
    left = [
        total([v, *(column[row] * mass for column, mass in zip(columns, masses, strict=True))])
        for row, v in enumerate(initial)
    ]
    exact = len(rows) == len(weights) and not together
    off = plain(norm(left)) / (plain(norm(initial)) or 1.0)
    if together and not drop_dependent:
        _refuse_dependent(apart, off)
    number = _number(kind)
    put = [corrected(mass, one, scale_of(masses)) for mass, one in zip(masses, weights, strict=True)]
    first, second = put[0], put[1] if len(put) > 1 else (None, None, None)
    return TrialBalance(
        first_mass=first[0],
        first_angle=first[1],
        first_unbalance=first[2],
        second_mass=second[0],
        second_angle=second[1],
        second_unbalance=second[2],
        condition=apart if len(masses) > 1 and apart < BEYOND else None,
        coefficients=tuple(
            Coefficient(row, nth, Quantity(a.size * 1e-3, number), a.angle)
            for nth, column in enumerate(columns, 1)
            for row, a in enumerate(column, 1)
        ),
        predicted=_predicted(initial, left, number, exact=exact),
        checks=(Check("the corrections cancel the readings", off <= 1e-11, off, 1e-11),) if exact else (),
        advice=tuple(_advice(apart, columns, weights, initial, off if together else None)),
    )  # fmt: skip


def _predicted(before: "list[Phasor]", left: "list[Phasor]", number: Kind, *, exact: bool) -> "tuple[Predicted, ...]":
    """The readings before and those to expect, zero with as many readings as planes."""
    sizes = [0.0 if exact else rest.size for rest in left]
    return tuple(
        Predicted(nth, Quantity(v.size, number), Quantity(size, number), size if exact else size / v.size)
        for nth, (v, size) in enumerate(zip(before, sizes, strict=True), 1)
    )


def _refuse_dependent(apart: float, off: float) -> None:
    """Refuse planes that the readings do not tell apart, with what a correction of both together would reach."""
    require(
        False,
        "the two planes act alike on every reading: the masses are not determined"
        if apart >= BEYOND
        else "the two planes act almost alike on every reading (condition {apart}): their masses would nearly cancel",
        code="dependent-planes",
        hint="balance in one plane, or add a sensor or a speed at which the planes act differently; --drop-dependent "
        "corrects what they do together and leaves {off} of the readings",
        apart=(apart, Ratio),
        off=(off if off > ROUNDING else 0.0, Fraction),
    )


def _advice(
    apart: float,
    columns: "list[list[Phasor]]",
    weights: "list[TrialWeight]",
    initial: "list[Phasor]",
    off: "float | None",
) -> "list[Advice]":
    out = []
    if off is not None:
        text = (
            "the readings do not separate the planes: only what both do together is corrected, and {off} of the "
            "readings stays"
        )
        out.append(Advice("dependent-planes", worded(text, off=(off, Fraction)),
                          remedy="add a sensor or a speed at which the planes act differently"))  # fmt: skip
    elif apart > POOR:
        text = "the readings separate the planes poorly (condition {apart}): reading errors are magnified"
        out.append(Advice("condition", worded(text, apart=(apart, Ratio)), remedy="add a sensor or a speed"))
    for nth, (column, one) in enumerate(zip(columns, weights, strict=True), 1):
        share = plain(norm(column)) * plain(one.mass) / plain(norm(initial))
        if share < WEAK:
            text = "trial weight {nth} changed the readings by {share} of them: the change is mostly scatter"
            message = worded(text, nth=str(nth), share=(share, Fraction))
            out.append(Advice("weak-trial", message, remedy="take a heavier trial weight"))
    return out


def _kind(rows: "Sequence[Sensor]") -> "Any":
    """The kind of all readings, each of which must have its phase."""
    kinds = []
    for nth, row in enumerate(rows, 1):
        for name in ("initial", "first", "second", "runout", "now"):
            reading = getattr(row, name)
            if reading is None:
                continue
            value = getattr(reading, "value", reading)
            require(
                isinstance(value, tuple | list) and len(value) == 2,
                "reading {name} of sensor {nth} has no phase",
                code="no-phase",
                hint="write 170 um @ 112 deg; of amplitudes alone: dynamics balance four-runs",
                name=name,
                nth=str(nth),
            )
            kinds.append(reading.kind if isinstance(reading, Quantity) else Kind("number", ""))
    for kind in kinds:
        require(
            kind.unit == kinds[0].unit,
            "readings of a {one} and of a {other} cannot be balanced together",
            code="mixed-kinds",
            hint="give all readings in one kind of unit",
            one=kinds[0].name,
            other=kind.name,
        )
    return kinds[0]


def _number(kind: "Any") -> Kind:
    # in the unit that was written, whichever system is asked for
    return Kind(kind.name, kind.unit, si=kind.si, us=kind.si)


def _influence(
    rows: "Sequence[Sensor]", weights: "list[TrialWeight]", phase: str, *, left_on: bool
) -> "tuple[list[Phasor], list[list[Phasor]]]":
    """The readings to cancel without runout, and for each plane the change of every reading for one kilogram."""
    initial = [_reading(row.initial, phase) for row in rows]
    firsts = [_reading(row.first, phase) for row in rows]
    columns = [_column(firsts, initial, weights[0], "first")]
    if len(weights) > 1:
        for nth, row in enumerate(rows, 1):
            require(
                row.second is not None,
                "sensor {nth} has no reading with the weight in the second plane",
                code="missing",
                hint='add second=… to it, for example "second=186 um @ 115 deg"',
                nth=str(nth),
            )
        seconds = [_reading(row.second, phase) for row in rows]
        columns.append(_column(seconds, firsts if left_on else initial, weights[1], "second"))
    else:
        require(
            all(row.second is None for row in rows),
            "a reading of a second plane is given, but not its trial weight",
            code="missing",
            hint="give --second-trial-mass and --second-trial-angle",
        )
    require(
        len({row.now is None for row in rows}) == 1,
        "some sensors have a reading now, others have none",
        code="missing",
        hint="add now=… to each sensor",
    )
    before = initial if rows[0].now is None else [_reading(row.now, phase) for row in rows]
    slow = [None if row.runout is None else _reading(row.runout, phase) for row in rows]
    still = [v if roll is None else v - roll for v, roll in zip(before, slow, strict=True)]
    require(
        plain(norm(still)) > 0.0,
        "the readings are zero: there is nothing to balance",
        code="nothing-to-balance",
    )
    return still, columns


def _reading(reading: "Any", phase: str) -> Phasor:
    read = Phasor(*getattr(reading, "value", reading))
    return read.conjugate if phase == "lag" else read


def _column(runs: "list[Phasor]", before: "list[Phasor]", weight: TrialWeight, name: str) -> "list[Phasor]":
    changes = [one - other for one, other in zip(runs, before, strict=True)]
    require(
        plain(norm(changes)) > 0.0,
        "the {name} trial weight changed no reading",
        code="no-response",
        hint="take a heavier trial weight, or check the readings",
        name=name,
    )
    put = polar(weight.mass, weight.angle)
    return [change / put for change in changes]
