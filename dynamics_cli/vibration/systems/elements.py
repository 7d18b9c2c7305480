"""Masses joined by springs: modes to the last digits.

Formed into matrices, a soft mount beside stiff springs is rounded away. The factor √k·A·m^{−½}, A the incidence of the
springs, keeps every spring; one-sided Jacobi (Drmač & Veselić, SIAM J. Matrix Anal. Appl. 29 (2008) 1322) finds its
singular values, which are the angular frequencies, each to its own digits. It takes five times as long as the
eigenvalues of the matrices. So large systems try those first: their shapes, put into the quotient of Rayleigh spring by
spring, give frequencies whose error is bounded (Kato and Temple) by the residual of the shape squared over the distance
to the next frequency. Where that bound is not small enough, Jacobi answers, beside the quotients of its own shapes.
"""

import math

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    Spring = tuple[int, int, float]

GROUND = -1
# Larger systems try the matrix first.
SMALL = 30
# Frequencies from matrices serve where their bound is below this.
CERTAIN = 2e-14
# A second computation bounds an error where it comes as near as this.
CLOSE = 1e-14
UNIT = 2.0**-53
BY_FACTOR = "one-sided Jacobi on the factor of springs and masses; beside element Rayleigh quotients"
BY_MATRIX = "element Rayleigh quotients of the shapes of the matrices; bound of Kato and Temple"


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

    def modes(self) -> "tuple[Any, Any, Any, str]":
        """Angular frequencies from the lowest, shapes of unit modal mass in rows, relative errors, and the method.

        Rigid modes are exactly zero. An error is 0 where nothing bounds it: the quotient of a soft mode beside stiff
        springs has fewer digits than its frequency.
        """
        import numpy as np

        if len(self.masses) > SMALL:
            omega, shapes, width = self.by_matrix()
            if width <= CERTAIN:
                return omega, shapes, np.full(len(omega), width), BY_MATRIX
        omega, shapes = self.by_factor()
        moving, off = omega > 0.0, np.full(len(omega), self._rounding())
        off[moving] += abs(self.rayleigh(shapes[moving]) / omega[moving] - 1.0)
        return omega, shapes, np.where(off <= CLOSE, off, 0.0), BY_FACTOR

    def _rounding(self) -> float:
        """What a quotient of Rayleigh, a sum of positive terms, is off by in hertz."""
        return (14.0 + math.log2(len(self.springs) or 1)) * UNIT

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
        width = 0.5 * float((bounds / (omega * omega)).max()) + self._rounding()
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


def _ends(springs: "list[Spring]") -> "tuple[Any, Any, Any]":
    """The bodies at both ends of the springs (−1: the ground), and the stiffnesses."""
    import numpy as np

    i, j, k = zip(*springs, strict=True) if springs else ((), (), ())
    return np.array(i, dtype=int), np.array(j, dtype=int), np.array(k, dtype=float)
