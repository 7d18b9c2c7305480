"""Lines of cells, grouped by the text around their numbers."""

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.group import (
    MOST_MAKES,
    MOST_TRIES,
    SMALLEST_GROUP,
    Group,
    Groups,
    make_plan,
    number_at,
    readable,
)
from dynamics_cli.core.batch.rows.inputs import Input
from dynamics_cli.core.batch.text.columns import Column, Unsuited, column_of
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.core.batch.rows.plan import Plan
    from dynamics_cli.core.batch.text.conversions import ExactPlan


def _tidy(data: bytes) -> bool:
    """Whether words are separated by single spaces and no quote can join them."""
    return not (b"  " in data or b"'" in data or b"\t" in data or data.startswith(b" ") or data.endswith(b" "))


class _Make:
    """Lines with the same words: for each parameter's column the unit behind its number, or the whole cell."""

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
        # Columns that arrays cannot replace: counts, and columns that a plan does not accept.
        self.literal: set[int] = set()
        self.makes: dict[tuple[tuple[bool, bytes], ...], _Make] = {}
        self.recent: _Make | None = None

    def _cells(self, lines: "list[bytes]") -> "list[list[bytes]] | None":
        """Columns of cells, or None when some line has a different number of them than the header."""
        count, width = len(lines), len(self.addresses)
        separator = self.separator
        data = (separator + b"\n" + separator).join(lines)
        if b'"' in data or not readable(data) or (separator == b" " and not _tidy(data)):
            return None
        cells = data.split(separator)
        # A marker cell separates lines; if each marker is in its place, every line has the right number of cells.
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
        """Groups by the text around the numbers in the parameters' columns."""
        width = len(self.addresses) - 1
        rows = [
            row
            for row, line in enumerate(lines)
            if b'"' not in line
            and line.count(self.separator) == width
            and readable(line)
            and (self.separator != b" " or _tidy(line))
        ]
        cells = self._cells([lines[row] for row in rows]) if len(rows) >= SMALLEST_GROUP else None
        while cells is not None:
            literal = set(self.literal)
            groups = self._groups(lines, rows, cells)
            if literal == self.literal:
                return groups
        return []

    def _groups(self, lines: "list[bytes]", rows: "list[int]", cells: "list[list[bytes]]") -> "list[Group]":
        keys = zip(*(self._keys(index, cells[index]) for index in self.parameters), strict=True)
        groups: dict[tuple[tuple[bool, bytes], ...], list[int]] = {}
        for place, key in enumerate(keys):
            groups.setdefault(key, []).append(place)
        listed = []
        for key, places in sorted(groups.items(), key=lambda item: -len(item[1])):
            if len(places) < SMALLEST_GROUP:
                break
            make = self._make(key, [lines[rows[place]] for place in places[:MOST_TRIES]])
            if make is None or make.plan is None:
                continue
            columns = self._columns(make, [[column[place] for place in places] for column in cells])
            if columns is not None:
                listed.append(Group(make.plan, columns, [rows[place] for place in places]))
                self.recent = make if len(listed) == 1 else self.recent
        return listed

    def _keys(self, index: int, cells: "list[bytes]") -> "list[tuple[bool, bytes]]":
        if index in self.literal:
            return [(False, cell) for cell in cells]
        keys = []
        for cell in cells:
            match = number_at(cell)
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
        units: list[str | None] = [
            rest or self.units[index] or None for index, rest in zip(numbers, rests, strict=True)
        ]
        for line in lines:
            try:
                raw = self.source.read(line)
                plan = make_plan(self.case, raw, [self.addresses[index] for index in numbers], units)
            except DynamicsError:
                continue  # this row has an error; another may serve as template
            except Unsuited as error:
                if error.numeric is not None:
                    self.literal |= {index for index in numbers if self.addresses[index] not in error.numeric}
                self.makes[key] = _Make(key, None)
                return None
            self.makes[key] = _Make(key, plan)
            return self.makes[key]
        return None
