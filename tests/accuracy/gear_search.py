"""A search for stated bounds below the true error of gear tasks that no other numbers go through.

    python tests/accuracy/gear_search.py [EVALUATIONS [TASK]]

Meshes, profiles, data blocks and unknown gears, drawn at random or disturbed from the hard cases shipped
(gear_meshes.json) and from the worst found so far, so that the search climbs; each is compared with exact numbers of
240 bits found by other ways (tests/references/gear_*_exact.py). A row of a table is an evaluation: a point of contact,
a line of a data block, a candidate, a vertex, chord or arc of a drawing; with them all other results of the answer,
together one.
"""

import random
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from statistics import median
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "references"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import gear_exact as exact
import gear_mesh_exact
import gear_profile_exact as curves
import generate_gear_meshes_references as references
from gear_exact import Exact, NoSuchGear, Tooth
from gear_table_exact import PRESSURE_ANGLES, all_candidates, candidate
from search_length import told

from dynamics_cli.accuracy.alternatives.gear.own import data_block, mesh
from dynamics_cli.accuracy.cases import DATA, flat, load
from dynamics_cli.errors import DynamicsError
from dynamics_cli.gear.measure.identify import SpanRead, identify
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.profile import Form, profile
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.outlines import Arc, Points

# A result: its name, what the program gave, its absolute bound, the exact value, and the size a difference is one of.
Compared = tuple[str, float, float, Any, float]
Inputs = dict[str, Any]
UNIT_ROUNDOFF = 2.0**-53
# What ties a difference of lengths near zero to: the module, or a radian.
OF_MODULE = ("backlash", "clearance", "_in_", "along", "base_pitch_error")
OF_RADIAN = ("transmission_error", "path.error")
WORST = 12
# Points of contact of a mesh that are compared.
SHOWN = 31


def size_of(name: str, value: float, module: float) -> float:
    """What a result's last bit is one of."""
    if any(part in name for part in OF_RADIAN):
        return 1.0
    return max(abs(value), module) if any(part in name for part in OF_MODULE) else abs(value)


def stated(answer: Any, values: dict[str, Any], wanted: dict[str, Any], module: float) -> Iterator[Compared]:
    """Every exact result beside the program's and its bound; a result without a bound, or left out, is a broken one."""
    bounds = {one.result: one for one in answer.numerics.bounds} if getattr(answer, "numerics", None) else {}
    for name, right in wanted.items():
        own = values.get(name)
        if isinstance(own, Tracked):
            yield name, own.value, own.error, right, size_of(name, own.value, module)
            continue
        bound = bounds.get(name)
        value = float("nan") if own is None else float(own)
        width = -1.0 if bound is None else bound.bound * abs(value) if bound.relative else bound.bound
        yield name, value, width, right, size_of(name, value, module)


def called(function: Callable[..., Any], inputs: Inputs, tracked: bool = False) -> Any:
    """The program's answer to inputs."""

    def part(value: Any) -> Any:
        return Tracked(value, 0.0, ()) if tracked and type(value) is float else value

    given = {name: part(value) for name, value in inputs.items() if name not in ("pitch", "spans")}
    if "pitch" in inputs:
        given["pitch"] = NormalModule(inputs["pitch"]["module"])
    if "spans" in inputs:
        given["spans"] = tuple(SpanRead(one["over"], part(one["length"])) for one in inputs["spans"])
    return function(**given)


# ---- what is asked ----


def _angles(rng: random.Random) -> dict[str, float]:
    alpha = rng.choice((0.3490658503988659, 0.25307274153917776, 0.4363323129985824, rng.uniform(0.18, 0.6)))
    beta = rng.choice((0.0, 0.0, rng.uniform(0.05, 0.7), 10.0 ** rng.uniform(-9.0, -1.0)))
    return {"pressure_angle": alpha, "helix_angle": beta}


def _pitch(rng: random.Random) -> dict[str, Any]:
    module = rng.choice((0.001, 0.003, 0.003175, 10.0 ** rng.uniform(-5.0, 0.0)))
    return {"record": "NormalModule", "module": module}


def _teeth(rng: random.Random, least: int = 6) -> int:
    return rng.choice((rng.randrange(least, 40), rng.randrange(least, 120), rng.randrange(least, 600)))


def draw_mesh(rng: random.Random) -> Inputs:
    """A pair: external or internal, shifted, helical, at the distance without backlash or near it."""
    first, internal = _teeth(rng), rng.random() < 0.3
    second = first + rng.randrange(6, 90) if internal else _teeth(rng, 10)
    given = {
        "first_teeth": first, "second_teeth": second, "pitch": _pitch(rng), "internal": internal, "points": 101,
        "first_profile_shift": rng.uniform(-0.5, 0.8), "second_profile_shift": rng.uniform(-0.5, 0.8), "shown": SHOWN,
        **_angles(rng),
    }  # fmt: skip
    if internal:
        given["root_radius_factor"] = rng.choice((0.2, rng.uniform(0.05, 0.3)))
    if rng.random() < 0.4:
        try:
            tight = references.mesh_of(given).a
        except (ArithmeticError, ValueError):
            return given
        off = rng.choice((1.0, -0.05, 1.0)) * 10.0 ** rng.uniform(-12.0, -0.8)
        given["centre_distance"] = float(tight) + (-off if internal else off) * given["pitch"]["module"]
    return given


def ask_mesh(inputs: Inputs) -> tuple[int, list[Compared]]:
    """One answer and its points of contact."""
    made = references.mesh_of(inputs)
    answer = called(mesh, inputs)
    wanted = made.closed() | made.gaps()
    shares = gear_mesh_exact.shares(inputs["points"], inputs["shown"])
    for index, share in enumerate(shares):
        wanted |= {f"path.{name}[{index}]": value for name, value in made.point(share).items()}
    module = inputs["pitch"]["module"]
    return 1 + len(shares), list(stated(answer, answer, wanted, module))


def draw_identify(rng: random.Random) -> Inputs:
    """The readings of a standard gear, off by what reading is good for."""
    teeth = rng.randrange(8, 150)
    over = max(1, teeth // 9)
    overs = rng.choice(((over,), (over, over + 1), (over, over + 1), (over, over + 2, over + 3)))
    reading = 10.0 ** rng.uniform(-7.0, -4.0)
    module = rng.choice((0.0001, 0.001, 0.002, 0.003, 0.0254 / 8, 0.0254 / 20, 0.01))
    try:
        return references.readings(
            teeth, module, rng.choice((0.3490658503988659, 0.25307274153917776, 0.4363323129985824)),
            rng.uniform(-0.5, 0.9), overs, noise=tuple(rng.uniform(-reading, reading) for _ in overs),
            helix_angle=rng.choice((0.0, 0.0, rng.uniform(0.05, 0.7))), reading=reading,
            tip=len(overs) == 1 or rng.random() < 0.7,
        )  # fmt: skip
    except NoSuchGear:
        return draw_identify(rng)


def ask_identify(inputs: Inputs) -> tuple[int, list[Compared]]:
    """The candidates shown, and now and then whether no other comes before them."""
    answer = called(identify, inputs, tracked=True)
    read = references.reading_of(inputs)
    compared: list[Compared] = []
    for _index, one in enumerate(answer.candidates):
        degrees = min(PRESSURE_ANGLES, key=lambda word: abs(float(word) - one.pressure_angle.value * 57.29577951308232))
        wanted = candidate(str(one.size), degrees, **read)
        values = {name: getattr(one, name) for name in wanted}
        compared += stated(answer, values, wanted, one.module.value)
    if inputs["teeth"] % 64 == 0:
        best = [(name, off) for off, name, _ in all_candidates(read)][: len(answer.candidates)]
        for (_, off), one in zip(best, answer.candidates, strict=True):
            own = one.disagreement
            compared.append(("order", own.value, own.error, off, own.value))
    return 1 + len(answer.candidates), compared


def draw_block(rng: random.Random) -> Inputs:
    """A gear with what its drawing needs, sizes over teeth and balls with it."""
    teeth, internal, x = _teeth(rng, 14), rng.random() < 0.25, rng.uniform(-0.3, 0.5)
    pitch, angles = _pitch(rng), _angles(rng)
    turned = teeth / float(exact.cos(Exact(angles["helix_angle"]))) ** 3
    more: Inputs = {"over": max(2, round(turned / 180 * 57.3 * angles["pressure_angle"] + 0.5 + x))}
    if internal:
        more["root_radius_factor"] = 0.2
        if angles["helix_angle"]:
            more.pop("over")
    if rng.random() < 0.4:
        more |= {"upper_allowance": -0.02 * pitch["module"] * rng.random()}
        more["lower_allowance"] = more["upper_allowance"] - 0.02 * pitch["module"] * rng.random()
    return {
        "teeth": teeth, "pitch": pitch, "profile_shift": x, "internal": internal, "decimals": rng.randrange(0, 10),
        "pin": rng.uniform(1.6, 1.9) * pitch["module"], **angles, **more,
    }  # fmt: skip


def ask_block(inputs: Inputs) -> tuple[int, list[Compared]]:
    """Every line that has a number."""
    answer = called(data_block, inputs)
    wanted = references.block(inputs)
    return len(wanted), list(stated(answer, answer, wanted, 1.0))


def draw_profile(rng: random.Random) -> Inputs:
    """A tooth of an external or internal gear, or a rack, drawn coarsely or finely."""
    way, pitch = rng.randrange(5), _pitch(rng)
    tolerance = max(pitch["module"] * 10.0 ** rng.uniform(-7.0, -1.5), 2e-12)
    common = {"pitch": pitch, "tolerance": tolerance, "profile_shift": rng.uniform(-0.6, 0.8), **_angles(rng)}
    if way == 0:
        rack = {"teeth": rng.randrange(1, 5), "rack": True, "profile_shift": 0.0, "helix_angle": 0.0}
        return {**common, **rack, "root_radius_factor": rng.choice((0.0, 0.2, 0.38))}
    if way == 1:
        fillet = rng.choice((0.2, rng.uniform(0.05, 0.4)))
        return {**common, "teeth": _teeth(rng, 30), "internal": True, "only_teeth": 1, "root_radius_factor": fillet}
    return {**common, "teeth": _teeth(rng), "internal": False, "only_teeth": 1}


def ask_profile(inputs: Inputs) -> tuple[int, list[Compared]]:
    """Circles, and how far some vertices, chords and arcs of one tooth drawn with lines are from the exact profile.

    Flanks of arcs are proved by numerics/fitting, which tests/cam/test_proof.py holds against sixty digits.
    """
    answer = called(profile, {**inputs, "form": Form("lines")})
    rng = random.Random(repr(sorted((k, str(v)) for k, v in inputs.items())))
    offs = list(_rack_offs(inputs, answer)) if inputs.get("rack") else list(_tooth_offs(inputs, answer, rng))
    worst = max(offs)
    # what is bounded is the worst: every one must be within it, and the worst not far
    compared: list[Compared] = [("deviation", 0.0, answer.deviation, off, 0.0) for off in offs if off < worst]
    compared.append(("deviation, worst", 0.0, answer.deviation, worst, inputs["pitch"]["module"]))
    if not inputs.get("rack"):
        compared += stated(answer, flat(answer), references.profile({"internal": False, **inputs}), 1.0)
    return 1 + len(offs), compared


def _rack_offs(inputs: Inputs, answer: Any) -> Iterator[Any]:
    ha, hf, _ = exact.RACKS["a"]
    alpha, m, rho = (
        Exact(inputs["pressure_angle"]),
        Exact(inputs["pitch"]["module"]),
        Exact(inputs["root_radius_factor"]),
    )
    ends = []
    for piece in answer.drawing.outlines[0].pieces:
        ends += [piece.start, piece.end]
    for index in range(inputs["teeth"]):
        for x, y in curves.rack_corners(m, alpha, Exact(ha), Exact(hf), rho, index):
            yield min(exact.sqrt((x - Exact(a)) ** 2 + (y - Exact(b)) ** 2) for a, b in ends)


def _tooth_offs(inputs: Inputs, answer: Any, rng: random.Random) -> Iterator[Any]:
    tooth = references.teeth_of(
        inputs, inputs["teeth"], x=inputs["profile_shift"], internal=inputs["internal"], tip=inputs.get("tip_diameter")
    )
    pieces = answer.drawing.outlines[0].pieces
    drawn = [piece for piece in pieces if isinstance(piece, Points)]
    # the right flank from the root up; the left one is its mirror image
    flanks: list[curves.Flank] = (
        [curves.Involute(tooth)] if tooth.internal else [curves.Trochoid(tooth), curves.Involute(tooth)]
    )
    for index, piece in enumerate(drawn):
        flank = flanks[index if index < len(flanks) else len(drawn) - 1 - index]
        mirror = index < len(flanks)
        points = [(Exact(x) if mirror else -Exact(x), Exact(y)) for x, y in piece.points]
        for spot in sorted(rng.sample(range(len(points) - 1), min(3, len(points) - 1))):
            a, b = points[spot], points[spot + 1]
            yield flank.off(*a)
            yield flank.off(*b)
            yield flank.arrow(a, b)
    for piece in pieces:
        if isinstance(piece, Arc):
            yield _arc_off(tooth, piece)


def _arc_off(tooth: Tooth, piece: Arc) -> Any:
    """How far the middle of an arc is from the circle it is of."""
    (ax, ay), (bx, by), bulge = piece.start, piece.end, Exact(piece.bulge)
    x = (Exact(ax) + Exact(bx)) / 2 + bulge * (Exact(by) - Exact(ay)) / 2
    y = (Exact(ay) + Exact(by)) / 2 - bulge * (Exact(bx) - Exact(ax)) / 2
    offs = [curves.circle_off(tooth.tip, x, y), curves.circle_off(tooth.root, x, y)]
    return min([*offs, curves.fillet_off(tooth, abs(x), y)] if tooth.internal else offs)


# Each question: how inputs are drawn, how asked, and how many evaluations the suite can afford.
QUESTIONS: dict[str, tuple[Callable[[random.Random], Inputs], Callable[[Inputs], tuple[int, list[Compared]]]]] = {
    "gear mesh": (draw_mesh, ask_mesh),
    "gear identify": (draw_identify, ask_identify),
    "gear data-block": (draw_block, ask_block),
    "gear profile": (draw_profile, ask_profile),
}


def hard_cases(task: str) -> list[Inputs]:
    """The inputs of a task's hard cases."""
    name = task.removeprefix("gear ").replace("-", "_")
    found = [references.doubles(case.inputs) for case in load("gear_meshes.json") if case.task == name and case.hard]
    return [{**one, "shown": SHOWN} if "shown" in one else one for one in found]


def disturbed(rng: random.Random, inputs: Inputs) -> Inputs:
    """The inputs with some of their numbers moved, by much or by a hair."""
    out = dict(inputs)
    for name, value in inputs.items():
        if rng.random() < 0.5:
            continue
        if type(value) is float:
            out[name] = value * (1.0 + rng.choice((1.0, -1.0)) * 10.0 ** rng.uniform(-16.0, -1.5))
        elif type(value) is int and name.endswith("teeth") and name != "only_teeth":
            out[name] = max(3, value + rng.choice((-1, 0, 0, 1)))
        elif name == "pitch":
            out[name] = {**value, "module": value["module"] * (1.0 + 10.0 ** rng.uniform(-16.0, -1.5))}
        elif name == "spans":
            out[name] = [{**one, "length": one["length"] * (1.0 + 1e-6 * rng.uniform(-1.0, 1.0))} for one in value]
    if "centre_distance" in out and "pitch" in inputs:
        # with the module: what lies between the gears stays
        out["centre_distance"] *= out["pitch"]["module"] / inputs["pitch"]["module"]
    return out


class Findings:
    """How many results were compared, where a bound did not hold, how loose bounds are, and the worst inputs."""

    def __init__(self) -> None:
        self.evaluations = self.refused = self.compared = 0
        self.broken: list[str] = []
        self.looseness: dict[str, list[float]] = {}
        # inputs where most of a bound is used, and where errors are largest
        self.worst: list[tuple[float, Inputs]] = []
        self.hardest: list[tuple[float, Inputs]] = []

    @property
    def median(self) -> float:
        """The median of bound over max(error, 2⁻⁵³·size), of all results."""
        return median(one for found in self.looseness.values() for one in found)

    def medians(self) -> dict[str, float]:
        """The same of every result."""
        return {name: median(found) for name, found in self.looseness.items()}

    def add(self, task: str, inputs: Inputs, found: list[Compared]) -> None:
        """Count the results of one answer."""
        steepest = largest = 0.0
        for name, value, bound, right, size in found:
            self.compared += 1
            # less what the exact value's own last digits may be
            error = float(max(abs(Exact(value) - right) - abs(right) * Exact(2) ** -180, Exact(0)))
            if not error <= bound:
                self.broken.append(f"{task} {name}: {value!r}, error {error:.3g}, bound {bound:.3g}: {inputs}")
            need = max(error, UNIT_ROUNDOFF * size)
            if size and need > 1e-300 and bound > 0.0:
                self.looseness.setdefault(name.partition("[")[0], []).append(bound / need)
                steepest, largest = max(steepest, error / bound), max(largest, error / size)
        self.worst = sorted([*self.worst, (steepest, inputs)], key=lambda one: -one[0])[:WORST]
        self.hardest = sorted([*self.hardest, (largest, inputs)], key=lambda one: -one[0])[:WORST]


def search(task: str, count: int, seed: int) -> Findings:
    """So many evaluations of one question: a third drawn, a third hard cases disturbed, a third climbing."""
    draw, ask = QUESTIONS[task]
    rng = random.Random(f"{task} {seed}")
    hard, found = hard_cases(task), Findings()
    exact.many_bits()
    while found.evaluations < count and found.refused < 4 * count + 100:
        way = rng.random()
        if way < 0.34 or not found.worst:
            inputs = draw(rng)
        else:
            pool = found.worst if way < 0.83 else found.hardest
            inputs = disturbed(rng, rng.choice(hard) if way < 0.67 else rng.choice(pool)[1])
        try:
            rows, compared = ask(inputs)
        except (DynamicsError, NoSuchGear):
            found.refused += 1
            continue
        found.evaluations += rows
        found.add(task, inputs, compared)
    return found


def main() -> None:
    """Search as long as asked, and tell what was found."""
    for found in told(QUESTIONS, search):
        for name, middle in sorted(found.medians().items(), key=lambda one: -one[1])[:6]:
            print(f"    {name}: {middle:.1f} in the median, at most {max(found.looseness[name]):.3g}")
        print(f"    worst: {found.worst[0][0]:.3f} of a bound, {found.worst[0][1]}")


if __name__ == "__main__":
    assert DATA.exists()
    main()
