"""A task's help: two examples first, its parameters, its results, and where the options of every task are listed."""

from dynamics_cli.core.answering.task import EXAMPLES_FOLDER
from dynamics_cli.core.command.help import (
    describe_options,
    describe_record,
    placeholder,
    result_fields,
    word_name,
    written_default,
)
from dynamics_cli.core.command.template import MOST_ALTERNATIVES
from dynamics_cli.core.inputs.options import group_name, kebab, options
from dynamics_cli.core.inputs.specification import Field, Leaf, Many, OneOf, Record, Tagged, description, members_of
from dynamics_cli.core.output.answer_words import short_source
from dynamics_cli.core.output.wrapping import wrapped

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from dynamics_cli.core.answering.task import Task
    from dynamics_cli.core.inputs.options import Option

EXAMPLES = 2
COLUMN = 28
MOST_LINES = 60
# How many results and tables are listed where the help has no space for all.
MOST_RESULT_LINES = 4
MORE = "Common options (output, units, uncertainty, batches): dynamics help options"


def task_help(task: "Task", width: int, word: str = "") -> str:
    """Help for one task, no line wider than `width`, as detailed as the number of its parameters allows.

    `word` may name one of a positional parameter's alternatives, whose parameters are then shown.
    """
    chosen = next((node.member(word) for node in _tagged(task)), None)
    words = f" {word}" if chosen else "".join(f" {word_name(field)}" for field in task.specification.words)
    required, optional = _parameters(task, width, chosen)
    full = [line for row in optional for line in _row(row[1], row[2], width)]
    lines = _assembled(task, width, words, required, full, brief=False)
    if len(lines) > MOST_LINES:
        lines_left = MOST_LINES - len(_assembled(task, width, words, required, [], brief=True))
        lines = _assembled(task, width, words, required, _fitting(optional, lines_left, width), brief=True)
    return "\n".join(lines) + "\n"


def _tagged(task: "Task") -> "list[Tagged]":
    return [field.node for field in task.specification.words if isinstance(field.node, Tagged)]


def _assembled(
    task: "Task", width: int, words: str, required: "list[str]", optional: "list[str]", *, brief: bool
) -> "list[str]":
    lines = [f"Usage: dynamics {task.path}{words}{' [OPTIONS]' if task.options else ''}", ""]
    lines += [f"  {line}" for line in wrapped(task.summary, width - 2, 0)]
    if task.examples:
        fitting = sorted(task.shown_examples, key=lambda example: f"{task.path}{words}" not in example)
        examples = fitting[:EXAMPLES]
        lines += ["", "Examples:", *(line for example in examples for line in example_lines(example, width))]
        lines += [f"  the file: dynamics examples {name} --copy" for name in _files(task)]
    if task.notes:
        lines += ["", *wrapped(task.notes, width, 2)]
    if required:
        lines += ["", "Required:", *required]
    if optional:
        lines += ["", "Optional:" if required else "Parameters:", *optional]
    lines += _results(task, width, brief=brief)
    sources = dict.fromkeys(part for model in task.models for part in short_source(model.source).split("; "))
    more = [f"All parameters and results described: dynamics reference {task.family}"] if brief else []
    last = [f"Source: {'; '.join(sources)}", *more, MORE]
    return [*lines, "", *(line for text in last for line in wrapped(text, width, 2))]


def _files(task: "Task") -> "list[str]":
    """The files of worked examples that the shown examples read."""
    words = " ".join(task.examples[:EXAMPLES]).split()
    return list(dict.fromkeys(word.removeprefix(EXAMPLES_FOLDER) for word in words if word.startswith(EXAMPLES_FOLDER)))


def _fitting(optional: "list[tuple[str, str, str, str]]", room: int, width: int) -> "list[str]":
    """A line for each of the first options, and the names of those that no longer fit."""
    for number in range(len(optional), -1, -1):
        lines = [_on_one_line(f"  {row[0]:<{COLUMN - 4}}  ", *row[2:], width) for row in optional[:number]]
        names = " ".join(row[0] for row in optional[number:])
        lines += [f"  {line}" for line in wrapped(f"also {names}" if lines else names, width - 2, 0)] if names else []
        if len(lines) <= room - 2:
            break
    spare = room - 2 - len(lines)
    full_rows: list[str] = []
    for place, line in enumerate(lines):
        row = _row(optional[place][0], optional[place][2], width) if place < number else [line]
        fits = len(row) - 1 <= spare
        spare -= len(row) - 1 if fits else 0
        full_rows += row if fits else [line]
    return full_rows


def example_lines(command: str, width: int) -> "Iterator[str]":
    """A long command in several lines, broken before options with shell continuations so that it can be copied."""
    line = "  "
    for nth, part in enumerate(command.split(" --")):
        word = f" --{part}" if nth else part
        if nth and len(line) + len(word) > width - 2:
            yield f"{line} \\"
            line = f"    {word.strip()}"
        else:
            line += word
    yield line


def _parameters(
    task: "Task", width: int, chosen: "Record | None"
) -> "tuple[list[str], list[tuple[str, str, str, str]]]":
    """Lines for required parameters, and for every other option its short name, head, text and brief text."""
    texts = {**describe_options(task), **(describe_record(chosen) if chosen else {})}
    rows: dict[bool, dict[tuple[str, str], list[str]]] = {True: {}, False: {}}
    extra = options(chosen.fields) if chosen else {}
    sizes = {name for node in _tagged(task) for member in node.members.values() for name in options(member.fields)}
    choices_of: dict[str, str] = {}
    for name, option in (extra | {name: item for name, item in task.options.items() if name not in sizes}).items():
        text = option_text(option, texts) if option.leaf is not None else _group_text(task, option)
        if option.leaf is not None and option.leaf.choice is not None:
            choices_of[text] = ", ".join(option.leaf.choice.names)
        value = "" if option.flag else placeholder(option)
        rows[option.required].setdefault((text, value), []).append(f"--{name}")
    choices = [
        f"either {', or '.join(item)}"
        for item in _choices((*(chosen.fields if chosen else ()), *task.specification.fields), ())
    ]
    plain = [] if chosen else list(_words(task, scene=False))
    required = [line for head, text in plain if not head.startswith("[") for line in _row(head, text, width)]
    for node in [] if chosen else _tagged(task):
        required += [f"    {line}" for line in wrapped(", ".join(node.members), width - 4, 0)]
    required += [f"  {line}" for item in choices for line in wrapped(item, width - 2, 2)]
    for (text, value), names in rows[True].items():
        required += _row(f"{', '.join(names)} {value}".rstrip(), text, width)
    loose = [(head, text) for head, text in plain if head.startswith("[")]
    optional = [(head, head, text, text) for head, text in (*loose, *_words(task, scene=True))]
    optional += [
        (_joined(names), f"{', '.join(names)} {value}".rstrip(), text, choices_of.get(text, text))
        for (text, value), names in rows[False].items()
    ]
    return required, optional


def _words(task: "Task", *, scene: bool) -> "Iterator[tuple[str, str]]":
    """Positional parameters with their texts: those that are read from a scene, or the others."""
    for field in task.specification.words:
        text = description(field.text)
        if isinstance(field.node, Tagged):
            text += f"; what one takes: dynamics {task.path} {next(iter(field.node.members))} --help; one of:"
        if scene and isinstance(field.node, Record):
            yield word_name(field), f"{text}; a TOML or JSON file: --template writes one"
        elif not scene and not isinstance(field.node, Record) and text:
            yield word_name(field), text


def _joined(names: "list[str]") -> str:
    """`--first-mass` and `--second-mass` as `--first|second-mass`."""
    if len(names) == 1:
        return names[0]
    first, *_ = names
    tail = first
    while not all(name.endswith(tail) for name in names):
        tail = tail[1:]
    tail = tail[tail.find("-") :] if "-" in tail else ""
    return "--" + "|".join(name.removesuffix(tail).removeprefix("--") for name in names) + tail


def _on_one_line(head: str, text: str, brief: str, width: int) -> str:
    """An option and its text; one that is too long loses its example, gives way to `brief`, ends at a comma or word."""
    for line in (head + text, head + text.partition(", e.g. ")[0], head + brief):
        if len(line) <= width:
            return line
    line = line[: width - 1]
    end = max(line.rfind(mark, (len(head) + width) // 2) for mark in ("; ", ", ", " ("))
    return line[: end if end > 0 else line.rfind(" ")] + " …"


def option_text(option: "Option", texts: "Mapping[tuple[str, ...], str]") -> str:
    """Help text of an option: its description without the SI unit, its choices, its default, an example."""
    leaf = option.leaf
    assert leaf is not None
    text = description(texts.get(option.path) or leaf.kind.about)
    if leaf.choice is not None and not all(name in text for name in leaf.choice.names):
        text = f"{text}: {', '.join(leaf.choice.names)}"
    default = written_default(option)
    if default:
        text += f" (default {default})"
    elif leaf.kind.example and leaf.choice is None and leaf.kind.form != "text" and "e.g. " not in text:
        text += f", e.g. {leaf.kind.example}"
    return text


def _row(head: str, text: str, width: int) -> "list[str]":
    body = wrapped(text, width - COLUMN, 0)
    heads = [f"  {line}" for line in wrapped(head, width - 2, 4)]
    if len(heads) == 1 and len(heads[0]) < COLUMN - 1:
        return [f"{heads[0]:<{COLUMN}}{body[0]}", *(" " * COLUMN + line for line in body[1:])]
    return [*heads, *(" " * COLUMN + line for line in body)]


def _choices(fields: "tuple[Field, ...]", prefix: "tuple[str, ...]") -> "Iterator[list[str]]":
    """Alternatives of which one must be given, each written as its required options."""
    for field in fields:
        node = field.node
        if isinstance(node, OneOf) and field.required:
            yield [
                " with ".join(_option(inner, prefix) for inner in member.fields if inner.name in member.required)
                for member in node.members
            ]
        elif isinstance(node, Record) and field.required and not field.place:
            yield from _choices(node.fields, (*prefix, field.key))
        elif isinstance(node, Many) and node.single and not node.columns and field.required and _takes_records(node):
            single = [
                " with ".join(
                    f"--{kebab('_'.join((*prefix, inner.spread()[0])))}" for inner in record.fields if inner.required
                )
                for record in members_of(node.item)
            ]
            if all(single):
                yield [_option(field, prefix), *single]


def _option(field: Field, prefix: "tuple[str, ...]") -> str:
    """The option of a field; of a list of records the one that gives a record."""
    path = (*prefix, field.key)
    node = field.node
    if isinstance(node, Many) and not node.columns and _takes_records(node):
        return f"--{group_name(node, path)}"
    return f"--{kebab('_'.join(path))}"


def _takes_records(node: Many) -> bool:
    return not isinstance(node.item, Leaf)


def _group_text(task: "Task", option: "Option") -> str:
    """A repeated group, with the fields that it takes."""
    names = [name for record in group_records(task.specification.fields, option.path) for name in group_keys(record)]
    return f"repeatable; takes {', '.join(dict.fromkeys(names))}"


def group_keys(record: Record) -> "Iterator[str]":
    """The names of a record's fields; of many alternatives only the name that chooses."""
    for field in record.fields:
        if isinstance(field.node, Tagged) and len(field.node.members) > MOST_ALTERNATIVES:
            yield f"{field.node.key} and its sizes"
        else:
            yield from map(kebab, field.spread())


def group_records(fields: "tuple[Field, ...]", path: "tuple[str, ...]") -> "list[Record]":
    """The records that stand at a path of keys."""
    node: Any = None
    for key in path:
        field = next((field for field in flat_fields(fields) if field.key == key), None)
        if field is None:
            return []
        node = field.node
        fields = getattr(node, "fields", ())
    return _records(node)


def flat_fields(fields: "tuple[Field, ...]") -> "Iterator[Field]":
    """Every field that may be given on this level, including those of alternatives and of a scene."""
    for field in fields:
        yield field
        if isinstance(field.node, OneOf | Tagged) or (isinstance(field.node, Record) and field.place):
            for record in _records(field.node):
                yield from flat_fields(record.fields)


def _records(node: "Any") -> "list[Record]":
    item = node.item if isinstance(node, Many) else node
    members = getattr(item, "members", None)
    if members is None:
        return [item] if isinstance(item, Record) else []
    return list(members.values()) if isinstance(members, dict) else list(members)


def _results(task: "Task", width: int, *, brief: bool) -> "list[str]":
    """The names of results, for --to, --only and --limit, and of tables, for --table."""
    names, tables = [], []
    for name, field in result_fields(task.specification.result):
        item = getattr(field.node, "item", field.node)
        if isinstance(item, Leaf):
            names.append(name)
        elif isinstance(item, Record):
            tables.append(name if brief else f"{name} ({', '.join(member.key for member in item.fields)})")
    lines = []
    if names:
        lines += ["", "Results (names for --to, --only, --limit):"]
        listed = [f"  {line}" for line in wrapped(", ".join(names), width - 2, 0)]
        most = MOST_RESULT_LINES if brief else len(listed)
        lines += [*listed[:most], *(["  …"] if len(listed) > most else [])]
    if tables and brief:
        lines += ["", *wrapped(f"Tables (names for --table): {', '.join(tables)}", width, 2)]
    elif tables:
        lines += ["", "Tables (names for --table):"]
        lines += [f"  {line}" for table in tables for line in wrapped(table, width - 2, 2)]
    return lines
