"""Masses joined by springs: modes to the last digits, and exact counts of frequencies below a limit.

Formed into matrices, a soft mount beside stiff springs is rounded away. The factor √k·A·m^{−½}, A the incidence of the
springs, keeps every spring; one-sided Jacobi (Drmač & Veselić, SIAM J. Matrix Anal. Appl. 29 (2008) 1322) finds its
singular values, which are the angular frequencies, each to its own digits. It takes five times as long as the
eigenvalues of the matrices. So large systems try those first: their shapes, put into the quotient of Rayleigh spring by
spring, give frequencies whose error is bounded (Kato and Temple) by the residual of the shape squared over the distance
to the next frequency. Where that bound is not small enough, Jacobi answers.
"""

import math

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Spring = tuple[int, int, float]

GROUND = -1
# The first and the widest interval about a frequency that counts are tried at, relatively.
TIGHT, WIDE = 2e-15, 1e-9
# Larger systems have a bound from their matrix before exact counts of them would be done.
MOST_PROVED = 30
# Frequencies from matrices serve where their bound is below this.
CERTAIN = 2e-14
UNIT = 2.0**-53


class Elements:
    """Masses and springs (i, j, k); j is −1 for the ground. Parallel springs are joined."""

    def __init__(self, masses: "Sequence[float]", springs: "Sequence[Spring]") -> None:
        self.masses = list(masses)
        joined: dict[tuple[int, int], float] = {}
        for i, j, k in springs:
            key = (max(i, j), min(i, j))
            if k > 0.0 and i != j:
                joined[key] = joined.get(key, 0.0) + k
        self.springs = [(i, j, k) for (i, j), k in joined.items()]

    def groups(self) -> "list[tuple[list[int], bool]]":
        """Bodies that springs connect, and whether one of them reaches the ground."""
        of = list(range(len(self.masses)))

        def top(i: int) -> int:
            while of[i] != i:
                of[i] = of[of[i]]
                i = of[i]
            return i

        for i, j, _ in self.springs:
            if j != GROUND:
                of[top(i)] = top(j)
        held = {top(i) for i, j, _ in self.springs if j == GROUND}
        members: dict[int, list[int]] = {}
        for i in range(len(of)):
            members.setdefault(top(i), []).append(i)
        return [(those, head in held) for head, those in members.items()]

    def modes(self) -> "tuple[Any, Any, float | None]":
        """Angular frequencies from the lowest, shapes of unit modal mass in rows, and what bounds their errors.

        The bound is relative, and None where there is none; rigid modes are exactly zero.
        """
        if len(self.masses) > MOST_PROVED:
            made = self.by_matrix()
            if made[2] <= CERTAIN:
                return made
        omega, shapes = self.by_factor()
        return omega, shapes, self.proved(omega.tolist())

    def _rigid(self) -> "Any":
        """The shapes of the groups that nothing holds, one in a row."""
        import numpy as np

        free = [those for those, held in self.groups() if not held]
        shapes = np.zeros((len(free), len(self.masses)))
        for row, those in enumerate(free):
            shapes[row, those] = 1.0 / math.sqrt(math.fsum(self.masses[i] for i in those))
        return shapes

    def by_factor(self) -> "tuple[Any, Any]":
        """Angular frequencies and shapes by one-sided Jacobi on the factor of the stiffness."""
        import numpy as np
        from scipy.linalg.lapack import dgejsv

        n, shapes = len(self.masses), self._rigid()
        count = n - len(shapes)
        if not count:
            return np.zeros(n), shapes
        roots = np.sqrt(np.array(self.masses))
        i, j, k = _ends(self.springs)
        rows, each = np.zeros((len(k), n + 1)), np.arange(len(k))
        # the ground has the last column, which is left out
        rows[each, i], rows[each, j] = np.sqrt(k), -np.sqrt(k)
        rows = rows[:, :n] / roots
        tall = len(k) >= n
        sizes, u, v, work, _, info = dgejsv(rows if tall else rows.T.copy(), joba=2, jobr=0, jobt=0, jobp=0)
        require(info == 0, "the modes did not converge", code="no-convergence")
        moving = (v if tall else u)[:, :count].T[::-1] / roots
        sizes = (sizes * (work[0] / work[1]))[:count][::-1]
        return np.concatenate([np.zeros(len(shapes)), sizes]), np.vstack([shapes, moving])

    def by_matrix(self) -> "tuple[Any, Any, float]":
        """Angular frequencies by the shapes of the assembled matrix, and a bound on their relative errors."""
        import numpy as np
        from scipy.linalg import eigh

        rigid = self._rigid()
        roots, none = np.sqrt(np.array(self.masses)), len(rigid)
        matrix = self.assembled(self.springs) / roots[:, None] / roots
        squares, vectors = eigh(matrix, driver="evd", check_finite=False)
        squares, vectors = squares[none:], vectors[:, none:]
        shapes = np.ascontiguousarray(vectors.T / roots)
        omega = self.rayleigh(shapes)
        if not len(omega) or not omega.min() > 0.0:
            return np.zeros(len(roots)), rigid, 0.0 if not len(omega) else math.inf
        # residuals, with what rounding adds while the matrix is formed and applied
        size = float(abs(matrix).sum(axis=1).max())
        terms = int((matrix != 0.0).sum(axis=1).max()) + 8
        off = matrix @ vectors
        off -= vectors * squares
        residuals = np.sqrt(np.einsum("ij,ij->j", off, off)) + 2.0 * terms * UNIT * size
        ends = np.concatenate([[0.0 if none else -math.inf], squares, [math.inf]])
        gaps = np.minimum(squares - ends[:-2], ends[2:] - squares) - math.sqrt(len(roots)) * residuals.max()
        bounds = np.where(gaps > residuals, residuals * residuals / np.maximum(gaps, residuals), residuals)
        width = 0.5 * float((bounds / (omega * omega)).max()) + (10.0 + math.log2(len(self.springs))) * UNIT
        return np.concatenate([np.zeros(none), omega]), np.vstack([rigid, shapes]), width

    def assembled(self, springs: "list[Spring]") -> "Any":
        """The matrix of springs (or dampers) between these bodies."""
        import numpy as np

        n, (i, j, k) = len(self.masses), _ends(springs)
        # the ground has the last row and column, which are left out
        made = np.zeros((n + 1, n + 1))
        for rows, columns, part in ((i, i, k), (j, j, k), (i, j, -k), (j, i, -k)):
            np.add.at(made, (rows, columns), part)
        return made[:n, :n]

    def rayleigh(self, shapes: "Any") -> "Any":
        """ω of shapes in rows by the quotient of Rayleigh, spring by spring: sums of positive terms."""
        import numpy as np

        i, j, k = _ends(self.springs)
        # the ground is the last row, and still
        moved = np.zeros((len(self.masses) + 1, len(shapes)))
        moved[:-1] = np.asarray(shapes).T
        stretched = moved[i]
        stretched -= moved[j]
        held = np.einsum("i,ij,ij->j", k, stretched, stretched)
        return np.sqrt(held / np.einsum("i,ij,ij->j", self.masses, moved[:-1], moved[:-1]))

    def participations(self, omega: "Any", shapes: "Any") -> "Any":
        """Σmφ of each mode; of modes that hardly move the whole from the springs to the ground, Σkφ/ω²."""
        import numpy as np

        masses, held = np.array(self.masses), np.zeros(len(self.masses))
        for i, j, k in self.springs:
            held[i] += k if j == GROUND else 0.0
        squares = np.where(omega > 0.0, omega, math.nan) ** 2
        # each sum is as good as its terms are small
        smaller = held.sum() * abs(shapes).max(axis=1) / squares < abs(shapes) @ masses
        return np.where(smaller, shapes @ held / squares, shapes @ masses)

    def order(self) -> "list[tuple[int, int, int]] | None":
        """Bodies from leaves to roots, each with what carries it (−1: none), by which spring; None for loops."""
        n = len(self.masses)
        beside: list[list[tuple[int, int]]] = [[] for _ in range(n)]
        inner = [(i, j, nth) for nth, (i, j, _) in enumerate(self.springs) if j != GROUND]
        if len(inner) != n - len(self.groups()):
            return None
        for i, j, nth in inner:
            beside[i].append((j, nth))
            beside[j].append((i, nth))
        seen: set[int] = set()
        walk: list[tuple[int, int, int]] = []
        for root in range(n):
            if root in seen:
                continue
            waiting = [(root, GROUND, GROUND)]
            seen.add(root)
            while waiting:
                here = waiting.pop()
                walk.append(here)
                for other, nth in beside[here[0]]:
                    if other not in seen:
                        seen.add(other)
                        waiting.append((other, here[0], nth))
        return walk[::-1]

    def _whole_numbers(self) -> "tuple[list[int], list[int], int]":
        """Masses and stiffnesses times powers of two that make them whole, and the difference of the exponents."""
        sides = []
        for values in (self.masses, [k for _, _, k in self.springs]):
            pairs = [value.as_integer_ratio() for value in values]
            shift = max((below.bit_length() - 1 for _, below in pairs), default=0)
            sides.append(([above << (shift + 1 - below.bit_length()) for above, below in pairs], shift))
        return sides[0][0], sides[1][0], sides[1][1] - sides[0][1]

    def count_below(self, square: float) -> int | None:
        """How many ω² lie below `square`, by exact signs of pivots; None where springs form loops."""
        walk = self.order()
        return None if walk is None else self._count(walk, self._whole_numbers(), *square.as_integer_ratio())

    def _count(
        self, walk: "list[tuple[int, int, int]]", whole: "tuple[list[int], list[int], int]", above: int, below: int
    ) -> int:
        """The count for a limit `above/below` in whole numbers, never reduced: their growth costs less than that."""
        masses, springs, shift = whole
        shift -= below.bit_length() - 1
        heavy, stiff = above << max(shift, 0), max(-shift, 0)
        held = [(0, 1)] * len(masses)
        for (i, j, _), k in zip(self.springs, springs, strict=True):
            if j == GROUND:
                held[i] = (held[i][0] + (k << stiff), 1)
        count = 0
        for body, carrier, spring in walk:
            number, under = held[body]
            rest = number - heavy * masses[body] * under
            if carrier == GROUND:
                count += rest < 0
                continue
            k = springs[spring] << stiff
            pivot = rest + k * under
            if pivot == 0:
                # at a zero of a minor the count is that of a limit a hair larger
                return self._count(walk, whole, (above << 80) + above, below << 80)
            count += pivot < 0
            number, under = held[carrier]
            number, under = number * pivot + k * rest * under, under * pivot
            held[carrier] = (number, under) if under > 0 else (-number, -under)
        return count

    def proved(self, values: "Sequence[float]") -> float | None:
        """The relative interval within which counts prove every frequency; None where they cannot."""
        walk = self.order()
        if len(self.masses) > MOST_PROVED or walk is None:
            return None
        whole = self._whole_numbers()

        def within(nth: int, value: float, width: float) -> bool:
            # limits that lie inside the interval, whatever their rounding
            low, high = (value * value * (1.0 + 1.8 * side * width) for side in (-1.0, 1.0))
            below, above = (self._count(walk, whole, *limit.as_integer_ratio()) for limit in (low, high))
            return below <= nth < above

        worst = 0.0
        for nth, value in enumerate(values):
            width = TIGHT
            while value and not within(nth, value, width):
                width *= 4.0
                if width > WIDE:
                    return None
            worst = max(worst, width if value else 0.0)
        return worst


def _ends(springs: "list[Spring]") -> "tuple[Any, Any, Any]":
    """The bodies at both ends of the springs (−1: the ground), and the stiffnesses."""
    import numpy as np

    i, j, k = zip(*springs, strict=True) if springs else ((), (), ())
    return np.array(i, dtype=int), np.array(j, dtype=int), np.array(k, dtype=float)
