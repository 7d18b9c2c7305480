"""One case answered: the model chosen, the physics called with tracked numbers, the record it returned."""

from dynamics_cli.core.answering.task import Model, Task, load
from dynamics_cli.core.inputs.specification import Leaf, Record
from dynamics_cli.core.inputs.values import Fields
from dynamics_cli.errors import DynamicsError, InadmissibleError, MissingError, UsageError
from dynamics_cli.records import Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from dynamics_cli.quantities import Kind

# With more inputs than this only bounds are calculated, no condition numbers.
MOST_SLOPES = 400
# Larger numbers, in SI units, belong to no machine; their squares soon leave the range of a double.
IMMENSE = 1e100


class Answer:
    """The record that the physics returned, its model, and the inputs that its derivatives belong to."""

    __slots__ = ("leaves", "model", "record", "why")

    def __init__(self, record: "Any", model: Model, why: str, leaves: "list[tuple[str, float]]") -> None:
        self.record = record
        self.model = model
        self.why = why
        self.leaves = leaves


def choose(task: Task, bound: Fields, requested: str) -> "tuple[Model, str]":
    """The requested model, or the smallest that suffices, and the reason."""
    if requested:
        for model in task.models:
            if requested.lower() == model.key:
                return model, "asked for"
        names = ", ".join(model.key for model in task.models)
        raise UsageError(f"there is no model {requested!r} of {task.path}", parameter="model", hint=f"there is {names}")
    for model in task.models[:-1]:
        args, kwargs = arguments(task, bound)
        why = load(model.suffices)(*args, **kwargs)
        if why is not None:
            return model, why
    last = task.models[-1]
    return last, "no smaller model suffices" if len(task.models) > 1 else ""


def arguments(
    task: Task, bound: Fields, values: "Mapping[str, Any] | None" = None
) -> "tuple[list[Any], dict[str, Any]]":
    """Positional and keyword arguments for the physics function, with `values` at their addresses."""
    objects = bound.assemble(values or {})
    args: list[Any] = []
    for field in task.specification.words:
        if field.name in objects:
            value = objects.pop(field.name)
            args.extend(value if field.place == "words" else (value,))
    return args, objects


def call_model(task: Task, model: Model, bound: Fields, values: "Mapping[str, Any] | None" = None) -> "Any":
    """The physics function's record; overflow is a refusal, never a traceback."""
    args, kwargs = arguments(task, bound, values)
    try:
        return model.call()(*args, **kwargs)
    except DynamicsError as error:
        from dynamics_cli.core.answering.messages import in_written_units

        if isinstance(error, MissingError):
            error.name(bound.spell)
        error.message = in_written_units(error.message, bound)
        error.hint = in_written_units(error.hint, bound) if error.hint else None
        raise
    except (ArithmeticError, ValueError) as error:
        # where an input is beyond all measure, `sqrt` and solvers of equations meet an infinity
        if isinstance(error, ValueError) and all(abs(si) < IMMENSE for _, _, si in bound.leaves()):
            raise
        raise InadmissibleError(
            f"the calculation leaves the range of a double ({error})", code="range", hint="check the size of the inputs"
        ) from None


def answer(
    task: Task, bound: Fields, asked: str = "", uncertain: "Mapping[str, Any] | None" = None, *, seen: bool = True
) -> Answer:
    """Answer one case, with derivatives and rounding bounds where the model can carry them.

    `uncertain` has the distributions of measured inputs by address, for physics that judges a gap by them. Bounds
    that are not `seen` need not be tight.
    """
    model, why = choose(task, bound, asked)
    leaves = [(address, si) for address, _, si in bound.leaves()] if task.tracked else []
    if not leaves:
        return Answer(call_model(task, model, bound), model, why, [])
    from dynamics_cli.core.answering.tightening import tighten
    from dynamics_cli.numerics.tracked import Tracked

    def call(numbers: "list[Any]") -> "Any":
        values = {address: number for (address, _), number in zip(leaves, numbers, strict=True)}
        return call_model(task, model, bound, values)

    doubles = [si for _, si in leaves]
    # every number carries its derivative by every input, so the cost grows with the square of their count
    sloped = len(leaves) <= MOST_SLOPES
    numbers = Tracked.inputs(doubles) if sloped else [Tracked(si, 0.0, ()) for si in doubles]
    if uncertain and sloped:
        from dynamics_cli.sampling import Measured

        with Measured(tuple(uncertain[name].std if name in uncertain else 0.0 for name, _ in leaves)):
            record = call(numbers)
    else:
        record = call(numbers)
    tighten(record, doubles, call, seen=seen)
    return Answer(record, model, why, leaves if sloped else [])


def result_leaves(record: "Any", spec: Record) -> "Iterator[tuple[str, Kind, Any]]":
    """Every real number of a result record that is not within a table: address, kind, value."""
    return (leaf for leaf in _leaves(record, spec, "") if leaf[1].form in ("scalar", "slope"))


def result_components(record: "Any", spec: Record) -> "Iterator[tuple[str, Kind, Any]]":
    """Every component (`velocity[0]`) of a vector or tensor that has a unit and is not within a table.

    Directions and axes are left out: a small change may reverse them.
    """
    for component_address, kind, value in _leaves(record, spec, ""):
        if kind.unit and kind.form in ("vector", "planar"):
            yield from ((f"{component_address}[{i}]", kind, value[i]) for i in range(kind.size))
        elif kind.unit and kind.form == "tensor":
            places = range(kind.size)
            yield from ((f"{component_address}[{i}][{j}]", kind, value[i][j]) for i in places for j in places)


def _leaves(record: "Any", spec: Record, address: str) -> "Iterator[tuple[str, Kind, Any]]":
    for field in spec.fields:
        value = getattr(record, field.name)
        field_address = f"{address}.{field.key}" if address else field.key
        if value is None:
            continue
        if isinstance(field.node, Record):
            yield from _leaves(value, field.node, field_address)
        elif isinstance(value, Quantity):
            yield field_address, value.kind, value.value
        elif isinstance(field.node, Leaf) and field.node.choice is None:
            yield field_address, field.node.kind, value


def result_numbers(record: "Any", spec: Record) -> "Iterator[tuple[str, Kind, Any]]":
    """Every real number of a result record that is not within a table, components of vectors last."""
    yield from result_leaves(record, spec)
    yield from result_components(record, spec)
