"""A system of forces at points and couples, summed exactly."""

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
    """A couple, which has a moment and no place."""

    adds = True
    moment: Annotated[FreeVector, "Its moment, e.g. 5 N*m."]


def vector(given: "Any", kind: "Any", what: str, example: str) -> "Ratios":
    """The exact components of a vector that must be of this kind; one number alone is a couple in the plane."""
    value = given.value if isinstance(given, Quantity) else given
    parts = value if isinstance(value, tuple | list) else (value,)
    if isinstance(given, Quantity):
        require(
            given.kind.unit == kind.unit,
            "{what} is a {name}, wanted a {kind}",
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
    """The exact components of a direction, which is not zero."""
    way = vector(given, Ratio, what, "'0, 1' or '1 @ 60 deg'")
    require(not ratios.is_zero(way), "{what} is zero", what=what, code="zero-vector", hint="give a direction")
    return way


class System:
    """Forces with their points and couples, and what they add up to about the origin."""

    __slots__ = ("couples", "flow", "force", "forces", "moment", "points")

    def __init__(self, loads: "Any", couples: "Any", *, needed: bool = True) -> None:
        those = _several(loads)
        turns = _several(couples)
        require(
            bool(those or turns) or not needed,
            "no force and no couple is given",
            code="missing",
            hint=f"such as {EXAMPLE}",
        )
        self.forces = [
            vector(one.force, Force, f"force {n}", "'3, 4 N' or '20 N @ 30 deg'") for n, one in enumerate(those, 1)
        ]
        self.points = [ratios.of_vector(one.at) for one in those]
        self.couples = [
            vector(one.moment, Torque, f"couple {n}", "'5 N*m', or '2, -3, 0.5 N*m' in space")
            for n, one in enumerate(turns, 1)
        ]
        self.force, turning = ratios.turning(self.points, self.forces)
        self.moment = ratios.plus(turning, *self.couples)
        self.flow = sum(ratios.size(one) for one in self.forces)

    def moment_about(self, point: "Ratios") -> "Ratios":
        """M_Q = M_O − Q × R."""
        return ratios.minus(self.moment, ratios.cross(point, self.force))

    @property
    def planar(self) -> bool:
        """Whether all of it lies in the x–y plane, or one parallel to it."""
        level = {point[2] for point in self.points}
        return (
            len(level) <= 1
            and not any(force[2][0] for force in self.forces)
            and not any(part[0] for couple in self.couples for part in couple[:2])
        )

    def advice(self) -> "tuple[Advice, ...]":
        """What cancels leaves few digits of measured forces."""
        size = ratios.size(self.force)
        if not size or self.flow / size <= MOST_CANCELLED:
            return ()
        message = worded(
            "the forces cancel: their sizes add to {times} times the resultant", times=(self.flow / size, Ratio)
        )
        return (
            Advice("cancellation", message, remedy="the answer is that of the digits typed: check that they are known"),
        )


def _several(given: "Any") -> "tuple[Any, ...]":
    if given is None:
        return ()
    return given if isinstance(given, tuple) else (given,)
