"""Finds tasks by words: `dynamics help flywheel`, and what a command that there is not may mean."""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.help import UNCERTAIN, describe_options, option_lines
from dynamics_cli.core.documents import singular
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS
from dynamics_cli.core.output.wrapping import wrapped
from dynamics_cli.core.units.near_names import nearest_words
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from dynamics_cli.core.answering.task import Family
    from dynamics_cli.core.terminal import Terminal

    Finder = Callable[[str], Family]

# Words of a question that say nothing of its subject.
IDLE = {"a", "an", "and", "at", "by", "for", "from", "how", "in", "is", "of", "on", "or", "the", "to", "what", "with"}
# Words of the trades, and the ones that the texts here use.
SAME = {
    "edr": "recorder", "cdr": "recorder", "blackbox": "recorder", "center": "centre", "cg": "centroid",
    "cog": "centroid", "moi": "inertia", "tire": "tyre", "prt": "reaction", "headway": "gap", "motorcycle": "rider",
    "bicycle": "rider", "cyclist": "rider", "accident": "crash", "reconstruction": "crash", "collision": "impact",
    "airbag": "recorder", "brake": "braking", "brakes": "braking", "knockback": "throw",
}  # fmt: skip
MOST, MOST_MEANT = 12, 3
# What other programs call commands and options of this one.
ELSEWHERE = {"version": "--version", "list": "--help", "commands": "--help", "usage": "--help"}
ELSEWHERE |= dict.fromkeys(("man", "manual", "docs"), "reference")
# From this length on the beginning of a word stands for it: "balanc" for balance and balancing.
STEM = 5
# A task's name of so many letters stands for longer words: "gyro" for gyroscope.
NAME = 4


def tasks_about(words: "Sequence[str]", families: "Iterable[str]", find: "Finder") -> "list[Task]":
    """The tasks about all the words: those that are called so, then by their summaries, else by all their texts."""
    terms = [SAME.get(term, term) for word in words for term in _words(word) if term not in IDLE]
    tasks = [task for name in families for task in find(name).tasks.values()] if terms else []
    called = [task for task in tasks if _about(terms, _called(task), NAME)]
    found = called + [task for task in tasks if task not in called and _about(terms, _summarized(task))]
    return found or [task for task in tasks if _about(terms, _described(task))]


def _called(task: Task) -> str:
    return " ".join((task.family, task.name, *task.also))


def _summarized(task: Task) -> str:
    labels = " ".join(f"{address} {label}" for address, label in task.headline)
    return f"{_called(task)} {task.summary} {labels}"


def _described(task: Task) -> str:
    named = " ".join(f"{model.name} {model.source}" for model in task.models)
    return f"{_summarized(task)} {named} {' '.join(task.options)} {' '.join(describe_options(task).values())}"


def _about(terms: "Sequence[str]", text: str, name: int = 0) -> bool:
    words = _words(text)
    return all(any(_same(term, word, name) for word in words) for term in terms)


def _same(term: str, word: str, name: int) -> bool:
    if term == word or singular(term) == singular(word) or (name and len(word) >= name and term.startswith(word)):
        return True
    stem = min(len(term), len(word))
    return stem >= STEM and (word.startswith(term) or (term.startswith(word) and len(term) - stem <= 3))


def _words(text: str) -> "list[str]":
    return "".join(c if c.isalnum() else " " for c in text.lower()).split()


def _options_about(words: "Sequence[str]") -> "list[str]":
    """The options of every task about all the words: those that are called so, else by what they do."""
    terms = [term for word in words for term in _words(word) if term not in IDLE]
    if not terms:
        return []
    called = [name for name in UNIVERSAL_OPTIONS if _about(terms, name)]
    # what an example names is not what the option is about
    return called or [
        name for name, (_, _, text) in UNIVERSAL_OPTIONS.items() if _about(terms, text.partition(": --")[0])
    ]


def print_found(words: "Sequence[str]", families: "Iterable[str]", find: "Finder", terminal: "Terminal") -> None:
    """List the tasks about some words, with their summaries, and the options of every task about them."""
    found, options = tasks_about(words, families, find), _options_about(words)
    if not found and not options:
        start = f"dynamics {words[0]} --help" if words and words[0] in families else "dynamics help"
        near = _spelled(words, families, find)
        hint = f"did you mean dynamics help {near}?" if near else f"try: {start}, or dynamics examples"
        raise UsageError(f"no task is about {' '.join(words)!r}", code="unknown-command", hint=hint)
    shown = found[:MOST]
    width, column = min(terminal.columns or 80, 80), max((len(task.path) for task in shown), default=0) + 2
    lines = []
    for task in shown:
        first, *others = wrapped(task.summary, width - column, 0)
        lines += [f"{task.path:<{column}}{first}", *(" " * column + line for line in others)]
    if len(found) > MOST:
        lines.append(f"and {len(found) - MOST} more: add a word")
    if options:
        lines += ["", "Options of every task:"] if lines else ["Options of every task:"]
        lines += option_lines(options, width)
    if _about(["uncertainty"], " ".join(words)):
        lines += ["", *wrapped(UNCERTAIN, width, 0)]
    terminal.write("\n".join(lines) + "\n")


def _spelled(words: "Sequence[str]", families: "Iterable[str]", find: "Finder") -> str:
    """The words with the spelling that the texts of tasks have, where tasks are about these."""
    texts = (_summarized(task) for name in families for task in find(name).tasks.values())
    known = sorted({word for text in texts for word in _words(text) if len(word) > 3})
    near = [next(iter(nearest_words(word, known, 1)), word) for word in words]
    return " ".join(near) if near != list(words) and tasks_about(near, families, find) else ""


def unknown_command(
    word: str, family: "Family | None", known: "Iterable[str]", families: "Iterable[str]", find: "Finder"
) -> UsageError:
    """The error for a command that there is not: a task of that name elsewhere, a similar name, tasks about it."""
    start = f"dynamics {family.name}" if family else "dynamics"
    tasks = [task for name in families for task in find(name).tasks.values() if word in (task.name, *task.also)]
    meant = (
        ([f"dynamics {ELSEWHERE[word]}"] if word in ELSEWHERE and family is None else [])
        or [f"dynamics {task.path}" for task in tasks]
        or [f"{start} {name}" for name in nearest_words(word, known)]
        or (_looked_up(family, word) if family else [])
        or [f"dynamics {task.path}" for task in tasks_about([word], families, find)]
    )
    hint = f"did you mean {' or '.join(meant)}?" if meant else f"try: {start} --help"
    if len(meant) > MOST_MEANT:
        hint = f"try: dynamics help {word}"
    message = f"{family.name} has no task {word!r}" if family else f"there is no command {word!r}"
    return UsageError(message, code="unknown-command", hint=hint)


def _looked_up(family: "Family", word: str) -> "list[str]":
    """Calls of a family of look-ups that a word may mean: a value of its first two tasks."""
    tasks = list(family.tasks.values())[:2]
    if not all(task.listing for task in tasks):
        return []
    return [" ".join(["dynamics", task.path, *(f"--{name}" for name in task.options), word]) for task in tasks]
