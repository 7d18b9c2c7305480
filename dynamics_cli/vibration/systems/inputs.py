"""What a system of several masses may be given by: a line of springs, bodies and couplings, matrices."""

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.fitting.records_file import read_matrix
from dynamics_cli.quantities import Annotated, InputFile, Mass, Matrix, Stiffness, Text, ViscousDamping
from dynamics_cli.records import Advice, record
from dynamics_cli.vibration.single.oscillator import require_damping
from dynamics_cli.vibration.systems.elements import GROUND, Elements

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

FIXED = "ground"
# What rounding leaves of the symmetry of a matrix.
SYMMETRIC = 1e-12


@record
class Line:
    """Masses in a row with springs between them."""

    masses: Annotated[tuple[Mass, ...], "Masses in a row, e.g. 1, 2, 3 kg."]
    stiffnesses: Annotated[
        tuple[Stiffness, ...],
        "Springs along it, the first to the wall; one less than masses: free ends; one more: a wall at each end.",
    ]
    dampings: Annotated[tuple[ViscousDamping, ...], "Dampers beside the springs, e.g. 5, 5, 0 N*s/m."] = ()


@record
class Body:
    """A body."""

    name: Annotated[Text, "Its name."]
    mass: Annotated[Mass, "Its mass, e.g. 200 kg."]


@record
class Coupling:
    """A spring with a damper."""

    from_: Annotated[Text, "The body at one end."]
    to: Annotated[Text, "The body at the other end, or ground."]
    stiffness: Annotated[Stiffness, "Its stiffness, e.g. 500 N/mm."] = 0.0
    damping: Annotated[ViscousDamping, "Its damping, e.g. 300 N*s/m."] = 0.0


@record
class Bodies:
    """Bodies and the springs between them."""

    bodies: Annotated[tuple[Body, ...], "The bodies."]
    couplings: Annotated[tuple[Coupling, ...], "Springs and dampers between them and the ground."]


@record
class Matrices:
    """Matrices as typed, in SI units."""

    mass_matrix: Annotated[Matrix, "Mass matrix in kg, e.g. 9, 0; 0, 1."]
    stiffness_matrix: Annotated[Matrix, "Stiffness matrix in N/m, e.g. 27, -3; -3, 3."]
    damping_matrix: Annotated[Matrix | None, "Damping matrix in N*s/m, e.g. 0.5, 0; 0, 0."] = None


@record
class MatrixFiles:
    """Matrices in files, in SI units."""

    mass_file: Annotated[InputFile, "CSV of the mass matrix in kg, without a header, e.g. mass.csv."]
    stiffness_file: Annotated[InputFile, "CSV of the stiffness matrix in N/m, e.g. stiffness.csv."]
    damping_file: Annotated[InputFile, "CSV of the damping matrix in N*s/m, e.g. damping.csv."] = ""


class System:
    """Names, matrices, and the elements where they are known; massless bodies are condensed."""

    def __init__(self, given: "Any") -> None:
        self.advice: list[Advice] = []
        self.elements: Elements | None = None
        # massless bodies, in the order they were condensed: place, what holds them, with which weight
        self.condensed: list[tuple[int, list[tuple[int, float]]]] = []
        self.dampers: list[tuple[int, int, float]] = []
        if isinstance(given, Line):
            self._line(given)
        elif isinstance(given, Bodies):
            self._bodies(given)
        else:
            self._matrices(given)

    # ---- springs and masses ----

    def _line(self, given: Line) -> None:
        n, s = len(given.masses), len(given.stiffnesses)
        require(n > 0, "no mass is given", code="missing")
        require(
            s in (n - 1, n, n + 1),
            "{s} springs do not go with {n} masses in a row",
            s=str(s),
            n=str(n),
            code="count",
            hint="{n} from a wall, one less with free ends, one more between walls",
        )
        dampings = given.dampings or (0.0,) * s
        require(len(dampings) == s, "there are {s} springs and {d} dampers", s=str(s), d=str(len(dampings)),
                code="count", hint="give 0 where there is none")  # fmt: skip
        ends = [(i - 1, i) for i in range(1, n)]
        if s >= n:
            ends.insert(0, (GROUND, 0))
        if s == n + 1:
            ends.append((n - 1, GROUND))
        self.names = [str(i + 1) for i in range(n)]
        self._join(given.masses, ends, given.stiffnesses, dampings)

    def _bodies(self, given: Bodies) -> None:
        self.names = [body.name for body in given.bodies]
        for name in self.names:
            require(
                self.names.count(name) == 1 and name != FIXED, "there are two bodies named {name}", name=repr(name),
                code="names",
            )  # fmt: skip
        ends = [(self.place(one.from_, FIXED), self.place(one.to, FIXED)) for one in given.couplings]
        for one, (i, j) in zip(given.couplings, ends, strict=True):
            require(
                i != j, "the coupling from {a} to {b} joins nothing", a=repr(one.from_), b=repr(one.to), code="loop"
            )
        self._join(
            [body.mass for body in given.bodies], ends, [one.stiffness for one in given.couplings],
            [one.damping for one in given.couplings],
        )  # fmt: skip

    def place(self, name: str, ground: str = "") -> int:
        """The place of a coordinate by its name."""
        if name == ground:
            return GROUND
        require(
            name in self.names,
            "there is no body {name}",
            name=repr(name),
            code="names",
            hint="the names are {known}",
            known=", ".join([*self.names, *([ground] if ground else [])]),
        )
        return self.names.index(name)

    def moving(self, name: str) -> int:
        """The place of a coordinate that has a mass among those that have one."""
        place = self.place(name)
        require(
            place in self.kept, "{name} has no mass: it is condensed, and nothing acts or is read there",
            name=repr(name), code="condensed",
        )  # fmt: skip
        return self.kept.index(place)

    def _join(
        self, masses: "Sequence[float]", ends: "list[tuple[int, int]]", stiffnesses: "Sequence[float]",
        dampings: "Sequence[float]",
    ) -> None:  # fmt: skip
        for value in dampings:
            require_damping(value, ViscousDamping)
        springs = [(i, j, k) for (i, j), k in zip(ends, stiffnesses, strict=True)]
        self.dampers = [(i, j, c) for (i, j), c in zip(ends, dampings, strict=True) if c > 0.0]
        left = [i for i, m in enumerate(masses) if m > 0.0]
        require(bool(left), "no body has a mass", code="no-mass")
        for body in [i for i, m in enumerate(masses) if m == 0.0]:
            springs = self._condense(body, springs)
        self.kept = left
        where = {body: nth for nth, body in enumerate(left)} | {GROUND: GROUND}
        self.elements = Elements([masses[i] for i in left], [(where[i], where[j], k) for i, j, k in springs])
        self.dampers = [(where[i], where[j], c) for i, j, c in self.dampers]

    def _condense(self, body: int, springs: "list[tuple[int, int, float]]") -> "list[tuple[int, int, float]]":
        """Springs without a massless body: its star becomes a mesh."""
        name = self.names[body]
        require(
            not any(body in (i, j) for i, j, _ in self.dampers),
            "{name} has a damper but no mass: it cannot be condensed",
            name=repr(name),
            code="massless-damped",
            hint="give it the small mass that it has",
        )
        star = [(j if i == body else i, k) for i, j, k in springs if body in (i, j) and k > 0.0]
        whole = sum(k for _, k in star)
        require(whole > 0.0, "{name} has neither mass nor spring", name=repr(name), code="singular-mass")
        self.condensed.append((body, [(other, k / whole) for other, k in star]))
        self.advice.append(Advice("condensed", worded("{n} has no mass: condensed exactly", n=name), severity="note"))
        rest = [(i, j, k) for i, j, k in springs if body not in (i, j)]
        for nth, (one, k) in enumerate(star):
            rest += [(one, other, k * more / whole) for other, more in star[nth + 1 :] if other != one]
        return rest

    def whole(self, shapes: "Any") -> "Any":
        """Shapes in rows with the massless bodies put back."""
        import numpy as np

        if not self.condensed:
            return shapes
        made = np.zeros((len(shapes), len(self.names)), dtype=shapes.dtype)
        made[:, self.kept] = shapes
        for body, star in reversed(self.condensed):
            made[:, body] = sum(weight * made[:, other] for other, weight in star if other != GROUND)
        return made

    # ---- matrices ----

    def _matrices(self, given: "Any") -> None:
        from dynamics_cli.vibration.systems.matrices import checked

        if isinstance(given, MatrixFiles):
            mass, stiffness = read_matrix(given.mass_file), read_matrix(given.stiffness_file)
            damping = read_matrix(given.damping_file) if given.damping_file else None
        else:
            mass, stiffness, damping = (  # type: ignore[assignment]
                None if one is None else [[a / b for a, b in row] for row in one]
                for one in (given.mass_matrix, given.stiffness_matrix, given.damping_matrix)
            )
        self.names = [str(i + 1) for i in range(len(mass))]
        self.kept = list(range(len(self.names)))
        self.mass, self.stiffness, self.damping = checked(mass, stiffness, damping)

    def matrices(self) -> "tuple[Any, Any, Any]":
        """Mass, stiffness and damping as arrays; damping None where there is none."""
        import numpy as np

        if self.elements is None:
            return self.mass, self.stiffness, self.damping
        damping = self.elements.assembled(self.dampers) if self.dampers else None
        return np.diag(self.elements.masses), self.elements.assembled(self.elements.springs), damping
