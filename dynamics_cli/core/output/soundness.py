"""No result is written with a number that is not finite, or after a failed internal check."""

from dynamics_cli.core.inputs.specification import Leaf, Many, Record
from dynamics_cli.errors import FaultError, InadmissibleError
from dynamics_cli.records import Advice, Check, Columns, Numerics, Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

INFINITY = float("inf")

# Checks below a record, by its specification: each field's name, key and kind of check.
_CHECKED: "dict[int, tuple[Record, list[tuple[str, str, str, Any]]]]" = {}


def _fields_to_check(spec: Record) -> "list[tuple[str, str, str, Any]]":
    cached = _CHECKED.get(id(spec))
    if cached is None:
        fields: list[tuple[str, str, str, Any]] = []
        for field in spec.fields:
            node = field.node
            item = node.item if isinstance(node, Many) else None
            if isinstance(node, Record):
                if node.cls is not Numerics:
                    fields.append((field.name, field.key, "record", node))
            elif isinstance(item, Record) and item.cls is Check:
                fields.append((field.name, field.key, "checks", None))
            elif isinstance(item, Record):
                if item.cls is not Advice:
                    fields.append((field.name, field.key, "records", item))
            elif not (isinstance(node, Leaf) and (node.choice is not None or node.kind.form in ("text", "flag"))):
                fields.append((field.name, field.key, "number", None))
        # The specification is kept with its entry, so that its id is not reused.
        _CHECKED[id(spec)] = cached = (spec, fields)
    return cached[1]


def check_numbers(record: "Any", spec: Record, address: str) -> None:
    """Refuse a record that holds a number beyond the range of a double, or a check that failed."""
    for name, key, how, inner in _fields_to_check(spec):
        value = getattr(record, name)
        if value is None:
            continue
        if type(value) is float:
            if not -INFINITY < value < INFINITY:
                _check_number(value, _below(address, key))
        elif how == "record":
            check_numbers(value, inner, _below(address, key))
        elif how == "checks":
            for check in value:
                if not check.passed:
                    hint = "this is a bug: please report it with the inputs"
                    raise FaultError(f"an internal check failed: {check.name} ({check.value})", code="check", hint=hint)
        elif isinstance(value, Columns):
            for column_name, column in value.arrays.items():
                _check_number(column.tolist(), f"{_below(address, key)}.{column_name}")
        elif how == "records":
            for item in value if isinstance(value, tuple | list) else (value,):
                check_numbers(item, inner, _below(address, key))
        else:
            _check_number(value.value if isinstance(value, Quantity) else value, _below(address, key))


def _below(address: str, key: str) -> str:
    return f"{address}.{key}" if address else key


def _check_number(value: "Any", address: str) -> None:
    if isinstance(value, tuple | list):
        for item in value:
            _check_number(item, address)
    elif isinstance(value, float) and not -INFINITY < value < INFINITY:
        raise InadmissibleError(
            f"{address} leaves the range of a double", code="range", hint="check the size of the inputs"
        )
