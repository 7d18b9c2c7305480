"""Several touching bodies in line: the answer is not unique, so every answer names its law."""

from math import fsum

from dynamics_cli.errors import require, worded
from dynamics_cli.impact.diagnostics import TOLERANCE, balance, not_above, require_finite, require_sizes
from dynamics_cli.impact.particles.chain_records import AfterChain, Body, ChainLaw, ChainResult, LawAnswer
from dynamics_cli.quantities import Annotated, Restitution, Speed
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.impact.particles.chain_laws import Answer, Bounded

UNIT_ROUNDOFF = 2.0**-53
LAWS = "sequential", "simultaneous"
ALL = ChainLaw("all")


def _require_row(bodies: tuple[Body, ...]) -> None:
    require(len(bodies) >= 2, "a chain has two bodies or more", code="too-few", hint='repeat --body "mass=1 kg"')
    require(
        bodies[-1].restitution is None,
        "the last body has a restitution with the next body, but it is the last",
        code="no-next",
        hint="give it to the body before: the contact belongs to the first of two",
    )
    require(len(bodies) <= 500, "{count} bodies are more than 500", count=len(bodies), code="too-many")
    for number, body in enumerate(bodies, 1):
        require(body.mass > 0.0, "the mass of body {number} must be above zero", number=number, code="no-mass")
        require_finite(body.mass * body.velocity * body.velocity, f"the energy of body {number}")


def chain(
    *,
    bodies: Annotated[tuple[Body, ...], "The bodies in order along the line."],
    restitution: Annotated[Restitution, "Coefficient of restitution of contacts without one [-]."],
    law: Annotated[ChainLaw, "Which law: sequential, simultaneous, or all of them side by side."] = ALL,
) -> ChainResult:
    """Several bodies in line, touching: velocities after by sequential pairs, or by all contacts at one moment.

    Equation
    --------
    Pair: p = (1 + e) m_r u. At one moment: p = (1 + e) c with K c − u ≥ 0, c ≥ 0, one of them zero at every contact.

    Returns
    -------
    ChainResult
        For each law the velocities, impulses and energy lost.

    Raises
    ------
    InadmissibleError
        When there are fewer than two bodies, a mass is zero, no pair closes, or the requested law has no answer:
        endless collisions, or different restitutions that would add energy.

    Notes
    -----
    Rigid-body theory does not decide between the laws: equal elastic balls give (0, 0, 1) by pairs and (−⅓, ⅔, ⅔) at
    one moment. Even very small gaps, and waves in real bodies, favour pairs. Results are rounded once, from decimals
    of many digits: the stated bound is that of rounding, including conversion to another unit.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.10, applied pair by pair; Moreau's law
    of impact (1988) for all contacts at one moment.

    Examples
    --------
    >>> row = (Body(1.0, 1.0), Body(1.0), Body(1.0))
    >>> [ball.velocity for ball in chain(bodies=row, restitution=1.0, law=ChainLaw("sequential")).bodies]
    [0.0, 0.0, 1.0]
    """
    require_sizes(bodies=bodies, restitution=restitution)
    _require_row(bodies)
    ratios = [restitution if body.restitution is None else body.restitution for body in bodies[:-1]]
    fastest = max(_closing([body.velocity for body in bodies]))
    require(
        fastest > 0.0,
        "no impact: no body approaches the next, the fastest pair closes at {fastest:6}",
        fastest=(fastest, Speed),
        code="no-impact",
        hint="velocities are positive from the first body to the last",
    )
    from dynamics_cli.impact.particles.chain_laws import Answer, Chain, momentum

    masses, speeds = [body.mass for body in bodies], [body.velocity for body in bodies]
    row = Chain(masses, speeds, ratios)
    laws = LAWS if law == "all" else (str(law),)
    answers: list[LawAnswer] = []
    solutions: list[Answer] = []
    after: list[tuple[AfterChain, ...]] = []
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    for name in laws:
        solution = Answer(row, name)
        text = worded("{name}: {why}", name=name, why=solution.why)
        require(not solution.why or law == "all", "{text}", text=text, code="no-answer", hint="try --law all")
        if solution.why:
            advice += (Advice(f"no-{name}", text, severity="caution"),)
            continue
        solutions.append(solution)
        answers.append(LawAnswer(name, solution.lost.value, solution.collisions))
        after.append(_after(name, solution))
        checks += _checks(answers[-1], after[-1], bodies)
    require(
        len(answers) > 0,
        "neither law has an answer: {sequential}; {simultaneous}",
        **{name: item.message for name, item in zip(LAWS, advice, strict=False)},
        code="no-answer",
    )
    total = momentum(masses, speeds)
    return ChainResult(
        momentum=total,
        laws=tuple(answers),
        bodies=tuple(row for rows in after for row in rows),
        checks=checks,
        advice=advice + _differ(after, fastest),
        numerics=Numerics("pairs and complementarity, in decimals of many digits", _bounds(solutions, total)),
    )


def _closing(velocities: list[float]) -> list[float]:
    return [velocities[i] - velocities[i + 1] for i in range(len(velocities) - 1)]


def _after(name: str, solution: "Answer") -> tuple[AfterChain, ...]:
    pushes = [*(push.value for push in solution.impulses), None]
    return tuple(
        AfterChain(name, index + 1, velocity.value, change.value, push)
        for index, (velocity, change, push) in enumerate(
            zip(solution.velocities, solution.changes, pushes, strict=True)
        )
    )


def _bounds(answers: "list[Answer]", momentum: float) -> tuple[ErrorBound, ...]:
    """Rounding of the results to doubles, plus what the digits of the decimals leave."""
    bounds: list[ErrorBound] = [ErrorBound("momentum", UNIT_ROUNDOFF)] if momentum else []

    def add(name: str, number: "Bounded") -> None:
        bounds.append(
            ErrorBound(name, number.error / abs(number.value))
            if number.value
            else ErrorBound(name, number.error, False)
        )

    place = 0
    for index, solution in enumerate(answers):
        add(f"laws[{index}].energy_lost", solution.lost)
        for velocity, change in zip(solution.velocities, solution.changes, strict=True):
            add(f"bodies[{place}].velocity", velocity)
            add(f"bodies[{place}].delta_v", change)
            place += 1
        first = place - len(solution.velocities)
        for j, push in enumerate(solution.impulses):
            add(f"bodies[{first + j}].impulse_to_next", push)
    return tuple(bounds)


def _checks(answer: LawAnswer, rows: tuple[AfterChain, ...], bodies: tuple[Body, ...]) -> tuple[Check, ...]:
    name = answer.law
    speeds = [body.velocity for body in bodies], [row.velocity for row in rows]
    parts = [[body.mass * v for body, v in zip(bodies, side, strict=True)] for side in speeds]
    pushes = [row.impulse_to_next or 0.0 for row in rows]
    # velocities are as accurate as the rounding of the fastest one
    fastest = max(abs(v) for v in speeds[0])
    size = fsum([abs(part) for part in (*parts[0], *parts[1], *pushes)]) + fsum([b.mass * fastest for b in bodies])
    checks = balance(f"{name}: momentum", fsum(parts[0]), fsum(parts[1]), size)
    energies = [fsum([0.5 * m * v for m, v in zip(*side, strict=True)]) for side in zip(parts, speeds, strict=True)]
    scale = energies[0] + fsum([abs(p * body.velocity) for p, body in zip(pushes, bodies, strict=True)])
    tolerance = max(TOLERANCE, 32.0 * answer.collisions * UNIT_ROUNDOFF)
    checks += balance(f"{name}: energy", energies[0] - energies[1], answer.energy_lost, scale, tolerance)
    checks += not_above(f"{name}: no energy is gained", -answer.energy_lost, 0.0, scale)
    checks += not_above(f"{name}: no tension", -min(pushes), 0.0, max(pushes))
    return checks + not_above(f"{name}: no pair closes", max(_closing(speeds[1])), 0.0, fastest)


def _differ(after: list[tuple[AfterChain, ...]], fastest: float) -> tuple[Advice, ...]:
    if len(after) < 2:
        return ()
    apart = max(abs(body.velocity - other_body.velocity) for body, other_body in zip(*after, strict=True))
    if apart <= 1e-9 * fastest:
        return ()
    message = worded(
        "the laws differ by up to {apart}: rigid-body theory does not decide between them", apart=(apart, Speed)
    )
    remedy = "choose --law sequential for bodies with gaps, however small"
    return (Advice(code="not-unique", message=message, severity="note", remedy=remedy),)
