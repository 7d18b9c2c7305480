"""Time–distance diagrams of phases, of two parties and of one behind another; the line of sight past a corner."""

import math
from itertools import pairwise

from dynamics_cli.errors import worded
from dynamics_cli.numerics.road.phases import Kind, Phase, legs
from dynamics_cli.pictures import Arrow, Axis, Band, Curve, Label, Mark, Panel, Picture
from dynamics_cli.quantities import STANDARD_GRAVITY, Acceleration, Length, RoadSpeed, Time
from dynamics_cli.skid.timing.bands import bands_of, before_impact, held, in_lane, party_in
from dynamics_cli.skid.timing.courses import Course
from dynamics_cli.skid.timing.meet import Party, course_to_impact, driving, motion_of
from dynamics_cli.skid.timing.recorded import ListedSpeeds, Samples, SpeedFile
from dynamics_cli.skid.timing.timeline import EndSpeed, StartSpeed, summed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.numerics.road.leg import Leg
    from dynamics_cli.pictures import Spreads

POINTS = 41
TWO_SIDED = 1.96
LEFT = Axis("distance to the end", Length)


def _before(longest: float, event: str = "the impact") -> Axis:
    """Time runs to the right, and is counted back from the impact."""
    return Axis(f"time before {event}", Time, ends=(1.04 * longest, 0.0))


def _curves(motion: "list[Leg]", role: int = -1) -> "tuple[list[Any], list[Any]]":
    """Distance and speed over the time left, one curve for each phase; and marks where phases begin."""
    places: list[Any] = []
    speeds: list[Any] = []
    for leg, row in zip(motion, summed(motion), strict=True):
        times = [leg.duration * i / (POINTS - 1) for i in range(POINTS)]
        times_left = [row.begins - time for time in times]
        states = [leg.at(time) for time in times]
        places.append(Curve(times_left, [row.from_distance - gone for gone, _ in states], leg.kind, role=role))
        speeds.append(Curve(times_left, [speed for _, speed in states], leg.kind, role=role))
    return places, speeds


def timeline(
    result: "Any", *, phases: "Any", known: "Any", gravity: float = STANDARD_GRAVITY,
    spreads: "Spreads | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """Distance and speed over the time before the end, phase by phase."""
    motion = legs(
        phases if isinstance(phases, tuple) else (phases,), gravity,
        start=known.start_speed if isinstance(known, StartSpeed) else None,
        end=known.end_speed if isinstance(known, EndSpeed) else None,
    )  # fmt: skip
    places, speeds = _curves(motion)
    for row in result.phases:
        places.append(Mark(row.begins, row.from_distance, ""))
    times = [result.duration * (1.0 - i / (POINTS - 1)) for i in range(POINTS)]
    ways, swift = bands_of(
        spreads,
        times,
        lambda case: before_impact(Party(case["phases"], case["known"]), case.get("gravity", STANDARD_GRAVITY)),
        6,
    )
    places += ways
    speeds += swift
    axis = _before(result.duration, "the end")
    return Picture(
        (Panel(axis, LEFT, tuple(places)), Panel(axis, Axis("speed", RoadSpeed), tuple(speeds))),
        "time and distance",
        subtitle=held(spreads),
    )


def _begun(row: "Any") -> "Any":
    """A phase and the speed where it begins."""
    return worded("{phase}\n{speed:3}", phase=row.phase, speed=(row.start_speed, RoadSpeed))


def _named(party: Party, otherwise: str) -> str:
    return str(party.name) if party.name else otherwise


def meet(
    result: "Any", *, first: Party, second: Party, gravity: float = STANDARD_GRAVITY,
    spreads: "Spreads | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """Both parties' distances and speeds over the time before the impact, and the first as it would have avoided it."""
    begins = (result.hazard_time, result.hazard_time)
    if spreads is not None:
        begins = spreads.intervals.get("hazard_time", begins)
    longest = max(result.moments[0].time_left, begins[1])
    times = [longest * (1.0 - i / (4 * POINTS)) for i in range(4 * POINTS + 1)]
    places: list[Any] = []
    speeds: list[Any] = []
    for role, (party, name) in enumerate(((first, "first"), (second, "second"))):
        distances, swiftness = zip(*map(before_impact(party, gravity), times), strict=True)
        places.append(Curve(times, distances, _named(party, name), role=role))
        speeds.append(Curve(times, swiftness, _named(party, name), role=role))
        for items, band in zip((places, speeds), bands_of(spreads, times[::4], party_in(name), role), strict=True):
            items += band
        if role == 0:
            places += [
                Mark(row.begins, row.from_distance, "" if row.phase == "build-up" else _begun(row), role=role)
                for row in summed(motion_of(first, gravity, ""))
            ]
    for items, words in ((places, ""), (speeds, "hazard begins")):
        items.append(Band(*begins, words))
    ends = (1.04 * longest, 0.0)
    avoiding = _avoiding(result, motion_of(first, gravity, ""), gravity)
    if avoiding:
        left, distances, swift = zip(*avoiding, strict=True)
        places.append(Curve(left, distances, style="dashed", role=2))
        speeds.append(Curve(left, swift, f"{_named(first, 'first')}, avoiding", "dashed", role=2))
        ends = (ends[0], min(ends[1], 1.04 * left[-1]))
    if spreads is not None:
        speeds += _bar(result.hazard_time, spreads, "sufficient_speed", 2)
    axis = Axis("time before the impact", Time, ends=ends)
    highest = max(max(item.y) for item in places if isinstance(item, Curve))
    # room above for the words where the reaction begins
    away = Axis("distance to it", Length, ends=(-0.05 * highest, 1.3 * highest))
    return Picture(
        (Panel(axis, away, tuple(places)), Panel(axis, Axis("speed", RoadSpeed), tuple(speeds))),
        "two parties before the impact",
        subtitle=held(spreads, "bands and bar"),
    )


def _avoiding(result: "Any", motion: "list[Leg]", gravity: float) -> "list[tuple[float, float, float]]":
    """Time left, distance and speed of the first from the hazard on, had it come with the speed that suffices."""
    acting = driving(motion)
    if result.sufficient_speed is None or acting is None:
        return []
    reaction, build_up, rate = acting
    if not result.sufficient_speed > 0.5 * rate * build_up or not reaction > 0.0:
        return []
    phases = [Phase(Kind("reaction"), duration=reaction)]
    if build_up > 0.0:
        phases.append(Phase(Kind("build-up"), duration=build_up))
    phases.append(Phase(Kind("braking"), speed=0.0, acceleration=rate))
    chain = legs(tuple(phases), gravity, start=result.sufficient_speed, end=None)
    course = Course(chain, -result.hazard_time, -result.first_distance)
    whole = sum(leg.duration for leg in chain)
    rows = []
    for step in range(POINTS):
        time = -result.hazard_time + whole * step / (POINTS - 1)
        way, speed, _ = course.at(time)
        rows.append((-time, -way, speed))
        if way >= 0.0:
            break
    return rows


def _bar(time: float, spreads: "Spreads", address: str, role: int) -> "list[Any]":
    """The interval of a result at a moment."""
    if address not in spreads.intervals:
        return []
    return [Curve([time, time], list(spreads.intervals[address]), style="thick", role=role)]


def follow(
    result: "Any", *, leader: Party, follower: Party, gap: float, gravity: float = STANDARD_GRAVITY,
    spreads: "Spreads | None" = None, **_: "Any",
) -> Picture:  # fmt: skip
    """Places of both and speeds over time, up to the contact."""
    end = result.moments[-1].time
    times = [end * i / (4 * POINTS) for i in range(4 * POINTS + 1)]
    places: list[Any] = []
    speeds: list[Any] = []
    for role, (party, name, ahead) in enumerate(((leader, "leader", gap), (follower, "follower", 0.0))):
        motion_course = Course(motion_of(party, gravity, ""), 0.0, ahead)
        states = [motion_course.at(time) for time in times]
        places.append(Curve(times, [gone for gone, _, _ in states], _named(party, name), role=role))
        speeds.append(Curve(times, [speed for _, speed, _ in states], _named(party, name), role=role))
        for items, band in zip((places, speeds), bands_of(spreads, times[::4], in_lane(name), role), strict=True):
            items += band
    if result.contact:
        places.append(Mark(result.contact_time, result.follower_distance, "contact", aside=(-5.0, -12.0)))
    axis = Axis("time", Time, ends=(0.0, 1.08 * end))
    place = Axis("place", Length)
    return Picture(
        (Panel(axis, place, tuple(places)), Panel(axis, Axis("speed", RoadSpeed), tuple(speeds))),
        "one behind the other",
        subtitle=held(spreads),
    )


def sight(
    result: "Any", *, first: Party, second: Party,
    corner_before: "float | None" = None, corner_aside: "float | None" = None,
    recognition_distance: "float | None" = None, eye_behind: float = 0.0,
    crossing: float = 0.5 * math.pi, obstruction: "Any" = None, obstruction_length: "float | None" = None,
    gravity: float = STANDARD_GRAVITY, **_: "Any",
) -> Picture:  # fmt: skip
    """The plan at the opening of the sight: ways, obstruction, eye, target and the line between them."""
    eye = -(result.first_distance + eye_behind)
    target = (-result.second_distance * math.cos(crossing), -result.second_distance * math.sin(crossing))
    depth = max(2.0 * result.second_distance * math.sin(crossing), 3.0 * (corner_aside or 1.0))
    back = 1.1 * eye
    span = depth / math.tan(crossing) if abs(crossing - 0.5 * math.pi) > 1e-9 else 0.0
    items: list[Any] = []
    if corner_before is not None and corner_aside is not None:
        corner, heading = (-corner_before, -corner_aside), 0.0
        if obstruction is not None:
            heading = obstruction.heading
            shift = -course_to_impact(motion_of(obstruction, gravity, "")).at(-result.time_left)[0]
            corner = (corner[0] - shift * math.cos(heading), corner[1] - shift * math.sin(heading))
            items.append(Arrow(*corner, 2.0 * math.cos(heading), 2.0 * math.sin(heading), role=6))
        if obstruction is None and obstruction_length is None:
            x, y = [back, corner[0], corner[0], back], [corner[1], corner[1], -depth, -depth]
        else:
            x, y = _block(corner, heading, abs(back) if obstruction_length is None else obstruction_length)
        items += [
            Curve(x, y, style="fill", role=6),
            Label(0.5 * (min(x) + max(x)), 0.5 * (min(y) + max(y)), "obstruction"),
        ]
    if recognition_distance is not None:
        turns = [0.2 * math.pi * (i / (POINTS - 1) - 0.5) for i in range(POINTS)]
        arc = [(eye + recognition_distance * math.cos(a), recognition_distance * math.sin(a)) for a in turns]
        items.append(Curve([x for x, _ in arc], [y for _, y in arc], "recognized within", "dots", role=0))
    items += [
        Curve([back, 0.15 * -back], [0.0, 0.0], style="centre", role=0),
        Curve([-span, 0.4 * span], [-depth, 0.4 * depth], style="centre", role=1),
        Curve([eye, target[0]], [0.0, target[1]], "line of sight", "dashed", role=2),
        Arrow(eye, 0.0, eye_behind if eye_behind > 0.0 else 0.0, 0.0, role=0),
        Mark(eye, 0.0, f"eye of {_named(first, 'the first')}", aside=(0.0, 8.0), role=0),
        Mark(*target, _named(second, "the second"), role=1),
        Mark(0.0, 0.0, "impact"),
    ]
    return Picture(
        (
            Panel(
                Axis(f"along the way of {_named(first, 'the first')}", Length),
                Axis("aside", Length),
                tuple(items),
                equal=True,
            ),
        ),
        "where the sight opens",
    )


# An obstruction of some length is drawn as wide as a van, on the side away from the first.
WIDE = 2.0


def _block(corner: "tuple[float, float]", heading: float, length: float) -> "tuple[list[float], list[float]]":
    """A body back from its corner, on the far side of the line that hides."""
    back = (-length * math.cos(heading), -length * math.sin(heading))
    side = -1.0 if math.cos(heading) >= 0.0 else 1.0
    out = (-side * WIDE * math.sin(heading), side * WIDE * math.cos(heading))
    places = [(0.0, 0.0), back, (back[0] + out[0], back[1] + out[1]), out]
    return [corner[0] + x for x, _ in places], [corner[1] + y for _, y in places]


def record(
    result: "Any",
    *,
    recorded: ListedSpeeds | SpeedFile,
    greatest_age: "float | None" = None,
    tolerance: float = 1.0 / 3.6,
    resolution: float = 1.0 / 3.6,
    **_: "Any",
) -> Picture:
    """Recorded speeds with their tolerance, what the last deceleration leads to at the event, and the decelerations."""
    samples = Samples(recorded)
    interval = samples.interval
    oldest = samples.ended + (interval if greatest_age is None else greatest_age)
    rows = result.intervals
    times = [row.time_left + oldest for row in rows]
    speeds = [row.speed for row in rows]
    outline = [speed + tolerance for speed in speeds] + [max(speed - tolerance, 0.0) for speed in reversed(speeds)]
    items: list[Any] = [
        Curve(times, speeds, "recorded", role=0),
        Curve(times, speeds, style="points", role=0),
        Curve([*times, *reversed(times)], outline, "tolerance", "filled", role=0),
        Curve([times[-1], 0.0], [speeds[-1], result.least_event_speed], "to the event", "dashed", role=1),
    ]
    if result.brake_earliest is not None and result.brake_latest is not None:
        items.append(Band(result.brake_latest, result.brake_earliest, "braking began"))
    axis = Axis("time before the event, at its greatest", Time, ends=(1.03 * times[0], 0.0))
    changes = [row.acceleration for row in rows[:-1]]
    steps = [time for pair in pairwise(times) for time in pair]
    # the deviation of the way from each sample: the common error grows with the time, rounding with its root
    count = [row.time_left / interval for row in rows]
    sigmas = [
        math.hypot(row.time_left * tolerance / math.sqrt(3.0),
                   interval * math.sqrt(max(number - 0.5, 0.0) / 12.0) * resolution)
        for row, number in zip(rows, count, strict=True)
    ]  # fmt: skip
    ways = [row.distance_left for row in rows]
    edges = [[way + sign * TWO_SIDED * sigma for way, sigma in zip(ways, sigmas, strict=True)] for sign in (1.0, -1.0)]
    band = Curve([*times, *reversed(times)], [*edges[0], *reversed([max(low, 0.0) for low in edges[1]])], "95 %",
                 "filled", role=0)  # fmt: skip
    slowing = Curve(steps, [change for change in changes for _ in (0, 1)], role=2)
    return Picture(
        (
            Panel(axis, Axis("speed", RoadSpeed), tuple(items)),
            Panel(axis, Axis("distance left", Length), (Curve(times, ways, role=0), band)),
            Panel(axis, Axis("acceleration", Acceleration), (slowing,)),
        ),
        "a recorded approach",
    )
