"""`dynamics examples`: lists the worked examples, shows one, copies one."""

import os
from pathlib import Path

from dynamics_cli.core.output.files import Files
from dynamics_cli.core.output.wrapping import wrapped
from dynamics_cli.core.units.near_names import nearest_words
from dynamics_cli.errors import OutputError, UsageError
from dynamics_cli.examples_command.worked import WORKED, Example

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from dynamics_cli.core.answering.task import Family
    from dynamics_cli.core.terminal import Terminal


def names() -> "list[str]":
    """The names, for completion."""
    return [example.name for example in WORKED]


def carry_out(
    words: "Sequence[str]",
    options: "Mapping[str, str]",
    families: "Mapping[str, tuple[str, str]]",
    find: "Callable[[str], Family]",
    terminal: "Terminal",
) -> None:
    """List the examples, show one, or copy one."""
    if len(words) > 1:
        raise UsageError(f"unexpected word {words[1]!r}", code="unexpected", hint="name one example")
    if not words:
        if options.get("copy"):
            raise UsageError("the name of the example is missing", code="missing", hint="see: dynamics examples")
        terminal.write(_by_trade(families, min(terminal.columns or 80, 80)))
        return
    of_family = [example for example in WORKED if words[0] in families and _uses(example, words[0])]
    if of_family and not options.get("copy") and words[0] not in names():
        lines = _listed(of_family, min(terminal.columns or 80, 80), max(len(name) for name in names()) + 2)
        terminal.write("\n".join([*lines, "", _offer(of_family[0]), ""]))
        return
    example = _named(words[0])
    if options.get("copy"):
        _copy(example, terminal)
    else:
        files = wrapped(", ".join(example.files), 72, 0)
        lines = [*wrapped(example.line, 80, 0), "", f"files  {files[0]}", *(f"       {line}" for line in files[1:])]
        terminal.write("\n".join([*lines, f"copy   dynamics examples {example.name} --copy", _run(example), ""]))


def _run(example: Example) -> str:
    return f"run    {example.run}"


def _calls(example: Example) -> str:
    """The command that runs an example, and those of its scripts."""
    scripts = [folder() / name for name in example.files if name.endswith(".sh")]
    return "\n".join([example.run, *(script.read_text(encoding="utf-8") for script in scripts)])


def _uses(example: Example, family: str) -> bool:
    """Whether an example calls a task of a family."""
    return f"dynamics {family} " in _calls(example)


def _by_trade(families: "Mapping[str, tuple[str, str]]", width: int) -> str:
    """All examples under the headings of `dynamics --help`, each where the family stands that it calls most."""
    trades: dict[str, list[Example]] = {trade: [] for trade, _ in families.values()}
    for example in WORKED:
        calls = _calls(example)
        words = ((f"dynamics {name} ", trade) for name, (trade, _) in families.items())
        most, _, trade = max((calls.count(word), calls.rfind(word), trade) for word, trade in words)
        trades[trade if most else list(trades)[-1]].append(example)
    column = max(len(name) for name in names()) + 4
    lines = []
    for trade, examples in trades.items():
        lines += [f"{trade}:", *(f"  {line}" for line in _listed(examples, width - 2, column - 2))] if examples else []
    return "\n".join([*lines, "", _offer(WORKED[0]), "Of one family: dynamics examples impact", ""])


def _listed(examples: "Sequence[Example]", width: int, column: int) -> "list[str]":
    lines = []
    for example in examples:
        first, *others = wrapped(example.line, width - column, 0)
        lines += [f"{example.name:<{column}}{first}", *(" " * column + line for line in others)]
    return lines


def _offer(example: Example) -> str:
    return f"One of them: dynamics examples {example.name}; copy it: dynamics examples {example.name} --copy"


def _named(word: str) -> Example:
    wanted = os.path.basename(word)
    for example in WORKED:
        if word == example.name:
            return example
    # By the name of a file, the smallest example that holds it.
    holders = [example for example in WORKED if wanted in map(os.path.basename, example.files)]
    if holders:
        return min(holders, key=lambda example: len(example.files))
    near = nearest_words(word, names())
    hint = f"did you mean {' or '.join(near)}?" if near else "see: dynamics examples"
    raise UsageError(f"there is no example {word!r}", code="unknown-example", hint=hint)


def how_to_copy(argv: "Sequence[str]") -> str | None:
    """Where a call names a file that is not there and is one of an example: how to have it."""
    shipped = {name for example in WORKED for name in example.files}
    missing = [word for word in argv if word in shipped and not os.path.lexists(word)]
    return f"it is a worked example: dynamics examples {missing[0]} --copy" if missing else None


def folder() -> Path:
    """Where the examples are: in the package, or beside it in a checkout."""
    package = Path(__file__).resolve().parents[1]
    return next((path for path in (package / "examples", package.parent / "examples") if path.is_dir()), package)


def _copy(example: Example, terminal: "Terminal") -> None:
    """Write the files of an example, all or none."""
    try:
        contents = [(name, (folder() / name).read_bytes(), "copy") for name in example.files]
        there = [name for name, data, _ in contents if os.path.lexists(name) and Path(name).read_bytes() != data]
        if there:
            hint = "move it away, or copy the example in another folder"
            raise OutputError(f"{', '.join(there)} exists: nothing is written", code="exists", hint=hint)
        for name in example.files:
            os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
    except OSError as error:
        raise OutputError(f"cannot copy {example.name}: {error.strerror or error}") from None
    with Files(contents):
        pass
    terminal.write("".join(f"{name}\n" for name in example.files))
    terminal.tell(f"{_run(example)}\n")
