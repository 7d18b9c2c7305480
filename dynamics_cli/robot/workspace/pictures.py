"""The area that an arm reaches, with its border, what each elbow reaches, and singular curves."""

from cmath import exp, phase

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Picture, complex_curve
from dynamics_cli.quantities import Coordinate, FloorArea
from dynamics_cli.robot.arms.chain import chain_of
from dynamics_cli.robot.arms.records import Arm
from dynamics_cli.robot.workspace.border import Side, border, loops, points_of
from dynamics_cli.robot.workspace.planar import PlanarArm
from dynamics_cli.robot.workspace.section import Section, section_of, ways_to
from dynamics_cli.robot.workspace.task import elbows

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

GREY, BORDER, LEFT, RIGHT, LINKS = 6, 0, 1, 2, 3


def workspace_picture(result: "Any", arm: Arm, *, position: "Any" = None, **_: "Any") -> Picture:
    """The area and its border; of two links the edges of either elbow; where the links are in line; the postures."""
    section = section_of(over_plain(chain_of(arm)))
    links = section.arm
    sides = border(links.arcs(), links.reaches, links.size)
    items: list[Any] = [*_area(sides, links.size), *_elbows(section)]
    for line in loops(sides, links.size):
        points = [point for side in line for point in points_of(side)]
        items.append(complex_curve(points, "" if line[0] is not sides[0] else "border", "thick", BORDER))
    items += [*_singular(section), *_postures(section, result, position)]
    if section.planar:
        items.append(Mark(0.0, 0.0, "first axis", (6.0, -12.0), role=GREY))
    names = ("x", "y") if section.planar else ("outwards from the first axis", "along the first axis")
    panel = Panel(Axis(names[0], Coordinate), Axis(names[1], Coordinate), tuple(items), equal=True)
    title = worded(f"workspace of the {section.tip}: {{area}}", area=(result.area, FloorArea))
    words = "seen from above" if section.planar else "section through the first axis, which turns it"
    return Picture((panel,), title, subtitle=words)


def _area(sides: "list[Side]", size: float) -> "list[Any]":
    """The area faintly filled: holes are cut out by a seam to the line around them."""
    outlines = [[point for side in line for point in points_of(side)] for line in loops(sides, size)]
    outlines.sort(key=lambda line: -max(map(abs, line)))
    points: list[complex] = []
    for line in outlines:
        points += [*line, line[0]]
        points.append(outlines[0][0])
    return [complex_curve(points, "", "fill", BORDER)]


def _elbows(section: Section) -> "list[Any]":
    """The edges of what either elbow reaches."""
    items: list[Any] = []
    named: set[int] = set()
    straight = len(section.arm.links) == 2
    for each in elbows(section.arm) if straight else ():
        bend = 0.5 * sum(each.limits[1])
        turn = exp(1j * (bend + phase(each.links[1]) - phase(each.links[0])))
        role, name = (RIGHT, "elbow right") if turn.imag > 0.0 else (LEFT, "elbow left")
        for line in loops(border(each.arcs(), each.reaches, each.size), each.size):
            points = [point for side in line for point in points_of(side)]
            items.append(complex_curve(points, "" if role in named else name, "dashed", role))
            named.add(role)
    return items


def _singular(section: Section) -> "list[Any]":
    """Where the links are in line, and of arms that turn their plane the first axis."""
    items: list[Any] = []
    for number, arc in enumerate(arc for arc in section.arm.arcs() if arc.singular):
        items.append(complex_curve(points_of(Side(arc, True)), "" if number else "links in line", "dotted", GREY))
    if not section.planar:
        heights = [point.imag for arc in section.arm.arcs() for point in (arc.at(arc.start), arc.at(arc.end))]
        items.append(Curve([0.0, 0.0], [min(heights), max(heights)], "first axis", "centre", GREY))
    return items


def _postures(section: Section, result: "Any", position: "Any") -> "list[Any]":
    """The links in each posture at the point."""
    if position is None:
        return []
    items: list[Any] = []
    links = section.arm
    for posture in result.postures or ():
        turned = posture.angles if section.planar else posture.angles[1:]
        angles = [sense * angle for sense, angle in zip(section.senses, turned, strict=True)]
        parts = [PlanarArm(links.links[:count], (), links.base).point(angles[:count]) for count in range(len(angles))]
        line = [complex(0.0, links.base.imag if not section.planar else 0.0), *parts, links.point(angles)]
        items.append(complex_curve(line, "", "solid", LINKS))
    places = ways_to(section, over_plain(tuple(position))).places[: None if result.postures else 1]
    words = "" if result.postures else "not reached"
    return items + [Mark(place.real, place.imag, words, (7.0, 5.0), role=LINKS) for place in places]
