"""The commands as typer sees them: help, suggestions, completion, and every call that is not plainly written.

The only module that imports typer. Commands are built for the chosen family only, from the same specification that the
direct route reads, and both end in the same `execute`.
"""

from typer import _click as click
from typer._completion_classes import completion_init
from typer._completion_shared import get_completion_script
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption
from typer.exceptions import Abort

from dynamics_cli import __version__
from dynamics_cli.core.about import COMMANDS, Command, completions
from dynamics_cli.core.call import FORMATS, METHODS, SYSTEMS, UNIVERSAL_OPTIONS, Call
from dynamics_cli.core.help import command_help, describe_options, option_help, placeholder
from dynamics_cli.core.specification import Leaf, Option, Record, Tagged
from dynamics_cli.core.task import Family, Task, load
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping
    from typing import Any

    from dynamics_cli.core.terminal import Terminal

    Finder = Callable[[str], Family]

# Forms of results that `--to` and `--limit` name.
NUMBERS = ("scalar", "slope", "measured")
SHELLS = ("bash", "zsh", "fish")


def run_tree(
    argv: "list[str]",
    families: "Mapping[str, tuple[str, str]]",
    find: "Finder",
    others: "tuple[Command, ...]",
    terminal: "Terminal",
) -> int:
    """Carry out a call through typer; typer's own complaints become UsageError. `others` are commands, no tasks."""
    completion_init()
    root = _root(families, find, others, terminal)
    try:
        with terminal.own_stdout():
            status = root.main(args=argv, prog_name="dynamics", standalone_mode=False)
    except Abort:
        raise KeyboardInterrupt from None
    except click.exceptions.NoSuchOption as error:
        hint = f"did you mean {' or '.join(error.possibilities)}?" if error.possibilities else _try_help(error)
        name = (error.option_name or "").lstrip("-")
        raise UsageError(
            f"there is no option {error.option_name}", code="unknown-option", parameter=name or None, hint=hint
        ) from None
    except click.exceptions.NoArgsIsHelpError as error:
        terminal.write(error.ctx.get_help() + "\n")
        return 0
    except click.exceptions.ClickException as error:
        message = error.format_message().rstrip(".")
        raise UsageError(message[:1].lower() + message[1:], hint=_try_help(error)) from None
    return status if isinstance(status, int) else 0


def _try_help(error: "Any") -> str | None:
    context = getattr(error, "ctx", None)
    return f"try: {context.command_path} --help" if context is not None else None


def _root(
    families: "Mapping[str, tuple[str, str]]", find: "Finder", others: "tuple[Command, ...]", terminal: "Terminal"
) -> TyperGroup:
    group = _Families(
        families,
        find,
        terminal,
        help="Engineering calculations with units, sources and error bounds.\n\n"
        'Example: dynamics skid speed --distance "60 ft" --friction 0.7',
        params=[_version_option(terminal), _completion_option(terminal)],
    )
    for command in (*COMMANDS, *others):
        group.commands[command.name] = _plain_command(command, find, families, terminal)
    return group


class _Families(TyperGroup):
    """The families by name; a family is imported when it is asked for, never for the list of names."""

    def __init__(
        self, families: "Mapping[str, tuple[str, str]]", find: "Finder", terminal: "Terminal", **rest: "Any"
    ) -> None:
        super().__init__(name="dynamics", rich_markup_mode=None, no_args_is_help=True, **rest)
        self._find = find
        self._terminal = terminal
        self._lines = {name: line for name, (_, line) in families.items()}
        for name, line in self._lines.items():
            self.commands[name] = TyperCommand(name, help=line, rich_markup_mode=None)

    def get_command(self, ctx: "Any", cmd_name: str) -> "Any":
        """The family's commands, built now unless only its line of help is wanted."""
        if cmd_name not in self._lines or (ctx.resilient_parsing and not ctx._protected_args and not ctx.args):
            return self.commands.get(cmd_name)
        if getattr(self, "_listing", False):
            return self.commands[cmd_name]
        return build_family(self._find(cmd_name), self._terminal)

    def format_commands(self, ctx: "Any", formatter: "Any") -> None:
        """List the families without importing them."""
        self._listing = True
        try:
            super().format_commands(ctx, formatter)
        finally:
            self._listing = False


def build_family(family: Family, terminal: "Terminal") -> "TyperCommand | TyperGroup":
    """The command of a lone task, or a group with a command for each task."""
    if family.alone is not None:
        return _TaskCommand(family.alone, terminal)
    group = TyperGroup(name=family.name, help=family.summary, rich_markup_mode=None, no_args_is_help=True)
    for name, task in family.tasks.items():
        group.commands[name] = _TaskCommand(task, terminal)
    return group


class _TaskCommand(TyperCommand):
    """One task; its options and long help are made when first needed, not to list it."""

    def __init__(self, task: Task, terminal: "Terminal") -> None:
        super().__init__(task.name or task.family, short_help=task.summary, rich_markup_mode=None)
        self.task = task
        self.terminal = terminal
        self._built = False

    def _build(self) -> None:
        if not self._built:
            self._built = True
            # Where words may be negative numbers, an unknown short option is a word: `convert -40 degC degF`.
            self.context_settings = {"ignore_unknown_options": bool(self.task.specification.words)}
            self.help = command_help(self.task)
            texts = describe_options(self.task)
            own = [_option(option, texts, self.task.names.get(name)) for name, option in self.task.options.items()]
            self.params = [*_arguments(self.task), *own, *_universal_options(self.task)]
            self.callback = self._carry_out

    def make_context(self, *args: "Any", **kwargs: "Any") -> "Any":
        """Build the options before typer parses with them."""
        self._build()
        return super().make_context(*args, **kwargs)

    def _carry_out(self, **given: "Any") -> int:
        from dynamics_cli.core.execute import execute

        return execute(self.task, _call(self.task, given), self.terminal)


def _call(task: Task, given: "dict[str, Any]") -> Call:
    call = Call()
    call.words = list(given.pop("words__", None) or ())
    for word in call.words:
        if word.startswith("-") and word[1:2] not in "0123456789." and word != "-":
            raise UsageError(f"there is no option {word}", code="unknown-option", hint=_near_option(task, word))
    for name in UNIVERSAL_OPTIONS:
        value = given.pop(_variable("setting", name), None)
        if value:
            call.settings[name] = _single(name, value, UNIVERSAL_OPTIONS[name][0])
    for name, option in task.options.items():
        value = given.pop(_variable("option", name), None)
        if value:
            how = "flag" if option.flag else "many" if option.repeats else "value"
            call.options[name] = _single(name, value, how)
    return call


def _variable(side: str, name: str) -> str:
    return f"{side}__{name.replace('-', '_')}"


def _single(name: str, value: "Any", how: str) -> "Any":
    if how == "flag":
        return True
    if how == "many":
        return list(value)
    if value[-1].startswith("--"):
        raise UsageError(f"--{name} has no value: it is followed by {value[-1]}", code="missing", parameter=name)
    if len(value) > 1:
        raise UsageError(f"--{name} is given {len(value)} times", code="repeated", parameter=name)
    return value[0]


def _near_option(task: Task, word: str) -> str:
    from dynamics_cli.core.words import nearest_words

    near = nearest_words(word.lstrip("-").partition("=")[0], [*task.options, *UNIVERSAL_OPTIONS])
    return (
        "did you mean " + " or ".join(f"--{name}" for name in near) + "?"
        if near
        else f"try: dynamics {task.path} --help"
    )


def _arguments(task: Task) -> "list[TyperArgument]":
    words = task.specification.words
    if not words:
        return []
    metavar = " ".join(_word_metavar(field) for field in words)

    def complete(context: "Any", parameter: "Any", incomplete: str) -> "list[str]":
        return _complete_words(task, incomplete)

    return [
        TyperArgument(
            param_decls=["words__"], nargs=-1, type=str, metavar=metavar, required=False, autocompletion=complete
        )
    ]


def _word_metavar(field: "Any") -> str:
    name = str(field.node.key if isinstance(field.node, Tagged) else field.key).upper()
    return f"{name}..." if field.place == "words" else name


def _complete_words(task: Task, incomplete: str) -> "list[str]":
    """Units, shapes and other names that a word may be."""
    for field in task.specification.words:
        node = field.node
        item = getattr(node, "item", node)
        if isinstance(node, Tagged):
            return [name for name in node.members if name.startswith(incomplete)]
        if isinstance(item, Leaf) and item.choice is not None:
            return [name for name in item.choice.names if name.startswith(incomplete)]
        if isinstance(item, Leaf) and item.kind.form == "unit":
            from dynamics_cli.core.units import all_units

            return sorted(name for name, *_ in all_units() if name.startswith(incomplete))
    return []


def _option(option: Option, texts: "Mapping[tuple[str, ...], str]", names: "str | None") -> TyperOption:
    decls = [_variable("option", option.name), f"--{option.name}"]
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
        autocompletion=_completer(names or (choice.names if choice else ())),
    )


def _universal_options(task: Task) -> "list[TyperOption]":
    made = []
    known = {
        "format": FORMATS,
        "units": SYSTEMS,
        "method": METHODS,
        "model": tuple(model.key for model in task.models),
        "jobs": ("all",),
        "sweep": tuple(f"{name}=" for name, option in task.options.items() if option.leaf and not option.flag),
    }
    for name, (how, metavar, text) in UNIVERSAL_OPTIONS.items():
        decls = [_variable("setting", name), f"--{name}"]
        if how == "flag":
            made.append(TyperOption(param_decls=decls, is_flag=True, default=False, help=text))
        else:
            complete = _result_completer(task) if name in ("to", "limit") else _completer(known.get(name, ()))
            made.append(
                TyperOption(
                    param_decls=decls, multiple=True, type=str, metavar=metavar, help=text, autocompletion=complete
                )
            )
    return made


def _results(record: Record, address: str = "") -> "Iterator[str]":
    """The addresses of the numbers outside tables."""
    for field in record.fields:
        if isinstance(field.node, Record):
            yield from _results(field.node, f"{address}{field.key}.")
        elif isinstance(field.node, Leaf) and field.node.choice is None and field.node.kind.form in NUMBERS:
            yield f"{address}{field.key}"


def _result_completer(task: Task) -> "Callable[[Any, Any, str], list[str]]":
    """The names of a task's results, looked up only when they are asked for."""

    def complete(context: "Any", parameter: "Any", incomplete: str) -> "list[str]":
        return [f"{name}=" for name in _results(task.specification.result) if name.startswith(incomplete)]

    return complete


def _completer(names: "tuple[str, ...] | str") -> "Callable[[Any, Any, str], list[str]]":
    """What completes one of these names; a text says where they are, as "module:names", for when they are wanted."""

    def complete(context: "Any", parameter: "Any", incomplete: str) -> "list[str]":
        return [name for name in (load(names) if isinstance(names, str) else names) if name.startswith(incomplete)]

    return complete


def _version_option(terminal: "Terminal") -> TyperOption:
    def show(context: "Any", parameter: "Any", value: bool) -> None:
        if value and not context.resilient_parsing:
            terminal.write(f"dynamics {__version__}\n")
            context.exit()

    return TyperOption(
        param_decls=["--version"],
        is_flag=True,
        is_eager=True,
        expose_value=False,
        callback=show,
        help="Show the version.",
    )


def _completion_option(terminal: "Terminal") -> TyperOption:
    def show(context: "Any", parameter: "Any", value: str | None) -> None:
        if value and not context.resilient_parsing:
            if value not in SHELLS:
                raise UsageError(f"read {value!r}, wanted one of {', '.join(SHELLS)}", parameter="show-completion")
            script = get_completion_script(prog_name="dynamics", complete_var="_DYNAMICS_COMPLETE", shell=value)
            terminal.write(script + "\n")
            context.exit()

    return TyperOption(
        param_decls=["--show-completion"],
        type=str,
        metavar="SHELL",
        is_eager=True,
        expose_value=False,
        callback=show,
        help="Print the completion script of bash, zsh or fish.",
    )


def _plain_command(
    command: Command, find: "Finder", families: "Mapping[str, tuple[str, str]]", terminal: "Terminal"
) -> TyperCommand:
    """A command that is no task."""

    def carry_out(words: "tuple[str, ...]", **given: "Any") -> int:
        options = {name: _single(name, value, "value") for name, value in given.items() if value}
        command.carry_out(words, options, families, find, terminal)
        return 0

    def complete(context: "Any", parameter: "Any", incomplete: str) -> "list[str]":
        before = context.params.get("words") or context.args
        return [word for word in completions(command, before, families, find) if word.startswith(incomplete)]

    words = TyperArgument(param_decls=["words"], nargs=-1, type=str, metavar=command.metavar, autocompletion=complete)
    options = [
        TyperOption(
            param_decls=[option.name, f"--{option.name}"],
            multiple=True,
            type=str,
            metavar=option.metavar,
            help=option.text,
            autocompletion=_completer(option.names),
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
