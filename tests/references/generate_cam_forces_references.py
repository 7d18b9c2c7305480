"""Write cam_forces.json: forces, torques, jump speeds and stresses of cams to 40 digits, by another construction.

Derivatives of the motion come from Taylor coefficients by mpmath's numerical differentiation in 60 digits of the laws,
written out here anew. The force along the normal comes from statics: an envelope found from its definition (see
generate_cam_geometry_references.py) gives the point of contact and the normal, and the moment balance of the arm about
its pivot, or the balance along the slide, gives the force; no lever formula is used. Curvatures come from
differentiating the curve. Extremes are roots of numerical derivatives, beside the ends of every branch of every law.

Run: python tests/references/generate_cam_forces_references.py
"""

import json
import sys
from pathlib import Path

from generate_cam_geometry_references import (
    Carried,
    arm,
    flat,
    knife,
    program_text,
    rocker,
    roller,
)
from mpmath import cos, diff, findroot, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 60
DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"
WIDTH, YOUNG, POISSON = mpf(0.012), mpf(206e9), mpf(0.3)


def mirrored(branches):
    """A law of f(x) = 1 − f(1 − x) from the branches of its first half."""
    far = [(1 - b, 1 - a, lambda x, f=f: 1 - f(1 - x)) for a, b, f in reversed(branches)]
    return [*branches, *far]


def trapezoid():
    c = 2 / (pi + 2)
    wave, peak = c / (4 * pi), 4 * pi * c
    first = lambda x: c * x - wave * sin(4 * pi * x)  # noqa: E731
    e = mpf(1) / 8
    s1 = first(e)
    flat_ = lambda x: s1 + c * (x - e) + peak / 2 * (x - e) ** 2  # noqa: E731
    s2, v2 = flat_(3 * e), c + peak * 2 * e
    last = lambda x: s2 + v2 * (x - 3 * e) + peak / (16 * pi**2) * (1 - cos(4 * pi * (x - 3 * e)))  # noqa: E731
    return mirrored([(mpf(0), e, first), (e, 3 * e, flat_), (3 * e, mpf(1) / 2, last)])


def modified_sine():
    k = 1 / (pi + 4)
    e = mpf(1) / 8
    return [
        (mpf(0), e, lambda x: k * (pi * x - sin(4 * pi * x) / 4)),
        (e, 7 * e, lambda x: k * (2 + pi * x - mpf(9) / 4 * sin(pi / 3 + 4 * pi * x / 3))),
        (7 * e, mpf(1), lambda x: k * (4 + pi * x - sin(4 * pi * x) / 4)),
    ]


def whole(f):
    return [(mpf(0), mpf(1), f)]


LAWS = {
    "cycloidal": whole(lambda x: x - sin(2 * pi * x) / (2 * pi)),
    "3-4-5": whole(lambda x: x**3 * (10 - 15 * x + 6 * x * x)),
    "4-5-6-7": whole(lambda x: x**4 * (35 - 84 * x + 70 * x * x - 20 * x**3)),
    "5-6-7-8-9": whole(lambda x: x**5 * (126 - 420 * x + 540 * x**2 - 315 * x**3 + 70 * x**4)),
    "harmonic": whole(lambda x: (1 - cos(pi * x)) / 2),
    "double-harmonic": whole(lambda x: (1 - cos(pi * x)) / 2 - (1 - cos(2 * pi * x)) / 8),
    "parabolic": mirrored([(mpf(0), mpf(1) / 2, lambda x: 2 * x * x)]),
    "modified-sine": modified_sine(),
    "modified-trapezoid": trapezoid(),
}


def zones(segments):
    """(start, end, lift as a function of the angle, whether it rests) of every branch of one turn."""
    start, level = mpf(0), mpf(0)
    for span, law, to in segments:
        end, top = start + mpf(span) * pi / 180, mpf(to)
        if law is None:
            yield start, end, lambda t, level=level: level + 0 * t, True
        else:
            width = end - start
            for a, b, f in LAWS[law]:
                inner = lambda t, f=f, o=start, w=width, b=level, h=top - level: b + h * f((t - o) / w)  # noqa: E731
                yield start + a * width, start + b * width, inner, False
        start, level = end, top


NEAR = {mpf(2) ** -j for j in range(7, 24)}
SHARES = sorted({mpf(k) / 72 for k in range(1, 72)} | NEAR | {1 - share for share in NEAR})


def extreme(function, turn, sign, *, only=None):
    """The largest of sign·function over the turn; `only` says at which (lift, angle) it counts."""
    best = None
    for start, end, inner, rests in turn:
        mp.dps = 60
        candidates = [start, end]
        if not rests:
            mp.dps = 25
            inside = [start + (end - start) * share for share in SHARES]
            values = [sign * function(inner, at) if only is None or only(inner, at) else None for at in inside]
            mp.dps = 60
            # every hump is climbed: the highest sample need not be on the highest of them
            candidates.extend(_top(function, inner, inside, index, (start, end)) for index in humps(values))
        for at in candidates:
            if only is not None and not only(inner, at):
                continue
            value = sign * function(inner, at)
            best = value if best is None or value > best else best
    return None if best is None else sign * best


def humps(values):
    """Samples that are not below their neighbours."""
    low = min((value for value in values if value is not None), default=mpf(0)) - 1
    padded = [low, *(low if value is None else value for value in values), low]
    return [i for i in range(len(values)) if padded[i + 1] > low and padded[i] <= padded[i + 1] >= padded[i + 2]]


def _top(function, inner, inside, index, ends):
    """Root of the derivative between the neighbours of a sample, or the sample."""
    around = [ends[0], *inside, ends[1]][index : index + 3]
    slope = lambda t: diff(lambda u: function(inner, u), t)  # noqa: E731
    # a derivative needs room on both sides
    low, high = (around[1] + (edge - around[1]) * (1 - mpf(10) ** -6) for edge in (around[0], around[2]))
    if slope(low) * slope(high) >= 0:
        return around[1]
    return findroot(slope, (low, high), solver="anderson", tol=mpf(10) ** -90, maxsteps=200, verify=False)


def double(text):
    return mpf(float(text))


class Pressed:
    """A follower's load: force of a slide or torque of an arm."""

    def __init__(self, train, speed):
        values = {key: double(value) for key, value in train.items() if key != "record"}
        zero = mpf(0)
        self.kind = train["record"]
        if self.kind == "Slide":
            self.inertia, self.rate = values["mass"], values.get("spring_rate", zero)
            self.steady = values.get("preload", zero) + values.get("load", zero)
        elif self.kind == "ArmOnTorsionSpring":
            self.inertia, self.rate = values["inertia"], values.get("torsion_rate", zero)
            self.steady = values.get("preload_torque", zero) + values.get("load_torque", zero)
        else:
            r = values["spring_radius"]
            self.inertia, self.rate = values["inertia"], values.get("spring_rate", zero) * r * r
            self.steady = values.get("preload", zero) * r + values.get("load_torque", zero)
        self.square = double(speed) ** 2

    def held(self, inner, t):
        return self.rate * inner(t) + self.steady

    def force(self, inner, t):
        return self.held(inner, t) + self.inertia * self.square * diff(inner, t, 2)

    def torque(self, inner, t):
        return self.force(inner, t) * diff(inner, t)

    def lifting(self, inner, t):
        """1/ω² at which the load vanishes."""
        return -self.inertia * diff(inner, t, 2) / self.held(inner, t)


class Touched:
    """The force along the normal, and how close cam and follower lie."""

    def __init__(self, pressed, follower, turn):
        self.pressed, self.follower = pressed, follower
        self.carried = Carried(follower, turn, 1)

    def normal(self, inner, t):
        point, n = self.carried.point(inner, t)
        back = self.carried.back(t)
        point, n = point / back, n / back
        if self.pressed.kind == "Slide":
            return self.pressed.force(inner, t) / (n * self.carried.way(inner(t)).conjugate()).real
        # moment of the normal force about the pivot, in the sense that lifts the arm (clockwise)
        lever = point - double(self.follower["pivot_distance"])
        return self.pressed.force(inner, t) / -(lever.conjugate() * n).imag

    def crowding(self, inner, t):
        """Normal force times the sum of both curvatures."""
        curved = 1 / self.carried.radius(inner, t)
        if self.carried.roller:
            curved += 1 / self.carried.roller
        return self.normal(inner, t) * curved


def answers(segments, swing, speed, train, follower, turn, stressed):
    unit = pi / 180 if swing else mpf(1)
    levels = [(span, law, mpf(float(mpf(to) * unit))) for span, law, to in segments]
    turned = list(zones(levels))
    pressed = Pressed(train, speed)
    name = "arm_torque" if swing else "force"
    out = {}
    for end, sign in (("least", -1), ("greatest", 1)):
        out[f"{end}_{name}"] = extreme(pressed.force, turned, sign)
        out[f"{end}_torque"] = extreme(pressed.torque, turned, sign)
    lifted = extreme(pressed.lifting, turned, 1, only=lambda inner, t: diff(inner, t, 2) < -(mpf(10) ** -20))
    out["jump_speed"] = 1 / sqrt(lifted)
    if follower is not None:
        touched = Touched(pressed, follower, turn)
        for end, sign in (("least", -1), ("greatest", 1)):
            out[f"{end}_contact_force"] = extreme(touched.normal, turned, sign)
        if stressed:
            give = 2 * (1 - POISSON**2) / YOUNG
            out["stress"] = sqrt(extreme(touched.crowding, turned, 1) / (pi * WIDTH * give))
    return out


RISES = (("90", "cycloidal", "0.02"), ("60", None, "0.02"), ("90", "3-4-5", "0"), ("120", None, "0"))
MODIFIED = (
    ("100", "modified-sine", "0.015"), ("50", None, "0.015"), ("80", "modified-trapezoid", "0"), ("130", None, "0"),
)  # fmt: skip
HIGH = (("110", "4-5-6-7", "0.012"), ("60", None, "0.012"), ("130", "5-6-7-8-9", "0"), ("60", None, "0"))
JUMPS = (("120", "parabolic", "0.02"), ("60", None, "0.02"), ("120", "harmonic", "0"), ("60", None, "0"))
DOUBLE = (("180", "double-harmonic", "0.01"), ("180", "3-4-5", "0"))
STEEP = (("60", "cycloidal", "0.01"), ("60", "cycloidal", "0"), ("240", None, "0"))
SHORT = (("5.72957795e-5", "cycloidal", "1e-9"), ("89.9999427042205", None, "1e-9"), ("270", "3-4-5", "0"))
BELOW = (("90", "cycloidal", "-0.004"), ("90", None, "-0.004"), ("180", "3-4-5", "0"))
SWING = (("120", "3-4-5", "12"), ("60", None, "12"), ("150", "cycloidal", "0"), ("30", None, "0"))
SWING_MS = (("110", "modified-sine", "15"), ("40", None, "15"), ("130", "modified-trapezoid", "0"), ("80", None, "0"))
FAST = (("90", "3-4-5", "20"), ("30", None, "20"), ("40", "3-4-5", "0"), ("200", None, "0"))
INWARD = (("90", "cycloidal", "-4"), ("90", None, "-4"), ("180", "3-4-5", "0"))


def slide(mass, rate="0", preload="0", load="0"):
    return {"record": "Slide", "mass": mass, "spring_rate": rate, "preload": preload, "load": load}


def torsion(inertia, rate="0", preload="0", load="0"):
    given = {"inertia": inertia, "torsion_rate": rate, "preload_torque": preload, "load_torque": load}
    return {"record": "ArmOnTorsionSpring", **given}


def sprung(inertia, radius, rate, preload):
    given = {"inertia": inertia, "spring_radius": radius, "spring_rate": rate, "preload": preload}
    return {"record": "ArmOnSpring", **given}


S, A = slide("0.5", "5000", "60"), torsion("0.002", "10", "2")
ARM = arm("0.03", "0.008", "0.08", "0.1")
CASES = [
    ("slide without a follower's geometry", "", RISES, "50", S, None, 1, False),
    ("slide, offset roller", "", RISES, "50", S, roller("0.04", "0.01", "0.006"), 1, True),
    ("slide, offset roller, clockwise", "", MODIFIED, "60", S, roller("0.04", "0.01", "0.006"), -1, True),
    ("slide, flat face", "", HIGH, "70", S, flat("0.05"), 1, True),
    ("slide, knife-edge", "", HIGH, "40", slide("0.2", "8000", "20", "30"), knife("0.03", "0.005"), 1, False),
    ("acceleration that jumps", "", JUMPS, "45", S, roller("0.05", "0.012"), 1, True),
    ("turn without a dwell", "", DOUBLE, "120", slide("0.3", "9000", "150"), roller("0.03", "0.008"), 1, True),
    ("arm with roller", "", SWING, "50", A, ARM, 1, True),
    ("arm with roller, clockwise", "", SWING_MS, "45", A, ARM, -1, True),
    ("arm on a linear spring", "", SWING_MS, "50", sprung("0.002", "0.05", "4000", "40"), ARM, 1, False),
    ("flat rocker", "", SWING, "40", A, rocker("0.045", "0.12"), 1, True),
    ("flat rocker with offset face, clockwise", "", SWING, "40", A, rocker("0.045", "0.12", "0.006"), -1, True),
    ("a million turns a minute", "the spring is nothing beside 1e13 N of inertia", RISES, "104719.75511965978", S,
     roller("0.04", "0.01"), 1, True),
    ("at rest", "only the spring is left; the stress is that of a dwell", RISES, "0", S,
     roller("0.04", "0.01"), 1, True),
    ("at the jump speed itself", "the least force is what rounding of the speed leaves of 160 N", RISES,
     "76.74172567886146", S, roller("0.04", "0.01"), 1, False),
    ("dip to zero between samples", "0.125 N at the start is less than any sample of the dip to nothing in the rise",
     RISES, "109.51236970071136", slide("1", "34238", "0.125"), None, 1, False),
    ("no preload", "where the follower rests the quotient of the jump is 0/0", RISES, "30", slide("0.5", "5000"),
     None, 1, False),
    ("hardly any preload", "the quotient of the jump has poles a micrometre off the dwell", HIGH, "30",
     slide("0.5", "1000000", "1e-6"), None, 1, False),
    ("no spring rate", "a preload alone: the jump is where it slows down most", MODIFIED, "30", slide("0.5", "0", "60"),
     None, 1, False),
    ("load that nearly takes the preload off", "the sum of both keeps four digits", RISES, "30",
     slide("0.5", "5000", "100", "-99.9999999999"), None, 1, False),
    ("rise within a millionth of a radian", "accelerations of 1e4 m beside lifts of a nanometre", SHORT, "10",
     slide("0.1", "5000", "60"), None, 1, False),
    ("fall below the base circle", "the spring slackens to a millinewton where the acceleration is upwards", BELOW,
     "10", slide("0.5", "5000", "20.001"), roller("0.03", "0.008"), 1, True),
    ("two places of the jump", "rise and return leave at one speed", STEEP, "90", S, roller("0.04", "0.01"), 1, False),
    ("offset next to the start radius", "√(Rp² − e²) by squares keeps five digits; 1/cos φ is 1e4 at the start", RISES,
     "20", S, knife("0.03", "0.02999999999997"), 1, False),
    ("metre-sized cam", "sizes and forces a thousand times larger",
     (("120", "cycloidal", "20"), ("120", "modified-trapezoid", "0"), ("120", None, "0")), "2",
     slide("500", "5e6", "6e7"), roller("40", "10", "6"), 1, True),
    ("arm next to the line of pivot and axis", "the triangle is 1e-12 m from its limit: the lever begins at 2e-7 m",
     SWING, "30", A, arm("0.022000000000001", "0.008", "0.07", "0.1"), 1, False),
    ("arm stretched beyond the axis", "the triangle is 1e-9 m from its other limit", INWARD, "30", A,
     arm("0.159999999", "0.01", "0.07", "0.1"), 1, False),
    ("flat rocker as fast as the cam", "1 + dψ/dθ falls to a sixteenth", FAST, "20", torsion("0.002", "10", "2"),
     rocker("0.03", "0.2"), 1, False),
    ("swing of a millionth of a degree", "torques of the arm within 1e-9 of one another",
     (("120", "3-4-5", "1e-6"), ("60", None, "1e-6"), ("150", "cycloidal", "0"), ("30", None, "0")), "50", A, ARM, 1,
     True),
]  # fmt: skip


def cusps():
    """Rollers and faces that come to a hair of a cusp: chosen by the least radius of the pitch curve."""
    levels = [(span, law, double(to)) for span, law, to in STEEP]
    turned = list(zones(levels))
    prime = mpf("0.03")
    pitch = Carried({"record": "Roller", "base_radius": "0.03", "roller_radius": "0"}, 1, 1)
    sharpest = 1 / extreme(lambda inner, t: 1 / pitch.radius(inner, t), turned, 1)
    for share, words in ((mpf("1e-3"), "a thousandth"), (mpf("1e-7"), "a ten-millionth")):
        radius = float(sharpest * (1 - share))
        base = float(prime - radius)
        yield (
            f"roller within {words} of the radius of curvature", "1 − R κ is left over from much larger terms", STEEP,
            "60", S, roller(repr(base), repr(radius)), 1, True,
        )  # fmt: skip
    low = extreme(lambda inner, t: inner(t) + diff(inner, t, 2), turned, -1)
    base = float(-low + mpf("1e-9"))
    yield ("flat face a nanometre off a cusp", "R + s + s″ is left over from centimetres", STEEP, "150", S,
           flat(repr(base)), 1, True)  # fmt: skip


def main():
    cases = []
    for name, why, segments, speed, train, follower, turn, stressed in [*CASES, *cusps()]:
        swing = train["record"] != "Slide"
        mp.dps = 60
        results = answers(segments, swing, speed, train, follower, turn, stressed)
        inputs = {
            "program": program_text(segments, *(("deg", 1) if swing else ("mm", 1000))),
            "shaft_speed": speed,
            "train": train,
            **({} if follower is None else {"follower": follower}),
            "rotation": "counter-clockwise" if turn > 0 else "clockwise",
            **({"contact": {"width": "0.012"}} if stressed else {}),
        }
        cases.append(
            {
                "task": "force",
                "kind": "hard" if why else "ordinary",
                "name": name,
                **({"why": why} if why else {}),
                "inputs": inputs,
                "results": {key: nstr(value, 40, min_fixed=1, max_fixed=0) for key, value in results.items()},
            }
        )
        print(name, flush=True)
    about = "Written by generate_cam_forces_references.py: SI inputs as doubles, results to 40 digits of 60."
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / "cam_forces.json"
    text = json.dumps({"about": about, "cases": cases}, indent=1, ensure_ascii=False)
    target.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
