"""Many rows answered by one call of the physics: the inputs of one row as template, arrays in place of its numbers.

Whatever an array cannot settle (a row that physics refuses, a number out of range or bounds) is left to the single
call, which also words the error. A division by zero or an overflow anywhere counts as that too, since numpy would go on
where Python stops: the rows are halved until the one that does it is alone.
"""

import numpy as np

from dynamics_cli.core.answering.models import arguments, call_model, choose
from dynamics_cli.core.answering.task import Model, load
from dynamics_cli.core.batch.rows.case import Case
from dynamics_cli.core.batch.text.columns import Column, Slot, Unsuited, joined_texts, texts
from dynamics_cli.core.inputs.values import Bound, Fields, Several, Value, VectorValue
from dynamics_cli.core.output.row_layout import Part, compact
from dynamics_cli.core.units.display import Shown
from dynamics_cli.core.units.lookup import parse_unit
from dynamics_cli.errors import DynamicsError, InadmissibleError, UsageError
from dynamics_cli.numerics.exact.factors import Factor, scale
from dynamics_cli.records import Check, Columns

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[Any]
    Mask = NDArray[Any]
    # (part, "each", one text a row), (part, "measured", (texts, unit)) or (part, "all", the value of every row).
    Result = tuple[Part, str, Any]

# Fewer rows than this are not worth another array call.
FEWEST = 16
MOST_REFUSALS = 24
NAN = float("nan")
VARIES = object()


class Untouchable:
    """Stands for a number that a choice of model may pass on but not look at."""

    def _touched(self, *_: object) -> "Any":
        raise Unsuited("the choice of model depends on the numbers")

    __bool__ = __float__ = __int__ = __eq__ = __ne__ = __lt__ = __le__ = __gt__ = __ge__ = _touched
    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _touched
    __neg__ = __abs__ = __pow__ = __getattr__ = _touched
    __hash__ = None  # type: ignore[assignment]


def _is_fixed(fixed: "dict[str, Any]", address: str) -> bool:
    """Whether the call itself gives what a column at this address would."""
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
    """How rows of one make are answered: the template's inputs, where its numbers go, and the model."""

    def __init__(
        self, case: Case, raw: "dict[str, Any]", addresses: "Sequence[str]", units: "Sequence[str | None]"
    ) -> None:
        self.case = case
        self.proved = False
        self.failures = 0
        self.bound = case.bind(raw)
        leaves = {bound.address: bound for bound in values_of(self.bound)}
        self._leaves = {address: leaves[_owner(address, leaves)] for address, _, _ in self.bound.leaves()}
        unknown = [address for address in addresses if address not in self._leaves]
        if unknown or not addresses:
            raise Unsuited(f"{unknown} are not numbers that arrays can stand for", set(self._leaves))
        self.addresses = list(addresses)
        self.slots = [self._slot(address, unit) for address, unit in zip(addresses, units, strict=True)]
        self.model = self._model()
        self._scales = [_shown_factor(part.shown) for part in case.layout.parts]

    def _slot(self, address: str, unit: "str | None") -> Slot:
        leaf = self._leaves[address]
        if _is_fixed(self.case.fixed, address):
            raise Unsuited(f"{address} is fixed by the call", set(self._leaves) - {address})
        if isinstance(leaf, VectorValue) and unit is not None and unit != leaf.unit:
            raise Unsuited(f"{address} has components in several units")
        kind = leaf.kind
        wanted = parse_unit(kind.unit)
        read = parse_unit(leaf.unit, wanted)
        if read.dimension != wanted.dimension:
            raise Unsuited(f"{address} is read in a way of its own")
        return Slot(address, kind, read)

    def _model(self) -> Model:
        task = self.case.task
        if len(task.models) > 1 and not self.case.asked:
            args, kwargs = arguments(task, self.bound, {address: Untouchable() for address in self.addresses})
            for model in task.models[:-1]:
                if load(model.suffices)(*args, **kwargs) is not None:
                    return model
            return task.models[-1]
        return choose(task, self.bound, self.case.asked)[0]

    def run(self, columns: "list[Column]") -> "tuple[list[Result], Mask | None]":
        """The results of all rows that can be answered together, and which these are (None: all)."""
        count = len(columns[0].tokens)
        arrays: dict[str, Array] = {}
        bad: Mask | None = None
        for slot, column in zip(self.slots, columns, strict=True):
            # Where a row gives a parameter twice, the later place (an earlier step's result) wins.
            arrays[slot.address], odd = slot.read(column)
            if odd is not None:
                bad = odd if bad is None else bad | odd
        good = np.ones(count, dtype=bool) if bad is None else ~bad
        found = _Found(self, count)
        rows = np.flatnonzero(good)
        found.evaluate(arrays if bad is None else {name: array[rows] for name, array in arrays.items()}, rows, 0)
        return found.results(), None if found.good.all() else found.good


class _Found:
    """Results gathered from one or several array calls."""

    def __init__(self, plan: Plan, count: int) -> None:
        self.plan = plan
        self.good = np.zeros(count, dtype=bool)
        self.constant: list[Any] = []
        self.arrays: dict[int, Any] = {}

    def evaluate(self, arrays: "dict[str, Array]", rows: "NDArray[np.int64]", depth: int) -> None:
        """Answer some rows; those that cannot be answered stay marked as bad."""
        if not len(rows) or depth > MOST_REFUSALS:
            return
        plan = self.plan
        try:
            with np.errstate(divide="raise", over="raise", invalid="raise", under="ignore"):
                record = call_model(plan.case.task, plan.model, plan.bound, arrays)
        except InadmissibleError as error:
            refused = error.refused
            if isinstance(refused, np.ndarray) and refused.shape == rows.shape and refused.any():
                kept = ~refused
                self.evaluate({name: array[kept] for name, array in arrays.items()}, rows[kept], depth + 1)
                return
            self._halve(arrays, rows, depth)
        except Unsuited:
            raise
        except (DynamicsError, ArithmeticError, ValueError):
            self._halve(arrays, rows, depth)
        except (TypeError, AttributeError) as error:
            raise Unsuited(f"the physics does not take arrays: {error}") from None
        else:
            self._take(record, rows)

    def _halve(self, arrays: "dict[str, Array]", rows: "NDArray[np.int64]", depth: int) -> None:
        if len(rows) <= FEWEST:
            return
        middle = len(rows) // 2
        for part in (slice(None, middle), slice(middle, None)):
            self.evaluate({name: array[part] for name, array in arrays.items()}, rows[part], depth + 1)

    def _take(self, record: "Any", rows: "NDArray[np.int64]") -> None:
        good = _finite(record, len(rows))
        if not good.any():
            return
        layout = self.plan.case.layout
        constant: list[Any] = []
        for index, (part, factor) in enumerate(zip(layout.parts, self.plan._scales, strict=True)):
            found = part.of(record)
            if not isinstance(found, np.ndarray) or not found.ndim:
                constant.append(_constant(part, record))
                continue
            if found.shape != rows.shape or part.how == "word":
                raise Unsuited(f"{part.address} is no column")
            constant.append(VARIES)
            shown = _shown(found, part, factor, good)
            if len(rows) == len(self.good):
                self.arrays[index] = shown
            else:
                whole = self.arrays.setdefault(index, np.zeros(len(self.good), dtype=shown.dtype))
                whole[rows] = shown
        if self.constant and [item is VARIES for item in constant] != [item is VARIES for item in self.constant]:
            raise Unsuited("results exist for some rows only")
        # Values that are alike in all rows of one call may differ between calls.
        if self.constant and any(a != b for a, b in zip(constant, self.constant, strict=True) if a is not VARIES):
            raise Unsuited("results differ between calls")
        self.constant = constant
        self.good[rows] = good

    def results(self) -> "list[Result]":
        """The results for the rows that are good."""
        made: list[Result] = []
        everything = self.good.all()
        for index, (part, value) in enumerate(zip(self.plan.case.layout.parts, self.constant, strict=False)):
            if value is not VARIES:
                made.append((part, "all", value))
                continue
            array = self.arrays[index]
            made.append((part, "each", array if everything else array[self.good]))
        return made


def _constant(part: Part, record: "Any") -> "Any":
    try:
        return part.value(record)
    except UsageError as error:
        raise Unsuited(error.message) from None


def _shown(found: "Any", part: Part, factor: "Factor | None", good: "Mask") -> "Any":
    """A column of results as it is shown: doubles, or what a compound unit or a flag is written as."""
    if part.how != "number":
        return found.astype(object)
    values = found.astype(float)
    if part.shown is None or (factor is not None and factor.is_one):
        return values
    if factor is None:
        return _mapped(values, part.shown, good)
    with np.errstate(all="ignore"):
        made = scale(np.where(good, values, 0.0), factor, _one_by_one(part.shown))
    lost = np.isnan(made)
    if lost.any():
        good &= ~lost
        made[lost] = 0.0
    return made


def _one_by_one(shown: Shown) -> "Any":
    def one(value: float) -> "Any":
        try:
            return shown.value(value)
        except UsageError:
            return NAN

    return one


def _mapped(values: "Array", shown: Shown, good: "Mask") -> "Any":
    made = np.empty(len(values), dtype=object)
    one = _one_by_one(shown)
    for row in np.flatnonzero(good).tolist():
        made[row] = one(float(values[row]))
        if made[row] != made[row]:
            good[row] = False
    return made


def _shown_factor(shown: "Shown | None") -> "Factor | None":
    """From SI to the unit shown; None where it takes more than a factor."""
    if shown is None or shown.compound:
        return None
    unit = shown.unit
    if unit is None:
        return Factor(1, 1)
    if shown.kind.form == "slope" and unit.text != "%":
        return None
    shift, over = unit.offset
    return Factor(unit.denominator, unit.numerator, -unit.pi, (-shift * unit.denominator, over * unit.numerator))


def _finite(node: "Any", count: int) -> "Mask":
    """Where every number below a record is finite and every check has passed."""
    good = np.ones(count, dtype=bool)
    for item in _below(node):
        if isinstance(item, Check):
            good &= np.asarray(item.passed, dtype=bool)
        elif isinstance(item, np.ndarray):
            if item.dtype.kind == "f":
                good &= np.isfinite(item)
        elif isinstance(item, float) and not -np.inf < item < np.inf:
            good[:] = False
    return good


def _below(node: "Any") -> "Iterator[Any]":
    if isinstance(node, Columns):
        raise Unsuited("the task answers with a table of its own")
    if isinstance(node, tuple | list):
        for item in node:
            yield from _below(item)
    elif isinstance(node, Check) or not hasattr(node, "fields"):
        yield node
    else:
        for name in node.fields:
            yield from _below(getattr(node, name))


def values_of(bound: Bound) -> "Iterator[Value | VectorValue]":
    """Every number and vector among the inputs as read."""
    if isinstance(bound, Value | VectorValue):
        yield bound
    elif isinstance(bound, Fields):
        for item in bound.fields.values():
            yield from values_of(item)
    elif isinstance(bound, Several):
        for item in bound.items:
            yield from values_of(item)


def _owner(address: str, leaves: "dict[str, Value | VectorValue]") -> str:
    while address not in leaves:
        address = address.rpartition("[")[0]
    return address


def written(results: "list[Result]", form: str) -> "list[Result]":
    """Columns as texts: the shortest text of every number, flags and compound numbers as the format writes them."""
    made: list[Result] = []
    side: list[Array] = []
    for part, how, value in results:
        if how == "each" and isinstance(value, np.ndarray):
            if value.dtype == object:
                value = _listed(value.tolist(), part, form)
            elif form == "csv":
                # Neighbours are written together, which saves a cut and a join a row.
                side.append(value)
                if len(side) > 1:
                    made.pop()
                made.append((part, how, side))
                continue
            else:
                value = texts(value)
        side = []
        made.append((part, how, value))
    return [
        (part, how, joined_texts(value) if how == "each" and value and isinstance(value[0], np.ndarray) else value)
        for part, how, value in made
    ]


def _listed(rows: "list[Any]", part: Part, form: str) -> "list[bytes]":
    if form == "ndjson":
        return [compact(row).encode() for row in rows]
    separator = "," if form == "csv" else "\t"
    return [separator.join(part.cells(row)).encode() for row in rows]
