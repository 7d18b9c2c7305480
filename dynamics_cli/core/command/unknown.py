"""Errors for options and words that a task does not have: all at once, each with the likely meaning."""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS
from dynamics_cli.core.inputs.suggestions import suggestions
from dynamics_cli.errors import ManyErrors, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


def near_option(task: Task, word: str) -> str:
    """The option that an unknown one probably means."""
    near = suggestions(word.lstrip("-").partition("=")[0], task.options, UNIVERSAL_OPTIONS)
    return (
        "did you mean " + " or ".join(f"--{name}" for name in near) + "?"
        if near
        else f"try: dynamics {task.path} --help"
    )


def unknown_option(task: Task, word: str, typed: "Sequence[str]") -> UsageError:
    """The error for an unknown option, combined with those for other unknown options in the call."""
    known = {f"--{name}" for name in (*task.options, *UNIVERSAL_OPTIONS, "help", "template")}
    names = [part.partition("=")[0] for part in typed if part.startswith("--") and part[2:3].isalpha()]
    unknown = dict.fromkeys([word, *(name for name in names if name not in known)])
    errors = [
        UsageError(
            f"there is no option {name}",
            code="unknown-option",
            parameter=name.lstrip("-") or None,
            hint=near_option(task, name),
        )
        for name in unknown
    ]
    return errors[0] if len(errors) == 1 else ManyErrors(errors)


def extra_words(task: Task, message: str) -> UsageError:
    """The error for words where a task takes only options."""
    words = message.rpartition(" (")[2].removesuffix(")")
    example = task.shown_examples[0] if task.shown_examples else f"dynamics {task.path} --help"
    hint = f"for example: {example}"
    if words.endswith((".toml", ".json", ".yaml", ".yml")):
        hint = f"a file of them: dynamics {task.path} --input {words}"
    return UsageError(f"unexpected {words!r}: {task.path} takes its values by name", code="unexpected", hint=hint)
