"""The skid tasks' answers in 60 digits, by other routes than the program takes: laws of motion instead of its formulas.

Angles instead of slopes, forces instead of drag factors, roots of the motion's own equations instead of
rearranged ones. Every function takes exact inputs (mpf) and gives a dictionary of results by address.
"""

from itertools import pairwise
from typing import Any

from mpmath import mp, mpf

mp.dps = 60

Inputs = dict[str, Any]
Results = dict[str, Any]


def deceleration(gravity: Any, friction: Any, grade: Any, braking: Any) -> Any:
    """Forces along an inclined road, per mass."""
    angle = mp.atan(grade)
    return gravity * (braking * friction * mp.cos(angle) + mp.sin(angle))


def speed(*, segments: list[Inputs], end_speed: Any, gravity: Any, mass: Any = None) -> Results:
    """March backwards through the surfaces, one work–energy balance each."""
    slowed = [deceleration(gravity, s["friction"], s["grade"], s["braking"]) for s in segments]
    speeds = [end_speed]
    for own, segment in zip(reversed(slowed), reversed(segments), strict=True):
        speeds.insert(0, mp.sqrt(speeds[0] * speeds[0] + 2 * own * segment["distance"]))
    times = [(fast - slow) / own for fast, slow, own in zip(speeds, speeds[1:], slowed, strict=False)]
    out: Results = {
        "speed": speeds[0],
        "time": mp.fsum(times),
        "total_distance": mp.fsum(s["distance"] for s in segments),
    }
    if mass is not None:
        out["energy"] = mass * speeds[0] ** 2 / 2
        out["friction_work"] = mp.fsum(
            s["braking"] * s["friction"] * mass * gravity * mp.cos(mp.atan(s["grade"])) * s["distance"]
            for s in segments
        )
    for index, (segment, own, time) in enumerate(zip(segments, slowed, times, strict=True)):
        row = {"entry_speed": speeds[index], "exit_speed": speeds[index + 1], "drag_factor": own / gravity}
        row |= {"time": time, "distance": segment["distance"]}
        out |= {f"surfaces[{index}].{name}": value for name, value in row.items()}
    return out


def distance(
    *, speed: Any, friction: Any, grade: Any, braking: Any, end_speed: Any, gravity: Any, mark: Any = None
) -> Results:
    """Distance as the integral of the speed."""
    own = deceleration(gravity, friction, grade, braking)
    time = (speed - end_speed) / own
    out = {
        "distance": speed * time - own * time**2 / 2,
        "time": time,
        "drag_factor": own / gravity,
        "deceleration": own,
    }
    if mark is not None:
        out["exit_time"] = (speed - mp.sqrt(speed**2 - 2 * own * mark)) / own
        out["exit_speed"] = speed - own * out["exit_time"]
    return out


def friction(*, skids: list[Inputs], gravity: Any) -> Results:
    """Forces on each test skid; moments of the sample from its plain sums."""
    found, drags = [], []
    for skid in skids:
        own = skid["speed"] ** 2 / (2 * skid["distance"])
        angle = mp.atan(skid["grade"])
        drags.append(own / gravity)
        found.append((own - gravity * mp.sin(angle)) / (skid["braking"] * gravity * mp.cos(angle)))
    count = len(found)
    mean = mp.fsum(found) / count
    out: Results = {"friction": mean, "lowest": min(found), "highest": max(found)}
    if count > 1:
        variance = (mp.fsum(one**2 for one in found) - count * mean**2) / (count - 1)
        out["standard_deviation"] = mp.sqrt(max(variance, mpf(0)))
        out["standard_error"] = out["standard_deviation"] / mp.sqrt(count)
    for index, (one, drag) in enumerate(zip(found, drags, strict=True)):
        row = {"friction": one, "drag_factor": drag}
        out |= {f"tests[{index}].{name}": value for name, value in row.items()}
    return out


def drag_factor(*, measurement: Inputs, gravity: Any) -> Results:
    """Equilibrium of the forces, solved as linear equations for a vehicle of unit weight."""
    given = {name: value for name, value in measurement.items() if name != "record"}
    return {"Surface": _surface, "Axles": _axles, "Sled": _sled}[measurement["record"]](gravity, **given)


def _surface(gravity: Any, friction: Any, grade: Any, braking: Any) -> Results:
    own = deceleration(gravity, friction, grade, braking)
    return {"drag_factor": own / gravity, "deceleration": own, "effective_friction": braking * friction}


def _axles(
    gravity: Any,
    front_friction: Any,
    rear_friction: Any,
    wheelbase: Any,
    cm_position: Any,
    cm_height: Any,
    front_braking: Any,
    rear_braking: Any,
    grade: Any,
) -> Results:
    angle = mp.atan(grade)
    front, rear = front_braking * front_friction, rear_braking * rear_friction
    # unknowns: front load, rear load, deceleration over gravity; moments about the front tyre's contact
    matrix = mp.matrix([[1, 1, 0], [0, wheelbase, cm_height], [-front, -rear, 1]])
    right = mp.matrix([mp.cos(angle), mp.cos(angle) * cm_position + mp.sin(angle) * cm_height, mp.sin(angle)])
    load_front, load_rear, drag = mp.lu_solve(matrix, right)
    total = load_front + load_rear
    return {
        "drag_factor": drag,
        "deceleration": gravity * drag,
        "effective_friction": (front * load_front + rear * load_rear) / total,
        "front_share": load_front / total,
        "rear_share": load_rear / total,
        "weight_transfer": load_front / total - (wheelbase - cm_position) / wheelbase,
    }


def _sled(gravity: Any, pull: Any, weight: Any, pull_angle: Any, grade: Any) -> Results:
    angle = mp.atan(grade)
    normal = weight * mp.cos(angle) - pull * mp.sin(pull_angle)
    sliding = (pull * mp.cos(pull_angle) - weight * mp.sin(angle)) / normal
    drag = sliding * mp.cos(angle) + mp.sin(angle)
    return {"drag_factor": drag, "deceleration": gravity * drag, "effective_friction": sliding}


def stop(
    *,
    speed: Any,
    friction: Any,
    reaction_time: Any,
    grade: Any,
    braking: Any,
    steps: int,
    gravity: Any,
    build_up_time: Any = None,
) -> Results:
    """Integrate the deceleration twice, phase by phase, as polynomials of time."""
    own = deceleration(gravity, friction, grade, braking)
    rows = [(mpf(0), mpf(0), speed)]
    way, start, now = mpf(0), mpf(0), speed
    out: Results = {"drag_factor": own / gravity, "deceleration": own, "reaction_distance": speed * reaction_time}
    phases: list[tuple[str, Any, list[Any]]] = [("reaction", reaction_time, [0])]
    if build_up_time is not None:
        until = build_up_time
        if build_up_time > 0 and own * build_up_time / 2 > speed:
            until = mp.sqrt(2 * speed * build_up_time / own)
        phases.append(("build_up", until, [0, own / build_up_time if build_up_time else mpf(0)]))
    for name, duration, rate in [*phases, ("braking", None, [own])]:
        if duration is None:
            duration = now / own
            out |= {"braking_speed": now, "braking_time": duration}
        # speed = now − ∫ rate, way = ∫ speed; rate's coefficients by rising power of time
        velocity = [now] + [-part / (power + 1) for power, part in enumerate(rate)]
        position = [way] + [part / (power + 1) for power, part in enumerate(velocity)]
        for step in range(1, steps + 1):
            time = duration * step / steps
            rows.append((start + time, _polynomial(position, time), _polynomial(velocity, time)))
        before = way
        start, way, now = rows[-1]
        if name == "build_up":
            now = mpf(0) if abs(now) < mpf(10) ** -45 * speed else now
            out |= {"build_up_distance": way - before, "build_up_duration": duration}
        elif name == "braking":
            out["braking_distance"] = way - before
    out |= {"stopping_distance": way, "stopping_time": start}
    for index, (time, gone, left) in enumerate(rows):
        left = mpf(0) if abs(left) < mpf(10) ** -45 * speed else left
        row = {"time": time, "distance": gone, "speed": left}
        out |= {f"timeline[{index}].{name}": value for name, value in row.items()}
    return out


def _polynomial(coefficients: list[Any], x: Any) -> Any:
    return mp.fsum(part * x**power for power, part in enumerate(coefficients))


def yaw(*, path: Inputs, friction: Any, superelevation: Any, gravity: Any, track_width: Any = None) -> Results:
    """Friction angle and bank angle add; a chord's radius from the angle it subtends."""
    if path["record"] == "Chord":
        half_angle = 2 * mp.atan(2 * path["middle_ordinate"] / path["chord"])
        mark = path["chord"] / (2 * mp.sin(half_angle))
    else:
        mark = path["radius"]
    radius = mark if track_width is None else mark - track_width / 2
    lateral = gravity * mp.tan(mp.atan(friction) + mp.atan(superelevation))
    return {
        "speed": mp.sqrt(lateral * radius),
        "path_radius": radius,
        "mark_radius": mark,
        "lateral_acceleration": lateral,
    }


def vault_known_angle(*, distance: Any, rise: Any, take_off: Any, gravity: Any) -> Results:
    """The flight's time from the height lost below the straight line of the take-off."""
    time = mp.sqrt(2 * (distance * mp.tan(take_off) - rise) / gravity)
    speed = distance / (time * mp.cos(take_off))
    forward, upward = speed * mp.cos(take_off), speed * mp.sin(take_off) - gravity * time
    return {
        "speed": speed,
        "launch_angle": take_off,
        "flight_time": time,
        "landing_speed": mp.sqrt(forward**2 + upward**2),
        "landing_angle": mp.atan2(-upward, forward),
    }


def vault_least_speed(*, distance: Any, rise: Any, gravity: Any) -> Results:
    """The least speed points half-way between the line of sight and the vertical."""
    with mp.workdps(400):
        take_off = mp.pi / 4 + mp.atan2(rise, distance) / 2
        return vault_known_angle(distance=distance, rise=rise, take_off=take_off, gravity=gravity)


def pedestrian(
    *, throw_distance: Any, friction: Any, launch_height: Any, gravity: Any, launch_angle: Any = None
) -> Results:
    """Speeds at which the simulated flight and slide end at the throw distance.

    The greatest angle is where a launch at the greatest speed comes to fall short of it, found by halving.
    """

    def landing(speed: Any, angle: Any) -> tuple[Any, Any, Any]:
        down = mp.sqrt((speed * mp.sin(angle)) ** 2 + 2 * gravity * launch_height)
        time = (speed * mp.sin(angle) + down) / gravity
        return time, speed * mp.cos(angle) * time, speed * mp.cos(angle) - friction * down

    def thrown(speed: Any, angle: Any) -> Any:
        _, flown, left = landing(speed, angle)
        return flown + left**2 / (2 * friction * gravity)

    def solve(angle: Any) -> Any:
        # thrown is quadratic in v² + constant: two evaluations fix it, no formula of the program needed
        one, two = mpf(1), mpf(2)
        slope = (thrown(two, angle) - thrown(one, angle)) / 3
        return mp.sqrt((throw_distance - thrown(one, angle)) / slope + 1)

    def reached(speed: Any, angle: Any) -> Any:
        _, flown, left = landing(speed, angle)
        return flown + (left**2 / (2 * friction * gravity) if left > 0 else 0)

    def flight(angle: Any) -> Any:
        # the flight alone ends at the throw distance
        rise = 2 * (throw_distance * mp.tan(angle) + launch_height)
        return throw_distance / mp.cos(angle) * mp.sqrt(gravity / rise)

    def least() -> Any:
        """Of slides, of flights that the landing ends, and where one becomes the other."""
        slides, steep = mp.atan(friction), (mp.pi / 2 - mp.atan2(launch_height, throw_distance)) / 2
        speeds = []
        if landing(solve(slides), slides)[2] >= 0:
            speeds.append(solve(slides))
        if landing(flight(steep), steep)[2] <= 0:
            speeds.append(flight(steep))
        with mp.workdps(100):
            low, high = -mp.atan2(launch_height, throw_distance), mp.pi / 2
            for _ in range(300):
                middle = (low + high) / 2
                low, high = (middle, high) if landing(flight(middle), middle)[2] > 0 else (low, middle)
            return min([*speeds, flight(low)])

    level = solve(mpf(0))
    if landing(level, mpf(0))[2] < 0:
        level = throw_distance / mp.sqrt(2 * launch_height / gravity)
    with mp.workdps(100):
        far, short = mp.atan(friction), mp.pi / 2
        assert reached(level, far) > throw_distance
        for _ in range(260):
            middle = (far + short) / 2
            far, short = (middle, short) if reached(level, middle) > throw_distance else (far, middle)
    out = {"least_speed": least(), "greatest_speed": level, "greatest_angle": far}
    if launch_angle is not None:
        speed = solve(launch_angle)
        time, flown, left = landing(speed, launch_angle)
        out |= {"speed": speed, "flight_time": time, "flight_distance": flown}
        out |= {"slide_time": left / (friction * gravity), "slide_distance": left**2 / (2 * friction * gravity)}
    return out


def avoid(
    *,
    speed: Any,
    sight_distance: Any,
    reaction_time: Any,
    friction: Any,
    grade: Any,
    braking: Any,
    gravity: Any,
    speed_limit: Any = None,
) -> Results:
    """Follow the motion to the hazard or to rest; the sufficient speed is the root of its quadratic."""
    own = deceleration(gravity, friction, grade, braking)

    def approach(start: Any) -> Results:
        reaction, stopping = start * reaction_time, start**2 / (2 * own)
        beyond = sight_distance - reaction
        if start == 0:
            impact, time = mpf(0), mpf(0)
        elif beyond <= 0:
            impact, time = start, sight_distance / start
        elif stopping <= beyond:
            impact, time = mpf(0), reaction_time + start / own
        else:
            braked = (start - mp.sqrt(start**2 - 2 * own * beyond)) / own
            impact, time = start - own * braked, reaction_time + braked
        return {
            "approach_speed": start,
            "reaction_distance": reaction,
            "braking_distance": stopping,
            "stopping_distance": reaction + stopping,
            "margin": beyond - stopping,
            "impact_speed": impact,
            "time": time,
        }

    with mp.workdps(900):
        root = mp.sqrt((own * reaction_time) ** 2 + 2 * own * sight_distance) - own * reaction_time
    travelled = approach(speed)
    out: Results = {"drag_factor": own / gravity, "sufficient_speed": root}
    out |= {name: travelled[name] for name in ("margin", "impact_speed", "stopping_distance")}
    cases = [travelled]
    if speed_limit is not None:
        limit = approach(speed_limit)
        out |= {"margin_at_limit": limit["margin"], "impact_speed_at_limit": limit["impact_speed"]}
        cases.append(limit)
    enough = approach(root) | {"margin": mpf(0), "impact_speed": mpf(0), "time": reaction_time + root / own}
    for index, case in enumerate([*cases, enough]):
        out |= {f"approaches[{index}].{name}": value for name, value in case.items()}
    return out


def spin(*, drag: Inputs, distance: Any, friction: Any, end_speed: Any, grade: Any, gravity: Any) -> Results:
    """Mean share by integrating the slip angle's sine between its zeros."""
    if drag["record"] == "Share":
        share = drag["drag_share"]
    else:
        start, stop = drag["start_angle"], drag["start_angle"] + drag["rotation"]
        zeros = [mp.pi * k for k in range(int(mp.ceil(start / mp.pi)), int(mp.floor(stop / mp.pi)) + 1)]
        points = [start, *[zero for zero in zeros if start < zero < stop], stop]
        across = mp.fsum(abs(mp.cos(begin) - mp.cos(end)) for begin, end in pairwise(points))
        share = drag["rolling_drag"] + (1 - drag["rolling_drag"]) * across / drag["rotation"]
    own = deceleration(gravity, friction, grade, share)
    speed = mp.sqrt(end_speed**2 + 2 * own * distance)
    out = {"speed": speed, "speed_lost": speed - end_speed, "mean_share": share, "drag_factor": own / gravity}
    out["time"] = (speed - end_speed) / own
    if drag["record"] == "Rotation":
        out["mean_yaw_rate"] = drag["rotation"] / out["time"] if out["time"] else mpf(0)
    return out
