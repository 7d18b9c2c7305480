"""Lines of cells, grouped by the text around their numbers."""

import re

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.group import (
    MOST_MAKES,
    MOST_TRIES,
    SMALLEST_GROUP,
    Group,
    Groups,
    make_plan,
    readable,
)
from dynamics_cli.core.batch.rows.inputs import Input
from dynamics_cli.core.batch.text.columns import Column, column_of
from dynamics_cli.core.batch.text.numbers import QUOTED, Written, apart, written
from dynamics_cli.core.batch.text.weaving import Unsuited
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.core.batch.rows.plan import Plan
    from dynamics_cli.core.batch.text.conversions import ExactPlan

# Stands for a doubled quote while lines are split at quotes.
MARK = b"\x01"
_QUOTED_CELL = re.compile(rb'"((?:[^"]|"")*)"')


def _tidy(data: bytes) -> bool:
    """Whether words are separated by single spaces and no quote can join them."""
    return not (b"  " in data or b"'" in data or b"\t" in data or data.startswith(b" ") or data.endswith(b" "))


class _Make:
    """Lines with the same words: for each parameter's column how its numbers are written, or the whole cell."""

    def __init__(self, ways: "list[Written | bytes]", plan: "Plan | ExactPlan | None") -> None:
        self.ways = ways
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
        self.makes: dict[tuple[Any, ...], _Make] = {}
        self.recent: _Make | None = None
        cell = rb'(?:"[^"\n]*"|[^",\n]*)'
        self._quoted_line = re.compile(b",".join([cell] * len(addresses))).fullmatch

    def _without_inner_quotes(self, line: bytes) -> bytes | None:
        """A line with a mark for each doubled quote within a quoted cell; None where it cannot be split."""
        if b'""' in line and MARK not in line:
            line = _QUOTED_CELL.sub(lambda cell: b'"' + cell[1].replace(b'""', MARK) + b'"', line)
        return line if self._quoted_line(line) else None

    def _cells(self, lines: "list[bytes]") -> "list[list[bytes]] | None":
        """Columns of cells, or None when some line has a different number of them than the header."""
        data = b"\n".join(lines)
        if not readable(data) or (self.separator == b" " and not _tidy(data)):
            return None
        width = len(self.addresses)
        if b'"' not in data:
            return apart(lines, self.separator, width)
        if not all(map(self._quoted_line, lines)):
            marked = list(map(self._without_inner_quotes, lines))
            if None in marked:
                return None
            data = b"\n".join(marked)  # type: ignore[arg-type]
        # What is quoted may hold separators.
        pieces = data.split(b'"')
        return apart(QUOTED.join(pieces[::2]).split(b"\n"), self.separator, width, iter(pieces[1::2]))

    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """All lines as one group like the last one, or like the first of them; or None."""
        cells = self._cells(lines)
        make = self.recent if self.recent is not None or cells is None else self._first_make(lines, cells)
        if cells is None or make is None or make.plan is None:
            return None
        columns = self._columns(make, cells)
        if columns is None:
            return None
        self.recent = make
        return [Group(make.plan, columns)]

    def _first_make(self, lines: "list[bytes]", cells: "list[list[bytes]]") -> "_Make | None":
        key = tuple([self._keys(index, cells[index][:1])[0] for index in self.parameters])
        return self._make(key, lines[:1])

    def _columns(self, make: _Make, cells: "list[list[bytes]]") -> "list[Column] | None":
        columns = []
        for index, way in zip(self.parameters, make.ways, strict=True):
            if isinstance(way, bytes):
                if cells[index].count(way) != len(cells[index]):
                    return None
                continue
            for tokens in way.columns(cells[index]) or ([],):
                column = column_of(tokens) if tokens else None
                if column is None:
                    return None
                columns.append(column)
        return columns

    def sorted(self, lines: "list[bytes]") -> "list[Group]":
        """Groups by the text around the numbers in the parameters' columns."""
        rows = [row for row, line in enumerate(lines) if self._fits(line)]
        cells = self._cells([lines[row] for row in rows]) if len(rows) >= SMALLEST_GROUP else None
        while cells is not None:
            literal = set(self.literal)
            groups = self._groups(lines, rows, cells)
            if literal == self.literal:
                return groups
        return []

    def _fits(self, line: bytes) -> bool:
        if b'"' in line:
            return self.separator == b"," and self._without_inner_quotes(line) is not None and readable(line)
        if line.count(self.separator) != len(self.addresses) - 1 or not readable(line):
            return False
        return self.separator != b" " or _tidy(line)

    def _groups(self, lines: "list[bytes]", rows: "list[int]", cells: "list[list[bytes]]") -> "list[Group]":
        keys = zip(*(self._keys(index, cells[index]) for index in self.parameters), strict=True)
        groups: dict[tuple[Any, ...], list[int]] = {}
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

    def _keys(self, index: int, cells: "list[bytes]") -> "list[Any]":
        if index in self.literal:
            return cells
        return [cell if (way := written(cell)) is None else way.key for cell in cells]

    def _make(self, key: "tuple[Any, ...]", lines: "list[bytes]") -> "_Make | None":
        make = self.makes.get(key)
        if make is None and len(self.makes) < MOST_MAKES:
            make = self._new_make([way if isinstance(way, bytes) else Written(*way) for way in key], lines)
            if make is not None:
                self.makes[key] = make
        return make

    def _new_make(self, ways: "list[Written | bytes]", lines: "list[bytes]") -> "_Make | None":
        addresses: list[str] = []
        units: list[str | None] = []
        for index, way in zip(self.parameters, ways, strict=True):
            if isinstance(way, Written):
                addresses += way.addresses(self.addresses[index])
                units += way.units(self.units[index])
        if not addresses:
            return None
        for line in lines:
            try:
                return _Make(ways, make_plan(self.case, self.source.read(line), addresses, units))
            except DynamicsError:
                continue  # this row has an error; another may serve as template
            except Unsuited as error:
                if error.numeric is not None:
                    self._take_literally(ways, error.numeric)
                return _Make(ways, None)
        return None

    def _take_literally(self, ways: "list[Written | bytes]", numeric: "set[str]") -> None:
        """Keep columns as they are whose numbers arrays cannot replace."""
        for index, way in zip(self.parameters, ways, strict=True):
            if isinstance(way, Written) and not numeric.issuperset(way.addresses(self.addresses[index])):
                self.literal.add(index)
