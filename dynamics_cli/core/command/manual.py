"""The command reference as Markdown or as a manual page, generated from the data of the help."""

from dynamics_cli.core.answering.explain import filled
from dynamics_cli.core.command.help import describe_options, option_help, placeholder, result_fields
from dynamics_cli.core.inputs.settings import UNIVERSAL_OPTIONS
from dynamics_cli.core.inputs.specification import Leaf, Record
from dynamics_cli.errors import ExitStatus
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from dynamics_cli.core.answering.task import Family, Task

    Row = tuple[str, str]

_STATUS = (
    (ExitStatus.DONE, "done"),
    (ExitStatus.FAULT, "an internal error (a bug: please report it)"),
    (ExitStatus.USAGE, "the call is wrong"),
    (ExitStatus.INADMISSIBLE, "well-formed but physically inadmissible, or not finished within --time-limit"),
    (ExitStatus.SOME_FAILED, "some or all rows of a stream, or points of a sweep, failed"),
    (ExitStatus.OUTPUT, "the output could not be written"),
    (ExitStatus.INTERRUPTED, "interrupted"),
)
ABOUT = "Engineering calculations with units, sources and error bounds."


def parameters(task: "Task") -> "list[Row]":
    """Every word and option of a task, with its description."""
    texts = describe_options(task)
    rows = [
        (field.key.upper() + ("…" if field.place == "words" else ""), texts.get((field.key,), ""))
        for field in task.specification.words
        if isinstance(getattr(field.node, "item", field.node), Leaf)
    ]
    for name, option in task.options.items():
        value = "" if option.flag else f" {placeholder(option)}"
        rows.append((f"--{name}{value}", option_help(option, texts)))
    return rows


def results(task: "Task") -> "list[Row]":
    """Every result of a task by its address, with its description."""
    return list(_results(task.specification.result, ""))


def _results(record: Record, start: str) -> "Iterator[Row]":
    for address, field in result_fields(record, start):
        item = getattr(field.node, "item", field.node)
        if isinstance(item, Record):
            yield from _results(item, f"{address}[].")
        elif isinstance(item, Leaf):
            yield address, (field.text or item.kind.about).rstrip(".")


def sources(task: "Task") -> "Iterator[tuple[str, list[Row]]]":
    """Every model of a task: its name, and formula, assumptions, method and source."""
    for model in task.models:
        rows = [("Formula", formula) for formula in dict.fromkeys(filled(one, {}) for one in model.formulas) if formula]
        rows += [("Assumption", text) for text in model.assumptions]
        yield model.name, [*rows, ("Method", model.method), ("Source", model.source)]


def markdown(families: "Iterable[Family]") -> str:
    """The reference as Markdown."""
    lines = [f"# dynamics {__version__}: command reference", "", ABOUT, ""]
    for family in families:
        lines += [f"## dynamics {family.name}", "", family.summary, ""]
        for task in family.tasks.values():
            lines += _markdown_task(task)
    lines += ["## Options of every task", "", *_table("option", _universal()), ""]
    return "\n".join([*lines, "## Exit status", "", *_table("status", _statuses()), ""])


def _markdown_task(task: "Task") -> "list[str]":
    lines = [f"### dynamics {task.path}", "", task.summary, ""]
    if task.examples:
        lines += ["```sh", *task.shown_examples, "```", ""]
    lines += [*_table("parameter", parameters(task)), "", *_table("result", results(task)), ""]
    for name, rows in sources(task):
        lines += [f"Model: {name}", "", *(f"- {head}: {_cell(text)}" for head, text in rows), ""]
    return lines


def _table(head: str, rows: "list[Row]") -> "list[str]":
    return [f"| {head} | |", "|---|---|", *(f"| `{name}` | {_cell(text)} |" for name, text in rows)]


def _cell(text: str) -> str:
    for mark in ("\\", "|", "*", "_", "<"):
        text = text.replace(mark, f"\\{mark}")
    return text


def man(families: "Iterable[Family]") -> str:
    """The reference as a manual page, in the macros of man(7)."""
    lines = [f'.TH DYNAMICS 1 "" "dynamics {__version__}"', ".SH NAME", "dynamics \\- engineering calculations"]
    lines += [".SH SYNOPSIS", "\\fBdynamics\\fR FAMILY [TASK] [OPTIONS]", ".SH DESCRIPTION", _roff(ABOUT)]
    for family in families:
        lines += [f".SH {_roff(family.name.upper())}", _roff(family.summary)]
        for task in family.tasks.values():
            lines += _man_task(task)
    lines += [".SH OPTIONS OF EVERY TASK", *_tagged(_universal())]
    return "\n".join([*lines, ".SH EXIT STATUS", *_tagged(_statuses())]) + "\n"


def _man_task(task: "Task") -> "list[str]":
    lines = [f".SS dynamics {_roff(task.path)}", _roff(task.summary)]
    for example in task.shown_examples:
        lines += [".PP", ".nf", _roff(example), ".fi"]
    lines += _tagged(parameters(task))
    lines += [".PP", "Results:", *_tagged(results(task))]
    for name, rows in sources(task):
        lines += [".PP", f"Model: {_roff(name)}", *_tagged(rows)]
    return lines


def _tagged(rows: "list[Row]") -> "list[str]":
    return [line for name, text in rows for line in (".TP", f"\\fB{_roff(name)}\\fR", _roff(text) or "\\&")]


def _roff(text: str) -> str:
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("\n", " ")
    return f"\\&{text}" if text.startswith((".", "'")) else text


def _universal() -> "list[Row]":
    return [(f"--{name} {metavar}".rstrip(), text) for name, (_, metavar, text) in UNIVERSAL_OPTIONS.items()]


def _statuses() -> "list[Row]":
    return [(str(int(status)), text) for status, text in _STATUS]


WRITERS: "dict[str, Callable[[Iterable[Family]], str]]" = {"markdown": markdown, "man": man}
