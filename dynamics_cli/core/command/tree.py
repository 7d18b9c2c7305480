"""The commands as typer sees them: help, suggestions, completion, and every call that is not plainly written.

The only module that imports typer. Commands are built for the chosen family only, from the same specification that the
direct route reads, and both end in the same `execute`.
"""

import os
import sys

from typer import Exit, TyperException
from typer.completion import completion_init, get_completion_script, shell_complete  # type: ignore[attr-defined]
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption

from dynamics_cli.core.answering.task import Family, Task
from dynamics_cli.core.command.arguments import call_of, single, variable
from dynamics_cli.core.command.completion import POWERSHELL, completer_of, result_completer, words_that_fit
from dynamics_cli.core.command.help import describe_options, option_help, placeholder, word_name
from dynamics_cli.core.command.plain_commands import COMMANDS, Command, completions
from dynamics_cli.core.command.search import unknown_command
from dynamics_cli.core.command.template import takes_scene
from dynamics_cli.core.command.unknown import extra_words, unknown_option, without_value
from dynamics_cli.core.inputs.options import Option
from dynamics_cli.core.inputs.settings import FORMATS, METHODS, SYSTEMS, UNIVERSAL_OPTIONS
from dynamics_cli.errors import UsageError
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    from dynamics_cli.core.terminal import Terminal

    Finder = Callable[[str], Family]

SHELLS = ("bash", "zsh", "fish", "powershell")
# Commands that share a line of the list: about the program, and seldom called.
SELDOM_CALLED = ("help", "accuracy", "reference", "schema")
# Environment variable in which a shell asks for completion.
COMPLETE = "_DYNAMICS_COMPLETE"


def run_tree(
    argv: "list[str]",
    families: "Mapping[str, tuple[str, str]]",
    find: "Finder",
    further: "tuple[Command, ...]",
    terminal: "Terminal",
) -> int:
    """Execute a call through typer; its errors become UsageError. `further` are commands that are not tasks."""
    completion_init()
    root = _root(families, find, further, terminal)
    try:
        with terminal.own_stdout():
            # As `main`, which however turns a closed pipe into a failure (status 1).
            if shell := os.environ.get(COMPLETE):
                sys.exit(shell_complete(root, {}, "dynamics", COMPLETE, shell))
            with root.make_context("dynamics", list(argv)) as context:
                status = root.invoke(context)
    except Exit as error:
        return error.exit_code
    except TyperException as error:
        raise _refusal(error, argv) from None
    return status if isinstance(status, int) else 0


def _refusal(error: "Any", argv: "list[str]") -> UsageError:
    """Typer's error as ours; only the one for an unknown option has `possibilities`."""
    task = getattr(getattr(getattr(error, "ctx", None), "command", None), "task", None)
    if not hasattr(error, "possibilities"):
        message = error.format_message().rstrip(".")
        if task is not None and message.startswith("Got unexpected extra"):
            return extra_words(task, message, argv)
        return UsageError(message[:1].lower() + message[1:], hint=_try_help(error))
    if task is not None:
        # of -distance typer names -d
        single = (word for word in argv if word.startswith(error.option_name) and word[:2] != "--")
        return unknown_option(task, next(single, error.option_name).partition("=")[0], argv)
    hint = f"did you mean {' or '.join(error.possibilities)}?" if error.possibilities else _try_help(error)
    name = error.option_name.lstrip("-") or None
    return UsageError(f"there is no option {error.option_name}", code="unknown-option", parameter=name, hint=hint)


def _try_help(error: "Any") -> str | None:
    context = getattr(error, "ctx", None)
    return f"try: {context.command_path} --help" if context is not None else None


def _root(
    families: "Mapping[str, tuple[str, str]]", find: "Finder", further: "tuple[Command, ...]", terminal: "Terminal"
) -> TyperGroup:
    group = _Families(
        families,
        find,
        terminal,
        help="\b\nEngineering calculations with units, sources and error bounds.\n"
        'Example: dynamics skid speed --distance "60 ft" --friction 0.7',
        params=[_version_option(terminal), _completion_option(terminal)],
    )
    for command in (*COMMANDS, *further):
        group.commands[command.name] = _plain_command(command, find, families, terminal)
    return group


class _Group(TyperGroup):
    """Commands by name; without one its help."""

    def __init__(
        self, families: "Mapping[str, tuple[str, str]]", find: "Finder", terminal: "Terminal", **rest: "Any"
    ) -> None:
        super().__init__(rich_markup_mode=None, **rest)
        self.families = families
        self.find = find
        self.terminal = terminal
        self.family: Family | None = None

    def parse_args(self, ctx: "Any", args: "list[str]") -> "list[str]":
        """Write the help if no arguments are given."""
        if not args and not ctx.resilient_parsing:
            self.terminal.write(ctx.get_help() + "\n")
            ctx.exit()
        return super().parse_args(ctx, args)

    def resolve_command(self, ctx: "Any", args: "list[str]") -> "Any":
        """The command of a name, or what an unknown one may mean."""
        if args[0] not in self.commands and not args[0].startswith("-"):
            raise unknown_command(args[0], self.family, self.commands, self.families, self.find)
        return super().resolve_command(ctx, args)


class _Families(_Group):
    """The families by name; a family is imported when it is called, never for the list of names."""

    def __init__(
        self, families: "Mapping[str, tuple[str, str]]", find: "Finder", terminal: "Terminal", **rest: "Any"
    ) -> None:
        super().__init__(families, find, terminal, name="dynamics", **rest)
        for name, (_, line) in families.items():
            self.commands[name] = TyperCommand(name, help=line, rich_markup_mode=None)

    def resolve_command(self, ctx: "Any", args: "list[str]") -> "Any":
        """The family's commands, built now; lists of families need only their lines of help."""
        if args[0] not in self.families:
            return super().resolve_command(ctx, args)
        family = self.find(args[0])
        if family.alone is not None:
            return args[0], _TaskCommand(family.alone, self.terminal), args[1:]
        group = _Group(self.families, self.find, self.terminal, name=family.name, help=family.summary)
        group.family = family
        for name, task in family.tasks.items():
            group.commands[name] = _TaskCommand(task, self.terminal)
            for other in task.also:
                group.commands[other] = _TaskCommand(task, self.terminal)
                group.commands[other].hidden = True
        return args[0], group, args[1:]

    def format_commands(self, ctx: "Any", formatter: "Any") -> None:
        """List the families by trade, without importing them; commands of no trade come last."""
        groups: dict[str, list[tuple[str, str]]] = {}
        for name, (group, line) in self.families.items():
            groups.setdefault(group, []).append((name, line))
        last = list(groups)[-1]
        others = [name for name in self.commands if name not in self.families]
        groups[last] += [(name, self.commands[name].get_short_help_str(limit=70)) for name in others]
        # those that few call share a line: the whole stays on a page
        groups[last] = [row for row in groups[last] if row[0] not in SELDOM_CALLED]
        for group, rows in groups.items():
            formatter.write(f"{group}:\n")
            with formatter.indentation():
                formatter.write_dl(rows)
        formatter.write(f"  and {', '.join(SELDOM_CALLED)}: each with --help\n")

    def format_options(self, ctx: "Any", formatter: "Any") -> None:
        """The families first, then the few options on one line: the help of a call without words fits a screen."""
        formatter.write_paragraph()
        self.format_commands(ctx, formatter)
        formatter.write(f"Options: --version, --help, --show-completion {'|'.join(SHELLS)}\n")


class _TaskCommand(TyperCommand):
    """One task; its options and long help are made when first needed, not to list it."""

    def __init__(self, task: Task, terminal: "Terminal") -> None:
        super().__init__(task.name or task.family, short_help=task.summary, rich_markup_mode=None)
        self.task = task
        self.terminal = terminal
        self.words: list[str] = []
        self._built = False

    def _build(self) -> None:
        if not self._built:
            self._built = True
            # Where words may be negative numbers, an unknown short option is a word: `convert -40 degC degF`.
            self.context_settings = {"ignore_unknown_options": bool(self.task.specification.words)}
            self.help = self.task.summary
            texts = describe_options(self.task)
            options = [_option(option, texts, self.task.names.get(name)) for name, option in self.task.options.items()]
            self.params = [*_arguments(self.task), *options, *_universal_options(self.task)]
            self.callback = self._carry_out

    def format_help(self, ctx: "Any", formatter: "Any") -> None:
        """Write the task's help: examples first, then parameters and results."""
        from dynamics_cli.core.command.task_help import task_help

        width = max(48, min(self.terminal.columns or 80, 80))
        formatter.write(task_help(self.task, width, next(iter(self.words), "")))

    def make_context(self, info_name: "str | None", args: "list[str]", parent: "Any" = None, **extra: "Any") -> "Any":
        """Build the options before typer parses with them."""
        self._build()
        self.words = list(args)
        try:
            return super().make_context(info_name, args, parent, **extra)
        except TyperException as error:
            if "requires an argument" in error.format_message():
                raise without_value(self.task, self.words[-1]) from None
            raise

    def _carry_out(self, **values: "Any") -> int:
        from dynamics_cli.core.command.execute import execute

        return execute(self.task, call_of(self.task, values), self.terminal)


def _arguments(task: Task) -> "list[TyperArgument]":
    words = task.specification.words
    if not words:
        return []
    metavar = " ".join(word_name(field) for field in words)

    def complete(context: "Any", parameter: "Any", incomplete: str) -> "list[str]":
        return words_that_fit(task, incomplete)

    return [
        TyperArgument(
            param_decls=["words__"], nargs=-1, type=str, metavar=metavar, required=False, autocompletion=complete
        )
    ]


def _option(option: Option, texts: "Mapping[tuple[str, ...], str]", names: "str | None") -> TyperOption:
    decls = [variable("option", option.name), f"--{option.name}"]
    text = option_help(option, texts)
    choice = option.leaf.choice if option.leaf is not None else None
    if option.flag:
        return TyperOption(param_decls=decls, is_flag=True, default=False, help=text)
    return TyperOption(
        param_decls=decls,
        multiple=True,
        type=str,
        metavar=placeholder(option),
        help=text,
        autocompletion=completer_of(names or (choice.names if choice else ())),
    )


def _universal_options(task: Task) -> "list[TyperOption]":
    parameters = []
    choices = {
        "format": FORMATS,
        "units": SYSTEMS,
        "method": METHODS,
        "model": tuple(model.key for model in task.models),
        "jobs": ("all",),
        "sweep": tuple(f"{name}=" for name, option in task.options.items() if option.leaf and not option.flag),
    }
    for name, (how, metavar, text) in UNIVERSAL_OPTIONS.items():
        if name == "template" and not takes_scene(task):
            continue
        decls = [variable("setting", name), f"--{name}"]
        if how == "flag":
            parameters.append(TyperOption(param_decls=decls, is_flag=True, default=False, help=text))
        else:
            complete = result_completer(task) if name in ("to", "limit") else completer_of(choices.get(name, ()))
            parameters.append(
                TyperOption(
                    param_decls=decls, multiple=True, type=str, metavar=metavar, help=text, autocompletion=complete
                )
            )
    return parameters


def _version_option(terminal: "Terminal") -> TyperOption:
    def show(context: "Any", parameter: "Any", value: bool) -> None:
        if value and not context.resilient_parsing:
            terminal.write(f"dynamics {__version__}\n")
            context.exit()

    return _eager("version", "Show the version.", show, is_flag=True)


def _completion_option(terminal: "Terminal") -> TyperOption:
    def show(context: "Any", parameter: "Any", value: str | None) -> None:
        if value and not context.resilient_parsing:
            if value not in SHELLS:
                raise UsageError(f"read {value!r}, wanted one of {', '.join(SHELLS)}", parameter="show-completion")
            arguments = {"prog_name": "dynamics", "complete_var": COMPLETE, "shell": value}
            terminal.write(POWERSHELL if value == "powershell" else get_completion_script(**arguments) + "\n")
            context.exit()

    text = "Print the completion script of bash, zsh, fish or powershell."
    return _eager("show-completion", text, show, type=str, metavar="SHELL")


def _eager(name: str, text: str, callback: "Callable[..., None]", **rest: "Any") -> TyperOption:
    """An option that acts in place of a command."""
    return TyperOption(
        param_decls=[f"--{name}"], is_eager=True, expose_value=False, callback=callback, help=text, **rest
    )


def _plain_command(
    command: Command, find: "Finder", families: "Mapping[str, tuple[str, str]]", terminal: "Terminal"
) -> TyperCommand:
    """A command that is not a task."""

    def carry_out(words: "tuple[str, ...]", **values: "Any") -> int:
        options = {
            name: "yes" if value is True else single(name, value, "value") for name, value in values.items() if value
        }
        command.carry_out(words, options, families, find, terminal)
        return 0

    def complete(context: "Any", parameter: "Any", incomplete: str) -> "list[str]":
        before = context.params.get("words") or context.args
        return [word for word in completions(command, before, families, find) if word.startswith(incomplete)]

    words = TyperArgument(param_decls=["words"], nargs=-1, type=str, metavar=command.metavar, autocompletion=complete)
    options = [
        TyperOption(
            param_decls=[option.name, f"--{option.name}"],
            multiple=bool(option.metavar),
            type=str if option.metavar else bool,
            is_flag=not option.metavar,
            metavar=option.metavar or None,
            help=option.text,
            autocompletion=completer_of(option.names),
        )
        for option in command.options
    ]
    return TyperCommand(
        command.name,
        help="\n\n".join(filter(None, (command.line, command.more, f"Example: {command.example}"))),
        short_help=command.line,
        params=[words, *options],
        callback=carry_out,
        rich_markup_mode=None,
    )
