"""Accelerations within loops and with drives at every instant, on plain floats and without the forces of the loops.

Elimination with full pivots chooses at every instant the speeds that follow from the others: ẏ_d = p − R·ẏ_f.
"""

from dynamics_cli.errors import require
from dynamics_cli.numerics.trees.matrix import mass_matrix
from dynamics_cli.numerics.trees.newton_euler import inverse, sweep

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.multibody.bodies.loops import Loops
    from dynamics_cli.multibody.bodies.system import System
    from dynamics_cli.multibody.motions.drives import Drives

# A condition counts where its pivot is above this share of the largest.
COUNTS = 1e-10
# The motion that the loops leave free needs inertia above this share of the largest.
RESISTS = 1e-13


class Guided:
    """A system whose speeds keep the conditions of its loops and of its drives."""

    def __init__(self, system: "System", loops: "Loops | None", drives: "Drives | None") -> None:
        self.system, self.drives = system, drives
        self.closures = loops.closures if loops is not None else []
        self.rows: list[float] = loops.row_scales.tolist() if loops is not None else []
        self.columns: list[float] = loops.column_scales.tolist() if loops is not None else [1.0] * system.tree.speeds

    def accelerations(self, efforts: "Sequence[float]", time: float) -> "list[float]":
        """Rates of the speeds where the system stands."""
        system = self.system
        count = len(self.columns)
        dependent = eliminated(self._conditions(time), count)
        held, _ = inverse(system.tree, system.frames, system.speeds, ground=system.base, loads=system.loads)
        left = [effort - bias for effort, bias in zip(efforts, held, strict=True)]
        return reduced_rates(dependent, self.columns, mass_matrix(system.tree, system.frames), left)

    def _conditions(self, time: float) -> "list[list[float]]":
        """The conditions on the rates of the speeds, free of units, with their right-hand sides."""
        system = self.system
        motions = sweep(system.tree, system.frames, system.speeds) if self.closures else []
        out: list[list[float]] = []
        for one in self.closures:
            drifts = one.drift(system.ground, motions)
            for row, drift in zip(one.rows(system, system.ground), drifts, strict=True):
                scale = self.rows[len(out)]
                out.append([scale * x * y for x, y in zip(row, self.columns, strict=True)] + [-scale * drift])
        return out if self.drives is None else out + self.drives.conditions(time, self.columns)


def reduced_rates(
    dependent: "dict[int, list[float]]", scales: "list[float]", matrix: "list[list[float]]", left: "list[float]"
) -> "list[float]":
    """Rates of the speeds by those that are free: (CᵀM·C)·ż = Cᵀ(F − h − M·p), with rates p that keep the conditions.

    `left` is F − h; the rows of `dependent` are free of units by `scales`.
    """
    count = len(scales)
    rates = [0.0] * count
    for column, row in dependent.items():
        rates[column] = row[count] * scales[column]
    free = [column for column in range(count) if column not in dependent]
    if not free:
        return rates
    # what every speed does per unit of a free one
    ways = [[(n, scales[n])] + [(d, -row[n] * scales[d]) for d, row in dependent.items() if row[n]] for n in free]
    short = [f - sum([a * b for a, b in zip(line, rates, strict=True)]) for f, line in zip(left, matrix, strict=True)]
    heavy = [[sum([part * line[k] for k, part in way]) for line in matrix] for way in ways]
    reduced = [[sum([part * m[k] for k, part in way]) for way in ways] for m in heavy]
    for row, way in zip(reduced, ways, strict=True):
        row.append(sum([part * short[k] for k, part in way]))
    for size, way in zip(solved(reduced), ways, strict=True):
        for k, part in way:
            rates[k] += size * part
    return rates


def eliminated(rows: "list[list[float]]", count: int) -> "dict[int, list[float]]":
    """Gauss–Jordan elimination with full pivots: for each column that follows from others, the row that gives it.

    Conditions that repeat others are left out. The rows are used up.
    """
    out: dict[int, list[float]] = {}
    left = list(range(count))
    largest = 0.0
    while rows and left:
        size, line, column = max([(abs(row[c]), r, c) for r, row in enumerate(rows) for c in left])
        largest = largest or size
        if not size > COUNTS * largest:
            break
        pivot = rows.pop(line)
        over = 1.0 / pivot[column]
        pivot = [x * over for x in pivot]
        for row in [*rows, *out.values()]:
            factor = row[column]
            if factor:
                row[:] = [x - factor * y for x, y in zip(row, pivot, strict=True)]
        out[column] = pivot
        left.remove(column)
    return out


def solved(rows: "list[list[float]]") -> "list[float]":
    """Solution of symmetric positive equations, the right-hand side in the last column."""
    count = len(rows)
    largest = max(rows[k][k] for k in range(count))
    for k, pivot in enumerate(rows):
        require(pivot[k] > RESISTS * largest, "nothing resists a motion that the loops leave free", code="no-inertia",
                hint="give the bodies that move freely mass or a tensor")  # fmt: skip
        for row in rows[k + 1 :]:
            factor = row[k] / pivot[k]
            row[k:] = [x - factor * y for x, y in zip(row[k:], pivot[k:], strict=True)]
    out = [0.0] * count
    for k in range(count - 1, -1, -1):
        row = rows[k]
        out[k] = (row[count] - sum(row[n] * out[n] for n in range(k + 1, count))) / row[k]
    return out
