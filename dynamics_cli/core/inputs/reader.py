"""Inputs, from the user's text to a tree of parsed values; every bad parameter is reported, not just the first.

The raw input is nested dictionaries and lists whose leaves are text (`"60 ft"`), `Token` (a bare JSON number, kept as
its text so that it is read exactly), `{"value": 60, "unit": "ft"}`, truth values or None.
"""

from dynamics_cli.core.inputs.context import Context, Token
from dynamics_cli.core.inputs.leaves import MANY_CHOICES, read_leaf
from dynamics_cli.core.inputs.options import kebab
from dynamics_cli.core.inputs.specification import Field, Leaf, Many, OneOf, Record, Tagged
from dynamics_cli.core.inputs.spelling import underscored, written
from dynamics_cli.core.inputs.values import Bound, Fields, Several
from dynamics_cli.errors import DynamicsError, ManyErrors, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from typing import Any

    from dynamics_cli.core.inputs.specification import Node

    Raw = Mapping[str, Any]


# Kinds of few tasks, each read by its own module.
FREE = ("free vector", "matrix")


class Reader(Context):
    """Reads raw input against a specification; collects errors."""

    def __init__(
        self, environ: "Mapping[str, str]", *, folder: str = "", units: "Mapping[str, str] | None" = None
    ) -> None:
        super().__init__(environ, folder)
        self.units = units or {}
        self.errors: list[DynamicsError] = []
        # Where to find values of parameters that are missing or named, by the parameters' names.
        self.pointers: Mapping[str, str] = {}
        if units:
            from dynamics_cli.core.inputs.default_units import default_units

            self.default_units = default_units(units)

    def read(self, fields: "tuple[Field, ...]", raw: "Raw") -> Fields:
        """Every parameter of a task; raises all errors together."""
        self.axes = str(raw.get("axes") or "")
        bound = self._object(fields, raw, "")
        for error in self.errors:
            error.named = self._variable(fields, raw, error.parameter) or self.spell(error.parameter or "")
            if error.code == "number" and (pointer := self.pointers.get((error.parameter or "").rpartition(".")[2])):
                error.hint = f"{error.hint}; {pointer}"
        if len(self.errors) == 1:
            raise self.errors[0]
        if self.errors:
            raise ManyErrors(self.errors)
        inputs = Fields(None, bound)
        inputs.spell = self.spell
        return inputs

    def _variable(self, fields: "tuple[Field, ...]", raw: "Raw", key: str | None) -> str:
        """The variable of the environment that gave a parameter."""
        leaf = next((field.node for field in fields if field.key == key and key not in raw), None)
        variable = leaf.kind.variable if isinstance(leaf, Leaf) else ""
        return variable if variable in self.environ else ""

    def _fail(self, address: str, message: str, *, code: str = "usage", hint: str | None = None) -> None:
        self.errors.append(UsageError(message, code=code, parameter=address, hint=hint))

    def _object(self, fields: "tuple[Field, ...]", raw: "Raw", address: str) -> "dict[str, Bound]":
        known_keys = {key for field in fields for key in field.known}
        if any("-" in key for key in raw):
            raw = underscored(raw, known_keys)
        bound: dict[str, Bound] = {}
        for field in fields:
            before = len(self.errors)
            member = self._field(field, raw, address)
            for error in self.errors[before:]:
                error.hint = _with_example(error.hint, field)
            if member is not None:
                bound[field.name] = member
        for key in raw:
            if key not in known_keys:
                self._unknown(key, known_keys, address)
        return bound

    def _unknown(self, key: str, known: "Iterable[str]", address: str) -> None:
        from dynamics_cli.core.inputs.suggestions import halved, suggestions

        near = suggestions(key, known)
        hint = (
            f"did you mean {' or '.join(near)}{halved(key, near)}?"
            if near
            else f"known here: {', '.join(sorted(known)) or 'nothing'}"
        )
        self._fail(_join(address, key), f"there is no parameter {key!r}", code="unknown-parameter", hint=hint)

    def _field(self, field: Field, raw: "Raw", address: str) -> Bound | None:
        node = field.node
        if isinstance(node, Many):
            return self._many(field, node, raw, address)
        if isinstance(node, OneOf | Tagged) or (isinstance(node, Record) and field.place):
            return self._spread(field, node, raw, address)
        field_address = _join(address, field.key)
        value = raw.get(field.key)
        if value is None:
            value = self._default_of(node, raw)
        if value is None:
            if not field.required:
                return None
            if isinstance(node, Leaf):
                self._missing(field, node, field_address)
                return None
            value = {}
        return self._item(node, value, field_address)

    def _spread(self, field: Field, node: "Node", raw: "Raw", address: str) -> Bound | None:
        """What stands beside its siblings, without a name of its own."""
        if isinstance(node, OneOf):
            return self._one_of(field, node, raw, address)
        if isinstance(node, Tagged):
            return self._tagged(field, node, raw, address)
        assert isinstance(node, Record)
        values = {key: value for key, value in raw.items() if key in node.names}
        return Fields(node.cls, self._object(node.fields, values, address), spread=True)

    def _default_of(self, node: "Node", raw: "Raw") -> str | None:
        """The default text of a kind that is never missing: gravity, from the environment or the standard value."""
        kind = node.kind if isinstance(node, Leaf) else None
        if kind is None or not kind.default or (kind.needs and not raw.get(kind.needs)):
            return None
        return self.environ.get(kind.variable) or kind.default

    def _missing(self, field: Field, node: Leaf, address: str) -> None:
        example, spelled = None, self.spell(address)
        if node.kind.example and "[" in address:
            example = f"for example {address.rpartition('.')[2]}={node.kind.example}"
        elif node.kind.example:
            name = f"{spelled} " if spelled.startswith("--") and not field.place else ""
            example = f"for example {name}{_quoted(node.kind.example)}"
        if node.choice is not None:
            example = f"one of {', '.join(node.choice.names)}"
        pointer = self.pointers.get(address.rpartition(".")[2])
        if pointer and example:
            example = f"{example}; {pointer}"
        expected = field.meaning or node.kind.about or node.kind.name
        self._fail(address, f"{spelled} is missing: {expected}", code="missing", hint=example)

    def _item(self, node: "Node", value: "Any", address: str) -> Bound | None:
        if isinstance(node, Leaf):
            try:
                if node.kind.form in FREE:
                    from dynamics_cli.core.inputs.free_kinds import read_free

                    return read_free(node.kind, value, address, self)
                return read_leaf(node, value, address, self)
            except DynamicsError as error:
                error.parameter = error.parameter or address
                self.errors.append(error)
                return None
        if isinstance(value, str) and not isinstance(value, Token):
            value = self._pairs(value, address, node)
            if value is None:
                return None
        if not isinstance(value, dict):
            self._fail(address, f"{address}: read {value!r}, wanted named values", hint="an object such as {…}")
            return None
        if isinstance(node, Record):
            return Fields(node.cls, self._object(node.fields, self.named(node.names, value), address))
        wrapper = Field("", node, ())
        if isinstance(node, Tagged):
            return self._tagged(wrapper, node, value, address, alone=True)
        assert isinstance(node, OneOf)
        return self._one_of(wrapper, node, value, address, alone=True)

    def _pairs(self, text: str, address: str, node: "Node") -> "dict[str, Any] | None":
        from dynamics_cli.core.inputs.forms.leading import pairs_of
        from dynamics_cli.core.inputs.forms.splitting import PAIRS

        try:
            return pairs_of(text, node)
        except DynamicsError as error:
            error.parameter = error.parameter or address
            error.hint = f"example: {written(node)}" if error.hint == PAIRS and written(node) else error.hint
            self.errors.append(error)
            return None

    def _one_of(self, field: Field, node: OneOf, raw: "Raw", address: str, *, alone: bool = False) -> Bound | None:
        names = {name for member in node.members for name in member.names}
        present = [key for key in raw if raw[key] is not None and (alone or key in names)]
        if not present:
            if field.required or alone:
                self._fail(
                    _join(address, min(node.members[0].required, default=field.key)),
                    self._of_item(address, f"one of these is missing: {self._choices(node, address)}"),
                    code="missing",
                )
            return None
        fits = [member for member in node.members if member.names.issuperset(present)]
        if not fits:
            self._fail(
                _join(address, present[0]),
                self._of_item(
                    address, f"{' and '.join(self._member(address, name) for name in present)} cannot be given together"
                ),
                code="exclusive",
                hint=f"give {self._choices(node, address)}",
            )
            return None
        complete = [member for member in fits if member.required.issubset(present)]
        if not complete and len(fits) > 1:
            alternatives = (
                " and ".join(self._member(address, name) for name in sorted(fit.required.difference(present)))
                for fit in fits
            )
            message = self._of_item(address, f"one of these is missing: {', or '.join(alternatives)}")
            beside = " and ".join(self._member(address, name) for name in present)
            missing = min(fits[0].required.difference(present))
            self._fail(_join(address, missing), message, code="missing", hint=f"it goes with {beside}")
            return None
        member = (complete or fits)[0]
        fields = self._object(member.fields, {key: raw[key] for key in present}, address)
        return Fields(member.cls, fields, spread=not alone)

    def _choices(self, node: OneOf, address: str) -> str:
        """What the alternatives need, as the caller writes it."""
        return ", or ".join(
            " and ".join(self._member(address, name) for name in sorted(member.required)) or "nothing"
            for member in node.members
        )

    def _member(self, address: str, name: str) -> str:
        """A field as the caller writes it; a field of a list's item by its own name."""
        return kebab(name) if "[" in address else self.spell(_join(address, name))

    def _of_item(self, address: str, message: str) -> str:
        return f"{self.spell(address)}: {message}" if "[" in address else message

    def _tagged(self, field: Field, node: Tagged, raw: "Raw", address: str, *, alone: bool = False) -> Bound | None:
        tag = raw.get(node.key)
        place = _join(address, node.key)
        names = node.names
        if tag is None:
            if field.required or alone or any(raw.get(name) is not None for name in names):
                self._fail(
                    place, f"{self.spell(place)} is missing", code="missing", hint=f"one of {', '.join(node.members)}"
                )
            return None
        member = node.member(kebab(str(tag).strip().lower().replace(" ", "-")))
        if member is None:
            from dynamics_cli.core.units.near_names import nearest_words

            begun = [name for name in node.members if name.startswith(str(tag).strip().lower())]
            near = list(dict.fromkeys([*nearest_words(str(tag), node.members), *begun]))[:3]
            hint = f"one of {', '.join(node.members)}"
            if len(node.members) > MANY_CHOICES:
                hint = f"--help lists all {len(node.members)}"
            if near:
                hint = f"did you mean {' or '.join(near)}?"
            self._fail(place, f"there is no {node.key} {str(tag)!r}", code="unknown-choice", hint=hint)
            return None
        values = {key: value for key, value in raw.items() if key != node.key and (alone or key in names)}
        before = len(self.errors)
        fields = self._object(member.fields, values, address)
        for error in self.errors[before:]:
            instead = getattr(member.cls, "instead", {}).get(str(error.parameter).rpartition(".")[2])
            error.hint = instead or error.hint
        return Fields(member.cls, fields, spread=not alone, tag=member.cls.tag)  # type: ignore[attr-defined]

    def _many(self, field: Field, node: Many, raw: "Raw", address: str) -> Bound | None:
        field_address = _join(address, field.key)
        value = raw.get(field.key)
        plain = [key for key in raw if raw[key] is not None and key in node.plain]
        if value is not None and plain and not getattr(getattr(node.item, "cls", None), "adds", False):
            self._fail(
                field_address,
                f"{self.spell(field_address)} and {self._member(address, plain[0])} cannot be given together",
                code="exclusive",
            )
            return None
        if value is None and (plain or field.required) and node.by_plain(plain):
            return self._spread(Field("", node.item, ()), node.item, {key: raw[key] for key in plain}, address)
        if value is None:
            if field.required:
                message = f"{self.spell(field_address)} is missing{field.meaning and ': '}{field.meaning}"
                self._fail(field_address, message, code="missing")
            return None
        from dynamics_cli.core.inputs.forms.lists import items_of

        try:
            items = items_of(node, value, field_address, self)
        except DynamicsError as error:
            error.parameter = error.parameter or field_address
            self.errors.append(error)
            return None
        if not items and field.place != "words":
            self._fail(field_address, f"{self.spell(field_address)} is empty", code="missing")
            return None
        if plain:
            # items that add up, such as forces: the one of plain options is one more
            items = [*items, {key: raw[key] for key in plain}]
        items_read = [self._item(node.item, item, f"{field_address}[{index}]") for index, item in enumerate(items)]
        bound_items = [item for item in items_read if item is not None]
        if node.single and isinstance(node.item, Leaf) and len(bound_items) == 1 and not isinstance(value, list):
            return bound_items[0]
        row = node.item.cls if node.columns and isinstance(node.item, Record) else None
        return Several(bound_items, row)


def _join(address: str, key: str) -> str:
    return f"{address}.{key}" if address else key


def _with_example(hint: str | None, field: Field) -> str | None:
    """A hint that ends with the example of a kind, with that of the field itself in its place."""
    node = field.node.item if isinstance(field.node, Many) else field.node
    usual, said = (node.kind.example, field.example) if isinstance(node, Leaf) else ("", "")
    if not (hint and usual and said):
        return hint
    for ending in (_quoted(usual), usual):
        if hint.endswith(" " + ending):
            return hint.removesuffix(ending) + (_quoted(said) if " --" in hint else said)
    return hint


def _quoted(text: str) -> str:
    return f'"{text}"' if " " in text or ";" in text else text
