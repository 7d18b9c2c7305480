"""Writes orient.json: the orient tasks' answers to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_orient_references.py [FILE]. The same bytes every time.

Other ways than the program's: turns are matrix exponentials, angles the textbook's arc sines and arc cosines, angular
velocities and accelerations are derivatives of motions, contacts are systems of linear equations.
"""

import json
import random
import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from found_cases import numbered
from mpmath import mp, mpf

DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"
DIGITS = 130
ORDERS = ("xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz")
Case = tuple[str, str, str, dict[str, Any], dict[str, Any]]
UNITS = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}
mp.dps = DIGITS


def vec(v: Any) -> Any:
    return mp.matrix([mpf(x) for x in v])


def cross(a: Any, b: Any) -> Any:
    return skew(a) * b


def dot(a: Any, b: Any) -> Any:
    return (a.T * b)[0]


def skew(v: Any) -> Any:
    return mp.matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def turn(axis: Any, angle: Any) -> Any:
    """A turn about an axis, as the exponential of its matrix (by halving and squaring)."""
    n = vec(axis)
    m = skew(n / mp.norm(n)) * mpf(angle) / 2**24
    whole, term = mp.eye(3), mp.eye(3)
    for k in range(1, 24):
        term = term * m / k
        whole += term
    for _ in range(24):
        whole = whole * whole
    return whole


def of_angles(angles: Any, order: str) -> Any:
    whole = mp.eye(3)
    for letter, angle in zip(order.lower(), angles, strict=True):
        step = turn(UNITS[letter], angle)
        whole = whole * step if order.islower() else step * whole
    return whole


def of_quaternion(q: Any) -> Any:
    """Columns q e q* of the sandwich product."""
    w, v = mpf(q[0]), vec(q[1:])
    square = w * w + dot(v, v)
    columns = [
        ((w * w - dot(v, v)) * e + 2 * dot(v, e) * v + 2 * w * cross(v, e)) / square for e in map(vec, UNITS.values())
    ]
    return mp.matrix([[columns[j][i] for j in range(3)] for i in range(3)])


def polar(rows: Any) -> Any:
    """The rotation nearest to a matrix: averaging with the inverse transpose, Higham's iteration."""
    m = mp.matrix([[mpf(x) for x in row] for row in rows])
    for _ in range(12):
        m = (m + (m**-1).T) / 2
    return m


def vee(m: Any) -> Any:
    return mp.matrix([(m[2, 1] - m[1, 2]) / 2, (m[0, 2] - m[2, 0]) / 2, (m[1, 0] - m[0, 1]) / 2])


def axis_angle(r: Any) -> tuple[Any, Any]:
    """Axis and angle from both parts of the matrix; no turn has the axis z, a half turn a first positive part."""
    sine, cosine = mp.norm(vee(r)), (r[0, 0] + r[1, 1] + r[2, 2] - 1) / 2
    angle = mp.atan2(sine, cosine)
    if sine > mpf(10) ** -40:
        return vee(r) / sine, angle
    if cosine > 0:
        return vec((0, 0, 1)), mpf(0)
    best = max(range(3), key=lambda k: r[k, k])
    n = mp.matrix([(r[i, best] + (i == best)) / 2 for i in range(3)])
    n = n / mp.norm(n)
    first = next(x for x in n if abs(x) > mpf(10) ** -40)
    return n * mp.sign(first), mp.pi


def quaternion(r: Any) -> list[Any]:
    n, angle = axis_angle(r)
    return [mp.cos(angle / 2) if angle != mp.pi else mpf(0), *(mp.sin(angle / 2) * x for x in n)]


def angles_of(r: Any, order: str) -> list[Any]:
    """Angles by the textbook: the middle one by its sine or cosine, the others by two elements each."""
    body = order if order.islower() else order[::-1].lower()
    i, j, k = ("xyz".index(letter) for letter in body)
    e = 1 if (j - i) % 3 == 1 else -1
    last = 3 - i - j
    if i == k:
        b = mp.acos(r[i, i])
        a, c = mp.atan2(r[j, i], -e * r[last, i]), mp.atan2(r[i, j], e * r[i, last])
    else:
        b = mp.asin(e * r[i, k])
        a, c = mp.atan2(-e * r[j, k], r[k, k]), mp.atan2(-e * r[i, j], r[i, i])
    return [a, b, c] if order.islower() else [c, b, a]


def motion(place: Callable[[Any], Any]) -> list[Any]:
    """A function of time at zero with its first two derivatives, by differences of 130 digits."""
    h = mpf(10) ** -22
    # Taylor coefficients from seven places: the error is of the order h⁶
    at = {k: place(k * h) for k in range(-3, 4)}
    first = (at[3] - 9 * at[2] + 45 * at[1] - 45 * at[-1] + 9 * at[-2] - at[-3]) / (60 * h)
    second = (2 * at[3] - 27 * at[2] + 270 * at[1] - 490 * at[0] + 270 * at[-1] - 27 * at[-2] + 2 * at[-3]) / (
        180 * h * h
    )
    return [at[0], first, second]


def spin(place: Callable[[Any], Any]) -> tuple[Any, Any, Any]:
    """Rotation, angular velocity and angular acceleration of a turning motion."""
    r, first, second = motion(place)
    return r, vee(first * r.T), vee(second * r.T + first * first.T)


def addresses(name: str, v: Any) -> dict[str, Any]:
    return {f"{name}[{k}]": x for k, x in enumerate(v)}


def rotation_of(record: dict[str, Any]) -> Any:
    kind = record["record"]
    if kind == "Euler":
        return of_angles(record["euler_angles"], record["euler_order"]["word"])
    if kind == "ByQuaternion":
        return of_quaternion(record["quaternion"])
    if kind == "ByMatrix":
        return polar(record["rotation_matrix"])
    if kind == "AxisAngle":
        return turn(record["rotation_axis"], record["rotation_angle"])
    if kind == "RotationVector":
        v = vec(record["rotation_vector"])
        return turn(v, mp.norm(v)) if mp.norm(v) else mp.eye(3)
    if kind == "Rodrigues":
        v = vec(record["rodrigues"])
        return turn(v, 2 * mp.atan(mp.norm(v)))
    a, b = vec(record["from_direction"]), vec(record["to_direction"])
    return turn(cross(a, b), mp.atan2(mp.norm(cross(a, b)), dot(a, b)))


def euler(angles: Any, order: str) -> dict[str, Any]:
    return {"record": "Euler", "euler_angles": list(angles), "euler_order": {"word": order}}


def convert_case(kind: str, name: str, record: dict[str, Any], sequence: str) -> Case:
    r = rotation_of(record)
    n, angle = axis_angle(r)
    q = quaternion(r)
    results = {
        "rotation_angle": angle, **addresses("rotation_axis", n), **addresses("quaternion", q),
        **addresses("rotation_vector", n * angle), **addresses("euler_angles", angles_of(r, sequence)),
        **addresses("rodrigues", n * mp.tan(angle / 2)),
    }  # fmt: skip
    return "convert", kind, name, {"turn": record, "sequence": {"word": sequence}}, results


def converts(g: random.Random) -> Iterator[Case]:
    def number(low: float, high: float) -> float:
        value = g.uniform(low, high)
        return round(value, 2) if g.random() < 0.4 else value

    for order in (*ORDERS, *(order.upper() for order in ORDERS)):
        angles = [number(-3.1, 3.1), number(0.2, 1.4), number(-3.1, 3.1)]
        yield convert_case("ordinary", f"angles {order}", euler(angles, order), g.choice(ORDERS))
        q = [number(-1, 1) for _ in range(4)]
        yield convert_case("ordinary", f"quaternion to {order}", {"record": "ByQuaternion", "quaternion": q}, order)
    for order in ("zyx", "zxz", "xyz", "XYZ", "ZXZ"):
        at = 0.0 if order[0] == order[2] else float(mp.pi / 2)
        for off in (1e-2, 1e-5, 9e-8, 1.1e-7, 1e-10):
            yield convert_case(
                "hard", f"{order}, {off} from lock", euler([0.7, at - off if at else off, 0.3], order), order
            )
    for angle in (1e-20, 1e-12, 1e-8, 1e-4, 0.1, 3.1, float(mp.pi) - 1e-6, float(mp.pi) - 1e-9, 3.1415926535897927):
        axis = {"record": "AxisAngle", "rotation_axis": [1.0, 2.0, -2.0], "rotation_angle": angle}
        yield convert_case("hard", f"{angle} about an axis", axis, "zyx")
        if angle < 3.14159:
            vector = {"record": "RotationVector", "rotation_vector": [angle * x / 3 for x in (1.0, 2.0, -2.0)]}
            yield convert_case("hard", f"rotation vector of {angle}", vector, "xyz")
    for scale in (1e-200, 1e200):
        yield convert_case(
            "hard", f"quaternion of size {scale}",
            {"record": "ByQuaternion", "quaternion": [scale * x for x in (1.0, -0.5, 0.25, 2.0)]}, "zyx",
        )  # fmt: skip
    rounded = [[0.8138, -0.4410, 0.3785], [0.4698, 0.8826, 0.0180], [-0.3420, 0.1632, 0.9254]]
    yield convert_case("hard", "O11 matrix of four decimals", {"record": "ByMatrix", "rotation_matrix": rounded}, "zyx")
    for _ in range(12):
        q = [g.gauss(0, 1) for _ in range(4)]
        rows = [[float(x) for x in of_quaternion(q)[i, :]] for i in range(3)]
        yield convert_case(
            "ordinary", "matrix in doubles", {"record": "ByMatrix", "rotation_matrix": rows}, g.choice(ORDERS)
        )
    yield convert_case(
        "ordinary",
        "O1 matrix",
        {"record": "ByMatrix", "rotation_matrix": [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]},
        "zxz",
    )
    yield convert_case(
        "ordinary", "O12 constant rate", {"record": "RotationVector", "rotation_vector": [1.0, 2.0, 3.0]}, "zyx"
    )
    yield convert_case(
        "hard",
        "O4 near a half turn",
        {"record": "AxisAngle", "rotation_axis": [1.0, 2.0, -2.0], "rotation_angle": float(mp.pi) - 1e-9},
        "xyz",
    )
    angles = [float(mp.radians(x)) for x in (30, 20, -40)]
    for sequence in ("zyx", "xyz", "zxz"):
        yield convert_case("ordinary", f"O2 to {sequence}", euler(angles, "zyx"), sequence)
    for _ in range(6):
        pair = [[number(-2, 2) for _ in range(3)] for _ in range(2)]
        yield convert_case(
            "ordinary",
            "two directions",
            {"record": "TwoDirections", "from_direction": pair[0], "to_direction": pair[1]},
            "zyx",
        )
        yield convert_case("ordinary", "Rodrigues parameters", {"record": "Rodrigues", "rodrigues": pair[0]}, "zyx")
    yield convert_case(
        "hard",
        "directions nearly the same",
        {"record": "TwoDirections", "from_direction": [1.0, 0.5, 0.25], "to_direction": [1.0, 0.5, 0.2500000001]},
        "zyx",
    )
    yield convert_case(
        "hard",
        "directions nearly opposite",
        {"record": "TwoDirections", "from_direction": [1.0, 0.5, 0.25], "to_direction": [-1.0, -0.5, -0.2501]},
        "zyx",
    )


def composes(g: random.Random) -> Iterator[Case]:
    for count in (1, 2, 3, 3, 5, 8):
        for about in ("body", "fixed"):
            chain = [{"axis": {"word": g.choice("xyz")}, "angle": g.uniform(-3, 3)} for _ in range(count)]
            whole = mp.eye(3)
            for one in chain:
                step = turn(UNITS[one["axis"]["word"]], one["angle"])
                whole = whole * step if about == "body" else step * whole
            n, angle = axis_angle(whole)
            results = {
                "rotation_angle": angle,
                **addresses("rotation_axis", n),
                **addresses("quaternion", quaternion(whole)),
            }
            yield "compose", "ordinary", f"{count} turns, {about}", {"turns": chain, "about": {"word": about}}, results


def betweens(g: random.Random) -> Iterator[Case]:
    for apart in (None, None, None, None, 1e-9, 3.1415926):
        q = [g.gauss(0, 1) for _ in range(4)]
        other = [g.gauss(0, 1) for _ in range(4)]
        if apart is not None:
            r = of_quaternion(q) * turn((1, 2, -2), apart)
            other = [float(x) for x in quaternion(r)]
        first, second = ({"record": "ByQuaternion", "quaternion": x} for x in (q, other))
        one, two = rotation_of(first), rotation_of(second)
        n, angle = axis_angle(one.T * two)
        results = {"rotation_angle": angle, **addresses("body_axis", n), **addresses("rotation_axis", one * n),
                   **addresses("quaternion", quaternion(one.T * two))}  # fmt: skip
        inputs = {"first": {"record": "Oriented", "turn": first}, "second": {"record": "Oriented", "turn": second}}
        yield "between", "hard" if apart else "ordinary", f"apart by {apart or 'any angle'}", inputs, results


def screws(g: random.Random) -> Iterator[Case]:
    def case(kind: str, name: str, record: dict[str, Any], d: Any, at: Any) -> Case:
        r = rotation_of(record)
        n, angle = axis_angle(r)
        shift = vec(at) + vec(d) - r * vec(at)
        travel = dot(n, shift)
        # (1 − R)·p = d − travel·n and n·p = 0, the second added along n
        point = mp.lu_solve(mp.eye(3) - r + n * n.T, shift - travel * n)
        results = {"rotation_angle": angle, **addresses("axis", n), **addresses("point", point), "travel": travel,
                   "lead": travel * 2 * mp.pi / angle}  # fmt: skip
        return "screw", kind, name, {"turn": record, "displacement": d, "of_point": at}, results

    angles = [float(mp.radians(x)) for x in (40, 25, 70)]
    yield case("ordinary", "O10", euler(angles, "zxz"), [0.2, -0.1, 0.3], [0.0, 0.0, 0.0])
    for angle in (2.5, 0.3, 1e-3, 1e-6):
        record = {"record": "AxisAngle", "rotation_axis": [g.uniform(-1, 1) for _ in range(3)], "rotation_angle": angle}
        yield case(
            "hard" if angle < 0.1 else "ordinary",
            f"turn of {angle}",
            record,
            [g.uniform(-1, 1) for _ in range(3)],
            [g.uniform(-3, 3) for _ in range(3)],
        )


def rates(g: random.Random) -> Iterator[Case]:
    def case(kind: str, name: str, angles: Any, order: str, first: Any, second: Any) -> Case:
        def place(t: Any) -> Any:
            return of_angles(
                [
                    a + b * t + c * t * t / 2
                    for a, b, c in zip(map(mpf, angles), map(mpf, first), map(mpf, second), strict=True)
                ],
                order,
            )

        r, omega, alpha = spin(place)
        results = {
            **addresses("angular_velocity", omega), **addresses("angular_acceleration", alpha),
            **addresses("body_angular_velocity", r.T * omega), **addresses("body_angular_acceleration", r.T * alpha),
            "angular_speed": mp.norm(omega), "angular_acceleration_size": mp.norm(alpha),
        }  # fmt: skip
        inputs = {"euler_angles": angles, "euler_order": {"word": order},
                  "motion": {"record": "ByRates", "angle_rates": first, "angle_accelerations": second}}  # fmt: skip
        return "rates", kind, name, inputs, results

    angles = [float(mp.radians(x)) for x in (30, 20, -40)]
    yield case("ordinary", "O5", angles, "zyx", [0.1, 0.2, 0.3], [0.4, -0.5, 0.6])
    angles = [float(mp.radians(x)) for x in (40, 25, 70)]
    yield case("ordinary", "O6", angles, "zxz", [3.0, 0.0, 50.0], [0.0, 0.0, 0.0])
    for order in ("zyx", "xyz", "zxz", "yzy", "XYZ", "ZXZ", "yxz", "XZX"):
        triples = [[g.uniform(-3, 3) for _ in range(3)] for _ in range(3)]
        yield case("ordinary", f"any, {order}", triples[0], order, triples[1], triples[2])
    inverse = case("hard", "", [0.7, float(mp.pi / 2) - 1e-6, 0.3], "zyx", [0.1, 0.2, 0.3], [0.4, -0.5, 0.6])
    yield "rates", "hard", "near lock", inverse[3], inverse[4]


def additions(g: random.Random) -> Iterator[Case]:
    for count in (1, 2, 3, 5):
        chain = [
            {"axis": [g.uniform(-1, 1) for _ in range(3)], "rate": g.uniform(-9, 9),
             "acceleration": g.uniform(-9, 9), "angle": g.uniform(-3, 3)} for _ in range(count)
        ]  # fmt: skip

        def place(t: Any, chain: Any = chain) -> Any:
            whole = mp.eye(3)
            for link in chain:
                angle = mpf(link["angle"]) + mpf(link["rate"]) * t + mpf(link["acceleration"]) * t * t / 2
                whole = whole * turn(link["axis"], angle)
            return whole

        _, omega, alpha = spin(place)
        results = {**addresses("angular_velocity", omega), **addresses("angular_acceleration", alpha),
                   "angular_speed": mp.norm(omega), "angular_acceleration_size": mp.norm(alpha)}  # fmt: skip
        yield "addition", "ordinary", f"{count} links", {"links": chain}, results


def turning(omega: Any, alpha: Any, t: Any) -> Any:
    v = vec(omega) * t + vec(alpha) * t * t / 2
    return turn(v, mp.norm(v)) if mp.norm(v) else mp.eye(3)


def moving_points(g: random.Random) -> Iterator[Case]:
    names = ("angular_velocity", "position", "relative_velocity", "relative_acceleration", "angular_acceleration",
             "origin_velocity", "origin_acceleration")  # fmt: skip
    for nth in range(4):
        inputs = {name: [g.uniform(-3, 3) for _ in range(3)] for name in names}
        w, r, u, b, al, vo, ao = (vec(inputs[name]) for name in names)
        _, first, second = motion(
            lambda t, w=w, r=r, u=u, b=b, al=al, vo=vo, ao=ao: (
                vo * t + ao * t * t / 2 + turning(w, al, t) * (r + u * t + b * t * t / 2)
            )
        )
        results = {**addresses("velocity", first), "speed": mp.norm(first), **addresses("acceleration", second),
                   "acceleration_size": mp.norm(second)}  # fmt: skip
        yield "moving_frame", "ordinary", f"any, {nth}", inputs, results


def point_sets(g: random.Random) -> Iterator[Case]:
    for nth in range(3):
        w, al, base, v, a, at = ([g.uniform(-3, 3) for _ in range(3)] for _ in range(6))
        _, first, second = motion(
            lambda t, w=w, al=al, base=base, v=v, a=a, at=at: (
                vec(v) * t + vec(a) * t * t / 2 + turning(w, al, t) * (vec(at) - vec(base))
            )
        )
        results = {**addresses("points[0].velocity", first), **addresses("points[0].acceleration", second),
                   "pitch": dot(vec(w), vec(v)) / dot(vec(w), vec(w))}  # fmt: skip
        inputs = {"angular_velocity": w, "angular_acceleration": al, "base": base, "base_velocity": v,
                  "base_acceleration": a, "points": [{"position": at}]}  # fmt: skip
        yield "points", "ordinary", f"any, {nth}", inputs, results
    for nth in range(3):
        w, v = ([g.uniform(-3, 3) for _ in range(3)] for _ in range(2))
        places = [[g.uniform(-2, 2) for _ in range(3)] for _ in range(3 + nth)]
        given = [{"position": p, "velocity": [float(x) for x in vec(v) + cross(vec(w), vec(p))]} for p in places]
        # least squares of v + ω × p over all components, by the normal equations of all six unknowns
        rows, right = mp.zeros(3 * len(places), 6), mp.zeros(3 * len(places), 1)
        for k, point in enumerate(given):
            rows[3 * k : 3 * k + 3, 0:3] = -skew(vec(point["position"]))
            rows[3 * k : 3 * k + 3, 3:6] = mp.eye(3)
            right[3 * k : 3 * k + 3, 0] = vec(point["velocity"])
        fit = mp.lu_solve(rows.T * rows, rows.T * right)
        yield (
            "points",
            "ordinary",
            f"from {len(places)} velocities",
            {"points": given},
            addresses("angular_velocity", fit[0:3]),
        )


def rollings(g: random.Random) -> Iterator[Case]:
    def case(name: str, contact: Any, normal: Any, bodies: list[dict[str, Any]]) -> Case:
        n = vec(normal) / mp.norm(vec(normal))
        across = mp.eye(3) - n * n.T
        columns, off = [], mp.zeros(3, 1)
        for sign, body in zip((1, -1), bodies, strict=True):
            arm = vec(contact) - vec(body["point"])
            off += sign * (vec(body["velocity"]) + cross(vec(body["angular_velocity"]), arm))
            if "axis" in body:
                columns.append(across * cross(vec(body["axis"]) / mp.norm(vec(body["axis"])), arm) * sign)
        m = mp.matrix([[column[i] for column in columns] for i in range(3)])
        found = list(mp.lu_solve(m.T * m, m.T * (across * -off)))
        spins, results = [], {}
        for label, body in zip(("first", "second"), bodies, strict=True):
            omega, alpha = vec(body["angular_velocity"]), mp.zeros(3, 1)
            if "axis" in body:
                rate = found.pop(0)
                own = rate * vec(body["axis"]) / mp.norm(vec(body["axis"]))
                results[f"{label}.rate"], alpha = rate, cross(omega, own)
                omega = omega + own
            spins.append(omega)
            results |= addresses(f"{label}.angular_velocity", omega) | addresses(f"{label}.angular_acceleration", alpha)
        results["spin"] = dot(spins[0] - spins[1], n)
        inputs = {"contact": contact, "normal": normal}
        for label, body in zip(("first", "second"), bodies, strict=True):
            inputs[label] = {"record": "Roller", **body}
        return "rolling", "ordinary", name, inputs, results

    still = {"angular_velocity": [0.0] * 3, "point": [0.0] * 3, "velocity": [0.0] * 3}
    half = mp.radians(20)
    cone = {
        "angular_velocity": [0.0, 0.0, 2.0],
        "axis": [float(mp.cos(half)), 0.0, float(mp.sin(half))],
        "point": [0.0] * 3,
        "velocity": [0.0] * 3,
    }
    yield case("O7 cone on a plane", [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [cone, still])
    for nth in range(4):
        bodies = [
            {name: [g.uniform(-2, 2) for _ in range(3)] for name in ("angular_velocity", "axis", "point", "velocity")}
            for _ in range(2)
        ]
        yield case(
            f"two rates, {nth}", [g.uniform(-1, 1) for _ in range(3)], [g.uniform(-1, 1) for _ in range(3)], bodies
        )


def disks(g: random.Random) -> Iterator[Case]:
    names = (
        "tilt",
        "spin_rate",
        "heading_rate",
        "tilt_rate",
        "spin_acceleration",
        "heading_acceleration",
        "tilt_acceleration",
    )

    def case(kind: str, name: str, radius: float, numbers: list[float]) -> Case:
        theta, psi1, phi1, theta1, psi2, phi2, theta2 = map(mpf, numbers)

        def place(t: Any) -> Any:
            tilt = theta + theta1 * t + theta2 * t * t / 2
            return turn((0, 0, 1), phi1 * t + phi2 * t * t / 2) * turn((1, 0, 0), tilt)

        def whole(t: Any) -> Any:
            return place(t) * turn((0, 0, 1), psi1 * t + psi2 * t * t / 2)

        frame, omega, alpha = place(mpf(0)), *spin(whole)[1:]

        def velocity(t: Any) -> Any:
            # ω(t) to the order that a first derivative needs, about the point of contact
            return cross(omega + alpha * t, mpf(radius) * place(t)[:, 1])

        _, acceleration, _ = motion(velocity)
        centre = velocity(mpf(0))
        arm = -mpf(radius) * frame[:, 1]
        contact = acceleration + cross(alpha, arm) + cross(omega, cross(omega, arm))
        results = {
            **addresses("angular_velocity", frame.T * omega), **addresses("angular_acceleration", frame.T * alpha),
            **addresses("centre_velocity", frame.T * centre),
            **addresses("centre_acceleration", frame.T * acceleration),
            **addresses("contact_acceleration", frame.T * contact),
            **addresses("fixed_centre_velocity", centre), **addresses("fixed_centre_acceleration", acceleration),
        }  # fmt: skip
        return "disk", kind, name, {"radius": radius, **dict(zip(names, numbers, strict=True))}, results

    yield case("ordinary", "O8", 0.35, [float(mp.pi / 3), -6.0, 1.5, 0.4, 0.5, 0.2, -0.3])
    for nth in range(4):
        yield case(
            "ordinary", f"any, {nth}", g.uniform(0.1, 2), [g.uniform(0.2, 2.9), *(g.uniform(-5, 5) for _ in range(6))]
        )


def bearings(g: random.Random) -> Iterator[Case]:
    for name, angle, a in [
        ("O9", float(mp.radians(25)), 0.012),
        *((f"any, {k}", g.uniform(0.05, 0.75), g.uniform(0.001, 0.1)) for k in range(4)),
    ]:
        c, s, size = mp.cos(angle), mp.sin(angle), mpf(a)
        # Kennedy: the ball's axis through both contacts with the race, the shaft's axis and the cone's line meet at the
        # apex, (0, −a − b); the cone touches the ball
        b = mp.findroot(lambda b, c=c, s=s, size=size: b * c - (size + b) * s - size, 3 * size)
        # unknown w and cage speed for a shaft speed of one: equal velocities at the cone, and of the centre
        touch = b - size * c
        m = mp.matrix([[-size * (1 + c + s), 0], [-size, -b]])
        w, cage = mp.lu_solve(m, mp.matrix([touch, 0]))
        results = {"rolling_radius": b, "contact_radius": touch, "cage_ratio": cage, "ball_ratio": abs(w) * mp.sqrt(2)}
        yield "bearing", "hard" if angle > 0.7 else "ordinary", name, {"cone_angle": angle, "ball_radius": a}, results


def joints(g: random.Random) -> Iterator[Case]:
    def through(bend: Any, theta: Any) -> Any:
        """Angle of the driven fork: across the driving fork and its own shaft."""
        fork = vec((-mp.sin(theta), mp.cos(theta), 0))
        shaft = vec((0, mp.sin(bend), mp.cos(bend)))
        driven = cross(shaft, fork)
        # both from where the driving fork is in the plane of the shafts
        level = vec((-1, 0, 0))
        return mp.atan2(dot(driven, cross(shaft, level)), dot(driven, level))

    for name, bend, at in [
        ("O13", float(mp.pi / 6), float(mp.radians(50))),
        *((f"any, {k}", g.uniform(0.05, 1.2), g.uniform(0.1, 1.4)) for k in range(4)),
        ("nearly straight", 1e-6, 0.8),
    ]:
        here, first, second = motion(lambda t, bend=bend, at=at: through(mpf(bend), mpf(at) + t))
        results = {"output_angle": here, "ratio": first, "ratio_slope": second, "output_speed": 100 * first,
                   "output_acceleration": 10000 * second}  # fmt: skip
        inputs = {"joint_angle": bend, "input_angle": at, "speed": 100.0}
        yield "joint", "hard" if bend < 1e-3 else "ordinary", name, inputs, results


def written(tree: Any) -> Any:
    """Doubles as text that reads back to the same bits."""
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, dict):
        return {name: part if name in ("word", "record") else written(part) for name, part in tree.items()}
    return [written(part) for part in tree] if isinstance(tree, list) else tree


# Why hard cases are so, by the names that they begin with or hold.
WHY = (
    (r"zyx, .* from lock", "yaw, pitch and roll near a pitch of 90°: yaw and roll turn about nearly one axis"),
    (r"xyz, .* from lock", "Bryan angles near lock: an arc sine of the middle angle keeps half of its digits"),
    (r"XYZ, .* from lock", "turns about fixed axes near lock: the sensitive angles come in reverse order"),
    (r"zxz, .* from lock", "Euler angles of a small nutation: an arc cosine near 1 keeps half of its digits"),
    (r"ZXZ, .* from lock", "Euler angles about fixed axes, small in the middle: their sum is known, not each"),
    (r"(1e-20|1e-12|1e-08) about", "a tiny turn: the arc cosine of the trace gives an angle of zero"),
    (r"vector of (1e-20|1e-12|1e-08)", "a tiny rotation vector: dividing by its sine or its angle must not lose it"),
    (r"(0.0001|0.1|3.1) (about|$)", "a turn on the far side of where series would take over from closed forms"),
    (r"vector of (0.0001|0.1|3.1)", "a rotation vector where (θ − sin θ)/θ³ by its closed form loses digits"),
    (
        r"^3.1415\d+ about",
        "a turn near 180°: the antisymmetric part of the matrix, which holds the axis, all but vanishes",
    ),
    (r"O4", "a turn 1e-9 short of 180°: the quaternion's scalar is a difference of nearly equal numbers"),
    (r"size 1e-200", "the squares of so small a quaternion's components underflow, so that its length would be zero"),
    (
        r"size 1e\+200",
        "the squares of so large a quaternion's components overflow, so that its length would be infinite",
    ),
    (r"O11", "a matrix printed with four decimals is no rotation, and the nearest one is wanted"),
    (r"nearly the same", "the angle between nearly equal directions vanishes in the arc cosine of their product"),
    (r"nearly opposite", "the axis of the shortest turn is the product of directions that are nearly parallel"),
    (r"apart by 1e-09", "two orientations nearly alike: their turn is what is left of products that cancel"),
    (r"apart by 3.14", "two orientations nearly half a turn apart: the other way round is nearly as short"),
    (r"turn of 0.001", "a small turn's screw axis is far away: the point is divided by the tangent of half the angle"),
    (r"turn of 1e-06", "a tiny turn's screw axis is a million times as far away as the displacement is long"),
    (r"near lock", "rates near lock: two of the axes that the angles turn about are nearly parallel"),
    (r"straight", "a nearly straight joint: its ratio differs from 1 by the square of the angle"),
)


def why(name: str) -> str:
    """Why a case is hard."""
    return next(sentence for pattern, sentence in WHY if re.search(pattern, name))


def digits(x: Any) -> str:
    """40 digits; what is left of a zero by derivatives is zero."""
    return "0.0" if abs(x) < mpf(10) ** -70 else mp.nstr(x, 40)


def main() -> None:
    g = random.Random(4)
    found = []
    for cases in (
        converts,
        composes,
        betweens,
        screws,
        rates,
        additions,
        moving_points,
        point_sets,
        rollings,
        disks,
        bearings,
        joints,
    ):
        for task, kind, name, inputs, results in cases(g):
            found.append(
                {
                    "task": task,
                    "kind": kind,
                    "name": name,
                    **({"why": why(name)} if kind == "hard" else {}),
                    "inputs": written(inputs),
                    "results": {k: digits(v) for k, v in results.items()},
                }
            )
    about = "Answers of the orient tasks to 40 digits; see tests/references/generate_orient_references.py"
    lines = ",\n".join(json.dumps(case, ensure_ascii=False) for case in numbered(found))
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / "orient.json"
    target.write_text(f'{{"about": {json.dumps(about)}, "cases": [\n{lines}\n]}}\n', encoding="utf-8")


if __name__ == "__main__":
    main()
