"""Approach speeds from exit motion with rotation: by momentum, by spins, or by both in least squares."""

from dynamics_cli.errors import require
from dynamics_cli.impact.conventions import AXES, PDOF_ZERO, Axes, PdofZero
from dynamics_cli.impact.inverse.fit import solve
from dynamics_cli.impact.inverse.judgement import judge_crossing, judge_levers
from dynamics_cli.impact.inverse.records import UNKNOWN_CONTACT, Departing, InverseResult, KnownContact
from dynamics_cli.impact.inverse.rest import Ended, Problem, contact_of, solve_rest, with_turning
from dynamics_cli.impact.inverse.scene import Scene, ended, turns
from dynamics_cli.quantities import STANDARD_GRAVITY, Angle, Annotated, Gravity, PlanarPosition

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def by_momentum(
    *,
    first: Annotated[Departing, "The first vehicle."],
    second: Annotated[Departing, "The second vehicle."],
    **circumstances: "Any",
) -> InverseResult:
    """Approach speeds from exit velocities and approach headings by momentum alone; parameters of `by_rest`.

    Equation
    --------
    m₁v₁d₁ + m₂v₂d₂ = m₁u₁ + m₂u₂ with the unit vectors d of the approach headings.

    Returns
    -------
    InverseResult
        Speeds and headings before, with standard deviations where those of the measurements are given.

    Raises
    ------
    InadmissibleError
        When an approach heading is missing, the paths are close to one line, or a vehicle would drive backwards.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.5.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> from dynamics_cli.impact.inverse.records import ExitVelocity
    >>> car = Departing(ByMass(1500.0), ExitVelocity((11.2, 0.2)), approach_heading=0.0)
    >>> other = Departing(ByMass(1200.0), ExitVelocity((4.9, 9.9)), approach_heading=1.5707963267948966)
    >>> result = by_momentum(first=car, second=other)
    >>> round(result.first.approach_speed, 9), round(result.second.approach_speed, 9)
    (15.12, 10.15)
    """
    scene = Scene(first, second, **circumstances, spins=False)
    require(
        first.approach_heading is not None and second.approach_heading is not None,
        "momentum alone needs both approach headings",
        code="not-enough",
        hint="give them; or, for headings unknown, both exit spins and approach spins, inertias and levers",
    )
    first_path, second_path = scene.sides[0].way, scene.sides[1].way
    assert first_path is not None
    assert second_path is not None
    verdict = judge_crossing(first_path, second_path)
    return scene.answer(solve(scene.sides), verdict, None, "momentum, QR of the scaled equations")


def by_spins(
    *,
    first: Annotated[Departing, "The first vehicle."],
    second: Annotated[Departing, "The second vehicle."],
    **circumstances: "Any",
) -> InverseResult:
    """Approach speeds and headings from exit velocities and changes of spin; parameters of `by_rest`.

    Equation
    --------
    p = [J₁Δω₁·r₂ + J₂Δω₂·r₁]/(r₁ × r₂); V₁ = u₁ − p/m₁, V₂ = u₂ + p/m₂.

    Returns
    -------
    InverseResult
        Speeds and headings before, with standard deviations where those of the measurements are given.

    Raises
    ------
    InadmissibleError
        When a spin, inertia or lever is missing, or the contact is close to the line of the mass centres.

    References
    ----------
    R. M. Brach, R. M. Brach, Vehicle Accident Analysis and Reconstruction Methods, SAE 2011: planar impact mechanics.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> from dynamics_cli.impact.inverse.records import ExitVelocity
    >>> from dynamics_cli.impact.planar.bodies import ByInertia, Lever
    >>> turn = {"approach_spin": 0.0}
    >>> car = Departing(ByMass(1500.0), ExitVelocity((11.2, 0.2)), ByInertia(2500.0), Lever((1.8, -0.3)), -0.5, **turn)
    >>> other = Departing(ByMass(1200.0), ExitVelocity((4.9, 9.9)), ByInertia(1800.0), Lever((-0.7, 0.9)), -2.7, **turn)
    >>> [round(part, 3) for part in by_spins(first=car, second=other).impulse]
    [-5583.688, 236.17]
    """
    scene = Scene(first, second, **circumstances, headings=False)
    missing = [name for name, side in zip(scene.names, scene.sides, strict=True) if side.spins is None]
    require(
        not missing,
        "without approach headings the spins decide, and {name} lacks one of inertia, lever, exit spin, approach spin",
        name=" and ".join(missing),
        code="not-enough",
        hint="give them, or both approach headings",
    )
    levers = scene.sides[0].spins[1], scene.sides[1].spins[1]  # type: ignore[index]
    sine, verdict = judge_levers(*levers)
    return scene.answer(solve(scene.sides), verdict, sine, "momentum and spins, QR of the scaled equations")


def least_squares(
    *,
    first: Annotated[Departing, "The first vehicle."],
    second: Annotated[Departing, "The second vehicle."],
    **circumstances: "Any",
) -> InverseResult:
    """Approach speeds that agree best with exit velocities, spins and headings together; parameters of `by_rest`.

    Equation
    --------
    Σ (fitted − measured)²/σ² = minimum over v₁, v₂, p, α₁, α₂; u = V ± p/m, ω' = ω ± (r × p)/J; covariance (JᵀJ)⁻¹.

    Returns
    -------
    InverseResult
        Speeds and headings before with standard deviations, χ² with its probability, residuals, the implied contact.

    Raises
    ------
    InadmissibleError
        When standard deviations are missing, the measurements do not determine the approach or contradict each other
        (probability of χ² below 0.1 %), a vehicle would have to drive backwards, or energy would be gained.

    References
    ----------
    R. M. Brach, R. M. Brach, Vehicle Accident Analysis and Reconstruction Methods, SAE 2011: planar impact mechanics.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> from dynamics_cli.impact.inverse.records import ExitVelocity
    >>> from dynamics_cli.impact.planar.bodies import ByInertia, Lever
    >>> more = {"approach_spin": 0.0, "velocity_sigma": 0.5}
    >>> car = Departing(ByMass(1500.0), ExitVelocity((11.2, 0.2)), ByInertia(2500.0), Lever((1.8, -0.3)), -0.5, 0.0,
    ...              spin_sigma=0.3, **more)
    >>> other = Departing(ByMass(1200.0), ExitVelocity((4.9, 9.9)), ByInertia(1800.0), Lever((-0.7, 0.9)), -2.7,
    ...              1.5707963267948966, spin_sigma=0.4, **more)
    >>> result = least_squares(first=car, second=other)
    >>> round(result.first.approach_speed, 9), round(result.first.speed_sigma, 9)
    (15.066562212, 0.602272637)
    """
    scene = Scene(first, second, **circumstances)
    require(
        scene.weighted,
        "least squares weigh the measurements, and a standard deviation is missing",
        code="no-sigma",
        hint="give the velocity sigma and the spin sigma of each vehicle, e.g. 0.5 m/s and 0.3 rad/s",
    )
    fit = solve(scene.sides)
    return scene.answer(fit, None, None, f"Gauss–Newton by QR of the scaled matrix, {fit.steps} steps")


def by_rest(
    *,
    first: Annotated[Departing, "The first vehicle."],
    second: Annotated[Departing, "The second vehicle."],
    contact_point: Annotated[PlanarPosition | None, "Place of the contact, where mass centres are placed."] = None,
    normal: Annotated[
        Angle | None, "Contact normal from the first vehicle to the second, for restitution and friction, e.g. 10 deg."
    ] = None,
    contact: Annotated[KnownContact, "What is known of the contact, for rest positions."] = UNKNOWN_CONTACT,
    axes: Annotated[Axes, "Axes of velocities and headings: mathematical, compass, sae or iso."] = AXES,
    pdof_zero: Annotated[PdofZero, "Where a force of PDOF zero comes from: heading, travel or scene."] = PDOF_ZERO,
    gravity: Annotated[Gravity, "Acceleration of gravity, for vehicles given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> InverseResult:
    """Approach speeds from where the vehicles came to rest: impact and slides driven forward, least squares.

    Equation
    --------
    Σ (rest(v₁, v₂, …) − measured)²/σ² = minimum; restitution, ratio of impulses, drags and headings that have a
    standard deviation are measurements too.

    Returns
    -------
    InverseResult
        Speeds before with standard deviations, χ², residuals, and the direction in which the speeds are known least.

    Raises
    ------
    InadmissibleError
        When headings, contact or standard deviations are missing, no approach leads to these rest positions
        (probability of χ² below 0.1 %), or a vehicle would have driven backwards.

    References
    ----------
    R. M. Brach, R. M. Brach, Vehicle Accident Analysis and Reconstruction Methods, SAE 2011: planar impact mechanics.

    Examples
    --------
    >>> from dynamics_cli.impact.conventions import ByMass
    >>> from dynamics_cli.impact.inverse.records import RestAfter
    >>> from dynamics_cli.impact.planar.bodies import ByInertia, Lever
    >>> car = Departing(ByMass(1500.0), RestAfter((12.9, 0.8), 0.5), ByInertia(2500.0), Lever((1.8, -0.3)),
    ...                 approach_heading=0.0, rest_sigma=0.5)
    >>> other = Departing(ByMass(1200.0), RestAfter((5.9, 12.1), 0.45), ByInertia(1800.0), Lever((-0.7, 0.9)),
    ...                 approach_heading=1.5707963267948966, rest_sigma=0.5)
    >>> result = by_rest(first=car, second=other, normal=0.3490658503988659, contact=KnownContact(0.1, -0.45))
    >>> round(result.first.approach_speed, 6), round(result.second.approach_speed, 6)
    (15.272087, 10.078129)
    """
    require(
        ended(first) and ended(second),
        "of one vehicle the rest position is given, of the other the motion just after the impact",
        code="mixed",
        hint="give both rest positions: dynamics impact slide turns a rest position into the motion after",
    )
    require(
        first.approach_heading is not None and second.approach_heading is not None,
        "rest positions need both approach headings",
        code="not-enough",
    )
    scene = Scene(first, second, contact_point, normal, contact, axes, pdof_zero, gravity)
    require(
        scene.weighted,
        "least squares weigh the rest positions, and a standard deviation is missing",
        code="no-sigma",
        hint="give the rest sigma of each vehicle, e.g. 0.5 m",
    )
    first_side, second_side = scene.sides
    ends = Ended(first, first_side, axes, gravity), Ended(second, second_side, axes, gravity)
    problem = Problem(scene.sides, ends, contact_of(normal, axes, scene.contact))
    fit = solve_rest(problem)
    result = scene.answer(fit, None, None, f"Gauss–Newton by QR of the scaled matrix, {fit.steps} steps")
    return with_turning(result, problem, scene.names)


def rests_given(*, first: Departing, second: Departing, **_: object) -> str | None:
    """Say why the fit to rest positions answers."""
    return "rest positions are given" if ended(first) or ended(second) else None


def momentum_suffices(*, first: Departing, second: Departing, **_: object) -> str | None:
    """Reason why momentum alone applies."""
    headings = first.approach_heading is not None and second.approach_heading is not None
    spun = turns(first) or turns(second)
    return "the headings are known, and no change of spin is" if headings and not spun else None


def spins_suffice(*, first: Departing, second: Departing, **_: object) -> str | None:
    """Reason why spins apply."""
    unknown = first.approach_heading is None and second.approach_heading is None
    return "no approach heading is given: the changes of spin decide" if unknown else None
