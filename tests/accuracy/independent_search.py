"""A search for stated bounds below the true error of tasks that no other numbers go through: against other formulas.

    python tests/accuracy/independent_search.py [EVALUATIONS [TASK]]

Each question draws inputs of its own kind of hardness, calls the task's function, and compares its results and the
bounds it states with the functions that made the shipped references (tests/references): exact rationals of the legal
definitions of units, arc cosines at up to 1,400 digits, laws of motion integrated from their acceleration, products of
tooth numbers, eigenvalues by QR at 60 digits, sums of exact triangles. What is exact there is exact here. An answer is
an evaluation; of `cam rise` and `gear ratio`, whose answers are tables, each row is one. Impacts and meshes are in
`impact_search.py` and `mesh_search.py`.
"""

import random
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from math import pi, prod, sqrt
from pathlib import Path
from statistics import median
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "references"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

import generate_cam_motion_references as cam_laws
import generate_convert_references as units
import generate_coords_references as points
import generate_inertia_sections_references as sections
from mpmath import mp, mpf
from search_length import told

from dynamics_cli.accuracy.cases import flat
from dynamics_cli.cam.laws.names import LawName
from dynamics_cli.cam.laws.rise import rise
from dynamics_cli.convert.conversion import convert
from dynamics_cli.convert.coordinates import NAMES, System, coords
from dynamics_cli.errors import DynamicsError
from dynamics_cli.gear.trains.ratio import ratio
from dynamics_cli.gear.trains.scene import Planetary, Stages
from dynamics_cli.gear.trains.train import train
from dynamics_cli.inertia.section.contours import Hole, Piece
from dynamics_cli.inertia.section.task import section
from dynamics_cli.inertia.tensors.tensor import Whole, tensor
from dynamics_cli.numerics.tracked import Tracked
from dynamics_cli.records import ExactQuantity

# What the program gave, what it bounds its error by, and the exact value.
Compared = tuple[str, float, float, Any]
UNIT_ROUNDOFF = 2.0**-53
# Of the cam laws' lift, velocity, acceleration and jerk, in shares of their peaks: as `cam rise` states them.
LAW_BOUNDS = (1e-15, 1e-15, 5e-15, 5e-14)


def quantity(value: str, unit: str) -> ExactQuantity:
    """A decimal and its unit."""
    exact = Fraction(value)
    return ExactQuantity(exact.numerator, exact.denominator, unit)


def stated(answer: Any) -> dict[str, tuple[float, bool]]:
    """The bounds of an answer by address, and whether each is relative."""
    return {one.result: (one.bound, one.relative) for one in answer.numerics.bounds}


def bounded(answer: Any, name: str, value: float, exact: Any) -> Iterator[Compared]:
    """A result with its bound as an absolute one; nothing where none is stated."""
    bound = stated(answer).get(name)
    if bound is not None:
        yield name, value, bound[0] * abs(value) if bound[1] else bound[0], exact


def converting(rng: random.Random) -> Iterator[Compared]:
    """A decimal of 1 to 25 digits between two units of a kind, against exact rationals (and π)."""
    kind = rng.choice(list(units.KINDS))
    source, target = rng.sample(list(units.KINDS[kind]), 2)
    digits = rng.randrange(10 ** rng.randrange(1, 25))
    exponent = rng.choice((0, -2, -10, rng.randrange(-250, 250)))
    text = f"{digits}e{exponent}"
    (a, p, zero), (b, q, origin) = units.KINDS[kind][source], units.KINDS[kind][target]
    exact = (Fraction(text) * a + zero - origin) / b
    with mp.workdps(60):
        number = mpf(exact.numerator) / exact.denominator * mp.pi ** (p - q)
        answer = convert(quantity(text, source), target)
        # the bound is on the distance from the exact result, relative to it
        yield from bounded(answer, "value", answer.value.value, number)


def _component(rng: random.Random, name: str) -> float:
    if name in ("theta", "phi"):
        low = 0.0 if name == "phi" else -pi
        near = rng.choice((0.0, pi / 2, pi, -pi, rng.uniform(low, pi)))
        value = near + rng.choice((0.0, 1.0, -1.0)) * 10.0 ** rng.uniform(-17.0, 1.0)
        return min(max(value, 0.0), pi) if name == "phi" else value
    size = 10.0 ** rng.choice((rng.uniform(-1.0, 1.0), rng.uniform(-20.0, 20.0), rng.uniform(-300.0, 300.0)))
    return size if name in ("r", "rho") else rng.choice((size, -size, 0.0))


def locating(rng: random.Random) -> Iterator[Compared]:
    """A point near axes, planes and cuts, against arc cosines and complex exponentials at up to 1,400 digits."""
    source = rng.choice(list(points.SOURCES))
    names, exactly, targets = points.SOURCES[source]
    values = [_component(rng, name) for name in names]
    written = [
        quantity(repr(x), "rad" if name in ("theta", "phi") else "") for x, name in zip(values, names, strict=True)
    ]
    # an arc cosine loses twice the digits by which components differ
    wide = any(x and not 1e-60 < abs(x) < 1e60 for x in values)
    with mp.workdps(points.DIGITS if wide else 300):
        for target, wanted in zip(targets, exactly(*map(mpf, values)), strict=True):
            answer = coords(*written, from_=System(source), into=System(target))
            for name in NAMES[target]:
                own = getattr(answer, name)
                exact = wanted[name] * (180 / mp.pi if own.unit == "deg" else 1)
                # a direction at the cut between −π and π is one direction
                if name == "theta" and abs(own.value - exact) > abs(exact):
                    exact = -exact
                yield from bounded(answer, name, own.value, exact)


def rising(rng: random.Random) -> Iterator[Compared]:
    """Fifty places of a law of motion, near its ends and joints and between, against its integrated acceleration."""
    name = rng.choice(list(cam_laws.LAWS))
    lift, span = 10.0 ** rng.uniform(-4.0, 0.0), rng.uniform(1e-3, 3.0)
    shares = [rng.choice((0.0, 0.125, 0.25, 0.5, 0.75, 1.0, rng.random())) for _ in range(50)]
    moved = [min(max(x + rng.choice((0.0, 1.0, -1.0)) * 10.0 ** rng.uniform(-16.0, -1.0), 0.0), 1.0) for x in shares]
    places = sorted({min(span * x, span) for x in moved})
    answer = rise(law=LawName(name), lift=lift, span=span, at=tuple(places))
    peaks = [lift, *(getattr(answer, f"peak_{key}") for key in cam_laws.DERIVATIVES[1:])]
    law = cam_laws.LAWS[name]
    with mp.workdps(60):
        for place, point in zip(places, answer.points, strict=True):
            x, near = mpf(place) / mpf(span), mpf(2) ** -50
            values, low, high = law(x), law(max(x - near, mpf(0))), law(min(x + near, mpf(1)))
            for order, key in enumerate(cam_laws.DERIVATIVES):
                # a derivative that steps within a rounding of here has a value on either side
                if peaks[order] and abs(low[order] - high[order]) < mpf(2) ** -36:
                    bound = LAW_BOUNDS[order] * peaks[order]
                    yield key, getattr(point, key), bound, mpf(lift) * values[order] / mpf(span) ** order


def gearing(rng: random.Random) -> Iterator[Compared]:
    """Compound trains and planetary sets, against products of tooth numbers and Willis' formula in rationals."""
    if rng.random() < 0.5:
        stages = [(rng.randrange(5, 500), rng.randrange(5, 500)) for _ in range(rng.randrange(1, 6))]
        exact = Fraction(1)
        for driver, driven in stages:
            exact *= -Fraction(driven, driver)
        answer = train(arrangement=Stages(", ".join(f"{a}:{b}" for a, b in stages)))
    else:
        sun, planet = rng.randrange(12, 300), rng.randrange(12, 300)
        exact = 1 + Fraction(sun + 2 * planet, sun)
        answer = train(arrangement=Planetary(sun=sun, ring=sun + 2 * planet, planets=1))
    yield from bounded(answer, "ratio_value", answer.ratio_value, mpf(exact.numerator) / exact.denominator)


def choosing(rng: random.Random) -> Iterator[Compared]:
    """The thirty best trains for a ratio, each a row, against their tooth numbers; the best against all there are.

    Half of the ratios wanted are those of a train but for a share of 1e-3 to 1e-18: its error is a tiny difference.
    """
    stages, low = rng.randrange(1, 3), rng.randrange(9, 40)
    high = low + rng.randrange(15, 30)
    target = Fraction(rng.randrange(100, 900), rng.randrange(50, 200))
    if rng.random() < 0.5:
        drawn = [(rng.randrange(low, high + 1), rng.randrange(low, high + 1)) for _ in range(stages)]
        target = prod((Fraction(b, a) for a, b in drawn), start=Fraction(1))
        target *= 1 + Fraction(rng.choice((-1, 0, 1)) * rng.randrange(1, 10), 10 ** rng.randrange(4, 19))
    answer = ratio(target=(target.numerator, target.denominator), stages=stages, teeth=(low, high), count=30)
    if stages == 1:
        teeth = range(low, high + 1)
        least = min(abs(Fraction(b, a) / target - 1) for a in teeth for b in teeth)
        own = abs(Fraction(answer.best[0].ratio) / target - 1)
        assert own == least, f"{target}: {own} is not the least error, {least}"
    for index, found in enumerate(answer.best):
        exact = Fraction(1)
        for stage in found.stages.split(","):
            driver, driven = stage.split(":")
            exact *= Fraction(int(driven), int(driver))
        off = exact / target - 1
        for name, value, rational in (
            ("ratio_value", found.ratio_value, exact),
            ("error_value", found.error_value, off),
        ):
            yield from bounded(answer, f"best[{index}].{name}", value, mpf(rational.numerator) / rational.denominator)


def turning(rng: random.Random) -> Iterator[Compared]:
    """A body from round to needle, turned anyhow, against mpmath's QR method at 60 digits."""
    seconds = [10.0 ** rng.choice((0.0, rng.uniform(-8.0, 0.0), rng.uniform(-1.0, 0.0))) for _ in range(3)]
    near = rng.choice((0.0, 1e-15, 1e-9, 1e-3)) * rng.uniform(-1.0, 1.0)
    seconds[2] = rng.choice((seconds[2], seconds[1] * (1.0 + near)))
    a, b, c, d = (rng.choice((0.0, 1.0, rng.gauss(0.0, 1.0))) for _ in range(4))
    size = sqrt(a * a + b * b + c * c + d * d) or 1.0
    a, b, c, d = (1.0, 0.0, 0.0, 0.0) if size == 1.0 else (a / size, b / size, c / size, d / size)
    turn = (
        (a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)),
        (2.0 * (b * c + a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d - a * b)),
        (2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a - b * b - c * c + d * d),
    )
    moments = (seconds[1] + seconds[2], seconds[2] + seconds[0], seconds[0] + seconds[1])
    rows = [[sum(turn[i][k] * moments[k] * turn[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    whole = tuple(tuple(rows[max(i, j)][min(i, j)] for j in range(3)) for i in range(3))
    tracked = tuple(tuple(Tracked(x, 0.0, ()) for x in row) for row in whole)
    answer = tensor(inertia=Whole(tracked))
    with mp.workdps(60):
        wanted = sorted(mp.eigsy(mp.matrix([[mpf(x) for x in row] for row in whole]), eigvals_only=True), reverse=True)
        made = answer.principal_moments
        found = sorted((made.first, made.second, made.third), key=lambda one: -one.value)
        for index, (own, exact) in enumerate(zip(found, wanted, strict=True)):
            # which of equal doubles is which is not told: the largest of their bounds is for all of them
            bound = max(one.error for one in found if one.value == own.value)
            yield f"principal_moments[{index}]", own.value, bound, exact


def sectioning(rng: random.Random) -> Iterator[Compared]:
    """A polygon, slender or far off, or a pipe or box of thin wall, beside sums of exact triangles."""
    far, slender = 10.0 ** rng.uniform(-1.0, 7.0), 10.0 ** rng.uniform(0.0, 9.0)
    at = rng.choice(((0.0, 0.0), (far, -0.7 * far), (rng.uniform(-3.0, 3.0), far)))
    wall = 10.0 ** rng.uniform(-13.0, -1.0)
    way = rng.randrange(4)
    if way == 0:
        inputs: dict[str, Any] = {"polygon": sections.star(rng, rng.choice((1.0, slender)), at, rng.randrange(3))}
    elif way == 1:
        inputs = {"polygon": sections.strip(1.0, 1.0 / slender, rng.randrange(3), at)}
    elif way == 2:
        inputs = {"pieces": [{"diameter": 1.0, "x": at[0]}], "holes": [{"diameter": 1.0 - wall, "x": at[0]}]}
    else:
        hole = {"width": 1.0 - wall, "height": 0.5 - wall}
        inputs = {"pieces": [{"width": 1.0, "height": 0.5}], "holes": [hole]}
    answer = section(
        polygon=tuple(inputs.get("polygon", ())),
        pieces=tuple(Piece(**one) for one in inputs.get("pieces", ())),
        holes=tuple(Hole(**one) for one in inputs.get("holes", ())),
    )
    with mp.workdps(90):
        exact, values = sections.results(inputs), flat(answer)
        for name, (bound, relative) in stated(answer).items():
            if name in exact:
                yield name, values[name], bound * (abs(values[name]) if relative else 1.0), exact[name]


QUESTIONS: dict[str, Callable[[random.Random], Iterator[Compared]]] = {
    "convert": converting,
    "coords": locating,
    "cam rise": rising,
    "inertia tensor": turning,
    "inertia section": sectioning,
    "gear train": gearing,
    "gear ratio": choosing,
}


# Tasks whose answer is a table: so many results make a row, which is an evaluation.
ROWS = {"cam rise": 4, "gear ratio": 2}


class Findings:
    """How many results were compared, where a bound did not hold, and how loose the bounds are."""

    def __init__(self) -> None:
        self.compared = 0
        self.evaluations = 0
        self.refused = 0
        self.broken: list[str] = []
        self.looseness: list[float] = []

    @property
    def median(self) -> float:
        """The median of bound over max(error, 2⁻⁵³·|result|)."""
        return median(self.looseness) if self.looseness else 0.0


def search(task: str, count: int, seed: int) -> Findings:
    """So many evaluations of one question."""
    ask = QUESTIONS[task]
    rng = random.Random(f"{task} {seed}")
    found = Findings()
    mp.dps = 60
    while found.evaluations < count and found.refused < 4 * count + 100:
        try:
            results = list(ask(rng))
        except DynamicsError:
            found.refused += 1
            continue
        # a table counts by its rows
        found.evaluations += max(1, len(results) // ROWS.get(task, len(results) or 1))
        for name, value, bound, exact in results:
            found.compared += 1
            # less what the exact value's own last digits may be
            error = max(abs(mpf(value) - exact) - abs(exact) * mpf(10) ** -50, mpf(0))
            if error > bound:
                found.broken.append(f"{task} {name}: {value!r}, error {mp.nstr(error, 3)}, bound {bound:.3g}")
            room = max(float(error), UNIT_ROUNDOFF * abs(value))
            if room > 1e-300:
                found.looseness.append(bound / room)
    return found


def main() -> None:
    """Search as long as asked, and tell what was found."""
    for _ in told(QUESTIONS, search):
        pass


if __name__ == "__main__":
    main()
