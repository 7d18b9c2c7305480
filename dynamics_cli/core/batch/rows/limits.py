"""`--limit` in rows and sweeps: beside a result whether it exceeds the limit, or how probably."""

from dynamics_cli.core.answering.limits import limited
from dynamics_cli.core.output.row_layout import Part, SpreadPart
from dynamics_cli.errors import UsageError
from dynamics_cli.numerics.number import plain, single
from dynamics_cli.records import Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from dynamics_cli.core.batch.text.weaving import Result
    from dynamics_cli.core.inputs.quantity_text import Reading
    from dynamics_cli.quantities import Kind


class Limit:
    """A limit, and the result that it is for."""

    def __init__(self, result: str, kind: "Kind", reading: "Reading") -> None:
        self.result = result
        self.kind = kind
        self.value = reading.si
        self.shown = {"value": reading.value, "unit": reading.unit} if reading.unit else {"value": reading.value}
        self.text = f"{result.replace('_', ' ')} exceeds {reading.value:g} {reading.unit}".rstrip()


class LimitPart(Part):
    """Whether a result exceeds its limit; of uncertain results the probability that it does."""

    beside = True

    __slots__ = ("limit", "probable")

    def __init__(self, part: Part, limit: Limit, *, probable: bool, nth: int) -> None:
        super().__init__(part.keys, part.steps, "number" if probable else "flag")
        self.limit = limit
        self.probable = probable
        name = ("limit_probability" if probable else "limit_exceeded") + (f"_{nth}" if nth > 1 else "")
        self.address = f"{part.address}.{name}"

    def of(self, record: "Any") -> "Any":
        """The verdict on the nominal result, of an array one for each of its numbers."""
        value = super().of(record)
        if isinstance(value, Quantity):
            value = value.value if value.kind.unit == self.limit.kind.unit else None
        if value is None:
            return None
        exceeded = plain(value) > self.limit.value
        if not single(exceeded):
            return exceeded
        return float(exceeded) if self.probable else bool(exceeded)

    def value(self, record: "Any") -> "Any":
        """The verdict, as it is shown."""
        return self.of(record)

    def exceeded(self, value: "Any", above: float) -> bool:
        """Whether a row's verdict is that the limit is exceeded, by a probability above this one."""
        return bool(value is not None and value > above) if self.probable else bool(value)


def read_limits(
    asked: "Sequence[tuple[str, str]]", parts: "Sequence[Part]", present: "dict[str, Kind]"
) -> "tuple[Limit, ...]":
    """The limits of all rows; one without a name is for the first result of those present that it can apply to."""
    every = {part.address: part.shown.kind for part in parts if part.shown is not None and _is_single(part)}
    kinds = {**every, **present}
    limits = []
    for name, text in asked:
        if name and name not in kinds:
            from dynamics_cli.core.units.near_names import instead_of

            hint = instead_of(name, kinds)
            raise UsageError(f"there is no result {name!r}", parameter="limit", hint=hint, code="unknown-result")
        limits.append(Limit(*limited(text, {name: kinds[name]} if name else present or every)))
    return tuple(limits)


def _is_single(part: Part) -> bool:
    return part.how == "number" and not isinstance(part, SpreadPart) and not isinstance(part.steps[-1], int)


def with_limits(parts: "Sequence[Part]", limits: "Sequence[Limit]", *, probable: bool) -> "Iterator[Part]":
    """The parts of a row, each result's limits after it and its distribution."""
    for place, part in enumerate(parts):
        yield part
        after = parts[place + 1] if place + 1 < len(parts) else None
        if after is None or after.keys != part.keys:
            own = (limit for limit in limits if limit.result == ".".join(part.keys))
            result = next(other for other in parts if other.keys == part.keys)
            for nth, limit in enumerate(own, 1):
                yield LimitPart(result, limit, probable=probable, nth=nth)


def exceeded_limits(parts: "Sequence[Part]", values: "Sequence[Any]", above: float) -> "dict[str, int]":
    """The limits that a row exceeds, each once."""
    every = zip(parts, values, strict=True)
    return {part.limit.text: 1 for part, value in every if isinstance(part, LimitPart) and part.exceeded(value, above)}


def exceeded_counts(results: "list[Result]", count: int) -> "dict[str, int]":
    """How many of the rows that arrays have answered exceed each limit."""
    return {
        part.limit.text: sum(map(bool, value)) if how == "each" else count * bool(value)
        for part, how, value in results
        if isinstance(part, LimitPart)
    }
