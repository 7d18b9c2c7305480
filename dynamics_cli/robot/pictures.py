"""Pictures of arms: one posture, and every posture of a pose."""

from math import cos, hypot, pi, radians, sin

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.numerics.orientation.rotations import IDENTITY
from dynamics_cli.numerics.vectors import Vector
from dynamics_cli.numerics.vectors import times as turned
from dynamics_cli.pictures import Arrow, Axis, Curve, Label, Mark, Panel, Picture
from dynamics_cli.pictures.vectors import GREY, arrow, corner, curve, from_above, times, unit
from dynamics_cli.quantities import Coordinate, Force, Torque
from dynamics_cli.robot.arms.chain import BASE, Chain, Frame, chain_of, coordinates_of
from dynamics_cli.robot.arms.records import ORIGIN, REVOLUTE, Arm
from dynamics_cli.robot.pose import is_planar

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Lengths of a hand's axes, and half the height of a joint, as shares of the arm.
HAND, DRUM = 0.12, 0.035
# Points nearer than this share of the arm are one.
SAME = 1e-6
# Longest half axis of an ellipsoid as a share of the arm, and the points of an ellipse.
SHOWN, POINTS = 0.22, 72
# How far the fastest joint has moved in the posture drawn dotted.
LATER = radians(10.0)
AXES = ("x", "y", "z")
# Where the eye is: before the arm and to its right.
AZIMUTH, ELEVATION = radians(-62.0), radians(22.0)


def bones(chain: Chain, coordinates: "Sequence[float]") -> "list[Vector]":
    """The arm as a line: along each joint's axis to where the link leaves it, along the link, to the next axis."""
    links = chain.links(coordinates)
    points: list[Vector] = [ORIGIN]
    before = BASE
    for joint, coordinate, link in zip(chain.joints, coordinates, links, strict=True):
        if chain.standard:
            rise = joint.d if joint.type == REVOLUTE else joint.d + coordinate
            points.append(before.point((0.0, 0.0, rise)))
        else:
            points.append(before.point((joint.a, 0.0, 0.0)))
        points.append(link.position)
        before = link
    points.append(chain.hand(links).position)
    size = SAME * chain.reach
    kept = points[:1]
    for point in points[1:]:
        if hypot(*(a - b for a, b in zip(point, kept[-1], strict=True))) > size:
            kept.append(point)
    return kept


def from_side(v: "Sequence[float]") -> "tuple[float, float]":
    """A vector on paper: x to the right, y inwards, z up."""
    right = -sin(AZIMUTH) * v[0] + cos(AZIMUTH) * v[1]
    outward = cos(AZIMUTH) * v[0] + sin(AZIMUTH) * v[1]
    return right, cos(ELEVATION) * v[2] - sin(ELEVATION) * outward


def seen_from(chain: Chain) -> "Any":
    """From above for arms that move in a level plane, else from the side."""
    return from_above if is_planar(chain) else from_side


def posture(
    chain: Chain, coordinates: "Sequence[float]", role: int, label: str = "", style: str = "thick"
) -> "list[Any]":
    """The arm as a line."""
    flat = [seen_from(chain)(point) for point in bones(chain, coordinates)]
    return [Curve([x for x, _ in flat], [y for _, y in flat], label, style, role)]  # type: ignore[arg-type]


def joint_marks(chain: Chain, coordinates: "Sequence[float]", role: int) -> "list[Any]":
    """The joints: dots of a planar arm, else short lines along the axes."""
    view = seen_from(chain)
    frames = chain.axes(chain.links(coordinates))
    if is_planar(chain):
        places = [view(frame.position) for frame in frames]
        return [Mark(x, y, name, role=role) for name, (x, y) in zip(chain.names, places, strict=True)]
    size = DRUM * chain.reach
    points = bones(chain, coordinates)
    floor = min(0.0, *(point[2] for point in points))
    items: list[Any] = [curve([(x, y, floor) for x, y, _ in points], "dots", GREY, view)]
    for frame in frames:
        ends = [times(sign * size, frame.z, frame.position) for sign in (-1.0, 1.0)]
        items.append(curve(ends, "thick", GREY, view))
    return items


def hand_axes(chain: Chain, hand: Frame) -> "list[Any]":
    """The axes of the hand."""
    if is_planar(chain):
        return []
    size = HAND * chain.reach
    items: list[Any] = []
    for k, name in enumerate(AXES):
        way = times(size, unit([row[k] for row in hand.rotation]))
        item = arrow(way, "", GREY, seen_from(chain), start=hand.position)
        items += [item, Label(item.x + 1.25 * item.dx, item.y + 1.25 * item.dy, name)]
    return items


def panel(chain: Chain, items: "list[Any]", title: "Any" = "") -> Panel:
    """A panel on one scale; of an arm in space without axes, with a small tripod of the base's directions."""
    if is_planar(chain):
        return Panel(Axis("x", Coordinate), Axis("y", Coordinate), tuple(items), title, equal=True)
    return Panel(
        Axis("", Coordinate), Axis("", Coordinate), (*items, *corner(items, from_side)), title, equal=True, bare=True
    )


def pose_picture(result: "Any", arm: Arm, *, angles: "Any" = (), slides: "Any" = (), **_: "Any") -> Picture:
    """The arm with its joints and the axes of its hand."""
    chain = over_plain(chain_of(arm))
    coordinates = coordinates_of(chain, over_plain(tuple(angles)), over_plain(tuple(slides)))
    hand = chain.hand(chain.links(coordinates))
    items = [*posture(chain, coordinates, 0), *joint_marks(chain, coordinates, GREY), *hand_axes(chain, hand)]
    return Picture((panel(chain, items),), f"arm of {len(chain.joints)} joints", subtitle=_view(chain))


def _view(chain: Chain) -> str:
    return (
        "seen from above" if is_planar(chain) else "short black lines: axes of the joints; dotted: the arm on the floor"
    )


def inverse_picture(result: "Any", arm: Arm, **_: "Any") -> Picture:
    """Every posture that gives the pose, the first one bold; those that differ in the wrist alone fall together."""
    chain = over_plain(chain_of(arm))
    items: list[Any] = []
    shapes: list[tuple[tuple[float, ...], list[int], Any]] = []
    for solution in result.solutions:
        coordinates = coordinates_of(chain, solution.angles, solution.slides or ())
        line = tuple(round(x / (SAME * chain.reach)) for point in bones(chain, coordinates) for x in point)
        for known, numbers, _first in shapes:
            if len(known) == len(line) and max(abs(a - b) for a, b in zip(known, line, strict=True)) <= 10:
                numbers.append(solution.number)
                break
        else:
            shapes.append((line, [solution.number], coordinates))
    for role, (_line, numbers, coordinates) in enumerate(shapes):
        label = f"posture{'s' * (len(numbers) > 1)} {', '.join(map(str, numbers))}"
        items += posture(chain, coordinates, role, label, "thick" if role == 0 else "solid")
    first = shapes[0][2]
    items += joint_marks(chain, first, GREY)
    items += hand_axes(chain, chain.hand(chain.links(first)))
    count = result.count
    return Picture((panel(chain, items),), f"{count} posture{'s' * (count != 1)} for one pose", subtitle=_view(chain))


def jacobian_picture(
    result: "Any", arm: Arm, *, angles: "Any" = (), slides: "Any" = (), axes: str = "base", **_: "Any"
) -> Picture:
    """The arm with the velocity and the force ellipsoid of its hand, each drawn to a size of its own."""
    chain = over_plain(chain_of(arm))
    coordinates = coordinates_of(chain, over_plain(tuple(angles)), over_plain(tuple(slides)))
    hand = chain.hand(chain.links(coordinates))
    items = [*posture(chain, coordinates, 0), *joint_marks(chain, coordinates, GREY)]
    words = "the hand's ellipsoids are drawn of an arm without slides"
    if result.ellipsoid is not None:
        turn = hand.rotation if axes == "hand" else IDENTITY
        ways = [turned(turn, axis.direction) for axis in result.ellipsoid]
        size = SHOWN * chain.reach
        longest = result.ellipsoid[0].velocity or 1.0
        speeds = [size * axis.velocity / longest for axis in result.ellipsoid]
        items += ellipsoid(chain, hand.position, ways, speeds, ("velocity", 1))
        if all(axis.force for axis in result.ellipsoid):
            shortest = result.ellipsoid[-1].velocity
            forces = [size * shortest / axis.velocity for axis in result.ellipsoid]
            items += ellipsoid(chain, hand.position, ways, forces, ("force", 2))
        words = "ellipsoids of velocity and force: shapes, not sizes"
    return Picture((panel(chain, items),), f"arm of {len(chain.joints)} joints, {result.verdict}", subtitle=words)


def ellipsoid(
    chain: Chain, centre: Vector, ways: "Sequence[Vector]", radii: "Sequence[float]", name: "tuple[str, int]"
) -> "list[Any]":
    """The principal ellipses about a point: one in the plane, three in space."""
    view = seen_from(chain)
    items: list[Any] = []
    label, role = name
    for i in range(len(ways)):
        for j in range(i + 1, len(ways)):
            points = []
            for k in range(POINTS + 1):
                turn = 2.0 * pi * k / POINTS
                points.append(times(radii[j] * sin(turn), ways[j], times(radii[i] * cos(turn), ways[i], centre)))
            flat = [view(point) for point in points]
            style = "solid" if len(ways) == 2 else "thin"
            items.append(Curve([x for x, _ in flat], [y for _, y in flat], label, style, role))  # type: ignore[arg-type]
            label = ""
    return items


def rates_picture(
    result: "Any", arm: Arm, *, angles: "Any" = (), slides: "Any" = (), velocity: "Any" = None, **_: "Any"
) -> Picture:
    """The arm with the velocity of its hand, and the arm a little later, dotted."""
    chain = over_plain(chain_of(arm))
    coordinates = coordinates_of(chain, over_plain(tuple(angles)), over_plain(tuple(slides)))
    speeds = coordinates_of(chain, result.speeds or (), result.slide_speeds or ())
    fastest = max(map(abs, speeds), default=0.0)
    later = (
        [q + LATER * speed / fastest for q, speed in zip(coordinates, speeds, strict=True)] if fastest else coordinates
    )
    items = [
        *posture(chain, later, GREY, "", "dots"),
        *posture(chain, coordinates, 0),
        *joint_marks(chain, coordinates, GREY),
    ]
    way = over_plain(tuple(velocity or ORIGIN))
    if any(way):
        hand = chain.hand(chain.links(coordinates)).position
        items.append(arrow(times(SHOWN * chain.reach, unit(way)), "", 1, seen_from(chain), start=hand))
    words = "the arrow is the hand's velocity; dotted: the arm later, its fastest joint 10 degrees on"
    return Picture((panel(chain, items),), f"arm of {len(chain.joints)} joints, speeds of its joints", subtitle=words)


def torque_picture(
    result: "Any", arm: Arm, *, angles: "Any" = (), slides: "Any" = (), up: "Any" = (0.0, 0.0, 1.0), **_: "Any"
) -> Picture:
    """The arm with the torque or force of each joint beside it, and which way is down."""
    chain = over_plain(chain_of(arm))
    coordinates = coordinates_of(chain, over_plain(tuple(angles)), over_plain(tuple(slides)))
    view, size = seen_from(chain), SHOWN * chain.reach
    items = posture(chain, coordinates, 0)
    turns, travels = iter(over_plain(result.torques or ())), iter(over_plain(result.slide_forces or ()))
    names = iter(chain.names)
    placed: list[tuple[float, float]] = []
    for frame, turning in zip(chain.axes(chain.links(coordinates)), chain.turning, strict=True):
        value = (next(turns), Torque) if turning else (next(travels), Force)
        x, y = view(frame.position)
        # words of joints at one place stand below each other
        beside = sum(hypot(x - a, y - b) < 0.05 * chain.reach for a, b in placed)
        placed.append((x, y))
        text = worded(f"{next(names)}: {{value}}", value=value)
        items.append(Mark(x, y, text, (6.0, 4.0 - 12.0 * beside), role=GREY))
    foot = view(times(-size, unit(over_plain(tuple(up)))))
    left = min(min(item.x) for item in items if isinstance(item, Curve)) - 0.6 * size
    top = max(max(item.y) for item in items if isinstance(item, Curve)) - 0.2 * size
    if hypot(*foot) > SAME * chain.reach:
        items += [Arrow(left, top, 0.6 * foot[0], 0.6 * foot[1], "", GREY), Label(left, top + 0.12 * size, "weight")]
    return Picture((panel(chain, items),), f"arm of {len(chain.joints)} joints, torques of its joints")
