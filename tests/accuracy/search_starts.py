"""Where the search for broken bounds starts: the examples of every tracked task and the reference cases called hard.

A start is a call of a task's physics function by its numbers alone, all else as given; what a number may be is what its
kind allows.
"""

import json
import re
import shlex
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "inertia"))

import inertia_answers
from references import impact_particles_tasks, skid_tasks
from references.comparison import DATA, build, leaves

from dynamics_cli import cli
from dynamics_cli.accuracy import catalogue
from dynamics_cli.core.answering.gather import gather
from dynamics_cli.core.answering.models import call_model, choose
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.direct import read_plainly
from dynamics_cli.core.inputs.settings import Settings
from dynamics_cli.core.inputs.specification import Leaf, Many, OneOf, Record, Tagged, specification
from dynamics_cli.core.inputs.values import Fields
from dynamics_cli.core.terminal import Terminal
from dynamics_cli.errors import DynamicsError
from dynamics_cli.gear import pitch
from dynamics_cli.gear.crossing import bevel, crossed, worm
from dynamics_cli.gear.measure import measurement
from dynamics_cli.gear.pair import pair as pairs
from dynamics_cli.gear.pair import records
from dynamics_cli.gear.pair.shift_split import Tips
from dynamics_cli.gear.single import cylindrical, trochoid
from dynamics_cli.impact.planar.impact import planar
from dynamics_cli.quantities import Kind


class Start:
    """A call by its numbers: the task, what the call is, the numbers and their kinds."""

    def __init__(
        self, task: str, label: str, numbers: list[float], kinds: list[Kind | None], call: Callable[[list[Any]], Any]
    ) -> None:
        self.task = task
        self.label = label
        self.numbers = numbers
        self.kinds = kinds
        self.call = call


# ---- examples ----

# Scenes of these are measured throughout: they are searched without their uncertainties.
MEASURED = ("impact crash",)
UNCERTAINTY = re.compile(r"( ± |\.\.)[0-9.]+")


def tracked_tasks(family: str = "") -> Iterator[Task]:
    """Every task that tracked numbers go through."""
    for name in cli.FAMILIES:
        if family in ("", name):
            yield from (task for task in cli.family(name).tasks.values() if task.tracked)


def certain(raw: Any) -> Any:
    """What was measured without its uncertainty: of `6.5 ± 0.3 m` and of a range, the value or its beginning."""
    if isinstance(raw, dict):
        return {name: certain(value) for name, value in raw.items()}
    if isinstance(raw, list):
        return [certain(value) for value in raw]
    return UNCERTAINTY.sub("", raw) if isinstance(raw, str) else raw


def bound_inputs(task: Task, example: str) -> Fields | None:
    """An example's inputs as read; None where it is not one plain, certain case."""
    words = shlex.split(example)[1 + len(task.path.split()) :]
    call = read_plainly(task, words)
    if call is None or any(name in call.settings for name in ("rows", "sweep")):
        return None
    terminal = Terminal(environ={})
    gathered = gather(task, call, Settings({}, {}), terminal)
    gathered.reader.uncertain = {}
    raw = certain(gathered.raw) if task.path in MEASURED else gathered.raw
    try:
        made = gathered.reader.read(task.specification.fields, raw)
    except DynamicsError:
        return None
    return None if gathered.reader.uncertain else made


def of_example(task: Task, example: str) -> Start | None:
    """The start an example gives, where it has numbers."""
    inputs = bound_inputs(task, example)
    found = list(inputs.leaves()) if inputs is not None else []
    if inputs is None or not found:
        return None
    model, _ = choose(task, inputs, "")
    names = [address for address, _, _ in found]

    def call(numbers: list[Any]) -> Any:
        return call_model(task, model, inputs, dict(zip(names, numbers, strict=True)))

    return Start(task.path, example, [value for _, _, value in found], [kind for _, kind, _ in found], call)


# ---- hard cases ----


def doubles_of(part: Any) -> Iterator[float]:
    """Every double of a function's arguments: of records, tuples and dictionaries."""
    if type(part) is float:
        yield part
    elif isinstance(part, dict):
        for item in part.values():
            yield from doubles_of(item)
    elif isinstance(part, tuple):
        for item in part:
            yield from doubles_of(item)
    elif hasattr(part, "fields"):
        for name in part.fields:
            yield from doubles_of(getattr(part, name))


def with_numbers(part: Any, numbers: Iterator[Any]) -> Any:
    """The arguments with `numbers` in place of the doubles, in the same order."""
    if type(part) is float:
        return next(numbers)
    if isinstance(part, dict):
        return {name: with_numbers(item, numbers) for name, item in part.items()}
    if isinstance(part, tuple):
        return tuple(with_numbers(item, numbers) for item in part)
    if hasattr(part, "fields"):
        return type(part)(**{name: with_numbers(getattr(part, name), numbers) for name in part.fields})
    return part


def kinds_of(node: Any, part: Any) -> Iterator[Kind | None]:
    """The kinds of the doubles of an argument, as the signature's node says."""
    if type(part) is float:
        yield node.kind if isinstance(node, Leaf) else None
    elif isinstance(part, tuple):
        for item in part:
            yield from kinds_of(node.item if isinstance(node, Many) else node, item)
    elif hasattr(part, "fields"):
        members = {OneOf: lambda: node.members, Tagged: lambda: node.members.values()}
        among = members.get(type(node), lambda: (node.item,) if isinstance(node, Many) else (node,))()
        record = next((one for one in among if isinstance(one, Record) and one.cls is type(part)), Record(type(part)))
        for field in record.fields:
            yield from kinds_of(field.node, getattr(part, field.name))


def of_call(task: str, label: str, function: Callable[..., Any], arguments: dict[str, Any]) -> Start:
    """The start that a function's arguments give."""
    numbers = list(doubles_of(arguments))
    kinds: list[Kind | None] = [None] * len(numbers)
    if function.__module__ != inertia_answers.__name__ and "return" in function.__annotations__:
        nodes = {field.name: field.node for field in specification(function).fields}
        kinds = [kind for name, part in arguments.items() for kind in kinds_of(nodes[name], part)]
    return Start(task, label, numbers, kinds, lambda own: function(**with_numbers(arguments, iter(own))))


def hard(file: str) -> Iterator[dict[str, Any]]:
    """The hard cases of a file of references."""
    for case in json.loads((DATA / file).read_text(encoding="utf-8"))["cases"]:
        if case["kind"] == "hard":
            yield case


GEAR_RECORDS = {
    one.__name__: one for one in (pitch.NormalModule, records.Mate, worm.AxialModule, worm.WormDiameter, crossed.Screw)
}
GEAR_CHOICES = {"tips": Tips, "kind": bevel.Kind, "internal": bool}
GEAR = {
    "spur": cylindrical.spur,
    "helical": cylindrical.helical,
    "pair": pairs.pair,
    "bevel": bevel.bevel,
    "worm": worm.worm,
    "crossed": crossed.crossed,
}


IMPACT = impact_particles_tasks.TASKS | {"planar": planar}


def _gear_cases() -> Iterator[Start]:
    for case in hard("gear_geometry.json"):
        if case["task"] in GEAR:
            tree = case["inputs"]
            arguments = build(tree, leaves(tree), GEAR_RECORDS)
            arguments |= {name: GEAR_CHOICES[name](value) for name, value in case["choices"].items()}
            yield of_call(f"gear {case['task']}", case["name"], GEAR[case["task"]], arguments)
    for case in hard("gear_trains.json"):
        plain = {name: float(value) if isinstance(value, str) else value for name, value in case["inputs"].items()}
        if case["task"] == "root":
            yield _of_root(case["name"], trochoid.Cutter(**plain))
            continue
        plain["pitch"] = pitch.NormalModule(plain.pop("module"))
        if plain["internal"] and plain["helix_angle"]:
            plain.pop("over")
        yield of_call("gear measure", case["name"], measurement.measure, plain)


# The command takes no other pressure angles; the function by itself does not ask.
PRESSURE_ANGLE = Kind("angle", "rad", above=0.0, below=1.57)


def _of_root(label: str, cutter: trochoid.Cutter) -> Start:
    numbers = list(doubles_of(cutter))
    kinds: list[Kind | None] = [PRESSURE_ANGLE] + [None] * (len(numbers) - 1)
    return Start(
        "gear profile, root", label, numbers, kinds, lambda own: trochoid.root(with_numbers(cutter, iter(own)))
    )


def _impact_cases() -> Iterator[Start]:
    for file in ("impact_particles.json", "impact_rigid.json"):
        for case in hard(file):
            task = case["task"]
            if task in IMPACT and task not in impact_particles_tasks.UNTRACKED:
                path = "impact " + task.replace("_and_energy", "").replace("_", "-")
                yield of_call(path, case["name"], IMPACT[task], _arguments("impact", case["inputs"]))


def _inertia_cases() -> Iterator[Start]:
    for case in hard("inertia_bodies.json"):
        task = case["task"]
        yield of_call(
            f"inertia {task}", case["name"], inertia_answers.FUNCTIONS[task], _arguments("inertia", case["inputs"])
        )


def _arguments(family: str, tree: Any) -> dict[str, Any]:
    return build(tree, leaves(tree), catalogue.groups(family))


def _skid_cases() -> Iterator[Start]:
    for case in hard("skid.json"):
        arguments = build(case["inputs"], leaves(case["inputs"]), skid_tasks.GROUPS)
        path = "skid " + case["task"].replace("vault_least_speed", "vault").replace("vault_known_angle", "vault")
        yield of_call(path.replace("_", "-"), case["name"], skid_tasks.TASKS[case["task"]], arguments)


HARD_CASES = {"skid": _skid_cases, "impact": _impact_cases, "inertia": _inertia_cases, "gear": _gear_cases}


# A body of triangles is summed in arrays of pairs of doubles, which no other numbers go through.
ARRAYS_ONLY = ("inertia mesh",)
# Its sums are exact, of the decimals as typed: nothing is left for a bound.
# The examples of the second read a file; its bounds are judged by the references of the family.
OTHERWISE = ("force first-moment", "human moments")


def starts(family: str = "") -> Iterator[Start]:
    """Every start of the search: examples, then hard cases."""
    for task in tracked_tasks(family):
        if task.path in (*ARRAYS_ONLY, *OTHERWISE):
            continue
        for example in task.examples:
            one = of_example(task, example)
            if one is not None:
                yield one
    for name, cases in HARD_CASES.items():
        if family in ("", name):
            yield from cases()
