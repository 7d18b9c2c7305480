"""The JSON Schema (2020-12) of a task's inputs and outputs, from the same specification that reads them."""

from dynamics_cli.core.answering.task import Task
from dynamics_cli.core.command.help import describe_options
from dynamics_cli.core.inputs.specification import FLAG, Field, Leaf, Many, OneOf, Record, Tagged
from dynamics_cli.records import Advice, Check, Numerics

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

_NUMBER_FORMS = ("scalar", "slope", "whole")


class _Inputs:
    """Builds the inputs' schema; recursive records go to `$defs`."""

    def __init__(self, texts: "Mapping[tuple[str, ...], str]") -> None:
        self.texts = texts
        self.definitions: dict[str, Any] = {}

    def fields(self, fields: "tuple[Field, ...]", prefix: "tuple[str, ...]" = ()) -> "dict[str, Any]":
        """An object schema."""
        properties: dict[str, Any] = {}
        required: list[str] = []
        choices: list[Any] = []
        for field in fields:
            self._field(field, prefix, properties, required, choices)
        schema: dict[str, Any] = {"type": "object", "properties": properties, "additionalProperties": False}
        if required:
            schema["required"] = required
        if choices:
            schema["allOf"] = choices
        return schema

    def _field(
        self,
        field: Field,
        prefix: "tuple[str, ...]",
        properties: "dict[str, Any]",
        required: "list[str]",
        choices: "list[Any]",
    ) -> None:
        node = field.node
        if isinstance(node, Record) and field.place:
            inner = self.fields(node.fields, prefix)
            properties.update(inner["properties"])
            required.extend(inner.get("required", ()))
            choices.extend(inner.get("allOf", ()))
        elif isinstance(node, OneOf):
            self._spread(node.members, prefix, properties)
            alternatives = [{"required": sorted(member.required)} for member in node.members]
            choices.append({"anyOf": alternatives if field.required else [*alternatives, {}]})
        elif isinstance(node, Tagged):
            self._spread(tuple(node.members.values()), prefix, properties)
            properties[node.key] = {"enum": list(node.members)}
            if field.required:
                required.append(node.key)
        else:
            path = (*prefix, field.key)
            if isinstance(node, Many) and node.single and isinstance(node.item, Record):
                self._spread((node.item,), prefix, properties)
                if field.required:
                    plain = {"required": sorted(node.item.required)}
                    several = {"required": [field.key]}
                    # a lone item without required fields is recognised by the absence of the list
                    choices.append({"oneOf": [several, plain if node.item.required else {"not": several}]})
            elif field.required and not (isinstance(node, Leaf) and node.kind.default):
                required.append(field.key)
            properties[field.key] = self.node(node, path)

    def _spread(self, members: "tuple[Record, ...]", prefix: "tuple[str, ...]", properties: "dict[str, Any]") -> None:
        for member in members:
            for name, schema in self.fields(member.fields, prefix)["properties"].items():
                properties.setdefault(name, schema)

    def node(self, node: object, path: "tuple[str, ...]") -> "dict[str, Any]":
        """The schema of one node."""
        if isinstance(node, Leaf):
            return self._leaf(node, path)
        if isinstance(node, Many):
            several = {"type": "array", "items": self.node(node.item, path), "minItems": 1}
            lone = node.single and isinstance(node.item, Leaf)
            return {"anyOf": [self.node(node.item, path), several]} if lone else several
        if isinstance(node, Record):
            return self._record(node, path)
        members = node.members  # type: ignore[attr-defined]
        records = members.values() if isinstance(members, dict) else members
        return {"anyOf": [self._record(record, path) for record in records]}

    def _record(self, record: Record, path: "tuple[str, ...]") -> "dict[str, Any]":
        name = record.cls.__name__
        if name not in self.definitions:
            self.definitions[name] = {}  # a placeholder that ends the recursion
            self.definitions[name] = self.fields(record.fields, path)
        return {"$ref": f"#/$defs/{name}"}

    def _leaf(self, leaf: Leaf, path: "tuple[str, ...]") -> "dict[str, Any]":
        schema = _leaf_schema(leaf)
        text = self.texts.get(path) or self.texts.get(path[-1:]) or leaf.kind.about
        if text:
            schema["description"] = text
        return schema


def _leaf_schema(leaf: Leaf) -> "dict[str, Any]":
    kind = leaf.kind
    if leaf.choice is not None:
        return {"enum": [*leaf.choice.names, *leaf.choice.aliases]}
    if kind is FLAG:
        return {"type": "boolean"}
    examples = {"examples": [kind.example]} if kind.example else {}
    if kind.form in ("text", "file", "unit", "range", "formula", "let"):
        return {"type": "string", **examples}
    if kind.form == "fraction":
        text_object = {"type": "object", "properties": {"value": {"type": "string"}}, "required": ["value"]}
        return {"anyOf": [{"type": "string"}, text_object], **examples}
    # of compound units, 5 ft 6 in, the value is a list
    value: dict[str, Any] = {"type": ["number", "array"] if kind.unit or kind.form == "exact" else "number"}
    if kind.form not in _NUMBER_FORMS and kind.form != "exact":
        value = {"type": ["array", "number"]} if kind.form == "free vector" else {"type": "array"}
    pair = {
        "type": "object",
        "properties": {"value": value, "unit": {"type": "string"}},
        "required": ["value", "unit"] if kind.unit else ["value"],
    }
    forms: list[dict[str, Any]] = [{"type": "string"}, pair]
    if not kind.unit and kind.form != "exact":
        forms.append(_bounded(value, leaf))
    schema: dict[str, Any] = {"anyOf": forms, "examples": [kind.example], "x-kind": kind.name}
    if kind.unit:
        schema["x-unit"] = kind.unit
    return schema


def _bounded(value: "dict[str, Any]", leaf: Leaf) -> "dict[str, Any]":
    schema = dict(value)
    for key, limit in (
        ("minimum", leaf.kind.low),
        ("exclusiveMinimum", leaf.kind.above),
        ("maximum", leaf.kind.high),
        ("exclusiveMaximum", leaf.kind.below),
    ):
        if limit is not None:
            schema[key] = limit
    return schema


def _result(node: object) -> "dict[str, Any]":
    if isinstance(node, Record):
        return {"type": "object", "properties": _result_fields(node)}
    if isinstance(node, Many):
        if node.columns and isinstance(node.item, Record):
            return {"type": "object", "properties": {name: _listed(s) for name, s in _result_fields(node.item).items()}}
        if isinstance(node.item, Leaf) and node.item.kind.form == "scalar" and not node.single:
            return _listed(_result(node.item))
        several = {"type": "array", "items": _result(node.item)}
        return {"anyOf": [_result(node.item), several]} if node.single else several
    assert isinstance(node, Leaf)
    if node.choice is not None or node.kind.form in ("text", "unit"):
        return {"type": ["string", "null"]}
    if node.kind is FLAG:
        return {"type": "boolean"}
    if node.kind.form == "drawing":
        return _drawing_schema(node)
    value = {"type": "number"} if node.kind.form in _NUMBER_FORMS else {}
    properties: dict[str, Any] = {"value": value}
    if node.kind.si or node.kind.form in ("measured", "free", "free vector"):
        properties["unit"] = {"type": "string"}
    required = ["value", "unit"] if node.kind.unit else ["value"]
    return {"type": ["object", "null"], "properties": properties, "required": required, "x-kind": node.kind.name}


def _drawing_schema(node: Leaf) -> "dict[str, Any]":
    count = {"type": "object", "properties": {"value": {"type": "integer"}}, "required": ["value"]}
    length = {"type": "object", "properties": {"value": {"type": "number"}, "unit": {"type": "string"}}}
    return {
        "type": ["object", "null"],
        "description": node.kind.about,
        "properties": {"outlines": count, "pieces": count, "deviation": {**length, "required": ["value", "unit"]}},
        "required": ["outlines", "pieces", "deviation"],
        "x-kind": node.kind.name,
    }


def _listed(schema: "dict[str, Any]") -> "dict[str, Any]":
    properties = {**schema.get("properties", {}), "value": {"type": "array"}}
    return {**schema, "type": "object", "properties": properties}


def _result_fields(record: Record) -> "dict[str, Any]":
    hidden = (Check, Advice, Numerics)
    return {
        field.key: _result(field.node)
        for field in record.fields
        if getattr(getattr(field.node, "item", field.node), "cls", None) not in hidden
    }


def schema(task: Task) -> "dict[str, Any]":
    """The schema of a task: `inputs` for --input and --rows, `outputs` for the document's results."""
    builder = _Inputs(describe_options(task))
    inputs = builder.fields(task.specification.fields)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"dynamics {task.path}",
        "description": task.summary,
        "type": "object",
        "properties": {
            "inputs": inputs,
            "results": {"type": "object", "properties": _result_fields(task.specification.result)},
        },
        "$defs": builder.definitions,
    }
