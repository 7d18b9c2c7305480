"""The plane in which an arm's links move: the hand's of planar arms, the wrist centre's of arms that turn it about."""

from itertools import pairwise
from math import hypot, sqrt

from dynamics_cli.errors import require
from dynamics_cli.numerics.vectors import Vector, add, cross, dot, scale, subtract
from dynamics_cli.records import record
from dynamics_cli.robot.arms.chain import Chain, limits
from dynamics_cli.robot.inverse.structures import PARALLEL, PLANAR, POSITION, Structure, structure_of
from dynamics_cli.robot.inverse.subproblems import Plane, angle_about
from dynamics_cli.robot.workspace.planar import PlanarArm

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

# Lengths this small, as a share of the arm, are none; axes this near to a right angle are at it.
SHORT, SQUARE = 1e-12, 1e-9


@record
class Section:
    """The links as a planar arm, and how its plane lies in the base."""

    arm: PlanarArm
    structure: Structure
    plane: Plane
    joints: "tuple[int, ...]"
    """The joints that turn its links."""
    senses: "tuple[float, ...]"
    offset: float
    """Of the plane from the first axis, or from the base's origin."""
    slide: "tuple[int, float, float, float] | None"
    """Of a planar arm: the sliding joint, its sense along the normal, and its limits."""

    @property
    def planar(self) -> bool:
        """Whether the arm moves in this plane alone."""
        return self.structure.kind == PLANAR

    @property
    def tip(self) -> str:
        """What the plane shows the places of."""
        return "hand" if self.structure.kind in (PLANAR, POSITION) else "wrist centre"


def section_of(chain: Chain) -> Section:
    """The plane of an arm with a known structure."""
    structure = structure_of(chain)
    return _planar(structure, chain) if structure.kind == PLANAR else _upright(structure, chain)


def _planar(structure: Structure, chain: Chain) -> Section:
    plane = Plane(structure.axes[0] if structure.axes[0][2] != -1.0 else (0.0, 0.0, 1.0))
    joints = structure.turns
    places = [structure.points[joint] for joint in joints] + [structure.hand]
    if len(joints) == 3 and abs(plane.flat(subtract(places[3], places[2]))) < SHORT * structure.size:
        joints = joints[:2]
        del places[2]
    slides = [index for index, turning in enumerate(structure.turning) if not turning]
    slide = None
    if slides:
        sense = structure.sense(slides[0], plane.normal)
        slide = (slides[0], sense, *limits(chain.joints[slides[0]]))
    return _section(structure, chain, plane, joints, places, dot(plane.normal, structure.hand), slide)


def _upright(structure: Structure, chain: Chain) -> Section:
    """The plane along the first axis, outwards to the right."""
    up, axis = structure.axes[0], structure.axes[1]
    require(
        abs(dot(up, axis)) < SQUARE,
        "axes 1 and 2 are not at right angles: the links do not move in a plane along the first axis",
        code="no-section", hint="`robot inverse` says whether a pose is reached",
    )  # fmt: skip
    joints = (1, 2, 3) if structure.kind == PARALLEL else (1, 2)
    places = [structure.points[joint] for joint in joints] + [structure.centre]
    out = cross(up, axis)
    if dot(out, subtract(structure.centre, structure.points[0])) < 0.0:
        out = scale(-1.0, out)
    plane = Plane(cross(out, up))
    plane.first, plane.second = out, up
    offset = dot(plane.normal, subtract(structure.centre, structure.points[0]))
    return _section(structure, chain, plane, joints, places, offset, None)


def _section(
    structure: Structure, chain: Chain, plane: Plane, joints: "Sequence[int]", places: "list[Vector]",
    offset: float, slide: "tuple[int, float, float, float] | None",
) -> Section:  # fmt: skip
    flat = [plane.flat(subtract(place, structure.points[joints[0]])) for place in places]
    links = tuple(after - before for before, after in pairwise(flat))
    require(
        all(abs(link) > SHORT * structure.size for link in links),
        "a link has no length in the plane of the arm: its reach has no area", code="no-area",
    )  # fmt: skip
    senses = tuple(structure.sense(joint, plane.normal) for joint in joints)
    bounds = []
    for joint, sense in zip(joints, senses, strict=True):
        low, high = limits(chain.joints[joint])
        bounds.append((low, high) if sense > 0.0 else (-high, -low))
    origin = structure.points[0] if structure.kind != PLANAR else (0.0, 0.0, 0.0)
    base = plane.flat(subtract(structure.points[joints[0]], origin))
    if structure.kind != PLANAR:
        base += 1j * dot(plane.second, structure.points[0])
    arm = PlanarArm(links, tuple(bounds), base)
    return Section(arm, structure, plane, tuple(joints), senses, offset, slide)


@record
class Ways:
    """Where a point lies in the section for each angle of the first joint that allows it, and that angle."""

    places: "tuple[complex, ...]"
    firsts: "tuple[float | None, ...]"
    gap: float = 0.0
    """How far the point is from where any angle would do."""


def ways_to(section: Section, point: Vector) -> Ways:
    """The places in the section that are the point: one of a planar arm, two of others, in front and at the back."""
    structure, plane = section.structure, section.plane
    if section.planar:
        return Ways((plane.flat(point),), (None,), 0.0)
    way = subtract(point, structure.points[0])
    height = dot(plane.second, point)
    across = subtract(way, scale(dot(plane.second, way), plane.second))
    far = hypot(*across)
    inner = (far - abs(section.offset)) * (far + abs(section.offset))
    if inner < 0.0:
        return Ways((), (), abs(section.offset) - far)
    outs = (sqrt(inner), -sqrt(inner)) if inner else (0.0,)
    firsts = []
    for out in outs:
        start = add(scale(out, plane.first), scale(section.offset, plane.normal))
        firsts.append(angle_about(structure.axes[0], start, across) if far else 0.0)
    return Ways(tuple(complex(out, height) for out in outs), tuple(firsts))
