"""A search for stated bounds below the true error: every tracked task, from its examples and its hard cases.

    python tests/accuracy/bound_search.py [EVALUATIONS [FAMILY]]

Each evaluation disturbs a start's numbers (by last bits, by percents, by orders of magnitude; to zero, to a limit of
their kind, to one another), sends tracked numbers and numbers of 240 bits (`precise.py`) through the same formula, and
compares every result: the difference must lie within the bound, as it is stated (where it came out loose, measured by
a second pass in 60 decimal digits). A part of the evaluations disturbs the worst found so far instead of the start.
Plain floats go the same way and must give the tracked numbers' bits.

What is compared with what: the rounding of a formula with the same formula in many bits. That the formulas themselves
are right is shown elsewhere, by references of other formulas (tests/references). Tasks that iterate or state bounds of
their own are searched beside numbers found otherwise: independent_search.py, cam_search.py, gear_search.py,
impact_search.py, mesh_search.py.
"""

import random
import sys
from collections import defaultdict
from collections.abc import Iterator
from math import inf, isfinite, nextafter, pi, ulp
from statistics import median
from typing import Any

from precise import Exact, Precise, exact_pi, many_bits
from search_starts import Start, starts

from dynamics_cli.core.answering.tightening import tighten
from dynamics_cli.errors import DynamicsError
from dynamics_cli.numerics.tracked import Tracked

STEPS = (1e-15, 1e-12, 1e-8, 1e-3, 0.1, 0.7)
UNIT_ROUNDOFF = 2.0**-53
# Gradual underflow leaves no relative error; results below this are not measured for tightness.
LEAST = 1e-290
# How many of the evaluations start from the worst found so far.
CLIMBING = 0.3
# How many times as many are tried, where most inputs near a start are refused.
PATIENCE = 8
# A median of fewer says nothing.
ENOUGH = 20
# Floats go along in every so many evaluations.
FLOATS_EVERY = 4
REFUSALS = (DynamicsError, ArithmeticError, ValueError)


class Worst:
    """The place where some measure was largest."""

    def __init__(self) -> None:
        self.measure = -1.0
        self.address = ""
        self.start: Start | None = None
        self.numbers: list[float] = []

    def offer(self, measure: float, address: str, start: Start, numbers: list[float]) -> bool:
        """Keep this place if it is worse."""
        if not measure > self.measure:
            return False
        self.measure, self.address, self.start, self.numbers = measure, address, start, numbers
        return True

    def __str__(self) -> str:
        where = f"{self.start.label}: {self.numbers}" if self.start else "nowhere"
        return f"{self.measure:.4g} {self.address} at {where}"


class Findings:
    """What the search found for one task."""

    def __init__(self, task: str) -> None:
        self.task = task
        self.evaluations = 0
        self.refused = 0
        self.switched = 0
        self.compared = 0
        self.broken: list[str] = []
        self.unlike: list[str] = []
        # bound over max(error, 2⁻⁵³·|result|), by address
        self.looseness: dict[str, list[float]] = defaultdict(list)
        self.nearest = Worst()
        self.loosest = Worst()
        self.largest = Worst()

    @property
    def answered(self) -> int:
        """The evaluations that both kinds of numbers answered alike."""
        return self.evaluations - self.refused - self.switched

    @property
    def median(self) -> float:
        """The median looseness over all results of all evaluations."""
        values = [one for column in self.looseness.values() for one in column]
        return median(values) if values else 0.0

    def loose(self) -> dict[str, float]:
        """The results whose bound is in the median more than 100 times what it need be, where there are enough."""
        medians = {address: median(column) for address, column in self.looseness.items() if len(column) >= ENOUGH}
        return {address: value for address, value in medians.items() if value > 100.0}


def beside(first: Any, second: Any, third: Any, address: str = "") -> Iterator[tuple[str, Any, Any, Any]]:
    """The leaves of three answers to one question, by address; raises Unlike where their shapes differ."""
    kind = type(first)
    if kind is Tracked or kind is float or kind is Precise:
        yield address, first, second, third
    elif kind is tuple or kind is list:
        if len(first) != len(second):
            raise Switched
        for index, item in enumerate(first):
            yield from beside(item, second[index], third[index], f"{address}[{index}]")
    elif hasattr(kind, "fields"):
        if type(second) is not kind:
            raise Switched
        for name in kind.fields:
            if name not in ("checks", "advice", "numerics"):
                own = f"{address}.{name}" if address else name
                yield from beside(getattr(first, name), getattr(second, name), getattr(third, name), own)
    elif (kind in (int, bool) or first is None or isinstance(first, str)) and first != second:
        raise Switched


class Switched(Exception):
    """A count, a word or a gap differs: two answers of either side of a switch, each right for its own."""


def disturbed(rng: random.Random, start: Start, base: list[float]) -> list[float]:
    """Numbers near `base`, each within what its kind allows."""
    share = rng.choice((1.0 / len(base), 0.3, 0.8))
    step = rng.choice(STEPS)
    chosen = rng.randrange(len(base))
    made = []
    for index, (kind, value) in enumerate(zip(start.kinds, base, strict=True)):
        new = value
        if index == chosen or rng.random() < share:
            new = _moved(rng, start, base, index, step)
        made.append(value if (kind is not None and kind.outside(new)) or not isfinite(new) else new + 0.0)
    for row in (index for index, kind in enumerate(start.kinds) if kind is not None and kind.form == "tensor"):
        place = tensor_place(start, row)
        if place in MIRRORED:
            made[row] = made[row - MIRRORED[place]]
    return made


# Below the diagonal of a tensor written by rows: how far back its twin stands.
MIRRORED = {3: 2, 6: 4, 7: 2}


def tensor_place(start: Start, index: int) -> int:
    """Where in its tensor a number stands."""
    first = index
    while first and start.kinds[first - 1] is start.kinds[index]:
        first -= 1
    return (index - first) % 9


def _moved(rng: random.Random, start: Start, base: list[float], index: int, step: float) -> float:
    """One number moved in one of the ways."""
    value, kind = base[index], start.kinds[index]
    way = rng.random()
    if way < 0.7:
        return value * (1.0 + step * rng.uniform(-1.0, 1.0))
    if way < 0.8:
        return nextafter(value, rng.choice((-inf, inf)))
    if way < 0.86:
        return value * 10.0 ** rng.uniform(-6.0, 6.0)
    if way < 0.9:
        return rng.choice((0.0, 1.0, -value))
    if way < 0.95:
        limits = [getattr(kind, name) for name in ("low", "high", "above", "below") if kind is not None]
        limit = rng.choice([one for one in limits if one is not None] or [value])
        return rng.choice((limit, limit + step, limit - step))
    alike = [other for other, own in zip(base, start.kinds, strict=True) if own is kind]
    return rng.choice(alike) * rng.choice((1.0, 1.0, -1.0, 1.0 + step))


# Eigenvalues come from an iteration in doubles, whatever numbers came in: independent_search.py compares them.
ITERATED = (
    "principal_",
    "ellipsoid_axes",
    "equivalent_",
    "slack",
    "extreme_products",
    "greatest_product",
    "moment_there",
)


def difference(value: float, exact: Any) -> Any:
    """The error; a direction at the cut, between −180 and 180 degrees or 0 and 360, is one direction."""
    error = abs(Exact(value) - exact)
    if error > 6.28 and min(abs(abs(value) - end) for end in (0.0, pi, 2.0 * pi)) < 1e-6:
        error = abs(error - 2 * exact_pi())
    return error


def evaluate(start: Start, numbers: list[float], found: Findings) -> bool:
    """One evaluation entered into the findings; whether it is the worst so far."""
    found.evaluations += 1
    try:
        tracked = start.call([Tracked(number, 0.0, ()) for number in numbers])
        tighten(tracked, numbers, start.call)
        precise = _precisely(start, numbers)
    except REFUSALS:
        found.refused += 1
        return False
    try:
        floats = start.call(numbers) if found.evaluations % FLOATS_EVERY == 0 else tracked
        leaves = list(beside(tracked, precise, floats))
    except Switched:
        found.switched += 1
        return False
    worse = False
    for address, own, exact, plain in leaves:
        if type(own) is Tracked:
            echoed = start.task.startswith(AS_TYPED) and own.error == 0.0 and own.value in numbers
            known = isfinite(own.error) and isfinite(own.value) and not _iterated(start, address) and not echoed
            if type(exact) is Precise and known:
                worse |= _compare(start, numbers, address, own, exact.exact, found)
            own = own.value
        if floats is not tracked and own != plain and not (own != own and plain != plain):
            found.unlike.append(f"{start.task} {address}: {plain!r} is not {own!r}, {start.label}: {numbers}")
    return worse


# Tasks that take a double for the decimal that was typed (numerics/typed_products.py), and never iterate in doubles.
DECIMALS = 1e-60
AS_TYPED = "vec "


def _precisely(start: Start, numbers: list[float]) -> Any:
    """The answer in 240 bits; where decimals are taken as typed, of the same decimals as tracked numbers take."""
    if not start.task.startswith(AS_TYPED):
        return start.call(Precise.inputs(numbers))
    if any(0.0 < abs(number) < LEAST for number in numbers):
        raise ArithmeticError("the decimal of a subnormal double is another number")
    # what iterates in doubles and takes a last step in these numbers would refuse them: only here
    Precise.many_digits = True  # type: ignore[attr-defined]
    try:
        return start.call(Precise.inputs(numbers))
    finally:
        del Precise.many_digits  # type: ignore[attr-defined]


def _iterated(start: Start, address: str) -> bool:
    return start.task.startswith("inertia ") and address.startswith(ITERATED)


def _compare(start: Start, numbers: list[float], address: str, own: Tracked, exact: Any, found: Findings) -> bool:
    found.compared += 1
    true = difference(own.value, exact)
    error = float(true)
    # in 240 bits a decimal is rounded too
    if start.task.startswith(AS_TYPED) and error <= DECIMALS * max(map(abs, numbers)) ** 2:
        error = true = 0.0
    # an error below the least double cannot be stated
    if true > own.error and error > 0.0:
        found.broken.append(
            f"{start.task} {address}: error {error:.3g}, bound {own.error:.3g}, {start.label}: {numbers}"
        )
    size = abs(own.value)
    if size < LEAST:
        return False
    looseness = own.error / max(error, UNIT_ROUNDOFF * size)
    found.looseness[address].append(looseness)
    if looseness > found.loosest.measure:
        found.loosest.offer(looseness, address, start, numbers)
    if error > found.largest.measure * ulp(size):
        found.largest.offer(error / ulp(size), address, start, numbers)
    return own.error > 0.0 and found.nearest.offer(error / own.error, address, start, numbers)


def search(task: str, places: list[Start], count: int, seed: int) -> Findings:
    """So many answered evaluations of one task, shared by its starts."""
    many_bits()
    rng = random.Random(f"{task} {seed}")
    found = Findings(task)
    for number, start in enumerate(places):
        base = start.numbers
        evaluate(start, base, found)
        wanted = -(-count * (number + 1) // len(places))
        for _ in range(PATIENCE * count // len(places)):
            if found.answered >= wanted:
                break
            numbers = disturbed(rng, start, base if rng.random() < CLIMBING else start.numbers)
            if evaluate(start, numbers, found):
                base = numbers
    return found


def by_task(family: str = "") -> dict[str, list[Start]]:
    """The starts of every task."""
    made: dict[str, list[Start]] = defaultdict(list)
    for start in starts(family):
        made[start.task].append(start)
    return made


def main() -> None:
    """Search as long as asked, and tell what was found."""
    from time import process_time

    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    for task, places in by_task(sys.argv[2] if len(sys.argv) > 2 else "").items():
        before = process_time()
        found = search(task, places, count, 1)
        print(
            f"{task:22} {found.answered:7} answered, {found.refused} refused, {found.switched} switched, "
            f"{found.compared} results compared, "
            f"{len(found.broken)} broken, {len(found.unlike)} unlike, looseness {found.median:.1f} in the median, "
            f"{process_time() - before:.1f} s",
            flush=True,
        )
        for name in ("nearest", "largest", "loosest"):
            print(f"    {name}: {getattr(found, name)}"[:400])
        for line in found.broken[:4] + found.unlike[:3]:
            print("    ! " + line[:600])
        if found.loose():
            print("    loose:", {key: round(value) for key, value in found.loose().items()})


if __name__ == "__main__":
    main()
