"""`impact solve`: scenes by the smallest model that the program chooses, against the whole of their physics.

The exact side knows no smaller models: it takes the contact as it is in space, however little of it the model sees, and
follows it in closed form where the bodies are particles or stay in the plane of x and y, else along Keller's path.
What a model leaves out because it is "the rounding of the inputs" therefore counts as its error.
"""

import random
from collections.abc import Iterator
from typing import Any

from climbing import Answer, Question, Tree, arguments, bits, stated
from impact_search_solids import (
    CURVED,
    STRAIGHT,
    Met,
    Solid,
    cross,
    dot,
    inverse_of,
    meet,
    plus,
    results,
    slacks,
    vector,
)
from impact_search_space import GROUPS, LAWS, STILL, flat_end, friction, smooth_end, three, turned
from impact_search_space import starts as spatial_starts
from precise import FUNCTIONS, Exact
from references.impact_keller import SEARCH, ended, whole

from dynamics_cli.accuracy.cases import flat
from dynamics_cli.errors import DynamicsError
from dynamics_cli.impact.spatial import scene as models
from dynamics_cli.impact.spatial.scene_records import Scene

sin, cos = FUNCTIONS["sin"], FUNCTIONS["cos"]
GRAVITY = 9.80665
MODELS = (
    (models.central_suffices, models.solve_central),
    (models.oblique_suffices, models.solve_oblique),
    (models.planar_suffices, models.solve_planar),
)


def solid(tree: Tree) -> Solid:
    """A body of a scene in many bits."""
    motion, rotation = tree.get("motion", {}), tree.get("rotation", {})
    velocity = vector(motion.get("velocity", STILL))
    if "speed" in motion:
        speed, heading = Exact(motion["speed"]), Exact(motion["heading"])
        velocity = (speed * cos(heading), speed * sin(heading), Exact(0))
    spin = vector(rotation.get("spin", (0.0, 0.0, rotation.get("yaw_rate", 0.0))))
    lever = vector(tree["arm"]["lever"] if "arm" in tree else STILL)
    if tree["bulk"]["record"] == "Fixed":
        return Solid(None, None, None, lever, velocity, spin)
    bulk, turning = tree["bulk"], tree.get("turning")
    mass = Exact(bulk["mass"]) if "mass" in bulk else Exact(bulk["weight"]) / Exact(GRAVITY)
    if turning is None:
        return Solid(mass, None, None, lever, velocity, spin)
    rows = turning.get("inertia")
    if rows is None:
        radius = Exact(turning.get("radius_of_gyration", 0.0))
        moment = mass * radius * radius if radius else Exact(turning["moment"])
        rows = [[moment if i == j else Exact(0) for j in range(3)] for i in range(3)]
    return Solid(mass, rows, inverse_of(rows), lever, velocity, spin)


def keeps_its_line(tree: Tree) -> bool:
    """Whether the slip stays on one line: particles, or bodies that stay in the plane of x and y."""
    if tree["contact"]["friction"] == 0.0 or all("turning" not in tree[name] for name in ("first", "second")):
        return True
    if tree["contact"]["normal"][2]:
        return False
    for body in (tree["first"], tree["second"]):
        parts = [body.get("arm", {}).get("lever", STILL), body.get("motion", {}).get("velocity", STILL)]
        x, y, _ = body.get("rotation", {}).get("spin", STILL)
        rows = body.get("turning", {}).get("inertia")
        if x or y or any(part[2] for part in parts) or (rows and (rows[0][2] or rows[1][2])):
            return False
    return True


def answered(scene: Scene) -> Any:
    """The answer by the model that the program chooses."""
    for suffices, solve in MODELS:
        if suffices(scene) is not None:
            return solve(scene)
    return models.solve(scene)


def variants(rng: random.Random, tree: Tree, count: int) -> list[Tree]:
    """The same scene by other laws and restitutions."""
    others = [
        {**tree, "contact": {**tree["contact"], "restitution": e, "law": {"word": law}}}
        for e in (tree["contact"]["restitution"], rng.choice((0.0, 1.0)), rng.random())
        for law in LAWS
    ]
    rng.shuffle(others)
    return [tree, *others[: count - 1]]


def ask(rng: random.Random, tree: Tree) -> Iterator[Answer]:
    """One scene by several laws and restitutions."""
    straight = keeps_its_line(tree)
    met: Met | None = None
    path = None
    for own in variants(rng, tree, 4 if straight else 7):
        contact = own["contact"]
        try:
            answer = answered(Scene(**{name: arguments(own[name], GROUPS) for name in ("first", "second", "contact")}))
        except DynamicsError:
            continue
        mu, e, law = Exact(contact["friction"]), Exact(contact["restitution"]), contact["law"]["word"]
        if met is None:
            levers = [vector(own[name]["arm"]["lever"]) for name in ("first", "second") if "arm" in own[name]]
            met = meet(solid(own["first"]), solid(own["second"]), contact["normal"], next(iter(levers), None))
        if straight:
            end = flat_end(met, mu, e, law) if mu else smooth_end(met, e)
        else:
            with bits(SEARCH.bits):
                path = whole(met.mobility, met.before, mu) if path is None else path
                end = ended(path, met.mobility, mu, met.before, e, law)
        kind, noise = ("line", STRAIGHT) if straight else ("path", CURVED)
        yield Answer(own, stated(answer, flat(answer), results(met, end), slacks(met, end, noise)), kind)


# ---- what is asked ----


def scene(rng: random.Random, first: Tree, second: Tree, normal: list[float], mu: float) -> Tree:
    """A scene whose bodies approach."""
    one, two = solid(first), solid(second)
    u = plus(one.at_contact(one.velocity, one.spin), two.at_contact(two.velocity, two.spin), -1)
    way = 1.0 if dot(u, vector(normal)) > 0 else -1.0
    contact = {
        "record": "SceneContact", "normal": [way * x for x in normal], "friction": mu,
        "restitution": rng.choice((0.0, 1.0, rng.random(), rng.random())), "law": {"word": rng.choice(LAWS)},
    }  # fmt: skip
    return {"first": first, "second": second, "contact": contact}


def bulk(rng: random.Random) -> Tree:
    mass = 10.0 ** rng.choice((rng.uniform(-1.0, 4.0), rng.uniform(-9.0, 9.0)))
    if rng.random() < 0.2:
        return {"record": "ByWeight", "weight": mass}
    return {"record": "ByMass", "mass": mass}


def barrier(velocity: list[float]) -> Tree:
    return {"record": "SceneBody", "bulk": {"record": "Fixed", "fixed": True}, "motion": components(velocity)}


def components(velocity: list[float]) -> Tree:
    return {"record": "ByComponents", "velocity": velocity}


def tiny(rng: random.Random) -> float:
    """Nothing, or what is near the rounding of the inputs, or more."""
    return rng.choice((0.0, 1.0, -1.0)) * 10.0 ** rng.uniform(-18.0, -9.0)


def particles(rng: random.Random) -> Tree:
    """Particles that meet along the normal, nearly so, or anyhow."""
    axis = rng.choice(([1.0, 0.0, 0.0], [0.0, 0.0, -1.0], three(rng, 1.0)))

    def particle() -> Tree:
        along = rng.uniform(-5.0, 5.0)
        aside = rng.choice((0.0, 0.0, 1.0)) * rng.uniform(-5.0, 5.0) + tiny(rng)
        velocity = [along * x + aside * y for x, y in zip(axis, cross(axis, [0.6, 0.8, 0.0]), strict=True)]
        return {"record": "SceneBody", "bulk": bulk(rng), "motion": components(velocity)}

    second = particle() if rng.random() < 0.6 else barrier(rng.choice((STILL, three(rng, 1.0))))
    return scene(rng, particle(), second, axis, rng.choice((0.0, friction(rng))))


def in_the_plane(rng: random.Random) -> Tree:
    """Bodies that move in the plane of x and y, by speed and heading or by components."""

    def vehicle() -> Tree:
        own = bulk(rng)
        mass = own.get("mass", own.get("weight", 0.0) / GRAVITY)
        radius = 10.0 ** rng.uniform(-1.0, 0.5)
        moment = mass * radius * radius
        turning: Tree = rng.choice((
            {"record": "ByRadius", "radius_of_gyration": radius}, {"record": "ByMoment", "moment": moment},
            {"record": "ByTensor", "inertia": [[0.6 * moment, 0.0, 0.0], [0.0, 0.7 * moment, 0.0], [0.0, 0.0, moment]]},
        ))  # fmt: skip
        motion: Tree = components([*three(rng, 20.0)[:2], 0.0])
        if rng.random() < 0.5:
            motion = {"record": "BySpeed", "speed": rng.uniform(0.0, 30.0), "heading": rng.uniform(-3.1, 3.1)}
        lever = [*three(rng, 2.0 * radius)[:2], 0.0]
        spin = {"record": "YawRate", "yaw_rate": rng.choice((0.0, rng.uniform(-3.0, 3.0)))}
        arm = {"record": "LeverInSpace", "lever": lever}
        return {"record": "SceneBody", "bulk": own, "turning": turning, "arm": arm, "motion": motion, "rotation": spin}

    second = vehicle() if rng.random() < 0.6 else barrier(rng.choice((STILL, [*three(rng, 3.0)[:2], 0.0])))
    normal = rng.choice(([1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [*three(rng, 1.0)[:2], 0.0]))
    return scene(rng, vehicle(), second, normal, rng.choice((0.0, friction(rng))))


def in_space(rng: random.Random) -> Tree:
    """Bodies of any kind, often struck almost at their centre or at an axis of theirs."""

    def block() -> Tree:
        own = bulk(rng)
        mass = own.get("mass", own.get("weight", 0.0) / GRAVITY)
        squares = [mass / 12.0 * 10.0 ** rng.uniform(-2.0, 1.0) for _ in range(3)]
        moments = [squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]]
        straight = [[moments[i] if i == j else 0.0 for j in range(3)] for i in range(3)]
        inertia = straight if rng.random() < 0.5 else turned(rng, moments)
        lever = rng.choice((three(rng, 1.0), [tiny(rng), tiny(rng), -rng.uniform(0.1, 1.0)]))
        arm = {"record": "LeverInSpace", "lever": lever}
        rotation = {"record": "SpinVector", "spin": rng.choice((STILL, three(rng, 5.0)))}
        velocity = rng.choice((three(rng, 5.0), [tiny(rng), tiny(rng), rng.uniform(-5.0, 5.0)]))
        turning = {"record": "ByTensor", "inertia": inertia}
        return {
            "record": "SceneBody", "bulk": own, "turning": turning, "arm": arm, "motion": components(velocity),
            "rotation": rotation,
        }  # fmt: skip

    second = block() if rng.random() < 0.4 else barrier(rng.choice((STILL, three(rng, 2.0))))
    normal = rng.choice(([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], three(rng, 1.0)))
    return scene(rng, block(), second, normal, rng.choice((0.0, friction(rng))))


def draw(rng: random.Random) -> Tree:
    """A fresh scene."""
    return rng.choices((particles, in_the_plane, in_space), (10, 11, 2))[0](rng)


def starts() -> list[Tree]:
    """The shipped hard cases of impacts in space, written as scenes."""

    def body(tree: Tree) -> Tree:
        if "mass" not in tree["bulk"]:
            return {**barrier(tree["velocity"]), "rotation": {"record": "SpinVector", "spin": tree["spin"]}}
        return {
            "record": "SceneBody", "bulk": tree["bulk"], "turning": {"record": "ByTensor", "inertia": tree["inertia"]},
            "arm": tree["arm"], "motion": components(tree["velocity"]),
            "rotation": {"record": "SpinVector", "spin": tree["spin"]},
        }  # fmt: skip

    found = []
    for tree in spatial_starts():
        contact = {
            "record": "SceneContact", "normal": tree["normal"], "friction": tree["friction"],
            "restitution": tree["contact"]["restitution"], "law": tree["law"],
        }  # fmt: skip
        found.append({"first": body(tree["first"]), "second": body(tree["second"]), "contact": contact})
    return found


def question() -> Question:
    """`impact solve`."""
    return Question("impact solve", starts(), draw, ask, drawn=0.95)
