"""Writes inertia_bodies.json: shapes, assemblies, tensors and torques to 40 digits, for ordinary and hard inputs.

Shapes by quadrature of patches, assemblies by the parallel axis theorem from the origin at 90 digits, principal
moments by mpmath's QR. Run: python tests/references/generate_inertia_bodies_references.py [FILE]. The same bytes
every time.
"""

import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import inertia_found
from case_files import put
from found_cases import numbered
from inertia_exact import answer, exact, rotation
from inertia_scenes import arguments
from mpmath import cos, mp, mpf, nstr, sin

ABOUT = "Written by generate_inertia_bodies_references.py: mass properties of bodies of doubles, to 40 digits."
Case = tuple[str, str, str, str, dict[str, Any]]


SIZES = {
    "radius": (0.02, 2.0),
    "length": (0.05, 3.0),
    "width": (0.05, 2.0),
    "height": (0.05, 2.0),
    "depth": (0.05, 2.0),
    "base": (0.1, 2.0),
    "offset": (-1.0, 2.0),
    "angle": (0.2, 6.2),
    "x_radius": (0.05, 2.0),
    "y_radius": (0.05, 2.0),
    "z_radius": (0.05, 2.0),
    "thickness": (0.001, 0.02),
    "base_radius": (0.05, 2.0),
    "top_radius": (0.05, 2.0),
    "ring_radius": (2.1, 4.0),
}
FIELDS = {
    "rod": "length",
    "ring-rod": "radius",
    "arc-rod": "radius angle",
    "semicircle-rod": "radius",
    "quarter-circle-rod": "radius",
    "triangle": "base height offset",
    "rectangle": "width height",
    "polygon": "vertices",
    "disk": "radius",
    "half-disk": "radius",
    "quarter-disk": "radius",
    "sector": "radius angle",
    "ellipse": "x_radius y_radius",
    "annulus": "radius thickness",
    "cylindrical-shell": "radius length ends",
    "half-cylindrical-shell": "radius length",
    "conical-shell": "radius height closed",
    "frustum-shell": "base_radius top_radius height",
    "spherical-shell": "radius",
    "hemispherical-shell": "radius closed",
    "box-shell": "width depth height",
    "torus-shell": "ring_radius radius",
    "sphere": "radius",
    "hemisphere": "radius",
    "cylinder": "radius length",
    "half-cylinder": "radius length",
    "quarter-cylinder": "radius length",
    "elliptic-cylinder": "x_radius y_radius length",
    "cone": "radius height",
    "frustum": "base_radius top_radius height",
    "paraboloid": "radius height",
    "capsule": "radius length",
    "ellipsoid": "x_radius y_radius z_radius",
    "half-ellipsoid": "x_radius y_radius z_radius",
    "torus": "ring_radius radius",
    "block": "width depth height",
    "wedge": "width height length",
    "prism": "vertices height",
    "regular-prism": "sides radius height",
    "pyramid": "width depth height",
    "tetrahedron": "corners",
    "hollow-sphere": "radius thickness",
    "hollow-hemisphere": "radius thickness",
    "hollow-cylinder": "radius thickness length",
    "closed-cylinder": "radius thickness length",
    "hollow-frustum": "base_radius top_radius thickness height",
    "hollow-block": "width depth height thickness",
    "rectangular-tube": "width depth thickness length",
    "hollow-torus": "ring_radius radius thickness",
}


def draw(generator: random.Random, low: float, high: float) -> float:
    """A double as a person would write it, or any double."""
    value = generator.uniform(low, high)
    return round(value, 3) if generator.random() < 0.4 else value


def sizes(generator: random.Random, shape: str) -> dict[str, Any]:
    made: dict[str, Any] = {"shape": shape}
    for field in FIELDS[shape].split():
        if field == "vertices":
            made[field] = star(generator, generator.randint(3, 8))
        elif field == "corners":
            for name in ("first", "second", "third", "fourth"):
                made[name] = [draw(generator, -1.0, 1.0) for _ in range(3)]
        elif field == "ends":
            made[field] = generator.choice(["open", "one", "both"])
        elif field == "closed":
            made["closed"] = generator.random() < 0.5
        elif field == "sides":
            made[field] = generator.randint(3, 12)
        else:
            made[field] = draw(generator, *SIZES[field])
    return made


def star(generator: random.Random, count: int, at: tuple[float, float] = (0.0, 0.0)) -> list[dict[str, float]]:
    """A polygon whose corners go once around a point."""
    angles = sorted(generator.uniform(0.0, 6.28) for _ in range(count))
    if max(b - a for a, b in zip(angles, [*angles[1:], angles[0] + 6.2832], strict=True)) > 3.0:
        return star(generator, count, at)
    made = []
    for angle in angles:
        r = generator.uniform(0.3, 1.0)
        made.append({"x": at[0] + r * float(cos(angle)), "y": at[1] + r * float(sin(angle))})
    return made


def shapes(generator: random.Random) -> Iterator[Case]:
    for shape in FIELDS:
        for _ in range(2):
            yield "shape", "ordinary", shape, "", {**sizes(generator, shape), "mass": draw(generator, 0.1, 20.0)}
    for shape in [name for name in FIELDS if "thickness" in FIELDS[name].split()]:
        for exponent in (4, 8, 12):
            case = sizes(generator, shape)
            large = case.get("radius") or case.get("width") or case["base_radius"]
            case["thickness"] = float(large) * 10.0**-exponent
            why = f"a wall of 1e-{exponent} of the size: outer less inner loses as many digits unless it is factored"
            yield "shape", "hard", f"{shape}, wall 1e-{exponent}", why, {**case, "mass": 1.0}
    arcs = (1e-9, 1e-5, 0.01, 0.5, 1.49, 1.51, 2.99, 3.01, 3.19, 3.21, 6.2)
    for shape in ("arc-rod", "sector"):
        for angle in arcs:
            why = f"at {angle:g} rad, beside a switch of series: both sides must agree in the last place"
            if angle < 0.1:
                why = f"an arc of {angle:g} rad: its moments are differences that cancel to the fourth power of that"
            yield (
                "shape",
                "hard",
                f"{shape} of {angle} rad",
                why,
                {"shape": shape, "radius": 1.7, "angle": angle, "mass": 2.0},
            )
    for at in (1e3, 1e8):
        why = f"a polygon at {at:g} of its sizes from the origin"
        corners = star(generator, 6, (at, -at))
        yield "shape", "hard", f"polygon at {at:g}", why, {"shape": "polygon", "vertices": corners, "mass": 3.0}
        corners3 = {
            name: [at + generator.uniform(0.0, 1.0), generator.uniform(0.0, 1.0) - at, at + generator.uniform(0.0, 1.0)]
            for name in ("first", "second", "third", "fourth")
        }
        why = f"a tetrahedron at {at:g} of its sizes from the origin"
        yield "shape", "hard", f"tetrahedron at {at:g}", why, {"shape": "tetrahedron", **corners3, "mass": 3.0}
    for ratio in (1e-6, 1e-9):
        why = "a needle: its least principal moment is a share of the others that rounding alone could reach"
        case = {"shape": "triangle", "base": 1.0, "height": ratio, "offset": 0.3, "mass": 1.0}
        yield "shape", "hard", f"sliver triangle {ratio:g}", why, case
        case = {"shape": "wedge", "width": 1.0, "height": ratio, "length": 0.4, "mass": 1.0}
        yield "shape", "hard", f"sliver wedge {ratio:g}", why, case


def turned(generator: random.Random) -> dict[str, Any]:
    way = generator.randrange(4)
    if way == 0:
        axis = [draw(generator, -1.0, 1.0) for _ in range(3)]
        return {"rotation_axis": axis, "rotation_angle": draw(generator, -3.0, 3.0)}
    if way == 1:
        order = generator.choice(["zyx", "zxz", "xyz", "XYZ", "ZYX", "yzy"])
        return {"euler_angles": [draw(generator, -3.0, 3.0) for _ in range(3)], "euler_order": order}
    if way == 2:
        return {"quaternion": [draw(generator, -1.0, 1.0) for _ in range(4)]}
    return {}


def part(generator: random.Random, spread: float = 1.0) -> dict[str, Any]:
    made: dict[str, Any] = {"position": [draw(generator, -spread, spread) for _ in range(3)], **turned(generator)}
    if generator.random() < 0.25:
        return {**made, "mass": draw(generator, 0.1, 4.0)}
    return {**made, **sizes(generator, generator.choice(list(FIELDS))), "mass": draw(generator, 0.1, 4.0)}


NEEDLE = {"shape": "block", "width": 1.0, "depth": 2e-6, "height": 1e-6, "mass": 1.0}
PLATE = {"shape": "block", "width": 1.0, "depth": 0.7, "height": 1e-6, "mass": 1.0}
LEAN = {"rotation_axis": [0.3, -0.5, 0.8], "rotation_angle": 1.1}


def bodies(generator: random.Random) -> Iterator[Case]:
    for count in (1, 2, 3, 5, 8, 12):
        yield "body", "ordinary", f"{count} parts", "", {"parts": [part(generator) for _ in range(count)]}
    for _ in range(4):
        inner = [part(generator) for _ in range(3)]
        yield (
            "body",
            "ordinary",
            "nested",
            "",
            {"parts": [part(generator), {"parts": inner, **turned(generator), "position": [0.3, 0.2, 1.0]}]},
        )
    plate = {"shape": "block", "width": 1.0, "depth": 0.6, "height": 0.05, "density": 7850.0}
    bore = {"shape": "cylinder", "radius": 0.1, "length": 0.05, "density": 7850.0, "subtract": True}
    holes = [{**bore, "position": [x, y, 0.0]} for x, y in ((0.3, 0.1), (-0.3, 0.1), (0.0, -0.15))]
    yield "body", "ordinary", "plate with bores", "", {"parts": [plate, *holes]}
    measured = {
        "mass": 3.0,
        "centroid": [0.1, -0.2, 0.05],
        "tensor": [[0.5, 0.02, -0.01], [0.02, 0.4, 0.03], [-0.01, 0.03, 0.6]],
    }
    yield (
        "body",
        "ordinary",
        "measured",
        "",
        {"parts": [{**measured, **LEAN, "position": [1.0, 2.0, 3.0]}, part(generator)]},
    )
    for at in (1e3, 1e5, 1e8):
        why = f"parts {at:g} of their sizes from the origin: sums about the origin lose twice as many digits"
        far = [part(generator) for _ in range(4)]
        for one in far:
            one["position"] = [x + at for x in one["position"]]
        yield "body", "hard", f"assembly at {at:g}", why, {"parts": far}
    for name, thin in (("needle", NEEDLE), ("plate", PLATE)):
        for at in (0.0, 10.0):
            why = "the least second moment is 1e-12 of the greatest, in axes where no element of the matrix shows it"
            yield (
                "body",
                "hard",
                f"{name} 1e6 turned, at {at:g}",
                why,
                {"parts": [{**thin, **LEAN, "position": [at, -at, 0.3 * at]}]},
            )
    why = "two needles end to end, turned: both the needles' own and their transport terms must be seen along them"
    row = [{**NEEDLE, "position": [0.0, 0.0, 0.0]}, {**NEEDLE, "position": [1.0, 0.0, 0.0]}]
    yield "body", "hard", "two needles in a turned frame", why, {"parts": [{"parts": row, **LEAN}]}
    for share in (1e-3, 1e-6, 1e-9):
        why = f"a hole that leaves a wall of {share:g}: the difference of two solids has lost as many digits"
        outer = {"shape": "sphere", "radius": 1.0, "density": 1000.0}
        inner = {"shape": "sphere", "radius": 1.0 - share, "density": 1000.0, "subtract": True}
        yield "body", "hard", f"ball less ball, wall {share:g}", why, {"parts": [outer, inner]}
    why = "a hole given before the body it is cut from: the running mass must not pass through nothing"
    yield "body", "hard", "hole first", why, {"parts": [{**bore, "position": [0.2, 0.0, 0.0]}, plate]}
    why = "masses 1e12 apart: the small one moves nothing but its own row"
    yield (
        "body",
        "hard",
        "a grain on a hull",
        why,
        {
            "parts": [
                {"mass": 1e6, **{k: v for k, v in PLATE.items() if k != "mass"}},
                {"mass": 1e-6, "position": [5.0, 0.0, 0.0]},
            ]
        },
    )
    why = "a point mass alone has no inertia about itself: zero, and not rounding"
    yield "body", "hard", "one point", why, {"parts": [{"mass": 2.5, "position": [0.1, 0.7, -3.3]}]}
    why = "points on a line in no axis: a rod whose moment about itself is rounding of the transport terms"
    row = [{"mass": 1.0 + k, "position": [0.1 * k, 0.2 * k, 0.3 * k]} for k in range(4)]
    yield "body", "hard", "points on a line", why, {"parts": row}


def tensors(generator: random.Random) -> Iterator[Case]:
    def built(moments: list[float], spec: dict[str, Any]) -> list[list[float]]:
        r = rotation(exact(spec))
        full = r * mp.diag([mpf(x) for x in moments]) * r.T
        rows = [[float(full[i, j]) for j in range(3)] for i in range(3)]
        return [[rows[max(i, j)][min(i, j)] for j in range(3)] for i in range(3)]

    for _ in range(6):
        a, b = draw(generator, 0.5, 4.0), draw(generator, 0.5, 4.0)
        spec = {"quaternion": [generator.uniform(-1.0, 1.0) for _ in range(4)]}
        yield (
            "tensor",
            "ordinary",
            "any",
            "",
            {"tensor": built([a, b, generator.uniform(abs(a - b) + 0.05, a + b - 0.05)], spec)},
        )
    for gap in (1e-6, 1e-12, 1e-15):
        why = f"two moments {gap:g} apart: closed forms lose half the digits there"
        yield "tensor", "hard", f"gap {gap:g}", why, {"tensor": built([1.0, 1.0 + gap, 1.6], LEAN)}
    why = "a lamina's tensor rounded: the sum of the two smaller moments may fall short of the third by rounding"
    yield "tensor", "hard", "lamina turned", why, {"tensor": built([1.0, 0.7, 1.7], LEAN)}


def torques(generator: random.Random) -> Iterator[Case]:
    for _ in range(4):
        w = [draw(generator, -300.0, 300.0) for _ in range(3)]
        alpha = [draw(generator, -50.0, 50.0) for _ in range(3)]
        full = [[2.0, 0.1, -0.05], [0.1, 3.0, 0.2], [-0.05, 0.2, 4.0]]
        yield "torque", "ordinary", "any", "", {"tensor": full, "angular_velocity": w, "angular_acceleration": alpha}
    why = "a rotor nearly round, fast: the gyroscopic part is a difference of moments that agree to nine digits"
    full = [[0.03, 0.0, 0.0], [0.0, 0.04, 0.0], [0.0, 0.0, 0.04 + 4e-11]]
    yield (
        "torque",
        "hard",
        "nearly round rotor",
        why,
        {"tensor": full, "angular_velocity": [0.0, 1000.0, 1000.0], "angular_acceleration": [0.0, 0.0, 0.0]},
    )


def comparisons(generator: random.Random) -> Iterator[Case]:
    for count in (1, 3, 6):
        both = {name: {"parts": [part(generator) for _ in range(count)]} for name in ("first", "second")}
        yield "compare", "ordinary", f"{count} parts each", "", both
    block = {
        "shape": "block",
        "width": 0.6,
        "depth": 0.4,
        "height": 0.1,
        "mass": 2.0,
        **LEAN,
        "position": [0.1, 0.2, 0.3],
    }
    parts = [block, part(generator), part(generator)]
    for nudge in (1e-6, 1e-12):
        why = f"the same assembly, one part moved by {nudge:g}: every difference is that of nearly equal numbers"
        moved = [dict(one) for one in parts]
        moved[0]["position"] = [moved[0]["position"][0] + nudge, *moved[0]["position"][1:]]
        yield "compare", "hard", f"moved by {nudge:g}", why, {"first": {"parts": parts}, "second": {"parts": moved}}
    why = "the same assembly far off: the way between the mass centres is known, what they are made of must not be lost"
    far = [{**one, "position": [x + 1e6 for x in one["position"]]} for one in parts]
    yield "compare", "hard", "far off", why, {"first": {"parts": parts}, "second": {"parts": far}}
    why = "a needle turned by a small angle: the angle between axes comes from a cosine that rounds to one"
    needle = {key: value for key, value in NEEDLE.items() if key != "mass"}
    one = {"parts": [{**needle, "density": 7850.0}]}
    for angle in (1e-5, 1e-9):
        two = {"parts": [{**needle, "density": 7850.0, "rotation_axis": [0.0, 0.0, 1.0], "rotation_angle": angle}]}
        yield "compare", "hard", f"needle turned by {angle:g}", why, {"first": one, "second": two}


def main() -> None:
    generator = random.Random(20260101)
    cases = []
    for task, kind, name, why, inputs in (
        *shapes(generator),
        *bodies(generator),
        *tensors(generator),
        *torques(generator),
        *comparisons(generator),
        *((task, "hard", name, why, inputs) for task, name, why, inputs in inertia_found.BODIES),
    ):
        found = answer(task, inputs)
        largest = max(abs(value) for value in found.values())
        # what quadrature leaves of an exact zero
        found = {key: nstr(value, 40) if abs(value) > 1e-48 * largest else "0.0" for key, value in found.items()}
        entry = {
            "task": task,
            "kind": kind,
            "name": name,
            "why": why,
            "inputs": arguments(task, inputs),
            "results": found,
        }
        cases.append(entry if why else {key: part for key, part in entry.items() if key != "why"})
    put("inertia_bodies", ABOUT, numbered(cases), "  ")


if __name__ == "__main__":
    main()
