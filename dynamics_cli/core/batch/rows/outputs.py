"""Output rows: the input row, its results, and an error if there was one."""

from abc import ABC, abstractmethod

from dynamics_cli.core.batch.rows.inputs import Input
from dynamics_cli.core.output.csv_text import csv_cell, free_name, header
from dynamics_cli.core.output.failure import as_object
from dynamics_cli.core.output.row_layout import Layout, Part, compact
from dynamics_cli.errors import DynamicsError
from dynamics_cli.records import Measured

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    # For weaving: the same bytes in every row, or one piece for each row.
    Piece = bytes | Sequence[Any]


def error_line(error: DynamicsError) -> str:
    """An error in one line, every bad parameter in it."""
    texts = []
    for item in error.all():
        name = f"{item.parameter}: " if item.parameter and not item.message.startswith(item.parameter) else ""
        remedy = getattr(item, "left", "")
        texts.append(name + item.message + (f"; {remedy}" if remedy else ""))
    text = "; ".join(texts)
    return "".join(character if character.isprintable() else repr(character)[1:-1] for character in text)


def error_object(error: DynamicsError) -> "dict[str, Any]":
    """An error as the contract's object."""
    body = as_object(error)
    if len(error.all()) > 1:
        body["errors"] = [as_object(item) for item in error.all()]
    return body


class Slot:
    """A placeholder in a template for a number that differs from row to row."""

    def __repr__(self) -> str:
        return "\0"


class Output(ABC):
    """Interface of every format of output rows."""

    format = ""

    def __init__(self, source: Input, layout: Layout) -> None:
        self.source = source
        self.layout = layout

    def head(self) -> bytes:
        """The text before all rows."""
        return b""

    @abstractmethod
    def echo(self, line: bytes) -> bytes:
        """The input row."""

    @abstractmethod
    def good(self, line: bytes, values: "Sequence[Any]") -> bytes:
        """A row with its results."""

    @abstractmethod
    def bad(self, line: bytes, error: DynamicsError) -> bytes:
        """A row with its error."""

    @abstractmethod
    def pieces(self, echoes: "list[bytes]", results: "list[tuple[Part, str, Any]]") -> "list[Piece]":
        """Many rows with their results, for weaving.

        A result is (part, "each", column), (part, "measured", (columns, units)) or (part, "all", that of every row).
        """


class CsvOutput(Output):
    """The line, a column for each number, and the error in the last column."""

    format = "csv"

    def __init__(self, source: Input, layout: Layout) -> None:
        super().__init__(source, layout)
        used = {head.rpartition("[")[0] if head.endswith("]") else head for head in source.heads} | set(source.heads)
        self.columns = [header(free_name(name, used), unit) for part in layout.parts for name, unit in part.names]
        self.error_column = free_name("error", used)

    def head(self) -> bytes:
        """The header: the row's own columns, the results', and `error`."""
        own_heads = getattr(self.source, "line", None) or ",".join(map(csv_cell, self.source.heads)).encode()
        tail = ",".join((*self.columns, self.error_column)).encode()
        return (own_heads + b"," if self.source.heads else b"") + tail + b"\n"

    def echo(self, line: bytes) -> bytes:
        """The row's own cells."""
        return self.source.csv(line)

    def _row(self, line: bytes, cells: "list[str]", error: str) -> bytes:
        echoed = self.echo(line) + b"," if self.source.heads else b""
        return echoed + ",".join((*cells, csv_cell(error))).encode(errors="surrogateescape") + b"\n"

    def good(self, line: bytes, values: "Sequence[Any]") -> bytes:
        """A row with its results, its error empty."""
        parts = zip(self.layout.parts, values, strict=True)
        return self._row(line, [csv_cell(cell) for part, value in parts for cell in part.cells(value)], "")

    def bad(self, line: bytes, error: DynamicsError) -> bytes:
        """A row with empty results and its error."""
        return self._row(line, [""] * len(self.columns), error_line(error))

    def pieces(self, echoes: "list[bytes]", results: "list[tuple[Part, str, Any]]") -> "list[Piece]":
        """Cells between commas, the last one (the error's) empty."""
        pieces: list[Piece] = [echoes, b","] if self.source.heads else []
        for part, how, value in results:
            if how == "each":
                pieces.append(value)
            elif how == "measured":
                pieces += _measured_cells(part, *value)
            else:
                pieces.append(",".join(map(csv_cell, part.cells(value))).encode())
            pieces.append(b",")
        return [*pieces, b"\n"]


def _measured_cells(part: Part, columns: "list[list[bytes]]", units: "list[str]") -> "list[Piece]":
    pieces: list[Piece] = []
    between = b"," if part.how == "components" else b";"
    for column in columns:
        pieces += [between, column]
    if part.how == "components":
        pieces.append(b"," * (3 - len(columns)))
    return pieces[1:] if part.unit else [*pieces[1:], b"," + csv_cell(";".join(units)).encode()]


class JsonOutput(Output):
    """The object, with `results` or `error` as its last member."""

    format = "ndjson"

    def echo(self, line: bytes) -> bytes:
        """The object, its closing brace apart."""
        return self.source.json(line)

    def _member(self, line: bytes, name: str, value: "Any") -> bytes:
        echoed = self.echo(line)
        comma = b"" if echoed == b"{" else b","
        return echoed + comma + f'"{name}":{compact(value)}}}\n'.encode(errors="replace")

    def good(self, line: bytes, values: "Sequence[Any]") -> bytes:
        """An object with its results."""
        return self._member(line, "results", self.layout.entries(values))

    def bad(self, line: bytes, error: DynamicsError) -> bytes:
        """An object with its error."""
        return self._member(line, "error", error_object(error))

    def pieces(self, echoes: "list[bytes]", results: "list[tuple[Part, str, Any]]") -> "list[Piece]":
        """The results as a template with a place for each number."""
        slot = Slot()
        entries = self.layout.entries([_template(slot, *result) for result in results])
        texts = (',"results":' + compact(entries) + "}\n").encode().split(b"\0")
        pieces: list[Piece] = [echoes, texts[0]]
        each = [column for _, how, value in results for column in _columns(how, value)]
        for column, text in zip(each, texts[1:], strict=True):
            pieces += [column, text]
        return pieces


def _template(slot: Slot, part: Part, how: str, value: "Any") -> "Any":
    if part.how == "components" and how == "measured":
        return Measured(tuple([slot for _ in value[0]]), *value[1])  # type: ignore[misc]
    if how == "measured":
        places = tuple([Measured(slot, unit) for unit in value[1]])  # type: ignore[arg-type]
        return places if len(places) > 1 else places[0]
    return slot if how == "each" else value


def _columns(how: str, value: "Any") -> "list[list[bytes]]":
    if how == "measured":
        return value[0]  # type: ignore[no-any-return]
    return [value] if how == "each" else []


class TextOutput(Output):
    """The line and its numbers, separated by tabs; an error after an empty number."""

    format = "text"

    def echo(self, line: bytes) -> bytes:
        """The line itself."""
        return line

    def good(self, line: bytes, values: "Sequence[Any]") -> bytes:
        """A line and its numbers."""
        parts = zip(self.layout.parts, values, strict=True)
        numbers = [cell for part, value in parts for cell in part.numbers(value)]
        return line + "".join([f"\t{number}" for number in numbers]).encode() + b"\n"

    def bad(self, line: bytes, error: DynamicsError) -> bytes:
        """A line, no number, and its error."""
        return line + f"\t\terror: {error_line(error)}\n".encode(errors="replace")

    def pieces(self, echoes: "list[bytes]", results: "list[tuple[Part, str, Any]]") -> "list[Piece]":
        """Numbers between tabs."""
        pieces: list[Piece] = [echoes]
        for part, how, value in results:
            if part.how not in ("flag", "word"):
                for column in _columns(how, value):
                    pieces += [b"\t", column]
            if how == "all":
                pieces += [f"\t{number}".encode() for number in part.numbers(value)]
        return [*pieces, b"\n"]


OUTPUTS: "dict[str, type[Output]]" = {"csv": CsvOutput, "ndjson": JsonOutput, "text": TextOutput}
