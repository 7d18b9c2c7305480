"""Writes force_systems.json: resultants, reactions, springs, weights, friction, wedges and screws to 40 digits.

Moments are added about a far point and brought back, axes and reactions come from linear equations, springs from their
ends' distance, limits of pushes from moments about the block's edges. Where the program takes numbers as typed,
as of all points and loads, so does this, from their decimals; elsewhere as doubles.
Run: python tests/references/generate_force_systems_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator, Sequence
from typing import Any

from case_files import Case, write
from mpmath import atan, cos, lu_solve, matrix, mp, mpf, sin, sqrt, tan

mp.dps = 90
ABOUT = (
    "Written by generate_force_systems_references.py: inputs as typed or as doubles, results to 40 digits from "
    "90-digit arithmetic."
)
RANDOM = random.Random(1687)
FAR = (mpf(17), mpf(-31), mpf("2.5"))
GRAVITY = mpf(9.80665)
Vector = tuple[Any, Any, Any]


def exact(text: str) -> Any:
    return mpf(float(text))


def drawn(low: float, high: float, digits: int = 3) -> str:
    return repr(round(RANDOM.uniform(low, high), digits))


def triple(low: float, high: float, *, flat: bool = False) -> "list[str]":
    return [drawn(low, high), drawn(low, high), "0.0" if flat else drawn(low, high)]


def typed(texts: Sequence[str]) -> Vector:
    x, y, z = map(mpf, texts)
    return x, y, z


def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a: Vector, b: Vector) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def added(vectors: Sequence[Vector]) -> Vector:
    x, y, z = (sum(column, mpf(0)) for column in zip(*vectors, strict=True))
    return x, y, z


def addresses(name: str, vector: Vector) -> dict[str, Any]:
    return {f"{name}[{k}]": part for k, part in enumerate(vector)}


def axis_foot(force: Vector, moment: Vector) -> Vector:
    """The point x next to the origin with x × R = M − p·R: three equations and x·R = 0 for three unknowns."""
    pitch = dot(force, moment) / dot(force, force)
    x, y, z = force
    rows = matrix([[0, z, -y], [-z, 0, x], [y, -x, 0], [x, y, z]])
    right = matrix([*(m - pitch * f for m, f in zip(moment, force, strict=True)), 0])
    solved = lu_solve(rows, right)
    return solved[0], solved[1], solved[2]


def systems() -> Iterator[Case]:
    hard = [
        ([("123456.789 -98765.4321 55555.5555", "0.3 0.7 0.2"), ("-123456.788 98765.4322 -55555.5554", "1.1 -0.4 0.9"),
          ("-0.0011 -0.0002 -0.0002", "0.5 0.5 -0.25")], "forces that cancel but for nine digits"),
        ([("1e8 0.0 0.0", "0.0 1.0 0.0"), ("-1e8 0.0 0.0", "0.0 -1.0 2.0"), ("0.0 1e-6 0.0", "1.0 0.0 0.0"),
          ("0.0 0.0 2e-6", "3.0 0.0 5.0")], "a couple fourteen powers of ten above the force"),
        ([("0.1 0.0 0.3", "0.0 0.0 0.0"), ("0.2 0.0 -0.1", "0.0 1.0 0.0"), ("-0.3 0.0 -0.1", "0.0 2.0 0.0")],
         "decimals that cancel along x, which the doubles nearest to them do not"),
    ]  # fmt: skip
    given: list[Any] = [([(a.split(), b.split()) for a, b in rows], why) for rows, why in hard]
    given += [([(triple(-50, 50), triple(-3, 3)) for _ in range(n)], "") for n in (1, 2, 3, 4)]
    for nth, (rows, why) in enumerate(given):
        about, couple = triple(-2, 2), triple(-9, 9)
        inputs: dict[str, Any] = {
            "loads": [{"record": "Load", "force": force, "at": at} for force, at in rows],
            "couples": [{"record": "Couple", "moment": couple}], "about": about,
        }  # fmt: skip
        force = added([typed(force) for force, _ in rows])
        far = [cross(minus(typed(at), FAR), typed(force)) for force, at in rows]
        # what is known about the far point, seen from the point of reference
        point = typed(about)
        moment = added([*far, typed(couple), cross(minus(FAR, point), force)])
        size = sqrt(dot(force, force))
        foot = added([axis_foot(force, moment), point])
        turning = dot(force, moment) / size
        common = {"pitch": turning / size, "wrench_moment": turning}
        yield (
            "resultant", f"forces {nth}", why, inputs,
            addresses("force", force) | addresses("moment", moment) | addresses("axis_point", foot)
            | {"magnitude": size, **common},
        )  # fmt: skip
        yield (
            "equivalent", f"wrench {nth}", why, {**inputs, "form": {"word": "wrench"}},
            addresses("force", force) | addresses("at", foot) | common,
        )  # fmt: skip
        yield "equivalent", f"force and couple {nth}", why, inputs, addresses("couple", moment)


def moments() -> Iterator[Case]:
    hard = [
        ("1.0 2.0 -2.0", "100000.1 200000.0 -200000.0", "a force that all but passes through the point, far along it"),
        ("1e-9 0.0 1.0", "0.0 3.0 1e6", "a line far away whose lever is small"),
    ]
    given: list[Any] = [(force.split(), at.split(), why) for force, at, why in hard]
    given += [(triple(-90, 90), triple(-3, 3), "") for _ in range(4)]
    for nth, (pull, place, why) in enumerate(given):
        axis = triple(-1, 1)
        force, way = typed(pull), typed(axis)
        turning = cross(typed(place), force)
        size, across = sqrt(dot(turning, turning)), cross(force, way)
        # the point of the line of action r + s·F that is nearest to the origin
        share = -dot(typed(place), force) / dot(force, force)
        foot = added([typed(place), (share * force[0], share * force[1], share * force[2])])
        yield (
            "moment", f"force {nth}", why, {"force": pull, "at": place, "axis": axis},
            addresses("moment", turning) | addresses("foot", foot)
            | {
                "magnitude": size, "lever": sqrt(dot(foot, foot)),
                "about_line": dot(turning, way) / sqrt(dot(way, way)),
                "line_lever": abs(dot(typed(place), across)) / sqrt(dot(across, across)),
            },
        )  # fmt: skip


def supports() -> Iterator[Case]:
    """Reactions along three lines in the plane: three equations."""
    hard = [
        ("3.0", "5.000000001", "three links that all but meet in a point"),
        ("0.001", "1000.0", "a support far away: the moments of the reactions all but cancel"),
    ]
    for nth, (middle, far, why) in enumerate([*hard, *((drawn(1, 4), drawn(5, 9), "") for _ in range(4))]):
        links = [(["0.0", "0.0", "0.0"], ["0.6", "0.8", "0.0"]), ([middle, "0.0", "0.0"], ["0.0", "1.0", "0.0"]),
                 ([far, "0.0", "0.0"], ["-0.6", "0.8", "0.0"])]  # fmt: skip
        loads = [(triple(-90, 90, flat=True), triple(-3, 9, flat=True)) for _ in range(2)]
        inputs = {
            "loads": [{"record": "Load", "force": force, "at": at} for force, at in loads],
            "supports": [
                {"record": "Support", "type": {"word": "link"}, "at": at, "direction": way} for at, way in links
            ],
        }
        columns = [(*typed(way)[:2], cross(typed(at), typed(way))[2]) for at, way in links]
        force = added([typed(force) for force, _ in loads])
        turning = sum(cross(typed(at), typed(force))[2] for force, at in loads)
        pulls = lu_solve(matrix(columns).T, matrix([-force[0], -force[1], -turning]))
        results: dict[str, Any] = addresses("load", force)
        for k, (_, way) in enumerate(links):
            pull = tuple(pulls[k] * part for part in typed(way))
            results |= addresses(f"reactions[{k}].force", pull)  # type: ignore[arg-type]
            results[f"reactions[{k}].size"] = abs(pulls[k])
        yield "equilibrium", f"links {nth}", why, inputs, results


def springs() -> Iterator[Case]:
    hard = [
        (["0.0", "0.0", "0.0"], ["0.3", "0.4", "0.0"], "0.5", "at its free length as typed, not as doubles"),
        (["1e6", "0.0", "0.0"], ["1000000.3", "0.4", "0.0"], "0.4999999999", "hardly stretched, far from the origin"),
    ]
    for nth, (start, end, free, why) in enumerate(
        [*hard, *((triple(-1, 1), triple(2, 3), drawn(0.5, 4), "") for _ in range(4))]
    ):
        rate, damping, speed = drawn(10, 9000), drawn(1, 90), drawn(-2, 2)
        way = minus(typed(end), typed(start))
        length = sqrt(dot(way, way))
        stretch = length - mpf(free)
        tension = exact(rate) * stretch
        ends = {"record": "Ends", "first_end": start, "second_end": end}
        inputs = {"place": ends, "stiffness": rate, "free_length": free}
        results = {"tension": tension, "stretch": stretch, "length": length, "energy": tension * stretch / 2}
        yield "spring", f"ends {nth}", why, inputs, results | {"first_force[0]": tension * way[0] / length}
        drag = exact(damping) * exact(speed)
        yield (
            "spring", f"damper {nth}", "", {**inputs, "damping": damping, "rate": speed},
            {"spring_force": tension, "damper_force": drag, "tension": tension + drag},
        )  # fmt: skip


def weights() -> Iterator[Case]:
    for nth in range(4):
        mass, height, other, distance = drawn(1, 90), drawn(1, 4e6), drawn(1e3, 6e24, 0), drawn(1e3, 9e6)
        share = 1 / (1 + exact(height) / 6371000) ** 2
        yield (
            "gravity", f"altitude {nth}", "", {"mass": mass, "place": {"record": "AtAltitude", "altitude": height}},
            {"acceleration": GRAVITY * share, "force": exact(mass) * GRAVITY * share, "share": share},
        )  # fmt: skip
        pull = exact("6.6743e-11") * exact(other) / exact(distance) ** 2
        beside = {"record": "Beside", "other_mass": other, "distance": distance}
        yield (
            "gravity", f"masses {nth}", "", {"mass": mass, "place": beside},
            {"acceleration": pull, "force": exact(mass) * pull},
        )  # fmt: skip
    hard = [[("2.0", ["1.0", "0.1", "-0.3"]), ("2.0", ["-0.9999999999", "0.2", "0.30000000001"])]]
    drawings = [[(drawn(0.1, 9), triple(-3, 3)) for _ in range(n)] for n in (1, 2, 4)]
    for nth, rows in enumerate([*hard, *drawings]):
        about = ["0.0", "0.0", "0.0"] if nth == 0 else triple(-3, 3)
        particles = [{"record": "Particle", "mass": mass, "at": at} for mass, at in rows]
        total = sum(mpf(mass) for mass, _ in rows)
        centre = [sum(mpf(mass) * typed(at)[k] for mass, at in rows) / total for k in range(3)]
        results = {f"centre[{k}]": part for k, part in enumerate(centre)} | {"mass": total}
        results |= {f"first_moment[{k}]": total * (centre[k] - typed(about)[k]) for k in range(3)}
        why = "" if nth else "the mass centre all but at the origin"
        yield "first_moment", f"particles {nth}", why, {"particles": particles, "about": about}, results


def frictions() -> Iterator[Case]:
    hard = [("0.4636476090008061", "0.5", "on the angle of friction: the least push is what is left of a difference")]
    for nth, (slope, friction, why) in enumerate([*hard, *((drawn(-0.6, 0.6), drawn(0.2, 1.2), "") for _ in range(6))]):
        inputs = {
            "mass": drawn(1, 90), "angle": slope, "friction": friction, "width": drawn(0.3, 1),
            "centre_height": drawn(0.1, 0.4), "push": drawn(-90, 90), "push_height": drawn(0.05, 0.9),
        }  # fmt: skip
        mass, angle, mu, width, high, push, lever = (exact(text) for text in inputs.values())
        normal, down = mass * GRAVITY * cos(angle), mass * GRAVITY * sin(angle)
        # about the lower and the upper edge nothing is left of the push and the weight
        tips = [(down * high + side * normal * width / 2) / lever for side in (-1, 1)]
        results = {
            "normal_force": normal, "friction_force": down - push, "needed_friction": abs(down - push) / normal,
            "pressure_point": (lever * push - high * down) / normal,
        }  # fmt: skip
        low, top = max(down - mu * normal, tips[0]), min(down + mu * normal, tips[1])
        results["margin"] = min(push - low, top - push)
        if low <= top:
            results |= {"least_push": low, "largest_push": top}
        yield "friction", f"block {nth}", why, inputs, results


def wedges() -> Iterator[Case]:
    """Load and wedge on their own, each with the forces of its faces and their friction."""
    hard = [
        ("0.29145679447786715", "0.15", "0.15", "0.0", "on the limit of holding: what pulls it out all but vanishes"),
        ("1.15", "0.3", "0.05", "0.1", "close to where it jams: the drive grows without limit"),
        ("1e-06", "0.1", "0.2", "0.05", "a wedge as flat as a shim: friction is all there is"),
    ]
    drawings = [(drawn(0.05, 0.4), *(drawn(0, 0.4) for _ in range(3)), "") for _ in range(5)]
    for nth, (angle, face, ground, guide, why) in enumerate([*hard, *drawings]):
        load = drawn(100, 9000)
        inputs = {"load": load, "angle": angle, "friction": face, "ground_friction": ground, "guide_friction": guide}
        weight, a, mu, under, side = (exact(text) for text in inputs.values())
        # across the face and by the guide: nothing up or down, nothing sideways is left of the load
        normal, beside = lu_solve(
            matrix([[cos(a) - mu * sin(a), -side], [-(sin(a) + mu * cos(a)), 1]]), matrix([weight, 0])
        )
        drive = beside + under * (normal * (cos(a) - mu * sin(a)))
        # friction turned round; the guide is pressed on the side to which the face now leans
        lean = sin(a) - mu * cos(a)
        up = cos(a) + mu * sin(a)
        back, held = lu_solve(matrix([[up, side], [-abs(lean), 1]]), matrix([weight, 0]))
        results = {
            "drive": drive, "release": under * back * up - (held if lean > 0 else -held),
            "limit_angle": atan(mu) + atan(under), "efficiency": weight * tan(a) / drive,
            "face_force": normal * sqrt(1 + mu**2), "guide_force": beside * sqrt(1 + side**2),
        }  # fmt: skip
        yield "wedge", f"wedge {nth}", why, inputs, results


def screws() -> Iterator[Case]:
    """The thread unrolled: a block on an incline, pushed along the ground, up or down, with friction at its limit."""
    hard = [
        (
            "0.2617993877991494",
            "0.03",
            "0.002",
            "0.020498",
            "on the limit of holding: the lowering torque all but vanishes",
        ),
        ("0.0", "0.01", "0.03", "1.0", "close to where it jams: the torque grows without limit"),
    ]
    drawings = [(drawn(0, 0.6), drawn(0.01, 0.06, 4), drawn(0.001, 0.009, 4), drawn(0.02, 0.3), "") for _ in range(5)]
    for nth, (flank, mean, pitch, friction, why) in enumerate([*hard, *drawings]):
        load, collar, rubbing = drawn(100, 9000), drawn(0.02, 0.09), drawn(0.02, 0.3)
        inputs = {
            "load": load, "form": {"record": "Flank", "flank_angle": flank},
            "size": {"record": "Mean", "mean_diameter": mean}, "pitch": pitch, "friction": friction,
            "collar_diameter": collar, "collar_friction": rubbing,
        }  # fmt: skip
        weight, turn, across, lead, mu, ring, worn = map(exact, (load, flank, mean, pitch, friction, collar, rubbing))
        slope = atan(lead / (mp.pi * across))
        grip = mu / cos(turn)
        # across the incline N, along the ground H: N·(cos − s·μ′·sin) carries the load, H = N·(sin + s·μ′·cos)
        pushes = []
        for way in (1, -1):
            normal = weight / (cos(slope) - way * grip * sin(slope))
            pushes.append(normal * (sin(slope) + way * grip * cos(slope)))
        extra = weight * worn * ring / 2
        results = {
            "raising_torque": pushes[0] * across / 2 + extra, "lowering_torque": -pushes[1] * across / 2 + extra,
            "thread_torque": pushes[0] * across / 2, "collar_torque": extra, "lead_angle": slope,
            "efficiency": weight * lead / (2 * mp.pi * (pushes[0] * across / 2 + extra)),
            "locking_friction": tan(slope) * cos(turn), "lead": lead,
        }  # fmt: skip
        yield "screw", f"screw {nth}", why, inputs, results


def every() -> Iterator[Case]:
    for part in (systems, moments, supports, springs, weights, frictions, wedges, screws):
        yield from part()


if __name__ == "__main__":
    write("force_systems", ABOUT, every())
