"""Lines of JSON objects, grouped by shape."""

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
from dynamics_cli.core.batch.rows.inputs import JsonInput
from dynamics_cli.core.batch.text.columns import column_of
from dynamics_cli.core.batch.text.shapes import Shape, shape_of
from dynamics_cli.core.batch.text.weaving import Unsuited
from dynamics_cli.errors import DynamicsError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class JsonGroups(Groups):
    """Objects, by their shapes."""

    def __init__(self, source: JsonInput, case: Case) -> None:
        self.source = source
        self.case = case
        self.shapes: list[Shape] = []
        self.recent: Shape | None = None

    def uniform(self, lines: "list[bytes]") -> "list[Group] | None":
        """All lines as one group like the last one, or like the first of them; or None."""
        if self.recent is None and not self.shapes and self._learn(lines[0]):
            self.recent = self.shapes[0]
        shape = self.recent
        if shape is None or shape.plan is None:
            return None
        data = b"\n".join(lines)
        captured = shape.find(data, len(lines))
        if captured is None or not readable(data):
            return None
        return self._group(shape, lines, captured, None)

    def _group(
        self, shape: Shape, lines: "list[bytes]", captured: "list[list[bytes]]", rows: "list[int] | None"
    ) -> "list[Group] | None":
        echoes = captured.pop(0) if shape.cut else [line[:-1] for line in lines]
        columns = [column_of(tokens, strict=True) for tokens in captured]
        complete = [column for column in columns if column is not None]
        return [Group(shape.plan, complete, rows, echoes)] if len(complete) == len(columns) else None

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
                rows, chosen = groups.setdefault(index, ([], []))
                rows.append(row)
                chosen.append(match.groups())
        listed: list[Group] = []
        for index, (rows, chosen) in sorted(groups.items(), key=lambda item: -len(item[1][0])):
            if len(rows) < SMALLEST_GROUP:
                break
            self.recent = self.recent if listed else self.shapes[index]
            listed += (
                self._group(
                    self.shapes[index], [lines[row] for row in rows], list(map(list, zip(*chosen, strict=True))), rows
                )
                or []
            )
        return listed

    def _shape(self, line: bytes) -> "tuple[int, Any]":
        for index, shape in enumerate(self.shapes):
            match = shape.whole.fullmatch(line)
            if match is not None:
                return index, match
        return -1, None

    def _learn(self, line: bytes, numeric: "set[str] | None" = None) -> bool:
        """Learn the shape of this line; false when the line is invalid or has no shape."""
        try:
            raw = self.source.read(line)
        except DynamicsError:
            return False
        shape = shape_of(line, self.case.names, numeric)
        if shape is None:
            return False
        try:
            shape.plan = make_plan(self.case, raw, shape.addresses, shape.units)
        except DynamicsError:
            return False
        except Unsuited as error:
            # Numbers that an array cannot replace become part of the shape; if that does not help, its lines go one by
            # one.
            if error.numeric is not None and numeric is None:
                return self._learn(line, error.numeric)
        self.shapes.append(shape)
        return True
