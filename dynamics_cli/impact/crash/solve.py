"""A whole crash, solved after → impact → before as one function of all its measurements."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import heading_of, mass_of
from dynamics_cli.impact.crash.agreement import agreements, gap_advice, require_agreement
from dynamics_cli.impact.crash.links import verdicts, weakest
from dynamics_cli.impact.crash.results import BeforeImpact, Course, Crash, CrashCourse, CrashDeltaV, CrashEnergy
from dynamics_cli.impact.crash.scene import CrashScene, named
from dynamics_cli.impact.crash.ways import After, Before, along
from dynamics_cli.impact.diagnostics import balance, require_sizes
from dynamics_cli.impact.reconstruction.momentum import momentum, momentum_and_energy, momentum_of_samples
from dynamics_cli.impact.reconstruction.momentum_records import MomentumResult, Reconstructed, Vehicle
from dynamics_cli.quantities import STANDARD_GRAVITY, Annotated, Gravity
from dynamics_cli.sampling import drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from dynamics_cli.records import Check

SIDES = ("first", "second")


def crash(
    scene: Annotated[CrashScene, "Two vehicles before and after their impact, surfaces, and the impact."],
    /,
    *,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Crash:
    """Speeds of a two-vehicle crash from its start to rest, calculated back from the measurements as one model.

    Equation
    --------
    After: u² = u_e² + 2g Σ f d. Impact: m₁v₁ + m₂v₂ = m₁u₁ + m₂u₂ in the plane. Before: v₀² = v² + 2g f d, and likewise
    in every phase.

    Returns
    -------
    Crash
        Each vehicle's speeds at its start, where it brakes, into the impact and after it, ΔV and PDOF, the energy of
        the whole crash, a verdict for every link and the weakest.

    Raises
    ------
    InadmissibleError
        When a link is impossible (see `skid speed`, `impact momentum`, `skid timeline`), a surface is unknown,
        or two links give one quantity further apart than three of its standard deviations.

    Notes
    -----
    Every step is the corresponding task: `skid speed`, `impact momentum`, `skid timeline`. One surface is one friction:
    its uncertainty counts once, however many phases refer to it.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.5 and 10.10.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> from dynamics_cli.impact.crash.scene import CrashVehicle, NamedSurface, PhaseBefore, SegmentAfter
    >>> one = CrashVehicle(ByMass(1500.0), approach_heading=0.0, exit_heading=0.7, after=(SegmentAfter(10.0, "road"),),
    ...                    before=(PhaseBefore(distance=12.0, surface="road"),))
    >>> two = CrashVehicle(ByMass(1200.0), approach_heading=1.5, exit_heading=0.6, after=(SegmentAfter(12.0, "road"),))
    >>> found = crash(CrashScene(one, two, (NamedSurface("road", 0.7),)))
    >>> round(found.first.approach_speed, 4), round(found.first.start.speed, 4)
    (16.4903, 20.8969)
    """
    return _solved(scene, gravity, momentum_of_samples if drawing() else momentum)


def crash_with_energy(
    scene: Annotated[CrashScene, "Two vehicles before and after their impact, surfaces, and the impact."],
    /,
    *,
    gravity: Annotated[Gravity, "Acceleration of gravity [m/s^2]."] = STANDARD_GRAVITY,
) -> Crash:
    """Speeds of a crash of vehicles that met on one line, from momentum and the energies of deformation.

    Equation
    --------
    As `crash`, with u² = w² + 2E/m_r along the line of the impact.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 9.5 and 10.10.
    """
    return _solved(scene, gravity, momentum_and_energy)


def energy_suffices(scene: CrashScene, /, **_: object) -> str | None:
    """Reason why the energy route applies."""
    return None if scene.impact.damage is None else "energies of deformation are given: the vehicles met on one line"


def _solved(scene: CrashScene, gravity: float, method: "Callable[..., MomentumResult]") -> Crash:
    require_sizes(gravity=gravity, **{side: getattr(scene, side).bulk for side in SIDES})
    slides = [After(scene, side, gravity) for side in SIDES]
    met = [_met(scene, slide) for slide in slides]
    link = scene.impact
    meeting = method(
        first=met[0], second=met[1], damage=link.damage, branch=link.branch, axes=scene.axes,
        pdof_zero=scene.pdof_zero, gravity=gravity,
    )  # fmt: skip
    bodies = (meeting.first, meeting.second)
    masses = [mass_of(getattr(scene, side).bulk, gravity) for side in SIDES]
    ways = [Before(scene, side, body.approach_speed, gravity) for side, body in zip(SIDES, bodies, strict=True)]
    courses = [_course(scene, *parts) for parts in zip(bodies, slides, ways, strict=True)]
    names = [named(getattr(scene, side), side) for side in SIDES]
    energy, energy_checks = _energy(masses, meeting, slides, ways)
    whole = (courses[0], courses[1], meeting.closing_speed, meeting.restitution, meeting.angle_condition, energy)
    if drawing():
        # tables are not needed for samples
        return Crash(*whole, "", (), (), (), meeting.conventions)
    rows: list[Course] = []
    for name, mass, body, slide, way in zip(names, masses, bodies, slides, ways, strict=True):
        impact = Course(name, "impact", body.approach_speed, body.exit_speed, 0.0, 0.0, -body.energy_change)
        rows += [*way.rows(name, mass), impact, *slide.rows(name, mass, scene)]
    links = verdicts(names, slides, ways, meeting)
    twice = agreements(scene, names, courses)
    require_agreement(twice)
    checks = meeting.checks + energy_checks
    for name, slide, way in zip(names, slides, ways, strict=True):
        checks += slide.forward(name) + way.forward(name)
    advice = meeting.advice + gap_advice(twice)
    for slide, way in zip(slides, ways, strict=True):
        advice += slide.advice() + way.advice()
    return Crash(
        *whole, weakest(links), tuple(rows), links, tuple(gap.agreement for gap in twice), meeting.conventions, checks,
        advice,
    )  # fmt: skip


def _met(scene: CrashScene, slide: After) -> Vehicle:
    """A vehicle in the form that the impact takes."""
    given = getattr(scene, slide.side)
    heading = given.exit_heading
    if slide.spinning is not None:
        heading = slide.spinning.heading
    elif heading is None and given.rest is not None:
        away = given.rest[0] - scene.impact.point[0], given.rest[1] - scene.impact.point[1]
        require(
            (away[0] != 0.0) | (away[1] != 0.0),
            "{side}: it came to rest at the point of impact, so its exit heading is not known",
            code="no-heading",
            hint="give its exit heading",
            side=slide.side,
        )
        heading = heading_of(*away, scene.axes)
    return Vehicle(
        given.bulk, given.approach_speed, given.approach_heading, slide.speed, heading, given.nose, given.name
    )


def _course(scene: CrashScene, body: Reconstructed, slide: After, way: Before) -> CrashCourse:
    slid = bool(slide.surfaces)
    spun = slide.spinning
    rest = along(scene, body.exit_heading, slide.distance) if slid else None
    if spun is not None:
        rest = getattr(scene, slide.side).rest
    start: BeforeImpact | None = way.summary(scene, body.approach_heading)
    change = body.delta_v
    return CrashCourse(
        start, body.approach_speed, body.approach_heading, body.exit_speed, body.exit_heading,
        None if spun is None else spun.spin, CrashDeltaV(change.magnitude, change.pdof),
        slide_distance=slide.distance if slid or spun is not None else None, rest_position=rest,
        per_degree=None if body.determined is None else body.determined.per_degree,
    )  # fmt: skip


def _energy(
    masses: "list[float]", meeting: MomentumResult, slides: "list[After]", ways: "list[Before]"
) -> "tuple[CrashEnergy, tuple[Check, ...]]":
    """The energy balance: kinetic energy at both ends, and the work of every link from forces and distances."""
    start: float = 0.0
    before: float = 0.0
    after: float = 0.0
    remaining: float = 0.0
    for mass, slide, way, body in zip(masses, slides, ways, (meeting.first, meeting.second), strict=True):
        start = start + 0.5 * mass * (way.start_speed * way.start_speed)
        before = before + mass * way.work
        after = after + mass * (slide.gravity * slide.work)
        left = slide.end_speed if slide.surfaces or slide.spinning is not None else body.exit_speed
        remaining = remaining + 0.5 * mass * (left * left)
    energy = CrashEnergy(start, before, meeting.energy_lost, after, remaining)
    spent = before + meeting.energy_lost + after + remaining
    closed = meeting.closure is None and meeting.checks != ()
    return energy, balance("energy of the whole crash", start, spent, start) if closed else ()
