"""A path of the hand: the arm on its way, and angles and speeds of its joints in time."""

from dynamics_cli.errors import worded
from dynamics_cli.numerics.number import over_plain
from dynamics_cli.pictures import Axis, Band, Curve, Panel, Picture
from dynamics_cli.pictures.vectors import GREY
from dynamics_cli.quantities import Angle, Coordinate, Size, Speed, Time, TurnRate
from dynamics_cli.robot.arms.chain import Chain, chain_of, coordinates_of, limits
from dynamics_cli.robot.arms.records import Arm
from dynamics_cli.robot.pictures import joint_marks, panel, posture, seen_from
from dynamics_cli.robot.pose import is_planar
from dynamics_cli.robot.velocities import CLOSE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

# Postures between start and end.
BETWEEN = 4


def path_picture(
    result: "Any", arm: Arm, *, max_speeds: "Any" = (), max_slide_speeds: "Any" = (), **_: "Any"
) -> Picture:
    """The arm at the start, on its way and at the end; below it the joints in time."""
    chain = over_plain(chain_of(arm))
    points = result.points
    times = [point.time for point in points]
    near = [point.time for point in points if point.nearness < CLOSE]
    bands = [Band(min(near), max(near), "nearly singular")] if near else []
    turns = [name for name, turning in zip(chain.names, chain.turning, strict=True) if turning]
    slides = [name for name, turning in zip(chain.names, chain.turning, strict=True) if not turning]
    allowed = {"speeds": over_plain(tuple(max_speeds)), "slide_speeds": over_plain(tuple(max_slide_speeds))}
    clock = Axis("time", Time)
    panels = [panel(chain, _scene(chain, points), "")]
    for title, names, kind, field in (
        ("angle", turns, Angle, "angles"), ("travel", slides, Coordinate, "slides"),
        ("speed", turns, TurnRate, "speeds"), ("speed", slides, Speed, "slide_speeds"),
    ):  # fmt: skip
        if not names:
            continue
        items: list[Any] = list(bands)
        for number, name in enumerate(names):
            values = [getattr(point, field)[number] for point in points]
            items.append(Curve(times, values, f"joint {name}" if name.isdigit() else name, "solid", number))
            if field in ("angles", "slides"):
                bounds: tuple[float, ...] = limits(chain.joints[chain.names.index(name)])
            else:
                bounds = (-allowed[field][number], allowed[field][number]) if allowed[field] else ()
            items += [
                Curve([times[0], times[-1]], [bound, bound], "", "dots", number)
                for bound in bounds
                if _is_near(bound, values)
            ]
        panels.append(Panel(clock, Axis(title, kind), tuple(items)))
    title = worded("path of the hand: {length} in {time}", length=(result.length, Size), time=(result.duration, Time))
    words = "seen from above; " if is_planar(chain) else ""
    words += "the arm at the start, on its way, at the end; fine dots: limits"
    return Picture(
        tuple(panels),
        title,
        columns=1,
        subtitle=words,
    )


def _scene(chain: Chain, points: "Any") -> "list[Any]":
    """Start, end, postures between them, and the line of the hand."""
    view = seen_from(chain)
    last = len(points) - 1
    shown = sorted({round(last * k / (BETWEEN + 1)) for k in range(1, BETWEEN + 1)})
    items: list[Any] = []
    for index in (*shown, last, 0):
        point = points[index]
        q = coordinates_of(chain, point.angles, point.slides or ())
        role = 0 if index == 0 else 1 if index == last else GREY
        label = "start" if index == 0 else "end" if index == last else ""
        items += posture(chain, q, role, label, "thin" if role == GREY else "thick" if index == 0 else "solid")
    first = points[0]
    items += joint_marks(chain, coordinates_of(chain, first.angles, first.slides or ()), GREY)
    line = [view(point.position) for point in points]
    items.append(Curve([x for x, _ in line], [y for _, y in line], "path of the hand", "dashed", 2))
    return items


def _is_near(bound: float, values: "Any") -> bool:
    """Whether a motion comes near to a limit, as a share of how far it goes, or passes it."""
    low, high = min(values), max(values)
    span: float = high - low
    return bool(low - span <= bound <= high + span)
