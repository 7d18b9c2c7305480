"""Writes gear_meshes.json: meshes, unknown gears, data blocks and profiles to 40 digits, by ways of their own.

Run: python tests/references/generate_gear_meshes_references.py [FILE]. The same bytes every time.

Meshes: involutes as roots of tan α − α, the root as the envelope of the rolled rack, least distances where two curves
run along one another (gear_mesh_exact.py). Unknown gears and data blocks: arcs of the base circle unrolled, standard
sizes as exact fractions (gear_table_exact.py). Profiles: circles of the rack, the junction by a bracket in its corner.
"""

import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import gear_exact as exact
from case_files import put
from found_cases import doubles, found
from gear_exact import Tooth
from gear_mesh_exact import Mesh, shares
from gear_table_exact import all_candidates, candidate, data_block

TWENTY = 0.3490658503988659
POINTS, SHOWN = 101, 3
Case = tuple[str, str, dict[str, Any]]


def teeth_of(given: dict[str, Any], teeth: int, *, x: float = 0.0, **more: Any) -> Tooth:
    """A gear of a case's inputs."""
    return Tooth(
        teeth, given["pitch"]["module"], alpha=given["pressure_angle"], beta=given.get("helix_angle", 0.0), x=x,
        rho=given.get("root_radius_factor"), addendum=given.get("addendum_factor"),
        dedendum=given.get("dedendum_factor"), **more,
    )  # fmt: skip


# ---- meshes ----


def mesh_of(given: dict[str, Any]) -> Mesh:
    """The mesh of a case's inputs."""
    first = teeth_of(given, given["first_teeth"], x=given["first_profile_shift"], tip=given.get("first_tip_diameter"))
    second = teeth_of(
        given, given["second_teeth"], x=given["second_profile_shift"], internal=given["internal"],
        tip=given.get("second_tip_diameter"),
    )  # fmt: skip
    return Mesh(first, second, given.get("centre_distance"))


def mesh(given: dict[str, Any]) -> dict[str, Any]:
    """Every result of a mesh, some points of contact with them."""
    made = mesh_of(given)
    out = made.closed() | made.gaps()
    for index, share in enumerate(shares(given["points"], given["shown"])):
        out |= {f"path.{name}[{index}]": value for name, value in made.point(share).items()}
    return out


def pair(first: int, second: int, x1: float = 0.0, x2: float = 0.0, m: float = 0.003, **more: Any) -> dict[str, Any]:
    """The inputs of a mesh."""
    own = {"pressure_angle": TWENTY, "internal": False, "points": POINTS, "shown": SHOWN, **more}
    if own["internal"]:
        own.setdefault("root_radius_factor", 0.2)
    return {
        "first_teeth": first, "second_teeth": second, "pitch": {"record": "NormalModule", "module": m},
        "first_profile_shift": x1, "second_profile_shift": x2, **own,
    }  # fmt: skip


def meshes(rng: random.Random) -> Iterator[Case]:
    """Random pairs, and the hard ones."""
    for _ in range(12):
        first = rng.randint(14, 60)
        internal = rng.random() < 0.3
        second = first + rng.randint(20, 80) if internal else rng.randint(14, 150)
        beta = rng.choice([0.0, 0.0, round(rng.uniform(0.1, 0.6), 3)])
        shifts = (round(rng.uniform(0.0, 0.5), 3), round(rng.uniform(-0.1, 0.4), 3))
        yield (
            "",
            "",
            pair(first, second, *shifts, rng.choice([0.001, 0.003, 0.003175]), helix_angle=beta, internal=internal),
        )
    yield (
        "few teeth",
        "shifts balance a pinion of twelve: the root's distance is a hundredth of a module",
        pair(12, 24, 0.6, 0.36),
    )
    yield "undercut clips", "eight teeth: the contact begins at the form circle of an undercut root", pair(8, 60)
    yield (
        "long teeth",
        "the wheel's tips dig into the pinion's root by a hundredth of a module",
        pair(20, 200, second_tip_diameter=0.6066),
    )
    yield (
        "undercut and dug into",
        ("the tip's edge runs nearly along an undercut root: the least distance lies in a flat valley"),
        pair(13, 118, -0.323, -0.326, helix_angle=0.6),
    )
    yield (
        "root bends where the flank begins",
        ("half of what the edge digs into lies within a thousandth of the root's length"),
        pair(32, 107, 0.056, 0.629, 0.003175, internal=True),
    )
    yield (
        "a hair apart",
        "the distance leaves a backlash of 1e-9 modules: a difference of nearly equal involutes",
        pair(20, 40, centre_distance=0.09000000000411),
    )
    yield (
        "large negative shifts",
        "the working angle falls to fourteen degrees, and little is left of the path between long trochoids",
        pair(300, 360, -3.5, -3.5),
    )
    yield (
        "one tooth of difference",
        "a ring with one tooth more: the distance is a sixtieth of the radii",
        pair(
            60, 61, 0.0, -1.0, 0.002, internal=True, addendum_factor=0.5, dedendum_factor=0.7, root_radius_factor=0.05
        ),
    )
    yield "a thousand teeth", "every length is a small difference of large radii", pair(400, 1000, 0.1, -0.1)
    yield (
        "steep helix",
        "a helix of 60 degrees: tips and base circles differ by little",
        pair(20, 30, 0.1, 0.2, helix_angle=1.0471975511965976),
    )
    yield (
        "pressure angle of ten degrees",
        "involutes of angles of nothing, and deep undercut",
        pair(40, 60, 0.3, 0.3, pressure_angle=0.17453292519943295),
    )
    yield (
        "tip at the base circle",
        "the ring's tips just reach beyond its base circle: the path ends near no curvature",
        pair(16, 34, 0.2, 0.012, internal=True),
    )
    yield (
        "jammed",
        "the centre distance is too small by a thousandth: overlap of flanks, negative backlash",
        pair(25, 50, centre_distance=0.112497),
    )
    # the worst that searches found
    yield (
        "found, a hair deep",
        "the edge digs into the root by a ten-millionth of a module, between the places where it crosses the root",
        pair(
            393,
            16,
            0.28059320191162274,
            0.6479395709089599,
            0.001,
            helix_angle=0.24855435067861348,
        ),
    )
    yield (
        "found, large ring off its distance",
        "lengths of a hundred modules leave a contact ratio of one and a half",
        pair(
            351,
            410,
            -0.2554291806299496,
            0.4349108029207408,
            0.003175,
            internal=True,
            pressure_angle=0.27127427340125215,
            centre_distance=0.09306731850723869,
        ),
    )
    yield (
        "found, helical ring",
        "six hundred teeth at a helix of 33 degrees, a pinion nearly as large",
        pair(
            568,
            622,
            0.07162724524018202,
            0.12450812757054398,
            0.0030055571731741524,
            internal=True,
            pressure_angle=0.413326504047819,
            helix_angle=0.5835828616132724,
        ),
    )
    yield (
        "found, undercut meets a bend",
        "the junction is where the edge crosses: which of three distances is least hangs on a hair",
        pair(
            17,
            22,
            -0.24661897543978262,
            0.7714692149005655,
            pressure_angle=0.211075379894454,
            helix_angle=0.02276415635271324,
        ),
    )
    yield "micro gears", "a module of a hundredth of a millimetre", pair(15, 45, 0.3, 0.1, 1e-5)


# ---- unknown gears ----


def unknown(given: dict[str, Any]) -> dict[str, Any]:
    """The best candidates, in order."""
    read = reading_of(given)
    out: dict[str, Any] = {}
    best = all_candidates(read)
    for index, (_, name, degrees) in enumerate(best[: given["count"]]):
        one = candidate(name, degrees, **read)
        out |= {f"candidates[{index}].{key}": value for key, value in one.items()}
    overs = sorted((one["over"], one["length"]) for one in given["spans"])
    if len(overs) > 1:
        (low, shortest), (high, longest) = overs[0], overs[-1]
        out["base_pitch"] = (exact.Exact(longest) - exact.Exact(shortest)) / (high - low)
    return out


def reading_of(given: dict[str, Any]) -> dict[str, Any]:
    """What was read, in the words of the exact formulas."""
    return {
        "teeth": given["teeth"],
        "spans": [(one["over"], one["length"]) for one in given["spans"]],
        "tip": given.get("tip_diameter"),
        "beta": given["helix_angle"],
        "reading": given["reading"],
    }


def readings(
    teeth: int, module: float, alpha: float, x: float, overs: tuple[int, ...], *, noise: tuple[float, ...] = (),
    helix_angle: float = 0.0, tip: bool = True, reading: float = 2e-5, addendum: float = 1.0,
) -> dict[str, Any]:  # fmt: skip
    """The readings of a gear, off by some noise."""
    from gear_table_exact import unrolled

    gear = Tooth(teeth, module, alpha=alpha, beta=helix_angle, x=x)
    lengths = [float(unrolled(gear, gear.solid, over)) for over in overs]
    moved = [round(one + off, 7) for one, off in zip(lengths, noise or (0.0,) * len(overs), strict=True)]
    given: dict[str, Any] = {
        "teeth": teeth,
        "spans": [{"record": "SpanRead", "over": over, "length": one} for over, one in zip(overs, moved, strict=True)],
        "helix_angle": helix_angle,
        "reading": reading,
        "count": 3,
    }
    if tip:
        given["tip_diameter"] = round(2.0 * float(gear.r + gear.m * (addendum + x)), 7)
    return given


def unknowns(rng: random.Random) -> Iterator[Case]:
    """Gears read, ordinary and hard."""
    for _ in range(10):
        teeth = rng.randint(15, 90)
        k = max(2, teeth // 8)
        alpha = rng.choice([TWENTY, TWENTY, 0.25307274153917776, 0.4363323129985824])
        module = rng.choice([0.001, 0.002, 0.003, 0.0254 / 8])
        noise = (rng.uniform(-1e-5, 1e-5), rng.uniform(-1e-5, 1e-5))
        beta = rng.choice([0.0, 0.0, 0.3])
        yield (
            "",
            "",
            readings(teeth, module, alpha, round(rng.uniform(-0.2, 0.5), 3), (k, k + 1), noise=noise, helix_angle=beta),
        )
    alike = 0.25307274153917776
    yield (
        "one span",
        "no base pitch: module and angle are told by the tips alone",
        readings(32, 0.0254 / 8, alike, 0.0, (3,)),
    )
    yield (
        "no tips",
        "only m cos α is known: every pressure angle fits",
        readings(24, 0.003, TWENTY, 0.4, (3, 4), tip=False),
    )
    yield (
        "exact readings",
        "the base pitch is right to the last bit: its error is a difference of equal numbers",
        readings(40, 0.004, TWENTY, 0.0, (5, 6), reading=1e-7),
    )
    yield (
        "coarse readings",
        "a reading good for a fifth of a millimetre: dozens fit",
        readings(20, 0.002, TWENTY, 0.1, (3, 4), noise=(1e-4, -1e-4), reading=2e-4),
    )
    yield (
        "a shift of one module",
        "where a shift begins to count against a candidate",
        readings(60, 0.005, TWENTY, 1.0, (10, 11)),
    )
    yield (
        "steep helix",
        "a helix of 45 degrees: the tips stand on a diameter over cos β",
        readings(30, 0.002, TWENTY, 0.2, (6, 7), helix_angle=0.7853981633974483),
    )
    yield (
        "a thousand teeth",
        "the shift is what is left of a span of half a metre",
        readings(1000, 0.001, TWENTY, 0.1, (110, 115)),
    )
    yield (
        "five teeth",
        "few teeth: spans over one and two, whose difference is all that tells the base pitch",
        readings(5, 0.01, TWENTY, 0.5, (1, 2), addendum=0.8),
    )
    yield (
        "many spans",
        "four spans, one of them off: it must not drag the base pitch that the others agree on",
        readings(48, 0.0025, TWENTY, 0.0, (4, 5, 6, 7), noise=(0.0, 3e-5, -2e-5, 0.0)),
    )
    yield (
        "found, one span of a large gear",
        "an eighty-tooth gear's span of 24 cm read to a micrometre: the shift is a difference of spans",
        {
            "teeth": 80,
            "spans": [{"record": "SpanRead", "over": 8, "length": 0.2384116}],
            "helix_angle": 0.0,
            "reading": 8.429216498749583e-07,
            "count": 3,
            "tip_diameter": 0.8274146,
        },
    )
    yield (
        "watch gear",
        "a module of 0.12 mm, which no double is",
        readings(16, 0.00012, TWENTY, 0.0, (2, 3), reading=1e-6),
    )
    yield (
        "two sizes nearly one",
        "module 3.175 mm of 8 DP beside others of nearly its base pitch",
        readings(33, 0.0254 / 8, 0.2617993877991494, 0.3, (3, 6), noise=(1e-5, -1e-5)),
    )


# ---- data blocks ----


def block(given: dict[str, Any]) -> dict[str, Any]:
    """The numbers of a data block by their symbols."""
    tooth = teeth_of(given, given["teeth"], x=given["profile_shift"], internal=given["internal"])
    return data_block(
        tooth, given.get("over"), given.get("pin"), given.get("upper_allowance"), given.get("lower_allowance")
    )


def drawn(teeth: int, m: float, x: float = 0.0, over: int | None = None, pin: float | None = None, **more: Any) -> dict:
    """The inputs of a data block."""
    given = {
        "teeth": teeth, "pitch": {"record": "NormalModule", "module": m}, "profile_shift": x, "pressure_angle": TWENTY,
        "helix_angle": 0.0, "internal": False, "decimals": 9, **more,
    }  # fmt: skip
    given |= {name: value for name, value in (("over", over), ("pin", pin)) if value is not None}
    if given["internal"]:
        given.setdefault("root_radius_factor", 0.2)
    return given


def blocks(rng: random.Random) -> Iterator[Case]:
    """Data blocks to nine decimals, ordinary and hard."""
    for _ in range(10):
        teeth, x = rng.randint(18, 90), round(rng.uniform(-0.1, 0.4), 3)
        m = rng.choice([0.001, 0.002, 0.0035])
        beta = rng.choice([0.0, round(rng.uniform(0.1, 0.6), 3)])
        over = max(2, round(teeth / float(exact.cos(exact.Exact(beta))) ** 3 / 9 + 0.5 + x))
        yield "", "", drawn(teeth, m, x, over, round(1.8 * m, 5), helix_angle=beta, decimals=rng.choice([4, 6, 9]))
    yield (
        "allowances",
        "greatest and least sizes of thinned teeth",
        drawn(31, 0.0035, 0.0, 5, 0.006, helix_angle=0.3665191429188092, upper_allowance=-7e-5, lower_allowance=-11e-5),
    )
    yield (
        "ends in a five",
        "sizes whose next decimal is a five: a rounding decides the last digit",
        drawn(20, 0.00212345, 0.0, 3, 0.004, decimals=4),
    )
    yield "odd teeth", "balls that do not stand opposite one another", drawn(17, 0.004, 0.3, 3, 0.0072)
    yield (
        "five teeth",
        "an undercut root: its form diameter is where the trochoid meets the involute",
        drawn(5, 0.005, 0.35, 1, 0.0105, addendum_factor=0.7),
    )
    yield (
        "a thousand teeth",
        "a reference diameter of two metres to a millionth of a millimetre",
        drawn(1000, 0.002, 0.0, 112, 0.0034),
    )
    yield (
        "whole millimetres",
        "no decimals at all: half of a millimetre decides every digit that is printed",
        drawn(40, 0.005, 0.25, 5, 0.009, decimals=0),
    )
    yield (
        "internal",
        "a ring: sizes between balls are less by both radii, and signs of shifts turn round",
        drawn(72, 0.002, -0.1, 8, 0.0034, internal=True),
    )
    yield (
        "internal with allowances",
        "a ring's thinner teeth widen its spaces",
        drawn(60, 0.003, 0.0, 7, 0.0052, internal=True, upper_allowance=-5e-5, lower_allowance=-9e-5),
    )
    yield (
        "steep helix",
        "a helix so steep that the lead is a few diameters: tan β is large where others divide by it",
        drawn(24, 0.003, 0.1, 10, 0.0055, helix_angle=0.9),
    )
    yield (
        "tiny helix",
        "a helix so small that the lead is kilometres: a quotient by a tangent that all but vanishes",
        drawn(30, 0.002, 0.0, 4, 0.0036, helix_angle=1e-6),
    )
    yield "watch gear", "a module of 0.05 mm at nine decimals", drawn(20, 0.00005, 0.0, 3, 0.00009)


# ---- profiles ----


def profile(given: dict[str, Any]) -> dict[str, Any]:
    """The four circles."""
    tooth = teeth_of(
        given, given["teeth"], x=given["profile_shift"], internal=given["internal"], tip=given.get("tip_diameter")
    )
    circles = {"tip": tooth.tip, "root": tooth.root, "base": tooth.rb, "form": tooth.form}
    return {f"{name}_diameter": 2 * value for name, value in circles.items()}


def shape(teeth: int, x: float = 0.0, m: float = 0.002, **more: Any) -> dict[str, Any]:
    """The inputs of a profile."""
    given = {
        "teeth": teeth, "pitch": {"record": "NormalModule", "module": m}, "profile_shift": x, "pressure_angle": TWENTY,
        "helix_angle": 0.0, "internal": False, "only_teeth": 1, "tolerance": 1e-3 * m, **more,
    }  # fmt: skip
    if given["internal"]:
        given.setdefault("root_radius_factor", 0.2)
    return given


def profiles(rng: random.Random) -> Iterator[Case]:
    """Profiles, ordinary and hard."""
    for _ in range(10):
        internal = rng.random() < 0.3
        teeth = rng.randint(40, 120) if internal else rng.randint(7, 120)
        beta = rng.choice([0.0, round(rng.uniform(0.1, 0.8), 3)])
        yield "", "", shape(teeth, round(rng.uniform(-0.2, 0.4), 3), internal=internal, helix_angle=beta)
    limit = 1.0 - 17 * 0.1169777784405111 / 2
    yield "a hair above undercut", "form and base circle are one but for the square of a hair", shape(17, limit + 1e-9)
    yield "a hair into undercut", "the junction is where the curves nearly touch", shape(17, limit - 1e-9)
    yield (
        "deep undercut",
        "five teeth without a shift: the junction lies far out, where trochoid and involute cross steeply",
        shape(5, 0.0, addendum_factor=0.6),
    )
    yield "undercut to the tip", "most of the involute is cut away", shape(27, -1.6)
    yield "sharp corner", "a rack without a corner radius", shape(12, 0.1, root_radius_factor=0.0)
    yield (
        "steep helix",
        "a steep helix: the corner's circle is a long ellipse, whose normal turns fast at its end",
        shape(9, -0.3, helix_angle=1.1),
    )
    yield "a thousand teeth", "the form circle is a difference of large numbers", shape(1000, -1.0)
    yield "a ring at its base circle", "its tips just reach beyond the base circle", shape(34, 0.012, internal=True)
    yield (
        "a ring with a large fillet",
        "the fillet takes half of the flank",
        shape(80, 0.0, internal=True, root_radius_factor=0.4),
    )
    yield (
        "pressure angle of two degrees",
        "the base circle all but touches the reference circle",
        shape(60, 0.0, pressure_angle=0.03490658503988659),
    )
    yield (
        "a module of a metre",
        "a module of a metre, as large as mills have them: no tolerance may be in metres",
        shape(30, 0.2, 1.0),
    )


SOLVERS = {
    "mesh": (meshes, mesh),
    "identify": (unknowns, unknown),
    "data_block": (blocks, block),
    "profile": (profiles, profile),
}


def written(tree: Any) -> Any:
    """Doubles as text."""
    if isinstance(tree, dict):
        return {name: part if name == "record" else written(part) for name, part in tree.items()}
    if isinstance(tree, list):
        return [written(part) for part in tree]
    return repr(tree) if isinstance(tree, float) else tree


def solved(task: str, inputs: dict[str, Any]) -> dict[str, str]:
    """The results of a case to 40 digits."""
    return {name: exact.text(value) for name, value in SOLVERS[task][1](inputs).items()}


def generate() -> dict[str, Any]:
    """Every case, solved."""
    exact.many_bits()
    cases = []
    for task, (make, _) in SOLVERS.items():
        for index, (name, why, inputs) in enumerate(make(random.Random(task))):
            kind = (
                {"kind": "hard", "name": f"{task} {name}", "why": why}
                if why
                else {"kind": "ordinary", "name": f"{task} {index}"}
            )
            cases.append({"task": task, **kind, "inputs": written(inputs), "results": solved(task, inputs)})
    for case in found("gear_meshes.json"):
        own = {key: case[key] for key in ("name", "why", "inputs")}
        cases.append(
            {"task": case["task"], "kind": "hard", **own, "results": solved(case["task"], doubles(case["inputs"]))}
        )
    about = "Written by generate_gear_meshes_references.py: SI inputs as doubles, results to 40 digits of 72."
    return {"about": about, "cases": cases}


if __name__ == "__main__":
    put("gear_meshes", **generate())
