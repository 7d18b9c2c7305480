"""Writes robot.json: poses, Jacobians and inverses of arms to 40 digits, for ordinary and hard inputs.

Torques are Lagrange's equations of energies, differentiated by differences; the program has Newton–Euler.
Poses are products of elementary motions as 4 × 4 matrices, Jacobians are difference quotients in many digits, inverses
are roots of the pose's equations by Newton's method; the program has one matrix a link, cross products of axes, and
closed forms.
Run: python tests/references/generate_robot_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator
from typing import Any

from case_files import write
from mpmath import cos, findroot, matrix, mp, mpf, sin, sqrt, svd_r

mp.dps = 130
ABOUT = "Written by generate_robot_references.py: SI inputs as doubles, results to 40 digits from 130-digit arithmetic."
Case = tuple[str, str, str, dict[str, Any], dict[str, Any]]
RANDOM = random.Random(1955)
RIGHT = "1.5707963267948966"
STEP = mpf(10) ** -30
# Steps of differences of differences.
INNER, OUTER = mpf(10) ** -32, mpf(10) ** -22

# a, alpha, d, sort of each joint
PUMA = [
    ("0.0", RIGHT, "0.67183"), ("0.4318", "0.0", "0.0"), ("0.0203", "-" + RIGHT, "0.15005"),
    ("0.0", RIGHT, "0.4318"), ("0.0", "-" + RIGHT, "0.0"), ("0.0", "0.0", "0.0"),
]  # fmt: skip
UR = [
    ("0.0", RIGHT, "0.089159"), ("-0.425", "0.0", "0.0"), ("-0.39225", "0.0", "0.0"),
    ("0.0", RIGHT, "0.10915"), ("0.0", "-" + RIGHT, "0.09465"), ("0.0", "0.0", "0.0823"),
]  # fmt: skip
WELDER = [
    ("0.15", "-" + RIGHT, "0.45"), ("0.6", "0.0", "0.0"), ("0.12", "-" + RIGHT, "0.0"),
    ("0.0", RIGHT, "0.62"), ("0.0", "-" + RIGHT, "0.0"), ("0.0", "0.0", "0.1"),
]  # fmt: skip


def turn(axis: int, angle: Any) -> Any:
    """A turn about a coordinate axis."""
    c, s = cos(angle), sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    motion = mp.eye(4)
    motion[i, i], motion[i, j], motion[j, i], motion[j, j] = c, -s, s, c
    return motion


def shift(axis: int, by: Any) -> Any:
    motion = mp.eye(4)
    motion[axis, 3] = by
    return motion


def arm(rows: list[tuple[str, ...]], convention: str, q: list[Any]) -> Any:
    """The hand's frame."""
    frame = mp.eye(4)
    for (a, alpha, d, *sort), value in zip(rows, q, strict=True):
        slides = bool(sort)
        theta = mpf(0) if slides else mpf(value)
        along = mpf(float(d)) + (mpf(value) if slides else 0)
        about = turn(2, theta) * shift(2, along)
        across = (mpf(float(a)), mpf(float(alpha)))
        if convention == "standard":
            frame = frame * about * shift(0, across[0]) * turn(0, across[1])
        else:
            frame = frame * turn(0, across[1]) * shift(0, across[0]) * about
    return frame


def written(rows: list[tuple[str, ...]], convention: str) -> dict[str, Any]:
    """The arm as an input."""
    joints = []
    for a, alpha, d, *sort in rows:
        joint: dict[str, Any] = {"record": "Joint", "a": a, "alpha": alpha, "d": d}
        joints.append(joint | ({"type": {"word": sort[0]}} if sort else {}))
    return {"record": "Arm", "convention": {"word": convention}, "joints": joints}


def planar(lengths: list[str]) -> list[tuple[str, ...]]:
    return [(length, "0.0", "0.0") for length in lengths]


def postures() -> Iterator[tuple[str, str, list[tuple[str, ...]], str, list[str]]]:
    yield "puma", "", PUMA, "standard", ["0.3", "0.4", "-0.5", "0.7", "1.1", "-0.2"]
    yield "puma, read as modified", "", PUMA, "modified", ["0.3", "0.4", "-0.5", "0.7", "1.1", "-0.2"]
    yield "ur", "", UR, "standard", ["0.5", "-1.2", "1.4", "-0.6", "0.9", "0.25"]
    yield "welder", "", WELDER, "standard", ["-0.4", "-0.9", "0.35", "1.3", "-0.7", "2.1"]
    for power in (3, 6, 9):
        q = ["0.3", "0.4", "-0.5", "0.7", f"1e-{power:02d}", "-0.2"]
        yield f"wrist, 1e-{power}", "the outer axes of the wrist are all but in line", PUMA, "standard", q
    yield (
        "stretched",
        "the elbow is all but straight",
        PUMA,
        "standard",
        ["0.3", "0.4", "-1.5238203", "0.7", "1.1", "-0.2"],
    )
    for nth in range(4):
        rows = (PUMA, UR, WELDER)[nth % 3]
        yield f"drawn {nth}", "", rows, "standard", [repr(round(RANDOM.uniform(-3, 3), 3)) for _ in rows]


def quaternion(m: Any) -> list[Any]:
    """Euler parameters, the scalar not negative, of a turn that is no half turn."""
    w = sqrt(1 + m[0, 0] + m[1, 1] + m[2, 2]) / 2
    return [w, (m[2, 1] - m[1, 2]) / (4 * w), (m[0, 2] - m[2, 0]) / (4 * w), (m[1, 0] - m[0, 1]) / (4 * w)]


def poses() -> Iterator[Case]:
    for name, why, rows, convention, texts in postures():
        hand = arm(rows, convention, [mpf(float(text)) for text in texts])
        place = [hand[k, 3] for k in range(3)]
        results = {f"position[{k}]": place[k] for k in range(3)}
        results |= {f"euler_parameters[{k}]": part for k, part in enumerate(quaternion(hand))}
        results["distance"] = sqrt(sum(x * x for x in place))
        inputs = {"arm": written(rows, convention), "angles": texts}
        yield "pose", name, why and f"{why}: its place is known as well as ever", inputs, results


def rows_of(rows: list[tuple[str, ...]], convention: str, q: list[Any]) -> Any:
    """The six rows of the Jacobian by differences."""
    jacobian = matrix(6, len(q))
    here = arm(rows, convention, q)
    for k in range(len(q)):
        ends = [arm(rows, convention, [x + sign * STEP * (i == k) for i, x in enumerate(q)]) for sign in (1, -1)]
        rate = (ends[0] - ends[1]) / (2 * STEP)
        spin = rate[:3, :3] * here[:3, :3].T
        for i in range(3):
            jacobian[i, k] = rate[i, 3]
        jacobian[3, k], jacobian[4, k], jacobian[5, k] = spin[2, 1], spin[0, 2], spin[1, 0]
    return jacobian


def jacobians() -> Iterator[Case]:
    for name, why, rows, convention, texts in postures():
        jacobian = rows_of(rows, convention, [mpf(float(text)) for text in texts])
        results = {"determinant.value": mp.det(jacobian)}
        for k in range(3):
            for i, row in enumerate(("linear", "angular")):
                for j in range(3):
                    value = jacobian[3 * i + j, k]
                    # what is left of a right angle as a double is no entry
                    if abs(value) > mpf(10) ** -12:
                        results[f"columns[{k}].{row}[{j}]"] = value
        linear = sorted(svd_r(jacobian[:3, :], compute_uv=False), reverse=True)
        angular = sorted(svd_r(jacobian[3:, :], compute_uv=False), reverse=True)
        results |= {f"speed_ratios[{k}]": value for k, value in enumerate(linear)}
        results |= {f"angular_values[{k}]": value for k, value in enumerate(angular)}
        inputs = {"arm": written(rows, convention), "angles": texts}
        yield "jacobian", name, why and f"{why}: the determinant all but vanishes", inputs, results
    for lengths, texts in ((["0.5", "0.4"], ["0.5", "1.3"]), (["1.0", "0.8", "0.5"], ["0.3", "0.7", "-0.4"])):
        rows = planar(lengths)
        jacobian = rows_of(rows, "standard", [mpf(float(text)) for text in texts])
        chosen = jacobian[:2, :]
        linear = sorted(svd_r(chosen, compute_uv=False), reverse=True)
        results = {"manipulability.value": linear[0] * linear[1]}
        results |= {f"speed_ratios[{k}]": value for k, value in enumerate(linear)}
        yield (
            "jacobian",
            f"planar {len(lengths)}",
            "",
            {"arm": {"record": "Arm", "lengths": lengths}, "angles": texts},
            results,
        )


def euler(m: Any) -> list[Any]:
    """Angles about fixed x, y, z."""
    return [mp.atan2(m[2, 1], m[2, 2]), mp.asin(-m[2, 0]), mp.atan2(m[1, 0], m[0, 0])]


def inverses() -> Iterator[Case]:
    """Roots of the pose's equations near a posture, for a pose of doubles."""
    for name, why, rows, convention, texts in postures():
        if convention == "modified" or "1e-9" in name:
            continue
        q = [mpf(float(text)) for text in texts]
        hand = arm(rows, convention, q)
        place = [repr(float(hand[k, 3])) for k in range(3)]
        angles = [repr(float(angle)) for angle in euler(hand)]
        goal = [mpf(float(x)) for x in place]
        a, b, c = (mpf(float(x)) for x in angles)
        wanted = turn(2, c) * turn(1, b) * turn(0, a)

        def off(*values: Any, rows: Any = rows, goal: Any = goal, wanted: Any = wanted) -> list[Any]:
            now = arm(rows, "standard", list(values))
            gap = now[:3, :3] * wanted[:3, :3].T
            spin = [gap[2, 1] - gap[1, 2], gap[0, 2] - gap[2, 0], gap[1, 0] - gap[0, 1]]
            return [now[k, 3] - goal[k] for k in range(3)] + spin

        root = findroot(off, q, tol=mpf(10) ** -130, maxsteps=60)
        inputs = {
            "arm": written(rows, convention), "position": place,
            "turn": {"record": "Euler", "euler_angles": angles, "euler_order": {"word": "XYZ"}}, "near": texts,
        }  # fmt: skip
        yield (
            "inverse",
            name,
            why and f"{why}: two postures fall together",
            inputs,
            {f"angles[{k}]": root[k] for k in range(6)},
        )


def edges() -> Iterator[Case]:
    """Two links at the edges of their reach, by the cosine rule in many digits."""
    for first, second, r, why in (
        ("1.0", "1.0", repr(2.0 - 2.0**-40), "all but stretched: the arc cosine loses half the digits"),
        ("1.0", "0.5", repr(0.5 + 2.0**-40), "all but folded: the arc cosine loses half the digits"),
        ("1.0", "0.5", repr(1.5 - 2.0**-40), "all but stretched: the arc cosine loses half the digits"),
        ("0.5", "0.4", "0.7", ""),
    ):
        l1, l2, distance = mpf(float(first)), mpf(float(second)), mpf(float(r))
        bend = mp.acos((distance**2 - l1**2 - l2**2) / (2 * l1 * l2))
        base = mp.acos((distance**2 + l1**2 - l2**2) / (2 * l1 * distance))
        inputs = {"arm": {"record": "Arm", "lengths": [first, second]}, "position": [r, "0.0", "0.0"]}
        results = {
            "solutions[0].angles[0]": -base, "solutions[0].angles[1]": bend,
            "solutions[1].angles[0]": base, "solutions[1].angles[1]": -bend,
        }  # fmt: skip
        yield "inverse", f"two links to {r}", why, inputs, results


def links(rows: list[tuple[str, ...]], convention: str, q: list[Any]) -> list[Any]:
    """The frame of every link."""
    return [arm(rows[: k + 1], convention, q[: k + 1]) for k in range(len(rows))]


class Heavy:
    """An arm with masses, and its energies."""

    def __init__(
        self, rows: list[tuple[str, ...]], convention: str, bodies: list[tuple[str, list[str], list[str]]]
    ) -> None:
        self.rows, self.convention, self.bodies = rows, convention, bodies

    def written(self) -> dict[str, Any]:
        table = written(self.rows, self.convention)
        for joint, (mass, centroid, moments) in zip(table["joints"], self.bodies, strict=True):
            a, b, c, d, e, f = moments
            joint |= {"mass": mass, "centroid": centroid, "tensor": [[a, d, e], [d, b, f], [e, f, c]]}
        return table

    def centres(self, q: list[Any]) -> list[tuple[Any, Any]]:
        out = []
        for frame, (_, centroid, _) in zip(links(self.rows, self.convention, q), self.bodies, strict=True):
            place = frame * matrix([mpf(float(x)) for x in centroid] + [1])
            out.append((place[:3], frame[:3, :3]))
        return out

    def mass_matrix(self, q: list[Any]) -> Any:
        """From places and turns of the links, differentiated."""
        count = len(q)
        here = self.centres(q)
        ways: list[list[tuple[Any, Any]]] = []
        for k in range(count):
            ends = [self.centres([x + s * INNER * (i == k) for i, x in enumerate(q)]) for s in (1, -1)]
            way = []
            for (p1, r1), (p0, r0), (_, r) in zip(ends[0], ends[1], here, strict=True):
                spin = r.T * (r1 - r0) / (2 * INNER)
                way.append(((matrix(p1) - matrix(p0)) / (2 * INNER), matrix([spin[2, 1], spin[0, 2], spin[1, 0]])))
            ways.append(way)
        total = matrix(count, count)
        for nth, (mass, _, moments) in enumerate(self.bodies):
            a, b, c, d, e, f = (mpf(float(x)) for x in moments)
            tensor = matrix([[a, d, e], [d, b, f], [e, f, c]])
            for i in range(count):
                for j in range(count):
                    v, w = ways[i][nth], ways[j][nth]
                    total[i, j] += mpf(float(mass)) * (v[0].T * w[0])[0] + (v[1].T * tensor * w[1])[0]
        return total

    def height(self, q: list[Any], up: list[Any]) -> Any:
        """Potential energy per gravity."""
        return sum(
            mpf(float(mass)) * sum(u * place[k] for k, u in enumerate(up))
            for (place, _), (mass, _, _) in zip(self.centres(q), self.bodies, strict=True)
        )

    def efforts(self, q: list[Any], v: list[Any], a: list[Any], lift: list[Any]) -> list[Any]:
        """Lagrange's equations."""
        count, rate, second = len(q), matrix(v), matrix(a)
        slopes = []
        for k in range(count):
            ends = [[x + s * OUTER * (i == k) for i, x in enumerate(q)] for s in (1, -1)]
            masses = (self.mass_matrix(ends[0]) - self.mass_matrix(ends[1])) / (2 * OUTER)
            slopes.append((masses, (self.height(ends[0], lift) - self.height(ends[1], lift)) / (2 * OUTER)))
        changing = matrix(count, count)
        for k in range(count):
            changing += slopes[k][0] * v[k]
        left = self.mass_matrix(q) * second + changing * rate
        return [left[k] - (rate.T * slopes[k][0] * rate)[0] / 2 + slopes[k][1] for k in range(count)]


def torques() -> Iterator[Case]:
    """Postures with speeds and accelerations."""
    puma = [
        ("0.0", ["0.0", "0.0", "0.0"], ["0.0", "0.35", "0.0", "0.0", "0.0", "0.0"]),
        ("17.4", ["-0.3638", "0.006", "0.2275"], ["0.13", "0.524", "0.539", "0.01", "-0.02", "0.03"]),
        ("4.8", ["-0.0203", "-0.0141", "0.07"], ["0.066", "0.086", "0.0325", "0.0", "0.001", "0.0"]),
        ("0.82", ["0.0", "0.019", "0.0"], ["0.0018", "0.0013", "0.0018", "0.0", "0.0", "0.0"]),
        ("0.34", ["0.0", "0.0", "0.0"], ["0.0003", "0.0004", "0.0003", "0.0", "0.0", "0.0"]),
        ("0.09", ["0.0", "0.0", "0.032"], ["0.00015", "0.00015", "0.00004", "0.0", "0.0", "0.0"]),
    ]
    quill = [("0.3", "0.0", "0.4"), ("0.25", RIGHT, "0.0"), ("0.1", "0.0", "0.05", "prismatic")]
    bodies = [
        ("5.0", ["-0.15", "0.01", "0.0"], ["0.02", "0.05", "0.06", "0.001", "0.0", "0.002"]),
        ("3.0", ["-0.1", "0.0", "0.02"], ["0.01", "0.03", "0.03", "0.0", "0.0", "0.0"]),
        ("1.5", ["0.0", "-0.05", "0.1"], ["0.01", "0.012", "0.005", "0.0", "0.001", "0.0"]),
    ]
    for name, heavy, q, v, a in (
        ("puma", Heavy(PUMA, "standard", puma), ["0.3", "0.4", "-0.5", "0.7", "1.1", "-0.2"],
         ["1.0", "-0.5", "0.8", "2.0", "-1.5", "3.0"], ["2.0", "1.0", "-1.0", "0.5", "4.0", "-2.0"]),
        ("puma, read as modified", Heavy(PUMA, "modified", puma), ["0.3", "0.4", "-0.5", "0.7", "1.1", "-0.2"],
         ["1.0", "-0.5", "0.8", "2.0", "-1.5", "3.0"], ["2.0", "1.0", "-1.0", "0.5", "4.0", "-2.0"]),
        ("slide", Heavy(quill, "standard", bodies), ["0.4", "-1.1", "0.2"],
         ["0.9", "1.4", "-0.6"], ["-1.0", "2.0", "0.7"]),
    ):  # fmt: skip
        numbers = [[mpf(float(x)) for x in texts] for texts in (q, v, a)]
        efforts = heavy.efforts(*numbers, [mpf(0), mpf(0), mpf(float("9.81"))])
        slides = [k for k, row in enumerate(heavy.rows) if len(row) > 3]
        turns = [k for k in range(len(q)) if k not in slides]
        inputs: dict[str, Any] = {"arm": heavy.written(), "gravity": "9.81"}
        for texts, turning, sliding in (
            (q, "angles", "slides"), (v, "speeds", "slide_speeds"), (a, "accelerations", "slide_accelerations"),
        ):  # fmt: skip
            inputs[turning] = [texts[k] for k in turns]
            inputs |= {sliding: [texts[k] for k in slides]} if slides else {}
        results = {f"torques[{nth}]": efforts[k] for nth, k in enumerate(turns)}
        results |= {f"slide_forces[{nth}]": efforts[k] for nth, k in enumerate(slides)}
        yield "torque", name, "", inputs, results


if __name__ == "__main__":
    write("robot", ABOUT, [*poses(), *jacobians(), *inverses(), *edges(), *torques()])
