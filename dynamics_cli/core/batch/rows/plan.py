"""Many rows answered by few calls of the physics: the inputs of one row as template, arrays in place of its numbers.

Formulas that branch on their numbers split the rows by branch (`numerics.lanes`). Physics that takes no arrays
is called row by row with the template's inputs, which saves reading each row and writing it.

Rows that this cannot answer (refused by physics, a number out of range or bounds) are left to the single call, which
also writes the error message. A division by zero or an overflow counts as well, since numpy continues where Python
raises: the rows are halved until the one that causes it is found.
"""

import numpy as np

from dynamics_cli.core.answering.models import arguments, choose
from dynamics_cli.core.answering.task import Model, load
from dynamics_cli.core.batch.rows.answered import constant, kept, scaled, shown, shown_factor, texts_of, written
from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.rows.cautions import Extremes
from dynamics_cli.core.batch.text.columns import Slot
from dynamics_cli.core.batch.text.weaving import Unsuited
from dynamics_cli.core.inputs.values import Bound, Exact, Fields, Several, Value, VectorValue
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.errors import DynamicsError, InadmissibleError
from dynamics_cli.numerics.lanes import Part as LanePart
from dynamics_cli.numerics.lanes import parts
from dynamics_cli.numerics.number import plain
from dynamics_cli.records import Check, Columns, Measured, Numerics, Quantity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.batch.text.weaving import Answered
    from dynamics_cli.core.output.row_layout import Part

    Array = NDArray[Any]
    Mask = NDArray[Any]


# The unit that such a result is shown in depends on its numbers.
OWN_UNITS = ("measured", "components")


def _is_fixed(fixed: "dict[str, Any]", address: str) -> bool:
    """Whether the call itself gives the value of a column at this address."""
    inner: Any = fixed
    for step in address.split("."):
        name = step.partition("[")[0]
        if not isinstance(inner, dict):
            return True
        if name not in inner:
            return False
        inner = inner[name]
    return True


class Plan:
    """How rows of one kind are answered: the template's inputs, where its numbers go, and the model."""

    written = staticmethod(written)
    texts_of = staticmethod(texts_of)

    def __init__(
        self, case: Case, raw: "dict[str, Any]", addresses: "Sequence[str]", units: "Sequence[str | None]"
    ) -> None:
        self.case = case
        # Branches whose first and last rows have been compared with single calls.
        self.proved: set[tuple[Any, ...]] = set()
        self.failures = 0
        self.bound = case.bind(raw)
        leaves = {bound.address: bound for bound in values_of(self.bound)}
        self._leaves = {address: leaf for leaf in leaves.values() for address, _, _ in leaf.leaves()}
        # A list of one item may be given by that item alone, a vector of one component by its number.
        alone = {name.replace("[0]", ""): name for name, leaf in leaves.items() if isinstance(leaf, Value)}
        alone |= {name: f"{name}[0]" for name in leaves if f"{name}[0]" in self._leaves}
        addresses = [name if name in self._leaves else alone.get(name, name) for name in addresses]
        self._leaves |= {address: leaf for address, leaf in leaves.items() if isinstance(leaf, Exact)}
        unknown = [address for address in addresses if address not in self._leaves]
        if unknown or not addresses:
            raise Unsuited(f"{unknown} are not numbers that arrays can stand for", set(self._leaves))
        self.addresses = list(addresses)
        self.slots = [self._slot(address, unit) for address, unit in zip(addresses, units, strict=True)]
        # Whether the physics takes arrays; known once it has been tried.
        self.lanes = True
        self._constants = {address: si for address, _, si in self.bound.leaves()}
        self._mirrored = list(self._mirrors())
        self._scales = [shown_factor(part.shown) for part in case.layout.parts]
        self._extremes = Extremes()

    def _mirrors(self) -> "Iterator[tuple[str, str]]":
        """Elements of tensors that must be equal; nearly equal ones are left to the single call."""
        for leaf in values_of(self.bound):
            if leaf.kind.form == "tensor":
                for i, j in ((0, 1), (0, 2), (1, 2)):
                    yield f"{leaf.address}[{i}][{j}]", f"{leaf.address}[{j}][{i}]"

    def _slot(self, address: str, unit: "str | None") -> Slot:
        leaf = self._leaves[address]
        if _is_fixed(self.case.fixed, address):
            raise Unsuited(f"{address} is fixed by the call", set(self._leaves) - {address})
        if isinstance(leaf, Exact):
            return Slot(address, leaf.kind, parse_unit(leaf.value.unit))
        if isinstance(leaf, VectorValue) and unit is not None and unit != leaf.unit:
            raise Unsuited(f"{address} has components in several units")
        kind = leaf.kind
        base_unit = parse_unit(kind.unit)
        given_unit = parse_unit(leaf.unit, base_unit)
        if given_unit.dimension != base_unit.dimension:
            raise Unsuited(f"{address} needs a reader of its own")
        return Slot(address, kind, given_unit)

    def _model(self, values: "dict[str, Any]") -> Model:
        """The smallest model that suffices, with arrays in place of numbers."""
        task = self.case.task
        if len(task.models) > 1 and not self.case.asked:
            args, kwargs = arguments(task, self.bound, values)
            for model in task.models[:-1]:
                if load(model.suffices)(*args, **kwargs) is not None:
                    return model
            return task.models[-1]
        return choose(task, self.bound, self.case.asked)[0]

    def _record(self, values: "dict[str, Any]") -> "Any":
        args, kwargs = arguments(self.case.task, self.bound, values)
        return self._model(values).call()(*args, **kwargs)

    def run(self, columns: "Sequence[Any]") -> "list[Answered]":
        """The results of all rows that can be answered together, grouped by branch; the others are left out."""
        count = len(columns[0].tokens)
        arrays: dict[str, Array] = {}
        bad: Mask = np.zeros(count, dtype=bool)
        for slot, column in zip(self.slots, columns, strict=True):
            # Where a row gives a parameter twice, the later place (an earlier step's result) wins.
            arrays[slot.address], odd = slot.read(column)
            if odd is not None:
                bad |= odd
        for key, mirror in self._mirrored:
            bad |= arrays.get(key, self._constants[key]) != arrays.get(mirror, self._constants[mirror])
        rows = np.flatnonzero(~bad) if bad.any() else np.arange(count)
        if bad.any():
            arrays = {name: array[rows] for name, array in arrays.items()}
        if len(rows):
            self._note_cautions(arrays)
        answered = self._by_lanes(arrays, len(rows)) if self.lanes else self._one_by_one(arrays)
        for part in answered:
            part.rows = rows[part.rows]
        return answered

    def _note_cautions(self, arrays: "dict[str, Array]") -> None:
        for row in self._extremes.rows(arrays):
            try:
                self.case.note(self._record({name: float(array[row]) for name, array in arrays.items()}), self.bound)
            except (DynamicsError, ArithmeticError, ValueError):
                continue  # the single call words it

    def _by_lanes(self, arrays: "dict[str, Array]", count: int) -> "list[Answered]":
        try:
            with np.errstate(divide="raise", over="raise", invalid="raise", under="ignore"):
                all_answered = map(self._taken, parts(self._record, arrays, np.arange(count), _refused))
                return [answered for answered in all_answered if answered is not None]
        except Unsuited:
            self.lanes = False
            return self._one_by_one(arrays)

    def _taken(self, part: LanePart) -> "Answered | None":
        """The results of rows that took the same branch."""
        good = _finite(part.outcome, len(part.rows))
        if not good.any():
            return None
        rows, record = part.rows, part.outcome
        columns: list[tuple[Part, str, Any]] = []
        for layout, factor in zip(self.case.layout.parts, self._scales, strict=True):
            value = layout.of(record)
            if layout.how in OWN_UNITS and value is not None:
                columns.append(_measured(layout, value, good))
                continue
            if not isinstance(value, np.ndarray) or not value.ndim:
                columns.append((layout, "all", constant(layout, record)))
                continue
            if value.shape != rows.shape:
                raise Unsuited(f"{layout.address} is no column")
            columns.append((layout, "each", shown(value, layout, factor, good)))
        return kept(rows, columns, good, part.trail)

    def _one_by_one(self, arrays: "dict[str, Array]") -> "list[Answered]":
        """Each row by its own call; rows with the same set of results are written together."""
        layout = self.case.layout
        alike: dict[tuple[bool, ...], tuple[list[int], list[list[Any]]]] = {}
        names = list(arrays)
        for row, numbers in enumerate(zip(*(array.tolist() for array in arrays.values()), strict=True)):
            try:
                record = self._record(dict(zip(names, numbers, strict=True)))
                layout.check(record)
            except (DynamicsError, ArithmeticError, ValueError):
                continue  # the single call words it
            values = [part.of(record) for part in layout.parts]
            rows, lists = alike.setdefault(tuple([value is None for value in values]), ([], []))
            rows.append(row)
            lists.append(values)
        return [
            answered
            for missing, (rows, lists) in alike.items()
            if (answered := self._listed(missing, rows, lists)) is not None
        ]

    def _listed(self, missing: "tuple[bool, ...]", rows: "list[int]", lists: "list[list[Any]]") -> "Answered | None":
        columns: list[tuple[Part, str, Any]] = []
        good = np.ones(len(rows), dtype=bool)
        for part, factor, absent, values in zip(
            self.case.layout.parts, self._scales, missing, zip(*lists, strict=True), strict=True
        ):
            if part.how in OWN_UNITS and not absent:
                raise Unsuited("results that carry their own units are written one by one")
            if absent:
                columns.append((part, "all", None))
            elif part.how == "number":
                numbers = np.array([float(plain(value)) for value in values])
                columns.append((part, "each", shown(numbers, part, factor, good)))
            else:
                cells = np.empty(len(values), dtype=object)
                cells[:] = [str(value) if part.how == "word" else value for value in values]
                columns.append((part, "each", cells))
        return kept(np.array(rows), columns, good, missing)


def _measured(part: "Part", value: "Any", good: "Mask") -> "tuple[Part, str, Any]":
    """A column of results that carry their own unit, the same in all rows."""
    assert part.display is not None
    if isinstance(value, Quantity):
        show = part.display.of(part.address, value.kind)
        if show.compound:
            raise Unsuited("a number of several units is written one by one")
        numbers = value.value if isinstance(value.value, tuple) else (value.value,)
        columns = [np.broadcast_to(np.asarray(number, dtype=float), good.shape) for number in numbers]
        return part, "measured", ([scaled(column, show, shown_factor(show), good) for column in columns], [show.text])
    if part.display.to or part.display.system == "base" or not isinstance(value, Measured):
        raise Unsuited("results whose units depend on their numbers are written one by one")
    if isinstance(value.value, np.ndarray):
        return part, "measured", ([np.asarray(value.value)], [value.unit])
    return part, "all", value


def _refused(error: Exception) -> "Any":
    """Which lanes an error is about: see `numerics.lanes.parts`."""
    if isinstance(error, InadmissibleError):
        return True if error.refused is None else error.refused
    if isinstance(error, Unsuited):
        raise error
    if isinstance(error, DynamicsError):
        return True
    # An array that is not one of lanes was asked for its truth value.
    if isinstance(error, ArithmeticError | ValueError) and "ambiguous" not in str(error):
        return None
    raise Unsuited(f"the physics does not take arrays: {error}") from error


def _finite(node: "Any", count: int) -> "Mask":
    """Mask of the rows with finite numbers throughout the record and all checks passed."""
    good = np.ones(count, dtype=bool)
    for item in _below(node):
        if isinstance(item, Check):
            good &= np.asarray(item.passed, dtype=bool)
        elif isinstance(item, np.ndarray):
            if item.ndim and item.shape != good.shape:
                raise Unsuited("a number of the record has no column")
            if item.dtype.kind == "f":
                good &= np.isfinite(np.asarray(item))
        elif isinstance(item, float) and not -np.inf < item < np.inf:
            good[:] = False
    return good


def _below(node: "Any") -> "Iterator[Any]":
    if isinstance(node, Columns):
        raise Unsuited("the task's answer is a table")
    if isinstance(node, tuple | list):
        for item in node:
            yield from _below(item)
    elif isinstance(node, Check) or not hasattr(node, "fields"):
        yield node
    elif not isinstance(node, Numerics):
        for name in node.fields:
            yield from _below(getattr(node, name))


def values_of(bound: Bound) -> "Iterator[Value | VectorValue | Exact]":
    """Every number and vector among the inputs as read; of magnitude and direction each."""
    if isinstance(bound, VectorValue) and bound.parts:
        yield from bound.parts
    elif isinstance(bound, Value | VectorValue | Exact):
        yield bound
    elif isinstance(bound, Fields):
        for item in bound.fields.values():
            yield from values_of(item)
    elif isinstance(bound, Several):
        for item in bound.items:
            yield from values_of(item)
