"""Write cam_geometry.json: profiles, pressure angles and curvatures of cams to 40 digits, by another construction.

The envelope is not taken from formulas for contact points but from its definition: the roller is carried round the cam
as a moving circle, |z − c(θ)|² = R², and the point where ∂/∂θ of that vanishes is found with c′ by numerical
differentiation in 60 digits (Taylor coefficients by contour integrals, mpmath `taylor`); a flat face is a moving line
treated alike. Curvatures come from differentiating the curve itself. Laws are written out here anew.

Run: python tests/references/generate_cam_geometry_references.py
"""

import json
import sys
from itertools import pairwise
from pathlib import Path

from mpmath import acos, asin, atan2, cos, diff, exp, findroot, mp, mpc, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 60
DATA = Path(__file__).resolve().parents[2] / "dynamics_cli" / "accuracy" / "data"


def cycloidal(x):
    return x - sin(2 * pi * x) / (2 * pi)


def modified_sine(x):
    k = 1 / (pi + 4)
    if x <= mpf(1) / 8:
        return k * (pi * x - sin(4 * pi * x) / 4)
    if x >= mpf(7) / 8:
        return k * (4 + pi * x - sin(4 * pi * x) / 4)
    return k * (2 + pi * x - mpf(9) / 4 * sin(pi / 3 + 4 * pi * x / 3))


LAWS = {
    "cycloidal": cycloidal,
    "modified-sine": modified_sine,
    "3-4-5": lambda x: x**3 * (10 - 15 * x + 6 * x * x),
    "4-5-6-7": lambda x: x**4 * (35 - 84 * x + 70 * x * x - 20 * x**3),
    "harmonic": lambda x: (1 - cos(pi * x)) / 2,
}


class Lift:
    """Segments (degrees as text, law or None, level at the end) of one turn."""

    def __init__(self, segments):
        self.zones = []
        start, level = mpf(0), mpf(0)
        for span, law, to in segments:
            end = start + mpf(span) * pi / 180
            self.zones.append((start, end, law, level, mpf(to)))
            start, level = end, mpf(to)

    def zone(self, theta):
        for zone in self.zones:
            if theta < zone[1]:
                return zone
        return self.zones[-1]

    def within(self, zone):
        start, end, law, low, high = zone
        if law is None:
            return lambda theta: low + 0 * theta
        return lambda theta: low + (high - low) * LAWS[law]((theta - start) / (end - start))


def program_text(segments, unit, scale):
    words = []
    level = mpf(0)
    for span, law, to in segments:
        if law is None:
            words.append(f"dwell {span} deg")
        else:
            move = "rise" if mpf(to) > level else "return"
            amount = abs(mpf(to) - level) * scale
            words.append(f"{move} {nstr(amount, 15, strip_zeros=True)} {unit} in {span} deg {law}")
        level = mpf(to)
    return "; ".join(words)


class Carried:
    """A follower carried round the cam: where its circle or line is, in the cam's frame, at a cam angle."""

    def __init__(self, follower, turn, side):
        self.f = {key: mpf(float(value)) for key, value in follower.items() if key != "record"}
        self.kind = follower["record"]
        self.turn, self.side = turn, side
        f = self.f
        self.roller = f.get("roller_radius", mpf(0))
        if self.kind in ("KnifeEdge", "Roller", "ConjugateRoller"):
            prime = f["base_radius"] + self.roller
            self.start = sqrt(prime**2 - f.get("offset", mpf(0)) ** 2)
        elif self.kind in ("OscillatingRoller", "ConjugateOscillatingRoller"):
            prime = f["base_radius"] + self.roller
            self.start = acos(
                (f["pivot_distance"] ** 2 + f["arm"] ** 2 - prime**2) / (2 * f["arm"] * f["pivot_distance"])
            )
        elif self.kind == "OscillatingFlat":
            self.start = asin((f["base_radius"] + f.get("face_offset", mpf(0))) / f["pivot_distance"])
        else:
            self.start = f["base_radius"]

    def centre(self, s):
        """Fixed-frame centre of the roller."""
        f = self.f
        if self.kind in ("KnifeEdge", "Roller"):
            return mpc(f.get("offset", mpf(0)), self.start + s)
        if self.kind == "ConjugateRoller":
            return mpc(f.get("offset", mpf(0)), self.start + s - f["roller_distance"])
        angle = self.start + s - f.get("arm_angle", mpf(0))
        return f["pivot_distance"] - f["arm"] * exp(-1j * angle)

    def way(self, s):
        """Unit direction in which the follower is driven."""
        if self.kind in ("KnifeEdge", "Roller", "FlatFace"):
            return mpc(0, 1)
        if self.kind == "ConjugateRoller":
            return mpc(0, -1)
        angle = self.start + s - self.f.get("arm_angle", mpf(0))
        return (1 if "arm_angle" not in self.f else -1) * 1j * exp(-1j * angle)

    def face(self, s):
        """Fixed-frame normal of a flat face and the distance of its line from the cam's axis."""
        if self.kind == "FlatFace":
            return mpc(0, 1), self.start + s
        angle = self.start + s
        normal = 1j * exp(-1j * angle)
        return normal, self.f["pivot_distance"] * sin(angle) - self.f.get("face_offset", mpf(0))

    def back(self, theta):
        return exp(-1j * self.turn * theta)

    def point(self, lift, theta):
        """Envelope point in the cam's frame and the outward normal there."""
        if self.kind in ("FlatFace", "OscillatingFlat"):
            # the line Re(conj(n) z) = h and its derivative by θ, solved for z
            def normal(t):
                return self.face(lift(t))[0] * self.back(t)

            def level(t):
                return self.face(lift(t))[1]

            n, h = normal(theta), level(theta)
            n1, h1 = diff(normal, theta), diff(level, theta)
            # n₁ = i a n with a real
            a = (n1 / (1j * n)).real
            return n * (h + 1j * h1 / a), n

        def carried(t):
            return self.centre(lift(t)) * self.back(t)

        c, c1 = carried(theta), diff(carried, theta)
        # the circle's point whose radius is square to the centre's velocity, on the outer side
        n = 1j * self.turn * c1 / abs(c1)
        return c - self.side * self.roller * n, n

    def pressure(self, lift, theta):
        if self.kind in ("FlatFace",):
            return mpf(0)
        _, n = self.point(lift, theta)
        z, _ = self.point(lift, theta)
        fixed = n / self.back(theta)
        if self.kind == "OscillatingFlat":
            # the point of the face moves square to its arm
            touch = z / self.back(theta) - self.f["pivot_distance"]
            way = -1j * touch / abs(touch)
        else:
            way = self.way(lift(theta))
        ratio = fixed / way
        return self.turn * atan2(ratio.imag, ratio.real)

    def radius(self, lift, theta):
        """Radius of curvature of the cam, from two derivatives of its points' carrier."""
        if self.kind in ("FlatFace", "OscillatingFlat"):
            z1 = diff(lambda t: self.point(lift, t)[0], theta)
            n1 = diff(lambda t: self.point(lift, t)[1], theta)
            return (z1 / n1).real if abs(n1) else mpf(0)

        def carried(t):
            return self.centre(lift(t)) * self.back(t)

        c1, c2 = diff(carried, theta), diff(carried, theta, 2)
        curvature = -self.turn * (c1.conjugate() * c2).imag / abs(c1) ** 3
        return 1 / curvature - self.side * self.roller


def extreme(function, zones, sign):
    """The largest of sign·function over the zones: a grid, then a root of the derivative in 60 digits."""
    best = None
    for start, end, inner in zones:
        mp.dps = 40
        # fine towards the ends, where a law leaves its dwell with a high power
        shares = sorted({mpf(k) / 160 for k in range(1, 160)} | {mpf(2) ** -j for j in range(8, 40)}
                        | {1 - mpf(2) ** -j for j in range(8, 40)})  # fmt: skip
        values = [sign * function(inner, start + (end - start) * share) for share in shares]
        index = max(range(len(shares)), key=values.__getitem__)
        mp.dps = 60
        place = start + (end - start) * shares[index]
        candidates = [(sign * function(inner, place), place)]
        if 0 < index < len(shares) - 1:
            slope = lambda t: diff(lambda u: function(inner, u), t)  # noqa: B023, E731
            around = (start + (end - start) * shares[index - 1], start + (end - start) * shares[index + 1])
            try:
                root = findroot(slope, around, solver="anderson", tol=1e-60, verify=False)
                candidates.append((sign * function(inner, root), root))
            except (ValueError, ZeroDivisionError):
                pass
        candidates.extend((sign * function(inner, end_place), end_place) for end_place in (start, end))
        found = max(candidates, key=lambda pair: pair[0])
        if best is None or found[0] > best[0]:
            best = found
    return sign * best[0]


LAW_BREAKS = {"modified-sine": (mpf(1) / 8, mpf(7) / 8)}


def smooth_zones(lift):
    for zone in lift.zones:
        start, end, law, _, _ = zone
        cuts = [mpf(0), *LAW_BREAKS.get(law, ()), mpf(1)]
        inner = lift.within(zone)
        for a, b in pairwise(cuts):
            first, last = start + (end - start) * a, start + (end - start) * b
            if law == "modified-sine":
                inner = _branch(zone, a)
            yield first, last, inner


def _branch(zone, cut):
    start, end, _, low, high = zone
    k = 1 / (pi + 4)

    def law_of(x):
        if cut == 0:
            return k * (pi * x - sin(4 * pi * x) / 4)
        if cut == mpf(7) / 8:
            return k * (4 + pi * x - sin(4 * pi * x) / 4)
        return k * (2 + pi * x - mpf(9) / 4 * sin(pi / 3 + 4 * pi * x / 3))

    return lambda theta: low + (high - low) * law_of((theta - start) / (end - start))


MM = ("mm", 1000)
CYCLE = (("90", "modified-sine", "0.01"), ("90", None, "0.01"), ("90", "cycloidal", "0"), ("90", None, "0"))
RISES = (("120", "3-4-5", "0.02"), ("60", None, "0.02"), ("150", "4-5-6-7", "0"), ("30", None, "0"))
STEEP = (("45", "cycloidal", "0.02"), ("90", None, "0.02"), ("45", "cycloidal", "0"), ("180", None, "0"))
ROUND = (("180", "cycloidal", "0.01"), ("180", "cycloidal", "0"))
TINY = (("0.0001", "3-4-5", "1e-9"), ("179.9999", None, "1e-9"), ("180", "cycloidal", "0"))
SHORT = (("0.01", "cycloidal", "1e-8"), ("89.99", None, "1e-8"), ("270", "3-4-5", "0"))
SWING = (("120", "3-4-5", "12"), ("60", None, "12"), ("150", "cycloidal", "0"), ("30", None, "0"))
FAST = (("90", "3-4-5", "20"), ("30", None, "20"), ("95", "3-4-5", "0"), ("145", None, "0"))
BELOW = (("90", "cycloidal", "-0.004"), ("90", None, "-0.004"), ("180", "3-4-5", "0"))


def roller(base, radius, offset="0"):
    return {"record": "Roller", "base_radius": base, "roller_radius": radius, "offset": offset}


def knife(base, offset="0"):
    return {"record": "KnifeEdge", "base_radius": base, "offset": offset}


def flat(base):
    return {"record": "FlatFace", "base_radius": base}


def arm(base, radius, length, pivot):
    return {
        "record": "OscillatingRoller",
        "base_radius": base,
        "roller_radius": radius,
        "arm": length,
        "pivot_distance": pivot,
    }


def rocker(base, pivot, offset="0"):
    return {"record": "OscillatingFlat", "base_radius": base, "pivot_distance": pivot, "face_offset": offset}


def mate(base, radius, distance, offset="0"):
    return {
        "record": "ConjugateRoller",
        "base_radius": base,
        "roller_radius": radius,
        "roller_distance": distance,
        "offset": offset,
    }


def mate_arm(base, radius, length, pivot, angle):
    return {
        "record": "ConjugateOscillatingRoller",
        "base_radius": base,
        "roller_radius": radius,
        "arm": length,
        "pivot_distance": pivot,
        "arm_angle": angle,
    }


CASES = [
    ("the cam of the work-precision table", "", CYCLE, roller("0.025", "0.006"), 1, 1),
    ("knife-edge in line", "", RISES, knife("0.04"), 1, 1),
    ("knife-edge offset", "", RISES, knife("0.04", "0.01"), 1, 1),
    ("roller offset to the left", "", CYCLE, roller("0.03", "0.008", "-0.012"), 1, 1),
    ("roller, clockwise", "", RISES, roller("0.035", "0.008", "0.009"), -1, 1),
    ("outer flank of a track", "", CYCLE, roller("0.04", "0.01"), 1, -1),
    ("outer flank, clockwise", "", RISES, roller("0.06", "0.012", "0.005"), -1, -1),
    ("flat face", "", CYCLE, flat("0.05"), 1, 1),
    ("flat face, clockwise", "", RISES, flat("0.06"), -1, 1),
    ("arm with roller", "", SWING, arm("0.03", "0.008", "0.08", "0.1"), 1, 1),
    ("arm with roller, clockwise", "", SWING, arm("0.03", "0.008", "0.08", "0.1"), -1, 1),
    ("flat rocker", "", SWING, rocker("0.03", "0.09"), 1, 1),
    ("flat rocker with offset face, clockwise", "", SWING, rocker("0.03", "0.09", "0.006"), -1, 1),
    ("second cam on a slide", "", CYCLE, mate("0.03", "0.008", "0.09", "0.004"), 1, 1),
    ("second cam on a rocker", "", SWING, mate_arm("0.03", "0.008", "0.08", "0.1", "1.1"), 1, 1),
    (
        "offset a millionth of a millionth short of the radius",
        "√(Rp² − e²) by squares keeps five digits",
        CYCLE,
        knife("0.03", "0.02999999999997"),
        1,
        1,
    ),
    (
        "offset a billionth short of the start radius, roller",
        "the follower starts almost level with the axis",
        CYCLE,
        roller("0.025", "0.006", "0.030999999969"),
        1,
        1,
    ),
    (
        "offset equal to the start radius",
        "the start height is zero and the pressure angle a right angle there",
        BELOW[:0] + CYCLE,
        roller("0.025", "0.005", "-0.0299999999"),
        -1,
        1,
    ),
    ("base circle of a nanometre", "the cam shrinks onto its axis", CYCLE, roller("1e-9", "0.02"), 1, 1),
    (
        "base circle of a micrometre under a knife-edge",
        "the pressure angle comes near a right angle where the rise begins",
        RISES,
        knife("1e-6"),
        1,
        1,
    ),
    ("base circle zero", "the roller touches the axis itself", CYCLE, roller("0", "0.02"), 1, 1),
    (
        "roller a billionth short of a cusp",
        "1 − R κ is 1e-9 at the worst place and the radius is a difference",
        STEEP,
        roller("0.0187149094", "0.0112850906"),
        1,
        1,
    ),
    ("undercut roller", "the envelope runs backwards", STEEP, roller("0.015", "0.015"), 1, 1),
    ("large roller on a small cam", "pitch radius and roller cancel", CYCLE, roller("0.002", "0.04"), 1, 1),
    (
        "arm a picometre inside the triangle limit",
        "the arc cosine keeps half the digits",
        SWING,
        arm("0.012000000001", "0.008", "0.08", "0.1"),
        1,
        1,
    ),
    (
        "arm stretched out",
        "the roller starts almost beyond the axis",
        (("180", "cycloidal", "-12"), ("180", "3-4-5", "0")),
        arm("0.1719999999", "0.008", "0.08", "0.1"),
        1,
        1,
    ),
    ("arm of the pivot's distance", "|c − L| is zero", SWING, arm("0.03", "0.008", "0.1", "0.1"), 1, 1),
    (
        "flat rocker nearly as fast as the cam",
        "1 + ψ′ falls to a few hundredths and ρ has its cube below",
        FAST,
        rocker("0.04", "0.11"),
        1,
        1,
    ),
    (
        "flat rocker clockwise, rising fast",
        "1 − ψ′ is what counts when the cam turns the other way",
        FAST,
        rocker("0.04", "0.11"),
        -1,
        1,
    ),
    ("flat face at the edge of undercut", "R + s + s″ is a difference near zero", CYCLE, flat("0.0164263127864"), 1, 1),
    (
        "rise of a nanometre in 0.0001 deg",
        "a span of 1.7e-6 rad: derivatives of the law are 1e12 times the lift",
        TINY,
        roller("0.025", "0.006"),
        1,
        1,
    ),
    (
        "rise of ten nanometres in 0.01 deg",
        "curvature changes sign within 0.01 deg",
        SHORT,
        roller("0.025", "0.006"),
        1,
        1,
    ),
    ("flat face, rise in 0.01 deg", "the face is touched far out for an instant", SHORT, flat("0.03"), 1, 1),
    ("fall below the base circle", "the lift is negative", BELOW, roller("0.025", "0.006", "0.003"), 1, 1),
    ("metre-sized cam", "sizes a thousand times larger", CYCLE, roller("25", "6", "4"), 1, 1),
    ("micrometre-sized follower", "roller of a micrometre on a large cam", CYCLE, roller("0.025", "1e-6"), 1, 1),
    (
        "second roller close to the axis",
        "the second cam's own base circle is small",
        CYCLE,
        mate("0.03", "0.008", "0.0575"),
        1,
        1,
    ),
    (
        "outer flank where the pitch curve is hollow",
        "ρ of a hollow pitch curve and the roller subtract",
        STEEP,
        roller("0.015", "0.012"),
        1,
        -1,
    ),
]

COUNT = 16


def answers(segments, follower, turn, side, swing):
    scaled = [(span, law, mpf(to) * pi / 180 if swing else mpf(to)) for span, law, to in segments]
    # the program reads decimals of degrees or millimetres and rounds them to doubles of radians or metres
    if swing:
        scaled = [(span, law, mpf(float(to))) for span, law, to in scaled]
    else:
        scaled = [(span, law, mpf(float(to))) for span, law, to in scaled]
    lift = Lift(scaled)
    carried = Carried(follower, turn, side)
    out = {}
    for index in (1, 2, 3, 6, 9, 10, 13):
        theta = mpf(index * (2.0 * 3.141592653589793 / COUNT))
        inner = lift.within(lift.zone(theta))
        zone = lift.zone(theta)
        if zone[2] == "modified-sine":
            x = (theta - zone[0]) / (zone[1] - zone[0])
            inner = _branch(zone, 0 if x < mpf(1) / 8 else mpf(7) / 8 if x > mpf(7) / 8 else mpf(1) / 8)
        point, _ = carried.point(inner, theta)
        out[f"points[{index}].x"], out[f"points[{index}].y"] = point.real, point.imag
        out[f"points[{index}].pressure_angle"] = carried.pressure(inner, theta)
    zones = list(smooth_zones(lift))
    out["largest_pressure_angle"] = extreme(carried.pressure, zones, 1)
    out["least_pressure_angle"] = extreme(carried.pressure, zones, -1)
    if carried.kind in ("FlatFace", "OscillatingFlat"):
        out["least_convex_radius"] = extreme(carried.radius, zones, -1)
    else:
        pitch = Carried({**follower}, turn, 1)
        bend = lambda inner, t: 1 / (pitch.radius(inner, t) + pitch.roller)  # noqa: E731
        out["least_convex_radius"] = 1 / extreme(bend, zones, 1) - side * pitch.roller
    return out


SIZES = [
    ("two limits", "", CYCLE, "0.006", "0.5", "0.5", None),
    ("unequal limits", "", RISES, "0.008", "0.35", "0.6", None),
    ("in line", "", CYCLE, "0.006", "0.5", "0.4", "0"),
    ("offset given", "", RISES, "0.006", "0.5", "0.4", "0.004"),
    (
        "wide limits that differ",
        "the nearest point may be a foot in place of the apex",
        RISES,
        "0.0001",
        "1.5",
        "1.3",
        None,
    ),
    (
        "limits of a tenth of a degree",
        "the cam is hundreds of times its lift",
        CYCLE,
        "0.006",
        "0.0017",
        "0.0017",
        None,
    ),
    (
        "a rise of a nanometre beside one of millimetres",
        "the steepest place is within 1.7e-6 rad",
        TINY,
        "0.0001",
        "0.5",
        "0.5",
        None,
    ),
    ("fall below the base circle", "the lift is negative and the floor counts", BELOW, "0.001", "0.6", "0.6", None),
]
FLATS = [
    ("flat face", "", CYCLE, "0.004"),
    ("flat face, steep", "", STEEP, "0.001"),
    ("flat face without a least radius", "the curve comes to a point", RISES, "0"),
    ("flat face, rise in 0.01 deg", "s″ is large where the lift is ten nanometres", SHORT, "0.002"),
]


def size_answers(segments, roller_radius, rise, back, offset):
    lift = Lift([(span, law, mpf(float(to))) for span, law, to in segments])
    zones = list(smooth_zones(lift))
    c1, c2 = 1 / tan(mpf(float(rise))), 1 / tan(mpf(float(back)))
    a = extreme(lambda s, t: diff(s, t) * c1 - s(t), zones, 1)
    b = extreme(lambda s, t: -diff(s, t) * c2 - s(t), zones, 1)
    if offset is not None:
        e = mpf(float(offset))
        d = max(a - e * c1, b + e * c2)
    else:
        # the nearest of: both feet where they keep the other line, and the apex
        choices = [((a - b) / (c1 + c2), (a * c2 + b * c1) / (c1 + c2))]
        foot = (a * c1 / (1 + c1**2), a / (1 + c1**2))
        if foot[1] - foot[0] * c2 >= b:
            choices.append(foot)
        foot = (-b * c2 / (1 + c2**2), b / (1 + c2**2))
        if foot[1] + foot[0] * c1 >= a:
            choices.append(foot)
        e, d = min(choices, key=lambda pair: pair[0] ** 2 + pair[1] ** 2)
    radius = sqrt(e**2 + d**2)
    return {"base_radius": radius - mpf(float(roller_radius)), "offset": e, "start_radius": radius}


def size_cases():
    for name, why, segments, roller_radius, rise, back, offset in SIZES:
        mp.dps = 60
        follower = {"record": "Roller", "roller_radius": roller_radius} | ({} if offset is None else {"offset": offset})
        inputs = {
            "program": program_text(segments, *MM),
            "follower": follower,
            "rise_limit": rise,
            "return_limit": back,
        }
        yield name, why, inputs, size_answers(segments, roller_radius, rise, back, offset)
    for name, why, segments, least in FLATS:
        mp.dps = 60
        lift = Lift([(span, law, mpf(float(to))) for span, law, to in segments])
        low = extreme(lambda s, t: s(t) + diff(s, t, 2), list(smooth_zones(lift)), -1)
        inputs = {"program": program_text(segments, *MM), "follower": {"record": "FlatFace"}, "least_radius": least}
        yield name, why, inputs, {"base_radius": mpf(float(least)) - low}


def written(task, name, why, inputs, results):
    return {
        "task": task,
        "kind": "hard" if why else "ordinary",
        "name": name,
        **({"why": why} if why else {}),
        "inputs": inputs,
        "results": {key: nstr(value, 40, min_fixed=1, max_fixed=0) for key, value in results.items()},
    }


def main():
    cases = [written("size", *case) for case in size_cases()]
    print(len(cases), "sizes")
    for name, why, segments, follower, turn, side in CASES:
        swing = follower["record"] in ("OscillatingRoller", "OscillatingFlat", "ConjugateOscillatingRoller")
        mp.dps = 60
        found = answers(segments, follower, turn, side, swing)
        text = program_text(segments, *(("deg", 1) if swing else MM))
        inputs = {
            "program": text,
            "follower": follower,
            "rotation": "counter-clockwise" if turn > 0 else "clockwise",
            "flank": "inner" if side > 0 else "outer",
            "points": COUNT,
        }
        cases.append(written("profile", name, why, inputs, found))
        print(name)
    about = "Written by generate_cam_geometry_references.py: SI inputs as doubles, results to 40 digits of 60."
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else DATA / "cam_geometry.json"
    text = json.dumps({"about": about, "cases": cases}, indent=1, ensure_ascii=False)
    target.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
