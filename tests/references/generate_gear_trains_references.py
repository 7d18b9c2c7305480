"""Writes gear_trains.json: measuring sizes and root form radii to 40 digits, by other ways than the program's.

Run: python tests/references/generate_gear_trains_references.py [FILE]. The same bytes every time.

Pins: a ball pushed into the space of two helicoids, found in space from the surface's own normal. Spans: arcs
of the base circle unrolled. Chords: from coordinates. Roots: the envelope of the rack's corner in the parameter of its
circle, junction by bisection of 170 steps.
"""

import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from case_files import put
from found_cases import doubles, found
from mpmath import acos, atan, atan2, cos, floor, matrix, mp, mpf, pi, sin, sqrt, tan

TWENTY = 0.3490658503988659
Case = tuple[str, str, str, dict[str, Any]]
mp.dps = 60


class Flank:
    """One side of a tooth as a helicoid in space, from the definition of the involute."""

    def __init__(self, g: dict[str, Any]) -> None:
        self.z, self.m = g["teeth"], mpf(g["module"])
        self.alpha, self.beta, self.x = mpf(g["pressure_angle"]), mpf(g["helix_angle"]), mpf(g["profile_shift"])
        self.internal = g.get("internal", False)
        self.r = self.z * self.m / (2 * cos(self.beta))
        self.at = atan(tan(self.alpha) / cos(self.beta))
        self.rb = self.r * cos(self.at)
        # lead per radian: a point climbs by this while it turns by one
        self.climb = self.r / tan(self.beta) if self.beta else None
        thick = self.m * (pi / 2 + 2 * self.x * tan(self.alpha)) / cos(self.beta)
        inv = tan(self.at) - self.at
        # ISO's sign makes positive shift thicken both teeth; a space of an internal gear is what is left of the pitch
        tooth = thick / (2 * self.r)
        self.solid = (pi / self.z - tooth if self.internal else tooth) + inv
        self.hollow = pi / self.z - self.solid
        self.tooth_pitch = tooth

    def point(self, t: Any) -> tuple[Any, Any]:
        """The involute in the plane, its base point on the x-axis: string unwound from the base circle."""
        return self.rb * (cos(t) + t * sin(t)), self.rb * (sin(t) - t * cos(t))

    def normal(self, t: Any) -> Any:
        """The unit normal in space of the helicoid through that curve, away from the material of an external tooth."""
        tx, ty = cos(t), sin(t)
        if self.climb is None:
            return matrix([ty, -tx, 0])
        # tangent along the curve × tangent of the screw
        px, py = self.point(t)
        screw = matrix([-py, px, self.climb])
        along = matrix([tx, ty, 0])
        n = matrix(
            [
                along[1] * screw[2] - along[2] * screw[1],
                along[2] * screw[0] - along[0] * screw[2],
                along[0] * screw[1] - along[1] * screw[0],
            ]
        )
        return n / sqrt(n[0] ** 2 + n[1] ** 2 + n[2] ** 2)


def ball(g: dict[str, Any]) -> dict[str, Any]:
    """Size over balls: where a ball touches the helicoid while its centre stands in the middle of the space."""
    f = Flank(g)
    size = mpf(g["pin"])
    # the involute leaves the base circle this far from the middle of the space it bounds
    side = 1 if not f.internal else -1
    middle = -f.hollow if not f.internal else f.solid

    def centre(t: Any) -> Any:
        px, py = f.point(t)
        n = f.normal(t)
        return matrix([px, py, 0]) + side * n * size / 2

    def lean(t: Any) -> Any:
        c = centre(t)
        turned = c[2] / f.climb if f.climb is not None else mpf(0)
        return atan2(c[1], c[0]) - turned - middle

    # the involute turns away anticlockwise; the middle of an external gear's space lies clockwise of it
    t = bisect(lean, mpf(0), mpf(3))
    c = centre(t)
    radius = sqrt(c[0] ** 2 + c[1] ** 2)
    px, py = f.point(t)
    odd = cos(pi / (2 * f.z)) if f.z % 2 else 1
    over = 2 * radius * odd + (-size if f.internal else size)
    return {
        "pins.size": over,
        "pins.centre_diameter": 2 * radius,
        "pins.contact_diameter": 2 * sqrt(px**2 + py**2),
        "pins.pin": size,
    }


def bisect(f: Any, low: Any, high: Any) -> Any:
    below = f(low) < 0
    assert (f(high) < 0) != below
    for _ in range(230):
        middle = (low + high) / 2
        if (f(middle) < 0) == below:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def ideal(g: dict[str, Any]) -> dict[str, Any]:
    """The ball that touches at d + 2xm: by search over its diameter."""
    f = Flank(g)
    # ISO's shift goes towards the tips, which are inside in an internal gear
    ratio = (f.r + (-f.x if f.internal else f.x) * f.m) / f.rb
    wanted = sqrt(ratio**2 - 1)
    side = 1 if not f.internal else -1
    middle = -f.hollow if not f.internal else f.solid

    def lean(size: Any) -> Any:
        px, py = f.point(wanted)
        c = matrix([px, py, 0]) + side * f.normal(wanted) * size / 2
        turned = c[2] / f.climb if f.climb is not None else mpf(0)
        return atan2(c[1], c[0]) - turned - middle

    small, large = f.m / 100, f.m * 60
    if (lean(small) < 0) == (lean(large) < 0):
        return {}  # the flanks part so widely that no ball touches both there
    return {"pins.ideal_pin": bisect(lean, small, large)}


def spans(g: dict[str, Any]) -> dict[str, Any]:
    """The base circle unrolled over the teeth spanned, seen square to the helix."""
    f = Flank(g)
    k = g["over"]
    base_helix = atan(tan(f.beta) * cos(f.at))
    arc = f.rb * (2 * f.solid + (k - 1) * 2 * pi / f.z)
    length = arc * cos(base_helix)
    touch = 2 * sqrt(f.rb**2 + (length * cos(base_helix) / 2) ** 2)
    out = {"span.span": length, "span.contact_diameter": touch}
    if f.beta:
        out["span.least_face_width"] = length * sin(base_helix)
    return out


def chords(g: dict[str, Any]) -> dict[str, Any]:
    """From the coordinates of the two corners of the tooth on the (equivalent) pitch circle."""
    f = Flank(g)
    radius = f.z * f.m / cos(f.beta) ** 3 / 2
    normal = f.tooth_pitch * f.r * cos(f.beta)
    half = normal / radius
    tip = mpf(g["tip_diameter"]) / 2
    sag = radius - radius * cos(half)
    out = {
        "normal_thickness": 2 * normal,
        "chordal.thickness": 2 * radius * sin(half),
        "chordal.height": (f.r - tip - sag) if f.internal else tip - f.r + sag,
    }
    if not f.internal:
        # a rack's flank leans by α; the foot of the normal from the pitch point on it
        foot = normal * cos(f.alpha) ** 2
        height = tip - f.r - foot * tan(f.alpha)
        if height > 0:
            out |= {"constant_chord.thickness": 2 * foot, "constant_chord.height": height}
    return out


def gear(
    teeth: int, x: float = 0.0, beta: float = 0.0, *, m: float = 0.003, alpha: float = TWENTY, **more: Any
) -> dict:
    internal = more.get("internal", False)
    r = teeth * m / 2 / float(cos(beta))
    reach = more.pop("tip", 1.0)
    shift = x
    sign = -1 if internal else 1
    g = {
        "teeth": teeth,
        "module": m,
        "pressure_angle": alpha,
        "helix_angle": beta,
        "profile_shift": x,
        "internal": internal,
        "tip_diameter": round(2.0 * (r + sign * m * (reach + shift)), 9),
        **more,
    }
    if "over" not in g:
        f = Flank(g)
        lean = atan(tan(beta) * cos(f.at))
        k = (sqrt((f.r + sign * f.x * f.m) ** 2 - f.rb**2) / cos(lean) ** 2 / f.rb - f.solid) * f.z / pi + 1
        g["over"] = max(1, int(floor(k + mpf(1) / 2)))
    if "pin" not in g:
        g["pin"] = round(1.05 * float(ideal(g).get("pins.ideal_pin", 2 * m)), 5 if m > 1e-4 else 7)
    return g


def measured(random_: random.Random) -> Iterator[Case]:
    for _ in range(24):
        teeth = random_.randint(14, 150)
        x = round(random_.uniform(-0.2, 0.6), 3)
        beta = random_.choice([0.0, round(random_.uniform(0.05, 0.6), 4)])
        m = random_.choice([0.0005, 0.002, 0.003175, 0.01])
        yield "measure", "ordinary", "", gear(teeth, x, beta, m=m, alpha=random_.choice([TWENTY, 0.4363323129985824]))
    for _ in range(6):
        teeth = random_.randint(40, 150)
        yield "measure", "ordinary", "", gear(teeth, round(random_.uniform(-0.3, 0.1), 3), internal=True)
    hard = [
        ("four teeth: undercut and nearly pointed, contact close to the base circle", gear(4, 0.45, tip=0.4)),
        ("five teeth: the ball stands far out on a steep flank, and few teeth are spanned", gear(5, 0.4, tip=0.5)),
        (
            "six teeth and a shift of 0.6 modules: nearly pointed, the tip's thickness a small difference",
            gear(6, 0.6, tip=0.3),
        ),
        ("seven teeth: no shift serves undercut and tip at once", gear(7, 0.45, tip=0.5)),
        (
            "nine teeth at 14.5 degrees: deep undercut, and a base circle so large that the flank is short",
            gear(9, 0.3, alpha=0.25307274153917776, tip=0.8),
        ),
        ("a thousand teeth: inv α_K is a small difference of small angles", gear(1000, 0.0)),
        ("a thousand teeth and an odd one: the cosine of half a pitch is one but for 1e-6", gear(1001, 0.25)),
        (
            "odd number of teeth: the balls are not opposite, the size over them is shorter by a cosine near one",
            gear(17, 0.2),
        ),
        ("shift of three modules: thickness far from half a pitch", gear(60, 3.0, tip=0.2)),
        ("negative shift of a large gear: the ball sinks to where the flank begins", gear(300, -2.0)),
        ("helix above 45 degrees: the ball touches far from the transverse plane of its centre", gear(20, 0.1, 0.9)),
        (
            "helix of 70 degrees, like a worm's: transverse sizes are thrice the normal ones",
            gear(12, 0.0, 1.2217304763960306),
        ),
        ("helix of a hundredth of a degree: must join the spur gear", gear(30, 0.1, 1.7453292519943296e-4)),
        (
            "helix of 1e-9 rad: its cosine is one, its tangent is not zero, and sizes are a spur gear's",
            gear(30, 0.1, 1e-9),
        ),
        (
            "pressure angle of 30 degrees: the involute is more than three times that of 20, the base circle small",
            gear(18, 0.1, alpha=0.5235987755982988),
        ),
        (
            "pressure angle of 10 degrees: inv α is the difference of nearly equal numbers",
            gear(90, 0.0, alpha=0.17453292519943295),
        ),
        (
            "small ball, touching just above the form circle: whether it does is a small difference",
            gear(24, 0.4, pin=0.005),
        ),
        ("large ball, touching near the tip: whether it still does is a small difference", gear(24, 0.4, pin=0.0068)),
        (
            "internal with an odd number of teeth: the size between balls is "
            "longer by a cosine near one, less both radii",
            gear(71, -0.1, internal=True),
        ),
        (
            "internal with few teeth: the space closes fast, and the ball's own size decides where it lies",
            gear(36, -0.3, internal=True, tip=0.7, pin=0.0058),
        ),
        (
            "internal with a thousand teeth: the ball's involute is a small difference of small angles",
            gear(1000, 0.0, internal=True),
        ),
        (
            "internal and helical: signs of the helix and of the space change what is added and what is taken away",
            gear(60, -0.2, 0.4, internal=True, over=0),
        ),
        ("module of a hundredth of a millimetre: no tolerance may be in metres", gear(40, 0.0, m=1e-5, pin=1.7e-5)),
        ("module of a metre: no tolerance may be in metres, seen from the other end", gear(40, 0.0, m=1.0)),
    ]
    for why, g in hard:
        yield "measure", "hard", why, g


def all_sizes(g: dict[str, Any]) -> dict[str, Any]:
    out = {**chords(g), **ball(g), **ideal(g)}
    if not (g["internal"] and g["helix_angle"]):
        out |= spans(g)
    return out


def junction(c: dict[str, Any]) -> dict[str, Any]:
    """The root form radius in modules: the envelope of the corner meets the involute."""
    z = c["teeth"]
    a, b, x, hf, rho = (mpf(c[n]) for n in ("pressure_angle", "helix_angle", "shift", "dedendum", "tip_radius"))
    k = 1 / cos(b)
    r = z * k / 2
    at = atan(tan(a) * k)
    rb = r * cos(at)
    depth = hf - rho * (1 - sin(a)) - x
    xi = r * sin(at) - depth / sin(at)
    if xi >= 0:
        return {"form_radius": sqrt(rb**2 + xi**2)}
    hc = hf - rho - x
    offset = (pi / 4 - hf * tan(a) - rho * (1 - sin(a)) / cos(a)) * k
    c0 = (pi / 2 - 2 * x * tan(a)) / z - (tan(at) - at)

    def at_corner(theta: Any) -> tuple[Any, Any]:
        px, py = offset + k * rho * cos(theta), -(hc + rho * sin(theta))
        nx, ny = cos(theta), -k * sin(theta)
        shift = py * nx / ny - px
        return sqrt((shift + px) ** 2 + (r + py) ** 2), atan2(shift + px, r + py) - shift / r

    low, high = a, pi / 2
    for _ in range(190):
        middle = (low + high) / 2
        low, high = (middle, high) if at_corner(middle)[0] > rb else (low, middle)
    end = low

    def residual(theta: Any) -> Any:
        radius, eta = at_corner(theta)
        angle = acos(min(rb / radius, mpf(1)))
        return eta - c0 - (tan(angle) - angle)

    low, high = a, end
    for _ in range(190):
        middle = (low + high) / 2
        low, high = (middle, high) if residual(middle) < 0 else (low, middle)
    return {"form_radius": at_corner(low)[0]}


def cutter(z: int, x: float, *, beta: float = 0.0, alpha: float = TWENTY, hf: float = 1.25, rho: float = 0.38) -> dict:
    return {
        "teeth": z,
        "pressure_angle": alpha,
        "helix_angle": beta,
        "shift": x,
        "dedendum": hf,
        "tip_radius": rho,
    }


def roots(random_: random.Random) -> Iterator[Case]:
    for _ in range(40):
        z = random_.choice([random_.randint(5, 40), random_.randint(5, 1000)])
        x = round(random_.uniform(max(-12.0, 1.4 - z / 2), 1.0), 3)
        yield "root", "ordinary", "", cutter(z, x, beta=random_.choice([0.0, 0.0, round(random_.uniform(0.0, 1.2), 3)]))
    for z in (5, 6, 7, 8, 9, 10, 17, 25, 1000):
        yield (
            "root",
            "hard",
            "no shift: deep undercut at five teeth, micrometres of it at 17, none at 25",
            cutter(z, 0.0),
        )
        yield (
            "root",
            "hard",
            "the largest shift: the corner lies above the pitch line, its depth a difference that changes sign",
            cutter(z, 1.0),
        )
    for z in (27, 60, 200, 1000):
        yield (
            "root",
            "hard",
            "x = −12: nearly all of the involute is cut away, the junction is far out and its equation steep",
            cutter(z, -12.0),
        )
    limit = 1.0 - 17 * 0.1169777784405111 / 2
    for step in (-1e-3, -1e-5, -1e-7, -1e-9, -1e-11, -1e-13, -1e-15, 1e-15, 1e-12):
        why = "a hair from the limit of undercut: the curves touch there, and t is as small as the hair"
        yield "root", "hard", why, cutter(17, limit + step)
    yield (
        "root",
        "hard",
        "a sharp corner of the rack: its ellipse is a point, and the envelope is that point's own path",
        cutter(12, 0.0, rho=0.0),
    )
    yield (
        "root",
        "hard",
        "a full round of the rack: both corners meet, the land between them is zero but for rounding",
        cutter(12, 0.0, rho=0.47),
    )
    yield "root", "hard", "helix above 45 degrees: the corner is a long ellipse", cutter(6, -1.0, beta=1.1)
    yield "root", "hard", "helix of 1e-9: the ellipse is a circle but for rounding", cutter(9, 0.0, beta=1e-9)


def written(tree: dict[str, Any]) -> dict[str, Any]:
    return {name: repr(value) if isinstance(value, float) else value for name, value in tree.items()}


def generate() -> dict[str, Any]:
    cases = []
    for make, solve in ((measured, all_sizes), (roots, junction)):
        for index, (task, kind, why, inputs) in enumerate(make(random.Random(make.__name__))):
            case = {"task": task, "kind": kind, "name": f"{task} {index}"}
            if why:
                case["why"] = why
            results = {key: mp.nstr(value, 40) for key, value in solve(inputs).items()}
            cases.append({**case, "inputs": written(inputs), "results": results})
    for case in found("gear_trains.json"):
        solve = {"measure": all_sizes, "root": junction}[case["task"]]
        results = {key: mp.nstr(value, 40) for key, value in solve(doubles(case["inputs"])).items()}
        own = {key: case[key] for key in ("name", "why", "inputs")}
        cases.append({"task": case["task"], "kind": "hard", **own, "results": results})
    about = "Written by generate_gear_trains_references.py: SI inputs as doubles, results to 40 digits."
    return {"about": about, "cases": cases}


if __name__ == "__main__":
    put("gear_trains", **generate())
