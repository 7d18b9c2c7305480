"""360° momentum reconstruction: motion of the vehicles before the impact from their motion after it."""

from dynamics_cli.errors import judge, require, require_given
from dynamics_cli.impact.conventions import (
    AXES,
    PDOF_ZERO,
    Axes,
    PdofZero,
    conventions,
    heading_of,
    mass_of,
)
from dynamics_cli.impact.diagnostics import require_sizes
from dynamics_cli.impact.particles.central import reduced_mass
from dynamics_cli.impact.reconstruction.momentum_evidence import certified, with_energy_verdicts, with_verdicts
from dynamics_cli.impact.reconstruction.momentum_exchange import Exchange, change_of_velocity
from dynamics_cli.impact.reconstruction.momentum_records import (
    CrushEnergies,
    EquivalentSpeeds,
    MomentumResult,
    Reconstructed,
    Vehicle,
)
from dynamics_cli.impact.reconstruction.momentum_terms import Branch, Term, require_forward, solve
from dynamics_cli.impact.reconstruction.momentum_verdict import Unknowns, judge_crossing, verdict_advice
from dynamics_cli.numerics.elementary import absolute, cos, hypot, sin, sqrt, where
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Annotated,
    Energy,
    Gravity,
    Ratio,
)

Pair = tuple[float, float]
# Paths this close to one line (sine of 10 degrees) may be taken as collinear.
COLLINEAR = 0.17364817766693033


def momentum(
    *,
    first: Annotated[Vehicle, "The first vehicle."],
    second: Annotated[Vehicle, "The second vehicle."],
    damage: Annotated[
        CrushEnergies | EquivalentSpeeds | None, "Energies of deformation, for vehicles that met on one line."
    ] = None,
    branch: Annotated[
        Branch | None,
        "Which solution, where two close the equation: larger, smaller, left or right; of vehicles on one line, "
        "`smaller` says that the second closed in on the first.",
    ] = None,
    axes: Annotated[Axes, "Axes of velocities and headings: mathematical, compass, sae or iso."] = AXES,
    pdof_zero: Annotated[PdofZero, "Where a force of PDOF zero comes from: heading, travel or scene."] = PDOF_ZERO,
    gravity: Annotated[Gravity, "Acceleration of gravity, for vehicles given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> MomentumResult:
    """Speeds and headings before or after an impact from conservation of momentum, any two of them unknown.

    Equation
    --------
    v₁ = [m₁u₁ sin(α₂ − β₁) + m₂u₂ sin(α₂ − β₂)]/(m₁ sin(α₂ − α₁)) with headings α before, β after; likewise the rest.

    Returns
    -------
    MomentumResult
        Speeds, headings, ΔV and PDOF of both, impulse, energy lost, angle condition and verdict.

    Raises
    ------
    InadmissibleError
        When more than two quantities are unknown, a speed would be negative, the impulse would pull, or energy would be
        gained; and when the angle condition is above 12 and one degree would change both speeds by more than a tenth.

    Notes
    -----
    Cross products with each other's direction decouple the two speeds; not rounding but errors of the angles limit
    the accuracy. Each speed has its own verdict: the error of the worst heading that changes it by a tenth. The angle
    condition (cot of half the angle between the approach paths) says whether paths close to one line are the cause,
    otherwise the cause is a small mass beside a large one.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.5 and 10.10.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> car = Vehicle(ByMass(1500.0), None, 0.0, 8.0, 0.6)
    >>> other = Vehicle(ByMass(1200.0), None, 1.5707963267948966, 9.0, 0.8)
    >>> result = momentum(first=car, second=other)
    >>> round(result.first.approach_speed, 6), round(result.second.approach_speed, 6)
    (11.618973, 12.10263)
    """
    return momentum_of_samples(
        first=first, second=second, damage=damage, branch=branch, axes=axes, pdof_zero=pdof_zero, gravity=gravity,
        judged=True,
    )  # fmt: skip


def momentum_of_samples(
    *,
    first: Vehicle,
    second: Vehicle,
    damage: CrushEnergies | EquivalentSpeeds | None = None,
    branch: Branch | None = None,
    axes: Axes = AXES,
    pdof_zero: PdofZero = PDOF_ZERO,
    gravity: float = STANDARD_GRAVITY,
    judged: bool = False,
) -> MomentumResult:
    """As `momentum`, without verdicts unless asked for: a crash has none in its samples; they take half of the time."""
    require(
        damage is None,
        "energies of deformation are for vehicles on one line; these do not need them",
        code="damage-unused",
        hint="leave them out, or leave the choice of model to the program",
    )
    require_sizes(first=first, second=second, gravity=gravity)
    masses = _masses(first, second, gravity)
    terms = _terms(first, second, masses)
    unknown = Unknowns(terms)
    solution = solve(terms, branch)
    verdicts = unknown.verdicts() if judged else []
    answer = _answer(terms, (first, second), axes, pdof_zero, solution.closure)
    answer = with_verdicts(answer, terms, verdicts, solution.condition)
    answer = certified(answer, terms, check=solution.closure is None)
    if not judged:
        return answer
    if solution.condition is not None:
        judge_crossing(verdicts, solution.condition)
    advice = verdict_advice(unknown, verdicts, solution.condition) + answer.advice
    return MomentumResult(**{**answer.__dict__, "advice": advice})


def _require_energy_route(first: Vehicle, second: Vehicle, terms: list[Term]) -> None:
    lacking = [t.heading_name for t in terms if t.heading is None]
    lacking += [t.speed_name for t in terms[2:] if t.speed is None]
    require_given(
        not lacking,
        "the energy route needs of both vehicles the heading before, and the speed and heading after",
        tuple(lacking),
        code="not-enough",
    )
    require(
        first.approach_speed is None and second.approach_speed is None,
        "momentum and energy give both approach speeds; one of them is given",
        code="too-much",
        hint="leave out the approach speeds, or the energies of deformation",
    )


def momentum_and_energy(
    *,
    first: Annotated[Vehicle, "The first vehicle, with its heading before and its speed and heading after."],
    second: Annotated[Vehicle, "The second vehicle, likewise; its heading is along or against that of the first."],
    damage: Annotated[CrushEnergies | EquivalentSpeeds | None, "Energies of deformation of both vehicles."] = None,
    branch: Annotated[
        Branch | None,
        "Which solution, where two close the equation: larger, smaller, left or right; of vehicles on one line, "
        "`smaller` says that the second closed in on the first.",
    ] = None,
    axes: Annotated[Axes, "Axes of velocities and headings: mathematical, compass, sae or iso."] = AXES,
    pdof_zero: Annotated[PdofZero, "Where a force of PDOF zero comes from: heading, travel or scene."] = PDOF_ZERO,
    gravity: Annotated[Gravity, "Acceleration of gravity, for vehicles given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> MomentumResult:
    """Speeds before a collinear impact from momentum along the line and the energies of deformation.

    Equation
    --------
    u² = w² + 2E/m_r with closing speed u, separation speed w and energy E of both; v = V ± (m_r/m) u.

    Returns
    -------
    MomentumResult
        Speeds, ΔV and PDOF of both, impulse, energy lost.

    Raises
    ------
    InadmissibleError
        When the paths are more than 10 degrees from one line, a quantity after the impact is missing, both approach
        speeds are given, an energy is negative, or a speed would be negative.

    Notes
    -----
    All energy lost is deformation energy: e need not be assumed, since the speeds after are known. Components across
    the line stay as they are after the impact.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> car = Vehicle(ByMass(1000.0), None, 0.0, 5.0, 0.0)
    >>> other = Vehicle(ByMass(1000.0), None, 0.0, 5.0, 0.0)
    >>> result = momentum_and_energy(first=car, second=other, damage=CrushEnergies(20000.0, 5000.0))
    >>> result.first.approach_speed, result.second.approach_speed
    (10.0, 0.0)
    """
    require(damage is not None, "no energies of deformation are given", code="no-energy")
    assert damage is not None
    require_sizes(first=first, second=second, damage=damage, gravity=gravity)
    masses = _masses(first, second, gravity)
    energy = _deformation(damage, masses)
    terms = _terms(first, second, masses)
    _require_energy_route(first, second, terms)
    line = terms[0].heading
    assert line is not None
    bend = sin(terms[1].heading - line)  # type: ignore[operator]
    judge(
        absolute(bend) <= COLLINEAR,
        "the approach paths are not on one line: the sine of the angle between them is {bend}",
        bend=(bend, Ratio),
        code="not-collinear",
        hint="leave out the energies: momentum alone decides",
        results=("first.approach_speed", "second.approach_speed"),
    )
    sense = where(cos(terms[1].heading - line) >= 0.0, 1.0, -1.0)  # type: ignore[operator]
    after = [t.speed * cos(t.heading - line) for t in terms[2:]]  # type: ignore[operator]
    parting = after[1] - after[0]
    reduced = reduced_mass(*masses)
    closing = sqrt(parting * parting + 2.0 * (energy / reduced))
    total = masses[0] + masses[1]
    common = (masses[0] / total) * after[0] + (masses[1] / total) * after[1]
    side = -1.0 if branch == "smaller" else 1.0
    terms[0].speed = common + side * (reduced / masses[0]) * closing
    terms[1].speed = sense * (common - side * (reduced / masses[1]) * closing)
    for term in terms[:2]:
        require_forward(
            term.speed >= -1e-12 * closing,  # type: ignore[operator]
            term,
            term.speed,
            "check its heading; --branch smaller says that the second vehicle closed in on the first",
        )
    apart = side * parting
    straight = line, -side * reduced * (closing + apart)
    answer = _answer(terms, (first, second), axes, pdof_zero, None, straight)
    # along the line these need no difference of velocities
    along_impulse = {"energy_lost": energy, "closing_along_impulse": closing, "separation_along_impulse": apart}
    answer = MomentumResult(**{**answer.__dict__, **along_impulse, "restitution": apart / closing})
    answer = certified(answer, terms, check=False, along=line)
    return with_energy_verdicts(answer, terms, (after[0], after[1]), energy, side)


def energy_suffices(*, damage: object = None, **_: object) -> str | None:
    """Reason why the energy route applies."""
    return None if damage is None else "energies of deformation are given: the vehicles met on one line"


def _masses(first: Vehicle, second: Vehicle, gravity: float) -> Pair:
    return mass_of(first.bulk, gravity, "the first vehicle"), mass_of(second.bulk, gravity, "the second vehicle")


def _terms(first: Vehicle, second: Vehicle, masses: Pair) -> list[Term]:
    terms = []
    for car, mass, name in zip((first, second), masses, ("the first", "the second"), strict=True):
        heading = _heading(car.approach_speed, car.approach_heading)
        terms.append(Term(1.0, mass, car.approach_speed, heading, name, car.name))
    for car, mass, name in zip((first, second), masses, ("the first", "the second"), strict=True):
        heading = _heading(car.exit_speed, car.exit_heading)
        terms.append(Term(-1.0, mass, car.exit_speed, heading, name + " exit", car.name))
    return terms


def _heading(speed: float | None, heading: float | None) -> float | None:
    """Heading as given; for a vehicle at rest any value."""
    if heading is None and speed is not None and single(speed) and plain(speed) == 0.0:
        return 0.0
    return heading


def _deformation(damage: CrushEnergies | EquivalentSpeeds, masses: Pair) -> float:
    if isinstance(damage, EquivalentSpeeds):
        first = masses[0] * (damage.first_ees * damage.first_ees)
        return 0.5 * (first + masses[1] * (damage.second_ees * damage.second_ees))
    for energy in (damage.first_crush_energy, damage.second_crush_energy):
        require(
            energy >= 0.0,
            "an energy of deformation of {energy:6} is negative",
            energy=(energy, Energy),
            code="negative-energy",
        )
    return damage.first_crush_energy + damage.second_crush_energy


def _answer(
    terms: list[Term],
    vehicles: tuple[Vehicle, Vehicle],
    axes: Axes,
    zero: PdofZero,
    closure: float | None,
    straight: Pair | None = None,
) -> MomentumResult:
    exchange = Exchange(terms, axes, straight)
    velocities = exchange.plane
    impulse = exchange.impulse
    size = hypot(*impulse)
    struck = size > 0.0
    require(struck, "no impact: neither vehicle changes its velocity", code="no-impact", hint="check the speeds after")
    direction = impulse[0] / size, impulse[1] / size
    bodies = []
    for index, (term, vehicle, sign) in enumerate(zip(terms[:2], vehicles, (1.0, -1.0), strict=True)):
        nose = term.heading if vehicle.nose is None else vehicle.nose
        after = terms[index + 2]
        gained = 0.5 * term.mass * ((after.speed - term.speed) * (after.speed + term.speed))  # type: ignore[operator]
        bodies.append(
            Reconstructed(
                *(term.speed, term.heading, after.speed, after.heading),  # type: ignore[arg-type]
                delta_v=change_of_velocity(exchange, impulse, sign, term, nose, axes, zero),  # type: ignore[arg-type]
                energy_change=gained,
            )
        )
    before = velocities[0][0] - velocities[1][0], velocities[0][1] - velocities[1][1]
    apart = velocities[2][0] - velocities[3][0], velocities[2][1] - velocities[3][1]
    closing = -(before[0] * direction[0] + before[1] * direction[1])
    parting = apart[0] * direction[0] + apart[1] * direction[1]
    lost = 0.5 * size * (closing - parting)
    total = [terms[2].mass * velocities[2][axis] + terms[3].mass * velocities[3][axis] for axis in (0, 1)]
    return MomentumResult(
        first=bodies[0],
        second=bodies[1],
        angle_condition=None,
        verdict=None,
        impulse=size,
        impulse_heading=heading_of(impulse[0], impulse[1], axes),
        closing_speed=hypot(*before),
        closing_along_impulse=closing,
        separation_along_impulse=parting,
        restitution=parting / where(closing == 0.0, 1.0, closing),
        energy_lost=lost,
        total_momentum=hypot(*total),
        momentum_heading=heading_of(total[0], total[1], axes),
        closure=closure,
        conventions=conventions(axes, zero),
    )
