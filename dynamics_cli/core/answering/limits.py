"""`--limit "50 mph"`: a result against a limit; for certain inputs a plain check."""

from dynamics_cli.core.answering.models import result_leaves
from dynamics_cli.core.documents import number
from dynamics_cli.core.inputs.quantity_text import read_scalar
from dynamics_cli.core.inputs.values import Fields, Value
from dynamics_cli.errors import DynamicsError, UsageError
from dynamics_cli.numerics.number import plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.answering.models import Answer
    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.inputs.quantity_text import Reading
    from dynamics_cli.core.inputs.settings import Settings
    from dynamics_cli.core.inputs.values import Bound
    from dynamics_cli.core.units.display import Display
    from dynamics_cli.quantities import Kind


def add_limits(
    document: "dict[str, Any]",
    task: "Task",
    bound: "Fields",
    answered: "Answer",
    settings: "Settings",
    display: "Display",
) -> None:
    """Put each limit beside its result: within it or not, and by how much; undecided within the error bound."""
    document["limits"] = []
    for key, kind, value, reading in read_limits(task, bound, answered, settings):
        shown = display.of(key, kind)
        entry = limit_entry(key, value, reading, shown)
        if entry["by"]["value"] < _error(document["numerics"], key, abs(shown.width(value))):
            entry["undecided"] = True
            entry["message"] = f"{key} is at the limit: the difference is less than the error bound of {key}"
        document["limits"].append(entry)


def _error(numerics: "dict[str, Any]", key: str, size: float) -> float:
    """Error bound of a result of this size, as the document states it: calculation and rounding of the inputs."""
    total = 0.0
    for part in ("error_bound", "input_rounding"):
        stated = numerics.get(part, {}).get(key) or {}
        total += stated.get("absolute", 0.0) + stated.get("relative", 0.0) * size
    return total


def read_limits(
    task: "Task", bound: "Fields", answered: "Answer", settings: "Settings"
) -> "list[tuple[str, Kind, float, Reading]]":
    """Each limit as read: the result's name and kind, its value, and the limit."""
    if not (settings.limit or task.limited):
        return []
    present = {name: (kind, value) for name, kind, value in result_leaves(answered.record, task.specification.result)}
    kinds = {name: kind for name, (kind, _) in present.items()}
    if not kinds:
        raise UsageError(f"{task.path} has no result that a limit can be applied to", parameter="limit")
    limits = []
    for name, text in settings.limit or _among_inputs(task, bound, kinds):
        if name and name not in kinds:
            from dynamics_cli.core.units.near_names import instead_of

            declared = any(field.key == name for field in task.specification.result.fields)
            why = f"{name!r} has no value here" if declared else f"there is no result {name!r}"
            raise UsageError(why, parameter="limit", hint=instead_of(name, kinds), code="unknown-result")
        key, kind, limit = limited(text, {name: kinds[name]} if name else kinds)
        limits.append((key, kind, plain(present[key][1]), limit))
    return limits


def _among_inputs(task: "Task", bound: "Fields", kinds: "dict[str, Kind]") -> "list[tuple[str, str]]":
    """The limits that the inputs have: of each group of results for the first one that has a value."""
    limits = []
    for parameter, groups in task.limited.items():
        given: Bound | None = bound
        for key in parameter.split("."):
            given = given.fields.get(key) if isinstance(given, Fields) else None
        if type(given) is Value and not given.parts:
            present = [next((name for name in group.split() if name in kinds), "") for group in groups]
            limits += [(name, f"{given.shown} {given.unit}") for name in present if name]
    return limits


def limited(text: str, kinds: "dict[str, Kind]") -> "tuple[str, Kind, Reading]":
    """The first result that a limit of this kind can apply to, its kind, and the limit read."""
    first: DynamicsError | None = None
    for key, kind in kinds.items():
        try:
            return key, kind, read_scalar(text, kind)
        except DynamicsError as error:
            first = first or error
    assert first is not None
    first.parameter = "limit"
    raise first


def limit_entry(key: str, value: float, reading: "Reading", shown: "Any") -> "dict[str, Any]":
    """The document's entry of one limit."""
    limit = reading.si
    by = abs(shown.width(value - limit))
    unit = {"unit": shown.bound_unit} if shown.bound_unit else {}
    words = "at" if value == limit else "beyond" if value > limit else "within"
    return {
        "result": key,
        "beyond": value > limit,
        "by": {"value": by, **unit},
        "message": f"{key} is {words} the limit" + (f" by {number(by, 6)} {shown.bound_unit}".rstrip() if by else ""),
        "limit": {"value": reading.value, "unit": reading.unit} if reading.unit else {"value": reading.value},
    }
