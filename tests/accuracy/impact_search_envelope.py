"""`impact envelope`: every point of a small grid of restitution and friction by its own planar impact in 480 bits.

An answer of 1 to 9 points is one evaluation: its least and greatest changes of velocity, of spin and energies against
the extremes of the points, each followed from event to event (`impact_events`).
"""

import json
import random
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from climbing import Answer, Question, Tree, arguments, bits, read, stated
from impact_search_space import GROUPS
from precise import FUNCTIONS, Exact
from references.impact_events import brach, follow, kudlich_slibar

from dynamics_cli.accuracy.cases import DATA, flat
from dynamics_cli.impact.planar.envelope import envelope
from dynamics_cli.impact.planar.laws import LAWS

sqrt, sin, cos = (FUNCTIONS[name] for name in ("sqrt", "sin", "cos"))
Number = Any
# Points along each side of the grid, at most.
MOST = 3
# A law other than Stronge's answers at a point unless it gains more than this share of the work, as the program says.
GAIN = 1e-12
NOISE = 160
# Of the exact side: a very long lever costs the impulse a hundred bits and more.
BITS = 480


class Contact(NamedTuple):
    """K and the relative velocity in the frame of the contact; the normal points at body 1."""

    tangential: Number
    coupling: Number
    normal: Number
    slip: Number
    approach: Number


def planar(contact: Contact, mu: Number, e: Number, law: str) -> tuple[Number, Number]:
    """Normal and tangential impulse of an impact by any of the laws."""
    if law in ("brach", "kudlich-slibar"):
        along, across = (brach if law == "brach" else kudlich_slibar)(*contact, mu, e)
        return across, along
    end = follow(*contact, mu, e, law)
    return end["normal"], end["tangential"]


class Solid:
    """A body of an input tree in many bits; without mass it is fixed."""

    def __init__(self, tree: Tree) -> None:
        self.mass = Exact(tree["bulk"]["mass"]) if "mass" in tree["bulk"] else None
        self.lever = (Exact(0), Exact(0))
        if self.mass is not None:
            turning = tree["turning"]
            gyration = "radius_of_gyration" in turning
            radius = Exact(turning["radius_of_gyration" if gyration else "inertia"])
            self.inertia = self.mass * radius * radius if gyration else radius
            self.lever = tuple(map(Exact, tree["arm"]["lever"]))
        self.velocity = tuple(map(Exact, tree["motion"]["velocity"]))
        self.spin = Exact(tree["spin"])

    def at_contact(self, velocity: Any, spin: Number) -> Any:
        return velocity[0] - spin * self.lever[1], velocity[1] + spin * self.lever[0]

    def turned(self, push: Any) -> Number:
        """Change of spin by an impulse at the contact."""
        return (self.lever[0] * push[1] - self.lever[1] * push[0]) / self.inertia

    def answer(self, push: Any) -> Any:
        """Change of velocity at the contact."""
        if self.mass is None:
            return Exact(0), Exact(0)
        return self.at_contact((push[0] / self.mass, push[1] / self.mass), self.turned(push))


def contact_of(tree: Tree) -> tuple[Contact, Any, Any]:
    """The contact, and its tangent and normal, which points at the first body."""
    one, two = Solid(tree["first"]), Solid(tree["second"])
    angle = Exact(tree["normal"])
    normal = -cos(angle), -sin(angle)
    tangent = -normal[1], normal[0]
    a, b = one.at_contact(one.velocity, one.spin), two.at_contact(two.velocity, two.spin)
    u = a[0] - b[0], a[1] - b[1]
    moved = [[p + q for p, q in zip(one.answer(axis), two.answer(axis), strict=True)] for axis in (tangent, normal)]

    def along(v: Any, axis: Any) -> Number:
        return v[0] * axis[0] + v[1] * axis[1]

    approach = -Exact(tree["closing_speed"]) if "closing_speed" in tree else along(u, normal)
    k = along(moved[0], tangent), along(moved[0], normal), along(moved[1], normal)
    return Contact(*k, along(u, tangent), approach), tangent, normal


def lost(contact: Contact, end: tuple[Number, Number]) -> Number:
    """Energy lost."""
    kt, kx, kn, ut, un = contact
    pn, pt = end
    return -pn * (2 * un + kn * pn + kx * pt) / 2 - pt * (2 * ut + kt * pt + kx * pn) / 2


def exact(tree: Tree, places: list[tuple[float, float]]) -> dict[str, Number] | None:
    """The extremes over the points; nothing where one of them is at the edge of having no answer."""
    contact, tangent, normal = contact_of(tree)
    one, two = Solid(tree["first"]), Solid(tree["second"])
    law = tree["law"]["word"]
    found: dict[str, list[Number]] = {}
    work = Exact(0)
    for mu, e in places:
        end = planar(contact, Exact(mu), Exact(e), law)
        energy = lost(contact, end)
        across, along = end
        scale = abs(across * contact.approach) + abs(along * contact.slip)
        work = max(work, scale)
        # refused, or nearly so: which of the points count is then told by rounding
        if not across > 0 or (law != "stronge" and not energy > -0.5 * GAIN * scale):
            return None
        push = tuple(across * n + along * t for n, t in zip(normal, tangent, strict=True))
        size = sqrt(across * across + along * along)
        found.setdefault("energy_lost", []).append(energy)
        for name, body, way in (("first", one, 1), ("second", two, -1)):
            if body.mass is not None:
                found.setdefault(f"{name}_delta_v", []).append(size / body.mass)
                found.setdefault(f"{name}_spin_change", []).append(way * body.turned(push))
    out = {
        "work": work,
        "least_energy_lost": min(found["energy_lost"]),
        "greatest_energy_lost": max(found.pop("energy_lost")),
    }
    for name, values in found.items():
        out |= {f"{name}.least": min(values), f"{name}.greatest": max(values)}
    return out


def ask(_: random.Random, tree: Tree) -> Iterator[Answer]:
    """One region."""
    given = arguments(tree, GROUPS)
    answer = envelope(**given)
    e, mu = (
        np.linspace(tree[f"least_{name}"], tree[f"greatest_{name}"], tree[f"{name}_points"]).tolist()
        for name in ("restitution", "friction")
    )
    with bits(BITS):
        wanted = exact(tree, [(m, r) for m in mu for r in e])
    if wanted is None or answer.refused:
        return
    # a law may lose nothing at all, but for the last bits of the exact side
    noise = wanted.pop("work") * Exact(2) ** -NOISE
    found = stated(answer, flat(answer), wanted, lambda name: noise if "energy" in name else Exact(0))
    yield Answer(tree, found, tree["law"]["word"])


# ---- what is asked ----


def region(rng: random.Random, scene: Tree, law: str, e: float | None = None, mu: float | None = None) -> Tree:
    """A region of points about the restitution and friction of a planar impact, or any."""
    tree = {name: part for name, part in scene.items() if name not in ("friction", "contact", "law")}
    tree |= {"law": {"word": law}, "map_points": 2}
    for name, known, most in (("restitution", e, 1.0), ("friction", mu, 1.5)):
        low, high = sorted((rng.uniform(0.0, most), rng.uniform(0.0, most)))
        if rng.random() < 0.3:
            low, high = (0.0, most) if rng.random() < 0.5 else (low, low)
        low = low if known is None else known
        points = 1 if low == high else rng.randrange(2, MOST + 1)
        tree |= {f"least_{name}": low, f"greatest_{name}": max(low, high), f"{name}_points": points}
        if low >= high:
            tree |= {f"greatest_{name}": low, f"{name}_points": 1}
    return tree


def draw(rng: random.Random) -> Tree:
    """Two bodies in a plane, or one and a barrier."""

    def pair(reach: float) -> list[float]:
        return [rng.uniform(-reach, reach), rng.uniform(-reach, reach)]

    def body() -> Tree:
        mass = 10.0 ** rng.choice((rng.uniform(-1.0, 4.0), rng.uniform(-9.0, 9.0)))
        radius = 10.0 ** rng.uniform(-1.5, 0.5)
        turning = {"record": "ByGyration", "radius_of_gyration": radius}
        if rng.random() < 0.5:
            turning = {"record": "ByInertia", "inertia": mass * radius * radius}
        slow = 10.0 ** rng.choice((0.0, 0.0, rng.uniform(-12.0, 0.0)))
        return {
            "record": "RigidBody", "bulk": {"record": "ByMass", "mass": mass}, "turning": turning,
            "arm": {"record": "Lever", "lever": pair(rng.choice((radius, 2.0)))},
            "motion": {"record": "ByVelocity", "velocity": [slow * x for x in pair(20.0)]},
            "spin": rng.choice((0.0, rng.uniform(-5.0, 5.0))),
        }  # fmt: skip

    second: Tree = {**body(), "record": "RigidTarget"}
    if rng.random() < 0.4:
        still = {"record": "ByVelocity", "velocity": rng.choice(([0.0, 0.0], pair(3.0)))}
        second = {"record": "RigidTarget", "bulk": {"record": "Fixed", "fixed": True}, "motion": still, "spin": 0.0}
    scene = {"first": body(), "second": second, "normal": rng.choice((0.0, rng.uniform(-3.1, 3.1)))}
    made = region(rng, scene, rng.choice(LAWS))
    approach = contact_of(made)[0].approach
    return made if approach < 0 else {**made, "normal": made["normal"] + (3.0 if made["normal"] < 0.0 else -3.0)}


def starts() -> list[Tree]:
    """Regions that begin at the shipped hard cases of planar impacts."""
    rng = random.Random(1877)
    found = []
    for case in json.loads((DATA / "impact_rigid.json").read_text(encoding="utf-8"))["cases"]:
        if case["task"] != "planar" or case["kind"] != "hard":
            continue
        tree = read(case["inputs"])
        for name in ("first", "second"):
            if tree[name]["bulk"]["record"] == "Fixed":
                tree[name]["bulk"]["fixed"] = True
            tree[name].pop("nose", None)
        e, mu = tree["contact"]["restitution"], tree["friction"]
        found.append(region(rng, tree, tree["law"]["word"], e, mu))
    return found


def question() -> Question:
    """`impact envelope`."""
    return Question("impact envelope", starts(), draw, ask)
