"""Writes motion.json: equations of motion of bodies given by formulas, chains and their modes, to 40 digits.

Equations by differences of 150 digits: Lagrange's T from places and rotation matrices a small time apart, forces by the
work that they do on small changes of a coordinate; the program has exact derivatives and vectors. Chains by Taylor
series, with masses as in generate_chain_motions.py; modes are the eigenvalues there at 60 digits.

Run: python tests/references/generate_motion_references.py [FILE]. The same bytes every time.
"""

import json
import random
from typing import Any

from case_files import put
from generate_chain_motions import frequencies, masses
from mpmath import atan, cos, eye, fdot, lu_solve, matrix, mp, mpf, nstr, pi, sin, sqrt

ABOUT = "Written by generate_motion_references.py: SI inputs as doubles, results to 40 digits."
RANDOM = random.Random(1112)
GRAVITY = mpf(9.80665)
STEP = mpf(10) ** -30
TERMS, DIGITS = 60, 48
FUNCTIONS = {"sin": sin, "cos": cos, "sqrt": sqrt, "atan": atan, "pi": pi}


def exact(text: str) -> Any:
    return mpf(float(text))


class Formulas:
    """A scene's formulas as functions of coordinates, rates and time; numbers in them are doubles."""

    def __init__(self, scene: dict[str, Any]) -> None:
        self.scene = scene
        self.names = [one["name"] for one in scene["coordinates"]]

    def value(self, text: str, q: list[Any], w: list[Any], t: Any) -> Any:
        words = {"t": t, **FUNCTIONS, **dict(zip(self.names, q, strict=True))}
        words |= {f"{name}_dot": rate for name, rate in zip(self.names, w, strict=True)}
        return mpf(eval(_with_doubles(text), {"mpf": mpf}, words))

    def place(self, name: str, q: list[Any], t: Any) -> Any:
        if name == "origin":
            return matrix([0, 0, 0])
        one = next(one for one in (*self.scene["bodies"], *self.scene.get("points", [])) if one["name"] == name)
        return matrix([self.value(one.get(axis, "0"), q, [0] * len(q), t) for axis in "xyz"])

    def turned(self, body: dict[str, Any], q: list[Any], t: Any) -> Any:
        turns = body.get("turns", [("z", body["angle"])] if "angle" in body else [])
        whole = eye(3)
        for axis, text in turns:
            angle = self.value(text, q, [0] * len(q), t)
            j, k = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
            turn = eye(3)
            turn[j, j], turn[j, k], turn[k, j], turn[k, k] = cos(angle), -sin(angle), sin(angle), cos(angle)
            whole = whole * turn
        return whole


def _with_doubles(text: str) -> str:
    """Every number of a formula as the double that it is read as."""
    out, at = "", 0
    while at < len(text):
        end = at
        while end < len(text) and (text[end].isdigit() or text[end] == "." or (end > at and text[end] == "e")
                                   or (end > at and text[end] == "-" and text[end - 1] == "e")):  # fmt: skip
            end += 1
        if end > at and not (at and (text[at - 1].isalnum() or text[at - 1] == "_")):
            out += f"mpf(float({text[at:end]!r}))"
        else:
            end = max(end, at + 1)
            out += text[at:end]
        at = end
    return out


def slope(function: Any) -> Any:
    """A first derivative at zero."""
    return (function(STEP) - function(-STEP)) / (2 * STEP)


def shifted(values: list[Any], k: int, by: Any) -> list[Any]:
    return [x + by if i == k else x for i, x in enumerate(values)]


def along(values: list[Any], rates: list[Any], by: Any) -> list[Any]:
    return [x + by * rate for x, rate in zip(values, rates, strict=True)]


def dot(a: Any, b: Any) -> Any:
    return sum(a[k] * b[k] for k in range(3))


class Instant:
    """Energies, forces and equations of a scene."""

    def __init__(self, scene: dict[str, Any], choices: dict[str, Any]) -> None:
        self.f = Formulas(scene)
        self.scene = scene
        self.up = "xyz".find(choices.get("up", "y")) if choices.get("up") != "none" else -1

    def spin(self, body: dict[str, Any], q: list[Any], w: list[Any], t: Any) -> Any:
        """The vector of Ṙ·Rᵀ."""
        ahead, behind = (self.f.turned(body, along(q, w, s), t + s) for s in (STEP, -STEP))
        whole = ((ahead - behind) / (2 * STEP)) * self.f.turned(body, q, t).T
        return matrix([whole[2, 1], whole[0, 2], whole[1, 0]])

    def kinetic(self, q: list[Any], w: list[Any], t: Any) -> Any:
        total = mpf(0)
        for body in self.scene["bodies"]:
            velocity = self.velocity(body["name"], q, w, t)
            total += exact(body["mass"]) * dot(velocity, velocity) / 2
            moments = body.get("moments", ["0", "0", body.get("inertia", "0")])
            if any(map(float, moments)):
                own = self.f.turned(body, q, t).T * self.spin(body, q, w, t)
                total += sum(exact(m) * own[k] ** 2 for k, m in enumerate(moments)) / 2
        return total

    def velocity(self, name: str, q: list[Any], w: list[Any], t: Any) -> Any:
        ahead, behind = (self.f.place(name, along(q, w, s), t + s) for s in (STEP, -STEP))
        return (ahead - behind) / (2 * STEP)

    def length(self, spring: dict[str, Any], q: list[Any], t: Any) -> Any:
        way = self.f.place(spring["end"], q, t) - self.f.place(spring["start"], q, t)
        return sqrt(dot(way, way))

    def potential(self, q: list[Any], t: Any) -> Any:
        total = mpf(0)
        if self.up >= 0:
            for body in self.scene["bodies"]:
                total += exact(body["mass"]) * GRAVITY * self.f.place(body["name"], q, t)[self.up]
        for one in self.scene.get("springs", []):
            stretch = self.length(one, q, t) - exact(one.get("free_length", "0"))
            total += exact(one.get("stiffness", "0")) * stretch**2 / 2
        for one in self.scene.get("torsion_springs", []):
            twist = self.f.value(one["angle"], q, [0] * len(q), t) - exact(one.get("free_angle", "0"))
            total += exact(one.get("stiffness", "0")) * twist**2 / 2
        return total

    def power(self, q: list[Any], w: list[Any], u: list[Any], t: Any, now: int) -> Any:
        """Power of loads without a potential, at rates w, on the motion of rates u; `now` counts the time's share."""
        total = mpf(0)

        def moved(function: Any) -> Any:
            return slope(lambda s: function(along(q, u, s), t + now * s))

        for one in self.scene.get("forces", []):
            for k, axis in enumerate("xyz"):
                if axis in one:
                    part = moved(lambda p, s, at=one["at"], k=k: self.f.place(at, p, s)[k])
                    total += self.f.value(one[axis], q, w, t) * part
        for one in self.scene.get("torques", []):
            size = self.f.value(one["torque"], q, w, t)
            axis = [exact(x) for x in one.get("axis", ["0", "0", "1"])]
            bodies = {body["name"]: body for body in self.scene["bodies"]}
            for name, sign in ((one["body"], 1), (one.get("against"), -1)):
                if name:
                    turn = self.spin(bodies[name], q, u, t)
                    total += sign * size * dot(axis, turn) / sqrt(dot(axis, axis))
        for group, measure in (("springs", self.length), ("torsion_springs", self.twist)):
            for one in self.scene.get(group, []):
                if "damping" in one:
                    rate = slope(lambda s, one=one, m=measure: m(one, along(q, w, s), t + s))
                    total -= exact(one["damping"]) * rate * moved(lambda p, s, one=one, m=measure: m(one, p, s))
        return total

    def twist(self, spring: dict[str, Any], q: list[Any], t: Any) -> Any:
        return self.f.value(spring["angle"], q, [0] * len(q), t)

    def results(self, q: list[Any], w: list[Any], t: Any) -> dict[str, Any]:
        n = len(q)
        none = [mpf(0)] * n
        mass, active, speeds = matrix(n, n), [], []
        for r in range(n):

            def momentum(s: Any, r: int = r) -> Any:
                return slope(lambda e: self.kinetic(along(q, w, s), shifted(w, r, e), t + s))

            for s in range(n):
                mass[r, s] = slope(lambda e, r=r, s=s: slope(
                    lambda d: self.kinetic(q, shifted(shifted(w, s, e), r, d), t)))  # fmt: skip
            pull = slope(lambda e, r=r: self.potential(shifted(q, r, e), t))
            active.append(self.power(q, w, shifted(none, r, 1), t, 0) - pull)
            slope_of_kinetic = slope(lambda e, r=r: self.kinetic(shifted(q, r, e), w, t))
            speeds.append(slope_of_kinetic - slope(momentum))
        seconds = list(lu_solve(mass, matrix([a + b for a, b in zip(active, speeds, strict=True)])))
        made = {"kinetic_energy": self.kinetic(q, w, t), "potential_energy": self.potential(q, t)}
        for r in range(n):
            made |= {
                f"equations[{r}].acceleration": seconds[r], f"equations[{r}].active_force": active[r],
                f"equations[{r}].inertia_force": -active[r], f"equations[{r}].velocity_force": speeds[r],
            }  # fmt: skip
            made |= {f"mass_matrix[{r}].entries[{s}].value": mass[r, s] for s in range(n)}
        if "t" in json.dumps([one.get(axis, "") for one in self.scene["bodies"] for axis in "xyz"]).replace("sqrt", ""):

            def energy(s: Any) -> Any:
                path = [x + s * a + s * s * b / 2 for x, a, b in zip(q, w, seconds, strict=True)]
                return self.kinetic(path, along(w, seconds, s), t + s) + self.potential(path, t + s)

            made["drive_power"] = slope(energy) - self.power(q, w, w, t, 1)
        return made


FORMULAS = {"x": "m", "y": "m", "z": "m", "angle": "rad", "torque": "N*m"}


def document(scene: dict[str, Any]) -> dict[str, Any]:
    """The scene as the program's records."""
    records = {"bodies": "Body", "points": "Point", "forces": "Force", "torques": "Torque", "springs": "Spring",
               "torsion_springs": "TorsionSpring"}  # fmt: skip
    made: dict[str, Any] = {"record": "Scene", "coordinates": [
        {"record": "Turning" if "angle" in one else "Sliding"}
        | {key: {"word": value} if key == "name" else value for key, value in one.items()}
        for one in scene["coordinates"]
    ]}  # fmt: skip
    for group, name in records.items():
        if group in scene:
            made[group] = [{"record": name} | {key: _part(key, value, name) for key, value in one.items()}
                           for one in scene[group]]  # fmt: skip
    return made


def _part(key: str, value: Any, of: str) -> Any:
    if key == "turns":
        return [{"record": "Turn", "axis": {"word": axis}, "angle": _formula(text, "rad")} for axis, text in value]
    if key in FORMULAS:
        return _formula(value, "N" if of == "Force" else FORMULAS[key])
    return {"word": value} if key in ("name", "at", "start", "end", "body", "against") else value


def _formula(text: str, unit: str) -> dict[str, Any]:
    return {"record": "Formula", "text": {"word": text}, "factor": 1.0, "unit": {"word": unit}}


def turning(name: str, angle: str, rate: str = "0.0") -> dict[str, str]:
    return {"name": name, "angle": angle, "rate": rate}


def sliding(name: str, position: str, velocity: str = "0.0") -> dict[str, str]:
    return {"name": name, "position": position, "velocity": velocity}


def cart(x: dict[str, str], angle: dict[str, str], block: str = "2.0", rod: str = "1.0") -> dict[str, Any]:
    """A block on a rail and spring with a rod of 0.8 m on it."""
    return {
        "coordinates": [x, angle],
        "bodies": [
            {"name": "block", "mass": block, "x": "x", "y": "0"},
            {"name": "rod", "mass": rod, "inertia": "0.0533", "x": "x + 0.4*sin(q)", "y": "-0.4*cos(q)", "angle": "q"},
        ],
        "forces": [{"name": "push", "at": "block", "x": "3*sin(2*t) - 0.5*x_dot"}],
        "springs": [{"name": "spring", "start": "origin", "end": "block", "stiffness": "50.0", "damping": "4.0"}],
    }


def rods(first: dict[str, str], second: dict[str, str], masses: tuple[str, str] = ("1.0", "2.0")) -> dict[str, Any]:
    """Two rods on pins with a torsion spring between them and a motor."""
    return {
        "coordinates": [first, second],
        "bodies": [
            {"name": "upper", "mass": masses[0], "inertia": "0.02", "x": "0.25*sin(a)", "y": "-0.25*cos(a)",
             "angle": "a"},
            {"name": "lower", "mass": masses[1], "inertia": "0.03", "x": "0.5*sin(a) + 0.3*sin(b)",
             "y": "-0.5*cos(a) - 0.3*cos(b)", "angle": "b"},
        ],
        "torques": [{"name": "motor", "body": "lower", "against": "upper", "torque": "1.5 - 0.2*(b_dot - a_dot)"}],
        "torsion_springs": [{"name": "pin", "angle": "b - a", "stiffness": "3.0", "free_angle": "0.1",
                             "damping": "0.05"}],
    }  # fmt: skip


def bead(position: str, velocity: str) -> dict[str, Any]:
    """A bead on the lower half of a circle, by its abscissa."""
    return {"coordinates": [sliding("x", position, velocity)],
            "bodies": [{"name": "bead", "mass": "0.3", "x": "x", "y": "-sqrt(1 - x*x)"}]}  # fmt: skip


def tube(r: str, v: str, speed: str) -> dict[str, Any]:
    """A particle in a tube that turns about an upright axis at a given speed, held by a spring."""
    return {"coordinates": [sliding("r", r, v)],
            "bodies": [{"name": "ball", "mass": "0.2", "x": f"r*cos({speed}*t)", "y": f"r*sin({speed}*t)"}],
            "springs": [{"name": "spring", "start": "origin", "end": "ball", "stiffness": "40.0",
                         "free_length": "0.25"}]}  # fmt: skip


def polar(r: str, v: str, w: str) -> dict[str, Any]:
    """A particle in a plane by polar coordinates, pulled to a peg."""
    return {"coordinates": [sliding("r", r, v), turning("q", "0.7", w)],
            "bodies": [{"name": "puck", "mass": "1.5", "x": "r*cos(q)", "y": "r*sin(q)"}],
            "points": [{"name": "peg", "x": "0.5", "y": "0"}],
            "springs": [{"name": "band", "start": "peg", "end": "puck", "stiffness": "20.0", "free_length": "0.1",
                         "damping": "0.3"}]}  # fmt: skip


def top(tilt: str, spin: str, turn: str) -> dict[str, Any]:
    """A heavy top by Euler's angles."""
    return {"coordinates": [turning("psi", "0.4", turn), turning("theta", tilt, "0.3"), turning("phi", "1.1", spin)],
            "bodies": [{"name": "top", "mass": "0.5", "x": "0.06*sin(theta)*sin(psi)",
                        "y": "-0.06*sin(theta)*cos(psi)", "z": "0.06*cos(theta)",
                        "turns": [("z", "psi"), ("x", "theta"), ("z", "phi")],
                        "moments": ["0.0007", "0.0008", "0.0006"]}]}  # fmt: skip


def drawn(low: float, high: float) -> str:
    return repr(round(RANDOM.uniform(low, high), 3))


def scenes() -> Any:
    """Scenes with the time, choices and why they are hard."""
    yield "cart", cart(sliding("x", "0.1", "0.5"), turning("q", "0.5", "2.0")), "0.5", {}, ""
    yield "cart, upside down", cart(sliding("x", "-0.2", "1.5"), turning("q", "3.0", "-4.0")), "1.5", {}, ""
    yield "bead", bead("0.3", "0.7"), "0.0", {}, ""
    yield "tube", tube("0.4", "0.3", "5.0"), "0.3", {"up": "none"}, ""
    yield "polar", polar("0.9", "0.4", "1.5"), "0.0", {"up": "none"}, ""
    yield "top", top("0.5", "200.0", "2.5"), "0.0", {"up": "z"}, ""
    for nth in range(6):
        pair = (turning("a", drawn(-3, 3), drawn(-5, 5)), turning("b", drawn(-3, 3), drawn(-5, 5)))
        yield f"drawn rods {nth}", rods(*pair), "0.0", {}, ""
    pair = (turning("a", "0.4", "2.0"), turning("b", "-0.9", "3.0"))
    yield ("light before heavy", rods(*pair, ("1e-6", "1e6")), "0.0", {},
           "a rod of a milligram carries a thousand tonnes: the mass matrix is graded by twelve orders")  # fmt: skip
    yield ("heavy before light", cart(sliding("x", "0.1", "0.5"), turning("q", "0.5", "2.0"), "1e8", "1e-8"), "0.5", {},
           "the rod's mass is lost beside that of the block in the sum of the mass matrix")  # fmt: skip
    yield ("still rods", rods(turning("a", "1e-9", "1e-9"), turning("b", "-1e-9", "1e-9")), "0.0", {},
           "all but at rest: weight and spring leave forces a billion times smaller than their parts")  # fmt: skip
    yield ("folded rods", rods(turning("a", "0.3", "1e5"), turning("b", "0.3000001", "1e5")), "0.0", {},
           "two rods in line at a high common speed: centripetal terms are large and differ by little")  # fmt: skip
    yield ("bead near the side", bead("0.9999999", "1e-4"), "0.0", {},
           "the formula's slope grows without end where the circle stands upright, and 1 − x² cancels")  # fmt: skip
    yield ("bead at the bottom", bead("1e-8", "2.0"), "0.0", {},
           "the slope all but vanishes at the bottom, and the acceleration is what speed and weight leave")  # fmt: skip
    yield ("tube held", tube("0.25000001", "0.0", "14.142135623730951"), "1000.0", {"up": "none"},
           "the spring is stretched by a hundred millionth of a metre, after thousands of turns")  # fmt: skip
    yield ("tube in balance", tube("0.4", "0.0", "8.660254037844387"), "0.1", {"up": "none"},
           "the spring's pull and the centripetal force cancel to the last digits of the speed")  # fmt: skip
    yield ("polar near the pole", polar("1e-7", "0.4", "1e4"), "0.0", {"up": "none"},
           "near the pole the angle moves next to nothing: its entry of the mass matrix is 1.5e-14")  # fmt: skip
    yield ("upright top", top("1e-6", "400.0", "0.1"), "0.0", {"up": "z"},
           "two of Euler's angles all but turn about one axis: the mass matrix is nearly singular")  # fmt: skip
    yield ("level top", top("1.5707963", "200.0", "0.0"), "0.0", {"up": "z"},
           "without precession and all but level, the gyroscopic moment stands alone beside the weight")  # fmt: skip


def equations() -> Any:
    for name, scene, time, choices, why in scenes():
        with mp.workdps(150):
            q = [exact(one.get("angle", one.get("position"))) for one in scene["coordinates"]]
            w = [exact(one.get("rate", one.get("velocity"))) for one in scene["coordinates"]]
            results = Instant(scene, choices).results(q, w, exact(time))
            # what vanishes does so for all digits
            results = {key: value if abs(value) > mpf(10) ** -50 else mpf(0) for key, value in results.items()}
            made = {key: text(value) for key, value in results.items()}
        yield case("equations", name, why, {"scene": document(scene), "time": time}, choices, made)


def text(value: Any) -> str:
    return nstr(value, 40, min_fixed=1, max_fixed=0)


def case(task: str, name: str, why: str, inputs: Any, choices: Any, results: Any) -> dict[str, Any]:
    return {"task": task, "kind": "hard" if why else "ordinary", "name": name, **({"why": why} if why else {}),
            "inputs": inputs, **({"choices": choices} if choices else {}), "results": results}  # fmt: skip


CHAINS: "list[tuple[str, list[str], list[str], list[str], list[str], list[str], str, str]]" = [
    ("two rods", ["1.0", "1.0"], ["1.0", "1.0"], ["0.0", "0.0"], ["0.5", "0.25"], ["0.0", "0.0"], "1.0", ""),
    ("a double pendulum", ["1.0", "0.6"], ["0.0", "0.0"], ["1.0", "2.0"], ["1.5", "1.0"], ["0.0", "0.0"], "1.0", ""),
    ("three rods", ["0.5", "0.5", "0.5"], ["1.0", "1.0", "1.0"], ["0.0", "0.0", "0.0"], ["0.5", "-0.25", "0.75"],
     ["0.0", "0.0", "0.0"], "0.5", ""),
    ("near the top", ["1.0", "1.0"], ["1.0", "1.0"], ["0.0", "0.0"], ["3.125", "3.125"], ["0.0", "0.0"], "1.0",
     "let go beside the unstable equilibrium: errors of the start grow before anything moves"),
    ("a light end", ["1.0", "1.0"], ["0.0", "0.0"], ["1.0", "1e-6"], ["1.0", "-1.0"], ["0.0", "0.0"], "1.0",
     "the light mass is lost beside the heavy one in the sums of the mass matrix"),
    ("whirled", ["0.5", "0.5"], ["1.0", "1.0"], ["0.0", "0.0"], ["0.0", "0.1"], ["40.0", "40.0"], "0.25",
     "whole turns with pull a hundred times the weight: phases are sums of many radians"),
]  # fmt: skip


def product(a: list[Any], b: list[Any], k: int) -> Any:
    """The coefficient k of a product of two series."""
    return fdot(a[: k + 1], b[k::-1])


def circle(u: list[Any], sine: list[Any], cosine: list[Any], k: int) -> None:
    """The coefficient k of the sine and the cosine of a series."""
    if k == 0:
        sine.append(sin(u[0]))
        cosine.append(cos(u[0]))
        return
    slope = [j * u[j] for j in range(1, k + 1)]
    rise, fall = fdot(slope, cosine[k - 1 :: -1]) / k, fdot(slope, sine[k - 1 :: -1]) / k
    sine.append(rise)
    cosine.append(-fall)


def stepped(weights: Any, pulls: list[Any], q: list[Any], w: list[Any], most: Any) -> tuple[Any, list[Any], list[Any]]:
    """One step of Σ_j A_ij·(q̈_j·cos(q_i − q_j) + q̇_j²·sin(q_i − q_j)) + B_i·sin q_i = 0 by its Taylor series."""
    n = len(q)
    places, rates, seconds = [[x] for x in q], [[x] for x in w], [[] for _ in q]
    pairs = [(i, j) for i in range(n) for j in range(n)]
    apart = {pair: ([], [], []) for pair in pairs}
    upright: list[Any] = [([], []) for _ in q]
    squares: list[list[Any]] = [[] for _ in q]
    inverse = matrix(n, n)
    for k in range(TERMS):
        for i, j in pairs:
            way, sine, cosine = apart[i, j]
            way.append(places[i][k] - places[j][k])
            circle(way, sine, cosine, k)
        right = []
        for i in range(n):
            circle(places[i], *upright[i], k)
            squares[i].append(product(rates[i], rates[i], k))
        for i in range(n):
            total = -pulls[i] * upright[i][0][k]
            for j in range(n):
                _, sine, cosine = apart[i, j]
                total -= weights[i, j] * product(squares[j], sine, k)
                total -= weights[i, j] * fdot(seconds[j], cosine[k:0:-1])
            right.append(total)
        if k == 0:
            inverse = matrix(n, n)
            for i, j in pairs:
                inverse[i, j] = weights[i, j] * apart[i, j][2][0]
            inverse = inverse**-1
        for i in range(n):
            seconds[i].append(sum(inverse[i, j] * right[j] for j in range(n)))
            places[i].append(rates[i][k] / (k + 1))
            rates[i].append(seconds[i][k] / (k + 1))
    # as far as the last terms are nothing beside the rate's size
    size = max(abs(x) for x in (*w, sqrt(GRAVITY)))
    last = max((abs(one[k]) / size) ** (mpf(1) / k) for one in rates for k in (TERMS - 1, TERMS))
    step = min(mpf(10) ** (-mpf(DIGITS) / TERMS) / last, most)
    place, rate = ([fdot(one, [step**k for k in range(len(one))]) for one in group] for group in (places, rates))
    return step, place, rate


def carried(lengths: list[Any], rods: list[Any], points: list[Any]) -> tuple[Any, list[Any]]:
    """A_ij and B_i of the masses on a chain."""
    n = len(lengths)
    weights, pulls = matrix(n, n), [mpf(0)] * n
    held, turned = masses(lengths, rods, points)
    for i in range(n):
        weights[i, i] += turned[i]
    for mass, arms in held:
        for i in range(n):
            pulls[i] += GRAVITY * mass * arms[i]
            for j in range(n):
                weights[i, j] += mass * arms[i] * arms[j]
    return weights, pulls


def chains() -> Any:
    with mp.workdps(56):
        for name, lengths, rods, ends, angles, rates, duration, why in CHAINS:
            sizes = [[exact(x) for x in part] for part in (lengths, rods, ends)]
            start = [exact(x) for x in (*angles, *rates)]
            n = len(lengths)
            place, rate, left, system = start[:n], start[n:], exact(duration), carried(*sizes)
            while left:
                step, place, rate = stepped(*system, place, rate, left)
                left -= step
            results = {f"rods[{k}].angle": text(place[k]) for k in range(n)}
            results |= {f"rods[{k}].rate": text(rate[k]) for k in range(n)}
            inputs = {"lengths": lengths, "masses": rods, "end_masses": ends, "angles": angles, "rates": rates,
                      "duration": duration}  # fmt: skip
            yield case("chain", name, why, inputs, {}, results)


MODES = [
    ("two equal rods", ["1.0"] * 2, ["1.0"] * 2, ["0.0"] * 2, ""),
    ("three points", ["1.0"] * 3, ["0.0"] * 3, ["1.0"] * 3, ""),
    ("rods with ends", ["0.4", "0.9", "0.3"], ["2.0", "0.5", "1.0"], ["1.0", "3.0", "0.0"], ""),
    ("ten equal rods", ["0.1"] * 10, ["1.0"] * 10, ["0.0"] * 10, ""),
    ("light above heavy", ["1.0"] * 3, ["0.0"] * 3, ["1e-6", "1.0", "1e6"],
     "a light mass between strong pulls: the mass matrix rounds it away, and with it the highest frequency"),
    ("heavy above light", ["1.0"] * 3, ["0.0"] * 3, ["1e6", "1.0", "1e-6"],
     "the lowest mass is twelve orders lighter than the highest, and its mode nearly alone"),
    ("long above short", ["1000.0", "0.001"], ["1.0", "1.0"], ["0.0", "0.0"],
     "frequencies a thousand apart: the square of the lower one is lost beside that of the higher"),
    ("alike pairs", ["1.0", "1e-3", "1.0", "1e-3"], ["1.0", "1e-9", "1.0", "1e-9"], ["0.0"] * 4,
     "short links all but weightless between long rods have frequencies far above all others"),
]  # fmt: skip


def modes() -> Any:
    for name, lengths, rods, ends, why in MODES:
        with mp.workdps(60):
            squares = frequencies(*([exact(x) for x in part] for part in (lengths, rods, ends)))
            results = {}
            for k, square in enumerate(squares):
                results[f"modes[{k}].angular_frequency"] = text(sqrt(square * GRAVITY))
                results[f"modes[{k}].frequency"] = text(sqrt(square * GRAVITY) / (2 * pi))
        yield case("modes", name, why, {"lengths": lengths, "masses": rods, "end_masses": ends}, {}, results)


def main() -> None:
    """Write the cases to the file, or to the one named on the command line."""
    put("motion", ABOUT, (*equations(), *chains(), *modes()))


if __name__ == "__main__":
    main()
