"""Commands about commands: the JSON Schema of a task, and the reference of all of them."""

from dynamics_cli.core.task import Family, Task
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    Finder = Callable[[str], Family]
    Lines = Mapping[str, tuple[str, str]]

# Name: its words, what it does, an example.
COMMANDS = {
    "schema": (
        "FAMILY [TASK]",
        "Print the JSON Schema of a task's inputs and outputs.",
        "dynamics schema skid speed",
    ),
    "reference": (
        "[FAMILY]...",
        "Print the reference of all commands, or of some families: every parameter, result, formula and source.",
        "dynamics reference skid --format markdown",
    ),
}


def text_of(name: str, words: "Sequence[str]", form: str, families: "Lines", find: "Finder") -> str:
    """What a command about commands prints."""
    if name == "schema":
        from dynamics_cli.core.render import to_pretty_json
        from dynamics_cli.core.schema import schema

        if form:
            raise UsageError("a schema is JSON", parameter="format", code="exclusive")
        return to_pretty_json(schema(_task(words, families, find)))
    from dynamics_cli.core.manual import FORMS, WRITERS

    if form and form not in FORMS:
        raise UsageError(f"read {form!r}, wanted one of {', '.join(FORMS)}", parameter="format", code="unknown-choice")
    for word in words:
        _known(word, families)
    return WRITERS[form or FORMS[0]]([find(word) for word in words or families])


def _known(name: str, families: "Lines") -> None:
    if name in families:
        return
    from dynamics_cli.core.words import nearest_words

    near = nearest_words(name, families)
    hint = f"did you mean {near[0]}?" if near else f"there is {', '.join(families)}"
    raise UsageError(f"there is no family {name!r}", code="unknown-command", hint=hint)


def _task(words: "Sequence[str]", families: "Lines", find: "Finder") -> Task:
    if not words:
        hint = "for example: dynamics schema skid speed"
        raise UsageError("a family and its task are missing", code="missing", hint=hint)
    _known(words[0], families)
    family = find(words[0])
    task = family.alone or family.tasks.get(words[1] if len(words) > 1 else "")
    if len(words) > (1 if family.alone else 2):
        raise UsageError(f"unexpected word {words[-1]!r}", code="unexpected")
    if task is None:
        hint = f"there is {', '.join(family.tasks)}"
        raise UsageError(f"{words[0]} has no such task", code="unknown-command", hint=hint)
    return task


def completions(name: str, words: "Sequence[str]", families: "Lines", find: "Finder") -> "list[str]":
    """The words that may come next."""
    if name == "reference" or not words:
        return list(families)
    if len(words) == 1 and words[0] in families:
        return [task for task in find(words[0]).tasks if task]
    return []
