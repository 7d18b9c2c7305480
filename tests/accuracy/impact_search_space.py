"""`impact spatial`: Keller's path in 128 bits, and bodies for which it has a closed form.

Most drawn bodies have a closed form: spheres struck along their levers, whose slip keeps its direction; bodies whose
motion stays in one plane, laid into space by turns of whole numbers (3-4-5 triangles), so that every double is exact;
contacts without friction. The shipped hard cases, what is disturbed of them and bodies of any kind are followed along
the path (`impact_keller`), one path for several laws and restitutions, each an answer of the program's own. Of the
suite's 10,000 answers some 1,100 are followed along the path and 8,900 have a closed form: an answer that is followed
costs the program five times as much.
"""

import json
import random
from collections.abc import Iterator
from fractions import Fraction
from math import sqrt
from typing import Any

from climbing import Answer, Question, Tree, arguments, bits, read, stated
from impact_search_solids import (
    CURVED,
    STRAIGHT,
    Met,
    Solid,
    cross,
    dot,
    exactly,
    inverse_of,
    meet,
    parallel,
    results,
    slacks,
    vector,
)
from precise import Exact
from references.impact_events import follow
from references.impact_keller import SEARCH, End, ended, smooth, whole

from dynamics_cli.accuracy import catalogue
from dynamics_cli.accuracy.cases import DATA, flat
from dynamics_cli.errors import DynamicsError
from dynamics_cli.impact.spatial.impact import spatial

LAWS = ("stronge", "newton", "poisson")
# Answers asked for along one path.
ALONG = 7
STILL = [0.0, 0.0, 0.0]


# ---- the exact side ----


def solid(tree: Tree) -> Solid:
    """A body of an input tree."""
    velocity, spin = vector(tree["velocity"]), vector(tree["spin"])
    if "mass" not in tree["bulk"]:
        return Solid(None, None, None, vector(STILL), velocity, spin)
    lever = vector(tree["arm"]["lever"])
    return Solid(Exact(tree["bulk"]["mass"]), tree["inertia"], inverse_of(tree["inertia"]), lever, velocity, spin)


def kind_of(tree: Tree) -> str:
    """Which closed form the impact has, or that it has to be followed; told exactly."""
    if tree["friction"] == 0.0:
        return "smooth"
    bodies = [body for body in (tree["first"], tree["second"]) if "mass" in body["bulk"]]
    if all(_central(body, tree["normal"]) for body in bodies):
        return "sphere"
    return "plane" if _in_a_plane(tree, bodies) else "path"


def _central(body: Tree, normal: list[float]) -> bool:
    (a, b, c), (_, d, e), (_, _, f) = body["inertia"]
    return a == d == f and not (b or c or e) and parallel(body["arm"]["lever"], normal)


def _in_a_plane(tree: Tree, bodies: list[Tree]) -> bool:
    normal = exactly(tree["normal"])
    axis = next((a for a in (cross(normal, exactly(body["arm"]["lever"])) for body in bodies) if any(a)), None)
    if axis is None:
        return False
    inside = [body["arm"]["lever"] for body in bodies] + [tree[name]["velocity"] for name in ("first", "second")]
    if any(dot(exactly(part), axis) for part in inside):
        return False
    if not all(parallel(tree[name]["spin"], axis) for name in ("first", "second")):
        return False
    return all(parallel([dot(exactly(row), axis) for row in body["inertia"]], axis) for body in bodies)


def smooth_end(met: Met, e: Any) -> End:
    """The end of an impact without friction, whatever the law."""
    return smooth(met.mobility, met.before, e)


def flat_end(met: Met, mu: Any, e: Any, law: str) -> End:
    """The end of an impact whose slip keeps its line."""
    k, u = met.mobility, met.before
    made = follow(k[0][0], k[0][2], k[2][2], u[0], u[2], mu, e, law)
    impulse = made["tangential"], Exact(0), made["normal"]
    return End(impulse, made["compression"], made["friction_work"], made["slip_impulse"])


def variants(rng: random.Random, tree: Tree) -> list[Tree]:
    """The same contact by other laws and restitutions."""
    if tree["contact"]["record"] != "Restituted":
        return [tree]
    ratios = [tree["contact"]["restitution"], rng.choice((0.0, 1.0)), rng.random()]
    others = [
        {**tree, "contact": {"record": "Restituted", "restitution": e}, "law": {"word": law}}
        for e in ratios
        for law in LAWS
    ]
    rng.shuffle(others)
    return [tree, *others[: ALONG - 1]]


def ask(rng: random.Random, tree: Tree) -> Iterator[Answer]:
    """One contact by several laws and restitutions."""
    kind = kind_of(tree)
    guide = None
    if kind == "plane":
        guide = next((vector(tree[name]["arm"]["lever"]) for name in ("first", "second") if "arm" in tree[name]), None)
    met = path = None
    for own in variants(rng, tree):
        try:
            answer = spatial(**arguments(own, GROUPS))
        except DynamicsError:
            continue
        mu, e, law = Exact(own["friction"]), Exact(own["contact"]["restitution"]), own["law"]["word"]
        if met is None:
            met = meet(solid(tree["first"]), solid(tree["second"]), tree["normal"], guide)
        if kind != "path":
            end = smooth_end(met, e) if kind == "smooth" else flat_end(met, mu, e, law)
        else:
            with bits(SEARCH.bits):
                path = whole(met.mobility, met.before, mu) if path is None else path
                end = ended(path, met.mobility, mu, met.before, e, law)
        noise = CURVED if kind == "path" else STRAIGHT
        yield Answer(own, stated(answer, flat(answer), results(met, end), slacks(met, end, noise)), kind)


# ---- what is asked ----


def body(mass: float, inertia: Any, lever: Any, velocity: Any, spin: Any) -> Tree:
    """A body as an input tree."""
    return {
        "record": "BodyInSpace", "bulk": {"record": "ByMass", "mass": mass}, "inertia": [list(row) for row in inertia],
        "arm": {"record": "LeverInSpace", "lever": list(lever)}, "velocity": list(velocity), "spin": list(spin),
    }  # fmt: skip


def fixed(velocity: Any) -> Tree:
    """A barrier."""
    return {
        "record": "TargetInSpace",
        "bulk": {"record": "Fixed", "fixed": True},
        "velocity": list(velocity),
        "spin": STILL,
    }


def impact(rng: random.Random, first: Tree, second: Tree, normal: Any, mu: float) -> Tree:
    """An impact; the bodies approach."""

    def moved(one: Tree) -> Any:
        turned = cross(one["spin"], one["arm"]["lever"]) if "arm" in one else STILL
        return [v + w for v, w in zip(one["velocity"], turned, strict=True)]

    u = [a - b for a, b in zip(moved(first), moved(second), strict=True)]
    way = 1.0 if dot(u, normal) > 0.0 else -1.0
    return {
        "first": first, "second": {**second, "record": "TargetInSpace"}, "normal": [way * x for x in normal],
        "friction": mu,
        "contact": {"record": "Restituted", "restitution": rng.choice((0.0, 1.0, rng.random(), rng.random()))},
        "law": {"word": rng.choice(LAWS)},
    }  # fmt: skip


def three(rng: random.Random, reach: float) -> list[float]:
    return [rng.uniform(-reach, reach) for _ in range(3)]


def turned(rng: random.Random, moments: list[float]) -> list[list[float]]:
    """A tensor of such principal moments, turned anyhow."""
    a, b, c, d = (rng.gauss(0.0, 1.0) for _ in range(4))
    length = sqrt(a * a + b * b + c * c + d * d)
    a, b, c, d = a / length, b / length, c / length, d / length
    turn = (
        (a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)),
        (2.0 * (b * c + a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d - a * b)),
        (2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a - b * b - c * c + d * d),
    )
    rows = [[sum(turn[i][k] * moments[k] * turn[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    return [[rows[max(i, j)][min(i, j)] for j in range(3)] for i in range(3)]


def block(rng: random.Random) -> Tree:
    """A body of any slenderness."""
    mass = 10.0 ** rng.choice((rng.uniform(-1.0, 4.0), rng.uniform(-9.0, 9.0)))
    sides = [10.0 ** rng.choice((rng.uniform(-0.5, 0.5), rng.uniform(-3.0, 0.5))) for _ in range(3)]
    squares = [mass / 12.0 * side * side for side in sides]
    moments = [squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]]
    reach = max(sides) * rng.choice((0.5, 0.5, 3.0))
    return body(
        mass, turned(rng, moments), three(rng, reach), three(rng, 5.0), three(rng, rng.choice((0.0, 3.0, 100.0)))
    )


def normal_of(rng: random.Random) -> list[float]:
    """A direction, now and then along an axis."""
    return rng.choice((three(rng, 1.0), [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]))


def friction(rng: random.Random) -> float:
    """Friction, mostly so little that the slip lasts: one that stops costs the program ten times as much."""
    return rng.uniform(0.0, 1.5) if rng.random() < 0.12 else 10.0 ** rng.uniform(-4.0, -1.2)


def of_any_kind(rng: random.Random) -> Tree:
    """Two blocks, or one and a barrier."""
    second = fixed(rng.choice((STILL, three(rng, 3.0)))) if rng.random() < 0.5 else block(rng)
    mu = rng.choice((rng.uniform(0.05, 1.0), 10.0 ** rng.uniform(-6.0, 2.0)))
    return impact(rng, block(rng), second, normal_of(rng), mu)


def ball(rng: random.Random, lever: list[float]) -> Tree:
    """A sphere, or what has such moments."""
    mass = 10.0 ** rng.choice((rng.uniform(-1.0, 4.0), rng.uniform(-9.0, 9.0)))
    moment = rng.uniform(0.01, 0.7) * mass * dot(lever, lever)
    inertia = [[moment if i == j else 0.0 for j in range(3)] for i in range(3)]
    slow = 10.0 ** rng.choice((0.0, 0.0, rng.uniform(-12.0, 0.0)))
    return body(mass, inertia, lever, [slow * x for x in three(rng, 5.0)], three(rng, rng.choice((0.0, 30.0))))


def of_spheres(rng: random.Random) -> Tree:
    """Spheres struck along their levers."""
    lever = rng.choice((three(rng, 1.0), [0.0, 0.0, -rng.uniform(0.01, 2.0)]))
    longer, other = (2.0 ** rng.randrange(-3, 4) for _ in range(2))
    normal = [longer * x for x in lever]
    second = fixed(three(rng, 2.0))
    if rng.random() < 0.5:
        second = ball(rng, [-other * x for x in lever])
    return impact(rng, ball(rng, lever), second, normal, friction(rng))


def _whole_turn(rng: random.Random) -> list[list[Fraction]]:
    """A turn about two axes by angles of 3-4-5 triangles: its entries are of 25ths."""
    made = [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]
    for axis in rng.sample(range(3), 2):
        c, s = rng.choice(((3, 4), (4, 3), (-3, 4), (4, -3), (5, 0), (0, 5)))
        i, j = (axis + 1) % 3, (axis + 2) % 3
        turn = [[Fraction(int(a == b)) for b in range(3)] for a in range(3)]
        turn[i][i] = turn[j][j] = Fraction(c, 5)
        turn[i][j], turn[j][i] = Fraction(-s, 5), Fraction(s, 5)
        made = [[dot(row, column) for column in zip(*made, strict=True)] for row in turn]
    return made


def _double(x: Fraction) -> float:
    made = float(x)
    assert Fraction(made) == x, "a turn of whole numbers leaves the doubles"
    return made


def of_a_plane(rng: random.Random) -> Tree:
    """Bodies that move in one plane of space, turned exactly."""
    turn = _whole_turn(rng)

    def laid(x: Fraction, y: Fraction, z: Fraction = Fraction(0)) -> list[float]:
        return [_double(dot(row, (x, y, z))) for row in turn]

    def number(reach: int) -> Fraction:
        return Fraction(25 * rng.randrange(-(reach << 12), (reach << 12) + 1), 1 << (12 + rng.choice((4, 4, 10))))

    def flat_body() -> Tree:
        mass = 10.0 ** rng.uniform(-1.0, 4.0)
        p, q, r = (Fraction(625 * rng.randrange(1, 4096), 4096 * 16) * 2 ** rng.randrange(-4, 5) for _ in range(3))
        moments = q + r, r + p, p + q
        rows = [[sum(turn[i][k] * moments[k] * turn[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
        inertia = [[_double(x) for x in row] for row in rows]
        return body(
            mass,
            inertia,
            laid(number(2), number(2)),
            laid(number(4), number(4)),
            laid(Fraction(0), Fraction(0), number(3)),
        )

    second = fixed(laid(number(1), number(1))) if rng.random() < 0.5 else flat_body()
    normal = laid(Fraction(25 * rng.randrange(-7, 8)), Fraction(25 * rng.randrange(1, 8)))
    return impact(rng, flat_body(), second, normal, friction(rng))


def without_friction(rng: random.Random) -> Tree:
    """Bodies of any kind without friction."""
    return {**of_any_kind(rng), "friction": 0.0}


def draw(rng: random.Random) -> Tree:
    """A fresh impact; most have a closed form."""
    way = rng.choices((of_any_kind, of_spheres, of_a_plane, without_friction), (3, 12, 6, 19))[0]
    return way(rng)


GROUPS = catalogue.groups("impact")


def starts() -> list[Tree]:
    """The hard cases that are shipped."""
    cases = json.loads((DATA / "impact_spatial.json").read_text(encoding="utf-8"))["cases"]
    return [_plain(read(case["inputs"])) for case in cases if case["task"] == "spatial" and case["kind"] == "hard"]


def _plain(tree: Tree) -> Tree:
    """A barrier is fixed, whatever numbers are moved; noses turn no bound."""
    for name in ("first", "second"):
        if tree[name]["bulk"]["record"] == "Fixed":
            tree[name]["bulk"]["fixed"] = True
        tree[name].pop("nose", None)
    return tree


def question() -> Question:
    """`impact spatial`."""
    return Question("impact spatial", starts(), draw, ask, drawn=0.95)
