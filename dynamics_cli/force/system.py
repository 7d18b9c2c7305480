"""A system of forces at points, and of couples, with exact sums."""

from dynamics_cli.errors import require, worded
from dynamics_cli.force import ratios
from dynamics_cli.quantities import Annotated, Force, FreeVector, LoadPoint, Ratio, Torque
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


def vector(given: "Any", kind: "Any", what: str, example: str) -> "Ratios":
    """The exact components of a vector of this kind; a single number is a couple in the plane."""
    value = given.value if isinstance(given, Quantity) else given
    parts = value if isinstance(value, tuple | list) else (value,)
    if isinstance(given, Quantity):
        require(
            given.kind.unit == kind.unit,
            "{what} is a {name}; wanted a {kind}",
            what=what,
            name=given.kind.name or "number",
            kind=kind.name or "direction without a unit",
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

    def __init__(self, loads: "Any", couples: "Any", *, needed: bool = True) -> None:
        load_records, couple_records = _several(loads), _several(couples)
        require(
            bool(load_records or couple_records) or not needed,
            "neither a force nor a couple is given",
            code="missing",
            hint=f"such as {EXAMPLE}",
        )
        self.forces = [
            vector(load.force, Force, f"force {n}", "'3, 4 N' or '20 N @ 30 deg'")
            for n, load in enumerate(load_records, 1)
        ]
        self.points = [ratios.of_vector(load.at) for load in load_records]
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


def _several(given: "Any") -> "tuple[Any, ...]":
    if given is None:
        return ()
    return given if isinstance(given, tuple) else (given,)
