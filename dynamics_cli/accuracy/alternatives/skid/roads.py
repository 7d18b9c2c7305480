"""Skids: the forms of the textbook, with the slope's sine and cosine and with differences of squares.

Every formula takes its elementary functions as `m`, so that it is measured in numbers of 32 bits too.
"""

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def _drag(friction: float, grade: float, braking: float, m: "Any") -> float:
    """F = η·μ·cos θ + sin θ, θ = tan⁻¹ G: digits go as the drag comes near zero."""
    theta = m.atan(grade)
    return braking * friction * m.cos(theta) + m.sin(theta)  # type: ignore[no-any-return]


def speed_by_slope_angle(
    *, segments: "tuple[Any, ...]", gravity: float, end_speed: float = 0.0, mass: "float | None" = None,
    m: "Any" = math,
) -> "dict[str, float]":  # fmt: skip
    """V² = vₑ² + 2·g·d·f from the last surface to the first, t = (v − vₑ)/(g·f), energies ½·m·v² and m·g·μ·d·cos θ."""
    out: dict[str, Any] = {}
    leaving, work = end_speed, 0.0 * end_speed
    drags = [_drag(one.friction, one.grade, one.braking, m) for one in segments]
    for k in reversed(range(len(segments))):
        one, drag = segments[k], drags[k]
        entry = m.sqrt(leaving * leaving + 2 * gravity * one.distance * drag)
        out |= {
            f"surfaces[{k}].entry_speed": entry, f"surfaces[{k}].exit_speed": leaving,
            f"surfaces[{k}].drag_factor": drag, f"surfaces[{k}].distance": one.distance,
            f"surfaces[{k}].time": (entry - leaving) / (gravity * drag),
        }  # fmt: skip
        work = work + one.braking * one.friction * one.distance * m.cos(m.atan(one.grade))
        leaving = entry
    out["speed"] = leaving
    for name, part in (("time", "time"), ("total_distance", "distance")):
        parts = [out[f"surfaces[{k}].{part}"] for k in range(len(segments))]
        out[name] = sum(parts[1:], parts[0])
    if mass is not None:
        out |= {"energy": mass * leaving * leaving / 2, "friction_work": mass * gravity * work}
    return out


def distance_by_squares(
    *, speed: float, friction: float, gravity: float, grade: float = 0.0, braking: float = 1.0, end_speed: float = 0.0,
    mark: "float | None" = None, m: "Any" = math,
) -> "dict[str, float]":  # fmt: skip
    """D = (v² − vₑ²)/(2·g·f): digits go as the two speeds come near one another."""
    drag = _drag(friction, grade, braking, m)
    deceleration = gravity * drag
    out = {
        "distance": (speed * speed - end_speed * end_speed) / (2 * deceleration),
        "time": (speed - end_speed) / deceleration,
        "drag_factor": drag,
        "deceleration": deceleration,
    }
    if mark is not None:
        left = m.sqrt(speed * speed - 2 * deceleration * mark)
        out |= {"exit_speed": left, "exit_time": (speed - left) / deceleration}
    return out


def yaw_by_bank_angle(
    *, path: "Any", friction: float, gravity: float, superelevation: float = 0.0, track_width: "float | None" = None,
    m: "Any" = math,
) -> "dict[str, float]":  # fmt: skip
    """V = √(g·R·tan(tan⁻¹ μ + tan⁻¹ e)), the radius less half a track; R = C²/(8·M) + M/2."""
    if type(path).__name__ == "Radius" or hasattr(path, "radius"):
        radius = path.radius
    else:
        radius = path.chord * path.chord / (8 * path.middle_ordinate) + path.middle_ordinate / 2
    mark = radius
    if track_width is not None:
        radius = radius - track_width / 2
    across = gravity * m.tan(m.atan(friction) + m.atan(superelevation))
    return {
        "speed": m.sqrt(radius * across), "path_radius": radius, "mark_radius": mark, "lateral_acceleration": across,
    }  # fmt: skip


def friction_by_sums(*, skids: "Any", gravity: float, m: "Any" = math) -> "dict[str, float]":
    """Mean and deviation from Σμ and Σμ² in one pass: digits go as the skids come near one another."""
    several = skids if isinstance(skids, tuple) else (skids,)
    found, drags = [], []
    for one in several:
        theta = m.atan(one.grade)
        drags.append(one.speed * one.speed / (2 * gravity * one.distance))
        found.append((drags[-1] - m.sin(theta)) / (one.braking * m.cos(theta)))
    count = len(found)
    total, squares = sum(found[1:], found[0]), sum((x * x for x in found[1:]), found[0] * found[0])
    out = {"friction": total / count, "lowest": min(found), "highest": max(found)}
    for index, (one, drag) in enumerate(zip(found, drags, strict=True)):
        out |= {f"tests[{index}].friction": one, f"tests[{index}].drag_factor": drag}
    if count > 1:
        spread = m.sqrt((squares - total * total / count) / (count - 1))
        out |= {"standard_deviation": spread, "standard_error": spread / m.sqrt(0.0 * spread + count)}
    return out


def drag_by_angles(*, measurement: "Any", gravity: float, m: "Any" = math) -> "dict[str, float]":
    """F = μ·cos θ + sin θ; the sled's from forces along and across the slope, two axles' from moments about them."""
    one = measurement
    theta = m.atan(one.grade)
    out = {}
    if type(one).__name__ == "Surface":
        effective = one.braking * one.friction
    elif type(one).__name__ == "Sled":
        along = one.pull * m.cos(one.pull_angle) - one.weight * m.sin(theta)
        effective = along / (one.weight * m.cos(theta) - one.pull * m.sin(one.pull_angle))
    else:
        front, rear = one.front_braking * one.front_friction, one.rear_braking * one.rear_friction
        share = (one.wheelbase - one.cm_position + rear * one.cm_height) / (
            one.wheelbase - (front - rear) * one.cm_height
        )
        effective = front * share + rear * (1 - share)
        still = (one.wheelbase - one.cm_position) / one.wheelbase
        out = {"front_share": share, "rear_share": 1 - share, "weight_transfer": share - still}
    drag = effective * m.cos(theta) + m.sin(theta)
    return {"drag_factor": drag, "deceleration": gravity * drag, "effective_friction": effective, **out}


def stop_by_book(
    *, speed: float, reaction_time: float, friction: float, grade: float, braking: float, gravity: float,
    steps: int = 0, build_up_time: "float | None" = None, m: "Any" = math,
) -> "dict[str, float]":  # fmt: skip
    """D = v·t + v²/(2·g·f); while the brakes take hold u = v − a·t²/2T and x = v·t − a·t³/6T."""
    drag = _drag(friction, grade, braking, m)
    deceleration = gravity * drag
    reaction = speed * reaction_time
    rows = [(reaction_time * k / steps, reaction * k / steps, speed) for k in range(steps + 1)]
    out, left, now, way = {}, speed, reaction_time, reaction
    if build_up_time is not None:
        left = speed - deceleration * build_up_time / 2
        if left <= 0.0:
            # at rest before the brakes have taken hold
            raise ArithmeticError
        rise = speed * build_up_time - deceleration * build_up_time * build_up_time / 6
        for k in range(1, steps + 1):
            t = build_up_time * k / steps
            lost = deceleration * t * t / (2 * build_up_time)
            rows.append((now + t, way + speed * t - lost * t / 3, speed - lost))
        now, way = now + build_up_time, way + rise
        out = {"build_up_distance": rise, "build_up_duration": build_up_time}
    stopping, time = left * left / (2 * deceleration), left / deceleration
    for k in range(1, steps + 1):
        t = time * k / steps
        rows.append((now + t, way + left * t - deceleration * t * t / 2, left - deceleration * t))
    for k, row in enumerate(rows):
        out |= {f"timeline[{k}].{name}": value for name, value in zip(("time", "distance", "speed"), row, strict=True)}
    return out | {
        "drag_factor": drag,
        "deceleration": deceleration,
        "reaction_distance": reaction,
        "braking_speed": left,
        "braking_distance": stopping,
        "braking_time": time,
        "stopping_distance": way + stopping,
        "stopping_time": now + time,
    }


def avoid_by_roots(
    *, speed: float, sight_distance: float, reaction_time: float, friction: float, grade: float, braking: float,
    gravity: float, speed_limit: "float | None" = None, m: "Any" = math,
) -> "dict[str, float]":  # fmt: skip
    """The quadratic's root as taught, −a·t + √(a²t² + 2·a·s): digits go as reaction takes the sight distance."""
    drag = _drag(friction, grade, braking, m)
    deceleration = gravity * drag
    lost = deceleration * reaction_time
    enough = m.sqrt(lost * lost + 2 * deceleration * sight_distance) - lost
    out = {"drag_factor": drag, "sufficient_speed": enough}
    speeds = [speed, enough] if speed_limit is None else [speed, speed_limit, enough]
    for k, own in enumerate(speeds):
        row, reaction, braking_way = f"approaches[{k}].", own * reaction_time, own * own / (2 * deceleration)
        out |= {
            row + "approach_speed": own, row + "reaction_distance": reaction, row + "braking_distance": braking_way,
            row + "stopping_distance": reaction + braking_way,
        }  # fmt: skip
        if k == len(speeds) - 1:
            out[row + "time"] = reaction_time + own / deceleration
            continue
        margin = sight_distance - (reaction + braking_way)
        hit = 0 * own
        if reaction >= sight_distance:
            hit = own
        elif margin < 0.0:
            hit = m.sqrt(own * own - 2 * deceleration * (sight_distance - reaction))
        inside = reaction < sight_distance
        time = reaction_time + (own - hit) / deceleration if inside else sight_distance / own
        out |= {row + "margin": margin, row + "impact_speed": hit, row + "time": time}
        name = ("", "_at_limit")[k]
        out |= {"margin" + name: margin, "impact_speed" + name: hit}
    return out | {"stopping_distance": out["approaches[0].stopping_distance"]}


def spin_by_differences(
    *, drag: "Any", distance: float, friction: float, end_speed: float, grade: float, gravity: float,
    m: "Any" = math,
) -> "dict[str, float]":  # fmt: skip
    """V² = vₑ² + 2·g·f·d and what was lost as v − vₑ; the mean sine from cosines, within half a turn of straight."""
    if type(drag).__name__ == "Share":
        share = drag.drag_share
    else:
        first, last = drag.start_angle, drag.start_angle + drag.rotation
        if first < 0.0 or last > math.pi:
            raise ArithmeticError
        share = drag.rolling_drag + (1 - drag.rolling_drag) * (m.cos(first) - m.cos(last)) / drag.rotation
    return _spin(drag, share, distance, friction, end_speed, grade, gravity, m)


def _spin(
    drag: "Any", share: float, distance: float, friction: float, end_speed: float, grade: float, gravity: float,
    m: "Any",
) -> "dict[str, float]":  # fmt: skip
    """From the mean share on."""
    factor = _drag(friction, grade, share, m)
    speed = m.sqrt(end_speed * end_speed + 2 * gravity * factor * distance)
    time = (speed - end_speed) / (gravity * factor)
    out = {
        "mean_share": share, "drag_factor": factor, "speed": speed, "speed_lost": speed - end_speed, "time": time,
    }  # fmt: skip
    if type(drag).__name__ != "Share":
        out["mean_yaw_rate"] = drag.rotation / time
    return out
