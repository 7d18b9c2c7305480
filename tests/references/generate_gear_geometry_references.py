"""Writes gear_geometry.json: gears, pairs, bevels, worms and screws to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_gear_geometry_references.py [FILE]. The same bytes every time. Other ways than the
program's: the involute is solved by Newton in 80 digits, paths of contact are intersections of circles and a line in
coordinates, cones are intersections of unit vectors, friction is a balance of forces, limits are roots.
"""

import random
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from case_files import put
from found_cases import doubles, found
from mpmath import acos, asin, atan, cos, cot, findroot, mp, mpf, pi, sin, sqrt, tan

Case = dict[str, Any]
DEGREE = 0.017453292519943295


def inv(angle: Any) -> Any:
    return tan(angle) - angle


def solved(value: Any) -> Any:
    """The angle of an involute by Newton from above, where the function is convex."""
    if value == 0:
        return mpf(0)
    x = min((3 * value) ** (mpf(1) / 3), pi / 2 - mpf(10) ** -3) if value < 600 else pi / 2 - 1 / (value + pi / 2)
    for _ in range(200):
        step = (tan(x) - x - value) / tan(x) ** 2
        x = x - step
        if abs(step) < abs(x) * mpf(10) ** -75:
            break
    return x


class Gear:
    def __init__(self, z: int, m: Any, alpha: Any, beta: Any, x: Any, rack: tuple[Any, Any, Any]) -> None:
        self.z, self.m, self.alpha, self.beta, self.x = z, m, alpha, beta, x
        self.ha, self.hf, self.rho = rack
        self.alpha_t = atan(tan(alpha) / cos(beta))
        self.r = z * m / cos(beta) / 2
        self.rb = self.r * cos(self.alpha_t)
        self.ra = self.r + m * (self.ha + x)
        self.rf = self.r - m * (self.hf - x)

    def half(self, radius: Any) -> Any:
        """Half the angle of a tooth at a radius, of a space for an internal gear."""
        z = abs(self.z)
        x = self.x
        return (
            (pi / 2 + (2 if self.z > 0 else -2) * x * tan(self.alpha)) / z
            + inv(self.alpha_t)
            - inv(acos(abs(self.rb) / radius))
        )

    def tip_thickness(self) -> Any:
        if self.z > 0:
            return 2 * self.ra * self.half(self.ra)
        radius = abs(self.ra)
        return 2 * radius * (pi / abs(self.z) - self.half(radius))


def one_gear(task: str, given: dict[str, Any], beta: Any, internal: bool) -> dict[str, Any]:
    z = -given["teeth"] if internal else given["teeth"]
    alpha = mpf(given["pressure_angle"])
    gear = Gear(z, mpf(given["pitch"]["module"]), alpha, beta, mpf(given["profile_shift"]), (1, mpf(1.25), mpf(0.38)))
    out = {
        "reference_diameter": 2 * abs(gear.r),
        "base_diameter": 2 * abs(gear.rb),
        "tip_diameter": 2 * abs(gear.ra),
        "root_diameter": 2 * abs(gear.rf),
        "tip_thickness": gear.tip_thickness(),
        "normal_thickness": gear.m * (pi / 2 + 2 * gear.x * tan(alpha)),
        "tip_pressure_angle": acos(abs(gear.rb / gear.ra)),
    }
    if not internal:
        reach = gear.hf - gear.rho * (1 - sin(alpha))
        # the rack's last straight point at the base circle: reach − x = r sin²α_t/m
        out["least_shift"] = reach - gear.r / gear.m * sin(gear.alpha_t) ** 2

        def pointed(x: Any) -> Any:
            return Gear(z, gear.m, alpha, beta, x, (gear.ha, gear.hf, gear.rho)).tip_thickness()

        low, high = mpf(-1), mpf(1)
        while pointed(high) > 0:
            high *= 2
        for _ in range(40):
            middle = (low + high) / 2
            low, high = (middle, high) if pointed(middle) > 0 else (low, middle)
        out["pointed_shift"] = findroot(pointed, (low, high), solver="anderson", tol=mpf(10) ** -140)
    if task == "helical":
        out["transverse_pressure_angle"] = gear.alpha_t
        out["base_helix_angle"] = asin(sin(beta) * cos(alpha))
        out["normal_base_pitch"] = pi * gear.m * cos(alpha)
        out["virtual_teeth"] = abs(z) / (cos(beta) * (1 - (sin(beta) * cos(alpha)) ** 2))
        out["lead"] = 2 * pi * abs(gear.r) / tan(beta)
    return out


def two_gears(given: dict[str, Any], internal: bool, full: bool) -> dict[str, Any]:
    alpha, beta = mpf(given["pressure_angle"]), mpf(given["helix_angle"])
    m = mpf(given["pitch"]["module"])
    rack = (mpf(1), mpf(1.25), mpf(0.38))
    z1, z2 = given["first"]["teeth"], given["second"]["teeth"] * (-1 if internal else 1)
    g1 = Gear(z1, m, alpha, beta, mpf(given["first"]["profile_shift"]), rack)
    g2 = Gear(z2, m, alpha, beta, mpf(given["second"]["profile_shift"]), rack)
    tight = solved(inv(g1.alpha_t) + 2 * (g1.x + g2.x) * tan(alpha) / (z1 + z2))
    tight_distance = (g1.r + g2.r) * cos(g1.alpha_t) / cos(tight)
    if "centre_distance" in given:
        a = mpf(given["centre_distance"]) * (-1 if internal else 1)
        angle = acos((g1.rb + g2.rb) / a)
    else:
        a, angle = tight_distance, tight
    k = min((a - (g1.r + g2.r)) / m - g1.x - g2.x, 0) if not full else mpf(0)
    ra1, ra2 = g1.ra + k * m, g2.ra + k * m
    # coordinates: centre of the first at the origin, of the second at (|a|, 0) or, internal, at (−|a|, 0)
    centre = a
    pitch = mpf(a * z1) / (z1 + z2)
    direction = (-sin(angle), cos(angle))
    # points pitch + s·direction on the second's tip circle; of the two the one nearer the first's tangent point
    b = (pitch - centre) * direction[0]
    c = (pitch - centre) ** 2 - ra2**2
    roots = [-b - sqrt(b * b - c), -b + sqrt(b * b - c)]
    touch = -pitch * direction[0]  # foot of the perpendicular from the first centre
    start = min(roots, key=abs if internal else lambda s: abs(s - touch))
    b1 = pitch * direction[0]
    own = [-b1 - sqrt(b1 * b1 - pitch**2 + ra1**2), -b1 + sqrt(b1 * b1 - pitch**2 + ra1**2)]
    # the first tangent point lies on the side of `touch`
    sign = 1 if touch < 0 else -1
    end = max(own, key=lambda s: sign * s)
    rho_start, rho_end = sign * (start - touch), sign * (end - touch)
    rho_pitch = g1.rb * tan(angle)
    base = 2 * pi * g1.rb / z1
    u = mpf(z2) / z1
    line = a * sin(angle)

    def sliding(rho: Any) -> tuple[Any, Any]:
        """Speeds along the flanks from rotations 1 and 1/u."""
        first, second = rho, (line - rho) / u
        return (first - second) / first, (second - first) / second

    out = {
        "centre_distance": abs(a),
        "working_pressure_angle": angle,
        "first_working_diameter": 2 * abs(pitch),
        "first_tip_diameter": 2 * ra1,
        "second_tip_diameter": 2 * abs(ra2),
        "nominal": (rho_end - rho_start) / base,
        "margin": rho_start,
        "first_sliding_at_start": sliding(rho_start)[0],
        "second_sliding_at_end": sliding(rho_end)[1],
        "recess_length": rho_end - rho_pitch,
    }
    if "centre_distance" in given:
        # backlash: what two teeth leave of the pitch on the working circles
        r1, r2 = abs(pitch), abs(a - pitch)
        s1 = 2 * r1 * g1.half(r1)
        s2 = 2 * r2 * (g2.half(r2) if not internal else pi / abs(z2) - g2.half(r2))
        out["circumferential_backlash"] = 2 * pi * r1 / z1 - s1 - s2
    return out


def cones(given: dict[str, Any]) -> dict[str, Any]:
    """Pitch cones from the axis of rotation of the wheel relative to the pinion, as vectors."""
    shafts = mpf(given["shaft_angle"])
    z1, z2, m = given["first_teeth"], given["second_teeth"], mpf(given["module"])
    # the common generator g obeys z2·sin(g, k2)… : combine unit axes with weights z2 and z1
    gx, gy = z2 * 1 + z1 * cos(shafts), z1 * sin(shafts)
    first = acos(gx / sqrt(gx * gx + gy * gy))
    second = shafts - first
    cone = z1 * m / (2 * sin(first))
    width = mpf(given["face_width"])
    depth = mpf(1.25) * m
    tip = first + atan(m / cone)
    return {
        "cone_distance": cone,
        "first.pitch_angle": first,
        "second.pitch_angle": second,
        "first.tip_angle": tip,
        "second.root_angle": second - atan(depth / cone),
        "second.tip_distance": cone * cos(second) - m * sin(second),
        "first.inner_diameter": z1 * m + 2 * m * cos(first) - 2 * width * sin(tip) / cos(atan(m / cone)),
        "mean_module": m * (cone - width / 2) / cone,
        "crown_teeth": z1 / sin(first),
    }


def screw(given: dict[str, Any]) -> dict[str, Any]:
    """A worm's efficiency both ways from the force balance of its flank."""
    m, d = mpf(given["size"]["module"]), mpf(given["worm"]["worm_diameter"])
    z1, z2, mu, alpha = given["threads"], given["teeth"], mpf(given["friction"]), mpf(given["pressure_angle"])
    lead = atan(z1 * m / d)
    # unit normal force on the flank: along the axis, round the worm, with friction along the thread
    axial = cos(alpha) * cos(lead) - mu * sin(lead)
    round_ = cos(alpha) * sin(lead) + mu * cos(lead)
    back_axial = cos(alpha) * cos(lead) + mu * sin(lead)
    back_round = cos(alpha) * sin(lead) - mu * cos(lead)
    return {
        "lead_angle": lead,
        "centre_distance": (d + z2 * m) / 2 + mpf(given["profile_shift"]) * m,
        "efficiency": tan(lead) * axial / round_,
        "backward_efficiency": back_round / (tan(lead) * back_axial),
        "locking_margin": atan(mu / cos(alpha)) - lead,
        "worm_axial_force": 2 * mpf(given["torque"]) / d * axial / round_,
        "radial_force": 2 * mpf(given["torque"]) / d * sin(alpha) / round_,
    }


def crossed(given: dict[str, Any]) -> dict[str, Any]:
    alpha, m = mpf(given["pressure_angle"]), mpf(given["module"])
    virtual, reference = mpf(0), mpf(0)
    for name in ("first", "second"):
        beta = mpf(given[name]["helix_angle"])
        virtual += given[name]["teeth"] / cos(beta) ** 3
        reference += given[name]["teeth"] * m / cos(beta) / 2
    shift = mpf(given["first"]["profile_shift"]) + mpf(given["second"]["profile_shift"])
    angle = solved(inv(alpha) + 2 * shift * tan(alpha) / virtual)
    y = virtual / 2 * (cos(alpha) / cos(angle) - 1)
    a = reference + y * m
    helices = [acot_helix(mpf(given[name]["helix_angle"]), a / reference) for name in ("first", "second")]
    return {
        "centre_distance": a,
        "working_pressure_angle": angle,
        "distance_modification": y,
        "first_working_helix": helices[0],
        "shaft_angle": abs(helices[0] + helices[1]),
    }


def acot_helix(beta: Any, growth: Any) -> Any:
    return pi / 2 - atan(cot(beta) / growth) if beta > 0 else -(pi / 2 - atan(cot(-beta) / growth))


def gear_case(kind: str, name: str, z: int, x: float, **more: Any) -> Case:
    beta = more.get("beta", 0.0)
    task = "helical" if beta else "spur"
    given: dict[str, Any] = {
        "teeth": z,
        "pitch": {"record": "NormalModule", "module": more.get("m", 0.003)},
        "pressure_angle": more.get("alpha", 20.0 * DEGREE),
        "profile_shift": x,
    }
    if beta:
        given["helix_angle"] = beta
    internal = more.get("internal", False)
    results = one_gear(task, given, mpf(beta), internal)
    return made(task, kind, name, more.get("why", ""), given, {"internal": internal}, results)


def pair_case(kind: str, name: str, z1: int, z2: int, x1: float, x2: float, **more: Any) -> Case:
    given: dict[str, Any] = {
        "first": {"record": "Mate", "teeth": z1, "profile_shift": x1},
        "second": {"record": "Mate", "teeth": z2, "profile_shift": x2},
        "pitch": {"record": "NormalModule", "module": more.get("m", 0.003)},
        "pressure_angle": more.get("alpha", 20.0 * DEGREE),
        "helix_angle": more.get("beta", 0.0),
    }
    if "a" in more:
        given["centre_distance"] = more["a"]
    internal, tips = more.get("internal", False), more.get("tips", "full")
    results = two_gears(given, internal, tips == "full")
    return made("pair", kind, name, more.get("why", ""), given, {"internal": internal, "tips": tips}, results)


def made(
    task: str, kind: str, name: str, why: str, given: dict[str, Any], choices: dict[str, Any], results: dict[str, Any]
) -> Case:
    case: Case = {"task": task, "kind": kind, "name": name}
    if why:
        case["why"] = why
    case["inputs"] = written(given)
    case["choices"] = choices
    case["results"] = {key: mp.nstr(value, 40, strip_zeros=False) for key, value in results.items()}
    return case


def written(tree: Any) -> Any:
    if isinstance(tree, float):
        return repr(tree)
    return {name: written(part) for name, part in tree.items()} if isinstance(tree, dict) else tree


def bevel_case(kind: str, name: str, z1: int, z2: int, shafts: float, why: str = "") -> Case:
    given = {"first_teeth": z1, "second_teeth": z2, "module": 0.003, "shaft_angle": shafts, "face_width": 0.006}
    return made("bevel", kind, name, why, given, {"kind": "standard"}, cones(given))


def worm_case(kind: str, name: str, z1: int, z2: int, d: float, mu: float, why: str = "") -> Case:
    given: dict[str, Any] = {
        "threads": z1,
        "teeth": z2,
        "size": {"record": "AxialModule", "module": 0.004},
        "worm": {"record": "WormDiameter", "worm_diameter": d},
        "pressure_angle": 20.0 * DEGREE,
        "profile_shift": 0.1,
        "friction": mu,
        "torque": 7.5,
    }
    return made("worm", kind, name, why, given, {}, screw(given))


def crossed_case(
    kind: str, name: str, first: tuple[int, float, float], second: tuple[int, float, float], why: str = ""
) -> Case:
    given: dict[str, Any] = {
        key: {"record": "Screw", "teeth": z, "helix_angle": beta * DEGREE, "profile_shift": x}
        for key, (z, beta, x) in (("first", first), ("second", second))
    }
    given |= {"module": 0.003, "pressure_angle": 20.0 * DEGREE}
    return made("crossed", kind, name, why, given, {}, crossed(given))


def involute_cases() -> list[Case]:
    generator = random.Random(17)
    bands = [(1e-8, 1e-3), (1e-3, 0.08), (0.08, 0.6), (0.6, 1.2), (1.2, 1.5707)]
    cases = []
    for low, high in bands:
        for _ in range(6):
            angle = low * (high / low) ** generator.random()
            hard = low < 1e-3 or high > 1.5
            small = "tan φ − φ is φ³/3 at so small an angle: the difference loses every digit"
            steep = "tan φ is near its pole: an angle's last place moves the involute by many of its own"
            why = small if low < 1e-3 else steep
            given = {"phi": angle}
            value = inv(mpf(angle))
            cases.append(
                made(
                    "inv",
                    "hard" if hard else "ordinary",
                    f"inv {angle:.3g}",
                    why if hard else "",
                    given,
                    {},
                    {"value": value},
                )
            )
            given = {"value": float(value)}
            cases.append(
                made(
                    "inverse",
                    "hard" if hard else "ordinary",
                    f"inverse {angle:.3g}",
                    why if hard else "",
                    given,
                    {},
                    {"phi": solved(mpf(given["value"]))},
                )
            )
    join = "at a join or an end of the series' range: both sides must give the same to the last place"
    ends = (0.6848532563722795, 0.6848532563722797, 1e-24, 5e5, 1e9)
    cases += [
        made("inverse", "hard", f"inverse of {value}", join, {"value": value}, {}, {"phi": solved(mpf(value))})
        for value in ends
    ]
    return cases


def ordinary() -> list[Case]:
    generator = random.Random(1717)
    cases = []
    for index in range(12):
        z1, z2 = generator.randint(14, 40), generator.randint(41, 120)
        x1, x2 = round(generator.uniform(0.1, 0.6), 3), round(generator.uniform(-0.2, 0.5), 3)
        beta = 0.0 if index % 2 else round(generator.uniform(5, 35), 2) * DEGREE
        cases.append(gear_case("ordinary", f"gear {index}", z1, x1, beta=beta))
        tips = "clearance" if index % 3 else "full"
        cases.append(pair_case("ordinary", f"pair {index}", z1, z2, x1, x2, beta=beta, tips=tips))
        angle = generator.uniform(20.0, 150.0) * DEGREE
        cases.append(bevel_case("ordinary", f"bevel {index}", z1, z2, angle))
        cases.append(
            worm_case(
                "ordinary", f"worm {index}", generator.randint(1, 5), z2, 0.04 + 0.002 * index, 0.02 + 0.01 * index
            )
        )
    cases.append(pair_case("ordinary", "internal", 16, 48, 0.2, -0.1, internal=True))
    cases.append(pair_case("ordinary", "wide", 20, 43, 0.3, 0.2, a=0.0962))
    cases.append(pair_case("ordinary", "published, handbook table 4.1", 12, 24, 0.0, 0.0))
    cases.append(pair_case("ordinary", "published, handbook table 4.3", 12, 24, 0.6, 0.36))
    cases.append(crossed_case("ordinary", "screws", (15, 20.0, 0.4), (24, 30.0, 0.2)))
    return cases


def hard() -> list[Case]:
    cases = [
        gear_case("hard", f"z = {z}", z, x, why="few teeth: the thickness at the tip is a difference of large angles")
        for z, x in ((4, 0.1), (5, 0.3), (6, 0.4), (7, 0.45), (8, 0.54), (9, 0.6))
    ]
    cases += [
        gear_case(
            "hard",
            "nearly pointed",
            12,
            0.82020,
            why=("the tip thickness vanishes at x = 0.820204: here it is what is left of two angles that agree"),
        ),
        gear_case(
            "hard",
            "z = 1000",
            1000,
            0.5,
            why=(
                "a thousand teeth: inv α and inv α_a agree in their leading digits, and the tooth is their difference"
            ),
        ),
        gear_case(
            "hard",
            "large shift",
            40,
            1.3,
            why=("tips far outside the reference circle, near where the tooth comes to a point"),
        ),
        gear_case(
            "hard",
            "x = -12, z = 1000",
            1000,
            -12.0,
            why=("a shift of −12: tips lie inside the reference circle, and inv α_a is less than inv α"),
        ),
        gear_case(
            "hard",
            "helix 0.01 deg",
            20,
            0.2,
            beta=0.01 * DEGREE,
            why=("a helix of 0.01 deg: the lead is a quotient by a tangent that all but vanishes"),
        ),
        gear_case(
            "hard",
            "helix 70 deg",
            20,
            0.2,
            beta=70.0 * DEGREE,
            why="a steep helix: the normal section is far from the transverse",
        ),
        gear_case(
            "hard",
            "pressure angle 22.5 deg",
            20,
            0.3,
            alpha=22.5 * DEGREE,
            why=("the rack's corner just fits between its flanks: the land between corners is a difference near zero"),
        ),
        gear_case(
            "hard",
            "internal",
            36,
            -0.2,
            internal=True,
            why=("an internal gear: diameters are negative throughout, and roots must take the right sign"),
        ),
        gear_case(
            "hard",
            "internal tip near its base circle",
            34,
            0.0,
            internal=True,
            why="the tip lies next to the base circle: √(d_a² − d_b²) of nearly equal diameters",
        ),
    ]
    # shifts of an internal pair that bring inv α_w towards 0: Σx = inv α·(z₂ − z₁)/(2 tan α)·(1 − δ)
    close = "inv α_w is what is left of a cancellation: the bound grows with 1/tan α_w"
    for delta in (1e-2, 1e-4, 1e-6, 1e-9, 1e-12):
        total = 0.014904383867336446 * 40 / (2 * 0.36397023426620234) * (1.0 - delta)
        name = f"α_w to 0, {delta:g}"
        cases += [pair_case("hard", name, 20, 60, 0.6 * total, 0.4 * total, internal=True, why=close)]
    cases += [
        pair_case(
            "hard",
            "internal, z2 − z1 = 1",
            30,
            31,
            0.0,
            -1.0,
            internal=True,
            why="z₂ − z₁ = 1: inv α_w is ruled by the shifts, divided by one tooth only",
        ),
        pair_case(
            "hard",
            "internal, z2 − z1 = 2",
            60,
            62,
            0.1,
            -0.9,
            internal=True,
            why="z₂ − z₁ = 2: the working angle is above 45°, where its involute grows fast",
        ),
        pair_case(
            "hard",
            "steep helix",
            12,
            30,
            0.1,
            0.0,
            beta=50.0 * DEGREE,
            why=("a helix above 45°: twist and transverse sizes outgrow the normal ones, tan β exceeds one"),
        ),
        pair_case(
            "hard",
            "one to one thousand",
            20,
            1000,
            0.4,
            -0.4,
            why=("one to fifty: the pinion's part of the path of contact is a small difference of long ones"),
        ),
        pair_case(
            "hard",
            "tiny backlash",
            20,
            43,
            0.3,
            0.2,
            a=0.095937,
            why="backlash is what is left of two involute functions that agree in their first digits",
        ),
        pair_case(
            "hard",
            "published, handbook table 4.6",
            16,
            24,
            0.0,
            -0.5,
            internal=True,
            why="the pinion's contact would begin 0.03 mm beyond its base circle: a sign, left of a difference",
        ),
        pair_case(
            "hard",
            "eight teeth",
            8,
            9,
            0.54,
            0.5,
            tips="clearance",
            why=(
                "eight teeth on nine: tips are cut back by what the shifts exceed "
                "the spread of the axes, a small difference"
            ),
        ),
        bevel_case(
            "hard",
            "shafts 1 deg",
            20,
            21,
            1.0 * DEGREE,
            "shafts a degree apart: cones are nearly cylinders, distances quotients by the sine of their angles",
        ),
        bevel_case(
            "hard",
            "shafts 179 deg",
            20,
            60,
            179.0 * DEGREE,
            "shafts a degree from opposed: an internal wheel, its cone angle near 180°, the sine of it small",
        ),
        bevel_case(
            "hard",
            "crown",
            20,
            40,
            120.0 * DEGREE,
            "the wheel's cone is flat: the cosine of its angle is nothing but rounding",
        ),
        bevel_case(
            "hard",
            "just internal",
            20,
            40,
            120.0001 * DEGREE,
            "the wheel's cone is just beyond flat: its cosine is small and negative",
        ),
        worm_case(
            "hard",
            "at the limit of self-locking",
            1,
            40,
            0.0400,
            0.0939693,
            "lead angle and angle of friction agree in six digits",
        ),
        worm_case(
            "hard",
            "no friction",
            3,
            40,
            0.05,
            0.0,
            "no friction: the efficiency is exactly one both ways, and losses are zeros, not small",
        ),
        crossed_case(
            "hard",
            "shafts that are nearly parallel",
            (15, 20.0, 0.0),
            (24, -19.999, 0.0),
            "the helices cancel but for 0.001°: four digits of the shafts' angle go with them",
        ),
        crossed_case(
            "hard",
            "large negative shifts",
            (20, 45.0, -0.9),
            (30, 45.0, -0.9),
            "shifts take three quarters of inv α_n away: the working angle is solved from the small rest",
        ),
    ]
    return cases


def searched() -> list[Case]:
    """The worst that the search for broken bounds has found."""
    cases = []
    for case in found("gear_geometry.json"):
        task, choices, given = case["task"], case["choices"], doubles(case["inputs"])
        if task in ("spur", "helical"):
            results = one_gear(task, given, mpf(given.get("helix_angle", 0.0)), choices["internal"])
        elif task == "pair":
            results = two_gears(given, choices["internal"], choices["tips"] == "full")
        else:
            results = {"bevel": cones, "worm": screw, "crossed": crossed}[task](given)
        cases.append(made(task, "hard", case["name"], case["why"], given, choices, results))
    return cases


def main() -> None:
    mp.dps = 80
    cases = [*involute_cases(), *ordinary(), *hard(), *searched()]
    about = "Written by generate_gear_geometry_references.py: SI inputs as doubles, results to 40 digits of 80."
    put("gear_geometry", about, cases)


if __name__ == "__main__":
    main()
