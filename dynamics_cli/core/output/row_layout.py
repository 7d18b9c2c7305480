"""Which results a row carries: the record's numbers, flags and choices; tables, checks and advice stay out."""

from dynamics_cli.core.inputs.specification import Leaf, Many, Record
from dynamics_cli.core.json_text import quote
from dynamics_cli.core.output.soundness import check_numbers
from dynamics_cli.core.units.display import Display, Shown
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.number import plain
from dynamics_cli.records import Advice, Check, Measured, Numerics, Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any


def compact(value: "Any") -> str:
    """JSON without superfluous spaces; a value that JSON does not have is written as its `repr`."""
    if isinstance(value, dict):
        return "{" + ",".join([f"{quote(str(key))}:{compact(item)}" for key, item in value.items()]) + "}"
    if isinstance(value, list | tuple):
        return "[" + ",".join(map(compact, value)) + "]"
    if isinstance(value, str):
        return quote(value)
    if value is True or value is False or value is None:
        return {True: "true", False: "false", None: "null"}[value]
    return repr(value)


class Part:
    """One result: its place in the record, how it is shown, and its columns.

    `how` is "number", "whole", "flag", "word", "measured" (a number or several, each with a unit of its own) or
    "components" (of a vector with a unit of its own).
    """

    # Whether it stands in the entry of another result.
    beside = False

    __slots__ = ("address", "display", "how", "keys", "several", "shown", "steps", "unit")

    def __init__(
        self, keys: "tuple[str, ...]", steps: "tuple[str | int, ...]", how: str, shown: Shown | None = None
    ) -> None:
        self.keys = keys
        self.steps = steps
        self.how = how
        self.shown = shown
        self.unit = shown.text if shown is not None else ""
        self.several = False
        # Display of a result whose own unit may be replaced by another.
        self.display: Display | None = None
        self.address = ""
        for step in steps:
            self.address += f"[{step}]" if isinstance(step, int) else f".{step.rstrip('_')}"
        self.address = self.address.lstrip(".")

    def of(self, record: "Any") -> "Any":
        """The result in a record, in SI, or None."""
        for step in self.steps:
            if record is None:
                return None
            record = record[step] if isinstance(step, int) else getattr(record, step)
        return record

    def value(self, record: "Any") -> "Any":
        """The result as it is shown: a number, a list for compound units, a flag, a word or None."""
        value = self.of(record)
        if value is None:
            return None
        if isinstance(value, Quantity):
            return self._of_quantity(value)
        if self.how == "measured":
            show = self.display
            return value if show is None or isinstance(value, tuple) else show.of_measured(self.address, value)
        if self.how == "number":
            number = plain(value)
            return number if self.shown is None else self.shown.value(float(number))
        return str(value) if self.how == "word" else value

    def _of_quantity(self, quantity: Quantity) -> Measured:
        assert self.display is not None
        shown = self.display.of(self.address, quantity.kind)
        value = quantity.value
        several = isinstance(value, tuple)
        numbers = [shown.value(float(plain(number))) for number in (value if several else (value,))]
        return Measured(tuple(numbers) if several else numbers[0], shown.text)  # type: ignore[arg-type]

    @property
    def names(self) -> "list[tuple[str, str]]":
        """Its columns: name and unit; a planar vector leaves its third empty."""
        if self.how == "components":
            return [(f"{self.address}{end}", "") for end in ("[0]", "[1]", "[2]", ".unit")]
        if self.how == "measured" and not self.unit:
            return [(self.address, ""), (f"{self.address}.unit", "")]
        units = self.unit.split(";")
        if len(units) == 1:
            return [(self.address, self.unit)]
        return [(f"{self.address}[{i}]", unit.strip()) for i, unit in enumerate(units)]

    def cells(self, value: "Any") -> "list[str]":
        """Its cells in CSV."""
        if value is None:
            return [""] * len(self.names)
        if self.how == "components":
            return [*(self.numbers(value) + ["", ""])[:3], value.unit]
        if self.how == "measured":
            numbers, units = _measured(value)
            if self.unit:
                return [compact(number) for number in numbers]
            return [";".join(map(compact, numbers)), ";".join(units)]
        if self.how == "word":
            return [str(value)]
        return [compact(item) for item in value] if isinstance(value, list) else [compact(value)]

    def numbers(self, value: "Any") -> "list[str]":
        """Its numbers in a line of text."""
        if self.how in ("flag", "word"):
            return []
        if self.how in ("measured", "components"):
            return [compact(number) for number in _measured(value)[0]] if value is not None else []
        return self.cells(value)

    def add_to(self, entry: "dict[str, Any]", value: "Any") -> None:
        """Add it to the entry of the result that it stands beside, under the last name of its address."""
        entry[self.address.rpartition(".")[2]] = value

    def entry(self, value: "Any") -> "Any":
        """Its entry in JSON."""
        if value is None or self.how in ("flag", "word"):
            return value
        if self.how not in ("measured", "components"):
            return {"value": value, "unit": self.unit} if self.unit else {"value": value}
        if isinstance(value, tuple):
            return [self.entry(item) for item in value]
        entry_value = list(value.value) if isinstance(value.value, tuple) else value.value
        return {"value": entry_value, "unit": value.unit} if value.unit else {"value": entry_value}


class SpreadPart(Part):
    """One number of an uncertain result's distribution: `which` says which."""

    beside = True

    __slots__ = ("of_result", "which")

    def __init__(self, part: Part, which: str) -> None:
        super().__init__(part.keys, part.steps, "number", part.shown)
        indices = [step for step in part.steps if isinstance(step, int)]
        self.of_result = ".".join(part.keys) + "".join(f"[{index}]" for index in indices)
        self.which = which
        self.address = f"{part.address}.{which}"

    def of(self, record: "Any") -> "Any":
        """Nothing: a certain result has no distribution; the case fills it in."""
        return None

    def shown_value(self, si: float) -> "Any":
        """A number of the distribution as it is shown; a deviation is a difference."""
        if si - si != 0.0:
            return None
        assert self.shown is not None
        return self.shown.width(si) if self.which == "std" else self.shown.value(si)

    def add_to(self, entry: "dict[str, Any]", value: "Any") -> None:
        """Add it to the result's entry, as in a document: for a vector, in lists like its value."""
        indices = [step for step in self.steps if isinstance(step, int)]
        if not indices and self.which in ("low", "high"):
            entry.setdefault("interval", []).append(value)
        elif not indices:
            entry[self.which] = value
        elif self.which in ("low", "high"):
            nested(entry.setdefault("interval", [[], []])[self.which == "high"], indices).append(value)
        else:
            nested(entry.setdefault(self.which, []), indices).append(value)


SPREAD = ("mean", "median", "std", "low", "high")


def _measured(value: "Any") -> "tuple[list[float], list[str]]":
    items: Sequence[Measured] = value if isinstance(value, tuple) else (value,)
    numbers = [number for item in items for number in (item.value if isinstance(item.value, tuple) else (item.value,))]
    return numbers, [item.unit for item in items]


class Layout:
    """The results of a task's rows, in order; `targets` are the units of measured results where the call fixes them.

    With `spread` every number has those of its distribution after it; without `words` there are none.
    """

    def __init__(
        self,
        result: Record,
        display: Display,
        targets: "list[str] | None" = None,
        *,
        spread: bool = False,
        words: bool = True,
    ) -> None:
        self.result = result
        self._words = words
        self.display = display
        self.targets = targets
        self.spread = spread
        self._known: list[str] = []
        self.parts = list(self._record(result, (), ()))
        display.check(self._known)

    def narrow(self, names: "list[str]") -> None:
        """Keep the results of these names, or within them, in their order; refuses a name that no row has."""
        chosen_parts: dict[int, Part] = {}
        for name in names:
            chosen = {id(part): part for part in self.parts if name in _names_of(part)}
            if not chosen:
                known = dict.fromkeys(".".join(part.keys) for part in self.parts)
                hint = f"results of rows are {', '.join(known)}"
                raise UsageError(f"rows have no result {name!r}", parameter="only", code="unknown-result", hint=hint)
            chosen_parts.update(chosen)
        self.parts = list(chosen_parts.values())

    def _record(self, spec: Record, keys: "tuple[str, ...]", steps: "tuple[str | int, ...]") -> "Iterator[Part]":
        for field in spec.fields:
            node = field.node
            field_keys, path = (*keys, field.key), (*steps, field.name)
            if isinstance(node, Leaf):
                yield from self._leaf(node, field_keys, path)
            elif isinstance(node, Record) and node.cls is not Numerics:
                yield from self._record(node, field_keys, path)
            elif isinstance(node, Many):
                yield from self._many(node, field_keys, path)

    def _leaf(self, leaf: Leaf, keys: "tuple[str, ...]", steps: "tuple[Any, ...]") -> "Iterator[Part]":
        form = leaf.kind.form
        address = ".".join(keys)
        if form == "measured":
            yield from self._measured(keys, steps, several=False)
        elif form == "flag":
            yield Part(keys, steps, "flag")
        elif leaf.choice is not None or form in ("text", "unit"):
            if self._words and leaf.kind.name != "remark":
                yield Part(keys, steps, "word")
        elif form in ("file", "drawing", "matrix"):
            return
        elif form in ("free", "free vector"):
            yield from self._measured(keys, steps, several=False, how="measured" if form == "free" else "components")
        elif form == "whole":
            self._known.append(address)
            yield Part(keys, steps, "whole")
        else:
            self._known.append(address)
            shown = self.display.of(address, leaf.kind)
            indices: list[tuple[int, ...]] = [()]
            if form in ("vector", "planar"):
                indices = [(i,) for i in range(leaf.kind.size)]
            elif form == "tensor":
                indices = [(i, j) for i in range(leaf.kind.size) for j in range(leaf.kind.size)]
            for index in indices:
                part = Part(keys, (*steps, *index), "number", shown)
                yield part
                if self.spread and ";" not in part.unit and (not index or leaf.kind.unit):
                    yield from (SpreadPart(part, which) for which in SPREAD)

    def _many(self, node: Many, keys: "tuple[str, ...]", steps: "tuple[Any, ...]") -> "Iterator[Part]":
        item = node.item
        if isinstance(item, Leaf) and item.kind.form == "measured":
            yield from self._measured(keys, steps, several=True)
        elif isinstance(item, Record) and item.cls not in (Check, Advice):
            # A table does not fit into a row, but `--to` may still name its columns.
            _use(self._record(item, keys, steps))
        elif isinstance(item, Leaf) and item.kind.form in ("scalar", "slope"):
            self._known.append(".".join(keys))
            self.display.of(".".join(keys), item.kind)

    def _measured(
        self, keys: "tuple[str, ...]", steps: "tuple[Any, ...]", *, several: bool, how: str = "measured"
    ) -> "Iterator[Part]":
        if self.targets is None:
            part = Part(keys, steps, how)
            part.several, part.display = several, self.display
            self._known.append(part.address)
            # `--to` is looked at when there is a value.
            self.display.used.update(self.display.to.keys() & {part.address})
            yield part
        elif several == (len(self.targets) > 1):
            for index, target in enumerate(self.targets):
                path = (*steps, index) if several else steps
                part = Part(keys, path, "measured")
                part.unit = target
                yield part

    def values(self, record: "Any") -> "list[Any]":
        """Values of a row from a record; refuses numbers that are not finite, as a single call does."""
        self.check(record)
        return [part.value(record) for part in self.parts]

    def check(self, record: "Any") -> None:
        """Refuse numbers that are not finite, and a failed internal check."""
        check_numbers(record, self.result, "")

    def entries(self, values: "Sequence[Any]") -> "dict[str, Any]":
        """The results as an object, results that do not exist left out."""
        results: dict[str, Any] = {}
        for part, value in zip(self.parts, values, strict=True):
            if value is None:
                continue
            inner = results
            for key in part.keys[:-1]:
                inner = inner.setdefault(key, {})
            if part.beside:
                part.add_to(inner[part.keys[-1]], value)
            else:
                _place(inner, part, value)
        return results


def _names_of(part: Part) -> "set[str]":
    """The names that select a result: its own, that of its vector, and those of the records that contain it."""
    return {".".join(part.keys[:end]) for end in range(1, len(part.keys) + 1)}


def _use(parts: "Iterator[Part]") -> None:
    for _ in parts:
        pass


def _place(inner: "dict[str, Any]", part: Part, value: "Any") -> None:
    key = part.keys[-1]
    index = [step for step in part.steps if isinstance(step, int)]
    entry = part.entry(value)
    if not index:
        inner[key] = entry
        return
    if part.how == "measured":
        inner.setdefault(key, []).append(entry)
        return
    entry_here = inner.setdefault(key, {**entry, "value": []} if entry is not None else {"value": []})
    nested(entry_here["value"], index).append(value)


def nested(nest: "list[Any]", index: "Sequence[int]") -> "list[Any]":
    """The list for a component's place, created if missing; components come in order."""
    for step in index[:-1]:
        if len(nest) == step:
            nest.append([])
        nest = nest[step]
    return nest
