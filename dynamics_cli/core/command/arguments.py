"""A call's arguments as typer parsed them, or as Python callers give them.

Options given twice or without a value are refused; numbers of other libraries become Python's.
"""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.unknown import groups_with, unknown_option
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS, Call
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

# Command-line options without meaning for a function that returns a dictionary, with their replacements.
REFUSED = {
    **dict.fromkeys(
        ("json", "format", "output"), "the call returns the document as a dictionary: write it with json.dump"
    ),
    "template": "write it with the command: dynamics FAMILY TASK --template",
    "rows": "for a stream of cases use dynamics_cli.run_rows, or one call for each case",
    "digits": "the document has all digits: round when you print",
}
# Python prints integers of some thousands of digits at most; no double is that large.
MOST_BITS = 4000


def call_of(task: Task, values: "dict[str, Any]") -> Call:
    """The call with the values that typer parsed."""
    call = Call()
    call.words = list(values.pop("words__", None) or ())
    for word in call.words:
        if word.startswith("-") and word[1:2] not in "0123456789." and word != "-":
            raise unknown_option(task, word, call.words)
    for name in UNIVERSAL_OPTIONS:
        value = values.pop(variable("setting", name), None)
        if value:
            call.settings[name] = single(name, value, UNIVERSAL_OPTIONS[name][0])
    for name, option in task.options.items():
        value = values.pop(variable("option", name), None)
        if value:
            how = "flag" if option.flag else "many" if option.repeats else "value"
            call.options[name] = single(
                name, value, how, groups_with(task, name) if how == "value" and len(value) > 1 else ()
            )
    return call


def variable(side: str, name: str) -> str:
    """Typer's name for the value of a task's option, or of a setting."""
    return f"{side}__{name.replace('-', '_')}"


def single(name: str, value: "Any", how: str, groups: "Sequence[str]" = ()) -> "Any":
    """The value of an option given once, or all values of one that repeats; `groups` that repeat take it as well."""
    if how == "flag":
        return True
    if how == "many":
        return list(value)
    if value[-1].startswith("--"):
        raise UsageError(f"--{name} has no value: it is followed by {value[-1]}", code="missing", parameter=name)
    if len(value) > 1:
        hint = f'several: --{groups[0]} "{name}=…" for each' if groups else None
        raise UsageError(f"--{name} is given {len(value)} times", code="repeated", parameter=name, hint=hint)
    return value[0]


def plain_parameters(parameters: "Mapping[str, object]") -> "dict[str, Any]":
    """Parameters by name (`from_` is `from`), their values as JSON has them."""
    return {name.rstrip("_"): _plain(value, name) for name, value in parameters.items()}


def options_of(raw: "dict[str, Any]") -> "dict[str, Any]":
    """Separate the universal options from the parameters, in the form of the command line."""
    keys = {name: name.replace("-", "_") for name in UNIVERSAL_OPTIONS}
    settings = {name: value for name, key in keys.items() if (value := raw.pop(key, None)) is not None}
    for name, value in settings.items():
        how = UNIVERSAL_OPTIONS[name][0]
        if name in REFUSED or (name == "plot" and value == "-"):
            hint = REFUSED.get(name, "name a file")
            raise UsageError(f"{name}={value!r} is an option of the command line only", parameter=name, hint=hint)
        if how == "flag":
            if not isinstance(value, bool):
                raise UsageError(f"read {name}={value!r}, wanted True or False", parameter=name)
        elif how == "many":
            settings[name] = [_text(name, item) for item in (value if isinstance(value, list) else [value])]
        else:
            settings[name] = _text(name, value)
    return settings


def _text(name: str, value: object) -> str:
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise UsageError(f"read {name}={value!r}, wanted text", parameter=name, hint=UNIVERSAL_OPTIONS[name][2])
    return str(value)


def _plain(value: "Any", name: str) -> "Any":
    if isinstance(value, dict):
        return {key: _plain(item, name) for key, item in value.items()}
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(item, name) for item in value]
    if isinstance(value, int) and value.bit_length() > MOST_BITS:
        raise UsageError(f"{name} is beyond the range of a double", code="range", parameter=name)
    return value
