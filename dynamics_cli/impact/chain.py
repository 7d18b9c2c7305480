"""Several bodies in line that touch: the answer is not unique, so every answer names its law."""

from dynamics_cli.errors import require
from dynamics_cli.impact.chain_records import AfterChain, Body, ChainFound, ChainLaw, LawAnswer
from dynamics_cli.impact.diagnostics import TOLERANCE, balance, not_above, require_finite, require_sizes
from dynamics_cli.quantities import Restitution
from dynamics_cli.records import Advice, Check, ErrorBound, Numerics

UNIT_ROUNDOFF = 2.0**-53
# Closing speeds below this share of the greatest are rounding.
NOTHING = 1e-14
MOST_COLLISIONS = 20000
MOST_ROUNDS = 2000


ALL = ChainLaw("all")


def chain(*, bodies: tuple[Body, ...], restitution: Restitution, law: ChainLaw = ALL) -> ChainFound:
    """Several bodies in line, touching: velocities after by sequential pairs, or by all contacts at one moment.

    Equation
    --------
    Pair: p = (1 + e) m_r u. At one moment: p = (1 + e) c with K c − u ≥ 0, c ≥ 0, one of them zero at every contact.

    Parameters
    ----------
    bodies : tuple[Body, ...]
        The bodies in order along the line.
    restitution : Restitution
        Coefficient of restitution of contacts that have none of their own [-].
    law : ChainLaw
        Which law: sequential, simultaneous, or all of them side by side.

    Returns
    -------
    ChainFound
        For each law the velocities, impulses and energy lost.

    Raises
    ------
    InadmissibleError
        When there are fewer than two bodies, a mass is zero, no pair closes, or the law asked for has no answer: pairs
        that collide without end, or unlike restitutions that would give energy.

    Notes
    -----
    Rigid bodies do not decide between the laws: equal elastic balls give (0, 0, 1) by pairs and (−⅓, ⅔, ⅔) at one
    moment. Gaps, however small, and waves in real bodies favour pairs.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 9.10, applied pair by pair; Moreau's law
    of impact (1988) for all contacts at one moment.

    Examples
    --------
    >>> row = (Body(1.0, 1.0), Body(1.0), Body(1.0))
    >>> [one.velocity for one in chain(bodies=row, restitution=1.0, law=ChainLaw("sequential")).bodies]
    [0.0, 0.0, 1.0]
    """
    require_sizes(bodies=bodies, restitution=restitution)
    require(len(bodies) >= 2, "a chain has two bodies or more", code="too-few", hint='repeat --body "mass=1 kg"')
    require(
        bodies[-1].restitution is None,
        "the last body has a restitution with the next, but there is no next",
        code="no-next",
        hint="give it to the body before: the contact belongs to the first of two",
    )
    require(len(bodies) <= 500, f"{len(bodies)} bodies are more than 500", code="too-many")
    for index, body in enumerate(bodies):
        require(body.mass > 0.0, f"bodies[{index}] has a mass of " + "{0:.6g} kg", body.mass, code="no-mass")
        require_finite(body.mass * body.velocity * body.velocity, f"the energy of bodies[{index}]")
    ratios = [restitution if body.restitution is None else body.restitution for body in bodies[:-1]]
    fastest = max(_closing([body.velocity for body in bodies]))
    require(
        fastest > 0.0,
        "no impact: no body approaches the next, the fastest pair closes at {0:.6g} m/s",
        fastest,
        code="no-impact",
        hint="velocities are positive from the first body to the last",
    )
    laws = {"sequential": _sequential, "simultaneous": _simultaneous}
    asked = list(laws) if law == "all" else [str(law)]
    answers: list[LawAnswer] = []
    after: list[tuple[AfterChain, ...]] = []
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    for name in asked:
        changes, impulses, collisions, lost, why = laws[name](bodies, ratios)
        require(not why or law == "all", f"{name}: {why}", code="no-answer", hint="try the other law: --law all")
        if why:
            advice += (Advice(f"no-{name}", f"{name}: {why}", severity="caution"),)
            continue
        answers.append(LawAnswer(name, lost, collisions))
        after.append(_after(name, bodies, changes, impulses))
        checks += _checks(answers[-1], after[-1], bodies)
    require(len(answers) > 0, "neither law has an answer: " + "; ".join(a.message for a in advice), code="no-answer")
    return ChainFound(
        momentum=_sum([body.mass * body.velocity for body in bodies]),
        laws=tuple(answers),
        bodies=tuple(row for rows in after for row in rows),
        checks=checks,
        advice=advice + _differ(after, fastest),
        numerics=Numerics("pairs and complementarity", _bounds(bodies, answers, after)),
    )


def _sum(parts: list[float]) -> float:
    import math

    return math.fsum(parts)


def _closing(velocities: list[float]) -> list[float]:
    return [velocities[i] - velocities[i + 1] for i in range(len(velocities) - 1)]


# Changes of velocity, impulses between neighbours, collisions, energy lost, and why there is no answer.
Answer = tuple[list[float], list[float], int, float, str]


def _sequential(bodies: tuple[Body, ...], ratios: list[float]) -> Answer:
    """One pair at a time, the fastest first."""
    masses = [body.mass for body in bodies]
    changes = [0.0] * len(bodies)
    impulses = [0.0] * len(ratios)
    lost = 0.0
    scale = max(abs(body.velocity) for body in bodies)
    for count in range(MOST_COLLISIONS):
        closing = _closing([body.velocity + change for body, change in zip(bodies, changes, strict=True)])
        fastest = max(closing)
        if fastest <= NOTHING * scale:
            return changes, impulses, count, lost, ""
        at = closing.index(fastest)
        m, other = masses[at], masses[at + 1]
        reduced = min(m, other) / (1.0 + min(m, other) / max(m, other))
        push = (1.0 + ratios[at]) * reduced * fastest
        lost += 0.5 * (1.0 - ratios[at]) * (1.0 + ratios[at]) * reduced * fastest * fastest
        impulses[at] += push
        changes[at] -= push / m
        changes[at + 1] += push / other
    why = f"the pairs go on colliding after {MOST_COLLISIONS} collisions"
    return changes, impulses, MOST_COLLISIONS, lost, why


def _simultaneous(bodies: tuple[Body, ...], ratios: list[float]) -> Answer:
    """All contacts at one moment, in rounds until no pair closes.

    Relative velocities are what the law speaks of; a light body between heavy ones keeps its digits by them.
    """
    weights = [1.0 / body.mass for body in bodies]
    start = _closing([body.velocity for body in bodies])
    closing = list(start)
    scale = max(abs(body.velocity) for body in bodies)
    total = [0.0] * len(ratios)
    lost, size = 0.0, 0.0
    alike = len(set(ratios)) == 1
    for count in range(MOST_ROUNDS):
        if max(closing) <= NOTHING * scale:
            gained = lost < -1e-12 * size
            why = f"unlike restitutions would give {-lost:.4g} J to the bodies" if gained else ""
            opened = [one - other for one, other in zip(start, closing, strict=True)]
            return _spread(bodies, opened), total, count, lost, why
        plastic, acting = _plastic(weights, closing)
        held = [u if a else o for u, a, o in zip(closing, acting, _opened(weights, plastic), strict=True)]
        if alike:
            e = ratios[0]
            opened = [(1.0 + e) * o for o in held]
            works = [0.5 * (1.0 - e) * (1.0 + e) * p * o for p, o in zip(plastic, held, strict=True)]
        else:
            more = _opened(weights, [e * p for e, p in zip(ratios, plastic, strict=True)])
            opened = [o + again for o, again in zip(held, more, strict=True)]
            pushes = zip(ratios, plastic, closing, opened, strict=True)
            works = [0.5 * (1.0 + e) * p * (u + u - o) for e, p, u, o in pushes]
        lost += _sum(works)
        size += _sum([abs(work) for work in works])
        total = [one + (1.0 + e) * p for one, e, p in zip(total, ratios, plastic, strict=True)]
        closing = [u - o for u, o in zip(closing, opened, strict=True)]
    why = f"the pairs still close after {MOST_ROUNDS} rounds"
    return [0.0] * len(bodies), total, MOST_ROUNDS, lost, why


def _spread(bodies: tuple[Body, ...], opened: list[float]) -> list[float]:
    """Changes of velocity that open the contacts by so much and leave the momentum: sums of shares of the mass."""
    whole = _sum([body.mass for body in bodies])
    behind = [_sum([body.mass for body in bodies[: j + 1]]) / whole for j in range(len(opened))]
    ahead = [_sum([body.mass for body in bodies[j + 1 :]]) / whole for j in range(len(opened))]
    return [_sum([behind[j] * o if j < i else -ahead[j] * o for j, o in enumerate(opened)]) for i in range(len(bodies))]


def _plastic(weights: list[float], closing: list[float]) -> tuple[list[float], list[bool]]:
    """Least impulses after which no pair closes: an M-matrix, so the set of acting contacts only grows."""
    scale = max(abs(u) for u in closing)
    acting = [u > 0.0 for u in closing]
    impulses: list[float] = []
    for _ in range(len(closing) + 1):
        impulses = _tridiagonal(weights, closing, acting)
        opened = _opened(weights, impulses)
        short = [not a and o < u - 1e-15 * scale for a, o, u in zip(acting, opened, closing, strict=True)]
        if not any(short):
            break
        acting = [a or s for a, s in zip(acting, short, strict=True)]
    return impulses, acting


def _opened(weights: list[float], impulses: list[float]) -> list[float]:
    """K p: by how much the impulses open every contact."""
    count = len(impulses)
    opened = []
    for i in range(count):
        value = (weights[i] + weights[i + 1]) * impulses[i]
        if i > 0:
            value -= weights[i] * impulses[i - 1]
        if i + 1 < count:
            value -= weights[i + 1] * impulses[i + 1]
        opened.append(value)
    return opened


def _tridiagonal(weights: list[float], wanted: list[float], acting: list[bool]) -> list[float]:
    """K p = wanted on runs of acting contacts, p = 0 elsewhere."""
    impulses = [0.0] * len(wanted)
    start = 0
    while start < len(wanted):
        if not acting[start]:
            start += 1
            continue
        end = start
        while end < len(wanted) and acting[end]:
            end += 1
        # elimination without a subtraction: the diagonal keeps what it owes to the bodies before apart
        right = wanted[start:end]
        owed = weights[start]
        diagonal = [owed + weights[start + 1]]
        for i in range(1, end - start):
            factor = weights[start + i] / diagonal[i - 1]
            owed = factor * owed
            diagonal.append(owed + weights[start + i + 1])
            right[i] += factor * right[i - 1]
        for i in reversed(range(end - start)):
            following = weights[start + i + 1] * impulses[start + i + 1] if start + i + 1 < end else 0.0
            impulses[start + i] = (right[i] + following) / diagonal[i]
        start = end
    return impulses


def _after(name: str, bodies: tuple[Body, ...], changes: list[float], impulses: list[float]) -> tuple[AfterChain, ...]:
    rows = []
    for index, (body, change) in enumerate(zip(bodies, changes, strict=True)):
        pushes = impulses[index] if index < len(impulses) else None
        rows.append(AfterChain(name, index + 1, body.velocity + change, change, pushes))
    return tuple(rows)


def _checks(answer: LawAnswer, rows: tuple[AfterChain, ...], bodies: tuple[Body, ...]) -> tuple[Check, ...]:
    name = answer.law
    speeds = [body.velocity for body in bodies], [row.velocity for row in rows]
    parts = [[body.mass * v for body, v in zip(bodies, side, strict=True)] for side in speeds]
    pushes = [row.impulse_to_next or 0.0 for row in rows]
    # velocities are as right as the fastest of them is rounded
    fastest = max(abs(v) for v in speeds[0])
    size = _sum([abs(part) for part in (*parts[0], *parts[1], *pushes)]) + _sum([b.mass * fastest for b in bodies])
    checks = balance(f"{name}: momentum", _sum(parts[0]), _sum(parts[1]), size)
    energies = [_sum([0.5 * m * v for m, v in zip(*side, strict=True)]) for side in zip(parts, speeds, strict=True)]
    scale = energies[0] + _sum([abs(p * body.velocity) for p, body in zip(pushes, bodies, strict=True)])
    room = max(TOLERANCE, 32.0 * answer.collisions * UNIT_ROUNDOFF)
    checks += balance(f"{name}: energy", energies[0] - energies[1], answer.energy_lost, scale, room)
    checks += not_above(f"{name}: energy never gained", -answer.energy_lost, 0.0, scale)
    checks += not_above(f"{name}: no tension", -min(pushes), 0.0, max(pushes))
    return checks + not_above(f"{name}: no pair closes", max(_closing(speeds[1])), 0.0, fastest)


def _differ(after: list[tuple[AfterChain, ...]], fastest: float) -> tuple[Advice, ...]:
    if len(after) < 2:
        return ()
    apart = max(abs(one.velocity - other.velocity) for one, other in zip(*after, strict=True))
    if apart <= 1e-9 * fastest:
        return ()
    return (
        Advice(
            code="not-unique",
            message=f"the laws differ by up to {apart:.4g} m/s: rigid bodies do not decide between them",
            severity="note",
            mend="choose --law sequential for bodies with gaps, however small",
        ),
    )


def _bounds(
    bodies: tuple[Body, ...], answers: list[LawAnswer], after: list[tuple[AfterChain, ...]]
) -> tuple[ErrorBound, ...]:
    """Rounding of so many collisions, absolute in size, stated relative to each result."""
    found: list[tuple[str, float, float]] = []
    place = 0
    for index, (answer, rows) in enumerate(zip(answers, after, strict=True)):
        impulses = [row.impulse_to_next or 0.0 for row in rows]
        roundings = (8.0 + 4.0 * answer.collisions + 4.0 * len(bodies)) * UNIT_ROUNDOFF
        # every impulse is as wrong as the velocities it came from, which all impulses made
        fastest = max(abs(body.velocity) + abs(row.delta_v) for body, row in zip(bodies, rows, strict=True))
        total = _sum([body.mass * body.velocity * body.velocity for body in bodies])
        found.append((f"laws[{index}].energy_lost", answer.energy_lost, 2.0 * roundings * total))
        for j, (body, row) in enumerate(zip(bodies, rows, strict=True)):
            near = [bodies[k].mass for k in (j - 1, j, j + 1) if 0 <= k < len(bodies)]
            wrong = roundings * (fastest + ((impulses[j - 1] if j else 0.0) + impulses[j]) / body.mass)
            found.append((f"bodies[{place}].velocity", row.velocity, wrong))
            found.append((f"bodies[{place}].delta_v", row.delta_v, wrong))
            if row.impulse_to_next is not None:
                push = roundings * (impulses[j] + max(near) * fastest)
                found.append((f"bodies[{place}].impulse_to_next", row.impulse_to_next, push))
            place += 1
    return tuple(ErrorBound(name, wrong / abs(value)) for name, value, wrong in found if value != 0.0)
