"""A chain of rods pinned to one another: its inertias, its accelerations, its energy, its small oscillations."""

import math

from dynamics_cli.errors import require
from dynamics_cli.quantities import Length, Mass

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Beyond so many rods arrays are faster than plain floats.
PLAIN = 8
MOST = 60


class Rods:
    """Rods in absolute angles q from the downward vertical.

    ½·Σ a_ij·cos(q_i − q_j)·q̇_i·q̇_j is the kinetic energy and −g·Σ b_i·cos q_i the potential one; for i < j
    a_ij = l_i·b_j.
    """

    def __init__(
        self,
        lengths: "Sequence[float]",
        masses: "Sequence[float]",
        ends: "Sequence[float]",
        inertias: "Sequence[float]",
        gravity: float,
    ) -> None:
        self.lengths, self.masses, self.ends, self.inertias = list(lengths), list(masses), list(ends), list(inertias)
        self.gravity = gravity
        self.n = n = len(self.lengths)
        self._arrays: Any = None
        below = [0.0] * n
        for i in range(n - 2, -1, -1):
            below[i] = below[i + 1] + self.masses[i + 1] + self.ends[i + 1]
        # the mass that hangs at the lower end of each rod
        self.hung = [self.ends[i] + below[i] for i in range(n)]
        self.b = [0.5 * m * length + length * hung for m, length, hung in zip(masses, lengths, self.hung, strict=True)]
        self.a = [[self.lengths[min(i, j)] * self.b[max(i, j)] for j in range(n)] for i in range(n)]
        for i in range(n):
            length = self.lengths[i]
            self.a[i][i] = self.inertias[i] + 0.25 * self.masses[i] * length**2 + length**2 * self.hung[i]

    def energy(self, q: "Sequence[float]", w: "Sequence[float]") -> float:
        """Kinetic and potential energy above that of hanging at rest."""
        n = self.n
        kinetic = math.fsum(
            0.5 * self.a[i][j] * math.cos(q[i] - q[j]) * w[i] * w[j] for i in range(n) for j in range(n)
        )
        return kinetic + math.fsum(2.0 * self.gravity * self.b[i] * math.sin(0.5 * q[i]) ** 2 for i in range(n))

    def fastest(self) -> float:
        """The rate of its fastest small oscillation."""
        return 1.0 / min(self.oscillations()[0])

    def scale(self, q: "Sequence[float]", w: "Sequence[float]", fastest: float | None = None) -> float:
        """Rates that this motion can reach, with its fastest small oscillation, or that of a chain much like it."""
        return (fastest or self.fastest()) + max(map(abs, w)) + math.sqrt(2.0 * self.energy(q, w) / self.a[0][0])

    def rate(self, _: float, state: "Any") -> "Any":
        """Rates and accelerations of the angles."""
        if self.n > PLAIN:
            return self._rate_by_arrays(state)
        n = self.n
        y = state.tolist() if hasattr(state, "tolist") else list(state)
        sines, cosines, w = [math.sin(x) for x in y[:n]], [math.cos(x) for x in y[:n]], y[n:]
        matrix = []
        right = []
        for i in range(n):
            row, total, s, c, a = [], -self.gravity * self.b[i] * sines[i], sines[i], cosines[i], self.a[i]
            for j in range(n):
                if j <= i:
                    row.append(a[j] * (c * cosines[j] + s * sines[j]))
                total -= a[j] * (s * cosines[j] - c * sines[j]) * w[j] * w[j]
            row[i] = a[i]
            matrix.append(row)
            right.append(total)
        return w + solved(matrix, right)

    def _rate_by_arrays(self, state: "Any") -> "Any":
        import numpy as np
        from scipy.linalg.lapack import dposv

        n = self.n
        q, w = state[:n], state[n:]
        if self._arrays is None:
            self._arrays = np.array(self.a), self.gravity * np.array(self.b)
        a, weights = self._arrays
        s, c = np.sin(q), np.cos(q)
        squares = w * w
        right = c * (a @ (s * squares)) - s * (a @ (c * squares)) - weights * s
        matrix = a * (np.multiply.outer(c, c) + np.multiply.outer(s, s))
        _, turning, info = dposv(matrix, right)
        require(info == 0, "the mass matrix is singular", code="massless", hint="give every rod a mass")
        return np.concatenate((w, turning))

    def pin_forces(self, state: "Sequence[float]") -> "list[float]":
        """The force in the pin at the upper end of each rod: what moves and carries all below it."""
        n, y = self.n, list(state)
        turning = [float(x) for x in self.rate(0.0, _row(y))[n:]]
        across, up, moved = 0.0, 0.0, []
        for i in range(n):
            s, c, length = math.sin(y[i]), math.cos(y[i]), self.lengths[i]
            ax = length * (turning[i] * c - y[n + i] ** 2 * s)
            ay = length * (turning[i] * s + y[n + i] ** 2 * c)
            m, end, g = self.masses[i], self.ends[i], self.gravity
            moved.append((
                m * (across + 0.5 * ax) + end * (across + ax), m * (up + 0.5 * ay + g) + end * (up + ay + g)
            ))  # fmt: skip
            across, up = across + ax, up + ay
        return [math.hypot(math.fsum(x for x, _ in moved[i:]), math.fsum(y for _, y in moved[i:])) for i in range(n)]

    def joints(self, q: "Sequence[float]") -> "tuple[list[float], list[float]]":
        """Places of the upper pin and of all lower ends, across and up."""
        x, y = [0.0], [0.0]
        for angle, length in zip(q, self.lengths, strict=True):
            x.append(x[-1] + length * math.sin(angle))
            y.append(y[-1] - length * math.cos(angle))
        return x, y

    def oscillations(self) -> "tuple[list[float], list[list[float]]]":
        """1/ω of the small oscillations, from the slowest, and their shapes in the angles, of unit potential energy.

        They are the singular values of √m·B·(g·b)^{−½}, B the partial velocities: the mass matrix would round away a
        light mass beside a heavy one.
        """
        import numpy as np
        from scipy.linalg.lapack import dgejsv

        rows = []
        for i in range(self.n):
            above = self.lengths[:i]
            none = [0.0] * (self.n - i - 1)
            rows.append([math.sqrt(self.masses[i]) * part for part in [*above, 0.5 * self.lengths[i], *none]])
            rows.append([math.sqrt(self.ends[i]) * part for part in [*above, self.lengths[i], *none]])
            rows.append([0.0] * i + [math.sqrt(self.inertias[i]), *none])
        roots = np.sqrt(self.gravity * np.array(self.b))
        matrix = np.array([row for row in rows if any(row)]) / roots
        sizes, _, v, work, _, info = dgejsv(matrix, joba=2, jobr=0, jobt=0, jobp=0)
        require(info == 0, "the modes did not converge", code="no-convergence")
        order = np.argsort(-sizes)
        return (sizes * (work[0] / work[1]))[order].tolist(), (v.T[order] / roots).tolist()


def _row(values: "list[float]") -> "Any":
    import numpy as np

    return np.array(values)


def solved(matrix: "list[list[Any]]", right: "list[Any]") -> "list[Any]":
    """The solution of a positive definite system, its lower half given; by LDLᵀ on floats or arrays, D in its place.

    Entries may be one array several times, so that none is changed in place.
    """
    n = len(right)
    for i in range(n):
        row = matrix[i]
        for j in range(i):
            other = matrix[j]
            held = row[j]
            for k in range(j):
                held = held - row[k] * other[k]
            row[j] = held  # still times the pivot
        for j in range(i):
            share = row[j] / matrix[j][j]
            row[i] = row[i] - share * row[j]
            right[i] = right[i] - share * right[j]
            row[j] = share
    return _back(matrix, right)


def _back(matrix: "list[list[Any]]", right: "list[Any]") -> "list[Any]":
    n = len(right)
    out = [right[i] / matrix[i][i] for i in range(n)]
    for i in range(n - 1, -1, -1):
        for k in range(i + 1, n):
            out[i] -= matrix[k][i] * out[k]
    return out


def chain_of(
    lengths: "Sequence[float]",
    masses: "Sequence[float]",
    end_masses: "Sequence[float]",
    inertias: "Sequence[float]",
    count: int | None,
    gravity: float,
) -> Rods:
    """The chain of these rods; one length is for all of `count`."""
    require(len(lengths) > 0, "no rod is given", code="missing")
    require(count is None or len(lengths) in (1, count), "{n} lengths are not those of {count} rods",
            n=str(len(lengths)), count=str(count), code="count",
            hint="give one length for all, or leave --count out")  # fmt: skip
    n = count or len(lengths)
    require(n <= MOST, "{n} rods are too many", n=str(n), code="count", hint="{most} at the most", most=str(MOST))
    lengths = many(lengths, n, "lengths", 0.0)
    masses = many(masses, n, "masses", 0.0)
    ends = many(end_masses, n, "end masses", 0.0)
    for length in lengths:
        require(length > 0.0, "a length of {length} is not above zero", length=(length, Length))
    for i in range(n):
        require(masses[i] + ends[i] > 0.0, "rod {i} has no mass: {mass}", i=str(i + 1), mass=(0.0, Mass),
                code="massless", hint="give it a mass, or a mass at its end")  # fmt: skip
    require(gravity > 0.0, "without gravity the chain does not hang", code="gravity", hint="give it above zero")
    slender = [m * length**2 / 12.0 for m, length in zip(masses, lengths, strict=True)]
    return Rods(lengths, masses, ends, many(inertias, n, "inertias", 0.0) if inertias else slender, gravity)


def many(values: "Sequence[float]", n: int, name: str, default: float) -> "list[float]":
    """One for each rod: as given, one for all, or the default where none is given."""
    given = [float(value) for value in values] or [default]
    require(len(given) in (1, n), "{k} {name} do not go with {n} rods", k=str(len(given)), name=name, n=str(n),
            code="count", hint="give one for each rod, or one for all")  # fmt: skip
    return given * n if len(given) == 1 else given
