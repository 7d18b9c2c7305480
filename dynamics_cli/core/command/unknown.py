"""Errors for unknown options and words of a task: all at once, each with the likely meaning."""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.help import describe_options
from dynamics_cli.core.command.task_help import group_keys, group_records
from dynamics_cli.core.documents import singular
from dynamics_cli.core.inputs.settings import FORMATS, SYSTEMS, UNIVERSAL_OPTIONS
from dynamics_cli.core.inputs.suggestions import MOST, halved, suggestions
from dynamics_cli.errors import ManyErrors, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


def near_option(task: Task, word: str) -> str:
    """The option that an unknown one probably means: by its name, by its description, or one that every task has."""
    typed = word.lstrip("-").partition("=")[0].lower()
    if typed in (*task.options, *UNIVERSAL_OPTIONS):
        return f"did you mean --{typed}?"
    for name, values in (("units", SYSTEMS), ("format", FORMATS)):
        if typed in values:
            return f"did you mean --{name} {typed}?"
    near = (
        [name for name in task.options if singular(name) == typed]
        + [f'{name} "{typed}=…"' for name in groups_with(task, typed)]
        or suggestions(typed, task.options)
        or _each_of(task, typed)
        or _described(task, typed)
        or suggestions(typed, UNIVERSAL_OPTIONS)
    )
    if typed == "report":
        return "a report is made of a document: --output case.json, then: dynamics report case.json"
    if not near:
        return f"try: dynamics {task.path} --help"
    return "did you mean " + " or ".join(f"--{name}" for name in near) + f"{halved(typed, near)}?"


def groups_with(task: Task, typed: str) -> "list[str]":
    """The repeatable options whose records have a value of this very name: `--piece` for `--width`."""
    groups = {name: option for name, option in task.options.items() if option.leaf is None}
    return [
        name
        for name, option in groups.items()
        if any(typed in group_keys(record) for record in group_records(task.specification.fields, option.path))
    ]


def _each_of(task: Task, typed: str) -> "list[str]":
    """The few options for each of what was typed as several: `--first-plane` and `--second-plane` for `--planes`."""
    near = [name for name in task.options if singular(typed) != typed and singular(typed) in name.split("-")]
    return near if len(near) <= MOST else []


def _described(task: Task, typed: str) -> "list[str]":
    """The few options whose kind or description has every word that was typed: `--elevation` for `--launch-angle`."""
    words = set(typed.replace("_", "-").split("-"))
    texts = describe_options(task)
    found = []
    for name, option in task.options.items():
        kind = option.leaf.kind.name if option.leaf else ""
        text = "".join(c if c.isalnum() else " " for c in f"{kind} {texts.get(option.path, '')}".lower())
        if words.issubset(text.split()):
            found.append((not words.issubset(kind.split()), name))
    same_kind = [name for other, name in sorted(found) if not other]
    near = same_kind or [name for _, name in found]
    return near if len(near) <= MOST else []


def unknown_option(task: Task, word: str, typed: "Sequence[str]") -> UsageError:
    """The error for an unknown option, combined with those for other unknown options in the call."""
    known_options = {f"--{name}" for name in (*task.options, *UNIVERSAL_OPTIONS, "help", "template")}
    names = [part.partition("=")[0] for part in typed if part.startswith("--") and part[2:3].isalpha()]
    unknown = dict.fromkeys([word, *(name for name in names if name not in known_options)])
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


def without_value(task: Task, option: str) -> UsageError:
    """The error for an option at the end of a call, without its value."""
    name = {"-o": "output"}.get(option, option.lstrip("-"))
    known = task.options.get(name)
    hint = None
    if name in UNIVERSAL_OPTIONS:
        _, metavar, text = UNIVERSAL_OPTIONS[name]
        hint = f"--{name} {metavar}: {text[:1].lower()}{text[1:].rstrip('.')}"
    elif known is not None and known.leaf is not None:
        names = known.leaf.choice.names if known.leaf.choice else ()
        example = known.leaf.kind.example
        hint = f"one of {', '.join(names)}" if names else example and f'for example --{name} "{example}"'
    return UsageError(f"{option} needs a value", code="no-value", parameter=name, hint=hint)


def extra_words(task: Task, message: str, argv: "Sequence[str]") -> UsageError:
    """The error for words where a task takes only options."""
    words = message.rpartition(" (")[2].removesuffix(")")
    example = task.shown_examples[0] if task.shown_examples else f"dynamics {task.path} --help"
    hint = _quoted(words, argv) or f"for example: {example}"
    pairs = [word.partition("=") for word in words.split()]
    if all(equals and name in task.options for name, equals, _ in pairs):
        hint = f"did you mean {' '.join(f'--{name} {value}' for name, _, value in pairs)}?"
    if words == "help":
        hint = f"did you mean dynamics help {task.path}?"
    if len(task.options) == 1:
        hint = f"did you mean --{next(iter(task.options))} {words}?"
    if words.endswith((".toml", ".json", ".yaml", ".yml")):
        hint = f"a file of them: dynamics {task.path} --input {words}"
    return UsageError(f"unexpected {words!r}: {task.path} takes its values by name", code="unexpected", hint=hint)


def _quoted(words: str, argv: "Sequence[str]") -> str:
    """The option before words that belong to its value, all of it in quotes: `--distance "60 ft"`."""
    first = words.split(" ")[0]
    at = argv.index(first) if first in argv else 0
    if at < 2 or not argv[at - 2].startswith("--"):
        return ""
    end = next((place for place in range(at, len(argv)) if argv[place].startswith("--")), len(argv))
    return f'quote a value that has spaces: {argv[at - 2]} "{" ".join(argv[at - 1 : end])}"'
