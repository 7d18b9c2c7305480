"""Typer's parsed values as a call; options given twice or without a value are refused."""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.unknown import groups_with, unknown_option
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS, Call
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any


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
