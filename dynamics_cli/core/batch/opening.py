"""How a stream of rows begins: its separators, its header, and what its first rows settle for all."""

import itertools

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.heads import split_header, split_suffix, split_title
from dynamics_cli.core.batch.rows.inputs import CsvInput, Input, JsonInput, TextInput, decode_line, split_csv
from dynamics_cli.core.batch.text.records import first_record, records, with_commas
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from dynamics_cli.core.terminal import Terminal

# Number of rows searched for bare numbers and uncertain values.
LOOKED_AT = 50
# Marks of an uncertain value: ±, +/-, .., a distribution's bracket, a list, an object, an earlier result.
UNCERTAIN_MARKS = (b"\xc2\xb1", b"+/-", b"..", b"(", b"[", b"{", b"@", b"\\u")
ONE_A_LINE = 'one object a line, for example {"distance": "60 ft", "friction": 0.7}'


def without_blank_head(lines: "list[bytes | None]") -> "list[bytes | None]":
    """The lines from the first that is not blank on."""
    for start, line in enumerate(lines):
        if line is None or line.strip():
            return lines[start:]
    return []


def in_commas(
    case: Case, lines: "list[bytes | None]", blocks: "Iterator[list[bytes | None]]"
) -> "tuple[list[bytes | None], Iterator[list[bytes | None]]]":
    """The first rows and the following ones, with commas where the header has semicolons or tabs."""
    first = lines[0] or b""
    for separator in (b";", b"\t"):
        if separator in first and first.lstrip()[:1] != b"{" and not _is_header(case, first):
            changed = with_commas(itertools.chain([lines], blocks), separator)
            if _is_header(case, first.replace(separator, b",")):
                return next(changed), changed
    return lines, blocks


def opened(case: Case, lines: "list[bytes | None]", terminal: "Terminal") -> "tuple[Input, bytes, list[bytes | None]]":
    """The reader of the rows, the first line that it was chosen by, and the rows of the first block."""
    source: Input
    first = lines[0]
    if first is None:
        raise UsageError("the first row is longer than 16 MB", parameter="rows", code="too-long")
    start = first.lstrip()[:1]
    if start == b"[":
        hint = f"{ONE_A_LINE}, as from jq -c '.[]'"
        raise UsageError("rows begin with '[': a JSON list is not a stream", parameter="rows", code="json", hint=hint)
    if first.strip() == b"{":
        hint = f"{ONE_A_LINE}, as from jq -c ."
        raise UsageError("the first row is '{' alone", parameter="rows", code="json", hint=hint)
    if b"\r" in first and b'"' not in first:
        message = "the rows' lines end in bare carriage returns"
        hint = "save them with line feeds, or send them through: tr '\\r' '\\n'"
        raise UsageError(message, parameter="rows", code="line-ends", hint=hint)
    head, rest = first_record(lines)
    looked = lines
    if start == b"{":
        source = JsonInput(case, first)
    elif case.task.specification.words and not _is_header(case, head):
        source = TextInput(case)
    else:
        first, lines = head, rest
        source = _csv_input(case, first, terminal)
        looked = next(records([lines]), [])
    _settle_unit(case, source, looked[:LOOKED_AT])
    case.check()
    case.take_spread(_readable(source, looked[:LOOKED_AT], UNCERTAIN_MARKS))
    case.take_limits(_readable(source, looked[:LOOKED_AT]))
    return source, first, lines


def _settle_unit(case: Case, source: Input, lines: "list[bytes | None]") -> None:
    """Of several units, take the first as that of bare numbers if the rows hold such: `convert mph ft/s --rows -`."""
    for line in lines:
        try:
            if line is not None and case.is_bare(source.read(line)):
                case.take_default_unit()
                return
        except Exception:
            continue  # what is wrong with this row is reported in its place


def _readable(
    source: Input, lines: "list[bytes | None]", marks: "tuple[bytes, ...]" = (b"",)
) -> "Iterator[dict[str, Any]]":
    """The lines that hold one of these marks, read; errors of a line are reported in its place."""
    for line in lines:
        if line is not None and any(mark in line for mark in marks):
            try:
                yield source.read(line)
            except Exception:
                continue


def _is_header(case: Case, line: bytes) -> bool:
    """Whether some cell is the name of a parameter or of an earlier step's result; words are not names."""
    try:
        cells = split_csv(decode_line(line))
    except UsageError:
        return False
    names = [name for cell in cells for name in (split_header(cell)[0].removeprefix("results."), split_title(cell)[0])]
    return any(split_suffix(cell, case)[0] for cell in cells) or any(
        name.partition(".")[0].partition("[")[0].replace("-", "_") in case.names for name in names
    )


def _csv_input(case: Case, first: bytes, terminal: "Terminal") -> CsvInput:
    try:
        source = CsvInput(case, first)
    except UsageError as error:
        error.parameter = "rows"
        raise
    if not source.parameters:
        raise UsageError(
            f"no column of the header {decode_line(first)[:80]!r} is a parameter of {case.task.path}",
            parameter="rows",
            code="header",
            hint="cells are separated by commas, semicolons or tabs; a vector has a column for each component, "
            f"NAME[0], NAME[1] and so on; parameters are {', '.join(sorted(case.names))}",
        )
    warn_of_passing(case, [column.name for column in source.columns if not column.path], terminal)
    return source


def warn_of_passing(case: Case, names: "list[str]", terminal: "Terminal") -> None:
    """Warn of passed-through names that look like a parameter: a misspelt optional one would go unnoticed."""
    from dynamics_cli.core.units.near_names import nearest_words

    options = {name.replace("-", "_"): ".".join(option.path) for name, option in case.task.options.items()}
    for name in names[:20]:
        near = [] if name in ("error", "results", "id") else nearest_words(name, {*case.names, *options}, 1)
        if near:
            # an object has the parts of a body within it
            meant = options[name] if near == [name] else near[0]
            terminal.tell(
                f"dynamics: {name!r} is not a parameter of {case.task.path} and passes through (not {meant}?)\n"
            )
