"""A search for stated bounds below the true error: every tracked task, about its examples, against 60 digits.

    python tests/accuracy/bound_search.py [EVALUATIONS [FAMILY]]

Each evaluation disturbs an example's inputs (by last bits, by percents, by orders of magnitude, to zero), sends tracked
numbers and 60-digit numbers through the same formula, and compares every result: the difference must lie within the
bound. That the formulas themselves are right is shown by references of other formulas; this shows their rounding.
"""

import random
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from mpmath import mp, mpf

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from dynamics_cli import cli
from dynamics_cli.core.answer import call_model, choose
from dynamics_cli.core.bound import Fields
from dynamics_cli.core.call import Settings
from dynamics_cli.core.direct import read_plainly
from dynamics_cli.core.gather import gather
from dynamics_cli.core.task import Task
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import DynamicsError
from dynamics_cli.numerics.tracked import Tracked

_FUNCTIONS = {
    "sqrt": mp.sqrt, "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "asin": mp.asin, "acos": mp.acos, "atan": mp.atan,
    "exp": mp.exp, "log": mp.log, "atan2": mp.atan2, "hypot": mp.hypot, "maximum": max, "minimum": min,
    "multiply_add": lambda a, b, c: a * b + c,
}  # fmt: skip
STEPS = (1e-15, 1e-8, 1e-3, 0.1, 0.7)


class Precise:
    """A number of 60 digits that goes through a formula as a tracked number does."""

    __slots__ = ("value",)

    def __init__(self, value: Any) -> None:
        self.value = mpf(value)

    def apply(self, name: str, *arguments: Any) -> "Precise":
        made = _FUNCTIONS[name](*(_plain(argument) for argument in arguments))
        if not isinstance(made, mpf):
            raise ArithmeticError(f"{name} leaves the real numbers")
        return Precise(made)

    def __float__(self) -> float:
        raise TypeError("a precise number does not turn into a float")

    def __bool__(self) -> bool:
        return self.value != 0

    def __abs__(self) -> "Precise":
        return Precise(abs(self.value))

    def __neg__(self) -> "Precise":
        return Precise(-self.value)

    def __pos__(self) -> "Precise":
        return self

    def __hash__(self) -> int:
        return hash(self.value)


def _plain(number: Any) -> Any:
    return number.value if isinstance(number, Precise) else mpf(number)


def _binary(name: str) -> Any:
    def operation(self: Precise, other: Any) -> Any:
        if not isinstance(other, (Precise, float, int, mpf)):
            return NotImplemented
        made = getattr(self.value, name)(_plain(other))
        return Precise(made) if isinstance(made, mpf) else made

    return operation


for _name in ("add", "radd", "sub", "rsub", "mul", "rmul", "truediv", "rtruediv", "lt", "le", "gt", "ge", "eq", "ne"):
    setattr(Precise, f"__{_name}__", _binary(f"__{_name}__"))


def examples(family: str = "") -> Iterator[tuple[Task, str]]:
    """Every example of every tracked task that is plainly written and certain."""
    for name in cli.FAMILIES:
        if family in ("", name):
            for task in cli.family(name).tasks.values():
                if task.tracked:
                    yield from ((task, example) for example in task.examples)


def bound_inputs(task: Task, example: str) -> Fields | None:
    """An example's inputs as read; None where it is not one plain, certain case."""
    words = shlex.split(example)[1 + len(task.path.split()) :]
    call = read_plainly(task, words)
    if call is None or any(name in call.settings for name in ("rows", "sweep")):
        return None
    terminal = Terminal(environ={})
    gathered = gather(task, call, Settings({}, {}), terminal)
    gathered.reader.uncertain = {}
    try:
        made = gathered.reader.read(task.specification.fields, gathered.raw)
    except DynamicsError:
        return None
    return None if gathered.reader.uncertain else made


def numbers_of(value: Any, address: str = "") -> Iterator[tuple[str, Any]]:
    """Every number of a result, by address."""
    if hasattr(value, "fields"):
        for name in value.fields:
            if name not in ("checks", "advice", "numerics"):
                yield from numbers_of(getattr(value, name), f"{address}.{name}")
    elif isinstance(value, (tuple, list)):
        for index, item in enumerate(value):
            yield from numbers_of(item, f"{address}[{index}]")
    elif isinstance(value, (Tracked, Precise)):
        yield address, value


def disturbed(rng: random.Random, leaves: list[tuple[str, Any, float]]) -> list[float]:
    """The inputs, some of them moved, within what their kinds allow."""
    made = []
    for _, kind, value in leaves:
        new = value
        if rng.random() < 0.6:
            new = value * (1.0 + rng.choice(STEPS) * rng.uniform(-1.0, 1.0))
        elif rng.random() < 0.1:
            new = value * 10.0 ** rng.uniform(-6.0, 6.0)
        elif rng.random() < 0.1:
            new = rng.choice((0.0, 1.0, -value))
        made.append(value if kind.outside(new) else new + 0.0)
    return made


def broken(task: Task, inputs: Fields, count: int, seed: int) -> tuple[int, list[str]]:
    """How many evaluations had an answer, and where a bound was below the error."""
    rng = random.Random(seed)
    leaves = list(inputs.leaves())
    model, _ = choose(task, inputs, "")
    found: list[str] = []
    answered = 0
    for _ in range(count):
        values = disturbed(rng, leaves)
        names = [address for address, _, _ in leaves]
        try:
            tracked = call_model(task, model, inputs, dict(zip(names, Tracked.inputs(values), strict=True)))
            precise = call_model(task, model, inputs, dict(zip(names, map(Precise, values), strict=True)))
        except (DynamicsError, ArithmeticError):
            continue
        except TypeError:
            # Physics that makes tracked numbers of its own takes no others.
            return answered, found
        answered += 1
        exact = dict(numbers_of(precise))
        for address, number in numbers_of(tracked):
            if address not in exact or number.error != number.error or number.error == float("inf"):
                continue
            error = abs(mpf(number.value) - exact[address].value)
            # A direction at the cut between −180 and 180 degrees is one direction.
            error = min(error, abs(error - 2 * mp.pi))
            if error > mpf(number.error):
                found.append(f"{task.path}{address}: error {mp.nstr(error, 3)}, bound {number.error:.3g}, at {values}")
    return answered, found


def main() -> None:
    """Search as long as asked, and tell what was found."""
    mp.dps = 60
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    for task, example in examples(sys.argv[2] if len(sys.argv) > 2 else ""):
        inputs = bound_inputs(task, example)
        if inputs is None or not list(inputs.leaves()):
            continue
        answered, found = broken(task, inputs, count, 1)
        print(f"{task.path:22} {answered:6} answered, {len(found)} broken   {example[:60]}", flush=True)
        for line in found[:3]:
            print("    " + line)


if __name__ == "__main__":
    main()
