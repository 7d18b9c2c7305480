"""Commands about commands: the JSON Schema of a task, and the reference of all of them."""

from dynamics_cli.core.answering.task import Family, Task, load
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Mapping, Sequence

    from dynamics_cli.core.terminal import Terminal

    Finder = Callable[[str], Family]
    Lines = Mapping[str, tuple[str, str]]

REFERENCE_FORMS = ("markdown", "man")


class Option:
    """An option of a command that is not a task: its name, the placeholder of its value, help, and allowed values.

    An option without a metavar is a flag: it arrives as "yes".
    """

    def __init__(self, name: str, metavar: str, text: str, names: "tuple[str, ...]" = ()) -> None:
        self.name = name
        self.metavar = metavar
        self.text = text
        self.names = names


class Command:
    """A command that is not a task: its words, its help, an example, its options, and its function.

    The function takes the words, the options, the families' lines, how to find one, and the terminal. `names`
    ("module:function") gives the words that completion offers, unless they are families and tasks.
    """

    def __init__(
        self,
        name: str,
        metavar: str,
        line: str,
        more: str,
        example: str,
        options: "tuple[Option, ...]",
        function: str,
        names: str = "",
    ) -> None:
        self.names = names
        self.name = name
        self.metavar = metavar
        self.line = line
        self.more = more
        self.example = example
        self.options = options
        self.function = function

    def carry_out(
        self,
        words: "Sequence[str]",
        options: "Mapping[str, str]",
        families: "Lines",
        find: "Finder",
        terminal: "Terminal",
    ) -> None:
        """Run the command."""
        load(self.function)(words, options, families, find, terminal)


HERE = "dynamics_cli.core.command.plain_commands:"
COMMANDS = (
    Command(
        "schema",
        "FAMILY [TASK]",
        "Print the JSON Schema of a task's inputs and outputs.",
        "",
        "dynamics schema skid speed",
        (),
        HERE + "print_schema",
    ),
    Command(
        "reference",
        "[FAMILY]...",
        "Print the reference of all commands, or of some families.",
        "It lists every parameter, result, formula, assumption and source.",
        "dynamics reference skid --format markdown",
        (Option("format", "FORMAT", "markdown (the default) or man.", REFERENCE_FORMS),),
        HERE + "print_reference",
    ),
    Command(
        "help",
        "[FAMILY [TASK]] | options | WORD...",
        "Help of a task, of the options of all, or the tasks about a word.",
        "",
        "dynamics help flywheel",
        (),
        HERE + "print_help",
    ),
)


def print_schema(
    words: "Sequence[str]", options: "Mapping[str, str]", families: "Lines", find: "Finder", terminal: "Terminal"
) -> None:
    """The JSON Schema of a task."""
    from dynamics_cli.core.command.schema import schema
    from dynamics_cli.core.output.render import to_pretty_json

    terminal.write(to_pretty_json(schema(task_of(words, families, find))))


def print_reference(
    words: "Sequence[str]", options: "Mapping[str, str]", families: "Lines", find: "Finder", terminal: "Terminal"
) -> None:
    """The reference of all commands, or of some families."""
    from dynamics_cli.core.command.manual import WRITERS

    form = options.get("format") or REFERENCE_FORMS[0]
    if form not in REFERENCE_FORMS:
        raise UsageError(
            f"read {form!r}, wanted one of {', '.join(REFERENCE_FORMS)}", parameter="format", code="unknown-choice"
        )
    for word in words:
        if word not in families:
            raise _unknown(word, None, families, find)
    terminal.write(WRITERS[form]([find(word) for word in words or families]))


def print_help(
    words: "Sequence[str]", options: "Mapping[str, str]", families: "Lines", find: "Finder", terminal: "Terminal"
) -> None:
    """The options that every task has, or the tasks and options about some words."""
    if list(words) == ["options"]:
        from dynamics_cli.core.command.help import common_options

        terminal.write(common_options(min(terminal.columns or 80, 80)))
    else:
        from dynamics_cli.core.command.search import print_found

        print_found(words, families, find, terminal)


def task_of(words: "Sequence[str]", families: "Collection[str]", find: "Finder") -> Task:
    """The task that the words of a family and a task name, and nothing else."""
    if not words:
        hint = "for example: dynamics schema skid speed"
        raise UsageError("a family and its task are missing", code="missing", hint=hint)
    if words[0] not in families:
        raise _unknown(words[0], None, families, find)
    family = find(words[0])
    task = family.alone or family.tasks.get(words[1] if len(words) > 1 else "")
    if len(words) > (1 if family.alone else 2):
        raise UsageError(f"unexpected word {words[-1]!r}", code="unexpected")
    if task is None and len(words) == 1:
        hint = f"there is {', '.join(family.tasks)}"
        raise UsageError(f"the task of {words[0]} is missing", code="missing", hint=hint)
    if task is None:
        raise _unknown(words[1], family, families, find)
    return task


def _unknown(word: str, family: "Family | None", families: "Collection[str]", find: "Finder") -> UsageError:
    from dynamics_cli.core.command.search import unknown_command

    return unknown_command(word, family, family.tasks if family else families, families, find)


def completions(command: Command, words: "Sequence[str]", families: "Lines", find: "Finder") -> "list[str]":
    """The words that can follow."""
    if command.names:
        return list(load(command.names)())
    if not command.metavar.strip("[").startswith("FAMILY"):
        return []
    if not words or command.metavar.endswith("..."):
        return list(families)
    if len(words) == 1 and words[0] in families:
        return [task for task in find(words[0]).tasks if task]
    return []
