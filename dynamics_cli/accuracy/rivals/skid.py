"""Skids: the forms of the textbook, with the slope's sine and cosine and with differences of squares.

Every formula takes its elementary functions as `m`, so that it is measured in numbers of 32 bits too.
"""

import math

from dynamics_cli.accuracy.questions import Method, Question
from dynamics_cli.accuracy.rivals.single import DOUBLES, kind_of, single

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

HERE = "dynamics_cli.accuracy.rivals.skid:"


def _drag(friction: float, grade: float, braking: float, m: "Any") -> float:
    """F = η·μ·cos θ + sin θ, θ = tan⁻¹ G: digits go as the drag comes near zero."""
    theta = m.atan(grade)
    return braking * friction * m.cos(theta) + m.sin(theta)  # type: ignore[no-any-return]


def speed_by_slope_angle(
    *, segments: "tuple[Any, ...]", gravity: float, end_speed: float = 0.0, mass: "float | None" = None,
    m: "Any" = DOUBLES,
) -> "dict[str, float]":  # fmt: skip
    """V² = vₑ² + Σ 2·g·d·f."""
    total = end_speed * end_speed
    for one in segments:
        total = total + 2 * gravity * one.distance * _drag(one.friction, one.grade, one.braking, m)
    return {"speed": m.sqrt(total)}


def distance_by_squares(
    *, speed: float, friction: float, gravity: float, grade: float = 0.0, braking: float = 1.0, end_speed: float = 0.0,
    mark: "float | None" = None, m: "Any" = DOUBLES,
) -> "dict[str, float]":  # fmt: skip
    """D = (v² − vₑ²)/(2·g·f): digits go as the two speeds come near one another."""
    deceleration = gravity * _drag(friction, grade, braking, m)
    return {
        "distance": (speed * speed - end_speed * end_speed) / (2 * deceleration),
        "time": (speed - end_speed) / deceleration,
    }


def yaw_by_bank_angle(
    *, path: "Any", friction: float, gravity: float, superelevation: float = 0.0, track_width: "float | None" = None,
    m: "Any" = DOUBLES,
) -> "dict[str, float]":  # fmt: skip
    """V = √(g·R·tan(tan⁻¹ μ + tan⁻¹ e)), the radius less half a track; R = C²/(8·M) + M/2."""
    if kind_of(path) == "Radius" or hasattr(path, "radius"):
        radius = path.radius
    else:
        radius = path.chord * path.chord / (8 * path.middle_ordinate) + path.middle_ordinate / 2
    if track_width is not None:
        radius = radius - track_width / 2
    return {"speed": m.sqrt(gravity * radius * m.tan(m.atan(friction) + m.atan(superelevation)))}


def friction_by_sums(*, skids: "Any", gravity: float, m: "Any" = DOUBLES) -> "dict[str, float]":
    """Mean and deviation from Σμ and Σμ² in one pass: digits go as the skids come near one another."""
    made = skids if isinstance(skids, tuple) else (skids,)
    found, drags = [], []
    for one in made:
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


def drag_by_angles(*, measurement: "Any", gravity: float, m: "Any" = DOUBLES) -> "dict[str, float]":
    """F = μ·cos θ + sin θ; the sled's from forces along and across the slope, two axles' from moments about them."""
    one = measurement
    theta = m.atan(one.grade)
    out = {}
    if kind_of(one) == "Surface":
        effective = one.braking * one.friction
    elif kind_of(one) == "Sled":
        along = one.pull * m.cos(one.pull_angle) - one.weight * m.sin(theta)
        effective = along / (one.weight * m.cos(theta) - one.pull * m.sin(one.pull_angle))
    else:
        front, rear = one.front_braking * one.front_friction, one.rear_braking * one.rear_friction
        share = (one.wheelbase - one.cm_position + rear * one.cm_height) / (
            one.wheelbase - (front - rear) * one.cm_height
        )
        effective = front * share + rear * (1 - share)
        out = {"front_share": share, "rear_share": 1 - share}
    drag = effective * m.cos(theta) + m.sin(theta)
    return {"drag_factor": drag, "deceleration": gravity * drag, "effective_friction": effective, **out}


def stop_by_book(
    *, speed: float, reaction_time: float, friction: float, grade: float, braking: float, gravity: float,
    steps: int = 0, build_up_time: "float | None" = None, m: "Any" = DOUBLES,
) -> "dict[str, float]":  # fmt: skip
    """D = v·t + v²/(2·g·f), the brakes at once."""
    if build_up_time is not None:
        raise ArithmeticError
    drag = _drag(friction, grade, braking, m)
    reaction, stopping, time = speed * reaction_time, speed * speed / (2 * gravity * drag), speed / (gravity * drag)
    return {
        "drag_factor": drag,
        "deceleration": gravity * drag,
        "reaction_distance": reaction,
        "braking_distance": stopping,
        "braking_time": time,
        "stopping_distance": reaction + stopping,
        "stopping_time": reaction_time + time,
    }


def least_vault_by_book(
    *, distance: float, rise: float, gravity: float, take_off: "float | None" = None, m: "Any" = DOUBLES
) -> "dict[str, float]":
    """V² = g·(h + √(d² + h²)), tan α = v²/(g·d): digits go as the drop grows beside the distance."""
    up = rise + m.sqrt(distance * distance + rise * rise)
    speed = m.sqrt(gravity * up)
    return {"speed": speed, "launch_angle": m.atan(speed * speed / (gravity * distance)),
            "landing_speed": m.sqrt(speed * speed - 2 * gravity * rise)}  # fmt: skip


def least_vault_by_search(
    *, distance: float, rise: float, gravity: float, take_off: "float | None" = None
) -> "dict[str, float]":
    """The least speed over take-off angles by golden sections: half of the angle's digits, as at any minimum."""
    low, high = math.atan2(rise, distance), 0.5 * math.pi
    golden = 0.5 * (math.sqrt(5.0) - 1.0)

    def need(angle: float) -> float:
        below = distance * math.tan(angle) - rise
        return distance / math.cos(angle) * math.sqrt(0.5 * gravity / below) if below > 0.0 else math.inf

    for _ in range(80):
        one, other = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, other) if need(one) < need(other) else (one, high)
    angle = 0.5 * (low + high)
    return {"speed": need(angle), "launch_angle": angle}


def vault_by_book(
    *, distance: float, rise: float, take_off: float, gravity: float, m: "Any" = DOUBLES
) -> "dict[str, float]":
    """V = d·√(g/(2·cos α·(d·sin α − h·cos α))); the landing by tan⁻¹ and squares."""
    sine, cosine = m.sin(take_off), m.cos(take_off)
    speed = distance * m.sqrt(gravity / (2 * cosine * (distance * sine - rise * cosine)))
    time = distance / (speed * cosine)
    return {
        "speed": speed,
        "launch_angle": take_off,
        "flight_time": time,
        "landing_speed": m.sqrt(speed * speed - 2 * gravity * rise),
        "landing_angle": m.atan((gravity * time - speed * sine) / (speed * cosine)),
    }


def throw_by_searle(
    *, throw_distance: float, friction: float, launch_height: float, gravity: float,
    launch_angle: "float | None" = None, m: "Any" = DOUBLES,
) -> "dict[str, float]":  # fmt: skip
    """V = √(2·μ·g·(s − μ·h))/(cos α + μ·sin α), between its values for α = tan⁻¹ μ and for a level launch."""
    greatest = m.sqrt(2 * friction * gravity * (throw_distance - friction * launch_height))
    out = {"least_speed": greatest / m.sqrt(1 + friction * friction), "greatest_speed": greatest}
    if launch_angle is not None:
        speed = greatest / (m.cos(launch_angle) + friction * m.sin(launch_angle))
        up = speed * m.sin(launch_angle)
        time = (up + m.sqrt(up * up + 2 * gravity * launch_height)) / gravity
        flight = speed * m.cos(launch_angle) * time
        out |= {"speed": speed, "flight_time": time, "flight_distance": flight,
                "slide_distance": throw_distance - flight}  # fmt: skip
    return out


def avoid_by_roots(
    *, speed: float, sight_distance: float, reaction_time: float, friction: float, grade: float, braking: float,
    gravity: float, speed_limit: "float | None" = None, m: "Any" = DOUBLES,
) -> "dict[str, float]":  # fmt: skip
    """The quadratic's root as taught, −a·t + √(a²t² + 2·a·s): digits go as reaction takes the sight distance."""
    drag = _drag(friction, grade, braking, m)
    deceleration = gravity * drag
    lost = deceleration * reaction_time
    stopping = speed * reaction_time + speed * speed / (2 * deceleration)
    return {
        "drag_factor": drag,
        "sufficient_speed": m.sqrt(lost * lost + 2 * deceleration * sight_distance) - lost,
        "stopping_distance": stopping,
    }


def spin_by_differences(
    *, drag: "Any", distance: float, friction: float, end_speed: float, grade: float, gravity: float,
    m: "Any" = DOUBLES,
) -> "dict[str, float]":  # fmt: skip
    """V² = vₑ² + 2·g·f·d and what was lost as v − vₑ; the mean sine from cosines, within half a turn of straight."""
    if kind_of(drag) == "Share":
        share = drag.drag_share
    else:
        first, last = drag.start_angle, drag.start_angle + drag.rotation
        if first < 0.0 or last > math.pi:
            raise ArithmeticError
        share = drag.rolling_drag + (1 - drag.rolling_drag) * (m.cos(first) - m.cos(last)) / drag.rotation
    factor = _drag(friction, grade, share, m)
    speed = m.sqrt(end_speed * end_speed + 2 * gravity * factor * distance)
    return {
        "mean_share": share,
        "drag_factor": factor,
        "speed": speed,
        "speed_lost": speed - end_speed,
        "time": (speed - end_speed) / (gravity * factor),
    }


speed_single = single(speed_by_slope_angle)
distance_single = single(distance_by_squares)
yaw_single = single(yaw_by_bank_angle)
friction_single = single(friction_by_sums)
drag_single = single(drag_by_angles)
stop_single = single(stop_by_book)
least_vault_single = single(least_vault_by_book)
vault_single = single(vault_by_book)
throw_single = single(throw_by_searle)
avoid_single = single(avoid_by_roots)
spin_single = single(spin_by_differences)

# A task, its cases, what the textbook does, its function here, and that of 32 bits.
_RIVALS = (
    ("speed", "speed", "sine and cosine of the slope", "speed_by_slope_angle", "speed_single"),
    ("distance", "distance", "difference of squares", "distance_by_squares", "distance_single"),
    ("friction", "friction", "sums of squares in one pass", "friction_by_sums", "friction_single"),
    ("drag-factor", "drag_factor", "sine and cosine of the slope", "drag_by_angles", "drag_single"),
    ("stop", "stop", "v·t + v²/2a, brakes at once only", "stop_by_book", "stop_single"),
    ("yaw", "yaw", "angles added", "yaw_by_bank_angle", "yaw_single"),
    ("vault", "vault_least_speed", "rise plus slant", "least_vault_by_book", "least_vault_single"),
    ("vault", "vault_known_angle", "range formula as printed", "vault_by_book", "vault_single"),
    ("pedestrian", "pedestrian", "Searle, slide as a difference", "throw_by_searle", "throw_single"),
    ("avoid", "avoid", "root of the quadratic as taught", "avoid_by_roots", "avoid_single"),
    ("spin", "spin", "speeds subtracted", "spin_by_differences", "spin_single"),
)
_SEARCH = Method("golden sections over the angle", HERE + "least_vault_by_search")
QUESTIONS = tuple(
    Question(
        "skid", task, f"skid {task}", "skid.json", cases,
        Method(f"textbook: {name}", HERE + function), Method("the same in 32 bits", HERE + in_single),
        *((_SEARCH,) if cases == "vault_least_speed" else ()),
    )
    for task, cases, name, function, in_single in _RIVALS
)  # fmt: skip
