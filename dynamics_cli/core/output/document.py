"""The result document: inputs as read, results in their units, model, numerics, checks and warnings."""

import math

from dynamics_cli.core.answering.models import Answer
from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.documents import quantity_node
from dynamics_cli.core.inputs.specification import DEVIATION, Leaf, Many, Record
from dynamics_cli.core.inputs.values import Fields
from dynamics_cli.core.units.display import Display, Shown, round_condition, round_up
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.number import plain
from dynamics_cli.records import Advice, Check, Columns, Measured, Numerics, Quantity
from dynamics_cli.version import __version__

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

    from dynamics_cli.quantities import Kind
    from dynamics_cli.records import ErrorBound

UNIT_ROUNDOFF = 2.0**-53
# Below this a bound is stated relative to the number, else in the number's unit.
SMALLEST_RELATIVE = 1e-290
LARGEST_RELATIVE = 1e-3
# A check's value below both, the second as a share of its tolerance, is rounding.
ROUNDING = 1e-15
LITTLE = 1e-2


class _Walk:
    """Turns a result record into document entries, gathering diagnostics and numerics on the way."""

    def __init__(self, display: Display, answer: Answer) -> None:
        self.display = display
        self.answer = answer
        self.cells: dict[str, _Cells] = {}
        self.bounds: dict[str, dict[str, Any] | None] = {}
        self.shown: dict[str, Shown] = {}
        self.conditions: dict[str, dict[str, float]] = {}
        self.input_rounding: dict[str, dict[str, Any]] = {}
        # Results with their own unit that are shown in another one.
        self.converted: set[str] = set()
        self.checks: list[Check] = []
        self.advice: list[Advice] = []
        self.numerics: Numerics | None = None
        self.names: list[str] = []

    def record(self, record: "Any", spec: Record, address: str, *, table: bool = False) -> "dict[str, Any]":
        """One record's fields."""
        out: dict[str, Any] = {}
        for field in spec.fields:
            value = getattr(record, field.name)
            node = field.node
            field_address = f"{address}.{field.key}" if address else field.key
            if isinstance(node, Record) and node.cls is Numerics:
                self.numerics = value
            elif isinstance(node, Many) and isinstance(node.item, Record) and node.item.cls in (Check, Advice):
                (self.checks if node.item.cls is Check else self.advice).extend(value)
            elif value is not None:
                out[field.key] = self._node(value, node, field_address, table=table)
            elif self._has_no_answer(record, field.key, field_address):
                out[field.key] = None
        return out

    def _has_no_answer(self, record: "Any", name: str, address: str) -> bool:
        """Whether the record, or the whole answer, gives a reason for a missing result; others are left out."""
        lists = getattr(record, "advice", ()), getattr(self.answer.record, "advice", ())
        return any(
            advice.result == where for where, part in zip((name, address), lists, strict=True) for advice in part
        )

    def _node(self, value: "Any", node: "Any", address: str, *, table: bool) -> "Any":
        if isinstance(node, Record):
            return self.record(value, node, address, table=table)
        if isinstance(node, Many):
            if node.single and not isinstance(value, tuple | list):
                return self._node(value, node.item, address, table=table)
            return self._many(value, node, address)
        if isinstance(value, Measured):
            self.names.append(address)
            self.conditions.setdefault(address, {})
            measured, value = value, self.display.of_measured(address, value)
            if value is not measured:
                self.converted.add(address)
            return quantity_node(list(value.value) if isinstance(value.value, tuple) else value.value, value.unit)
        kind = value.kind if isinstance(value, Quantity) else node.kind
        if isinstance(value, Quantity):
            value = value.value
        if node.choice is not None or node.kind.form in ("text", "flag", "unit"):
            return value
        if node.kind.form == "drawing":
            return self._drawing(value, address)
        self.names.append(address)
        if node.kind.form == "whole":
            return {"value": value}
        if isinstance(value, tuple):
            return self._vector(value, kind, address)
        return self._scalar(value, kind, address, table=table)

    def _drawing(self, value: "Any", address: str) -> "dict[str, Any]":
        """A summary of a shape; the shape itself goes to `--drawing`."""
        from dynamics_cli.core.output.drawing.scaled import round_bound

        outlines = getattr(value, "outlines", (value,))
        shown = self.display.of(f"{address}.deviation", DEVIATION)
        self.names.append(f"{address}.deviation")
        return {
            "outlines": {"value": len(outlines)},
            "pieces": {"value": sum(len(outline.pieces) for outline in outlines)},
            "deviation": quantity_node(round_bound(shown.width(value.deviation)), shown.text),
        }

    def _many(self, value: "Any", node: Many, address: str) -> "Any":
        if isinstance(value, Columns):
            return self._columns(value, node, address)
        if isinstance(node.item, Leaf) and node.item.kind.form == "scalar":
            return self._vector(value, node.item.kind, address)
        return [self._node(item, node.item, address, table=True) for item in value]

    def _columns(self, value: "Any", node: Many, address: str) -> "dict[str, Any]":
        out: dict[str, Any] = {}
        assert isinstance(node.item, Record)
        for field in node.item.fields:
            field_address = f"{address}.{field.key}"
            self.names.append(field_address)
            numbers = value.arrays[field.name].tolist()
            if isinstance(field.node, Leaf) and field.node.kind.form in ("scalar", "slope"):
                shown = self.shown[field_address] = self.display.of(field_address, field.node.kind)
                for number in numbers:
                    _finite(number, field_address)
                out[field.key] = quantity_node([shown.value(number) for number in numbers], shown.text)
            else:
                out[field.key] = {"value": numbers}
        return out

    def _scalar(self, value: "Any", kind: "Kind", address: str, *, table: bool) -> "dict[str, Any]":
        number = plain(value)
        _finite(number, address)
        shown = self.shown[address] = self.display.of(address, kind, 0.0 if table else number)
        out = quantity_node(shown.value(number), shown.text)
        error = getattr(value, "error", None)
        if error is not None:
            self._state(address, shown, number, error)
            if not table:
                self._condition(address, number, value.slopes)
        return out

    def _state(self, address: str, shown: Shown, number: float, error: float, *, vector: bool = False) -> None:
        """Keep one cell's bound; a column of cells gets one bound for all of them."""
        column = self.cells.setdefault(address, _Cells(shown.bound_unit, vector))
        column.cells.append((abs(shown.width(number)), shown.spread(number, error)))

    def _condition(self, address: str, number: float, slopes: "tuple[float, ...]") -> None:
        if number == 0.0 or not all(map(math.isfinite, slopes)):
            return
        entry = self.conditions.setdefault(address, {})
        total = 0.0
        for (leaf, si), slope in zip(self.answer.leaves, slopes, strict=True):
            condition = slope * si / number
            if math.isfinite(condition):
                entry[leaf] = round_condition(condition)
                total += abs(condition)
        self.input_rounding[address] = {"relative": round_up(total * UNIT_ROUNDOFF)}

    def _vector(self, value: "Any", kind: "Kind", address: str) -> "dict[str, Any]":
        shown = self.shown[address] = self.display.of(address, kind)

        def show(part: "Any") -> "Any":
            if isinstance(part, tuple | list):
                return [show(item) for item in part]
            number = plain(part)
            _finite(number, address)
            if getattr(part, "error", None) is not None:
                self._state(address, shown, number, part.error, vector=True)
            return shown.value(number)

        return quantity_node(show(value), shown.text)


class _Cells:
    """The bounds of one result, or of every cell of a column: magnitude and error of each number."""

    __slots__ = ("cells", "unit", "vector")

    def __init__(self, unit: str, vector: bool) -> None:
        self.unit = unit
        self.vector = vector
        self.cells: list[tuple[float, float]] = []

    def stated(self) -> "dict[str, Any] | None":
        """A relative bound if every number allows one, else an absolute one; None without a bound."""
        if not all(math.isfinite(spread) for _, spread in self.cells):
            return None
        relative = not self.vector and all(
            spread == 0.0 or (size > SMALLEST_RELATIVE and spread < LARGEST_RELATIVE * size)
            for size, spread in self.cells
        )
        if relative:
            # relative to the true number, which may be smaller than the one shown by the bound
            return {
                "relative": round_up(max(spread / (size - spread) if spread else 0.0 for size, spread in self.cells))
            }
        return {
            "absolute": round_up(max(spread for _, spread in self.cells)),
            **({"unit": self.unit} if self.unit else {}),
        }


def _finite(number: float, address: str) -> None:
    if not math.isfinite(number):
        raise InadmissibleError(
            f"{address} leaves the range of a double", code="range", hint="check the size of the inputs"
        )


def build(task: Task, bound: Fields, answer: Answer, display: Display, notes: "list[str]") -> "dict[str, Any]":
    """The result document of one case."""
    walk = _Walk(display, answer)
    results = walk.record(answer.record, task.specification.result, "")
    display.check(walk.names)
    model = answer.model
    model_entry: dict[str, Any] = {"name": model.name, "source": model.source, "assumptions": list(model.assumptions)}
    if answer.why:
        model_entry["why"] = answer.why
    numerics: dict[str, Any] = {"method": walk.numerics.method if walk.numerics else model.method}
    _stated_bounds(walk)
    for key, entries in (
        ("error_bound", walk.bounds),
        ("condition", {name: entry for name, entry in walk.conditions.items() if entry}),
        ("input_rounding", walk.input_rounding),
    ):
        if entries:
            numerics[key] = entries
    # a reason that applies to two results is given once
    warnings_read = [_advice(item, bound, walk.shown.values()) for item in walk.advice]
    warnings = [warning for index, warning in enumerate(warnings_read) if warning not in warnings_read[:index]]
    warnings += [{"code": "reading", "severity": "note", "message": note} for note in notes]
    return {
        "schema": "dynamics/2",
        "command": task.path,
        "version": __version__,
        "inputs": bound.echo(),
        "results": results,
        "model": model_entry,
        "numerics": numerics,
        "checks": [_check(item) for item in walk.checks],
        "warnings": warnings,
    }


def _stated_bounds(walk: _Walk) -> None:
    """Every result's bound: null, with a warning, where none can be stated.

    Bounds and conditions a solver states itself stand beside those carried through the formula.
    """
    for address, cells in walk.cells.items():
        walk.bounds[address] = cells.stated()
        if walk.bounds[address] is None:
            message = f"no bound can be stated for the rounding of {address}: it may exceed the result"
            walk.advice.append(Advice("no-bound", message))
    for bound in walk.numerics.bounds if walk.numerics else ():
        walk.bounds[bound.result] = _stated_bound(walk, bound) if math.isfinite(bound.bound) else None
    totals: dict[str, float] = {}
    for condition in walk.numerics.conditions if walk.numerics else ():
        walk.conditions.setdefault(condition.result, {})[condition.parameter] = round_condition(condition.value)
        totals[condition.result] = totals.get(condition.result, 0.0) + abs(condition.value)
    for name, total in totals.items():
        walk.input_rounding[name] = {"relative": round_up(total * UNIT_ROUNDOFF)}


def _stated_bound(walk: _Walk, bound: "ErrorBound") -> "dict[str, Any]":
    """A solver's bound; an absolute one, in SI, in the unit that its result is shown in."""
    shown = walk.shown.get(bound.result)
    if bound.relative:
        # Showing it in another unit rounds once more.
        again = bound.result in walk.converted or (shown is not None and (shown.unit is not None or shown.compound))
        converted = UNIT_ROUNDOFF if again else 0.0
        return {"relative": round_up(bound.bound + converted)}
    if shown is None:
        return {"absolute": round_up(bound.bound)}
    stated: dict[str, Any] = {"absolute": round_up(shown.width(bound.bound))}
    return {**stated, "unit": shown.bound_unit} if shown.bound_unit else stated


def _check(check: Check) -> "dict[str, Any]":
    out: dict[str, Any] = {"name": check.name, "passed": bool(check.passed)}
    for key in ("value", "tolerance"):
        number = plain(getattr(check, key))
        if number is not None:
            out[key] = number
    # what rounding leaves differs from one processor to the next
    if 0.0 < out.get("value", 0.0) < min(ROUNDING, LITTLE * out.get("tolerance", 1.0)):
        out["value"] = 0.0
    return out


def _advice(advice: Advice, bound: Fields, results: "Iterable[Shown]") -> "dict[str, Any]":
    from dynamics_cli.core.answering.messages import in_written_units

    message = in_written_units(advice.message, bound, results)
    out = {"code": advice.code, "severity": advice.severity, "message": message}
    return {**out, "remedy": in_written_units(advice.remedy, bound, results)} if advice.remedy else out
