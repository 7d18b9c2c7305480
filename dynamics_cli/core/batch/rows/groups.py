"""Lines sorted into groups that one array call can answer; rows that fit no group are left to the single call.

Most blocks are one group: that is tried first, by whole-block operations. Only when it fails is each line looked at.
"""

from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.group import SMALLEST_GROUP, Group, Groups
from dynamics_cli.core.batch.rows.inputs import CsvInput, Input, JsonInput, TextInput
from dynamics_cli.core.batch.text.cells import CellGroups
from dynamics_cli.core.batch.text.columns import column_of
from dynamics_cli.core.batch.text.conversions import Pairs
from dynamics_cli.core.batch.text.numbers import is_number
from dynamics_cli.core.batch.text.objects import JsonGroups
from dynamics_cli.core.inputs.specification import Leaf


class WordGroups(Groups):
    """Lines of a number, its unit and the units wanted."""

    def __init__(self, case: Case) -> None:
        self.pairs = Pairs(case)

    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """Bare numbers, all in the unit that the call fixes."""
        plan = self.pairs.plan(b"", b"1")
        column = column_of(lines) if plan is not None else None
        return [Group(plan, [column])] if plan is not None and column is not None else None

    def sorted(self, lines: "list[bytes]") -> "list[Group]":
        """Groups by the text after the number."""
        parts = [line.partition(b" ") for line in lines]
        column = column_of([part[0] for part in parts])
        rows: list[int] | None = None
        if column is None:
            rows = [row for row, part in enumerate(parts) if is_number(part[0])]
            column = column_of([parts[row][0] for row in rows])
            if column is None:
                return []
            parts = [parts[row] for row in rows]
        groups: dict[bytes, list[int]] = {}
        for place, part in enumerate(parts):
            groups.setdefault(part[2], []).append(place)
        result = []
        for rest, places in groups.items():
            if len(places) < SMALLEST_GROUP // 4:
                continue
            plan = self.pairs.plan(rest, parts[places[0]][0])
            if plan is not None:
                result.append(Group(plan, [column.take(places)], places if rows is None else [rows[p] for p in places]))
        return result


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
