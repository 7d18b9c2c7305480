"""Checks of a planar impact, and advice about its inputs."""

from dynamics_cli.errors import worded
from dynamics_cli.impact.diagnostics import balance, momentum_kept, not_above
from dynamics_cli.impact.planar.bodies import Pair, Solid
from dynamics_cli.impact.planar.laws import ON_THE_PATH, Meeting, Outcome
from dynamics_cli.impact.planar.path import Path, travel
from dynamics_cli.numerics.elementary import absolute, hypot
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.numerics.vectors import planar_cross as cross
from dynamics_cli.numerics.vectors import planar_dot as dot
from dynamics_cli.quantities import Ratio
from dynamics_cli.records import Advice, Check

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.impact.planar.results import AfterPlanar, PlanarImpact


def certificate(
    answer: "PlanarImpact", solved: Outcome, law: str, m: Meeting, first: Solid, second: Solid, inward: Pair
) -> tuple[Check, ...]:
    """Momentum, angular momentum, energy, friction, no tension, and the law by its own definition."""
    if not single(solved.normal, m.slip, first.spin, second.spin):
        return ()
    size = answer.impulse_magnitude
    states = (first, answer.first), (second, answer.second)
    after = answer.first.velocity, answer.second.velocity
    checks = momentum_kept((first.mass, second.mass), (first.velocity, second.velocity), after, size)
    checks += _turning(states, answer.moment_impulse, size)
    # velocity change at the contact in the most compliant direction: all components are rounded beside it
    moved = (m.mobility.tangential + m.mobility.normal) * size
    checks += _kinematics(states, solved, inward, moved)
    work = solved.scale + moved * size + absolute(answer.first.energy_change) + absolute(answer.second.energy_change)
    gained = answer.first.energy_change + answer.second.energy_change
    checks += balance("energy", gained, -solved.lost, work)
    if not plain(m.restitution) > 1.0:
        checks += not_above("no energy is gained", -solved.lost, 0.0, work)
    checks += not_above("no tension", -solved.normal, 0.0, size)
    path = None
    if law in ON_THE_PATH:
        path = travel(m.mobility, m.slip, m.approach, m.friction, m.restitution, law)
    return checks + _friction(m, solved, path) + _restitution(m, solved, law, path)


def _turning(states: "tuple[tuple[Solid, AfterPlanar], ...]", moment: float | None, size: float) -> tuple[Check, ...]:
    """Angular momentum of each body about the contact, where the impulse has no moment but a moment impulse."""
    checks: tuple[Check, ...] = ()
    for (body, end), name, sense in zip(states, ("first", "second"), (-1.0, 1.0), strict=True):
        if body.mass is None or body.inertia is None:
            continue
        before = body.inertia * body.spin - body.mass * cross(body.lever, body.velocity)
        after = body.inertia * end.spin - body.mass * cross(body.lever, end.velocity)
        reach = hypot(body.lever[0], body.lever[1])
        scale = absolute(body.inertia * body.spin) + reach * size
        scale = scale + reach * body.mass * hypot(body.velocity[0], body.velocity[1])
        moment_impulse = 0.0 if moment is None else sense * moment
        checks += balance(f"angular momentum of the {name} about the contact", before + moment_impulse, after, scale)
    return checks


def _kinematics(
    states: "tuple[tuple[Solid, AfterPlanar], ...]", solved: Outcome, inward: Pair, least: float
) -> tuple[Check, ...]:
    """Check that velocities after, at the contact, give the law's final relative velocity."""
    speeds, relative = least, [0.0, 0.0]
    for (body, end), sense in zip(states, (1.0, -1.0), strict=True):
        x = end.velocity[0] - end.spin * body.lever[1]
        y = end.velocity[1] + end.spin * body.lever[0]
        relative = [relative[0] + sense * x, relative[1] + sense * y]
        reach = hypot(body.lever[0], body.lever[1])
        speeds = speeds + hypot(body.velocity[0], body.velocity[1]) + end.speed
        speeds = speeds + reach * (absolute(body.spin) + absolute(end.spin))
    after_relative = relative[0], relative[1]
    across = -inward[1], inward[0]
    return balance("separation at the contact", dot(after_relative, inward), solved.normal_after, speeds) + balance(
        "slip at the contact", dot(after_relative, across), solved.tangential_after, speeds
    )


def _friction(m: Meeting, solved: Outcome, path: "Path | None") -> tuple[Check, ...]:
    """|p_t| ≤ μ p_n in all, and on the path in both phases."""
    limit = m.friction * solved.normal
    checks = not_above("friction at most μ times the normal impulse", absolute(solved.tangential), limit, solved.normal)
    if path is None:
        return checks
    steepest = max(abs(plain(path.slopes[0])), 0.0 if plain(path.ended_first) else abs(plain(path.slopes[1])))
    return checks + not_above("friction at most μ at every stage", steepest, m.friction, 1.0 + plain(m.friction))


def _restitution(m: Meeting, solved: Outcome, law: str, path: "Path | None") -> tuple[Check, ...]:
    """Check restitution by its definition, from quantities that the law did not use."""
    name = f"restitution as {law} defines it"
    if law == "poisson":
        back = solved.normal - solved.compression  # type: ignore[operator]
        return balance(name, back, m.restitution * solved.compression, solved.normal)  # type: ignore[operator]
    if law != "stronge" or path is None:
        return balance(name, solved.normal_after, -m.restitution * m.approach, absolute(m.approach))
    # the returned work, by the trapezoids of the path
    k, rest = m.mobility, solved.normal - path.compression
    turned = m.approach + (k.normal + k.coupling * path.slopes[0]) * path.first_slip
    if plain(path.ended_first) or not plain(turned) > 0.0:
        back = 0.5 * solved.normal_after * rest
    else:
        back = 0.5 * turned * (path.first_slip - path.compression)
        back = back + 0.5 * (turned + solved.normal_after) * (solved.normal - path.first_slip)
    return balance(name, back, m.restitution * m.restitution * path.compression_work, path.compression_work)


def lever_advice(first: Solid, second: Solid) -> tuple[Advice, ...]:
    """Advice when a contact lies far outside a body of that inertia: beyond four radii of gyration."""
    advice: tuple[Advice, ...] = ()
    for body, name in ((first, "first"), (second, "second")):
        if body.mass is None or body.inertia is None:
            continue
        reach = absolute(hypot(body.lever[0], body.lever[1]))
        square = plain(reach * reach * body.mass / body.inertia)
        if single(square) and square > 16.0:
            message = worded(
                "the contact lies {times:3} radii of gyration from the mass centre of the {name} body",
                times=(square**0.5, Ratio),
                name=name,
            )
            remedy = "check its lever and its inertia: within a solid body it is at most about 2.5"
            advice += (Advice(code="far-contact", message=message, remedy=remedy),)
    return advice


def side_advice(first: Solid, second: Solid, towards: Pair) -> tuple[Advice, ...]:
    """Advice when a mass centre lies on the other body's side of the contact."""
    advice: tuple[Advice, ...] = ()
    for body, name, sense in ((first, "first", 1.0), (second, "second", -1.0)):
        if body.mass is None:
            continue
        ahead = sense * dot(body.lever, towards)
        if single(ahead) and plain(ahead) < 0.0:
            message = worded(
                "the mass centre of the {name} body lies on the other body's side of the contact", name=name
            )
            remedy = "the normal points from the first body to the second: reverse it, or check the lever"
            advice += (Advice(code="contact-behind", message=message, remedy=remedy),)
    return advice


def restituted_advice(law: str, moment_restitution: float) -> tuple[Advice, ...]:
    """Advice when a moment coefficient is given with a law that has none."""
    if law == "brach" or not single(moment_restitution) or plain(moment_restitution) == 1.0:
        return ()
    message = worded("only Brach's law has a moment restitution; {law} answers without it", law=law)
    return (Advice(code="moment-ignored", message=message, remedy="--law brach"),)
