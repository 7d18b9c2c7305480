"""Skids and flights as the textbook prints them: sine and cosine of the slope, differences of squares."""

from math import atan, cos, pi, sin, sqrt, tan
from typing import Any

from dynamics_cli.accuracy.questions import textbooks


def _drag(friction: float, grade: float, braking: float = 1.0) -> float:
    """F = η·μ·cos θ + sin θ, θ = tan⁻¹ G: digits go as the drag comes near zero."""
    theta = atan(grade)
    return braking * friction * cos(theta) + sin(theta)


def speed(
    *, segments: "tuple[Any, ...]", gravity: float, end_speed: float = 0.0, mass: "float | None" = None
) -> "dict[str, float]":
    """V² = vₑ² + 2·g·d·f from the last surface to the first, t = (v − vₑ)/(g·f), energies ½·m·v² and m·g·μ·d·cos θ."""
    results: dict[str, float] = {}
    leaving, work, time = end_speed, 0.0, 0.0
    for k in reversed(range(len(segments))):
        part = segments[k]
        drag = _drag(part.friction, part.grade, part.braking)
        entry = sqrt(leaving * leaving + 2 * gravity * part.distance * drag)
        took = (entry - leaving) / (gravity * drag)
        row = {"entry_speed": entry, "exit_speed": leaving, "drag_factor": drag, "time": took}
        results |= {f"surfaces[{k}].{name}": value for name, value in row.items()}
        time += took
        work += part.braking * part.friction * part.distance * cos(atan(part.grade))
        leaving = entry
    if mass is not None:
        results |= {"energy": mass * leaving * leaving / 2, "friction_work": mass * gravity * work}
    return results | {"speed": leaving, "time": time, "total_distance": sum(part.distance for part in segments)}


def distance(
    *, speed: float, friction: float, gravity: float, grade: float = 0.0, braking: float = 1.0, end_speed: float = 0.0,
    mark: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """D = (v² − vₑ²)/(2·g·f): digits go as the two speeds come near one another."""
    drag = _drag(friction, grade, braking)
    slowing = gravity * drag
    results = {
        "distance": (speed * speed - end_speed * end_speed) / (2 * slowing), "time": (speed - end_speed) / slowing,
        "drag_factor": drag, "deceleration": slowing,
    }  # fmt: skip
    if mark is not None:
        left = sqrt(speed * speed - 2 * slowing * mark)
        results |= {"exit_speed": left, "exit_time": (speed - left) / slowing}
    return results


def yaw(
    *, path: "Any", friction: float, gravity: float, superelevation: float = 0.0, track_width: "float | None" = None
) -> "dict[str, float]":
    """V = √(g·R·tan(tan⁻¹ μ + tan⁻¹ e)), the radius less half a track; R = C²/(8·M) + M/2."""
    if hasattr(path, "radius"):
        mark = path.radius
    else:
        mark = path.chord * path.chord / (8 * path.middle_ordinate) + path.middle_ordinate / 2
    radius = mark - (track_width or 0.0) / 2
    across = gravity * tan(atan(friction) + atan(superelevation))
    return {
        "speed": sqrt(radius * across), "path_radius": radius, "mark_radius": mark, "lateral_acceleration": across,
    }  # fmt: skip


def friction(*, skids: "Any", gravity: float) -> "dict[str, float]":
    """Mean and deviation from Σμ and Σμ² in one pass: digits go as the skids come near one another."""
    several = skids if isinstance(skids, tuple) else (skids,)
    results: dict[str, float] = {}
    values = []
    for index, skid in enumerate(several):
        theta, drag = atan(skid.grade), skid.speed * skid.speed / (2 * gravity * skid.distance)
        values.append((drag - sin(theta)) / (skid.braking * cos(theta)))
        results |= {f"tests[{index}].friction": values[-1], f"tests[{index}].drag_factor": drag}
    count, total = len(values), sum(values)
    results |= {"friction": total / count, "lowest": min(values), "highest": max(values)}
    if count > 1:
        spread = sqrt((sum(x * x for x in values) - total * total / count) / (count - 1))
        results |= {"standard_deviation": spread, "standard_error": spread / sqrt(count)}
    return results


def drag_factor(*, measurement: "Any", gravity: float) -> "dict[str, float]":
    """F = μ·cos θ + sin θ; the sled's from forces along and across the slope, two axles' from moments about them."""
    given, theta, results = measurement, atan(measurement.grade), {}
    if hasattr(given, "friction"):
        effective = given.braking * given.friction
    elif hasattr(given, "pull"):
        along = given.pull * cos(given.pull_angle) - given.weight * sin(theta)
        effective = along / (given.weight * cos(theta) - given.pull * sin(given.pull_angle))
    else:
        front, rear = given.front_braking * given.front_friction, given.rear_braking * given.rear_friction
        behind = given.wheelbase - given.cm_position
        share = (behind + rear * given.cm_height) / (given.wheelbase - (front - rear) * given.cm_height)
        effective = front * share + rear * (1 - share)
        results = {
            "front_share": share, "rear_share": 1 - share, "weight_transfer": share - behind / given.wheelbase,
        }  # fmt: skip
    drag = effective * cos(theta) + sin(theta)
    return {"drag_factor": drag, "deceleration": gravity * drag, "effective_friction": effective, **results}


def stop(
    *, speed: float, reaction_time: float, friction: float, grade: float, braking: float, gravity: float,
    build_up_time: "float | None" = None, **_: "Any",
) -> "dict[str, float]":  # fmt: skip
    """D = v·t + v²/(2·g·f); while the brakes take hold u = v − a·t²/2T and x = v·t − a·t³/6T."""
    drag = _drag(friction, grade, braking)
    slowing, reaction, left = gravity * drag, speed * reaction_time, speed
    results, rise = {}, 0.0
    if build_up_time is not None:
        left = speed - slowing * build_up_time / 2
        if left <= 0.0:
            # at rest before the brakes have taken hold
            raise ArithmeticError
        rise = speed * build_up_time - slowing * build_up_time * build_up_time / 6
        results = {"build_up_distance": rise, "build_up_duration": build_up_time}
    stopping, time = left * left / (2 * slowing), left / slowing
    return results | {
        "drag_factor": drag, "deceleration": slowing, "reaction_distance": reaction, "braking_speed": left,
        "braking_distance": stopping, "braking_time": time, "stopping_distance": reaction + rise + stopping,
        "stopping_time": reaction_time + (build_up_time or 0.0) + time,
    }  # fmt: skip


def avoid(
    *, speed: float, sight_distance: float, reaction_time: float, friction: float, grade: float, braking: float,
    gravity: float, speed_limit: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """The quadratic's root as taught, −a·t + √(a²t² + 2·a·s): digits go as reaction takes the sight distance."""
    drag = _drag(friction, grade, braking)
    slowing = gravity * drag
    lost = slowing * reaction_time
    results = {"drag_factor": drag, "sufficient_speed": sqrt(lost * lost + 2 * slowing * sight_distance) - lost}
    for name, approach in (("", speed), ("_at_limit", speed_limit)):
        if approach is None:
            continue
        reaction, way, hit = approach * reaction_time, approach * approach / (2 * slowing), 0.0
        if reaction >= sight_distance:
            hit = approach
        elif reaction + way > sight_distance:
            hit = sqrt(approach * approach - 2 * slowing * (sight_distance - reaction))
        results |= {f"margin{name}": sight_distance - (reaction + way), f"impact_speed{name}": hit}
        if not name:
            results["stopping_distance"] = reaction + way
    return results


def spin(
    *, drag: "Any", distance: float, friction: float, end_speed: float, grade: float, gravity: float
) -> "dict[str, float]":
    """V² = vₑ² + 2·g·f·d and what was lost as v − vₑ; the mean sine from cosines, within half a turn of straight."""
    if hasattr(drag, "drag_share"):
        return spun(drag, drag.drag_share, distance, friction, end_speed, grade, gravity)
    first, last = drag.start_angle, drag.start_angle + drag.rotation
    if first < 0.0 or last > pi:
        raise ArithmeticError
    share = drag.rolling_drag + (1 - drag.rolling_drag) * (cos(first) - cos(last)) / drag.rotation
    return spun(drag, share, distance, friction, end_speed, grade, gravity)


def spun(
    drag: "Any", share: float, distance: float, friction: float, end_speed: float, grade: float, gravity: float
) -> "dict[str, float]":
    """From the mean share on."""
    factor = _drag(friction, grade, share)
    speed = sqrt(end_speed * end_speed + 2 * gravity * factor * distance)
    time = (speed - end_speed) / (gravity * factor)
    turning = {} if hasattr(drag, "drag_share") else {"mean_yaw_rate": drag.rotation / time}
    return turning | {
        "mean_share": share, "drag_factor": factor, "speed": speed, "speed_lost": speed - end_speed, "time": time,
    }  # fmt: skip


def vault(*, distance: float, rise: float, take_off: float, gravity: float) -> "dict[str, float]":
    """V = d·√(g/(2·cos α·(d·sin α − h·cos α))); the landing by tan⁻¹ and squares."""
    sine, cosine = sin(take_off), cos(take_off)
    speed = distance * sqrt(gravity / (2 * cosine * (distance * sine - rise * cosine)))
    time = distance / (speed * cosine)
    return {
        "speed": speed, "launch_angle": take_off, "flight_time": time,
        "landing_speed": sqrt(speed * speed - 2 * gravity * rise),
        "landing_angle": atan((gravity * time - speed * sine) / (speed * cosine)),
    }  # fmt: skip


def throw(
    *, throw_distance: float, friction: float, launch_height: float, gravity: float,
    launch_angle: "float | None" = None,
) -> "dict[str, float]":  # fmt: skip
    """V = √(2·μ·g·(s − μ·h))/(cos α + μ·sin α), between its values for α = tan⁻¹ μ and for a level launch."""
    greatest = sqrt(2 * friction * gravity * (throw_distance - friction * launch_height))
    results = {"least_speed": greatest / sqrt(1 + friction * friction), "greatest_speed": greatest}
    if launch_angle is not None:
        speed = greatest / (cos(launch_angle) + friction * sin(launch_angle))
        up = speed * sin(launch_angle)
        time = (up + sqrt(up * up + 2 * gravity * launch_height)) / gravity
        flight = speed * cos(launch_angle) * time
        slide = throw_distance - flight
        if not slide >= 0.0:
            raise ArithmeticError
        results |= {
            "speed": speed, "flight_time": time, "flight_distance": flight, "slide_distance": slide,
            "slide_time": sqrt(2 * slide / (friction * gravity)),
        }  # fmt: skip
    return results


QUESTIONS = textbooks(
    "skid", "skid.json", "dynamics_cli.accuracy.alternatives.skid:",
    ("speed", "textbook: sine and cosine of the slope", "speed"),
    ("distance", "textbook: difference of squares", "distance"),
    ("friction", "textbook: sums of squares in one pass", "friction"),
    ("drag_factor", "textbook: sine and cosine of the slope", "drag_factor"),
    ("stop", "textbook: v·t + v²/2a, cubes while brakes take hold", "stop"),
    ("yaw", "textbook: angles added", "yaw"),
    ("vault_known_angle", "textbook: range formula as printed", "vault"),
    ("pedestrian", "textbook: Searle, slide as a difference", "throw"),
    ("avoid", "textbook: root of the quadratic as taught", "avoid"),
    ("spin", "textbook: speeds subtracted", "spin"),
)  # fmt: skip
