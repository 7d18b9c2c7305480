"""A task as a model on arrays: physics functions called with whole samples; refused cases are masked and left out."""

import numpy as np

from dynamics_cli.core.answering.models import arguments, result_numbers
from dynamics_cli.core.answering.task import load
from dynamics_cli.errors import DynamicsError, FaultError, InadmissibleError
from dynamics_cli.numerics.lanes import FEWEST, Lanes, parts
from dynamics_cli.numerics.number import plain
from dynamics_cli.progress import going
from dynamics_cli.sampling import Drawing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.answering.task import Model, Task
    from dynamics_cli.core.inputs.specification import Record
    from dynamics_cli.core.inputs.values import Fields

    Array = NDArray[Any]

# How often a formula may refuse further rows, for one reason after another.
MOST_REFUSALS = 20
# Rounding of other numbers: some dozens of last bits. And a relative deviation smaller than any measured input has: the
# second where cases are integrated or solved one by one, each to no more digits than a sample needs.
ROUNDING, STEADY, SOLVED = 1e-14, 1e-12, 1e-8
_FUNCTIONS: "dict[str, Callable[..., Any]]" = {
    "sqrt": np.sqrt, "sin": np.sin, "cos": np.cos, "tan": np.tan, "asin": np.arcsin, "acos": np.arccos,
    "sinh": np.sinh, "cosh": np.cosh, "tanh": np.tanh,
    "pi": lambda x: np.pi, "atan": np.arctan, "exp": np.exp, "log": np.log, "atan2": np.arctan2, "hypot": np.hypot,
    "multiply_add": lambda a, b, c: a * b + c, "maximum": np.maximum, "minimum": np.minimum,
}  # fmt: skip


class Sampled(np.ndarray):
    """An array that goes through `numerics.elementary` in numpy's own loops.

    Rows must equal single answers to the bit, so ordinary arrays are mapped through the C library value by value. A
    sample does not need that: a last bit is negligible beside its spread, and the loops are many times faster.
    """

    def apply(self, name: str, *arguments: "Any") -> "Any":
        """The elementary function `name`."""
        return _FUNCTIONS[name](*arguments)


class _Branching(Lanes):
    """Samples of a formula that branches on its numbers."""

    apply = Sampled.apply


def _noise(record: "Any", spec: "Record", bound: "Fields", steady: float) -> "dict[str, float]":
    """Error of the results, as their arithmetic or a solver states it: a variation within it is not real.

    A result that may be zero at the means, within its error or as a component of a vector, has elsewhere the rounding
    of the numbers it came from: results with its unit, or the other components.
    """
    bounds = {stated.result: stated for stated in getattr(getattr(record, "numerics", None), "bounds", ())}
    numbers = [(name, kind, value, abs(float(plain(value)))) for name, kind, value in result_numbers(record, spec)]
    # an angle of zero has the rounding of whole directions
    sizes = {"rad": 1.0}
    for name, size in (
        *((kind.unit, abs(si)) for _, kind, si in bound.leaves() if kind.unit),
        *((kind.unit, size) for _, kind, _, size in numbers if kind.unit),
        *((name.partition("[")[0], size) for name, _, _, size in numbers if "[" in name),
    ):
        sizes[name] = max(size, sizes.get(name, 0.0))
    noise = {}
    for name, kind, value, size in numbers:
        stem = name.partition("[")[0]
        own = float(getattr(value, "error", None) or 0.0)
        if stem in bounds:
            own = max(own, bounds[stem].bound * (size if bounds[stem].relative else 1.0))
        others = max(sizes.get(stem, 0.0), sizes.get(kind.unit, 0.0) if size <= own else 0.0)
        noise[name] = max(own, steady * size, ROUNDING * others)
    return noise


class TaskModel:
    """The model of a task at the inputs as read, with arrays at the uncertain addresses."""

    def __init__(self, task: "Task", model: "Model", bound: "Fields", nominal: "Any") -> None:
        self.task = task
        self.bound = bound
        self.function = model.call()
        self.together = load(model.together) if model.together else None
        self.spec = task.specification.result
        self.names = [name for name, _, _ in result_numbers(nominal, self.spec) if name not in task.unspread]
        # how many there are, of which a call may want a few
        self.results = len(self.names)
        self.headline = {address for address, _ in task.headline}
        self.kinds = {address: kind for address, kind, _ in bound.leaves()}
        self.noise = _noise(nominal, self.spec, bound, STEADY if task.arrays else SOLVED)
        self.arrays = task.arrays
        self.branches = task.branches or task.arrays
        self.drawing = Drawing()
        self.drawing.each = task.cost

    @property
    def missed(self) -> float:
        """What samples are off by where physics does not solve each of them, in their deviations."""
        return self.drawing.missed

    def __call__(self, inputs: "dict[str, Any]") -> "tuple[dict[str, Any], Any]":
        """Results by address, and which rows are inadmissible."""
        arrays = {name: value for name, value in inputs.items() if isinstance(value, np.ndarray)}
        count = len(next(iter(arrays.values()))) if arrays else 1
        if not count or not self.names:  # without an admissible point or a result there is nothing to evaluate
            return {name: np.empty(0) for name in self.names}, None
        refused = self._outside(arrays, count)
        if not self.arrays or not arrays:
            return self._one_by_one(inputs, arrays, count, refused)
        kept = None if refused is None else np.nonzero(~refused)[0]
        for _ in range(MOST_REFUSALS):
            if kept is not None and not kept.size:
                return dict.fromkeys(self.names, np.nan), np.ones(count, dtype=bool)
            try:
                results = self._call(inputs, arrays, kept)
            except InadmissibleError as error:
                if error.refused is None:
                    raise
                bad = np.broadcast_to(np.asarray(error.refused, dtype=bool), count if kept is None else kept.shape)
                kept = np.nonzero(~bad)[0] if kept is None else kept[~bad]
                continue
            except (TypeError, ValueError):
                # a formula that branches on a sample's truth value
                self.arrays = False
                return self._one_by_one(inputs, arrays, count, refused)
            return (results, None) if kept is None else self._spread(results, kept, count)
        raise FaultError("the formula keeps refusing rows")

    def _call(self, inputs: "dict[str, Any]", arrays: "dict[str, Array]", kept: "Any") -> "dict[str, Any]":
        values = dict(inputs)
        for name, array in arrays.items():
            values[name] = (array if kept is None else array[kept]).view(Sampled)
        args, kwargs = arguments(self.task, self.bound, values)
        with self.drawing:
            record = self.function(*args, **kwargs)
        numbers = {name: np.asarray(value, dtype=float) for name, _, value in result_numbers(record, self.spec)}
        if not numbers.keys() >= set(self.names):
            raise ValueError("results that only a single case has")
        return {name: numbers[name] for name in self.names}

    def _numbers(self, record: "Any") -> "dict[str, Any]":
        """The results that are wanted, as far as a record has them."""
        return {name: value for name, _, value in result_numbers(record, self.spec) if name in self.names}

    def _spread(self, results: "dict[str, Any]", kept: "Any", count: int) -> "tuple[dict[str, Any], Any]":
        refused = np.ones(count, dtype=bool)
        refused[kept] = False
        arrays = {}
        for name, value in results.items():
            arrays[name] = np.full(count, np.nan)
            arrays[name][kept] = value
        return arrays, refused

    def _outside(self, arrays: "dict[str, Array]", count: int) -> "Any":
        """Rows with inputs outside their kind's bounds (a negative friction) or undefined, or None."""
        refused = None
        for name, array in arrays.items():
            kind = self.kinds[name]
            if np.isnan(array.sum()):
                bad = np.isnan(array)
                refused = bad if refused is None else refused | bad
            for bound, low in ((kind.low, True), (kind.above, True), (kind.high, False), (kind.below, False)):
                if bound is None:
                    continue
                extreme = array.min() if low else array.max()
                open_ = bound == (kind.above if low else kind.below)
                if (extreme > bound if low else extreme < bound) or (extreme == bound and not open_):
                    continue
                apart = array - bound if low else bound - array
                bad = apart <= 0.0 if open_ else apart < 0.0
                refused = bad if refused is None else refused | bad
        return refused

    def _answers(self, cases: "Iterable[tuple[list[Any], dict[str, Any]]]") -> "Iterator[Any]":
        """The record of each case, or the error that refuses it."""
        if self.together:
            with self.drawing:
                words = self.task.specification.words
                yield from self.together(
                    [dict(zip((word.name for word in words), args, strict=False)) | named for args, named in cases]
                )
            return
        for args, kwargs in cases:
            try:
                with self.drawing:
                    record = self.function(*args, **kwargs)
            except (DynamicsError, ArithmeticError) as error:
                record = error
            yield record

    def _one_by_one(
        self, inputs: "dict[str, Any]", arrays: "dict[str, Array]", count: int, refused: "Any"
    ) -> "tuple[dict[str, Any], Any]":
        bad = np.zeros(count, dtype=bool) if refused is None else refused.copy()
        results = {name: np.full(count, np.nan) for name in self.names}
        columns = {name: array.tolist() for name, array in arrays.items()}
        alone = ~bad
        open_ = np.nonzero(alone)[0]
        if self.branches and len(open_) >= FEWEST:
            alone[self._side_by_side(inputs, arrays, open_, results)] = False
            # where most go their own way, the search for others on it costs more than it saves
            self.branches = self.task.branches or bool(2 * np.count_nonzero(alone) < len(open_))
        rows = np.nonzero(alone)[0].tolist()
        self.drawing.spent += self.task.cost * len(rows)
        cases = (
            arguments(self.task, self.bound, {**inputs, **{name: column[row] for name, column in columns.items()}})
            for row in rows
        )
        with going(len(rows), "cases of uncertain inputs") as progress:
            for done, (row, record) in enumerate(zip(rows, self._answers(cases), strict=True), 1):
                progress(done)
                if isinstance(record, Exception):
                    bad[row] = True
                    continue
                for name, _, value in result_numbers(record, self.spec):
                    if name in results:
                        results[name][row] = value
        return results, bad if bad.any() else None

    def _side_by_side(
        self, inputs: "dict[str, Any]", arrays: "dict[str, Array]", rows: "Any", results: "dict[str, Array]"
    ) -> "Any":
        """Put the results of all rows into their places that take the same branches as enough others; those rows."""

        def record_of(lanes: "dict[str, Any]") -> "Any":
            args, kwargs = arguments(self.task, self.bound, {**inputs, **lanes})
            with self.drawing:
                return self.function(*args, **kwargs)

        done = [np.empty(0, dtype=int)]
        try:
            with np.errstate(divide="raise", over="raise", invalid="raise", under="ignore"):
                for part in parts(record_of, arrays, rows, _refused, _Branching):
                    numbers = self._numbers(part.outcome)
                    if len(numbers) < len(self.names):
                        # a branch without this result, or physics that gives it to single cases only?
                        first = record_of({name: float(array[part.rows[0]]) for name, array in arrays.items()})
                        if self._numbers(first).keys() - numbers.keys():
                            continue
                    for name, value in numbers.items():
                        results[name][part.rows] = value
                    done.append(part.rows)
        except (TypeError, ValueError, AttributeError, LookupError):
            # physics that takes no arrays at all
            return done[0]
        return np.concatenate(done)


def _refused(error: Exception) -> "Any":
    """Rows that a formula refuses are answered one by one, which finds out what each of them is refused for."""
    if isinstance(error, InadmissibleError) and error.refused is not None:
        return error.refused
    if isinstance(error, DynamicsError):
        return True
    if isinstance(error, ArithmeticError):
        return None
    raise error
