"""Writes path.json: straight, circular and curved motion to 40 digits, for ordinary and hard inputs.

Positions are written as functions of time in fixed Cartesian axes and differentiated at 90 digits by mpmath; curvature
and torsion by Gram determinants; straight motion by the quadratic formula; closest approach by the roots of a
polynomial. Run: python tests/references/generate_path_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Callable, Iterator
from typing import Any

from case_files import DATA, put_tree
from mpmath import cos, cosh, exp, matrix, mp, mpf, nstr, pi, polyroots, quad, sin, sqrt, taylor

mp.dps = 90
ABOUT = "Written by generate_path_references.py: SI inputs as doubles, results to 40 digits from 90-digit arithmetic."
Case = tuple[str, str, str, str, dict[str, Any], dict[str, Any]]
RANDOM = random.Random(31)


def exact(text: str) -> Any:
    return mpf(float(text))


def drawn(low: float, high: float, digits: int = 3) -> str:
    return repr(round(RANDOM.uniform(low, high), digits))


def vector(texts: list[str]) -> Any:
    return matrix([exact(text) for text in texts])


def dotted(a: Any, b: Any) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def derivatives(position: Callable[[Any], list[Any]], at: Any) -> list[list[Any]]:
    """Position and its first three derivatives."""
    series = [taylor(lambda t, k=k: position(t)[k], at, 3) for k in range(3)]
    return [[mp.factorial(n) * series[k][n] for k in range(3)] for n in range(4)]


def bent(v: Any, a: Any, j: Any = None) -> dict[str, Any]:
    """Speed, parts of the acceleration, radius of curvature and torsion, without a vector product."""
    vv, va, aa = dotted(v, v), dotted(v, a), dotted(a, a)
    # Gram's determinant is the square of the area
    area = sqrt(vv * aa - va * va)
    made = {"speed": sqrt(vv), "tangential": va / sqrt(vv), "normal": area / sqrt(vv)}
    made["radius_of_curvature"] = vv * sqrt(vv) / area
    if j is not None:
        volume = mp.det(matrix([list(v), list(a), list(j)]))
        made["torsion"] = volume / (area * area)
    return made


def named(prefix: str, parts: Any) -> dict[str, Any]:
    return {f"{prefix}[{k}]": part for k, part in enumerate(parts)}


def straight() -> Iterator[Case]:
    """All ten triples of the same motions, and hard ones."""
    names = ("start_speed", "end_speed", "acceleration", "distance", "time")
    for nth in range(6):
        u, a, t = drawn(-5, 30), drawn(0.2, 6) if nth % 2 else drawn(-6, -0.2), drawn(0.5, 9)
        v, s = exact(u) + exact(a) * exact(t), exact(u) * exact(t) + exact(a) * exact(t) ** 2 / 2
        five = dict(zip(names, (u, repr(float(v)), a, repr(float(s)), t), strict=True))
        for i in range(5):
            for j in range(i):
                given = {name: five[name] for k, name in enumerate(names) if k not in (i, j)}
                made = solved({name: exact(text) for name, text in given.items()})
                if made is not None:
                    yield "rectilinear", "ordinary", f"motion {nth} by {' '.join(given)}", "", _phase(given), made
    hard = (
        (
            "acceleration all but zero",
            "20.0",
            "1e-14",
            "100.0",
            "the quadratic formula (−u + √)/a cancels: speeds differ by 2e-15",
        ),
        (
            "stops just beyond",
            "20.0",
            "-4.0",
            "49.9999",
            "both passages are near the stop, where the speed is a small root",
        ),
        (
            "stops a hair beyond",
            "20.0",
            "-4.0",
            "49.99999999999",
            "the square under the root cancels but for its last digits",
        ),
        ("stops at", "20.0", "-4.0", "50.0", "the square under the root is zero: one passage, not two"),
        ("large and small", "1e8", "-1e-8", "3.0", "squares of the speeds differ in the 17th digit only"),
    )
    for name, u, a, s, why in hard:
        given = {"start_speed": u, "acceleration": a, "distance": s}
        made = solved({key: exact(text) for key, text in given.items()})
        assert made is not None
        yield "rectilinear", "hard", name, why, _phase(given), made


def _phase(given: dict[str, str]) -> dict[str, Any]:
    return {"phases": {"record": "Phase", **given}}


def laws() -> Iterator[Case]:
    """Motions under laws of the acceleration, whose closed forms are not how the program goes."""
    g = exact("9.80665")

    def fall(k: Any, t: Any) -> tuple[Any, Any]:
        top, rate = sqrt(g / k), sqrt(g * k)
        return top * mp.tanh(rate * t), mp.log(mp.cosh(rate * t)) / k

    square = "drag with the square of the speed"
    yield _law("hard", f"fall with {square}", "the speed approaches its limit, from which it differs by little",
               "9.80665 - 0.004*v^2", "0.0", "3.0",
               fall(exact("0.004"), mpf(3)))  # fmt: skip
    for k in ("1e-09", "0.01", "3.0"):
        u, t, drag = mpf(40), exact("2.5"), exact(k)
        answer = u / (1 + drag * u * t), mp.log(1 + drag * u * t) / drag
        yield _law("hard", f"{square}, k = {k}", "log(1 + ku·t)/k cancels for little drag", f"-{k}*v^2", "40.0", "2.5",
                   answer)  # fmt: skip
    for k in ("1e-07", "0.05", "4.0"):
        u, t, drag = mpf(20), mpf(3), exact(k)
        answer = u * mp.exp(-drag * t), u * (1 - mp.exp(-drag * t)) / drag
        why = "1 − e^(−kt) cancels for little drag"
        yield _law("hard", f"drag with the speed, k = {k}", why, f"-{k}*v", "20.0", "3.0",
                   answer)  # fmt: skip
    w = sqrt(mpf(40))
    spring = 2 * mp.cos(w), 2 * mp.sin(w) / w
    yield _law("ordinary", "spring", "", "-40*x", "2.0", "1.0", spring)
    yield _law(
        "ordinary", "law of the time", "", "3 - t^2", "5.0", "2.0", (mpf(5) + 6 - mpf(8) / 3, mpf(16) - mpf(4) / 3)
    )


def _law(kind: str, name: str, why: str, text: str, speed: str, time: str, answer: tuple[Any, Any]) -> Case:
    law = {"record": "Formula", "text": {"word": text}, "factor": 1.0, "unit": {"word": "m/s^2"}}
    inputs = {"phases": {"record": "Phase", "start_speed": speed, "time": time}, "law": law}
    return "rectilinear_law", kind, name, why, inputs, {"end_speed": answer[0], "distance": answer[1]}


def solved(given: dict[str, Any]) -> dict[str, Any] | None:
    """The earliest motion, by the quadratic formula; None where time is negative or nothing fits."""
    g = given.get
    u, v, a, s, t = (g(name) for name in ("start_speed", "end_speed", "acceleration", "distance", "time"))
    if t is None:
        if s is None:
            t = (v - u) / a
        elif a is None:
            t = 2 * s / (u + v)
        else:
            # s = ut + at²/2, or from the end s = vt − at²/2
            linear, square = (u, a) if u is not None else (v, -a)
            under = linear * linear + 2 * square * s
            if under < 0:
                return None
            roots = sorted((-linear + sign * sqrt(under)) / square for sign in (1, -1))
            later = [root for root in roots if root >= 0]
            if not later:
                return None
            t = later[0]
    if t <= 0:
        return None
    if a is None:
        a = (
            (v - u) / t
            if u is not None and v is not None
            else 2 * (s - u * t) / t**2
            if u is not None
            else 2 * (v * t - s) / t**2
        )
    if u is None:
        u = v - a * t if v is not None else s / t - a * t / 2
    return {"start_speed": u, "end_speed": u + a * t, "acceleration": a, "distance": u * t + a * t * t / 2, "time": t}


def circles() -> Iterator[Case]:
    for nth in range(8):
        inputs = {
            "radius": drawn(0.05, 40),
            "state": {"record": "Turning", "angular_velocity": drawn(1, 90), "angular_acceleration": drawn(0.1, 9)},
            "time": drawn(0.1, 5),
        }
        yield _circle("ordinary", f"time, {nth}", "", inputs)
        inputs = {
            "radius": drawn(5, 90),
            "state": {"record": "Running", "speed": drawn(5, 30), "speed_rate": drawn(0.1, 3)},
            "arc": drawn(1, 90),
        }
        yield _circle("ordinary", f"arc, {nth}", "", inputs)
    slow = {
        "radius": "2.0",
        "state": {"record": "Turning", "angular_velocity": "3.0", "angular_acceleration": "-1e-15"},
        "angle": "1.0",
    }
    yield _circle("hard", "all but uniform", "the change of speed is below a last bit of the speed", slow)


def _circle(kind: str, name: str, why: str, inputs: dict[str, Any]) -> Case:
    r, state = exact(inputs["radius"]), inputs["state"]
    if state["record"] == "Turning":
        omega, alpha = exact(state["angular_velocity"]), exact(state["angular_acceleration"])
    else:
        omega, alpha = exact(state["speed"]) / r, exact(state["speed_rate"]) / r
    if "time" in inputs:
        t = exact(inputs["time"])
    else:
        angle = exact(inputs["angle"]) if "angle" in inputs else exact(inputs["arc"]) / r
        t = min(
            root
            for root in ((-omega + sign * sqrt(omega**2 + 2 * alpha * angle)) / alpha for sign in (1, -1))
            if root > 0
        )
    turn = lambda x: omega * x + alpha * x * x / 2  # noqa: E731
    _, v, a, _ = derivatives(lambda x: [r * cos(turn(x)), r * sin(turn(x)), mpf(0)], t)
    made = bent(v, a)
    results = {
        "speed": made["speed"],
        "tangential": made["tangential"],
        "normal": made["normal"],
        "acceleration": sqrt(dotted(a, a)),
        "time": t,
        "angle": turn(t),
        "arc": r * turn(t),
        "angular_velocity": omega + alpha * t,
    }
    return "circle", kind, name, why, inputs, results


def quadratic(inputs: dict[str, str], value: str, rate: str, second: str) -> Callable[[Any], Any]:
    a, b, c = (exact(inputs.get(name, "0.0")) for name in (value, rate, second))
    return lambda t: a + b * t + c * t * t / 2


def around(inputs: dict[str, str]) -> dict[str, Any]:
    r = quadratic(inputs, "radius", "radial_speed", "radial_speed_rate")
    q = quadratic(inputs, "angle", "angular_velocity", "angular_acceleration")
    z = quadratic(inputs, "height", "axial_speed", "axial_speed_rate")
    _, v, a, _ = derivatives(lambda t: [r(t) * cos(q(t)), r(t) * sin(q(t)), z(t)], mpf(0))
    c, s = cos(q(mpf(0))), sin(q(mpf(0)))
    out, beside = [c, s, mpf(0)], [-s, c, mpf(0)]
    return {
        **bent(v, a),
        "radial_velocity": dotted(v, out),
        "transverse_velocity": dotted(v, beside),
        "radial_acceleration": dotted(a, out),
        "transverse_acceleration": dotted(a, beside),
        **named("cartesian_velocity", v),
        **named("cartesian_acceleration", a),
    }


def coordinates() -> Iterator[Case]:
    ranges = {
        "radius": (0.1, 5),
        "angle": (-3, 3),
        "radial_speed": (-3, 3),
        "angular_velocity": (-6, 6),
        "radial_speed_rate": (-4, 4),
        "angular_acceleration": (-5, 5),
    }
    more = {"height": (-3, 3), "axial_speed": (-3, 3), "axial_speed_rate": (-5, 5)}
    for nth in range(8):
        inputs = {name: drawn(*ends) for name, ends in ranges.items()}
        yield "polar", "ordinary", f"drawn {nth}", "", inputs, around(inputs)
        inputs = {name: drawn(*ends) for name, ends in (ranges | more).items()}
        yield "cylindrical", "ordinary", f"drawn {nth}", "", inputs, around(inputs)
    tube = {"radius": "0.3", "radial_speed": "0.8", "angular_velocity": "5.0", "angular_acceleration": "2.0"}
    yield "polar", "ordinary", "turning tube", "", tube, around(tube)
    straight = {"radius": "1.0", "radial_speed": "300.0", "radial_speed_rate": "9.8", "angular_velocity": "1e-9"}
    yield (
        "polar",
        "hard",
        "all but straight",
        "velocity and acceleration are parallel but for 1e-10 of them",
        straight,
        around(straight),
    )
    ranges = {
        "radius": (0.1, 5),
        "polar_angle": (0.05, 3.1),
        "azimuth": (-3, 3),
        "radial_speed": (-3, 3),
        "polar_rate": (-4, 4),
        "azimuth_rate": (-4, 4),
        "radial_speed_rate": (-4, 4),
        "polar_second": (-5, 5),
        "azimuth_second": (-5, 5),
    }
    for nth in range(8):
        inputs = {name: drawn(*ends) for name, ends in ranges.items()}
        yield "spherical", "ordinary", f"drawn {nth}", "", inputs, poled(inputs)
    near = dict(inputs, polar_angle="1e-9")
    yield (
        "spherical",
        "hard",
        "beside the pole",
        "sin φ is tiny, and the azimuth all but undetermined",
        near,
        poled(near),
    )


def poled(inputs: dict[str, str]) -> dict[str, Any]:
    r = quadratic(inputs, "radius", "radial_speed", "radial_speed_rate")
    f = quadratic(inputs, "polar_angle", "polar_rate", "polar_second")
    q = quadratic(inputs, "azimuth", "azimuth_rate", "azimuth_second")
    _, v, a, _ = derivatives(
        lambda t: [r(t) * sin(f(t)) * cos(q(t)), r(t) * sin(f(t)) * sin(q(t)), r(t) * cos(f(t))], mpf(0)
    )
    sf, cf, sq, cq = (function(x(mpf(0))) for x in (f, q) for function in (sin, cos))
    axes = {"radial": [sf * cq, sf * sq, cf], "polar": [cf * cq, cf * sq, -sf], "azimuth": [-sq, cq, mpf(0)]}
    parts = {
        f"{name}_{what}": dotted(axis, of)
        for name, axis in axes.items()
        for what, of in (("velocity", v), ("acceleration", a))
    }
    return {**bent(v, a), **parts, **named("cartesian_velocity", v)}


def states() -> Iterator[Case]:
    for nth in range(8):
        inputs = {name: [drawn(-9, 9) for _ in range(3)] for name in ("velocity", "acceleration", "position", "jerk")}
        v, a, j = (vector(inputs[name]) for name in ("velocity", "acceleration", "jerk"))
        yield "components", "ordinary", f"drawn {nth}", "", inputs, bent(v, a, j)
    fast = {"velocity": ["300.0", "0.0", "0.0"], "acceleration": ["9.8", "1e-07", "0.0"]}
    yield (
        "components",
        "hard",
        "all but straight",
        "the normal part as √(a² − a_t²) cancels all digits",
        fast,
        bent(vector(fast["velocity"]), vector(fast["acceleration"])),
    )
    tilted = {"velocity": ["1.0", "2.0", "3.0"], "acceleration": ["0.1", "0.2", "0.30000000001"]}
    yield (
        "components",
        "hard",
        "all but parallel, oblique",
        "every component of the vector product cancels to 1e-11",
        tilted,
        bent(vector(tilted["velocity"]), vector(tilted["acceleration"])),
    )


PLACES: dict[str, Callable[..., list[Any]]] = {
    "Circle": lambda u, r: [r * cos(u), r * sin(u), mpf(0)],
    "Ellipse": lambda u, a, b: [a * cos(u), b * sin(u), mpf(0)],
    "Parabola": lambda u, f: [u, u * u / (4 * f), mpf(0)],
    "Projectile": lambda u, v, q, g: [v * cos(q) * u, v * sin(q) * u - g * u * u / 2, mpf(0)],
    "Helix": lambda u, r, p: [r * cos(u), r * sin(u), p * u / (2 * pi)],
    "Cycloid": lambda u, r, d=None: [r * u - (d or r) * sin(u), r - (d or r) * cos(u), mpf(0)],
    "Involute": lambda u, r: [r * (cos(u) + u * sin(u)), r * (sin(u) - u * cos(u)), mpf(0)],
    "Archimedes": lambda u, p: [p * u / (2 * pi) * cos(u), p * u / (2 * pi) * sin(u), mpf(0)],
    "Bernoulli": lambda u, a, b: [a * exp(b * u) * cos(u), a * exp(b * u) * sin(u), mpf(0)],
    "Catenary": lambda u, a: [u, a * cosh(u / a), mpf(0)],
    "Lissajous": lambda u, a, b, p, q, d: [a * sin(p * u + d), b * sin(q * u), mpf(0)],
}
WAVES = {"x_radius": "3.0", "y_radius": "2.0", "x_ratio": "3.0", "y_ratio": "2.0", "phase": "0.3"}
SHAPES: list[tuple[str, dict[str, str], str]] = [
    ("Circle", {"radius": "2.5"}, "0.7"),
    ("Ellipse", {"x_radius": "3.0", "y_radius": "2.0"}, "0.5"),
    ("Parabola", {"focal_length": "0.5"}, "0.8"),
    ("Projectile", {"launch_speed": "20.0", "launch_angle": "0.6", "gravity": "9.80665"}, "1.1"),
    ("Helix", {"radius": "3.0", "pitch": "25.132741228718345"}, "1.3"),
    ("Cycloid", {"radius": "0.3"}, "2.1"),
    ("Cycloid", {"radius": "0.3", "arm": "0.45"}, "2.1"),
    ("Involute", {"radius": "0.03"}, "0.4"),
    ("Archimedes", {"spacing": "0.1"}, "9.0"),
    ("Bernoulli", {"start_radius": "1.5", "growth": "0.2"}, "2.0"),
    ("Catenary", {"catenary_parameter": "2.0"}, "1.5"),
    ("Lissajous", WAVES, "0.9"),
]


def curves() -> Iterator[Case]:
    for name, fields, at in SHAPES:
        yield _curve("ordinary", f"{name}, {' '.join(fields)}", "", name, fields, at)
    hard = (
        ("Cycloid", {"radius": "1.0"}, "1e-06", "beside the cusp: t − sin t and 1 − cos t cancel"),
        ("Involute", {"radius": "0.03"}, "1e-07", "beside the cusp, where speed and radius vanish together"),
        (
            "Helix",
            {"radius": "1e-08", "pitch": "6.283185307179586"},
            "1.0",
            "all but straight: curvature and torsion differ by 1e8",
        ),
    )
    for name, fields, at, why in hard:
        yield _curve("hard", f"{name} at {at}", why, name, fields, at)
    clothoid = {"shape": {"record": "Clothoid", "clothoid_parameter": "1.0"}, "start": "0.0", "end": "1.0"}
    place = {
        "position[0]": quad(lambda s: cos(s * s / 2), [0, 1]),
        "position[1]": quad(lambda s: sin(s * s / 2), [0, 1]),
    }
    yield "curve", "ordinary", "Clothoid", "", clothoid, {**place, "curvature": mpf(1), "speed": mpf(1)}


def _curve(kind: str, name: str, why: str, shape: str, fields: dict[str, str], at: str) -> Case:
    numbers = [exact(text) for text in fields.values()]
    _, v, a, j = derivatives(lambda u: PLACES[shape](u, *numbers), exact(at))
    made = bent(v, a, j if shape == "Helix" else None)
    made["curvature"] = 1 / made["radius_of_curvature"]
    made |= {"acceleration_size": sqrt(dotted(a, a)), "jerk_size": sqrt(dotted(j, j))}
    inputs = {"shape": {"record": shape, **fields}, "start": at, "end": at}
    return "curve", kind, name, why, inputs, made | {f"velocity[{k}]": v[k] for k in range(3)}


def pairs() -> Iterator[Case]:
    for nth in range(10):
        first = {name: [drawn(-90, 90) for _ in range(3)] for name in ("position", "velocity")}
        second = {name: [drawn(-90, 90) for _ in range(3)] for name in ("position", "velocity")}
        if nth % 2:
            first["acceleration"], second["acceleration"] = ([drawn(-9, 9) for _ in range(3)] for _ in range(2))
        yield _pair("ordinary", f"drawn {nth}", "", first, second)
    grazing = {"position": ["1000.0", "500.0", "0.0"], "velocity": ["-10.0", "-5.000001", "0.0"]}
    yield _pair("hard", "grazing", "the difference of the positions cancels at the closest approach", {}, grazing)


def _pair(kind: str, name: str, why: str, first: dict[str, Any], second: dict[str, Any]) -> Case:
    zero = ["0.0"] * 3
    r, v, a = (
        vector(second.get(key, zero)) - vector(first.get(key, zero)) for key in ("position", "velocity", "acceleration")
    )
    parts = [dotted(a, a) / 2, 3 * dotted(v, a) / 2, dotted(v, v) + dotted(r, a), dotted(r, v)]
    while parts[0] == 0:
        parts = parts[1:]
    times = [
        mpf(0),
        *(
            root.real
            for root in polyroots(parts, maxsteps=500, extraprec=300)
            if abs(mp.im(root)) < mpf(10) ** -40 and mp.re(root) > 0
        ),
    ]
    apart = lambda t: sqrt(dotted(r + v * t + a * t * t / 2, r + v * t + a * t * t / 2))  # noqa: E731
    when = min(times, key=apart)
    inputs = {"first": {"record": "Mover", **first}, "second": {"record": "Mover", **second}}
    return (
        "relative",
        kind,
        name,
        why,
        inputs,
        {"closest_time": when, "closest_distance": apart(when), "distance": apart(0)},
    )


def frames() -> Iterator[Case]:
    names = (
        "position",
        "angular_velocity",
        "angular_acceleration",
        "relative_velocity",
        "relative_acceleration",
        "origin_velocity",
        "origin_acceleration",
    )
    for nth in range(8):
        inputs = {name: [drawn(-5, 5) for _ in range(3)] for name in names}
        r, w, alpha, vr, ar, vo, ao = (vector(inputs[name]) for name in names)
        spin = lambda x: matrix([[0, -x[2], x[1]], [x[2], 0, -x[0]], [-x[1], x[0], 0]])  # noqa: E731
        # the second derivative of the turning matrix, at the time when it is one
        turning = spin(alpha) + spin(w) * spin(w)
        v, a = vo + spin(w) * r + vr, ao + turning * r + 2 * (spin(w) * vr) + ar
        results = {
            "speed": sqrt(dotted(v, v)),
            "acceleration_size": sqrt(dotted(a, a)),
            **named("velocity", v),
            **named("acceleration", a),
        }
        yield "moving_frame", "ordinary", f"drawn {nth}", "", inputs, results


def every() -> Iterator[Case]:
    for part in (straight, laws, circles, coordinates, states, curves, pairs, frames):
        yield from part()


def main() -> None:
    cases = []
    for task, kind, name, why, inputs, results in every():
        texts = {key: nstr(value, 40, min_fixed=-8, max_fixed=18) for key, value in results.items()}
        said = {"why": why} if why else {}
        cases.append({"task": task, "kind": kind, "name": name, **said, "inputs": inputs, "results": texts})
    put_tree(DATA / "path.json", {"about": ABOUT, "cases": cases})


if __name__ == "__main__":
    main()
