"""Writes impact_spatial.json: impacts in space to 40 digits, in the frame of the contact and whole.

Run: python tests/references/generate_impact_spatial_references.py [FILE]. The same bytes every time. The
path is that of impact_keller, by direction and speed of the slip; whole impacts find K by giving the bodies unit
impulses (impact_solids), and energies as differences of kinetic energies.
"""

import math
import random
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from mpmath import mp, mpf
from references.case_files import put
from references.impact_keller import reference
from references.impact_solids import Solid, dot, frame, plus, size, turned_about, vector
from references.impact_spatial_found import FOUND
from references.trees import written

LAWS = ("stronge", "newton", "poisson")
DIGITS = 40
mp.dps = 70


def matrix(generator: random.Random, floor: float = 0.1) -> list[list[float]]:
    """A random symmetric matrix with eigenvalues of at least about `floor`."""
    rows = [[generator.gauss(0.0, 1.0) for _ in range(3)] for _ in range(3)]
    full = [[sum(a * b for a, b in zip(x, y, strict=True)) for y in rows] for x in rows]
    return [[full[min(i, j)][max(i, j)] + (floor if i == j else 0.0) for j in range(3)] for i in range(3)]


def symmetric(a: float, b: float, c: float, d: float, e: float, f: float) -> list[list[float]]:
    return [[a, b, c], [b, d, e], [c, e, f]]


def scenes() -> list[tuple[str, str, str, list[list[float]], list[float], float, float, str]]:
    r = random.Random(1986)
    found = []
    for index in range(12):
        speed = r.choice([0.3, 1.0, 5.0])
        u = [r.gauss(0.0, speed), r.gauss(0.0, speed), -r.uniform(0.2, 3.0)]
        law = LAWS[index % 3]
        found.append(
            (f"random {index}, {law}", "ordinary", "", matrix(r), u, r.uniform(0.05, 0.9), r.uniform(0.0, 1.0), law)
        )
    k = symmetric(3.0, 0.4, -0.9, 2.0, 0.7, 1.5)

    def hard(name: str, why: str, k: list[list[float]], u: list[float], mu: float, e: float, law: str) -> None:
        found.append((f"{name}, {law}", "hard", why, k, u, mu, e, law))

    for law in LAWS:
        hard("slip turns at once near zero", "the slip passes zero at a part of its size and comes out another way",
             k, [0.3, -0.62, -1.0], 0.25, 0.5, law)  # fmt: skip
        hard("slip stops and sticks", "slip approaches zero along the one direction that its rate keeps", k,
             [0.4, 0.3, -1.0], 0.9, 0.6, law)  # fmt: skip
        hard("slip stops and starts anew", "friction cannot hold: the way out is a root of its own",
             symmetric(1.3, -0.5, 0.7, 5.5, -0.1, 1.1), [-0.48, -0.78, -1.0], 0.44, 0.6, law)  # fmt: skip
        hard("jam", "the normal velocity falls at first, so that it is no clock",
             symmetric(26.0, 0.5, -15.0, 3.0, 0.4, 10.0), [-6.0, 0.7, -1.0], 1.5, 0.5, law)  # fmt: skip
        hard(
            "grazing",
            "slip is nine orders above the approach: it hardly turns, and the little it turns moves the end",
            k,
            [12.0, -3.0, -1e-9],
            0.4,
            0.5,
            law,
        )
        hard(
            "hardly any slip",
            "slip is twelve orders below the approach: it stops at once, and stick or the way out is all there is",
            k,
            [1e-12, -2e-12, -1.0],
            0.3,
            0.5,
            law,
        )
    hard(
        "from rest, held",
        "no slip at first: whether it sticks is decided by K alone, with no direction to begin from",
        k,
        [0.0, 0.0, -1.0],
        0.6,
        0.5,
        "stronge",
    )
    hard("from rest, not held",
        "no slip at first, and friction cannot hold: it starts along a direction that is a root of its own",
         symmetric(2.0, 0.1, -1.2, 2.2, 0.3, 1.6), [0.0, 0.0, -1.0], 0.3, 0.5, "stronge")  # fmt: skip
    hard(
        "plastic",
        "plastic: the law's end is that of compression, restitution's work a root of zero",
        k,
        [1.0, 2.0, -1.0],
        0.3,
        0.0,
        "stronge",
    )
    hard(
        "elastic",
        "elastic: no energy may be lost but to friction, and a difference of energies shows rounding as loss",
        k,
        [1.0, 2.0, -1.0],
        0.3,
        1.0,
        "stronge",
    )
    hard("threshold of stick",
        "friction is that which just holds, rounded: "
        "stick, with nothing to spare", symmetric(2.0, 0.0, -1.0, 2.0, 0.0, 2.0),
         [0.3, 0.2, -1.0], 0.5, 0.5, "stronge")  # fmt: skip
    hard("threshold of stick, just below",
        "friction is one rounding short of what holds: reversed slip in place of stick, with a slope next to zero",
         symmetric(2.0, 0.0, -1.0, 2.0, 0.0, 2.0), [0.3, 0.2, -1.0], math.nextafter(0.5, 0.0), 0.5,
         "stronge")  # fmt: skip
    hard("planar in space",
        "the slip keeps its line: the path in space must give the closed form of the plane to the last digit",
         symmetric(2.0, 0.0, -1.0, 3.0, 0.0, 2.0), [0.5, 0.0, -1.0], 0.4, 0.5, "stronge")  # fmt: skip
    hard("long lever",
        "a long lever: K is nearly singular, its columns agree in their "
        "first digits and their differences decide",
         symmetric(2.0001, 1.9, -1.95, 2.0002, -1.95, 2.0003), [0.7, -0.2, -1.0], 0.4, 0.5, "stronge")  # fmt: skip
    return found


def answered(scene: Any) -> dict[str, Any]:
    """An impact in the frame of its contact."""
    name, kind, why, k, u, mu, e, law = scene
    end = reference(k, u, mu, e, law)
    whole = sum(abs(part) for part in end.impulse)
    # what is left of a zero is none
    parts = [part if abs(part) > 1e-44 * whole else 0 for part in end.impulse]
    texts = {f"impulse[{i}]": digits(part) for i, part in enumerate(parts)}
    inputs = {
        "mobility": [[repr(x) for x in row] for row in k], "velocity": [repr(x) for x in u], "friction": repr(mu),
        "restitution": repr(e), "law": {"word": law},
    }  # fmt: skip
    case = {"task": "keller", "kind": kind, "name": name, **({"why": why} if why else {})}
    return {**case, "inputs": inputs, "results": {**texts, "compression": digits(end.compression)}}


def digits(value: Any) -> str:
    with mp.workdps(70):
        return mp.nstr(mpf(str(value)) + 0, DIGITS, strip_zeros=True)


def body(
    mass: float, inertia: list[list[float]], lever: list[float], velocity: list[float], spin: list[float],
    nose: list[float] | None = None,
) -> dict[str, Any]:  # fmt: skip
    tree = {
        "record": "BodyInSpace", "bulk": {"record": "ByMass", "mass": mass}, "inertia": inertia,
        "arm": {"record": "LeverInSpace", "lever": lever}, "velocity": velocity, "spin": spin,
    }  # fmt: skip
    return tree if nose is None else {**tree, "nose": nose}


def fixed(velocity: list[float]) -> dict[str, Any]:
    bulk = {"record": "Fixed", "fixed": True}
    return {"record": "TargetInSpace", "bulk": bulk, "velocity": velocity, "spin": [0.0, 0.0, 0.0]}


def box(mass: float, a: float, b: float, c: float, *turns: float) -> list[list[float]]:
    """A block's tensor in axes turned about x, y and z."""
    rows = [[mass / 12 * part if i == j else 0.0 for j in range(3)] for i, part in enumerate(
        (b * b + c * c, a * a + c * c, a * a + b * b))]  # fmt: skip
    for axis, angle in enumerate(turns):
        rows = turned_about(axis, angle, rows)
    return rows


def whole(first: Any, second: Any, normal: list[float], mu: float, e: float, law: str) -> dict[str, Any]:
    return {
        "first": first, "second": {**second, "record": "TargetInSpace"}, "normal": normal, "friction": mu,
        "contact": {"record": "Restituted", "restitution": e}, "law": {"word": law},
    }  # fmt: skip


def impacts() -> list[tuple[str, str, str, dict[str, Any]]]:
    """Whole impacts: name, kind, why, inputs."""
    r = random.Random(2000)

    def three(reach: float) -> list[float]:
        return [r.uniform(-reach, reach) for _ in range(3)]

    def block(mass: float, speed: float) -> dict[str, Any]:
        tensor = box(mass, r.uniform(0.5, 2.0), r.uniform(0.5, 2.0), r.uniform(1.0, 3.0), *three(3.0))
        return body(mass, tensor, three(1.0), three(speed), three(3.0))

    found = []
    while len(found) < 12:
        one = block(r.uniform(0.5, 2000.0), 5.0)
        two = fixed([0.0, 0.0, 0.0]) if r.random() < 0.4 else block(r.uniform(0.5, 2000.0), 5.0)
        inputs = whole(one, two, three(1.0), r.uniform(0.05, 0.9), r.uniform(0.0, 1.0), LAWS[len(found) % 3])
        if closing(inputs) > 1.0:
            found.append((f"two blocks {len(found)}, {inputs['law']['word']}", "ordinary", "", inputs))
    car = body(
        1500.0, box(1500.0, 4.2, 1.7, 1.4), [1.9, -0.5, -0.1], [14.0, 0.0, 0.0], [0.0, 0.0, 0.2], [1.0, 0.0, 0.0]
    )
    other = body(1200.0, box(1200.0, 3.9, 1.6, 1.4, 0.0, 0.0, 1.3), [-0.7, 0.6, 0.1], [0.0, 9.0, 0.0], [0.0, 0.0, 0.0])
    way = [0.97, 0.2, 0.05]

    def hard(name: str, why: str, first: Any, second: Any, normal: list[float], mu: float, e: float, law: str) -> None:
        found.append((f"{name}, {law}", "hard", why, whole(first, second, normal, mu, e, law)))

    floor, down = fixed([0.0, 0.0, 0.0]), [0.0, 0.0, -1.0]
    for law in LAWS:
        hard(
            "two cars",
            "spin, lean and yaw at once, with noses of their own: nothing vanishes by symmetry",
            car,
            other,
            way,
            0.45,
            0.15,
            law,
        )
        hard("mass ratio 1e12", "a change of velocity taken as a difference would have four digits left",
             body(1.5e15, box(1.5e15, 4.2, 1.7, 1.4), [1.9, -0.5, -0.1], [14.0, 0.0, 0.0], [0.0, 0.0, 0.2]), other, way,
             0.45, 0.15, law)  # fmt: skip
        hard("closing 1e-9 m/s at 300 m/s", "the closing speed is the last bits of the velocities",
             body(1000.0, box(1000.0, 4.0, 2.0, 1.0), [1.0, 0.25, 0.1], [300.0, 1.0, 0.5], [0.0, 0.0, 0.0]),
             body(900.0, box(900.0, 4.0, 2.0, 1.0), [-1.0, 0.5, 0.2], [299.999999999, 1.1, 0.0], [0.0, 0.0, 0.0]),
             [1.0, 0.0, 0.0], 0.5, 0.3, law)  # fmt: skip
        hard("needle", "one moment of inertia is a millionth of the others: K is nearly singular",
             body(0.2, box(0.2, 1e-3, 1e-3, 1.0, 0.6, 0.3), [0.1, -0.2, -0.4], [1.0, 0.5, -3.0], [0.0, 2.0, 0.0]),
             floor, down, 0.3, 0.6, law)  # fmt: skip
        hard("spinning top", "all speed at the contact is of the spin, beside which the approach is small",
             body(0.05, box(0.05, 0.04, 0.04, 0.02), [0.015, 0.01, -0.02], [0.0, 0.0, -0.05], [0.3, -0.2, 2000.0]),
             floor, down, 0.2, 0.7, law)  # fmt: skip
    ball = body(2.7e-3, [[7.2e-7 if i == j else 0.0 for j in range(3)] for i in range(3)], [0.0, 0.0, -0.02],
                [4.0, 1.0, -3.0], [30.0, -200.0, 80.0])  # fmt: skip
    for law in ("stronge", "poisson"):
        hard("ball on a table", "nothing couples: sliding straight to rolling, friction holds at any coefficient", ball,
             floor, down, 0.25, 0.9, law)  # fmt: skip
    hard(
        "elastic",
        "elastic: no energy may be lost but to friction, and a difference of energies shows rounding as loss",
        car,
        other,
        way,
        0.45,
        1.0,
        "stronge",
    )
    hard(
        "plastic",
        "plastic: the law's end is that of compression, restitution's work a root of zero",
        car,
        other,
        way,
        0.45,
        0.0,
        "stronge",
    )
    hard("smooth", "no friction: the tangential impulse and its losses are zero, not small", car, other, way, 0.0, 0.5,
         "stronge")  # fmt: skip
    hard(
        "rough",
        "friction of eight: slip stops almost at once and must stay stopped for the rest, whatever rounding says",
        car,
        other,
        way,
        8.0,
        0.2,
        "stronge",
    )
    hard("moving wall",
        "a wall that comes to meet the body works on "
        "it: the loss must count that work", car, fixed([-30.0, 2.0, 1.0]), way, 0.4,
         0.3, "stronge")  # fmt: skip
    hard("grazing", "slip is six orders above the approach: the closing speed is in its seventh digit",
         body(1.0, box(1.0, 0.5, 0.4, 0.3, 0.2, 0.1), [0.1, 0.05, -0.2], [20.0, 3.0, -2e-5], [0.0, 0.0, 0.0]), floor,
         down, 0.3, 0.5, "stronge")  # fmt: skip
    hard("stub on its end", "friction drives the bodies together: the normal velocity falls at first",
         body(1.0, box(1.0, 0.02, 0.02, 1.0, 0.0, 0.55), [0.26, 0.0, -0.43], [-9.0, 0.3, -1.0], [0.0, 0.0, 0.0]), floor,
         down, 1.6, 0.5, "stronge")  # fmt: skip
    flail = body(
        0.0006146917769218427,
        [[0.0004871405047799685, 6.948168893414773e-05, -0.00028885748958798387],
         [6.948168893414773e-05, 0.00064171187606327, 0.00011077893362746648],
         [-0.00028885748958798387, 0.00011077893362746648, 0.00020787623438409036]],
        [-12.371950112854822, -30.460399541267037, 14.138157440101448],
        [-0.07856712535423602, 0.12411379690576496, -0.13836921826005932],
        [-0.5339199115171047, -0.1369507134723652, 0.09441821570737452],
    )  # fmt: skip
    for law in ("stronge", "poisson"):
        hard("flail", "found by search: on a lever of thirty gyration radii it jams in restitution and presses again",
             flail, fixed([-0.8886385730275457, 0.4035479035734726, 0.5524870147256022]), [0.0, 1.0, 0.0],
             1.2958933420630503, 1.0, law)  # fmt: skip
    found += [(f"{name}, {inputs['law']['word']}", "hard", why, inputs) for name, why, inputs in FOUND]
    return found


def closing(inputs: dict[str, Any]) -> Any:
    """Speed of approach."""
    one, two = Solid(inputs["first"]), Solid(inputs["second"])
    inward = frame(tuple(-x for x in vector(inputs["normal"])))[2]
    return -dot(plus(one.at_contact(one.v, one.w), two.at_contact(two.v, two.w), -1), inward)


def results(inputs: dict[str, Any]) -> dict[str, Any]:
    """Everything that a whole impact reports."""
    mp.dps = 70
    one, two = Solid(inputs["first"]), Solid(inputs["second"])
    axes = frame(tuple(-x for x in vector(inputs["normal"])))
    u = plus(one.at_contact(one.v, one.w), two.at_contact(two.v, two.w), -1)
    moved = [plus(one.answer(axis), two.answer(tuple(-x for x in axis)), -1) for axis in axes]
    k = [[dot(change, axis) for axis in axes] for change in moved]
    before = [dot(u, axis) for axis in axes]
    end = reference(
        [[mp.nstr(x, 60) for x in row] for row in k], [mp.nstr(x, 60) for x in before], inputs["friction"],
        inputs["contact"]["restitution"], inputs["law"]["word"],
    )  # fmt: skip
    parts = [mpf(str(part)) for part in end.impulse]
    impulse = tuple(sum(part * axis[i] for part, axis in zip(parts, axes, strict=True)) for i in range(3))
    back = tuple(-x for x in impulse)
    after = plus(one.at_contact(*one.struck(impulse)), two.at_contact(*two.struck(back)), -1)
    found = {**one.after("first", impulse), **two.after("second", back)}
    lost = -found["first.energy_change"] - found["second.energy_change"]
    heat, n = mpf(str(end.heat)), axes[2]
    det = k[0][0] * k[1][1] - k[0][1] * k[1][0]
    hold = (k[0][1] * k[1][2] - k[1][1] * k[0][2]) / det, (k[0][1] * k[0][2] - k[0][0] * k[1][2]) / det
    vectors = {
        "impulse": back,
        "sliding_before": plus(u, n, -dot(u, n)),
        "sliding_after": plus(after, n, -dot(after, n)),
    }
    sideways = mp.sqrt(parts[0] ** 2 + parts[1] ** 2)
    found |= {
        "impulse_magnitude": size(impulse), "normal_impulse": parts[2], "tangential_impulse": sideways,
        "impulse_ratio": sideways / parts[2], "stick_friction": mp.sqrt(hold[0] ** 2 + hold[1] ** 2),
        "compression_impulse": mpf(str(end.compression)), "slip_impulse": mpf(str(end.slip)),
        "closing_speed": -before[2], "separation_speed": dot(after, n),
        "energy_lost": lost, "energy_lost_normal": lost - heat, "energy_lost_tangential": heat,
    }  # fmt: skip
    for key, value in vectors.items():
        found |= {f"{key}[{i}]": part for i, part in enumerate(value)}
    # the path is right to 44 digits of the impulse: what is left of zeros is smaller than this
    nothing = {"sliding_after": size(u), "separation_speed": size(u), "energy_lost_normal": abs(lost) + heat}
    return {
        name: mpf(0) if abs(value) < mpf(10) ** -40 * nothing.get(name.partition("[")[0], 0) else value
        for name, value in found.items()
    }


def reported(impact: Any) -> dict[str, Any]:
    """A whole impact."""
    name, kind, why, inputs = impact
    case = {"task": "spatial", "kind": kind, "name": name, **({"why": why} if why else {})}
    return {
        **case,
        "inputs": written(inputs),
        "results": {key: digits(value) for key, value in results(inputs).items()},
    }


def main() -> None:
    cases = [answered(scene) for scene in scenes()] + [reported(impact) for impact in impacts()]
    about = "Written by generate_impact_spatial_references.py: SI inputs as doubles, results to 40 digits from 63."
    put("impact_spatial", about, cases)


if __name__ == "__main__":
    main()
