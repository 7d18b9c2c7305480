"""What stands beside the scene of a crash: speeds with intervals, what decides each link, energy, time and distance."""

from dynamics_cli.errors import worded
from dynamics_cli.impact.crash.links import GOOD_FRICTION
from dynamics_cli.impact.crash.ways import Before
from dynamics_cli.impact.reconstruction.momentum_verdict import DEGREE
from dynamics_cli.pictures import Axis, Curve, Mark, Panel, Ranges, Shares
from dynamics_cli.quantities import Angle, Energy, Fraction, Length, RoadSpeed, Time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from dynamics_cli.pictures import Spreads

SIDES = ("first", "second")
SPEED = Axis("speed", RoadSpeed)
NOTHING = Axis("")
POINTS = 41
# The error of a heading that a bar shows without uncertain inputs.
ASKED = 3.0 * DEGREE
# A heading that may be wrong by more decides nothing.
LARGEST = 90.0 * DEGREE
# A part of the variance or of the energy below this is with the others.
LEAST_SHARE = 0.08


def speeds(result: "Any", names: "Sequence[str]", spreads: "Spreads", limit: "float | None", *, wide: bool) -> Panel:
    """Every vehicle's speeds at its start and into the impact with their intervals, and the speed limit."""
    rows = []
    for side, name in zip(SIDES, names, strict=True):
        course = getattr(result, side)
        if course.start is not None:
            rows.append((f"{name}\nat its start", course.start.speed, f"{side}.start.speed"))
        rows.append((f"{name}\ninto the impact", course.approach_speed, f"{side}.approach_speed"))
    low, high = zip(*(spreads.intervals.get(address, (speed, speed)) for _, speed, address in rows), strict=True)
    heads = [worded("{text} {speed:3}", text=text, speed=(speed, RoadSpeed)) for text, speed, _ in rows]
    limits = () if limit is None else ((limit, worded("limit {limit:3}", limit=(limit, RoadSpeed))),)
    title = f"speeds with {100.0 * spreads.coverage:.4g} % intervals"
    bars = Ranges(tuple(heads), low, high, [row[1] for row in rows], limits, ends=True)
    return Panel(SPEED, NOTHING, (bars,), title, wide=wide)


def links(result: "Any", names: "Sequence[str]", spreads: "Spreads | None") -> "Panel | None":
    """For every link its verdict, what decides it, and the shares of the inputs in the variance of its speed.

    Without uncertain inputs, what its worst heading changes by three degrees, or friction by a tenth.
    """
    rows = [(link, *_speed_of(link.link, result, names)) for link in result.links]
    if not rows:
        return None
    if spreads is None or not any(spreads.shares.get(address) for *_, address in rows):
        effects = [_effect(link, speed) for link, speed, _ in rows]
        heads = tuple(_told(link, speed) for link, speed, _ in rows)
        at = [speed for _, speed, _ in rows]
        low = [max(speed - effect, 0.0) for speed, effect in zip(at, effects, strict=True)]
        bars = Ranges(heads, low, [speed + effect for speed, effect in zip(at, effects, strict=True)], at, ends=True)
        title = "what 3 degrees of the worst heading, or a tenth of friction, change"
        return Panel(SPEED, NOTHING, (bars,), title, wide=True)
    varying = [(link, speed, spreads.shares[address]) for link, speed, address in rows if spreads.shares.get(address)]
    shown = Shares(
        tuple(_told(link, speed) for link, speed, _ in varying), tuple(_gathered(shares) for *_, shares in varying)
    )
    return Panel(NOTHING, NOTHING, (shown,), "what decides each link: shares of the variance of its speed", wide=True)


def _speed_of(link: str, result: "Any", names: "Sequence[str]") -> "tuple[float, str]":
    """The speed that a link gives, and its address."""
    side = next(side for side, name in zip(SIDES, names, strict=True) if link.endswith(name))
    course = getattr(result, side)
    if link.startswith("slide"):
        return course.exit_speed, f"{side}.exit_speed"
    if link.startswith("impact"):
        return course.approach_speed, f"{side}.approach_speed"
    return course.start.speed, f"{side}.start.speed"


def _told(link: "Any", speed: float) -> "Any":
    """A link's speed and verdict, and how far its most important input may be wrong."""
    values = {"link": link.link, "verdict": link.verdict, "input": link.decided_by, "speed": (speed, RoadSpeed)}
    text = "{link}: {speed:3}, {verdict}"
    if link.heading is not None and link.heading < LARGEST:
        values["error"] = (link.heading, Angle)
        text += "; {error:2} in the {input} heading changes it by a tenth"
    elif link.friction is not None and link.friction < 1.0:
        values["error"] = (link.friction, Fraction)
        text += "; {error:2} of {input} changes it by a tenth"
    return worded(text, **values)


def _effect(link: "Any", speed: float) -> float:
    """What the error that is asked for changes a speed by."""
    if link.heading is not None:
        return 0.1 * speed * ASKED / float(link.heading)
    return 0.1 * speed * GOOD_FRICTION / float(link.friction) if link.friction is not None else 0.0


def _gathered(shares: "Sequence[tuple[str, float]]") -> "tuple[tuple[str, float], ...]":
    """The shares of inputs worth showing, and those of all others together."""
    whole = sum(share for _, share in shares) or 1.0
    shown = [(name, share / whole) for name, share in shares if share >= LEAST_SHARE * whole]
    rest = 1.0 - sum(share for _, share in shown)
    return (*shown, *((("", rest),) if rest > 0.005 else ()))


def energy(result: "Any") -> "Panel | None":
    """Where the kinetic energy at the start went."""
    parts = [
        (f"{row.vehicle}: {row.what.partition(',')[0]}", row.energy)
        for row in result.courses
        if row.what != "impact" and row.energy > 0.0
    ]
    merged: dict[str, float] = {}
    for name, part in parts:
        merged[name] = merged.get(name, 0.0) + part
    merged["impact"] = max(result.energy.impact, 0.0)
    if result.energy.remaining > 0.0:
        merged["left where the slides end"] = result.energy.remaining
    if not sum(merged.values()):
        return None
    head = worded("{energy:3} at the start: the impact took {impact:3}", energy=(result.energy.start, Energy),
                  impact=(result.energy.impact, Energy))  # fmt: skip
    shown = _gathered(sorted(merged.items(), key=lambda part: -part[1]))
    return Panel(NOTHING, NOTHING, (Shares((head,), (shown,)),), "energy of the whole crash", wide=True)


def approach(
    result: "Any", scene: "Any", names: "Sequence[str]", gravity: float, spreads: "Spreads | None", *, wide: bool
) -> "Panel | None":
    """Distance to the impact over the time before it, with the moments at which phases begin."""
    if all(getattr(result, side).start is None for side in SIDES):
        return None
    longest = max(getattr(result, side).start.time for side in SIDES if getattr(result, side).start is not None)
    items: list[Any] = []
    for role, (side, name) in enumerate(zip(SIDES, names, strict=True)):
        course = getattr(result, side)
        if course.start is None:
            # nothing is known of it
            far = longest * course.approach_speed
            items.append(Curve([longest, 0.0], [far, 0.0], f"{name}, if at constant speed", "dashed", role))
            continue
        items += _curve(Before(scene, side, course.approach_speed, gravity).legs, name, role)
        if spreads is not None:
            items += _whiskers(side, course.start, spreads, role)
    farthest = max(max(item.y) for item in items if isinstance(item, Curve))
    across, up = Axis("time before the impact", Time, ends=(1.2 * longest, 0.0)), (0.0, 1.15 * farthest)
    return Panel(across, Axis("distance to it", Length, ends=up), tuple(items), "before the impact", wide=wide)


def _curve(legs: "Sequence[Any]", name: str, role: int) -> "list[Any]":
    """The way of a vehicle to the impact, and a mark with its speed where each phase begins."""
    left, way = sum(leg.duration for leg in legs), sum(leg.distance for leg in legs)
    times: list[float] = []
    ways: list[float] = []
    marks: list[Any] = []
    for leg in legs:
        if leg.kind != "build-up":
            text = worded("{kind}\n{speed:3}", kind=leg.kind, speed=(leg.start, RoadSpeed))
            # clear of the whiskers of the start
            marks.append(Mark(left, way, text, (6.0, 8.0), role=role))
        for nth in range(POINTS):
            time = leg.duration * nth / (POINTS - 1)
            times.append(left - time)
            ways.append(way - leg.at(time)[0])
        left, way = left - leg.duration, way - leg.distance
    return [Curve(times, ways, name, "solid", role), *marks]


def _whiskers(side: str, start: "Any", spreads: "Spreads", role: int) -> "list[Any]":
    """The intervals of the time and the distance at the start."""
    times = spreads.intervals.get(f"{side}.start.time", (start.time, start.time))
    ways = spreads.intervals.get(f"{side}.start.distance", (start.distance, start.distance))
    return [
        Curve(list(times), [start.distance, start.distance], "", "thin", role),
        Curve([start.time, start.time], list(ways), "", "thin", role),
    ]
