"""Inputs as read: a tree that offers its numbers by address, accepts other numbers in their place, and can be shown.

The tree mirrors the signature. `assemble` converts it into the arguments of the physics function; with `values` it puts
floats, arrays or tracked numbers at chosen addresses, for sweeps, rows, sensitivities and uncertainty.
"""

from dynamics_cli.quantities import Kind
from dynamics_cli.records import ExactQuantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping
    from typing import Any

    Values = Mapping[str, Any]

NOTHING: "Values" = {}


class Bound:
    """One node of the inputs as read; `spread`: its fields appear beside its siblings in the document."""

    spread = False

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """The function's argument, with `values` in place of the numbers at their addresses."""
        raise TypeError

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """Every number: its address, kind and SI value."""
        return iter(())

    def echo(self) -> "Any":
        """The input as the document shows it."""
        raise TypeError


class Value(Bound):
    """A number: its SI value, and the number and unit as written; `parts`: the numbers and units of `5 ft 6 in`."""

    def __init__(
        self, address: str, kind: Kind, si: float, shown: "Any", unit: str, parts: "tuple[Any, str] | None" = None
    ) -> None:
        self.address = address
        self.kind = kind
        self.si = si
        self.shown = shown
        self.unit = unit
        self.parts = parts

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """The SI value, or its substitute."""
        return values.get(self.address, self.si)

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """This one number."""
        yield self.address, self.kind, self.si

    def echo(self) -> "Any":
        """Number and unit as written."""
        shown, unit = self.parts or (self.shown, self.unit)
        return {"value": shown, "unit": unit} if unit else {"value": shown}


class VectorValue(Bound):
    """A vector or tensor: SI components by index (`position[0]`), and as written; its `parts` if in another way."""

    parts: "tuple[Value, ...]" = ()

    def __init__(self, address: str, kind: Kind, si: "tuple[Any, ...]", shown: "Any", unit: str) -> None:
        self.address = address
        self.kind = kind
        self.si = si
        self.shown = shown
        self.unit = unit

    def _walk(self, part: "Any", address: str) -> "Iterator[tuple[str, float]]":
        for index, item in enumerate(part):
            name = f"{address}[{index}]"
            if isinstance(item, tuple):
                yield from self._walk(item, name)
            else:
                yield name, item

    def _replace(self, part: "Any", address: str, values: "Values") -> "Any":
        if not isinstance(part, tuple):
            return values.get(address, part)
        return tuple(self._replace(item, f"{address}[{index}]", values) for index, item in enumerate(part))

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """Nested tuples of components."""
        return self._replace(self.si, self.address, values)

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """Every component."""
        for address, value in self._walk(self.si, self.address):
            yield address, self.kind, value

    def echo(self) -> "Any":
        """Components and unit as written."""
        return {"value": self.shown, "unit": self.unit} if self.unit else {"value": self.shown}


class PolarVector(VectorValue):
    """A vector in the x–y plane by magnitude and direction, which may have distributions."""

    def __init__(self, address: str, kind: "Kind", magnitude: Value, direction: Value) -> None:
        self.parts = magnitude, direction
        self.kind = kind
        si = PolarVector.assemble(self)
        super().__init__(address, kind, si, list(si), kind.unit)

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """Both components, and a third that is zero where the kind has three."""
        from dynamics_cli.numerics.turns import turned

        size, angle = (part.assemble(values) for part in self.parts)
        cosine, sine = turned(angle)
        return size * cosine, size * sine, *[0.0 * size] * (self.kind.size - 2)

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """The magnitude and the direction."""
        for part in self.parts:
            yield from part.leaves()

    def echo(self) -> "Any":
        """The JSON form, which reads back: nominal components, magnitude and direction."""
        magnitude, direction = self.parts
        return {**super().echo(), "magnitude": magnitude.echo(), "direction": direction.echo()}


class TypedPolar(PolarVector):
    """Certain components of a planar vector that was written by magnitude and direction, and is shown so."""

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """Both components: those of another magnitude or direction where rows give them."""
        typed = any(part.address in values for part in self.parts)
        return PolarVector.assemble(self, values) if typed else VectorValue.assemble(self, values)

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """Both components."""
        return VectorValue.leaves(self)


class Constant(Bound):
    """Anything that is not a real number: words, choices, counts, flags, files, exact quantities."""

    def __init__(self, value: "Any", shown: "Any") -> None:
        self.value = value
        self.shown = shown

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """The value itself."""
        return self.value

    def echo(self) -> "Any":
        """The value as the document shows it."""
        return self.shown


class Exact(Constant):
    """An exact quantity: a ratio and its unit, or in SI the numbers of many rows in its place."""

    def __init__(self, address: str, kind: Kind, value: ExactQuantity, shown: "Any") -> None:
        super().__init__(value, shown)
        self.address = address
        self.kind = kind

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """The quantity, or its substitute."""
        numbers = values.get(self.address)
        return self.value if numbers is None else ExactQuantity(0, 1, self.value.unit, self.value.text, numbers)


class Fields(Bound):
    """A record (or, without a class, the parameters of a task), with key and tag when it is one of a tagged union.

    Those of a task know how the caller writes them (`spell`).
    """

    spell: "Callable[[str], str]" = staticmethod(str)

    def __init__(
        self,
        cls: "type | None",
        fields: "dict[str, Bound]",
        *,
        spread: bool = False,
        tag: "tuple[str, str] | None" = None,
    ) -> None:
        self.cls = cls
        self.fields = fields
        self.spread = spread
        self.tag = tag

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """The record, or a dictionary of parameters."""
        members = {name: bound.assemble(values) for name, bound in self.fields.items()}
        return members if self.cls is None else self.cls(**members)

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """Every number below."""
        for bound in self.fields.values():
            yield from bound.leaves()

    def echo(self) -> "Any":
        """A dictionary by key, in which spread fields are not nested."""
        out: dict[str, Any] = {} if self.tag is None else {self.tag[0]: self.tag[1]}
        for name, bound in self.fields.items():
            if bound.spread:
                out.update(bound.echo())
            else:
                out[name.rstrip("_")] = bound.echo()
        return out


class Several(Bound):
    """A tuple of items, or the columns of a table when `columns` names the row's class."""

    def __init__(self, items: "list[Bound]", columns: "type | None" = None) -> None:
        self.items = items
        self.columns = columns

    def assemble(self, values: "Values" = NOTHING) -> "Any":
        """A tuple of items, or columns."""
        items = tuple(item.assemble(values) for item in self.items)
        if self.columns is None:
            return items
        import numpy as np

        from dynamics_cli.records import Columns

        names = self.columns.fields  # type: ignore[attr-defined]
        return Columns(self.columns, **{name: np.array([getattr(row, name) for row in items]) for name in names})

    def leaves(self) -> "Iterator[tuple[str, Kind, float]]":
        """Every number below."""
        for item in self.items:
            yield from item.leaves()

    def echo(self) -> "Any":
        """A list."""
        return [item.echo() for item in self.items]
