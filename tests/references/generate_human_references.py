"""Writes human.json: body segments, postures, joint moments, limbs, falls and solids to 40 digits.

Figures are chains of complex numbers, moments of joints come from the change of potential energy when what is beyond
the joint turns, those of moving limbs from one sum over everything beyond, falls and solids by quadrature; the program
has components, recursions, Carlson's integrals and Gauss's rule. Numbers of tables count as doubles. The table of
segments is typed anew, from BMClab/BMC, data/BSPmale_ZdeLeva.txt and BSPfemale_ZdeLeva.txt.
Run: python tests/references/generate_human_references.py [FILE]. The same bytes every time.
"""

import math
import random
from collections.abc import Iterator
from typing import Any

from case_files import write
from mpmath import cos, diff, mp, mpc, mpf, pi, quad, sin, sqrt

mp.dps = 60
ABOUT = "Written by generate_human_references.py: SI inputs as doubles, results to 40 digits from 60-digit arithmetic."
Case = tuple[str, str, str, dict[str, Any], dict[str, Any]]
RANDOM = random.Random(1955)
GRAVITY = mpf(9.80665)
# mass, centroid, radii about the front-back, left-right and long axes; vertex-cervicale and cervicale-hip
TABLE = {
    "male": """head 0.0694 0.5002 0.303 0.315 0.261
trunk 0.4346 0.5138 0.328 0.306 0.169
upper_arm 0.0271 0.5772 0.285 0.269 0.158
forearm 0.0162 0.4574 0.276 0.265 0.121
hand 0.0061 0.79 0.628 0.513 0.401
thigh 0.1416 0.4095 0.329 0.329 0.149
shank 0.0433 0.4395 0.251 0.246 0.102
foot 0.0137 0.4415 0.257 0.245 0.124""",
    "female": """head 0.0668 0.4841 0.271 0.295 0.261
trunk 0.4257 0.4964 0.307 0.292 0.147
upper_arm 0.0255 0.5754 0.278 0.26 0.148
forearm 0.0138 0.4559 0.261 0.257 0.094
hand 0.0056 0.7474 0.531 0.454 0.335
thigh 0.1478 0.3612 0.369 0.364 0.162
shank 0.0481 0.4352 0.267 0.263 0.092
foot 0.0129 0.4014 0.299 0.279 0.139""",
}
ROWS = {
    sex: {line.split()[0]: [mpf(float(number)) for number in line.split()[1:]] for line in text.splitlines()}
    for sex, text in TABLE.items()
}
ORDER = ("head", "trunk", "upper_arm", "forearm", "hand", "thigh", "shank", "foot")
PAIRS = ("upper arm", "forearm", "hand", "thigh", "shank", "foot", "shoulder")
DEMPSTER = (
    ("chest", "11"), ("abdomen and pelvis", "26.4"), ("head and neck", "7.9"), ("shoulder", "5.15"),
    ("upper arm", "2.65"), ("forearm", "1.55"), ("hand", "0.6"), ("thigh", "9.65"), ("shank", "4.5"), ("foot", "1.4"),
)  # fmt: skip
ZATSIORSKY = """foot -.829 .0077 .0073
shank -1.592 .0362 .0121
thigh -2.649 .1463 .0137
hand -.1165 .0036 .00175
forearm .3185 .01445 -.00114
upper arm .250 .03012 -.0027
head 1.296 .0171 .0143
thorax 8.2144 .1862 -.0584
abdomen 7.181 .2234 -.0663
pelvis -7.498 .0976 .04896"""
LENGTHS = {
    "head": "0.24", "trunk": "0.6", "shoulder": "0.5", "upper_arm": "0.28", "forearm": "0.27", "hand": "0.085",
    "thigh": "0.42", "shank": "0.43", "foot": "0.26",
}  # fmt: skip


def exact(text: str) -> Any:
    return mpf(float(text))


def degrees(angle: float) -> str:
    return repr(math.radians(angle))


def drawn(low: float, high: float, digits: int = 3) -> str:
    return repr(round(RANDOM.uniform(low, high), digits))


def segments() -> Iterator[Case]:
    for nth, (sex, mass) in enumerate((("male", "75.0"), ("female", "61.5"), ("male", drawn(50, 110)))):
        lengths = {name: LENGTHS[name] for name in ("upper_arm", "forearm", "thigh", "shank", "foot")}
        results = {}
        for at, name in enumerate(ORDER):
            share, centroid, *radii = ROWS[sex][name]
            own = share * exact(mass)
            results[f"segments[{at}].mass"] = own
            if name in lengths:
                span = exact(lengths[name])
                results[f"segments[{at}].centroid"] = centroid * span
                for axis, radius in zip(("front_back", "left_right", "lengthwise"), radii, strict=True):
                    results[f"segments[{at}].{axis}"] = own * (radius * span) ** 2
        inputs = {"mass": mass, "sex": {"word": sex}, "size": {"record": "Lengths", **lengths}}
        yield "segments", f"de Leva {nth}", "", inputs, results
    inputs = {"mass": "80.0", "segment_table": {"word": "dempster"}, "normalise": True, "size": {"record": "Lengths"}}
    shares = {name: exact(repr(round(float(text) / 100, 6))) for name, text in DEMPSTER}
    lost = sum(shares.values()) + sum(share for name, share in shares.items() if name in PAIRS)
    results = {"sum": lost, "mass": mpf(80), "segments[2].share": shares["head and neck"] / lost}
    yield "segments", "Dempster rescaled", "what a dissection lost is given back to all segments", inputs, results
    inputs = {
        "mass": "60.0", "segment_table": {"word": "zatsiorsky"}, "size": {"record": "Height", "height": "1.65"},
    }  # fmt: skip
    masses = {
        name: exact(b0) + exact(b1) * 60 + exact(b2) * (100 * exact("1.65"))
        for name, b0, b1, b2 in (line.rsplit(" ", 3) for line in ZATSIORSKY.splitlines())
    }
    whole = sum(masses.values()) + sum(mass for name, mass in masses.items() if name in PAIRS)
    yield "segments", "Zatsiorsky", "", inputs, {"mass": whole, "segments[7].mass": masses["thigh"]}


class Chain:
    """A figure in the side view as complex numbers; both sides together."""

    def __init__(self, sex: str, mass: str, lengths: dict[str, str], angles: dict[str, str]) -> None:
        self.rows, self.mass = ROWS[sex], exact(mass)
        self.spans = {name: exact(text) for name, text in lengths.items()}
        self.angles = {name: exact(text) for name, text in angles.items()} | {"foot": mpf(0)}
        self.joints = self.placed()

    def way(self, name: str, turned: dict[str, Any]) -> Any:
        """A step along a segment whose angle is turned by so much."""
        angle = self.angles[name] + turned.get(name, 0)
        return mpc(cos(angle), sin(angle))

    def placed(self, turned: "dict[str, Any] | None" = None) -> dict[str, Any]:
        turn = turned or {}
        heel = mpc(-exact("0.06"), 0)
        ankle = mpc(0, exact("0.08"))
        knee = ankle + self.spans["shank"] * self.way("shank", turn)
        hip = knee + self.spans["thigh"] * self.way("thigh", turn)
        neck = hip + self.spans["trunk"] * self.way("trunk", turn)
        shoulder = hip + self.spans["shoulder"] * self.way("trunk", turn)
        elbow = shoulder + self.spans["upper_arm"] * self.way("upper_arm", turn)
        wrist = elbow + self.spans["forearm"] * self.way("forearm", turn)
        return {
            "heel": heel, "toe": heel + self.spans["foot"], "ankle": ankle, "knee": knee, "hip": hip, "neck": neck,
            "vertex": neck + self.spans["head"] * self.way("head", turn), "shoulder": shoulder, "elbow": elbow,
            "wrist": wrist, "knuckle": wrist + self.spans["hand"] * self.way("hand", turn),
        }  # fmt: skip

    def masses(self, joints: dict[str, Any]) -> dict[str, tuple[Any, Any, Any]]:
        """Mass, centre and moment about it of each segment."""
        ends = {
            "head": ("vertex", "neck"), "trunk": ("neck", "hip"), "upper_arm": ("shoulder", "elbow"),
            "forearm": ("elbow", "wrist"), "hand": ("wrist", "knuckle"), "thigh": ("hip", "knee"),
            "shank": ("knee", "ankle"), "foot": ("heel", "toe"),
        }  # fmt: skip
        out = {}
        for name, (first, second) in ends.items():
            share, centroid, _, radius, _ = self.rows[name]
            mass = share * self.mass * (1 if name in ("head", "trunk") else 2)
            way = joints[second] - joints[first]
            out[name] = mass, joints[first] + centroid * way, mass * (radius * abs(way)) ** 2
        return out

    def energy(self, turned: dict[str, Any], load: Any) -> Any:
        """Potential energy of body and load, with some segments turned."""
        joints = self.placed(turned)
        return GRAVITY * (sum(m * c.imag for m, c, _ in self.masses(joints).values()) + load * joints["knuckle"].imag)


ARM = ("upper_arm", "forearm", "hand")
BEYOND = {
    "neck": ("head",), "shoulder": ARM, "elbow": ("forearm", "hand"), "wrist": ("hand",),
    "hip": ("trunk", "head", *ARM), "knee": ("thigh", "trunk", "head", *ARM),
    "ankle": ("shank", "thigh", "trunk", "head", *ARM),
}  # fmt: skip
POSES = {
    "standing": (90, 90, 90, 90, -90, -90, -90),
    "arms up": (90, 90, 90, 90, 90, 90, 90),
    "lifting": (80, 120, 40, 50, -90, -80, -80),
    "reaching": (88, 92, 70, 75, -20, 15, 10),
    "leaning back": (86, 94, 97, 95, -75, 5, 0),
}


def poses() -> Iterator[tuple[str, dict[str, str]]]:
    names = ("shank", "thigh", "trunk", "head", "upper_arm", "forearm", "hand")
    for title, angles in POSES.items():
        yield title, {name: degrees(angle) for name, angle in zip(names, angles, strict=True)}


def postures() -> Iterator[Case]:
    for sex, mass in (("male", "75.0"), ("female", "58.3")):
        for title, angles in poses():
            chain = Chain(sex, mass, LENGTHS, angles)
            masses = chain.masses(chain.joints).values()
            whole = sum(m for m, _, _ in masses)
            centre = sum(m * c for m, c, _ in masses) / whole
            inertia = sum(i + m * abs(c - centre) ** 2 for m, c, i in masses)
            pose = {"record": "Inclinations", **{f"{name}_inclination": text for name, text in angles.items()}}
            yield (
                "posture", f"{title}, {sex}", "",
                {"mass": mass, "sex": {"word": sex}, "size": {"record": "Lengths", **LENGTHS}, "pose": pose},
                {
                    "centre[2]": centre.imag, "height": centre.imag, "inertia": inertia,
                    "ankle_inertia": inertia + whole * abs(centre - chain.joints["ankle"]) ** 2,
                    "toe_margin": chain.joints["toe"].real - centre.real,
                    "heel_margin": centre.real - chain.joints["heel"].real,
                },
            )  # fmt: skip


def moments() -> Iterator[Case]:
    for load in ("0.0", "15.0", drawn(1, 9)):
        for title, angles in poses():
            if title in ("standing", "arms up"):
                continue
            chain = Chain("male", "75.0", LENGTHS, angles)
            results = {}
            for at, (joint, beyond) in enumerate(BEYOND.items()):
                change = diff(lambda t, b=beyond, c=chain, w=load: c.energy(dict.fromkeys(b, t), exact(w)), 0)
                results[f"joints[{at}].moment"] = -change if joint == "knee" else change
            masses = [(m, c) for m, c, _ in chain.masses(chain.joints).values()]
            masses.append((exact(load), chain.joints["knuckle"]))
            whole = sum(m for m, _ in masses)
            results["pressure_centre"] = sum(m * c.real for m, c in masses) / whole
            if not -0.06 <= results["pressure_centre"] <= 0.2:
                continue  # it topples
            # the muscle of the back, or of the belly where it leans back, with a lever of 5 cm
            above = [(m, c) for name, (m, c, _) in chain.masses(chain.joints).items() if name in BEYOND["hip"]]
            weight = GRAVITY * (sum(m for m, _ in above) + exact(load))
            results["muscle_force"] = abs(results["joints[4].moment"]) / exact("0.05")
            results["compression"] = results["muscle_force"] + weight * sin(chain.angles["trunk"])
            results["shear"] = weight * cos(chain.angles["trunk"])
            pose = {"record": "Inclinations", **{f"{name}_inclination": text for name, text in angles.items()}}
            yield (
                "moments", f"{title}, {load} kg", "",
                {
                    "mass": "75.0", "sex": {"word": "male"}, "size": {"record": "Lengths", **LENGTHS}, "pose": pose,
                    "load": load, "muscles": [{"record": "Muscle", "joint": {"word": "back"}, "lever": "0.05"}],
                },
                results,
            )  # fmt: skip


def limbs() -> Iterator[Case]:
    published = [
        ("1.0275", "0.0042", ("0.93", "0.062"), ("0.878", "0.105"), ("0.4", "-0.2"), "-1.5"),
        ("3.2475", "0.0355", ("0.858", "0.359"), ("0.834", "0.548"), ("1.2", "-0.3"), "2.1"),
        ("10.62", "0.21", ("0.783", "0.764"), ("0.741", "0.924"), ("1.9", "0.25"), "-3.2"),
    ]
    for nth in range(4):
        rows = published if nth == 0 else [
            (m, i, c, j, (drawn(-9, 9), drawn(-9, 9)), drawn(-40, 40)) for m, i, c, j, _, _ in published
        ]  # fmt: skip
        force, at = (
            (("-60.0", "710.0"), ("0.95", "0.0"))
            if nth == 0
            else ((drawn(-200, 200), drawn(0, 900)), (drawn(0.8, 1), "0.0"))
        )
        push, place = mpc(*map(exact, force)), mpc(*map(exact, at))
        results = {}
        for joint in range(3):
            about = mpc(*map(exact, rows[joint][3]))
            moment = -((place - about).conjugate() * push).imag
            whole = -push
            for m, i, c, _, a, alpha in rows[: joint + 1]:
                inertial = exact(m) * (mpc(*map(exact, a)) + mpc(0, GRAVITY))
                moment += exact(i) * exact(alpha) + ((mpc(*map(exact, c)) - about).conjugate() * inertial).imag
                whole += inertial
            results[f"joints[{joint}].moment"] = moment
            results[f"joints[{joint}].force[0]"], results[f"joints[{joint}].force[1]"] = whole.real, whole.imag
        given = [
            {
                "record": "Segment", "name": {"word": name}, "mass": m, "inertia": i, "centre": list(c),
                "joint": list(j), "acceleration": list(a), "rotation": alpha,
            }
            for name, (m, i, c, j, a, alpha) in zip(("foot", "shank", "thigh"), rows, strict=True)
        ]  # fmt: skip
        ground = {"record": "OuterForce", "force": list(force), "at": list(at)}
        yield "limb", f"leg {nth}", "", {"segments": given, "ground": ground}, results


def falls() -> Iterator[Case]:
    cases = [
        ("0.1", "0.0", "1.5707963267948966", ""),
        ("0.01", "0.0", "1.5707963267948966", ""),
        ("1e-06", "0.0", "1.5707963267948966", "hardly inclined: the time grows with the logarithm"),
        ("0.0", "1.4", "1.5707963267948966", ""),
        ("0.0", "1e-06", "1.5707963267948966", "upright and hardly moving: the time grows with the logarithm"),
        ("0.3", "0.9", "1.2", ""),
        ("0.6", "0.2", "0.6000001", "hardly any way: what is gained is a difference"),
    ]
    for nth, (start, speed, end, why) in enumerate(cases):
        h, k = exact("1.0") if nth < 3 else exact("0.95"), exact("0.5477225575051661")
        height = "1.0" if nth < 3 else "0.95"
        square = k * k + h * h
        own = GRAVITY * h / square
        first, last = exact(start), exact(end)
        begun = exact(speed) * h * cos(first) / square
        # from rest the rate begins with a root: the angle as the square of what is integrated over
        if speed == "0.0":

            def slow(u: Any, a: Any = first, p: Any = own) -> Any:
                angle = a + u * u
                return 2 * u / sqrt(4 * p * sin((angle + a) / 2) * sin(u * u / 2)) if u else 2 / sqrt(2 * p * sin(a))

            ends = [
                mpf(0),
                *(sqrt(first) * 4**n for n in range(12) if sqrt(first) * 4**n < sqrt(last - first)),
                sqrt(last - first),
            ]
            time = quad(slow, ends)
        else:
            ends = [
                first,
                *(begun / sqrt(own) * 4**n + first for n in range(14) if begun / sqrt(own) * 4**n + first < last),
                last,
            ]
            time = quad(
                lambda t, a=first, p=own, w=begun: 1 / sqrt(w * w + 4 * p * sin((t + a) / 2) * sin((t - a) / 2)), ends
            )
        rate = sqrt(begun**2 + 2 * own * (cos(first) - cos(last)))
        yield (
            "fall", f"fall {nth}", why,
            {
                "centre_height": height,
                "body": {"record": "Gyration", "gyration": "0.5477225575051661", "mass": "75.0"},
                "start": start, "speed": speed, "end": end, "height": "1.7",
            },
            {"time": time, "rate": rate, "head_speed": rate * exact("1.7"), "energy": mpf(75) * square * rate**2 / 2},
        )  # fmt: skip


def solids() -> Iterator[Case]:
    def between(shape: dict[str, Any], length: str, area: Any, across: Any, deep: Any, why: str = "") -> Case:
        span, density = exact(length), exact("1050.0")
        volume = quad(area, [0, 1]) * span
        centre = quad(lambda s: s * area(s), [0, 1]) * span * span / volume
        along = span * quad(lambda s: area(s) * (s * span - centre) ** 2, [0, 1])
        x, y = span * quad(across, [0, 1]), span * quad(deep, [0, 1])
        results = {
            "mass": density * volume, "centroid": centre, "axial": density * (x + y),
            "about_width": density * (y + along), "about_depth": density * (x + along),
        }  # fmt: skip
        inputs = {"shape": shape, "amount": {"record": "ByDensity", "density": "1050.0"}}
        return "solid", f"{shape['record'].lower()} {length}", why, inputs, results

    for length, base, top in (("0.42", "0.09", "0.06"), ("0.3", "0.05", "0.05"), ("0.5", "0.1", "0.0")):
        first, last = exact(base), exact(top)

        def radius(s: Any, a: Any = first, b: Any = last) -> Any:
            return a + s * (b - a)

        shape = {
            "record": "Frustum",
            "length": length,
            "ends": {"record": "Radii", "base_radius": base, "top_radius": top},
        }
        yield between(
            shape, length, lambda s, r=radius: pi * r(s) ** 2, lambda s, r=radius: pi * r(s) ** 4 / 4,
            lambda s, r=radius: pi * r(s) ** 4 / 4,
        )  # fmt: skip
    for length, texts in (
        ("0.15", ("0.78", "0.3", "0.9", "0.34")),
        ("0.2", ("0.8026548245743669", "0.3", "0.8026548245743669", "0.3")),
    ):
        p0, w0, p1, w1 = (exact(text) for text in texts)
        r0, r1 = ((p - 2 * w) / (2 * pi - 4) for p, w in ((p0, w0), (p1, w1)))

        def sizes(s: Any, r0: Any = r0, r1: Any = r1, w0: Any = w0, w1: Any = w1) -> tuple[Any, Any]:
            r = r0 + s * (r1 - r0)
            return r, w0 / 2 - r0 + s * ((w1 / 2 - r1) - (w0 / 2 - r0))

        # strips across the depth: half circles joined to the straight part
        def width2(s: Any, f: Any = sizes) -> Any:
            r, t = f(s)
            return quad(lambda y: 2 * (t + sqrt(r * r - y * y)) ** 3 / 3, [-r, 0, r])

        def depth2(s: Any, f: Any = sizes) -> Any:
            r, t = f(s)
            return quad(lambda y: 2 * (t + sqrt(r * r - y * y)) * y * y, [-r, 0, r])

        def area(s: Any, f: Any = sizes) -> Any:
            r, t = f(s)
            return quad(lambda y: 2 * (t + sqrt(r * r - y * y)), [-r, 0, r])

        keys = ("base_girth", "base_width", "top_girth", "top_width")
        shape = {"record": "Stadium", "length": length, **dict(zip(keys, texts, strict=True))}
        yield between(shape, length, area, width2, depth2)
    a, b, c = exact("0.08"), exact("0.095"), exact("0.12")
    mass = exact("1050.0") * 4 * pi * a * b * c / 3
    yield (
        "solid", "ellipsoid", "",
        {
            "shape": {"record": "Ellipsoid", "length": "0.24", "width": "0.16", "depth": "0.19"},
            "amount": {"record": "ByDensity", "density": "1050.0"},
        },
        {"mass": mass, "axial": mass * (a * a + b * b) / 5, "about_width": mass * (b * b + c * c) / 5},
    )  # fmt: skip


if __name__ == "__main__":
    write("human", ABOUT, [*segments(), *postures(), *moments(), *limbs(), *falls(), *solids()])
