"""A system of forces at points, and of couples, with exact sums."""

from dynamics_cli.errors import require, worded
from dynamics_cli.force import ratios
from dynamics_cli.quantities import Annotated, DistributedForce, Force, FreeVector, LoadPoint, Ratio, Torque
from dynamics_cli.records import Advice, Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.force.ratios import Ratios

MOST_CANCELLED = 1e6
EXAMPLE = '--load "force=0, -500 N, at=2, 0 m"'


@record
class Load:
    """A force with the point where it acts."""

    adds = True
    force: Annotated[FreeVector, "The force, e.g. 200 N @ 30 deg."]
    at: Annotated[LoadPoint, "Where it acts, e.g. 2, 0 m."]


@record
class Couple:
    """A couple: a moment without a place."""

    adds = True
    moment: Annotated[FreeVector, "Its moment, e.g. 5 N*m."]


@record
class Distributed:
    """A load spread along a line, constant or changing evenly from one end to the other."""

    force: Annotated[FreeVector, "Force per length where it begins, e.g. 300 N/m down."]
    from_: Annotated[LoadPoint, "Where it begins, e.g. 0 m."]
    to: Annotated[LoadPoint, "Where it ends, e.g. 4 m."]
    end_force: Annotated[FreeVector | None, "Force per length where it ends; constant if left out."] = None


def vector(given: "Any", kind: "Any", what: str, example: str) -> "Ratios":
    """The exact components of a vector of this kind; a single number is a couple in the plane."""
    value = given.value if isinstance(given, Quantity) else given
    parts = value if isinstance(value, tuple | list) else (value,)
    if isinstance(given, Quantity):
        require(
            given.kind.unit == kind.unit,
            "{what} is {name}; wanted {kind}",
            what=what,
            name=given.kind.one if given.kind.name else "a number",
            kind=kind.one if kind.name else "a direction without a unit",
            code="kind",
            hint=f"write {example}",
        )
    require(
        len(parts) > 1 or kind is Torque,
        "{what} has a size but no direction",
        what=what,
        code="no-direction",
        hint=f"write {example}",
    )
    return ratios.of_vector(parts)


def direction(given: "Any", what: str) -> "Ratios":
    """The exact components of a direction; refuses a zero vector."""
    components = vector(given, Ratio, what, "'0, 1' or '1 @ 60 deg'")
    require(not ratios.is_zero(components), "{what} is zero", what=what, code="zero-vector", hint="give a direction")
    return components


class System:
    """Forces at their points and couples, with their sum and its moment about the origin."""

    __slots__ = ("couples", "force", "forces", "moment", "points", "total_size")

    def __init__(self, loads: "Any", couples: "Any", distributed: "Any" = None, *, needed: bool = True) -> None:
        load_records, couple_records, spread = _several(loads), _several(couples), _several(distributed)
        require(
            bool(load_records or couple_records or spread) or not needed,
            "neither a force nor a couple is given",
            code="missing",
            hint=f"such as {EXAMPLE}",
        )
        self.forces = [
            vector(load.force, Force, f"force {n}", "'3, 4 N' or '20 N @ 30 deg'")
            for n, load in enumerate(load_records, 1)
        ]
        self.points = [ratios.of_vector(load.at) for load in load_records]
        for n, line in enumerate(spread, 1):
            for force, point in _resultants(line, n):
                self.forces.append(force)
                self.points.append(point)
        self.couples = [
            vector(couple.moment, Torque, f"couple {n}", "'5 N*m', or '2, -3, 0.5 N*m' in space")
            for n, couple in enumerate(couple_records, 1)
        ]
        self.force, moment_of_forces = ratios.sums(self.points, self.forces)
        self.moment = ratios.plus(moment_of_forces, *self.couples)
        self.total_size = sum(ratios.size(force) for force in self.forces)

    def moment_about(self, point: "Ratios") -> "Ratios":
        """M_Q = M_O − Q × R."""
        return ratios.minus(self.moment, ratios.cross(point, self.force))

    @property
    def planar(self) -> bool:
        """Whether everything lies in the x–y plane or in a parallel plane."""
        heights = {point[2] for point in self.points}
        return (
            len(heights) <= 1
            and not any(force[2][0] for force in self.forces)
            and not any(part[0] for couple in self.couples for part in couple[:2])
        )

    def advice(self) -> "tuple[Advice, ...]":
        """A caution where forces cancel: measured ones then leave few digits."""
        size = ratios.size(self.force)
        if not size or self.total_size / size <= MOST_CANCELLED:
            return ()
        message = worded(
            "the forces cancel: their sizes add up to {times} times the resultant",
            times=(self.total_size / size, Ratio),
        )
        return (
            Advice("cancellation", message, remedy="typed digits count as exact: check that they are known so well"),
        )


def _resultants(line: Distributed, number: int) -> "list[tuple[Ratios, Ratios]]":
    """The resultants of an even load and of what it grows by, each with its point; lengths to 15 digits."""
    name = f"distributed load {number}"
    start, end = (
        None if given is None else vector(given, DistributedForce, f"the force of {name}", "'300 N/m down'")
        for given in (line.force, line.end_force)
    )
    assert start is not None
    begins, ends = ratios.of_vector(line.from_), ratios.of_vector(line.to)
    way = ratios.minus(ends, begins)
    require(not ratios.is_zero(way), "{name} has no length", name=name, code="no-length", hint="give from and to")
    axes = [part for part in way if part[0]]
    length = (abs(axes[0][0]), axes[0][1]) if len(axes) == 1 else ratios.of_number(ratios.size(way))
    half = ratios.over(length, (2, 1))
    parts = [(ratios.times(length, start), (1, 2))]
    if end is not None:
        parts.append((ratios.times(half, ratios.minus(end, start)), (2, 3)))
    return [
        (force, ratios.plus(begins, ratios.times(share, way))) for force, share in parts if not ratios.is_zero(force)
    ]


def _several(given: "Any") -> "tuple[Any, ...]":
    if given is None:
        return ()
    return given if isinstance(given, tuple) else (given,)
