"""360° momentum reconstruction: what the vehicles did before the impact from what they did after it."""

from dynamics_cli.errors import require
from dynamics_cli.impact.central import reduced_mass
from dynamics_cli.impact.conventions import (
    AXES,
    PDOF_ZERO,
    Axes,
    PdofZero,
    conventions,
    heading_of,
    mass_of,
)
from dynamics_cli.impact.diagnostics import balance, not_above, plain, require_sizes, single
from dynamics_cli.impact.momentum_exchange import Exchange, change_of_velocity
from dynamics_cli.impact.momentum_records import CrushEnergies, EquivalentSpeeds, MomentumFound, Reconstructed, Vehicle
from dynamics_cli.impact.momentum_terms import CAUTION, Branch, Term, solve
from dynamics_cli.numerics.elementary import absolute, cos, hypot, sin, sqrt, where
from dynamics_cli.quantities import (
    STANDARD_GRAVITY,
    Gravity,
)
from dynamics_cli.records import Advice, Check

Pair = tuple[float, float]
# Paths this close to one line (sine of 10 degrees) may be taken as collinear.
COLLINEAR = 0.17364817766693033


def momentum(
    *,
    first: Vehicle,
    second: Vehicle,
    damage: CrushEnergies | EquivalentSpeeds | None = None,
    branch: Branch | None = None,
    axes: Axes = AXES,
    pdof_zero: PdofZero = PDOF_ZERO,
    gravity: Gravity = STANDARD_GRAVITY,
) -> MomentumFound:
    """Speeds and headings before or after an impact from conservation of momentum, any two of them unknown.

    Equation
    --------
    v₁ = [m₁u₁ sin(α₂ − β₁) + m₂u₂ sin(α₂ − β₂)]/(m₁ sin(α₂ − α₁)) with headings α before, β after; likewise the rest.

    Parameters
    ----------
    first : Vehicle
        The first vehicle.
    second : Vehicle
        The second vehicle.
    damage : CrushEnergies | EquivalentSpeeds
        Energies of deformation, for vehicles that met on one line.
    branch : Branch
        Which solution, where two close the equation: larger, smaller, left or right; of vehicles on one line,
        `smaller` says that the second closed in on the first.
    axes : Axes
        Axes of velocities and headings: mathematical, compass, sae or iso.
    pdof_zero : PdofZero
        Where a force of PDOF zero comes from: heading, travel or scene.
    gravity : Gravity
        Acceleration of gravity, for vehicles given by weight [m/s^2].

    Returns
    -------
    MomentumFound
        Speeds, headings, ΔV and PDOF of both, impulse, energy lost, angle condition and verdict.

    Raises
    ------
    InadmissibleError
        When more than two quantities are unknown, the angle condition is above 12, a speed would be negative, the
        impulse would pull, or energy would be gained.

    Notes
    -----
    Cross products with each other's direction decouple the two speeds; rounding is never the trouble, errors of the
    angles are, by the factor of the angle condition (cot of half the angle between the approach paths).

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.5 and 10.10.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> one = Vehicle(ByMass(1500.0), None, 0.0, 8.0, 0.6)
    >>> two = Vehicle(ByMass(1200.0), None, 1.5707963267948966, 9.0, 0.8)
    >>> found = momentum(first=one, second=two)
    >>> round(found.first.approach_speed, 6), round(found.second.approach_speed, 6)
    (11.618973, 12.10263)
    """
    require(
        damage is None,
        "energies of deformation are for vehicles on one line; these do not need them",
        code="damage-unused",
        hint="leave them out, or leave the choice of model to the program",
    )
    require_sizes(first=first, second=second, gravity=gravity)
    masses = _masses(first, second, gravity)
    terms = _terms(first, second, masses)
    solution = solve(terms, branch)
    answer = _answer(terms, (first, second), axes, pdof_zero, solution.condition, solution.closure)
    return _certified(answer, terms, check=solution.closure is None)


def momentum_and_energy(
    *,
    first: Vehicle,
    second: Vehicle,
    damage: CrushEnergies | EquivalentSpeeds | None = None,
    branch: Branch | None = None,
    axes: Axes = AXES,
    pdof_zero: PdofZero = PDOF_ZERO,
    gravity: Gravity = STANDARD_GRAVITY,
) -> MomentumFound:
    """Speeds before a collinear impact from momentum along the line and the energies of deformation.

    Equation
    --------
    u² = w² + 2E/m_r with closing speed u, separation speed w and energy E of both; v = V ± (m_r/m) u.

    Parameters
    ----------
    first : Vehicle
        The first vehicle, with its heading before and its speed and heading after.
    second : Vehicle
        The second vehicle, likewise; its heading is along or against that of the first.
    damage : CrushEnergies | EquivalentSpeeds
        Energies of deformation of both vehicles.
    branch : Branch
        Which solution, where two close the equation: larger, smaller, left or right; of vehicles on one line,
        `smaller` says that the second closed in on the first.
    axes : Axes
        Axes of velocities and headings: mathematical, compass, sae or iso.
    pdof_zero : PdofZero
        Where a force of PDOF zero comes from: heading, travel or scene.
    gravity : Gravity
        Acceleration of gravity, for vehicles given by weight [m/s^2].

    Returns
    -------
    MomentumFound
        Speeds, ΔV and PDOF of both, impulse, energy lost.

    Raises
    ------
    InadmissibleError
        When the paths are more than 10 degrees from one line, a quantity after the impact is missing, both approach
        speeds are given, an energy is negative, or a speed would be negative.

    Notes
    -----
    All energy lost is that of deformation: e needs no guess, since the speeds after are known. Parts across the line
    are left to the vehicles as they are after the impact.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 10.10.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> one = Vehicle(ByMass(1000.0), None, 0.0, 5.0, 0.0)
    >>> two = Vehicle(ByMass(1000.0), None, 0.0, 5.0, 0.0)
    >>> found = momentum_and_energy(first=one, second=two, damage=CrushEnergies(20000.0, 5000.0))
    >>> found.first.approach_speed, found.second.approach_speed
    (10.0, 0.0)
    """
    require(damage is not None, "no energies of deformation are given", code="no-energy")
    assert damage is not None
    require_sizes(first=first, second=second, damage=damage, gravity=gravity)
    masses = _masses(first, second, gravity)
    energy = _deformation(damage, masses)
    terms = _terms(first, second, masses)
    require(
        all(t.heading is not None for t in terms) and all(t.speed is not None for t in terms[2:]),
        "the energy route needs of both vehicles the heading before, and the speed and heading after",
        code="not-enough",
    )
    require(
        first.approach_speed is None and second.approach_speed is None,
        "momentum and energy give both approach speeds; one of them is given",
        code="too-much",
        hint="leave out the approach speeds, or the energies of deformation",
    )
    line = terms[0].heading
    assert line is not None
    bend = sin(terms[1].heading - line)  # type: ignore[operator]
    require(
        absolute(bend) <= COLLINEAR,
        "the approach paths are not on one line: the sine of the angle between them is {0:.4g}",
        bend,
        code="not-collinear",
        hint="leave out the energies: momentum alone decides",
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
        require(
            term.speed >= -1e-12 * closing,  # type: ignore[operator]
            f"the speed of {term.name} would be " + "{0:.4g} m/s: it would have moved backwards",
            term.speed,
            code="backwards",
            hint="check its heading; --branch smaller says that the second vehicle closed in on the first",
        )
    apart = side * parting
    straight = line, -side * reduced * (closing + apart)
    answer = _answer(terms, (first, second), axes, pdof_zero, None, None, straight)
    # along the line these are known without a difference of velocities
    known = {"energy_lost": energy, "closing_along_impulse": closing, "separation_along_impulse": apart}
    answer = MomentumFound(**{**answer.__dict__, **known, "restitution": apart / closing})
    return _certified(answer, terms, check=False, along=line)


def energy_suffices(*, damage: object = None, **_: object) -> str | None:
    """Say why the energy route answers."""
    return None if damage is None else "energies of deformation are given: the vehicles met on one line"


def _masses(first: Vehicle, second: Vehicle, gravity: float) -> Pair:
    return mass_of(first.bulk, gravity, "the first vehicle"), mass_of(second.bulk, gravity, "the second vehicle")


def _terms(first: Vehicle, second: Vehicle, masses: Pair) -> list[Term]:
    terms = []
    for one, mass, name in zip((first, second), masses, ("the first", "the second"), strict=True):
        terms.append(Term(1.0, mass, one.approach_speed, _heading(one.approach_speed, one.approach_heading), name))
    for one, mass, name in zip((first, second), masses, ("the first", "the second"), strict=True):
        heading = _heading(one.exit_speed, one.exit_heading)
        terms.append(Term(-1.0, mass, one.exit_speed, heading, name + " exit"))
    return terms


def _heading(speed: float | None, heading: float | None) -> float | None:
    """Heading as given; of a vehicle at rest any will do."""
    if heading is None and speed is not None and single(speed) and plain(speed) == 0.0:
        return 0.0
    return heading


def _deformation(damage: CrushEnergies | EquivalentSpeeds, masses: Pair) -> float:
    if isinstance(damage, EquivalentSpeeds):
        first = masses[0] * (damage.first_ees * damage.first_ees)
        return 0.5 * (first + masses[1] * (damage.second_ees * damage.second_ees))
    for energy in (damage.first_crush_energy, damage.second_crush_energy):
        require(energy >= 0.0, "an energy of deformation of {0:.6g} J is negative", energy, code="negative-energy")
    return damage.first_crush_energy + damage.second_crush_energy


def _answer(
    terms: list[Term],
    vehicles: tuple[Vehicle, Vehicle],
    axes: Axes,
    zero: PdofZero,
    condition: float | None,
    closure: float | None,
    straight: Pair | None = None,
) -> MomentumFound:
    exchange = Exchange(terms, axes, straight)
    velocities = exchange.plane
    impulse = exchange.components(None)
    size = hypot(*impulse)
    struck = size > 0.0
    require(struck, "no impact: neither vehicle changes its velocity", code="no-impact", hint="check the speeds after")
    way = impulse[0] / size, impulse[1] / size
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
    closing = -(before[0] * way[0] + before[1] * way[1])
    parting = apart[0] * way[0] + apart[1] * way[1]
    lost = 0.5 * size * (closing - parting)
    total = [terms[2].mass * velocities[2][axis] + terms[3].mass * velocities[3][axis] for axis in (0, 1)]
    return MomentumFound(
        first=bodies[0],
        second=bodies[1],
        angle_condition=condition,
        verdict=_verdict(condition),
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


def _verdict(condition: float | None) -> str | None:
    if condition is None:
        return None
    return where(plain(condition) <= CAUTION, "good", "caution")  # type: ignore[arg-type,return-value]


def _certified(answer: MomentumFound, terms: list[Term], *, check: bool, along: float | None = None) -> MomentumFound:
    """The answer with what speaks for and against it; refused when the impulse pulls or energy would be gained."""
    size = sum((absolute(t.amount) for t in terms[1:]), absolute(terms[0].amount))
    work = answer.impulse * answer.closing_speed + absolute(answer.energy_lost)
    if check or along is not None:
        require(
            answer.closing_along_impulse >= -1e-9 * answer.closing_speed,
            "the vehicles would part along the impulse, at {0:.4g} m/s, before they meet: the impulse would pull",
            0.0 - answer.closing_along_impulse,
            code="pull",
            hint="check that headings are directions of travel",
        )
        require(
            answer.energy_lost >= -1e-9 * work,
            "the impact would have given {0:.4g} J to the vehicles",
            0.0 - answer.energy_lost,
            code="energy-gained",
            hint="check the speeds after and the headings",
        )
    checks: tuple[Check, ...] = ()
    if check and single(size):
        for name, turn in (("momentum along heading zero", cos), ("momentum across heading zero", sin)):
            sides = [t.mass * t.speed * turn(t.heading) for t in terms]  # type: ignore[operator,arg-type]
            checks += balance(name, sides[0] + sides[1], sides[2] + sides[3], size)
    # the second path may bend from the line by a few degrees, which is neglected
    straight = check if along is None else _straight(terms)
    if along is not None and straight:
        sides = [t.mass * t.speed * cos(t.heading - along) for t in terms]  # type: ignore[operator]
        checks += balance("momentum along the line", sides[0] + sides[1], sides[2] + sides[3], size)
    if straight:
        changes = answer.first.energy_change + answer.second.energy_change
        # what is lost is a difference of these
        kinetic = [0.5 * absolute(t.amount) * t.speed for t in terms]  # type: ignore[operator]
        checks += balance(
            "energy", changes, -answer.energy_lost, work + kinetic[0] + kinetic[1] + kinetic[2] + kinetic[3]
        )
    checks += not_above("energy never gained", -answer.energy_lost, 0.0, work) if check else ()
    return MomentumFound(**{**answer.__dict__, "checks": checks, "advice": _advice(answer, size)})


def _straight(terms: list[Term]) -> bool:
    """Whether all four vectors lie on one line; not told of arrays."""
    bends = [absolute(sin(t.heading - terms[0].heading)) for t in terms[1:]]  # type: ignore[operator]
    return single(*bends) and all(plain(bend) <= 1e-9 for bend in bends)


def _advice(answer: MomentumFound, size: float) -> tuple[Advice, ...]:
    if not single(size, answer.impulse, answer.angle_condition):
        return ()
    found: list[Advice] = []
    condition = answer.angle_condition
    if condition is not None and plain(condition) > CAUTION:
        number = plain(condition)
        found.append(
            Advice(
                code="angle-condition",
                message=f"the approach paths are close to one line: angle condition {number:.3g}; one degree of error "
                f"changes the speeds by up to about {1.75 * number:.2g} % of the momentum",
                mend="state the headings with their uncertainty, or use the energies of deformation",
            )
        )
    if answer.closure is not None and plain(answer.closure) > 0.01 * plain(size):
        share = 100.0 * plain(answer.closure) / plain(size)
        found.append(
            Advice(
                code="momentum-not-closed",
                message=f"momentum does not close: {share:.3g} % of all momenta are left over",
                severity="serious" if share > 5.0 else "caution",
                mend="leave out the least certain quantity and let momentum give it",
            )
        )
    bounce = plain(answer.restitution)
    if bounce > 0.6 or bounce < -0.05:
        word = "high for vehicles" if bounce > 0.6 else "negative: their mass centres pass each other (a sideswipe?)"
        found.append(Advice(code="odd-restitution", message=f"restitution along the impulse is {bounce:.3g}, {word}"))
    return tuple(found)
