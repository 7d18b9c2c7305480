"""The result document: inputs as read, results in their units, model, numerics, checks and warnings."""

import math

from dynamics_cli import __version__
from dynamics_cli.core.answer import Answer
from dynamics_cli.core.bound import Fields
from dynamics_cli.core.shown import Display, plain, round_condition, round_up
from dynamics_cli.core.specification import Leaf, Many, Record
from dynamics_cli.core.task import Task
from dynamics_cli.errors import InadmissibleError
from dynamics_cli.records import Advice, Check, Columns, Measured, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.quantities import Kind

UNIT_ROUNDOFF = 2.0**-53


class _Walk:
    """Turns a result record into document entries, gathering diagnostics and numerics on the way."""

    def __init__(self, display: Display, answer: Answer) -> None:
        self.display = display
        self.answer = answer
        self.bounds: dict[str, dict[str, Any]] = {}
        self.conditions: dict[str, dict[str, float]] = {}
        self.input_rounding: dict[str, dict[str, Any]] = {}
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
            own = f"{address}.{field.key}" if address else field.key
            if isinstance(node, Record) and node.cls is Numerics:
                self.numerics = value
            elif isinstance(node, Many) and isinstance(node.item, Record) and node.item.cls in (Check, Advice):
                (self.checks if node.item.cls is Check else self.advice).extend(value)
            elif value is not None:
                out[field.key] = self._node(value, node, own, table=table)
            elif self._has_no_answer(record, field.key):
                out[field.key] = None
        return out

    @staticmethod
    def _has_no_answer(record: "Any", name: str) -> bool:
        """Whether the record says why this result does not exist; results that do not apply are left out."""
        return any(advice.result == name for advice in getattr(record, "advice", ()))

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
            return _quantity(list(value.value) if isinstance(value.value, tuple) else value.value, value.unit)
        if node.choice is not None or node.kind.form in ("text", "flag", "unit"):
            return value
        self.names.append(address)
        if node.kind.form == "whole":
            return {"value": value}
        if isinstance(value, tuple):
            return self._vector(value, node.kind, address)
        return self._scalar(value, node.kind, address, table=table)

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
            own = f"{address}.{field.key}"
            self.names.append(own)
            numbers = value.arrays[field.name].tolist()
            if isinstance(field.node, Leaf) and field.node.kind.form in ("scalar", "slope"):
                shown = self.display.of(own, field.node.kind)
                for number in numbers:
                    _finite(number, own)
                out[field.key] = _quantity([shown.value(number) for number in numbers], shown.text)
            else:
                out[field.key] = {"value": numbers}
        return out

    def _scalar(self, value: "Any", kind: "Kind", address: str, *, table: bool) -> "dict[str, Any]":
        shown = self.display.of(address, kind)
        number = plain(value)
        _finite(number, address)
        out = _quantity(shown.value(number), shown.text)
        error = getattr(value, "error", None)
        if error is not None and not math.isfinite(error):
            message = f"no bound can be stated for the rounding of {address}: the formula leaves the range of a double"
            self.advice.append(Advice("no-bound", message, "caution"))
        elif error is not None:
            self._bound(address, number, error, shown)
            if not table:
                self._condition(address, number, value.slopes)
        return out

    def _bound(self, address: str, number: float, error: float, shown: "Any") -> None:
        extra = UNIT_ROUNDOFF if shown.converts else 0.0
        relative = error / abs(number) + extra if number != 0.0 and not shown.compound else math.inf
        old = self.bounds.get(address, {})
        # A bound that is no smaller than the number itself, or a number that is zero, is said in the number's own unit.
        if relative < 1.0 and "absolute" not in old and abs(number) > 1e-290:
            self.bounds[address] = {"relative": max(round_up(relative), old.get("relative", 0.0))}
        else:
            absolute = round_up(shown.width(error) * (1.0 + 1e-9) + extra * abs(shown.width(number))) + 5e-324
            entry = {"absolute": max(absolute, old.get("absolute", 0.0))}
            self.bounds[address] = _quantity_of_bound(entry, shown)

    def _condition(self, address: str, number: float, slopes: "tuple[float, ...]") -> None:
        if number == 0.0:
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
        shown = self.display.of(address, kind)
        errors: list[float] = []

        def show(part: "Any") -> "Any":
            if isinstance(part, tuple | list):
                return [show(item) for item in part]
            number = plain(part)
            _finite(number, address)
            if getattr(part, "error", None) is not None:
                extra = UNIT_ROUNDOFF * abs(number) if shown.converts else 0.0
                errors.append(part.error + extra)
            return shown.value(number)

        out = _quantity(show(value), shown.text)
        if errors:
            entry = {"absolute": round_up(shown.width(max(errors)) * (1.0 + 1e-9)) + 5e-324}
            self.bounds[address] = _quantity_of_bound(entry, shown)
        return out


def _quantity(value: "Any", unit: str) -> "dict[str, Any]":
    return {"value": value, "unit": unit} if unit else {"value": value}


def _quantity_of_bound(entry: "dict[str, Any]", shown: "Any") -> "dict[str, Any]":
    return {**entry, "unit": shown.text} if shown.text else entry


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
    about: dict[str, Any] = {"name": model.name, "source": model.source, "assumptions": list(model.assumptions)}
    if answer.why:
        about["why"] = answer.why
    numerics: dict[str, Any] = {"method": walk.numerics.method if walk.numerics else model.method}
    _stated_bounds(walk)
    for key, entries in (
        ("error_bound", walk.bounds),
        ("condition", {name: entry for name, entry in walk.conditions.items() if entry}),
        ("input_rounding", walk.input_rounding),
    ):
        if entries:
            numerics[key] = entries
    warnings = [_advice(item) for item in walk.advice]
    warnings += [{"code": "reading", "severity": "note", "message": note} for note in notes]
    return {
        "schema": "dynamics/1",
        "command": task.path,
        "version": __version__,
        "inputs": bound.echo(),
        "results": results,
        "model": about,
        "numerics": numerics,
        "checks": [_check(item) for item in walk.checks],
        "warnings": warnings,
    }


def _stated_bounds(walk: _Walk) -> None:
    """Bounds and conditions a solver states itself stand beside those carried through the formula."""
    for bound in walk.numerics.bounds if walk.numerics else ():
        walk.bounds[bound.result] = {"relative" if bound.relative else "absolute": round_up(bound.bound)}
    totals: dict[str, float] = {}
    for condition in walk.numerics.conditions if walk.numerics else ():
        walk.conditions.setdefault(condition.result, {})[condition.parameter] = round_condition(condition.value)
        totals[condition.result] = totals.get(condition.result, 0.0) + abs(condition.value)
    for name, total in totals.items():
        walk.input_rounding[name] = {"relative": round_up(total * UNIT_ROUNDOFF)}


def _check(check: Check) -> "dict[str, Any]":
    out: dict[str, Any] = {"name": check.name, "passed": bool(check.passed)}
    for key in ("value", "tolerance"):
        number = plain(getattr(check, key))
        if number is not None:
            out[key] = number
    return out


def _advice(advice: Advice) -> "dict[str, Any]":
    out = {"code": advice.code, "severity": advice.severity, "message": advice.message}
    return {**out, "mend": advice.mend} if advice.mend else out
