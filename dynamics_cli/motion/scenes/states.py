"""What is told of a scene at one time: links, points, forces in the joints; and what happens over time."""

import math

from dynamics_cli.errors import require
from dynamics_cli.motion.bodies.joints import NONE
from dynamics_cli.numerics.roots import highest
from dynamics_cli.quantities import (
    Angle,
    AngularAcceleration,
    Annotated,
    Force,
    PartAcceleration,
    PartPoint,
    PartVelocity,
    Size,
    Text,
    Time,
    Torque,
    TurnRate,
)
from dynamics_cli.records import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from dynamics_cli.motion.bodies.joints import Joint
    from dynamics_cli.motion.bodies.system import System

MOST_SAMPLES = 4000
# Peaks between two samples are narrowed to this share of their distance.
NARROW = 1e-5
# Components below this share of the largest are rounding.
DUST = 1e-13


@record
class LinkState:
    """One link."""

    name: Annotated[Text, "The link."]
    angle: Annotated[Angle, "Angle of its own axes [rad]."]
    speed: Annotated[TurnRate | None, "Angular velocity [rad/s]."]
    centre: Annotated[PartPoint, "Its mass centre [m]."]
    velocity: Annotated[PartVelocity | None, "Velocity of that [m/s]."]


@record
class PointState:
    """One point."""

    name: Annotated[Text, "The point."]
    position: Annotated[PartPoint, "Where it is [m]."]
    velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."]


@record
class JointForce:
    """What one joint or driver does to its link."""

    joint: Annotated[Text, "The joint."]
    on: Annotated[Text, "The link that the force acts on."]
    by: Annotated[Text, "The link that it comes from."]
    force: Annotated[Force | None, "Size of the force [N]."]
    force_x: Annotated[Force | None, "Its part along x [N]."]
    force_y: Annotated[Force | None, "Its part along y [N]."]
    moment: Annotated[Torque | None, "Couple, of joints that bear one and of drivers that turn [N·m]."]
    largest: Annotated[Force | None, "Largest force over the motion [N]."] = None
    largest_moment: Annotated[Torque | None, "Largest couple over the motion [N·m]."] = None
    when: Annotated[Time | None, "When that is [s]."] = None


@record
class SpringState:
    """One spring with its damper."""

    name: Annotated[Text, "Its ends."]
    length: Annotated[Size, "How long it is [m]."]
    pull: Annotated[Force, "What it pulls with, its damper too; negative where it pushes [N]."]


@record
class Moment:
    """What is followed, at one time."""

    time: Annotated[Time, "Time since the start [s]."]
    angle: Annotated[Angle | None, "Angle of the link [rad]."] = None
    speed: Annotated[TurnRate | None, "Its angular velocity [rad/s]."] = None
    angular_acceleration: Annotated[AngularAcceleration | None, "Its angular acceleration [rad/s^2]."] = None
    position: Annotated[PartPoint | None, "Where the point, or the mass centre, is [m]."] = None
    velocity: Annotated[PartVelocity | None, "Its velocity [m/s]."] = None
    acceleration: Annotated[PartAcceleration | None, "Its acceleration [m/s^2]."] = None
    force_x: Annotated[Force | None, "Force of the joint along x [N]."] = None
    force_y: Annotated[Force | None, "Force along y [N]."] = None
    moment: Annotated[Torque | None, "Its couple [N·m]."] = None


def links_of(system: "System", y: "Any", *, moving: bool = True) -> "tuple[LinkState, ...]":
    """Every link that moves."""
    size, end, rows = system.size, system.end, []
    for k, body in enumerate(system.bodies):
        x, v = y[3 * k : 3 * k + 3], y[end + 3 * k : end + 3 * k + 3]
        speed = (float(v[0]) * size, float(v[1]) * size)
        rows.append(LinkState(body.name, float(x[2]), float(v[2]) if moving else None,
                              (float(x[0]) * size, float(x[1]) * size), speed if moving else None))  # fmt: skip
    return tuple(rows)


def points_of(system: "System", y: "Any", *, moving: bool = True) -> "tuple[PointState, ...]":
    """Every named point."""
    f, size, rows = system.frame_of(y), system.size, []
    for name, links in system.holders.items():
        k = system.where[links[0], name]
        speed = (f.vx[k] * size, f.vy[k] * size) if moving else None
        rows.append(PointState(name, (f.x[k] * size, f.y[k] * size), speed))
    return tuple(rows)


def springs_of(system: "System", y: "Any") -> "tuple[SpringState, ...] | None":
    """Every spring; none where there is none."""
    f = system.frame_of(y)
    rows = [SpringState(one.name, one.length(f) * system.size, one.tension(f) * system.force)
            for one in system.forces if hasattr(one, "tension")]  # fmt: skip
    return tuple(rows) or None


def bears_a_couple(joint: "Joint") -> bool:
    """Whether it can."""
    return any(part.size == 1 and not hasattr(part, "way") for part in joint.parts)


def bears_a_force(joint: "Joint") -> bool:
    """Whether it can."""
    return any(part.size == 2 or hasattr(part, "way") for part in joint.parts)


def forces_of(system: "System", t: float, y: "Any") -> "list[tuple[float, float, float]]":
    """Force and couple of every joint in SI."""
    f, multipliers = system.frame_of(y), system.multipliers(t, y)
    return forces_by(system, f, multipliers)


def forces_by(system: "System", f: "Any", multipliers: "Any") -> "list[tuple[float, float, float]]":
    """The same from multipliers; what is rounding beside the largest is zero."""
    parts = [joint.force(f, multipliers) for joint in system.joints]
    dust = DUST * max((abs(x) for three in parts for x in three), default=0.0)
    sizes = (system.force, system.force, system.torque)
    return [
        tuple(float(x) * size if abs(x) > dust else 0.0 for x, size in zip(three, sizes, strict=True))  # type: ignore[misc]
        for three in parts
    ]


def joint_rows(
    system: "System", forces: "list[tuple[float, float, float]]", peaks: "list[tuple[float, float, float]] | None"
) -> "tuple[JointForce, ...]":
    """A row for every joint; forces of joints that repeat others are not determined."""
    rows = []
    for k, joint in enumerate(system.joints):
        x, y, couple = forces[k]
        known = not system.left & set(joint.rows())
        pushes, turns = known and bears_a_force(joint), known and bears_a_couple(joint)
        size, turn, when = peaks[k] if peaks and known else (None, None, None)
        rows.append(JointForce(
            joint.name, joint.link, joint.by, math.hypot(x, y) if pushes else None, x if pushes else None,
            y if pushes else None, couple if turns else None, size if pushes else None, turn if turns else None, when,
        ))  # fmt: skip
    return tuple(rows)


def peaks_of(runs: "Any") -> "list[tuple[float, float, float]]":
    """Largest force, largest couple, and when the first is (of a couple alone, when that is), for every joint."""
    system, fine, end = runs.system, runs.fine, runs.end
    ends = [t for t in fine.ends if t < end]
    times = [0.0, *ends, end] if len(ends) < MOST_SAMPLES else [end * k / MOST_SAMPLES for k in range(MOST_SAMPLES + 1)]
    table = [forces_of(system, t, fine.at(t)) for t in times]
    peaks = []
    for k, joint in enumerate(system.joints):
        found = []
        for pick in (_force, _couple):
            best = max(range(len(times)), key=lambda i, pick=pick, k=k: pick(table[i][k]))  # type: ignore[misc]
            low, high = times[max(best - 1, 0)], times[min(best + 1, len(times) - 1)]
            found.append(_refined(lambda t, pick=pick, k=k: pick(forces_of(system, t, fine.at(t))[k]), low, high,
                                  times[best], pick(table[best][k])))  # fmt: skip
        pushed = bears_a_force(joint)
        peaks.append((found[0][1], found[1][1], found[0 if pushed else 1][0]))
    return peaks


def _force(three: "tuple[float, float, float]") -> float:
    return math.hypot(three[0], three[1])


def _couple(three: "tuple[float, float, float]") -> float:
    return abs(three[2])


def _refined(value: "Any", low: float, high: float, at: float, best: float) -> "tuple[float, float]":
    """The maximum between two samples."""
    if best == 0.0:
        return at, best
    when = highest(value, low, high, NARROW * (high - low))
    top = value(when)
    return (when, top) if top > best else (at, best)


def followed(runs: "Any", name: str, steps: int) -> "tuple[Moment, ...]":
    """A link, a point or a joint over time; a pin's name gives the point and its force."""
    return tuple(moment_of(runs.system, runs.end * k / steps, runs.fine.at(runs.end * k / steps), name)
                 for k in range(steps + 1))  # fmt: skip


def moment_of(system: "System", t: float, y: "Any", name: str) -> Moment:
    """The same at one time."""
    joints = [k for k, joint in enumerate(system.joints) if joint.name == name]
    known = sorted({*system.index, *system.holders, *(joint.name for joint in system.joints)} - {"ground"})
    require(name in known, "no link, point or joint is called {name}", name=repr(name), code="name",
            hint="one of {list}", list=", ".join(known))  # fmt: skip
    end, size = system.end, system.size
    accelerations = system.solved(t, y)[0]
    given: dict[str, Any] = {"time": t}
    k = system.index.get(name, NONE)
    if k != NONE:
        at, v, a = (z[3 * k : 3 * k + 3].tolist() for z in (y[:end], y[end : 2 * end], accelerations))
        given |= {"angle": at[2], "speed": v[2], "angular_acceleration": a[2]}
    elif name in system.holders:
        f, spot = system.frame_of(y), system.where[system.holders[name][0], name]
        body, rx, ry = system.spots[spot][0], f.rx[spot], f.ry[spot]
        at, v, a = [f.x[spot], f.y[spot]], [f.vx[spot], f.vy[spot]], [0.0, 0.0]
        if body != NONE:
            w, (ax, ay, turn) = f.w[body], accelerations[3 * body : 3 * body + 3].tolist()
            a = [ax - turn * ry - w * w * rx, ay + turn * rx - w * w * ry]
    else:
        at = v = a = None
    if at is not None:
        given |= {
            part: (z[0] * size, z[1] * size) for part, z in (("position", at), ("velocity", v), ("acceleration", a))
        }
    if joints:
        x, up, couple = forces_of(system, t, y)[joints[0]]
        joint = system.joints[joints[0]]
        given |= {"force_x": x, "force_y": up} if bears_a_force(joint) else {}
        given |= {"moment": couple} if bears_a_couple(joint) else {}
    return Moment(**given)
