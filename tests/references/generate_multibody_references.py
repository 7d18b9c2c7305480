"""Writes multibody.json: efforts, accelerations, mass matrices and motions of trees and loops to 40 digits.

Every body is seven points with masses that have its mass, mass centre and second moments; their places are functions
of the ways of all joints, products of rotations by Rodrigues' formula. Efforts are sums of masses times accelerations
times slopes of places, by difference quotients over time and ways: no angular velocities, no recursion. Weight, loads,
springs and dampers act through slopes too; loops by Lagrange's multipliers. The program has recursions over bodies
with tensors, articulated bodies, and an orthogonal complement.
Run: python tests/references/generate_multibody_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator
from typing import Any

from case_files import Case, write
from mpmath import cos, eye, lu_solve, matrix, mp, mpf, norm, sin, sqrt, zeros

mp.dps = 110
ABOUT = (
    "Written by generate_multibody_references.py: SI inputs as doubles, results to 40 digits from 110-digit arithmetic."
)
STEP = mpf(10) ** -24
RANDOM = random.Random(1812)
GRAVITY = "9.81"
UNITS = {"x": ["1", "0", "0"], "y": ["0", "1", "0"], "z": ["0", "0", "1"]}
JOINTS = {  # ways of each joint, in the order of its speeds: t turns, s slides
    "revolute": "t", "prismatic": "s", "cylindrical": "st", "universal": "tu", "ball": "b", "planar": "pqt",
    "free": "xyzb", "fixed": "",
}  # fmt: skip
Body = dict[str, Any]


def exact(texts: list[str]) -> Any:
    return matrix([mpf(float(text)) for text in texts])


def drawn(count: int = 1, low: float = -1.0, high: float = 1.0) -> list[str]:
    return [repr(round(RANDOM.uniform(low, high), 3)) for _ in range(count)]


def skew(v: Any) -> Any:
    return matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def turned(axis: Any, angle: Any) -> Any:
    """Rodrigues' rotation."""
    cross = skew(axis / norm(axis))
    return eye(3) + sin(angle) * cross + (1 - cos(angle)) * cross * cross


def exponential(v: Any) -> Any:
    size = norm(v)
    return turned(v, size) if size else eye(3)


def of_quaternion(texts: list[str]) -> Any:
    q = exact(texts)
    q = q / norm(q)
    v = matrix([q[1], q[2], q[3]])
    return (q[0] ** 2 - (v.T * v)[0]) * eye(3) + 2 * v * v.T + 2 * q[0] * skew(v)


def points(body: Body) -> list[tuple[Any, Any]]:
    """Masses and places, in the body's axes, with its mass, mass centre and second moments."""
    mass = mpf(float(body.get("mass", "0")))
    if not mass:
        return []
    if "rod" in body:
        centre = exact(body["rod"]) / 2
        second = mass / 3 * centre * centre.T
    else:
        centre = exact(body.get("centroid", ["0", "0", "0"]))
        if "tensor" in body:
            tensor = matrix([[mpf(float(text)) for text in row] for row in body["tensor"]])
        else:
            a, b, c = exact(body["moments"])
            tensor = matrix([[a, 0, 0], [0, b, 0], [0, 0, c]])
        second = (tensor[0, 0] + tensor[1, 1] + tensor[2, 2]) / 2 * eye(3) - tensor
    out = [(mass / 7, centre)]
    for column in factor(second):
        arm = sqrt(mpf(7) / (2 * mass)) * column
        out += [(mass / 7, centre + arm), (mass / 7, centre - arm)]
    return out


def factor(second: Any) -> list[Any]:
    """Columns whose products add up to a matrix that is not negative, whatever its rank."""
    left, columns = second.copy(), []
    for _ in range(3):
        k = max(range(3), key=lambda i: left[i, i])
        if left[k, k] <= mpf(10) ** -90:
            columns.append(zeros(3, 1))
            continue
        column = left[:, k] / sqrt(left[k, k])
        columns.append(column)
        left -= column * column.T
    return columns


class Tree:
    """Bodies with their state, loads, springs and loops, from the inputs of a case."""

    def __init__(self, bodies: list[Body], **more: Any) -> None:
        self.bodies, self.more = bodies, more
        self.names = ["ground", *(body["name"] for body in bodies)]
        self.points = [points(body) for body in bodies]
        self.speeds, self.rates, self.efforts, self.turning = [], [], [], []
        for body in bodies:
            for turns, name, second, effort in (
                (False, "velocity", "acceleration", "force"), (True, "speed", "angular_acceleration", "torque"),
            ):  # fmt: skip
                letters = JOINTS[body["joint"]]
                count = sum((1, 3)[x == "b"] for x in letters if (x in "tub") is turns)
                none = ["0"] * count
                self.speeds += list(exact(body.get(name, none)))
                self.rates += list(exact(body.get(second, none)))
                self.efforts += list(exact(body.get(effort, none)))
                self.turning += [turns] * count
        self.count = len(self.speeds)

    def frames(self, way: list[Any]) -> list[tuple[Any, Any]]:
        """Rotation and origin of the ground and every body, each speed's joint moved by its way from the state."""
        frames, left = [(eye(3), zeros(3, 1))], list(way)
        for body in self.bodies:
            carrier, origin = frames[self.names.index(body.get("parent", "ground"))]
            origin = origin + carrier * exact(body.get("position", ["0", "0", "0"]))
            turn, axis = carrier, exact(body.get("axis", UNITS["z"]))
            angles, slides = list(exact(body.get("angle", ["0"] * 2))), list(exact(body.get("slide", ["0"] * 3)))
            for letter in JOINTS[body["joint"]]:
                if letter in "sxyzpq":
                    k = {"p": 1, "q": 2}.get(letter, 0)
                    first = max(range(3), key=lambda i: abs(axis[i]))
                    unit = UNITS[letter] if letter in "xyz" else UNITS["xyz"[(first + k) % 3]]
                    along = axis / norm(axis) if letter == "s" else exact(unit)
                    origin = origin + turn * along * (slides.pop(0) + left.pop(0))
                elif letter == "b":
                    start = of_quaternion(body.get("orientation", ["1", "0", "0", "0"]))
                    turn = turn * start * exponential(matrix([left.pop(0) for _ in range(3)]))
                else:
                    about = exact(body["second_axis"]) if letter == "u" else axis
                    turn = turn * turned(about, angles.pop(0) + left.pop(0))
            frames.append((turn, origin))
        return frames

    def places(self, way: list[Any]) -> list[Any]:
        """Places of all points with mass."""
        frames = self.frames(way)[1:]
        return [
            origin + turn * place
            for (turn, origin), group in zip(frames, self.points, strict=True)
            for _, place in group
        ]

    def masses(self) -> list[Any]:
        return [mass for group in self.points for mass, _ in group]

    def point(self, way: list[Any], name: str, at: list[str]) -> Any:
        turn, origin = self.frames(way)[self.names.index(name)]
        return origin + turn * exact(at)

    def slopes(self, function: Any) -> list[Any]:
        """Derivatives of a function of the ways, one for each speed, where the system stands."""
        out = []
        for k in range(self.count):
            ahead, behind = ([sign * STEP * (k == n) for n in range(self.count)] for sign in (1, -1))
            out.append(over(function(ahead), function(behind)))
        return out

    def along(self, rates: list[Any]) -> tuple[Any, Any]:
        """Places after a step of time and before it, with these rates of the speeds."""
        ways = (
            [sign * STEP * y + STEP**2 * a / 2 for y, a in zip(self.speeds, rates, strict=True)] for sign in (1, -1)
        )
        ahead, behind = ways
        return ahead, behind

    def needed(self, rates: list[Any]) -> list[Any]:
        """The efforts of all speeds for rates of the speeds, weight and what acts taken off."""
        here, masses = self.places([mpf(0)] * self.count), self.masses()
        ahead, behind = (self.places(way) for way in self.along(rates))
        weight = mpf(float(GRAVITY))
        slopes = self.slopes(self.places)
        out = []
        for k in range(self.count):
            total = mpf(float(self.rotor(k))) * rates[k] - self.acting()[k]
            for mass, a, b, c, slope in zip(masses, here, ahead, behind, slopes[k], strict=True):
                acceleration = (b - 2 * a + c) / STEP**2 + matrix([0, 0, weight])
                total += mass * (acceleration.T * slope)[0]
            out.append(total)
        return out

    def rotor(self, k: int) -> str:
        rotors = []
        for body in self.bodies:
            for letter in JOINTS[body["joint"]]:
                rotors += [body.get("rotor_inertia", "0") if letter in "tu" else "0"] * (1, 3)[letter == "b"]
        return rotors[k]

    def acting(self) -> list[Any]:
        """Generalized forces of loads, springs and dampers."""
        if not hasattr(self, "acted"):
            self.acted = self._acting()
        return self.acted

    def _acting(self) -> list[Any]:
        out = [mpf(0)] * self.count
        still = [mpf(0)] * self.count
        for load in self.more.get("loads", []):
            name = load["body"]
            slopes = self.slopes(lambda way, load=load, name=name: self.point(way, name, load.get("at", ["0"] * 3)))
            turn = self.frames(still)[self.names.index(name)][0]
            of_body = load.get("axes") == "body"
            force, moment = (exact(load.get(key, ["0"] * 3)) for key in ("force", "moment"))
            force, moment = (turn * force, turn * moment) if of_body else (force, moment)
            # a moment as couples of forces on arms along the axes
            spins = self.slopes(lambda way, name=name: self.frames(way)[self.names.index(name)][0])
            for k in range(self.count):
                spin = spins[k] * turn.T
                out[k] += (force.T * slopes[k])[0]
                out[k] += moment[0] * spin[2, 1] + moment[1] * spin[0, 2] + moment[2] * spin[1, 0]
        for spring in self.more.get("springs", []):

            def long(way: list[Any], spring: Any = spring) -> Any:
                ends = (self.point(way, spring[key], spring[f"{key}_at"]) for key in ("first", "second"))
                first, second = ends
                return norm(first - second)

            slopes = self.slopes(long)
            opening = sum(slope * y for slope, y in zip(slopes, self.speeds, strict=True))
            pull = mpf(float(spring["stiffness"])) * (long(still) - mpf(float(spring["free_length"])))
            pull += mpf(float(spring.get("damping", "0"))) * opening
            out = [total - pull * slope for total, slope in zip(out, slopes, strict=True)]
        return out

    def mass_matrix(self) -> Any:
        slopes, masses = self.slopes(self.places), self.masses()
        out = zeros(self.count, self.count)
        for i in range(self.count):
            out[i, i] = mpf(float(self.rotor(i)))
            for j in range(self.count):
                out[i, j] += sum(m * (a.T * b)[0] for m, a, b in zip(masses, slopes[i], slopes[j], strict=True))
        return out

    def accelerations(self) -> list[Any]:
        """Rates of the speeds for the efforts, within loops by multipliers of the conditions that count."""
        total = self.mass_matrix()
        bias = self.needed([mpf(0)] * self.count)
        left = [effort - held for effort, held in zip(self.efforts, bias, strict=True)]
        rows: list[list[Any]] = []
        drifts: list[Any] = []
        for loop in self.more.get("loops", []):

            def gap(way: list[Any], loop: Any = loop) -> Any:
                first = self.point(way, loop["first"], loop["first_at"])
                return first - self.point(way, loop["second"], loop["second_at"])

            slopes = self.slopes(gap)
            ahead, behind = (gap(way) for way in self.along([mpf(0)] * self.count))
            drift = (ahead - 2 * gap([mpf(0)] * self.count) + behind) / STEP**2
            # pins in one plane: two conditions count
            for k in loop["count"]:
                rows.append([slope[k] for slope in slopes])
                drifts.append(drift[k])
        n, c = self.count, len(rows)
        whole, right = zeros(n + c, n + c), zeros(n + c, 1)
        whole[:n, :n] = total
        for k, row in enumerate(rows):
            for j, x in enumerate(row):
                whole[n + k, j] = whole[j, n + k] = x
            right[n + k] = -drifts[k]
        for k, x in enumerate(left):
            right[k] = x
        return list(lu_solve(whole, right))[:n]

    def written(self) -> dict[str, Any]:
        """The inputs of a case."""
        scene: dict[str, Any] = {"record": "Scene", "bodies": [words("Body", body) for body in self.bodies]}
        for key, record in (("loads", "Load"), ("loops", "Loop"), ("springs", "Spring")):
            if self.more.get(key):
                scene[key] = [words(record, one) for one in self.more[key]]
        return {"scene": scene, "gravity": GRAVITY}


def over(ahead: Any, behind: Any) -> Any:
    """A difference quotient, of lists one by one."""
    if isinstance(ahead, list):
        return [(a - b) / (2 * STEP) for a, b in zip(ahead, behind, strict=True)]
    return (ahead - behind) / (2 * STEP)


def words(record: str, fields: dict[str, Any]) -> dict[str, Any]:
    """A record as cases write it."""
    names = ("name", "parent", "joint", "body", "first", "second", "axes")
    numbers = {
        key: {"word": value} if key in names else list(map(str, value)) if key == "count" else value
        for key, value in fields.items()
        if key != "count"
    }
    return {"record": record, **numbers}


def drawn_tree(joints: str, **more: Any) -> Tree:
    """A tree whose numbers are drawn; each body on one of those before."""
    bodies: list[Body] = []
    for n, joint in enumerate(joints.split()):
        letters = JOINTS[joint]
        turns = sum((1, 3)[x == "b"] for x in letters if x in "tub")
        slides = sum(x not in "tub" for x in letters)
        body: Body = {
            "name": f"b{n + 1}", "parent": RANDOM.choice(["ground", *(f"b{k + 1}" for k in range(n))][-2:]),
            "joint": joint, "position": drawn(3), "mass": drawn(1, 0.5, 4.0)[0], "centroid": drawn(3, -0.4, 0.4),
            "moments": drawn(3, 0.2, 0.38),
        }  # fmt: skip
        if joint not in ("ball", "free", "fixed"):
            body["axis"] = RANDOM.choice(list(UNITS.values())) if joint == "planar" else drawn(3)
        if joint == "universal":
            body["second_axis"] = drawn(3)
        if turns and turns < 3:
            body["angle"] = drawn(turns)
        if turns == 3:
            body["orientation"] = RANDOM.choice((["0.8", "0.4", "-0.2", "0.4"], ["0.5", "-0.5", "0.5", "0.5"]))
        if slides:
            body["slide"] = drawn(slides)
        for key, count in (("speed", turns), ("angular_acceleration", turns), ("torque", turns),
                           ("velocity", slides), ("acceleration", slides), ("force", slides)):  # fmt: skip
            if count:
                body[key] = drawn(count, -2.0, 2.0)
        bodies.append(body)
    return Tree(bodies, **more)


def cases_of(name: str, why: str, tree: Tree, tasks: str) -> Iterator[Case]:
    inputs = tree.written()
    if "efforts" in tasks:
        needs = tree.needed(tree.rates)
        yield "efforts", name, why, inputs, {f"efforts[{k}].effort": x for k, x in enumerate(needs)}
    if "matrix" in tasks:
        total = tree.mass_matrix()
        yield (
            "matrix", name, why, inputs,
            {f"matrix[{i}].values[{j}].value": total[i, j] for i in range(tree.count) for j in range(i + 1)},
        )  # fmt: skip
    if "accelerations" in tasks:
        rates = tree.accelerations()
        yield (
            "accelerations", name, why, inputs,
            {f"accelerations[{k}].acceleration": x for k, x in enumerate(rates)},
        )  # fmt: skip


def trees() -> Iterator[Case]:
    """Trees of joints of every kind."""
    every = "efforts matrix accelerations"
    load = {
        "body": "b2",
        "force": ["3.0", "-1.0", "2.0"],
        "moment": ["0.5", "0.2", "-0.4"],
        "at": ["0.1", "0.2", "-0.3"],
    }
    spring = {"first": "b3", "second": "b1", "first_at": ["0.1", "0.0", "-0.2"], "second_at": ["0.3", "0.1", "0.2"],
              "stiffness": "40.0", "free_length": "0.5", "damping": "3.0"}  # fmt: skip
    for joints in ("revolute revolute prismatic ball", "revolute universal cylindrical", "free ball revolute",
                   "planar revolute fixed revolute"):  # fmt: skip
        for k in (1, 2):
            yield from cases_of(f"{joints} {k}", "", drawn_tree(joints), every)
    loads = [load, load | {"axes": "body"}]
    yield from cases_of("tree with loads", "", drawn_tree("revolute ball", loads=loads), every)
    sprung = drawn_tree("ball revolute prismatic", springs=[spring])
    yield from cases_of("tree with spring and damper", "", sprung, every)


def chosen() -> Iterator[Case]:
    """Cases at limits."""
    rods: list[Body] = [
        {"name": f"rod {n}", "parent": f"rod {n - 1}" if n > 1 else "ground", "joint": "revolute", "axis": UNITS["y"],
         "position": ["1.0" if n > 1 else "0.0", "0.0", "0.0"], "mass": "1.0", "rod": ["1.0", "0.0", "0.0"]}
        for n in range(1, 7)
    ]  # fmt: skip
    yield from cases_of(
        "six thin rods, held level, let go", "no inertia about their own axes", Tree(rods), "accelerations"
    )
    cross: list[Body] = [
        {"name": "shaft", "joint": "universal", "axis": UNITS["x"], "second_axis": UNITS["y"], "mass": "2.0",
         "centroid": ["0.0", "0.0", "-0.5"], "moments": ["0.25", "0.25", "0.125"], "angle": ["0.5", "0.25"],
         "speed": ["1.0", "-2.0"]}
    ]  # fmt: skip
    yield from cases_of("universal joint", "a cross without mass stands between", Tree(cross), "matrix accelerations")
    for heavy in ("1e3", "1e9"):
        chain: list[Body] = [
            {"name": "light", "joint": "revolute", "axis": UNITS["y"], "mass": "0.001", "rod": ["0.5", "0.0", "0.2"],
             "angle": ["0.3"], "speed": ["1.0"]},
            {"name": "second", "parent": "light", "joint": "revolute", "axis": UNITS["x"], "mass": "0.001",
             "position": ["0.5", "0.0", "0.2"], "rod": ["0.0", "0.1", "0.5"], "angle": ["-0.4"], "speed": ["-0.7"]},
            {"name": "heavy", "parent": "second", "joint": "revolute", "axis": UNITS["y"], "mass": heavy,
             "position": ["0.0", "0.1", "0.5"], "rod": ["0.4", "0.1", "0.3"], "angle": ["0.9"], "torque": ["5.0"]},
        ]  # fmt: skip
        yield from cases_of(f"load of {heavy} kg", "light bodies carry a heavy one", Tree(chain), "accelerations")
    bar: list[Body] = [
        {"name": "crank", "joint": "revolute", "axis": UNITS["y"], "mass": "1.0", "rod": ["0.3", "0.0", "0.4"]},
        {"name": "coupler", "parent": "crank", "joint": "revolute", "axis": UNITS["y"], "mass": "2.0",
         "position": ["0.3", "0.0", "0.4"], "rod": ["0.9", "0.0", "0.3"]},
        {"name": "rocker", "joint": "revolute", "axis": UNITS["y"], "mass": "1.5", "position": ["1.0", "0.0", "0.0"],
         "rod": ["0.2", "0.0", "0.7"]},
    ]  # fmt: skip
    loop = {"first": "coupler", "second": "rocker", "first_at": ["0.9", "0.0", "0.3"],
            "second_at": ["0.2", "0.0", "0.7"], "axis": UNITS["y"], "count": (0, 2)}  # fmt: skip
    yield from cases_of("four-bar released", "pins in one plane hold more than they need", Tree(bar, loops=[loop]),
                        "accelerations")  # fmt: skip


if __name__ == "__main__":
    write("multibody", ABOUT, [*trees(), *chosen()])
