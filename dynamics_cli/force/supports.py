"""Supports by name: along which lines they push, about which axes they hold."""

from dynamics_cli.errors import require
from dynamics_cli.force import ratios
from dynamics_cli.force.system import direction
from dynamics_cli.numerics.exact.rational import nearest
from dynamics_cli.quantities import Annotated, FreeVector, LoadPoint, Text
from dynamics_cli.records import Choice, Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.force.ratios import Ratios
    from dynamics_cli.numerics.exact.rational import Pair

ALONG_ONE_LINE = ("roller", "smooth", "link", "cable")
# What lies in a plane holds by x, y and about z; in space along and about three axes.
PLANE = (0, 1, 5)
SPACE = (0, 1, 2, 3, 4, 5)


class Holding(Choice):
    """What a support is."""

    names = ("pin", "roller", "fixed", "link", "cable", "smooth", "guide", "ball", "hinge")
    aliases = {"hinged": "pin", "built-in": "fixed", "clamped": "fixed", "rope": "cable", "slider": "guide"}  # noqa: RUF012


@record
class Support:
    """What holds the body at a point."""

    type: Annotated[Holding, "pin, roller, fixed, link, cable, smooth, guide; in space ball, hinge."]
    at: Annotated[LoadPoint, "Where it holds, e.g. 0, 0 m."]
    direction: Annotated[
        FreeVector | None, "Push of a roller, pull of a cable, line of a link or hinge, e.g. 0, 1."
    ] = None
    name: Annotated[Text | None, "Its name, e.g. A."] = None


class Unknown:
    """One unknown of a support: a force along a line, or a couple about an axis; `turning` is its moment."""

    __slots__ = ("couple", "force", "support", "turning", "way")

    def __init__(self, support: int, way: "Ratios", at: "Ratios", *, couple: bool) -> None:
        self.support = support
        self.couple = couple
        self.way = way
        self.force = ratios.NONE if couple else way
        self.turning = way if couple else ratios.cross(at, way)

    @property
    def column(self) -> "tuple[Pair, ...]":
        """Its part in the six equations of equilibrium."""
        return (*self.force, *self.turning)


class Read:
    """A support as read."""

    __slots__ = ("at", "name", "type", "unknowns", "way")

    def __init__(self, given: Support, index: int, *, planar: bool) -> None:
        self.type = str(given.type)
        self.name = str(given.name) if given.name else chr(65 + index) if index < 26 else str(index + 1)
        self.at = ratios.of_vector(given.at)
        self.way = self._way(given, planar=planar)
        self.unknowns = [Unknown(index, way, self.at, couple=couple) for way, couple in self._ways(planar=planar)]

    def _way(self, given: Support, *, planar: bool) -> "Ratios | None":
        if given.direction is not None:
            return direction(given.direction, f"the direction of support {self.name}")
        needed = self.type in ("link", "cable", "hinge") or (not planar and self.type in (*ALONG_ONE_LINE, "guide"))
        require(
            not needed,
            "support {name} is a {type} without a direction",
            name=self.name,
            type=self.type,
            code="no-direction",
            hint="add direction=1 @ 60 deg, or direction=0, 1",
        )
        return ratios.AXES[1] if self.type in (*ALONG_ONE_LINE, "guide") else None

    def _ways(self, *, planar: bool) -> "list[tuple[Ratios, bool]]":
        """Each unknown's line or axis, and whether it is a couple."""
        x, y, z = ratios.AXES
        spatial = [(way, False) for way in ratios.AXES]
        require(
            planar or self.type not in ("pin", "guide"),
            "support {name} is a {type}, which is one of the plane; this problem is in space",
            name=self.name,
            type=self.type,
            code="space",
            hint="give ball, hinge, fixed, link, cable, roller or smooth",
        )
        if self.type in ALONG_ONE_LINE:
            assert self.way is not None
            return [(self.way, False)]
        if self.type == "guide":
            assert self.way is not None
            return [(self.way, False), (z, True)]
        if planar:
            return [(x, False), (y, False), *([(z, True)] if self.type == "fixed" else [])]
        if self.type == "ball":
            return spatial
        if self.type == "fixed":
            return [*spatial, *((way, True) for way in ratios.AXES)]
        assert self.way is not None
        axis = min((0, 1, 2), key=lambda i: (abs(nearest(self.way[i])), i))  # type: ignore[index]
        first = ratios.cross(self.way, ratios.AXES[axis])
        return [*spatial, (first, True), (ratios.cross(self.way, first), True)]


def lie_in_a_plane(supports: "Sequence[Support]") -> bool:
    """Whether no support reaches out of the x–y plane."""
    heights = {ratios.of_vector(one.at)[2] for one in supports}
    ways = [one.direction.value if isinstance(one.direction, Quantity) else one.direction for one in supports]
    upright = any(way is not None and len(way) == 3 and way[2] != 0.0 for way in ways if not isinstance(way, float))
    return len(heights) <= 1 and not upright and not any(one.type in ("ball", "hinge") for one in supports)
