"""A scene of two bodies and one contact, answered by the simplest model that fits it.

All models use the same matrix K in the frame of the contact; each neglects effects that a scene does not have:
`spatial` none, `planar` the turning of the slip, `oblique` friction and spin, `central` all motion across the line.
"""

from dynamics_cli.errors import require
from dynamics_cli.impact.spatial.bodies import SolidInSpace, mobility
from dynamics_cli.impact.spatial.impact import approach, followed, solved_in_space
from dynamics_cli.impact.spatial.results import Solved, SpatialImpact
from dynamics_cli.impact.spatial.scene_contact import SeenScene, viewed
from dynamics_cli.impact.spatial.scene_records import Scene
from dynamics_cli.impact.spatial.straight_slip import End
from dynamics_cli.quantities import STANDARD_GRAVITY, Annotated, Gravity
from dynamics_cli.records import Advice

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable


def central_suffices(scene: Scene, /, *, gravity: float = STANDARD_GRAVITY) -> str | None:
    """Reason why the line of impact is enough, or None."""
    view = viewed(scene, gravity)
    if view.rubs or view.eccentric or view.across():
        return None
    return "both bodies move along the normal, which passes through their mass centres: no impulse acts across it"


def oblique_suffices(scene: Scene, /, *, gravity: float = STANDARD_GRAVITY) -> str | None:
    """Reason why an oblique impact without friction or spin is enough, or None."""
    view = viewed(scene, gravity)
    if view.rubs or view.eccentric:
        return None
    why = "without friction" if view.friction == 0 else "without slip at the contact"
    return f"{why} and with the normal through the mass centres nothing acts across it and no spin changes"


def planar_suffices(scene: Scene, /, *, gravity: float = STANDARD_GRAVITY) -> str | None:
    """Reason why the plane of normal and slip is enough, or None."""
    view = viewed(scene, gravity)
    if view.friction == 0:
        return "without friction the direction of slip does not matter"
    if view.turns:
        return None
    return "an impulse in the plane of normal and slip moves the contact in that plane only: the slip stays on one line"


def solve_central(
    scene: Annotated[Scene, "Two bodies and a contact."],
    /,
    *,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> SpatialImpact:
    """Central impact of a scene: motion along the line of impact.

    Equation
    --------
    p = (1 + e) m_r u_n with 1/m_r = 1/m₁ + 1/m₂.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.10.
    """
    view = viewed(scene, gravity)
    neglects = _neglects(
        ("friction", view.rubs), ("the levers", view.eccentric), ("motion across the line", view.across())
    )
    return _answered(_smooth, scene, gravity, "central impact", advice=neglects)


def solve_oblique(
    scene: Annotated[Scene, "Two bodies and a contact."],
    /,
    *,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> SpatialImpact:
    """Oblique impact of a scene without friction and spin: velocities across the normal do not change.

    Equation
    --------
    p = (1 + e) m_r u_n with 1/m_r = 1/m₁ + 1/m₂.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.11.
    """
    view = viewed(scene, gravity)
    neglects = _neglects(("friction", view.rubs), ("the levers", view.eccentric))
    return _answered(_smooth, scene, gravity, "oblique impact", advice=neglects)


def _answered(
    solver: "Callable[..., Solved]", scene: Scene, gravity: float, *more: str, advice: tuple[Advice, ...] = ()
) -> SpatialImpact:
    """The answer of a smaller model; if it neglects effects of rounding size, its bounds include them."""
    from dynamics_cli.impact.spatial.bounds import answered, beside

    answer = answered(solver, scene, gravity, *more, advice=advice)
    if advice or answer.numerics is None or not _left_out(scene, gravity):
        return answer
    return beside(answer, answered(_in_space, scene, gravity))


def _left_out(scene: Scene, gravity: float) -> bool:
    """Whether a smaller model neglects anything at all, were it but rounding of the inputs."""
    from decimal import Context, localcontext

    from dynamics_cli.impact.spatial.arithmetic import widened

    with localcontext(Context(prec=80)):
        exact = SeenScene(widened(scene), widened(gravity), absent=10**60)
    return exact.effects != viewed(scene, gravity).effects


def _smooth(scene: Scene, gravity: float, name: str, **_: int) -> Solved:
    """An impulse along the normal through both mass centres."""
    view = viewed(scene, gravity)
    # without inertia nothing turns; with a lever a spin still moves the contact
    a, b = (SolidInSpace(**{**body.__dict__, "inertia": None, "inverse": None}) for body in view.bodies)
    k = mobility((a, b), view.frame)
    before = approach((a, b), view.frame)
    e = view.restitution
    compression = -before[2] / k[2][2]
    impulse = (1 + e) * compression
    work = compression * -before[2] / 2
    zero = before[2] * 0
    end = End(
        velocity=(before[0], before[1], -e * before[2]),
        impulse=(zero, zero, impulse),
        compression=compression,
        work=work,
        work_back=e * e * work,
        heat=zero,
        history="slip without friction" if before[0] or before[1] else "no slip",
        slip_impulse=impulse if view.friction == 0 else zero,
    )
    return Solved((a, b), view.frame, k, before, end, zero, e, view.law, f"closed form of a {name}, in decimals")


def solve_planar(
    scene: Annotated[Scene, "Two bodies and a contact."],
    /,
    *,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> SpatialImpact:
    """Planar impact of a scene: the closed-form path in the plane of the normal and the first slip.

    Equation
    --------
    u' = u + K p in that plane; slip, then stick or reversed slip, as `impact planar`.

    References
    ----------
    J. B. Keller, Impact with friction, J. Appl. Mech. 53 (1986); W. J. Stronge, Impact Mechanics (2000).
    """
    view = viewed(scene, gravity)
    turns = view.turns and view.friction > 0
    return _answered(_in_plane, scene, gravity, advice=_neglects(("the turning of the slip out of its plane", turns)))


def _in_plane(scene: Scene, gravity: float, **effort: int) -> Solved:
    """Slip along its line, and then stick or reversed slip."""
    view = viewed(scene, gravity)
    k, before, zero = view.k, view.before, view.before[2] * 0
    plane = (k[0][0], zero, k[0][2]), (zero, k[1][1], zero), (k[0][2], zero, k[2][2])
    end = followed(plane, before, view.friction, view.restitution, view.law, **effort)
    aside = k[0][1] * end.impulse[0] + k[1][2] * end.impulse[2]
    changed = {
        "velocity": (end.velocity[0], aside, end.velocity[2]),
        "history": end.history.replace("slip anew", "reversed slip"),
    }
    end = End(**{**end.__dict__, **changed})
    how = "closed-form Routh–Keller path in the plane of normal and slip, in decimals"
    return Solved(view.bodies, view.frame, k, before, end, view.friction, view.restitution, view.law, how)


def solve(
    scene: Annotated[Scene, "Two bodies and a contact."],
    /,
    *,
    gravity: Annotated[Gravity, "Acceleration of gravity, for bodies given by weight [m/s^2]."] = STANDARD_GRAVITY,
) -> SpatialImpact:
    """Two bodies and one contact in space, with friction, spin and slip that turns.

    Equation
    --------
    As `impact spatial`.

    Returns
    -------
    SpatialImpact
        Velocities and spins after, impulses, ΔV, slip history, energies.

    Raises
    ------
    InadmissibleError
        When the bodies do not approach, lack what their motion needs, or are described in inconsistent frames.

    Notes
    -----
    Which smaller model suffices is decided by K in the frame of the contact, not by how the scene was written down.

    References
    ----------
    J. B. Keller, Impact with friction, J. Appl. Mech. 53 (1986); W. J. Stronge, Impact Mechanics (2000).
    """
    view = viewed(scene, gravity)
    require(
        not view.single,
        "the impact leaves the plane, but the {names} body has one moment of inertia only",
        names=" and the ".join(view.single),
        code="one-moment",
        hint="give the inertia tensor, or choose --model planar and say why",
    )
    from dynamics_cli.impact.spatial.bounds import answered

    return answered(_in_space, scene, gravity)


def _in_space(scene: Scene, gravity: float, **effort: int) -> Solved:
    view = viewed(scene, gravity)
    return solved_in_space(view.bodies, view.inward, view.friction, view.restitution, view.law, **effort)


def _neglects(*aspects: tuple[str, bool]) -> tuple[Advice, ...]:
    """Advice on effects in this scene that a requested model neglects."""
    names = [name for name, present in aspects if present]
    if not names:
        return ()
    text = "this scene goes beyond the model, which leaves out " + ", ".join(names)
    return (Advice("model-too-small", text, "serious", remedy="leave out --model"),)
