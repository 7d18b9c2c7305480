"""Input rows: the parameters given by a line of CSV, of NDJSON or of words, and how the line is written out again.

A line that cannot be split as its header says is written out as one quoted cell, so that later columns stay aligned.
"""

from abc import ABC, abstractmethod
from itertools import pairwise

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.heads import Column
from dynamics_cli.core.documents import flatten
from dynamics_cli.core.inputs.sources.files import parse_json
from dynamics_cli.core.json_text import quote
from dynamics_cli.core.output.csv_text import csv_cell, header, without_guard
from dynamics_cli.core.output.row_layout import compact
from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    Raw = dict[str, Any]

ENVELOPE = ("schema", "command", "version", "inputs", "model", "numerics", "checks", "warnings", "files", "timing")
# Longest list in a row: an index of a billion must not fill the memory.
LONGEST_LIST = 1000


class CarriedError(UsageError):
    """The row failed in an earlier step of the pipe; its error is passed on."""

    def __init__(self, error: "Any") -> None:
        body = error if isinstance(error, dict) else {"message": str(error)}
        message = str(body.get("message") or "an earlier step failed")
        super().__init__(message, code=str(body.get("code") or "earlier"), hint=body.get("hint"))
        self.parameter = body.get("parameter")


def decode_line(line: bytes) -> str:
    """A line as text; refuses bytes that are not UTF-8."""
    try:
        return line.decode()
    except UnicodeDecodeError as error:
        raise UsageError(
            f"the row is not UTF-8 text: byte {error.start} is 0x{line[error.start]:02x}",
            code="encoding",
            hint="save it as UTF-8",
        ) from None


def split_csv(line: str) -> "list[str]":
    """The cells of one line."""
    if '"' not in line:
        return line.split(",")
    import csv

    try:
        return next(csv.reader([line], strict=True))
    except csv.Error as error:
        message = f"the row is not CSV: {error}"
        hint = 'close its quotes; a quote within a quoted cell is written ""'
        raise UsageError(message, code="csv", hint=hint) from None


def nest(raw: "Raw", path: "tuple[str | int, ...]", value: "Any") -> None:
    """Put a value at its path of keys and indices, extending lists as needed."""
    node: Any = raw
    for step, after in pairwise(path):
        empty: Any = [] if isinstance(after, int) else {}
        _extend(node, step, {}, path)
        if isinstance(step, int) and not node[step]:
            node[step] = empty
        node = node[step] if isinstance(step, int) else node.setdefault(step, empty)
    _extend(node, path[-1], "", path)
    node[path[-1]] = value


def _extend(node: "Any", step: "str | int", filler: "Any", path: "tuple[str | int, ...]") -> None:
    """Make a list long enough for an index; refuses an item of a list that is given as a whole."""
    if not isinstance(node, list if isinstance(step, int) else dict):
        raise UsageError(f"{path[0]} is given both whole and in parts", parameter=str(path[0]), code="exclusive")
    if isinstance(step, int):
        if step >= LONGEST_LIST:
            raise UsageError(f"{path[0]} has an index of {step}, at most {LONGEST_LIST - 1} is possible", code="index")
        assert isinstance(node, list)
        node.extend(filler if filler == "" else {} for _ in range(step + 1 - len(node)))


class Input(ABC):
    """Interface of every format of input rows."""

    format = ""
    # Columns of CSV that the row itself occupies.
    heads: "list[str]"

    def __init__(self, case: Case) -> None:
        self.case = case
        self.heads = []

    @abstractmethod
    def read(self, line: bytes) -> "Raw":
        """The parameters a line gives; raises UsageError."""

    @abstractmethod
    def csv(self, line: bytes) -> bytes:
        """The row's own cells."""

    @abstractmethod
    def json(self, line: bytes) -> bytes:
        """The row's object without its closing brace; a row that is not an object, as its text."""

    @staticmethod
    def unread(line: bytes) -> bytes:
        """A row that could not be read, as an object."""
        return b'{"row":' + quote(line.decode(errors="replace")).encode()

    def unread_cells(self, line: bytes) -> bytes:
        """A row that could not be read, as its first cell."""
        if not self.heads:
            return b""
        cell = csv_cell(line.decode(errors="surrogateescape").replace("\r", " "))
        return cell.encode(errors="surrogateescape") + b"," * (len(self.heads) - 1)


class CsvInput(Input):
    """Cells under a header."""

    format = "csv"

    def __init__(self, case: Case, first: bytes) -> None:
        super().__init__(case)
        self.heads = split_csv(decode_line(first))
        self.line = first
        self.columns = [Column(head, case) for head in self.heads]
        self.errors = [index for index, column in enumerate(self.columns) if column.is_error]
        for column, head in zip(self.columns, self.heads, strict=True):
            if not column.path:
                column.take_title(head, case, {column.path for column in self.columns})
        paths: set[tuple[str | int, ...]] = set()
        for column in self.columns:
            if column.path in paths and not column.name.startswith("results."):
                raise UsageError(f"the column {column.name!r} is there twice", code="csv", parameter="rows")
            if column.path:
                paths.add(column.path)
        # A result of an earlier step wins over the row's own parameter of that name, so it is put last.
        self._order = sorted(
            (index for index, column in enumerate(self.columns) if column.path),
            key=lambda index: self.columns[index].name.startswith("results."),
        )

    @property
    def parameters(self) -> "list[int]":
        """The columns that give parameters."""
        return self._order

    def read(self, line: bytes) -> "Raw":
        """The cells that are not empty, each where its header says."""
        cells = split_csv(decode_line(line))
        if len(cells) != len(self.columns):
            count = "1 cell" if len(cells) == 1 else f"{len(cells)} cells"
            raise UsageError(f"the row has {count}, wanted {len(self.columns)}", code="csv")
        for index in self.errors:
            if cells[index]:
                raise CarriedError(cells[index])
        raw: Raw = {}
        for index in self._order:
            if cells[index].strip():
                nest(raw, self.columns[index].path, self.columns[index].raw(cells[index]))
        return raw

    def csv(self, line: bytes) -> bytes:
        """The line itself, if its cells fit the header."""
        missing = len(self.heads) - 1 - line.count(b",")
        if b'"' not in line and missing >= 0:
            return line + b"," * missing
        try:
            cells = split_csv(line.decode(errors="surrogateescape"))
        except UsageError:
            return self.unread_cells(line)
        if len(cells) > len(self.heads):
            return self.unread_cells(line)
        return line + b"," * (len(self.heads) - len(cells))

    def json(self, line: bytes) -> bytes:
        """An object that a later step can read: quantities with their units, nested by their addresses."""
        try:
            cells = split_csv(decode_line(line))
        except UsageError:
            return self.unread(line)
        if len(cells) != len(self.columns):
            return self.unread(line)
        object_: Raw = {}
        for index, (column, cell) in enumerate(zip(self.columns, cells, strict=True)):
            if cell.strip() and index not in self.errors and not (index not in self._order and column.name in object_):
                if column.path:
                    nest(object_, column.path, column.raw(cell))
                else:
                    object_[column.name] = f"{without_guard(cell)} {column.unit}".strip()
        return compact(object_)[:-1].encode()


class TextInput(Input):
    """The words of a call, one call a line."""

    format = "text"

    def __init__(self, case: Case) -> None:
        super().__init__(case)
        self.heads = ["row"]

    def read(self, line: bytes) -> "Raw":
        """The words as positional parameters; quotes keep words together."""
        text = decode_line(line)
        if '"' not in text and "'" not in text:
            return self.case.words(text.split())
        import shlex

        try:
            return self.case.words(shlex.split(text))
        except ValueError as error:
            raise UsageError(f"the row's quotes do not match: {error}", code="syntax") from None

    def csv(self, line: bytes) -> bytes:
        """The line as one cell."""
        return self.unread_cells(line)

    def json(self, line: bytes) -> bytes:
        """The parameters by name."""
        try:
            return compact(self.read(line))[:-1].encode()
        except UsageError:
            return self.unread(line)


class JsonInput(Input):
    """One object a line; `results` of earlier steps are read as parameters of the same name."""

    format = "ndjson"

    def __init__(self, case: Case, first: bytes) -> None:
        super().__init__(case)
        self.passing: dict[str, None] = {}
        try:
            entries = self._flat(first)
        except UsageError:
            entries = []
        # Only CSV output needs columns: those of the first row.
        self.units = {name: unit for name, _, unit in entries}
        # Half a surrogate pair, which JSON may hold, cannot be written as text.
        self.heads = [header(name, unit).encode(errors="replace").decode() for name, unit in self.units.items()]

    def object(self, line: bytes) -> "Raw":
        """The line as an object."""
        raw = parse_json(decode_line(line), "the row")
        if not isinstance(raw, dict):
            raise UsageError("the row is not a JSON object", code="json", hint='for example {"distance": "60 ft"}')
        return raw

    def read(self, line: bytes) -> "Raw":
        """The object's parameters, and those that an earlier step's results give."""
        raw = self.object(line)
        if raw.get("error") is not None:
            raise CarriedError(raw["error"])
        names = self.case.names
        if raw.keys() <= names:
            return raw
        results = raw.get("results")
        parameters = {key: value for key, value in raw.items() if key in names}
        if len(self.passing) < 100:
            self.passing.update(dict.fromkeys(key for key in raw if key not in names))
        if isinstance(results, dict):
            parameters.update((key, value) for key, value in results.items() if key in names)
        return parameters

    def _flat(self, line: bytes) -> "list[tuple[str, Any, str]]":
        raw = self.object(line)
        raw.pop("error", None)
        raw.update(raw.pop("results", None) or {})
        return [entry for entry in flatten({"": raw}) if entry[0] != "."]

    def csv(self, line: bytes) -> bytes:
        """The cells of the first row's columns; a unit that differs from the header's stays with its number."""
        try:
            flat = {name: (value, unit) for name, value, unit in self._flat(line)}
        except UsageError:
            return self.unread_cells(line)
        cells = []
        for name, unit in self.units.items():
            value, cell_unit = flat.get(name, (None, ""))
            text = "" if value is None else value if isinstance(value, str) else compact(value)
            cells.append(csv_cell(f"{text} {cell_unit}" if cell_unit and cell_unit != unit else text))
        return ",".join(cells).encode(errors="replace")

    def json(self, line: bytes) -> bytes:
        """The line itself, without old results."""
        text = line.strip()
        try:
            raw = self.object(text)
        except UsageError:
            return self.unread(line)
        if "results" not in raw and "error" not in raw:
            return text[:-1].rstrip()
        from dynamics_cli.core.batch.text.shapes import without_members

        return without_members(text, ("results", "error"))
