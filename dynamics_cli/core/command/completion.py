"""Completions of a word or of an option's value: units, shapes, names, results."""

from dynamics_cli.core.answering.task import Task, load
from dynamics_cli.core.command.help import result_fields
from dynamics_cli.core.inputs.specification import Leaf, Tagged

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any

# What PowerShell runs on Tab. Each line printed is a word, `:::` and its help; help that is wrapped has lines without
# one, and a tip must not be empty.
POWERSHELL = """\
Register-ArgumentCompleter -Native -CommandName dynamics -ScriptBlock {
    param($word, $line, $position)
    $env:_DYNAMICS_COMPLETE = "complete_powershell"
    $env:_TYPER_COMPLETE_ARGS = $line.ToString()
    $env:_TYPER_COMPLETE_WORD_TO_COMPLETE = $word
    try {
        dynamics | Where-Object { $_ -match ":::" } | ForEach-Object {
            $name, $tip = $_ -split ":::", 2
            if (-not $tip) { $tip = $name }
            [System.Management.Automation.CompletionResult]::new($name, $name, "ParameterValue", $tip)
        }
    } finally {
        $env:_DYNAMICS_COMPLETE = $null
        $env:_TYPER_COMPLETE_ARGS = $null
        $env:_TYPER_COMPLETE_WORD_TO_COMPLETE = $null
    }
}
"""
# Forms of results that `--to` and `--limit` can name.
NUMBERS = ("scalar", "slope", "measured")


def words_that_fit(task: Task, incomplete: str) -> "list[str]":
    """Units, shapes and other names that can complete a word."""
    for field in task.specification.words:
        node = field.node
        item = getattr(node, "item", node)
        if isinstance(node, Tagged):
            return [name for name in node.members if name.startswith(incomplete)]
        if isinstance(item, Leaf) and item.choice is not None:
            return [name for name in item.choice.names if name.startswith(incomplete)]
        if isinstance(item, Leaf) and item.kind.form == "unit":
            from dynamics_cli.core.units.names import all_units

            return sorted(name for name, *_ in all_units() if name.startswith(incomplete))
    return []


def _results(task: Task) -> "Iterator[str]":
    """The addresses of the numbers outside tables."""
    for address, field in result_fields(task.specification.result):
        if isinstance(field.node, Leaf) and field.node.choice is None and field.node.kind.form in NUMBERS:
            yield address


def result_completer(task: Task) -> "Callable[[Any, Any, str], list[str]]":
    """The names of a task's results, looked up only when they are asked for."""

    def complete(context: "Any", parameter: "Any", incomplete: str) -> "list[str]":
        return [f"{name}=" for name in _results(task) if name.startswith(incomplete)]

    return complete


def completer_of(names: "tuple[str, ...] | str") -> "Callable[[Any, Any, str], list[str]]":
    """A completer of these names; a text such as "module:names" says where to load them from when needed."""

    def complete(context: "Any", parameter: "Any", incomplete: str) -> "list[str]":
        return [name for name in (load(names) if isinstance(names, str) else names) if name.startswith(incomplete)]

    return complete
