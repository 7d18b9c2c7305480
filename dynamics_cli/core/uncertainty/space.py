"""The space an uncertain calculation is integrated in: independent standard normals z, and the model on them.

All methods see only `Space.evaluate`: points (inputs, n) in, results (results, n) out, with
NaN where the model is inadmissible. NaN stays inside; callers see a fraction of inadmissible cases.
"""

from decimal import Decimal, localcontext

import numpy as np

from dynamics_cli.errors import FaultError, UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.core.inputs.uncertain.distributions import Distribution

    Array = NDArray[Any]
    Correlation = Mapping[tuple[str, str], float]
    # Results by name, and the rows that are inadmissible (or None).
    Model = Callable[[dict[str, Any]], tuple[dict[str, Any], Any]]

# With more results than this, those that turn, jump or have kinks share one sample.
FEW_RESULTS = 4
# Arrays of more points leave the processor's cache, which costs more than twice the time a point.
LARGEST_BLOCK = 1 << 13
# Cases at which it is looked whether an input bears on a result: a branch taken in one of a hundred shows.
BEARING_CASES = 256
# Cases before all others.
REHEARSED = 128
# Sets of points whose results are kept.
MOST_KNOWN = 4096
# Seconds of a usual processor that an expensive model may take for its samples. One that can answer fewer cases than
# the second in this time gives a sample of as many as it can, but not fewer than the third.
BUDGET, COSTLY, FEWEST = 4.0, 100_000, 64
# A pivot smaller than this is a correlation of ±1 as rounded, not a negative one.
_PIVOT = 1e-12


class Space:
    """Uncertain inputs, their correlation, and the model; counts the points it is asked for."""

    def __init__(self, model: "Model", distributions: "Mapping[str, Distribution]", correlation: "Correlation") -> None:
        self.model = model
        self.fixed = {
            name: distribution.mean for name, distribution in distributions.items() if distribution.std == 0.0
        }
        self.names = [name for name in distributions if name not in self.fixed]
        self.distributions = [distributions[name] for name in self.names]
        self.factor = factor(self.names, correlation, set(distributions))
        self.smooth = all(distribution.smooth for distribution in self.distributions)
        self.stepped = any(distribution.name == "empirical" for distribution in self.distributions)
        # Without a finite variance of an input (Student's t of two or three readings) the result has usually none
        # either.
        self.heavy = any(distribution.std == np.inf for distribution in self.distributions)
        self.results: list[str] = []
        # error of the values, by result
        self.noise: Mapping[str, float] = getattr(model, "noise", {})
        self.points = 0
        # Whether any case was refused; a result may also be missing from an admissible one.
        self.refuses = False
        # A model called case by case is expensive, and its results are often needed at the same points.
        self.slow = not getattr(model, "arrays", True)
        # One that answers many cases at once: thousands together cost little more than a hundred.
        self.together = self.slow and getattr(model, "together", None) is not None
        self._known: dict[bytes, Array] | None = {} if self.slow else None
        # The sample that results share, once one of them needs it.
        self.pool: Any = None
        # The results, by row, that are whole numbers at every point looked at.
        self.whole: set[int] = set()
        # The results that the sample is for (all of them, or the rest).
        self.open: Sequence[int] | None = None
        # By result, its direction and the outcome of grids where that is known already.
        self.started: dict[int, tuple[Array, Any]] = {}

    @property
    def size(self) -> int:
        """Number of uncertain inputs."""
        return len(self.names)

    @property
    def partial(self) -> bool:
        """Whether only some of the model's results are asked for."""
        return len(self.results) < getattr(self.model, "results", 0)

    @property
    def several(self) -> bool:
        """Whether the model has more than a few results, however many of them are asked for."""
        return max(len(self.results), getattr(self.model, "results", 0)) > FEW_RESULTS

    @property
    def missed(self) -> float:
        """What the model's samples are off by, in their deviations."""
        return float(getattr(self.model, "missed", 0.0))

    @property
    def affordable(self) -> int | None:
        """Cases that one more call of an expensive model may have; None of one that is not."""
        stated = getattr(self.model, "drawing", None)
        if stated is None or COSTLY * stated.each < BUDGET:
            return None
        return max(int(max(BUDGET - stated.spent - stated.once, 0.5 * BUDGET) / stated.each), FEWEST)

    def headline(self, rows: "Iterable[int]") -> bool:
        """Whether some results are among those that a short answer shows; where none is named, all are."""
        shown = getattr(self.model, "headline", ())
        return not shown or any(self.results[row].partition("[")[0] in shown for row in rows)

    def rehearse(self, seed: int) -> None:
        """A fair sample before all others, for models that solve something over the spread of their samples once."""
        if not self.slow:
            self.evaluate(np.random.default_rng(seed).standard_normal((self.size, REHEARSED)))
            self.points = 0

    def inputs(self, z: "Array") -> "dict[str, Any]":
        """The inputs at points z, by address."""
        return self.inputs_of(z if self.factor is None else self.factor @ z)

    def inputs_of(self, scores: "Array") -> "dict[str, Any]":
        """The inputs from their own (possibly correlated) normal scores."""
        inputs: dict[str, Any] = dict(self.fixed)
        for name, distribution, score in zip(self.names, self.distributions, scores, strict=True):
            inputs[name] = distribution.at(score)
        return inputs

    def evaluate(self, z: "Array") -> "Array":
        """Every result at points z (inputs, n): an array (results, n), NaN where inadmissible."""
        count = z.shape[1]
        if count > LARGEST_BLOCK:
            first = self.evaluate(z[:, :LARGEST_BLOCK])
            whole = np.empty((len(first), count))
            whole[:, :LARGEST_BLOCK] = first
            for start in range(LARGEST_BLOCK, count, LARGEST_BLOCK):
                whole[:, start : start + LARGEST_BLOCK] = self.evaluate(z[:, start : start + LARGEST_BLOCK])
            return whole
        if self._known is None:
            return self.evaluate_inputs(self.inputs(z), count)
        key = z.tobytes()
        known = self._known.get(key)
        if known is None:
            known = self.evaluate_inputs(self.inputs(z), count)
            if len(self._known) < MOST_KNOWN:
                self._known[key] = known
        return known

    def values(self, z: "Array", result: int) -> "Array":
        """One result at points z."""
        values: Array = self.some(z, [result])[0]
        return values

    def some(self, z: "Array", rows: "Sequence[int]", made: "Array | None" = None) -> "Array":
        """Some results at points z (rows, n), or into an array: what others need is not kept."""
        made = np.empty((len(rows), z.shape[1])) if made is None else made
        if self._known is not None:
            made[:] = self.evaluate(z)[rows]
            return made
        for start in range(0, z.shape[1], LARGEST_BLOCK):
            part = z[:, start : start + LARGEST_BLOCK]
            count = part.shape[1]
            self.evaluate_inputs(self.inputs(part), count, made[:, start : start + count], rows)
        return made

    def rest(self) -> "Sequence[int]":
        """The results, by row, that shared lines and samples are for."""
        return range(len(self.results)) if self.open is None else self.open

    def evaluate_inputs(
        self, inputs: "dict[str, Any]", count: int, made: "Array | None" = None, rows: "Sequence[int]" = ()
    ) -> "Array":
        """Every result at given cases of the inputs; or those of some rows, into an array."""
        self.points += count
        if not count and self.results:
            return np.empty((len(self.results), 0))
        with np.errstate(all="ignore"):
            results, refused = self.model(inputs)
        if not self.results:
            self.results = list(results)
        if made is None:
            rows = range(len(self.results))
            made = np.empty((len(rows), count))
        for line, row in zip(made, rows, strict=True):
            line[:] = results[self.results[row]]
        if refused is not None:
            self.refuses = True
            made[:, refused] = np.nan
        if not np.isfinite(made.sum()):
            made[~np.isfinite(made)] = np.nan
        return made


def bearing(space: Space, uniform: "Array") -> "Array":
    """Whether each axis bears on each result (results, axes), at points of which another half replaces an axis."""
    z, other = np.split(uniform, 2, axis=1)
    cases = [z]
    for axis in range(space.size):
        cases.append(z.copy())
        cases[-1][axis] = other[axis]
    values = space.evaluate(np.concatenate(cases, axis=1)).reshape(-1, space.size + 1, z.shape[1])
    one, rest = values[:, :1], values[:, 1:]
    return ~((one == rest) | (np.isnan(one) & np.isnan(rest))).all(axis=2)  # type: ignore[no-any-return]


def factor(names: "Sequence[str]", correlation: "Correlation", known: "set[str]") -> "Array | None":
    """The lower triangle L with L·Lᵀ = the correlation of the normal scores; None when nothing is correlated."""
    matrix = np.eye(len(names))
    for (one, other), rho in correlation.items():
        for name in (one, other):
            if name not in known:
                hint = f"uncertain inputs are {', '.join(known)}" if known else "no input is uncertain"
                raise UsageError(f"{name!r} is not an uncertain input", parameter="correlate", hint=hint)
        if one == other or not -1.0 <= rho <= 1.0:
            raise UsageError(
                f"a correlation of {rho:g} between {one} and {other} cannot be",
                parameter="correlate",
                hint="it is between -1 and 1, of two different inputs",
            )
        if one in names and other in names:
            i, j = names.index(one), names.index(other)
            matrix[i, j] = matrix[j, i] = rho
    if not (matrix - np.eye(len(names))).any():
        return None
    lower = _cholesky(matrix)
    if lower is None:
        _refuse(names, matrix)
    return lower


def positive(matrix: "Array") -> bool:
    """Whether a matrix is a possible correlation matrix."""
    return _cholesky(matrix) is not None


def _cholesky(matrix: "Array") -> "Array | None":
    """A triangular factor that allows pivots of zero (correlations of ±1); None when a pivot is negative.

    A pivot such as 1 − ρ² keeps few digits of a ρ next to one, and is the variance of what then cancels: pivots are
    calculated in 40 digits.
    """
    rows: list[dict[int, Decimal]] = []
    with localcontext(prec=40):
        for i, line in enumerate(matrix):
            row: dict[int, Decimal] = {}
            for j, entry in enumerate(line[: i + 1]):
                other = rows[j] if j < i else row
                shared = row.keys() & other.keys()
                rest = Decimal(float(entry)) - sum((row[k] * other[k] for k in shared), Decimal(0))
                if j < i:
                    if j in other:
                        row[j] = rest / other[j]
                    elif abs(rest) > np.sqrt(_PIVOT):
                        return None
                elif rest < -_PIVOT:
                    return None
                elif rest > _PIVOT:
                    row[j] = rest.sqrt()
            rows.append(row)
    lower = np.zeros_like(matrix)
    for i, row in enumerate(rows):
        for j, value in row.items():
            lower[i, j] = float(value)
    return lower


def _refuse(names: "Sequence[str]", matrix: "Array") -> None:
    """Name the pair without which the least eigenvalue would be largest, and the range that it may have."""
    best, pair = -np.inf, (0, 1)
    for i in range(len(names)):
        for j in range(i):
            if matrix[i, j]:
                changed = matrix.copy()
                changed[i, j] = changed[j, i] = 0.0
                least = float(np.linalg.eigvalsh(changed)[0])
                if least > best:
                    best, pair = least, (i, j)
    i, j = pair
    low, high = _admissible(matrix, i, j)
    hint = f"with the others as given it can range from {low:.3g} to {high:.3g}"
    if not low < high:
        hint = "the others contradict each other too"
    raise UsageError(
        f"the correlations cannot all hold: {names[j]} with {names[i]}, {matrix[i, j]:g}, contradicts the others",
        parameter="correlate",
        code="not-positive-definite",
        hint=hint,
    )


def _admissible(matrix: "Array", i: int, j: int) -> tuple[float, float]:
    """The correlations of a pair that leave the matrix positive: conditional correlation between −1 and 1."""
    rest = [k for k in range(len(matrix)) if k not in (i, j)]
    inner = np.linalg.pinv(matrix[np.ix_(rest, rest)]) if rest else np.zeros((0, 0))
    a, b = matrix[i, rest], matrix[j, rest]
    middle = float(a @ inner @ b)
    room = float(np.sqrt(max(1.0 - float(a @ inner @ a), 0.0) * max(1.0 - float(b @ inner @ b), 0.0)))
    return middle - room, middle + room


def complement(direction: "Array", axes: "Array | None" = None) -> "Array":
    """Orthonormal columns that span all, or some axes, across a unit vector (a Householder reflection)."""
    if axes is not None:
        across = np.zeros((len(direction), int(axes.sum()) - 1))
        across[axes] = complement(direction[axes])
        return across
    count = len(direction)
    v = direction.copy()
    v[0] += 1.0 if v[0] >= 0.0 else -1.0
    norm = float(v @ v)
    if norm == 0.0:
        raise FaultError("a direction of length zero")
    return (np.eye(count) - 2.0 * np.outer(v, v) / norm)[:, 1:]
