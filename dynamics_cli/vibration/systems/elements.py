"""Masses joined by springs: modes from the factor of the stiffness, and exact counts of frequencies below a limit.

Formed into matrices, a soft mount beside stiff springs is rounded away. The factor √k·A·m^{−½}, A the incidence of the
springs, keeps every spring; one-sided Jacobi (Drmač & Veselić, SIAM J. Matrix Anal. Appl. 29 (2008) 1322) finds its
singular values, which are the angular frequencies, each to its own digits.
"""

import math

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from fractions import Fraction
    from typing import Any

    Spring = tuple[int, int, float]

GROUND = -1
# The first and the widest interval about a frequency that counts are tried at, relatively.
TIGHT, WIDE = 2e-15, 1e-9
# Exact counts of larger systems take seconds.
MOST_PROVED = 30


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

    def modes(self) -> "tuple[list[float], list[list[float]]]":
        """Angular frequencies from the lowest, and shapes of unit modal mass; rigid modes are exactly zero."""
        import numpy as np
        from scipy.linalg.lapack import dgejsv

        n = len(self.masses)
        roots = np.sqrt(np.array(self.masses))
        rows = np.zeros((len(self.springs), n))
        for row, (i, j, k) in enumerate(self.springs):
            rows[row, i] = math.sqrt(k) / roots[i]
            if j != GROUND:
                rows[row, j] = -math.sqrt(k) / roots[j]
        free = [those for those, held in self.groups() if not held]
        values: list[float] = [0.0] * len(free)
        shapes = []
        for those in free:
            whole = math.sqrt(math.fsum(self.masses[i] for i in those))
            shapes.append([1.0 / whole if i in those else 0.0 for i in range(n)])
        if len(self.springs) and n > len(free):
            tall = len(self.springs) >= n
            sizes, u, v, work, _, info = dgejsv(rows if tall else rows.T.copy(), joba=2, jobr=0, jobt=0, jobp=0)
            require(info == 0, "the modes did not converge", code="no-convergence")
            sizes = sizes * (work[0] / work[1])
            vectors = v if tall else u
            count = n - len(free)
            for nth in range(count - 1, -1, -1):
                values.append(float(sizes[nth]))
                shapes.append([float(x) for x in vectors[:, nth] / roots])
        return values, shapes

    def rayleigh(self, shape: "Sequence[float]") -> float:
        """ω by the element Rayleigh quotient of a shape: sums of positive terms."""
        above = math.fsum(k * (shape[i] - (shape[j] if j != GROUND else 0.0)) ** 2 for i, j, k in self.springs)
        return math.sqrt(above / math.fsum(m * x * x for m, x in zip(self.masses, shape, strict=True)))

    def order(self) -> "list[tuple[int, int, float]] | None":
        """Bodies from leaves to roots, each with what carries it (−1: none), by which spring; None for loops."""
        n = len(self.masses)
        beside: list[list[tuple[int, float]]] = [[] for _ in range(n)]
        inner = [(i, j, k) for i, j, k in self.springs if j != GROUND]
        if len(inner) != n - len(self.groups()):
            return None
        for i, j, k in inner:
            beside[i].append((j, k))
            beside[j].append((i, k))
        seen: set[int] = set()
        walk: list[tuple[int, int, float]] = []
        for root in range(n):
            if root in seen:
                continue
            waiting = [(root, GROUND, 0.0)]
            seen.add(root)
            while waiting:
                here = waiting.pop()
                walk.append(here)
                for other, k in beside[here[0]]:
                    if other not in seen:
                        seen.add(other)
                        waiting.append((other, here[0], k))
        return walk[::-1]

    def count_below(self, square: "Any", exact: bool = True) -> int | None:
        """How many ω² lie below `square`, by signs of pivots, exact in fractions; None where springs form loops."""
        walk = self.order()
        if walk is None:
            return None
        number: Any = _fraction if exact else float
        held: list[Any] = [number(0.0)] * len(self.masses)
        for i, j, k in self.springs:
            if j == GROUND:
                held[i] += number(k)
        limit, below = number(square), 0
        for body, carrier, k in walk:
            rest = held[body] - limit * number(self.masses[body])
            if carrier == GROUND:
                below += rest < 0
                continue
            pivot = rest + number(k)
            if pivot == 0:
                # at a zero of a minor the count is that of a limit a hair larger
                return self.count_below(limit * (1 + number(2.0**-80)) if exact else square * (1.0 + 4e-16), exact)
            below += pivot < 0
            held[carrier] += number(k) * rest / pivot
        return below

    def proved(self, values: "Sequence[float]") -> float | None:
        """The relative interval within which counts prove every frequency; None where they cannot."""
        if len(self.masses) > MOST_PROVED or self.order() is None:
            return None
        worst = 0.0
        for nth, value in enumerate(values):
            if value == 0.0:
                continue
            width = TIGHT
            while not self._within(nth, value, width):
                width *= 4.0
                if width > WIDE:
                    return None
            worst = max(worst, width)
        return worst

    def _within(self, nth: int, value: float, width: float) -> bool:
        low, high = _fraction(value) * (1 - _fraction(width)), _fraction(value) * (1 + _fraction(width))
        below, above = self.count_below(low * low), self.count_below(high * high)
        return below is not None and above is not None and below <= nth < above


def _fraction(x: "float | Fraction") -> "Fraction":
    from fractions import Fraction

    return Fraction(x)
