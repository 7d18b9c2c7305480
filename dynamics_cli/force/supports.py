"""Supports by their type: the lines along which they push, the axes about which they hold."""

from dynamics_cli.errors import require
from dynamics_cli.force import ratios
from dynamics_cli.force.system import direction
from dynamics_cli.numerics.exact.rational import nearest
from dynamics_cli.quantities import Annotated, FreeVector, LoadPoint, Text
from dynamics_cli.records import Advice, Choice, Quantity, record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.force.ratios import Ratios
    from dynamics_cli.numerics.exact.rational import Pair

ALONG_ONE_LINE = ("roller", "smooth", "link", "cable")
# Rows of equilibrium: in the plane x, y and about z; in space along and about three axes.
PLANE = (0, 1, 5)
SPACE = (0, 1, 2, 3, 4, 5)


class Holding(Choice):
    """Types of support."""

    names = ("pin", "roller", "fixed", "link", "cable", "smooth", "guide", "ball", "hinge")
    aliases = {  # noqa: RUF012
        "pinned": "pin", "hinged": "pin", "built-in": "fixed", "clamped": "fixed", "clamp": "fixed", "weld": "fixed",
        "encastre": "fixed", "rope": "cable", "rocker": "roller", "slider": "guide", "collar": "guide",
        "strut": "link", "rod": "link", "wall": "smooth", "frictionless": "smooth", "ball-and-socket": "ball",
        "socket": "ball",
    }  # fmt: skip


@record
class Support:
    """A support of the body at a point."""

    type: Annotated[Holding, "pin, roller, fixed, link, cable, smooth, guide; in space ball, hinge."]
    at: Annotated[LoadPoint, "Where it holds, e.g. 0, 0 m."]
    direction: Annotated[
        FreeVector | None, "Push of a roller, pull of a cable, line of a link or hinge, e.g. 0, 1."
    ] = None
    name: Annotated[Text | None, "Its name, e.g. A."] = None


def left_out(supports: "Sequence[Support] | None") -> "tuple[Advice, ...]":
    """Say that the supports of a scene take no part in a sum of loads."""
    if not supports:
        return ()
    message = "the supports take no part: these are the loads alone, without reactions"
    return (Advice("supports", message, "note", "`dynamics force equilibrium` gives the reactions"),)


class Unknown:
    """One unknown of a support: a force along an axis, or a couple about it."""

    __slots__ = ("axis", "couple", "force", "moment", "support")

    def __init__(self, support: int, axis: "Ratios", at: "Ratios", *, couple: bool) -> None:
        self.support = support
        self.couple = couple
        self.axis = axis
        self.force = ratios.NONE if couple else axis
        self.moment = axis if couple else ratios.cross(at, axis)

    @property
    def column(self) -> "tuple[Pair, ...]":
        """Its part in the six equations of equilibrium."""
        return (*self.force, *self.moment)


class ExactSupport:
    """A support with its unknowns, in exact numbers."""

    __slots__ = ("at", "direction", "name", "type", "unknowns")

    def __init__(self, given: Support, index: int, *, planar: bool) -> None:
        # in the plane a hinge is a pin
        self.type = "pin" if planar and given.type == "hinge" else str(given.type)
        self.name = str(given.name) if given.name else chr(65 + index) if index < 26 else str(index + 1)
        self.at = ratios.of_vector(given.at)
        self.direction = self._direction(given, planar=planar)
        self.unknowns = [Unknown(index, axis, self.at, couple=couple) for axis, couple in self._axes(planar=planar)]

    def _direction(self, given: Support, *, planar: bool) -> "Ratios | None":
        if given.direction is not None:
            return direction(given.direction, f"the direction of support {self.name}")
        needed = self.type in ("link", "cable", "hinge") or (not planar and self.type in (*ALONG_ONE_LINE, "guide"))
        require(
            not needed,
            "support {name} is a {type} and needs a direction",
            name=self.name,
            type=self.type,
            code="no-direction",
            hint="add direction=1 @ 60 deg, or direction=0, 1",
        )
        return ratios.AXES[1] if self.type in (*ALONG_ONE_LINE, "guide") else None

    def _axes(self, *, planar: bool) -> "list[tuple[Ratios, bool]]":
        """The axis of each unknown, and whether it is a couple."""
        x, y, z = ratios.AXES
        spatial = [(axis, False) for axis in ratios.AXES]
        require(
            planar or self.type not in ("pin", "guide"),
            "support {name} is a {type}, which holds in the plane only; this problem is in space",
            name=self.name,
            type=self.type,
            code="space",
            hint="use ball, hinge, fixed, link, cable, roller or smooth",
        )
        if self.type in ALONG_ONE_LINE:
            assert self.direction is not None
            return [(self.direction, False)]
        if self.type == "guide":
            assert self.direction is not None
            return [(self.direction, False), (z, True)]
        if planar:
            return [(x, False), (y, False), *([(z, True)] if self.type == "fixed" else [])]
        if self.type == "ball":
            return spatial
        if self.type == "fixed":
            return [*spatial, *((axis, True) for axis in ratios.AXES)]
        assert self.direction is not None
        smallest = min((0, 1, 2), key=lambda i: (abs(nearest(self.direction[i])), i))  # type: ignore[index]
        first = ratios.cross(self.direction, ratios.AXES[smallest])
        return [*spatial, (first, True), (ratios.cross(self.direction, first), True)]


def lie_in_a_plane(supports: "Sequence[Support]") -> bool:
    """Whether all supports lie in a plane parallel to x–y."""
    heights = {ratios.of_vector(support.at)[2] for support in supports}
    return len(heights) <= 1 and not any(_spatial(support) for support in supports)


def _spatial(support: Support) -> bool:
    """A ball, a hinge about an axis in the plane, or a direction out of the plane."""
    given = support.direction
    way = given.value if isinstance(given, Quantity) else given
    x, y, z = (*way, 0.0, 0.0)[:3] if isinstance(way, tuple | list) else (0.0, 0.0, 0.0)
    if support.type == "hinge":
        return bool(x or y)
    return support.type == "ball" or z != 0.0
