"""Conditions that rates must keep, such as rolling or a knife edge, and generalized speeds in place of rates.

Conditions A·q̇ + b = 0 and speeds u = U·q̇ + c together give the rates: q̇ = W·u + what does not vary. With Wᵀ from the
left the forces of the conditions drop out of the equations.
"""

from dynamics_cli.errors import require
from dynamics_cli.motion.equations.kane import coefficient
from dynamics_cli.motion.rods import solved
from dynamics_cli.numerics.expressions.jets import Jet
from dynamics_cli.numerics.number import plain
from dynamics_cli.quantities import Speed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.equations.kane import Kane, Load
    from dynamics_cli.motion.equations.system import System

    Rows = list[list[Any]]

# Rates meet a condition within this share of its terms; a smaller pivot is rounding.
MET, DEPENDENT = 1e-9, 1e-12


class LinearForms:
    """Formulas linear in the rates, at an instant: slopes, values, derivatives in time without accelerations."""

    def __init__(self, kane: "Kane", laws: "dict[str, Any]") -> None:
        system, names = kane.system, kane.system.names
        rates = {f"{name}_dot": w for name, w in zip(names, kane.rates, strict=True)}
        at_rest = kane.numbers | dict.fromkeys(rates, 0.0)
        self.slopes: Rows = []
        self.values, self.drifts, self.fixed = [], [], []
        for own, law in laws.items():
            self.slopes.append(_slopes(system, own, law, at_rest, list(rates)))
            there = _slopes(system, own, law, kane.numbers | rates, list(rates))
            size = max(abs(plain(x)) for x in (*there, *self.slopes[-1]))
            bent = max(abs(plain(a) - plain(b)) for a, b in zip(there, self.slopes[-1], strict=True))
            require(bent <= DEPENDENT * size, "{name} is not linear in the rates", name=own, code="not-linear",
                    hint="write a sum of rates, each times a formula of the coordinates")  # fmt: skip
            self.values.append(system.value(own, law, kane.numbers | rates))
            self.fixed.append(system.value(own, law, at_rest))
            moving = {name: Jet([part.parts[0], part.parts[1]]) for name, part in kane.along.items()}
            constant = {name: Jet([w, 0.0]) for name, w in rates.items()}
            self.drifts.append(coefficient(system.value(own, law, moving | constant), 1))


def _slopes(system: "System", own: str, law: "Any", numbers: "dict[str, Any]", rates: "list[str]") -> "list[Any]":
    out = []
    for name in rates:
        one = {key: Jet([value, 1.0 if key == name else 0.0]) for key, value in numbers.items()}
        out.append(coefficient(system.value(own, law, one), 1))
    return out


class Constrained:
    """The rates, accelerations and forces of a scene with conditions, by generalized speeds."""

    def __init__(self, kane: "Kane") -> None:
        self.kane, self.system = kane, kane.system
        n = len(self.system.names)
        self.conditions = LinearForms(kane, self.system.conditions)
        self.count = len(self.conditions.values)
        self._require_met()
        self.speeds = LinearForms(kane, self.system.speeds)
        self.names, self.angular = list(self.system.speeds), [one.angular for one in self.system.scene.speeds]
        slopes = [*self.conditions.slopes, *self.speeds.slopes]
        drifts, values = [*self.conditions.drifts, *self.speeds.drifts], list(self.speeds.values)
        require(len(slopes) <= n, "{c} conditions and {s} speeds are too many for {n} coordinates", c=str(self.count),
                s=str(len(self.names)), n=str(n), code="count", hint="speeds and conditions together: {n}")  # fmt: skip
        require(not self.names or len(slopes) == n, "{s} generalized speeds; with these conditions there are {wanted}",
                s=str(len(self.names)), wanted=str(n - self.count), code="count",
                hint="give {wanted}, or none: then rates of coordinates are taken")  # fmt: skip
        for r in _free(slopes, n) if not self.names else ():
            slopes.append([1.0 if s == r else 0.0 for s in range(n)])
            drifts.append(0.0)
            values.append(kane.rates[r])
            self.names.append(f"{self.system.names[r]}_dot")
            self.angular.append(self.system.angular[r])
        self.values = values
        inverse = inverted(slopes)
        require(inverse is not None, "the speeds and the conditions depend on each other at this instant",
                code="dependent", hint="choose other speeds")  # fmt: skip
        assert inverse is not None
        # what the rates are per unit of each condition, and of each speed
        self.across = [row[: self.count] for row in inverse]
        self.ways = [row[self.count :] for row in inverse]
        self.drift = [-sum(a * d for a, d in zip(row, drifts, strict=True)) for row in inverse]

    def _require_met(self) -> None:
        forms = self.conditions
        for name, slopes, value in zip(self.system.conditions, forms.slopes, forms.values, strict=True):
            require(any(map(plain, slopes)), "{name} has no rate in it at this instant", name=name, code="dependent",
                    hint="leave it out, or choose another instant")  # fmt: skip
            terms = [abs(plain(a * w)) for a, w in zip(slopes, self.kane.rates, strict=True)]
            r = max(range(len(slopes)), key=lambda k: abs(plain(slopes[k])))
            wanted = plain(self.kane.rates[r]) - plain(value) / plain(slopes[r])
            require(abs(plain(value)) <= MET * max(terms), "{name} is not kept: it is {slip} with these rates",
                    name=name, slip=(plain(value), Speed), code="not-kept",
                    hint=f"{{rate}} = {wanted:.9g} would do, in SI", rate=f"{self.system.names[r]}_dot")  # fmt: skip

    def accelerations(self, masses: "Rows", right: "list[Any]") -> "tuple[list[Any], list[Any], list[Any]]":
        """Rates of the speeds, second derivatives of the coordinates, forces of the conditions."""
        left = [r - _dot(row, self.drift) for row, r in zip(masses, right, strict=True)]
        reduced = [[self._through(masses, a, b) for b in self._columns()] for a in self._columns()]
        firm = [list(row) for row in reduced]
        try:
            rates = solved(firm, [_dot(way, left) for way in self._columns()])
        except ZeroDivisionError:
            rates = []
        for name, row, old, k in zip(self.names, firm, reduced, range(len(firm)), strict=True):
            moves = plain(old[k]) > 0.0 and plain(row[k]) > DEPENDENT * plain(old[k])
            require(moves, "{name} moves no mass of its own",
                    name=name, code="massless", hint="give what it moves a mass or an inertia")  # fmt: skip
        seconds = [g + _dot(row, rates) for row, g in zip(self.ways, self.drift, strict=True)]
        lacking = [_dot(row, seconds) - r for row, r in zip(masses, right, strict=True)]
        return rates, seconds, [sum(row[k] * x for row, x in zip(self.across, lacking, strict=True))
                                for k in range(self.count)]  # fmt: skip

    def scales(self, masses: "list[list[float]]", sums: "list[float]") -> "list[float]":
        """For each coordinate the size of the terms of its acceleration."""
        ways = [[plain(x) for x in way] for way in self._columns()]
        inverse = inverted([[_dot(a, [_dot(row, b) for row in masses]) for b in ways] for a in ways]) or []
        each = [[abs(_dot(row, [way[s] for way in ways])) for s in range(len(sums))] for row in inverse]
        return [
            sum(abs(ways[k][r]) * _dot(each[k], sums) for k in range(len(ways))) + abs(plain(self.drift[r]))
            for r in range(len(sums))
        ]

    def extend(self, loads: "list[Load]") -> None:
        """Give every load its partial velocities by the speeds, after those by the coordinates."""
        n = len(self.system.names)
        for load in loads:
            for vectors in (load.velocities, load.turns):
                if len(vectors) == n + 1:
                    vectors += [_combined(way, vectors) for way in self._columns()]

    def _columns(self) -> "Rows":
        return [list(column) for column in zip(*self.ways, strict=True)]

    @staticmethod
    def _through(masses: "Rows", a: "list[Any]", b: "list[Any]") -> "Any":
        return _dot(a, [_dot(row, b) for row in masses])


def by_multipliers(
    conditions: LinearForms, matrix: "list[list[float]]", right: "list[float]"
) -> "tuple[list[float], list[float]]":
    """Accelerations and forces of the conditions by Lagrange's multipliers: M·q̈ − Aᵀ·λ = Q, A·q̈ = −drift."""
    slopes, drifts = conditions.slopes, conditions.drifts
    n, m = len(right), len(slopes)
    rows = [[*row, *(-plain(slopes[k][r]) for k in range(m))] for r, row in enumerate(matrix)]
    rows += [[*(plain(x) for x in slope), *[0.0] * m] for slope in slopes]
    inverse = inverted(rows)
    require(inverse is not None, "a coordinate moves no mass of its own", code="massless")
    ends = [*right, *(-plain(x) for x in drifts)]
    found = [_dot(row, ends) for row in inverse or []]
    return found[:n], found[n:]


def inverted(rows: "Rows") -> "Rows | None":
    """The inverse by elimination with the largest pivots; None where there is none."""
    n = len(rows)
    work = [[*row, *(1.0 if k == r else 0.0 for k in range(n))] for r, row in enumerate(rows)]
    for c in range(n):
        size = max(abs(plain(x)) for x in rows[c])
        p = max(range(c, n), key=lambda k: abs(plain(work[k][c])))
        if abs(plain(work[p][c])) <= DEPENDENT * DEPENDENT * size or not plain(work[p][c]):
            return None
        work[c], work[p] = work[p], work[c]
        pivot = work[c][c]
        work[c] = [x / pivot for x in work[c]]
        for k in range(n):
            if k != c and plain(work[k][c]):
                share = work[k][c]
                work[k] = [x - share * y for x, y in zip(work[k], work[c], strict=True)]
    return [row[n:] for row in work]


def _free(slopes: "Rows", n: int) -> "list[int]":
    """Coordinates whose rates can be chosen freely under these conditions."""
    rows, bound = [[plain(x) for x in row] for row in slopes], []
    for r, row in enumerate(rows):
        c = max((k for k in range(n) if k not in bound), key=lambda k: abs(row[k]))
        require(abs(row[c]) > DEPENDENT * max(map(abs, map(plain, slopes[r]))), "the conditions depend on each other",
                code="dependent", hint="leave one out")  # fmt: skip
        bound.append(c)
        for other in rows[r + 1 :]:
            share = other[c] / row[c]
            other[:] = [x - share * y for x, y in zip(other, row, strict=True)]
    return [k for k in range(n) if k not in bound]


def _dot(a: "Any", b: "Any") -> "Any":
    return sum(x * y for x, y in zip(a, b, strict=True))


def _combined(way: "list[Any]", vectors: "list[Any]") -> "Any":
    return tuple(sum(share * vector[k] for share, vector in zip(way, vectors, strict=False)) for k in range(3))
