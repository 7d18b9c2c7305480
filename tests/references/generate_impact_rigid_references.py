"""Writes impact_rigid.json: planar impacts by five laws to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_impact_rigid_references.py [FILE]. The same bytes every time. The contact's
matrix is found by giving each body unit impulses, the path is followed event by event (impact_events), the ratio laws
solve their linear equations, and energies are differences of kinetic energies, all in 120 digits. Contacts without
bodies (impact_contacts) follow.
"""

import math
import random
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from mpmath import atan2, cos, mp, mpf, nint, pi, sin, sqrt
from references.case_files import put
from references.impact_contacts import cases as contacts
from references.impact_events import brach, follow, kudlich_slibar
from references.trees import draw, written

mp.dps = 120
G = 9.80665
LAWS = ("stronge", "newton", "poisson", "brach", "kudlich-slibar")
Case = tuple[str, str, dict[str, Any]]


class Body:
    """A body in many digits."""

    def __init__(self, tree: dict[str, Any]) -> None:
        bulk = tree["bulk"]
        self.mass = None if bulk["record"] == "Fixed" else mpf(bulk["mass"])
        self.inertia = None
        self.r = mpf(0), mpf(0)
        if self.mass is not None:
            turning = tree["turning"]
            self.inertia = (
                mpf(turning["inertia"])
                if turning["record"] == "ByInertia"
                else self.mass * mpf(turning["radius_of_gyration"]) ** 2
            )
            self.r = tuple(map(mpf, tree["arm"]["lever"]))
        self.v = tuple(map(mpf, tree["motion"]["velocity"]))
        self.w = mpf(tree["spin"])
        nose = tree.get("nose")
        if nose is not None:
            self.nose = cos(mpf(nose)), sin(mpf(nose))
        elif any(self.v):
            size = sqrt(self.v[0] ** 2 + self.v[1] ** 2)
            self.nose = self.v[0] / size, self.v[1] / size
        else:
            self.nose = mpf(1), mpf(0)

    def at_contact(self, v: Any, w: Any) -> Any:
        return v[0] - w * self.r[1], v[1] + w * self.r[0]

    def struck(self, j: Any) -> Any:
        """Velocity and spin after an impulse at the lever."""
        if self.mass is None:
            return self.v, self.w
        moment = self.r[0] * j[1] - self.r[1] * j[0]
        return (self.v[0] + j[0] / self.mass, self.v[1] + j[1] / self.mass), self.w + moment / self.inertia

    def answers(self, j: Any) -> Any:
        """Change of velocity at the contact."""
        v, w = self.struck(j)
        before, after = self.at_contact(self.v, self.w), self.at_contact(v, w)
        return after[0] - before[0], after[1] - before[1]


def results(inputs: dict[str, Any]) -> dict[str, Any]:
    one, two = Body(inputs["first"]), Body(inputs["second"])
    angle, mu, e = mpf(inputs["normal"]), mpf(inputs["friction"]), mpf(inputs["contact"]["restitution"])
    law = inputs["law"]["word"]
    n = -cos(angle), -sin(angle)
    t = -n[1], n[0]
    a, b = one.at_contact(one.v, one.w), two.at_contact(two.v, two.w)
    u = a[0] - b[0], a[1] - b[1]
    ut, un = u[0] * t[0] + u[1] * t[1], u[0] * n[0] + u[1] * n[1]
    if "closing_speed" in inputs:
        un = -mpf(inputs["closing_speed"])
    columns = []
    for axis in (t, n):
        first = one.answers(axis)
        second = two.answers((-axis[0], -axis[1]))
        moved = first[0] - second[0], first[1] - second[1]
        columns.append((moved[0] * t[0] + moved[1] * t[1], moved[0] * n[0] + moved[1] * n[1]))
    (kt, kx), (_, kn) = columns
    found: dict[str, Any] = {}
    if law in ("stronge", "newton", "poisson"):
        end = follow(kt, kx, kn, ut, un, mu, e, law)
        pt, pn = end["tangential"], end["normal"]
        found["compression_impulse"], found["slip_impulse"] = end["compression"], end["slip_impulse"]
    else:
        pt, pn = (brach if law == "brach" else kudlich_slibar)(kt, kx, kn, ut, un, mu, e)
        if law == "kudlich-slibar":
            found["compression_impulse"] = pn / (1 + e)
    after_t, after_n = ut + kt * pt + kx * pn, un + kx * pt + kn * pn
    if abs(after_t) < mpf(10) ** -80 * (abs(ut) + abs(kx * pn)):
        after_t = mpf(0)
    on_first = pn * n[0] + pt * t[0], pn * n[1] + pt * t[1]
    back = -on_first[0], -on_first[1]
    energy = mpf(0)
    for name, body, j in (("first", one, on_first), ("second", two, back)):
        energy += after(found, name, body, j)
    critical_t, critical_n = kx * (1 + e) * un - kn * ut, kx * ut - kt * (1 + e) * un
    work_n, work_t = -pn * (un + after_n) / 2, -pt * (ut + after_t) / 2
    if law in ("stronge", "newton", "poisson"):
        work_n, work_t = end["compression_work"] - end["restitution_work"], end["friction_work"]
    found |= {
        "impulse[0]": back[0],
        "impulse[1]": back[1],
        "impulse_magnitude": sqrt(pn**2 + pt**2),
        "normal_impulse": pn,
        "tangential_impulse": pt,
        "impulse_direction": atan2(back[1], back[0]),
        "impulse_ratio": pt / pn,
        "closing_speed": -un,
        "separation_speed": after_n,
        "sliding_before": -ut,
        "sliding_after": -after_t,
        "energy_lost": work_n + work_t,
        "energy_lost_normal": work_n,
        "energy_lost_tangential": work_t,
        "critical.stick_friction": abs(kx) / kt,
    }
    if two.mass is None:
        found["equivalent_barrier_speed"] = sqrt(2 * max(work_n + work_t, mpf(0)) / one.mass)
    if critical_n != 0:
        found["critical.impulse_ratio"] = critical_t / critical_n
        if critical_t != 0:
            found["critical.share"] = mu * abs(critical_n / critical_t)
    return found


def after(found: dict[str, Any], name: str, body: Body, j: Any) -> Any:
    """What one body reports; its change of kinetic energy."""
    v, w = body.struck(j)
    found |= {
        f"{name}.velocity[0]": v[0],
        f"{name}.velocity[1]": v[1],
        f"{name}.speed": sqrt(v[0] ** 2 + v[1] ** 2),
        f"{name}.heading": atan2(v[1], v[0]),
        f"{name}.spin": w,
        f"{name}.spin_change": w - body.w if body.mass is not None else mpf(0),
    }
    if body.mass is None:
        found[f"{name}.energy_change"] = j[0] * body.v[0] + j[1] * body.v[1]
        return found[f"{name}.energy_change"]
    x, y = j[0] / body.mass, j[1] / body.mass
    along, across = body.nose[0], body.nose[1]
    angle = atan2(-x * across + y * along, -x * along - y * across)
    hours = int(nint(angle * 6 / pi))
    found |= {
        f"{name}.delta_v.vector[0]": x,
        f"{name}.delta_v.vector[1]": y,
        f"{name}.delta_v.magnitude": sqrt(x**2 + y**2),
        f"{name}.delta_v.longitudinal": x * along + y * across,
        f"{name}.delta_v.lateral": y * along - x * across,
        f"{name}.delta_v.pdof": angle,
        f"{name}.delta_v.clock": mpf(hours + 12 if hours <= 0 else hours),
    }
    change = body.mass * (x * (2 * body.v[0] + x) + y * (2 * body.v[1] + y)) / 2
    change += body.inertia * (w - body.w) * (w + body.w) / 2
    found[f"{name}.energy_change"] = change
    return change


def body(mass: float, inertia: float, lever: tuple[float, float], velocity: tuple[float, float], spin: float = 0.0,
         nose: float | None = None) -> dict[str, Any]:  # fmt: skip
    tree: dict[str, Any] = {
        "bulk": {"record": "ByMass", "mass": mass},
        "turning": {"record": "ByInertia", "inertia": inertia},
        "arm": {"record": "Lever", "lever": list(lever)},
        "motion": {"record": "ByVelocity", "velocity": list(velocity)},
        "spin": spin,
    }
    return tree if nose is None else {**tree, "nose": nose}


def fixed(velocity: tuple[float, float] = (0.0, 0.0)) -> dict[str, Any]:
    return {
        "bulk": {"record": "Fixed", "fixed": True},
        "motion": {"record": "ByVelocity", "velocity": list(velocity)},
        "spin": 0.0,
    }


def scene(first: Any, second: Any, normal: float, mu: float, e: float, law: str, **more: float) -> dict[str, Any]:
    return {
        "first": {"record": "RigidBody", **first},
        "second": {"record": "RigidTarget", **second},
        "normal": normal,
        "friction": mu,
        "contact": {"record": "Restituted", "restitution": e},
        "law": {"word": law},
        **more,
    }


def ordinary(generator: random.Random, law: str) -> Case:
    """Two cars, or a rod on a plane."""
    r = generator
    mu, e = draw(r, 0.1, 0.9), draw(r, 0.0, 0.5)
    if r.random() < 0.6:
        m1, m2 = draw(r, 800.0, 3000.0), draw(r, 800.0, 3000.0)
        first = body(m1, m1 * draw(r, 1.0, 2.2), (draw(r, 1.0, 2.3), draw(r, -0.9, 0.9)),
                     (draw(r, 5.0, 25.0), draw(r, -5.0, 5.0)), draw(r, -1.0, 1.0), draw(r, -0.5, 0.5))  # fmt: skip
        second = body(m2, m2 * draw(r, 1.0, 2.2), (draw(r, -2.3, -0.5), draw(r, -0.9, 0.9)),
                      (draw(r, -10.0, 2.0), draw(r, -10.0, 10.0)), draw(r, -1.0, 1.0))  # fmt: skip
        return "two cars", "", scene(first, second, draw(r, -0.6, 0.6), mu, e, law)
    lean = r.uniform(0.2, 1.4)
    first = body(1.0, 1.0 / 12.0, (0.5 * math.cos(lean), -0.5 * math.sin(lean)),
                 (draw(r, -3.0, 3.0), draw(r, -5.0, -1.0)), draw(r, -1.0, 1.0))  # fmt: skip
    return "rod on a plane", "", scene(first, fixed(), -0.5 * math.pi, mu, draw(r, 0.1, 0.9), law)


def hard() -> list[Case]:
    """Each with a sentence on why it is hard."""
    car = body(1500.0, 2500.0, (2.0, -0.4), (15.0, 0.0), 0.0, 0.0)
    other = body(1200.0, 1800.0, (-0.8, 0.5), (0.0, 10.0))
    cases: list[Case] = []

    def add(name: str, why: str, inputs: dict[str, Any]) -> None:
        cases.append((f"{name}, {inputs['law']['word']}", why, inputs))

    for law in LAWS:
        add("mass ratio 1e20", "a change of velocity taken as a difference would lose every digit",
            scene(car, body(1.5e23, 2.5e23, (-2.0, 0.3), (0.0, 3.0)), 0.1, 0.5, 0.2, law))  # fmt: skip
        add("mass ratio 1e-20", "the heavy body's change of velocity is below the spacing of its velocity",
            scene(body(1.5e23, 2.5e23, (2.0, 0.3), (4.0, 3.0)), other, 0.1, 0.5, 0.2, law))  # fmt: skip
        add("closing 1e-12 m/s at 300 m/s", "the closing speed is the last bits of the velocities",
            scene(body(1000.0, 1500.0, (1.0, 0.25), (300.0, 1.0)), body(900.0, 1200.0, (-1.0, 0.5),
                  (299.99999999999898, 1.0)), 0.0, 0.5, 0.3, law))  # fmt: skip
        add("grazing",
            "slip is ten orders above the approach: the normal impulse is decided by what is lost beside it",
            scene(body(1.0, 0.1, (0.25, -0.5), (20.0, -1e-9)), fixed(), -0.5 * math.pi, 0.3, 0.5, law,
                  closing_speed=1e-9))  # fmt: skip
        add("no coupling", "k_x is zero: stick needs no friction and slip changes nothing across",
            scene(body(1.0, 0.5, (1.0, 0.0), (3.0, 2.0)), fixed(), 0.0, 0.25, 0.5, law))  # fmt: skip
        add("coupling 1e-17", "k_x is lost beside k_t, but its sign decides the way of reversed slip",
            scene(body(1.0, 0.5, (1.0, 1e-17), (3.0, 0.001)), fixed(), 0.0, 0.25, 0.5, law))  # fmt: skip
        add("one body fixed and moving",
            "a barrier that moves does work: the other body's energy is not "
            "conserved, and nothing divides by its mass",
            scene(body(1.0, 0.5, (1.0, 0.25), (3.0, 2.0), 1.0), fixed((-2.0, 0.5)), 0.0, 0.3, 0.5, law))  # fmt: skip
        add("no restitution", "the work to be given back is zero, and so is the argument of its root",
            scene(car, other, 0.17, 0.3, 0.0, law))  # fmt: skip
        add("friction without bound",
            "friction without bound: slip stops at an impulse that all but vanishes, and then must stay stopped",
            scene(car, other, 0.17, 1e6, 0.1, law))  # fmt: skip
        add("a grain and a planet",
            "inertias from 1e-12 to 1e24 in one matrix: the planet's terms are "
            "lost in sums with the grain's, and rule its motion",
            scene(body(1e-9, 1e-19, (1e-5, 2e-6), (3.0, 1.0)), body(6e24, 1e38, (-6.4e6, 0.0), (0.0, 0.0)), 0.0, 0.5,
                  0.8, law))  # fmt: skip
    for law in LAWS[:3]:
        # lever (1, 1), m = J = 1: k_t = 2, k_x = -1, so the threshold is 0.5, every number exact
        for side, words in ((math.nextafter(0.5, 0.0), "just slips"), (0.5, "just sticks"),
                            (math.nextafter(0.5, 1.0), "sticks")):  # fmt: skip
            add(f"threshold of stick: {words}", "friction is |k_x|/k_t to the last bit: stick or reversed slip",
                scene(body(1.0, 1.0, (1.0, 1.0), (2.0, -0.25)), fixed(), 0.0, side, 0.6, law))  # fmt: skip
        # k_n = 1, k_t = 1.5, k_x = 0: slip of 0.375 m/s stops after 1 N·s, when a closing speed of 1 m/s is gone too
        for shift in (-1e-15, 0.0, 1e-15):
            add(
                f"slip stops as compression ends {shift:+.0e}",
                "slip stops as compression ends: two events in one, and which comes first is a last place",
                scene(body(1.0, 0.5, (0.5, 0.0), (1.0, 0.375 * (1.0 + shift)), 0.0), fixed(), 0.0, 0.25, 0.5, law),
            )
        add("slip at rest", "there is no first slip: stick or the way out is decided by K alone",
            scene(body(1.0, 0.5, (0.75, 0.5), (2.0, 0.0), 0.0), fixed(), 0.0, 0.2, 0.5, law,
                  ))  # fmt: skip
        add("jam", "friction drives the bodies together: u_n falls while the first slip lasts",
            scene(body(1.0, 0.01, (0.3, -0.5), (6.0, -1.0)), fixed(), -0.5 * math.pi, 1.5, 0.5, law))  # fmt: skip
        add("long lever", "K is nearly singular: k_t k_n exceeds k_x² by one part in 1e8",
            scene(body(1.0, 1e-4, (0.5, 0.5), (3.0, 1.0), 0.5), fixed(), 0.0, 0.4, 0.5, law))  # fmt: skip
        add("hardly any slip",
            "the first slip is sixteen orders below the approach: its impulse is one rounding of the whole",
            scene(body(1.0, 0.5, (0.75, 0.5), (2.0, -1e-16)), fixed(), 0.0, 0.3, 0.5, law))  # fmt: skip
    for law in ("stronge", "poisson"):
        add(
            "elastic",
            "elastic: no energy may be lost but to friction, and a difference of energies shows rounding as loss",
            scene(car, other, 0.17, 0.3, 1.0, law),
        )
    add(
        "frictionless and elastic",
        "frictionless and elastic: nothing may be lost at all, whatever the rounding of energies",
        scene(car, other, 0.17, 0.0, 1.0, "stronge"),
    )
    return cases


def all_cases() -> list[dict[str, Any]]:
    generator = random.Random(20020901)
    drawn = [(LAWS[i % 5], ordinary(generator, LAWS[i % 5])) for i in range(60)]
    found = []
    for index, (law, (name, why, inputs)) in enumerate(drawn):
        found.append(("ordinary", f"{name} {index}, {law}", why, inputs))
    found += [("hard", name, why, inputs) for name, why, inputs in hard()]
    made = []
    for kind, name, why, inputs in found:
        answer = results(inputs)
        if answer["closing_speed"] <= 0 or answer["energy_lost"] < -(mpf(10) ** -60) or answer["normal_impulse"] <= 0:
            assert kind == "ordinary" or inputs["law"]["word"] not in ("stronge", "poisson"), name
            continue
        case = {"task": "planar", "kind": kind, "name": name}
        if why:
            case["why"] = why
        texts = {key: mp.nstr(value + 0, 40, strip_zeros=True) for key, value in answer.items()}
        made.append({**case, "inputs": written(inputs), "results": texts})
    return made


def main() -> None:
    about = "Written by generate_impact_rigid_references.py: SI inputs as doubles, results to 40 digits from 120."
    put("impact_rigid", about, [*all_cases(), *contacts()])


if __name__ == "__main__":
    main()
