"""Lines sorted into groups that one array call can answer; what fits no group is left to the single call.

Most blocks are one group: that is tried first, by whole-block operations. Only when it fails is each line looked at.
"""

from dynamics_cli.core.exact_rows import ExactPlan, Pairs
from dynamics_cli.core.row_case import Case
from dynamics_cli.core.row_columns import Column, Unsuited, column_of
from dynamics_cli.core.row_inputs import CsvInput, Input, JsonInput, TextInput
from dynamics_cli.core.row_plan import Plan
from dynamics_cli.core.row_shapes import NUMBER, Shape, shape_of
from dynamics_cli.core.specification import Leaf
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Smaller groups cost more together than one by one.
SMALLEST_GROUP = 64
# More makes of rows than this in one stream, and most rows are a make of their own.
MOST_MAKES = 64
MOST_TRIES = 6


class Group:
    """Rows (None: all of the block) with their columns of numbers, their plan, and their echoes where already cut."""

    __slots__ = ("columns", "echoes", "plan", "rows")

    def __init__(
        self,
        plan: "Plan | ExactPlan",
        columns: "list[Column]",
        rows: "list[int] | None" = None,
        echoes: "list[bytes] | None" = None,
    ) -> None:
        self.plan = plan
        self.columns = columns
        self.rows = rows
        self.echoes = echoes


def make_plan(
    case: Case, raw: "dict[str, Any]", addresses: "Sequence[str]", units: "Sequence[str | None]"
) -> "Plan | ExactPlan":
    """The plan for rows like this one; raises Unsuited, or what is wrong with this one row."""
    if case.measure[0]:
        return ExactPlan(case, raw, addresses)
    if not case.task.arrays:
        raise Unsuited("the physics takes one case at a time")
    return Plan(case, raw, addresses, units)


class Groups:
    """How one format of rows is sorted."""

    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """All lines as one group like the last one, or None."""
        raise NotImplementedError

    def sorted(self, lines: "list[bytes]") -> "list[Group]":
        """Groups of the lines that can be answered together."""
        raise NotImplementedError


def readable(data: bytes) -> bool:
    """Whether bytes are UTF-8."""
    if data.isascii():
        return True
    try:
        data.decode()
    except UnicodeDecodeError:
        return False
    return True


class _Make:
    """Lines of cells whose words are alike: for each parameter's column the unit behind its number, or the whole cell."""

    def __init__(self, key: "tuple[tuple[bool, bytes], ...]", plan: "Plan | ExactPlan | None") -> None:
        self.key = key
        self.plan = plan


class CellGroups(Groups):
    """Lines of cells: CSV, or the words of calls that are all numbers."""

    def __init__(self, source: Input, case: Case, separator: bytes, addresses: "list[str]", units: "list[str]") -> None:
        self.source = source
        self.case = case
        self.separator = separator
        self.addresses = addresses
        self.units = units
        self.parameters = [index for index, address in enumerate(addresses) if address]
        # Columns whose numbers no array can stand for: counts, and whatever a plan would not have.
        self.literal: set[int] = set()
        self.makes: dict[tuple[tuple[bool, bytes], ...], _Make] = {}
        self.recent: _Make | None = None

    def _cells(self, lines: "list[bytes]") -> "list[list[bytes]] | None":
        """Columns of cells, or None when some line has others than the header's."""
        count, width = len(lines), len(self.addresses)
        separator = self.separator
        data = (separator + b"\n" + separator).join(lines)
        if b'"' in data or not readable(data):
            return None
        cells = data.split(separator)
        # Between two lines stands a cell of its own; if each is in its place, every line has the right number of cells.
        if len(cells) != count * (width + 1) - 1 or cells[width :: width + 1].count(b"\n") != count - 1:
            return None
        return [cells[index :: width + 1] for index in range(width)]

    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """All lines as one group like the last one, or None."""
        make = self.recent
        cells = self._cells(lines) if make is not None and make.plan is not None else None
        if cells is None or make is None or make.plan is None:
            return None
        columns = self._columns(make, cells)
        return [Group(make.plan, columns)] if columns is not None else None

    def _columns(self, make: _Make, cells: "list[list[bytes]]") -> "list[Column] | None":
        columns = []
        count = len(cells[0])
        for index, (number, rest) in zip(self.parameters, make.key, strict=True):
            tokens = cells[index]
            if not number:
                if tokens.count(rest) != count:
                    return None
                continue
            if rest:
                if not all(token.endswith(rest) for token in tokens):
                    return None
                tokens = [token[: -len(rest)] for token in tokens]
            column = column_of(tokens)
            if column is None:
                return None
            columns.append(column)
        return columns

    def sorted(self, lines: "list[bytes]") -> "list[Group]":
        """Groups by what stands in the parameters' columns beside numbers."""
        width = len(self.addresses) - 1
        rows = [
            row
            for row, line in enumerate(lines)
            if b'"' not in line and line.count(self.separator) == width and readable(line)
        ]
        cells = self._cells([lines[row] for row in rows]) if len(rows) >= SMALLEST_GROUP else None
        while cells is not None:
            known = set(self.literal)
            found = self._groups(lines, rows, cells)
            if known == self.literal:
                return found
        return []

    def _groups(self, lines: "list[bytes]", rows: "list[int]", cells: "list[list[bytes]]") -> "list[Group]":
        keys = zip(*(self._keys(index, cells[index]) for index in self.parameters), strict=True)
        groups: dict[tuple[tuple[bool, bytes], ...], list[int]] = {}
        for place, key in enumerate(keys):
            groups.setdefault(key, []).append(place)
        made = []
        for key, places in sorted(groups.items(), key=lambda item: -len(item[1])):
            if len(places) < SMALLEST_GROUP:
                break
            make = self._make(key, [lines[rows[place]] for place in places[:MOST_TRIES]])
            if make is None or make.plan is None:
                continue
            columns = self._columns(make, [[column[place] for place in places] for column in cells])
            if columns is not None:
                made.append(Group(make.plan, columns, [rows[place] for place in places]))
                self.recent = make if len(made) == 1 else self.recent
        return made

    def _keys(self, index: int, cells: "list[bytes]") -> "list[tuple[bool, bytes]]":
        if index in self.literal:
            return [(False, cell) for cell in cells]
        keys = []
        for cell in cells:
            match = _number(cell)
            keys.append((True, cell[match.end() :]) if match is not None else (False, cell))
        return keys

    def _make(self, key: "tuple[tuple[bool, bytes], ...]", lines: "list[bytes]") -> "_Make | None":
        make = self.makes.get(key)
        if make is None and len(self.makes) < MOST_MAKES:
            make = self._new_make(key, lines)
        return make

    def _new_make(self, key: "tuple[tuple[bool, bytes], ...]", lines: "list[bytes]") -> "_Make | None":
        numbers = [index for index, (number, _) in zip(self.parameters, key, strict=True) if number]
        if not numbers:
            return None
        rests = [rest.decode().strip() for number, rest in key if number]
        units: list[str | None] = [rest or self.units[index] or None for index, rest in zip(numbers, rests, strict=True)]
        for line in lines:
            try:
                raw = self.source.read(line)
                plan = make_plan(self.case, raw, [self.addresses[index] for index in numbers], units)
            except DynamicsError:
                continue  # this row is wrong; another may serve as template
            except Unsuited as error:
                if error.numeric is not None:
                    self.literal |= {index for index in numbers if self.addresses[index] not in error.numeric}
                self.makes[key] = _Make(key, None)
                return None
            self.makes[key] = _Make(key, plan)
            return self.makes[key]
        return None


def _compiled() -> "Any":
    import re

    return re.compile(NUMBER).match


_number = _compiled()


class JsonGroups(Groups):
    """Objects, by their shapes."""

    def __init__(self, source: JsonInput, case: Case) -> None:
        self.source = source
        self.case = case
        self.shapes: list[Shape] = []
        self.recent: Shape | None = None

    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """All lines as one group like the last one, or None."""
        shape = self.recent
        if shape is None or shape.plan is None:
            return None
        data = b"\n".join(lines)
        found = shape.search.findall(data)
        if len(found) != len(lines) or not readable(data):
            return None
        return self._group(shape, lines, found, None)

    def _group(
        self, shape: Shape, lines: "list[bytes]", found: "list[Any]", rows: "list[int] | None"
    ) -> "list[Group] | None":
        captured = list(zip(*found, strict=True)) if not isinstance(found[0], bytes) else [found]
        echoes = list(captured.pop(0)) if shape.cut else [line[:-1] for line in lines]
        columns = [column_of(list(tokens)) for tokens in captured]
        whole = [column for column in columns if column is not None]
        return [Group(shape.plan, whole, rows, echoes)] if len(whole) == len(columns) else None

    def sorted(self, lines: "list[bytes]") -> "list[Group]":
        """Groups by shape."""
        groups: dict[int, tuple[list[int], list[Any]]] = {}
        tries = 0
        for row, line in enumerate(lines):
            index, match = self._shape(line)
            if match is None and tries < MOST_TRIES and len(self.shapes) < MOST_MAKES:
                tries += not self._learn(line)
                index, match = self._shape(line)
            if match is not None and self.shapes[index].plan is not None and readable(line):
                rows, found = groups.setdefault(index, ([], []))
                rows.append(row)
                captured = match.groups()
                found.append(captured if len(captured) > 1 else captured[0])
        made: list[Group] = []
        for index, (rows, found) in sorted(groups.items(), key=lambda item: -len(item[1][0])):
            if len(rows) < SMALLEST_GROUP:
                break
            self.recent = self.recent if made else self.shapes[index]
            made += self._group(self.shapes[index], [lines[row] for row in rows], found, rows) or []
        return made

    def _shape(self, line: bytes) -> "tuple[int, Any]":
        for index, shape in enumerate(self.shapes):
            match = shape.whole.fullmatch(line)
            if match is not None:
                return index, match
        return -1, None

    def _learn(self, line: bytes) -> bool:
        """Make a shape of this line; "no" when the line is wrong or has no shape."""
        numeric: set[str] | None = None
        for _ in range(2):
            try:
                raw = self.source.read(line)
                shape = shape_of(line, self.case.names, numeric)
                if shape is None:
                    return False
                shape.plan = make_plan(self.case, raw, shape.addresses, shape.units)
            except DynamicsError:
                return False
            except Unsuited as error:
                if error.numeric is None or numeric is not None:
                    self.shapes.append(shape)  # its lines are known to go one by one
                    return True
                numeric = error.numeric
                continue
            self.shapes.append(shape)
            return True
        return False


class WordGroups(Groups):
    """Lines of a number, its unit and the units wanted."""

    def __init__(self, case: Case) -> None:
        self.pairs = Pairs(case)

    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """Bare numbers, all of the unit that the call fixes."""
        plan = self.pairs.plan(b"", b"1")
        column = column_of(lines) if plan is not None else None
        return [Group(plan, [column])] if plan is not None and column is not None else None

    def sorted(self, lines: "list[bytes]") -> "list[Group]":
        """Groups by what follows the number."""
        parts = [line.partition(b" ") for line in lines]
        column = column_of([part[0] for part in parts])
        rows: list[int] | None = None
        if column is None:
            rows = [row for row, part in enumerate(parts) if _is_number(part[0])]
            column = column_of([parts[row][0] for row in rows])
            if column is None:
                return []
            parts = [parts[row] for row in rows]
        groups: dict[bytes, list[int]] = {}
        for place, part in enumerate(parts):
            groups.setdefault(part[2], []).append(place)
        made = []
        for rest, places in groups.items():
            if len(places) < SMALLEST_GROUP // 4:
                continue
            plan = self.pairs.plan(rest, parts[places[0]][0])
            if plan is not None:
                made.append(Group(plan, [column.take(places)], places if rows is None else [rows[p] for p in places]))
        return made


def _is_number(token: bytes) -> bool:
    match = _number(token)
    return match is not None and match.end() == len(token)


def groups_of(source: Input, case: Case, first: bytes) -> "Groups | None":
    """How the rows of this input are sorted; None when they are answered one by one."""
    if isinstance(source, JsonInput):
        return JsonGroups(source, case)
    if isinstance(source, CsvInput):
        columns = source.columns
        addresses = [column.address if column.path else "" for column in columns]
        # Two columns for one parameter, or an earlier error: the single call knows which counts.
        if len(set(filter(None, addresses))) < len(list(filter(None, addresses))):
            return None
        addresses = [address or ("error" if i in source.errors else "") for i, address in enumerate(addresses)]
        return CellGroups(source, case, b",", addresses, [column.unit for column in columns])
    if case.measure[0]:
        return WordGroups(case)
    free = [field for field in case.task.specification.words if field.key not in case.fixed]
    words = first.split()
    if not isinstance(source, TextInput) or len(words) != len(free):
        return None
    if not all(isinstance(field.node, Leaf) and field.place == "word" for field in free):
        return None
    return CellGroups(source, case, b" ", [field.key for field in free], [""] * len(free))
