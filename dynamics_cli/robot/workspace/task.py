"""Workspace of an arm: how far it reaches, the area with its border and holes, and whether it reaches a point."""

from cmath import phase
from math import cos, hypot, pi, remainder

from dynamics_cli.errors import require
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.numerics.vectors import dot
from dynamics_cli.quantities import Angle, Annotated, Coordinate, Count, FloorArea, HandPosition, RoomVolume, Size, Text
from dynamics_cli.records import Advice, Check, Numerics, record
from dynamics_cli.robot.arms.chain import INFINITE, Chain, chain_of, limits
from dynamics_cli.robot.arms.records import Arm
from dynamics_cli.robot.workspace.border import Side, border, distance_to, extremes, loops
from dynamics_cli.robot.workspace.planar import TURN, PlanarArm
from dynamics_cli.robot.workspace.section import Section, section_of, ways_to

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Rounding, as a share of the arm's size; holes smaller than the second, as a share of its square, are rounding; gaps of
# the border up to the third are where what is reached is a sliver thinner than 1e-9 of the arm.
EXACT, SMALLEST, OPEN = 1e-12, 1e-9, 1e-3
YES = "yes"


@record
class Reaching:
    """One posture with which the point is reached."""

    number: Annotated[Count, "Its number."]
    angles: Annotated[tuple[Angle, ...], "Angles of the joints that decide the place [rad]."]
    travel: Annotated[Coordinate | None, "Travel of the prismatic joint [m]."]
    elbow: Annotated[Text | None, "Elbow to the left or to the right of the line to the point, of two links."]


@record
class BorderArc:
    """One arc of the border."""

    centre: Annotated[tuple[Coordinate, Coordinate], "Its centre, in the plane of the links [m]."]
    radius: Annotated[Size, "Its radius [m]."]
    start: Annotated[Angle, "Direction from the centre to its start [rad]."]
    end: Annotated[Angle, "To its end, counter-clockwise [rad]."]
    cause: Annotated[Text, "Links in line, or a joint at its limit."]


@record
class Workspace:
    """What an arm reaches."""

    reached: Annotated[Text | None, "Whether the point is reached within the limits."]
    from_border: Annotated[Size | None, "From the point to the border, in the plane of the links [m]."]
    tip: Annotated[Text, "What reaches: the hand, or the wrist centre of an arm with a wrist."]
    reach: Annotated[Size, "Farthest from the first axis [m]."]
    nearest: Annotated[Size, "Nearest to the first axis [m]."]
    lowest: Annotated[Coordinate | None, "Lowest along the first axis [m]."]
    highest: Annotated[Coordinate | None, "Highest along the first axis [m]."]
    area: Annotated[FloorArea, "Area reached, in the plane of the links: of arms that turn it, a section [m^2]."]
    both_elbows: Annotated[FloorArea | None, "Of it, reached with the elbow on either side; of two links [m^2]."]
    holes: Annotated[Count | None, "Holes in the area."]
    hole_area: Annotated[FloorArea | None, "Their area [m^2]."]
    volume: Annotated[RoomVolume | None, "Area times the stroke of a prismatic joint [m^3]."]
    first_turn: Annotated[Angle | None, "How far the first joint turns the plane of the links [rad]."]
    postures: Annotated[tuple[Reaching, ...] | None, "Postures at the point."]
    border: Annotated[tuple[BorderArc, ...], "Arcs of the border."]
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()
    numerics: Numerics | None = None


def workspace(
    arm: Annotated[Arm, "The arm, from a file."],
    /,
    *,
    position: Annotated[
        HandPosition | None, "A point (of planar arms two numbers do): is it reached, and how, e.g. 450, 100, 600 mm."
    ] = None,
) -> Workspace:
    """Reach of an arm with its limits, in the plane of its links.

    Equation
    --------
    On the border the joints that are not at a limit are in line with the hand, so the border is of arcs; they are cut
    where they meet, and a piece counts where one side is reached and the other is not. A = ½∮(x·dy − y·dx).

    Raises
    ------
    InadmissibleError
        When the links do not move in one plane that the first joint turns.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, section 19.2.

    Examples
    --------
    >>> round(workspace(Arm(lengths=(0.5, 0.4))).area, 12)
    2.513274122872
    """
    chain = over_plain(chain_of(arm))
    section = section_of(chain)
    links = section.arm
    sides = border(links.arcs(), links.reaches, links.size)
    require(bool(sides), "between its limits the arm reaches no area", code="no-area",
            hint="widen the limits of its joints")  # fmt: skip
    area = sum(side.area for side in sides)
    lines = loops(sides, links.size)
    sizes = [sum(side.area for side in line) for line in lines]
    holes = [-size for size in sizes if size < -SMALLEST * links.size**2]
    nearest, reach = _distances(section, sides)
    bottom, top = _heights(section, sides)
    asked = None if position is None else _asked(section, chain, sides, over_plain(position))
    slide = section.slide
    stroke = slide[3] - slide[2] if slide is not None else INFINITE
    low, high = limits(chain.joints[section.joints[0] if section.planar else 0])
    gap = max(abs(line[-1].ends[1] - line[0].ends[0]) for line in lines) / links.size
    closed = gap <= OPEN
    return Workspace(
        reached=None if asked is None else asked[0],
        from_border=None if asked is None else asked[1],
        postures=(asked[2] or None) if asked is not None else None,
        tip=section.tip,
        reach=reach,
        nearest=nearest,
        lowest=bottom,
        highest=top,
        area=area,
        both_elbows=_twice(links, area),
        holes=len(holes) if closed else None,
        hole_area=sum(holes) if closed and holes else None,
        volume=area * stroke if stroke < INFINITE else None,
        first_turn=None if section.planar else min(high - low, TURN),
        border=tuple(_row(side) for side in sides),
        advice=_advice(section, asked),
        checks=(Check("the border is closed", closed, gap, OPEN),),
        numerics=Numerics("arcs of circles"),
    )


def elbows(links: PlanarArm) -> "list[PlanarArm]":
    """Of two links, the arm with its elbow bent to the left alone, and to the right, where its limits let it."""
    straight = phase(links.links[0]) - phase(links.links[1])
    low, high = (limit - straight for limit in links.limits[1])
    spans = [(0.0, TURN)]
    if high - low < TURN:
        start = low % TURN
        end = start + high - low
        spans = [(start, min(end, TURN)), (0.0, end - TURN)]
    out = []
    for first, last in ((0.0, pi), (pi, TURN)):
        for start, end in spans:
            inner = max(start, first), min(end, last)
            if inner[1] - inner[0] > 1e-9:
                bends = inner[0] + straight, inner[1] + straight
                out.append(PlanarArm(links.links, (links.limits[0], bends), links.base))
    return out


def _twice(links: PlanarArm, area: float) -> float | None:
    """The area reached in two postures: what either elbow reaches, together, less the whole."""
    if len(links.links) != 2:
        return None
    straight = phase(links.links[0]) - phase(links.links[1])
    turn = min(links.limits[0][1] - links.limits[0][0], TURN)
    either = sum(abs(cos(each.limits[1][0] - straight) - cos(each.limits[1][1] - straight)) for each in elbows(links))
    return max(0.0, abs(links.links[0]) * abs(links.links[1]) * turn * either - area)


def _distances(section: Section, sides: "Sequence[Side]") -> "tuple[float, float]":
    """The least and the largest distance from the first axis."""
    nearest, reach = INFINITE, 0.0
    offset = section.offset if not section.planar else 0.0
    for side in sides:
        arc = side.arc
        # of planar arms from a point, of others from the line of the first axis
        ways = [phase(arc.centre), phase(-arc.centre)] if section.planar else [0.0, pi]
        far = [abs(place) if section.planar else abs(place.real) for place in extremes(arc, ways)]
        if not section.planar:
            reals = [place.real for place in extremes(arc, ways)]
            if min(reals) <= 0.0 <= max(reals):
                far.append(0.0)
        nearest, reach = min(nearest, *far), max(reach, *far)
    if section.planar and section.arm.reaches(0j):
        nearest = 0.0
    return hypot(nearest, offset), hypot(reach, offset)


def _heights(section: Section, sides: "Sequence[Side]") -> "tuple[float | None, float | None]":
    """The lowest and the highest place along the first axis."""
    if not section.planar:
        heights = [place.imag for side in sides for place in extremes(side.arc, (pi / 2.0, -pi / 2.0))]
        return min(heights), max(heights)
    if section.slide is None:
        return None, None
    _joint, sense, low, high = section.slide
    ends = sorted((section.offset + sense * low, section.offset + sense * high))
    return (None, None) if high - low == INFINITE else (ends[0], ends[1])


def _asked(
    section: Section, chain: Chain, sides: "Sequence[Side]", point: "tuple[float, float, float]"
) -> "tuple[str, float | None, tuple[Reaching, ...]]":
    """Whether a point is reached, its distance from the border, and the postures there."""
    ways = ways_to(section, point)
    lift = dot(section.plane.normal, point) - section.offset if section.planar else 0.0
    travel, fits = None, True
    if section.planar and section.slide is not None:
        _joint, sense, low, high = section.slide
        travel = sense * lift
        fits = low - EXACT <= travel <= high + EXACT
    else:
        require(
            abs(lift) <= EXACT * section.arm.size,
            "the point is {gap} out of the plane in which the arm moves", gap=(abs(lift), Size), code="out-of-reach",
        )  # fmt: skip
    free = PlanarArm(section.arm.links, ((-INFINITE, INFINITE),) * len(section.arm.links), section.arm.base)
    rows: list[Reaching] = []
    for place, first in zip(ways.places, ways.firsts, strict=True):
        if first is not None:
            low, high = limits(chain.joints[0])
            inside = PlanarArm((1.0,), ((low, high),)).within((first,))
            if inside is None:
                continue
            first = inside[0]
        for angles in section.arm.postures(place) if fits else ():
            turned = tuple(sense * angle for sense, angle in zip(section.senses, angles, strict=True))
            before = () if first is None else (first,)
            rows.append(Reaching(len(rows) + 1, before + turned, travel, _elbow(section, angles)))
    away = min((distance_to(side.arc, place) for side in sides for place in ways.places), default=None)
    if rows:
        return YES, away, tuple(rows)
    if any(free.reaches(place) for place in ways.places):
        return "no, a joint's limit stops it", away, ()
    return "no, out of reach", away, ()


def _advice(section: Section, asked: "tuple[Any, ...] | None") -> "tuple[Advice, ...]":
    if asked is None or not asked[2] or len(section.arm.links) == 2:
        return ()
    words = "three links reach the point in a family of postures; shown are its ends, a joint at a limit or two in line"
    return (Advice("family", words, severity="note"),)


def _elbow(section: Section, angles: "Sequence[float]") -> str | None:
    links = section.arm.links
    if len(links) != 2:
        return None
    bend = remainder(angles[1] + phase(links[1]) - phase(links[0]), TURN)
    return "straight" if abs(bend) < EXACT else "right" if bend > 0.0 else "left"


def _row(side: Side) -> BorderArc:
    arc = side.arc
    return BorderArc(
        centre=(arc.centre.real, arc.centre.imag), radius=arc.radius, start=remainder(arc.start, TURN),
        end=remainder(arc.start, TURN) + arc.end - arc.start, cause="links in line" if arc.singular else "limit",
    )  # fmt: skip
