"""A search that starts from hard cases and climbs from the worst it has found: the part that knows no task.

Inputs are trees as the files of references have them, with doubles for leaves. A question says where to start, how to
draw inputs afresh, and what the program and other numbers say of some inputs; here they are disturbed, the worst are
kept, and what was found is counted.
"""

import math
import random
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from statistics import median
from typing import Any, NamedTuple

from mpmath import mp
from precise import Exact, exact_pi, gmpy2, many_bits
from search_length import told

from dynamics_cli.errors import DynamicsError

Tree = dict[str, Any]
UNIT_ROUNDOFF = 2.0**-53
# Gradual underflow leaves no relative error; results below this are not measured for tightness.
LEAST = 1e-290
STEPS = (1e-15, 1e-12, 1e-8, 1e-3, 0.1, 0.7)
# Leaves that are shares of one: they stay between zero and one.
SHARES = ("restitution", "least_restitution", "greatest_restitution")
# Leaves that have no sign.
SIZES = ("mass", "friction", "weight", "moment", "radius_of_gyration", "speed", "least_friction", "greatest_friction")


class Compared(NamedTuple):
    """A result: what the program gave, its bound, the exact value, and what that may itself be off by."""

    name: str
    value: float
    bound: float
    exact: Any
    slack: Any = 0
    # whether the bound is of this number; one of the vector that it is a part of only has to be true
    own: bool = True


class Answer(NamedTuple):
    """One evaluation: the inputs it had, and its results."""

    inputs: Tree
    results: list[Compared]
    kind: str = ""


def stated(
    answer: Any, values: dict[str, float], exact: dict[str, Any], slacks: Callable[[str], Any] = lambda _: 0
) -> list[Compared]:
    """Each result that an answer states a bound for; a bound of a vector holds for each of its parts.

    `slacks` says what the exact side of a result may itself be off by.
    """
    found = []
    for one in answer.numerics.bounds:
        own = one.result
        for name in (own,) if own in exact else (f"{own}[0]", f"{own}[1]", f"{own}[2]"):
            if name in exact and values.get(name) is not None:
                bound = one.bound * (abs(values[name]) if one.relative else 1.0)
                true = exact[name]
                if name.endswith("pdof") and abs(values[name] - true) > 6:
                    # at the cut between −π and π both are one direction
                    true = true + 2 * exact_pi() if true < 0 else true - 2 * exact_pi()
                found.append(Compared(name, values[name], bound, true, slacks(name), own=name == own))
    return found


class Question(NamedTuple):
    """A task as the search asks it; `ask` may answer for several inputs that share the costly part of the exact."""

    task: str
    starts: list[Tree]
    draw: Callable[[random.Random], Tree]
    ask: Callable[[random.Random, Tree], Iterator[Answer]]
    # of the questions so many are drawn afresh; half of the others disturb a hard case, and half climb
    drawn: float = 0.5


class Worst(NamedTuple):
    """Where some measure of a result was largest."""

    measure: float
    name: str
    inputs: Tree


class Findings:
    """What a search found."""

    def __init__(self, task: str) -> None:
        self.task = task
        self.evaluations = 0
        self.compared = 0
        self.refused = 0
        # evaluations by what the exact side was
        self.kinds: Counter[str] = Counter()
        self.broken: list[str] = []
        self.looseness: list[float] = []
        # by result: error over bound, and bound over error
        self.nearest: dict[str, Worst] = {}
        self.loosest: dict[str, Worst] = {}

    @property
    def median(self) -> float:
        """The median of bound over max(error, 2⁻⁵³·|result|)."""
        return median(self.looseness) if self.looseness else 0.0

    def enter(self, answer: Answer) -> None:
        """Count one evaluation."""
        self.evaluations += 1
        self.kinds[answer.kind] += 1
        for one in answer.results:
            self.compared += 1
            error = abs(Exact(one.value) - one.exact)
            error = error - one.slack if error > one.slack else error * 0
            if not error <= one.bound:
                self.broken.append(
                    f"{self.task} {one.name}: {one.value!r}, error {float(error):.3g}, bound {one.bound:.3g}: "
                    f"{answer.inputs}"
                )
            size = abs(one.value)
            if size < LEAST or not one.own:
                continue
            off = float(error)
            room = max(off, UNIT_ROUNDOFF * size)
            self.looseness.append(one.bound / room)
            key = one.name.rpartition(".")[2].partition("[")[0]
            for store, measure in (
                (self.nearest, off / one.bound if one.bound else 0.0),
                (self.loosest, one.bound / room),
            ):
                if key not in store or measure > store[key].measure:
                    store[key] = Worst(measure, one.name, answer.inputs)


@contextmanager
def bits(count: int) -> Iterator[None]:
    """Arithmetic of so many bits, for a while; leaving the real numbers raises ArithmeticError."""
    if gmpy2:
        with gmpy2.context(gmpy2.get_context(), precision=count, trap_invalid=True, trap_divzero=True):
            yield
    else:
        with mp.workprec(count):
            yield


def search(question: Question, count: int, seed: int) -> Findings:
    """So many evaluations of a question."""
    many_bits()
    rng = random.Random(f"{question.task} {seed}")
    found = Findings(question.task)
    for start in question.starts:
        _evaluate(question, rng, start, found)
    while found.evaluations < count and found.refused < 4 * count + 100:
        way = rng.random()
        if way < question.drawn or not question.starts:
            inputs = question.draw(rng)
        elif way < 0.5 + 0.5 * question.drawn or not found.nearest:
            inputs = near(rng, rng.choice(question.starts))
        else:
            store = found.nearest if rng.random() < 0.85 else found.loosest
            inputs = near(rng, rng.choice(list(store.values())).inputs)
        _evaluate(question, rng, inputs, found)
    return found


def _evaluate(question: Question, rng: random.Random, inputs: Tree, found: Findings) -> None:
    answers = 0
    try:
        for answer in question.ask(rng, inputs):
            found.enter(answer)
            answers += 1
    except (DynamicsError, ArithmeticError, ValueError):
        pass
    found.refused += not answers


def near(rng: random.Random, tree: Tree) -> Tree:
    """Inputs near others: some numbers moved by last bits, by shares, by orders of magnitude, or to a special place."""
    # a number may take the place of one of its kind: a mass that stands for a lever asks nothing of sense
    alike: dict[str, list[float]] = {}
    for name, value in numbers(tree):
        alike.setdefault(name, []).append(value)
    leaves = sum(map(len, alike.values()))
    share = rng.choice((1.0 / max(leaves, 1), 0.3, 0.8))
    step = rng.choice(STEPS)

    def moved(name: str, value: float) -> float:
        if rng.random() > share:
            return value
        way = rng.random()
        if way < 0.7:
            made = value * (1.0 + step * rng.uniform(-1.0, 1.0))
        elif way < 0.82:
            made = math.nextafter(value, rng.choice((-math.inf, math.inf))) if value else value
        elif way < 0.88:
            made = value * 10.0 ** rng.uniform(-6.0, 6.0)
        elif way < 0.94:
            made = rng.choice((0.0, 1.0, -value))
        else:
            made = rng.choice(alike.get(name, [value])) * rng.choice((1.0, 1.0, -1.0, 1.0 + step))
        if name in SHARES:
            return min(max(made, 0.0), 1.0)
        return abs(made) if name in SIZES else made

    return with_numbers(tree, moved)


def numbers(tree: Any, name: str = "") -> Iterator[tuple[str, float]]:
    """Every double of a tree, and the name it goes by."""
    if isinstance(tree, float):
        yield name, tree
    elif isinstance(tree, dict):
        for key, part in tree.items():
            yield from numbers(part, key)
    elif isinstance(tree, list):
        for part in tree:
            yield from numbers(part, name)


def with_numbers(tree: Any, change: Callable[[str, float], float], name: str = "") -> Any:
    """The tree with each double changed; a tensor stays symmetric, and of a body where it is scaled along its axes."""
    if isinstance(tree, float):
        return change(name, tree)
    if isinstance(tree, dict):
        return {key: with_numbers(part, change, key) for key, part in tree.items()}
    if isinstance(tree, list):
        if name == "inertia" and len(tree) == 3 and isinstance(tree[0], list):
            shares = [abs(change("share", 1.0)) for _ in range(3)]
            return [
                [shares[max(i, j)] * tree[min(i, j)][max(i, j)] * shares[min(i, j)] for j in range(3)] for i in range(3)
            ]
        return [with_numbers(part, change, name) for part in tree]
    return tree


def written(tree: Any) -> Any:
    """Doubles as text that reads back to the same bits."""
    if isinstance(tree, float):
        return repr(tree)
    if isinstance(tree, dict):
        return {name: written(part) for name, part in tree.items()}
    return [written(part) for part in tree] if isinstance(tree, list) else tree


def read(tree: Any) -> Any:
    """An input tree of a file of references with its texts as doubles."""
    if isinstance(tree, dict):
        return {name: part if name in ("record", "word") else read(part) for name, part in tree.items()}
    if isinstance(tree, list):
        return [read(part) for part in tree]
    return float(tree) if isinstance(tree, str) else tree


def arguments(tree: Any, groups: dict[str, type], name: str = "") -> Any:
    """What the program's function is given: records for objects, tuples for lists."""
    if isinstance(tree, list):
        return tuple(arguments(part, groups, name) for part in tree)
    if not isinstance(tree, dict):
        return tree
    if "word" in tree:
        return tree["word"]
    parts = {key: arguments(part, groups, key) for key, part in tree.items() if key != "record"}
    record = tree.get("record", name)
    return groups[record](**parts) if record else parts


def main_of(questions: dict[str, Callable[[], Question]]) -> None:
    """Search as long as asked, and tell what was found."""
    import json

    for found in told(questions, lambda task, count, seed: search(questions[task](), count, seed)):
        if len(found.kinds) > 1:
            print("    " + ", ".join(f"{count} {kind}" for kind, count in found.kinds.items()))
        for title, store in (("nearest", found.nearest), ("loosest", found.loosest)):
            if store:
                print(f"    {title}: " + ", ".join(f"{one.name} {one.measure:.3g}" for one in store.values()))
                worst = max(store.values(), key=lambda one: one.measure)
                print(f"        {worst.name}: {json.dumps(written(worst.inputs))}", flush=True)
