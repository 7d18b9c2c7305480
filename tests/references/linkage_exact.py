"""Linkages in 60 digits by other formulas than the program: cosine rule, linear loop equations, complex numbers."""

from typing import Any

from mpmath import acos, arg, asin, cos, matrix, mp, mpc, mpf, pi, sin, sqrt

mp.dps = 60


def turn(angle: Any) -> Any:
    return mpc(cos(angle), sin(angle))


def cross(a: Any, b: Any) -> Any:
    return a.real * b.imag - a.imag * b.real


def solve_two(one: Any, other: Any, right: Any) -> tuple[Any, Any]:
    """x·one + y·other = right, for complex numbers as vectors."""
    system = matrix([[one.real, other.real], [one.imag, other.imag]])
    found = mp.lu_solve(system, matrix([right.real, right.imag]))
    return found[0], found[1]


def closed(a: Any, b: Any, c: Any, d: Any, theta: Any, side: int) -> tuple[Any, Any, Any]:
    """Crank, coupler and rocker as vectors; B by the angle at A, from the cosine rule."""
    crank = a * turn(theta)
    way = d - crank
    f = abs(way)
    angle = acos((b * b + f * f - c * c) / (2 * b * f))
    coupler = b * turn(arg(way) + side * angle)
    return crank, coupler, crank + coupler - d


def four_bar(
    crank: Any, coupler: Any, rocker: Any, ground: Any, crank_angle: Any, speed: Any, angular_acceleration: Any,
    point: Any, load_torque: Any, branch: str = "open",
) -> dict[str, Any]:  # fmt: skip
    """A pose with velocities and accelerations from the loop equations."""
    side = 1 if branch == "open" else -1
    a, b, c = closed(crank, coupler, rocker, ground, crank_angle, side)
    j = mpc(0, 1)
    w3, w4 = solve_two(j * b, -j * c, -speed * j * a)
    left = -(angular_acceleration * j - speed**2) * a + w3**2 * b - w4**2 * c
    a3, a4 = solve_two(j * b, -j * c, left)
    arm = mpc(*point) * b / coupler
    v = speed * j * a + w3 * j * arm
    acceleration = (angular_acceleration * j - speed**2) * a + (a3 * j - w3**2) * arm
    a_, b_, c_ = closed(crank, coupler, rocker, ground, crank_angle, -side)
    other = solve_two(j * b_, -j * c_, -j * a_)[1]
    found = {
        "rocker_angle": arg(c), "coupler_angle": arg(b), "transmission_angle": abs(arg(b / c)),
        "rocker_ratio": w4 / speed, "coupler_ratio": w3 / speed, "rocker_speed": w4, "coupler_speed": w3,
        "rocker_acceleration": a4, "coupler_acceleration": a3, "crank_torque": load_torque * w4 / speed,
        "other_rocker_angle": arg(c_), "other_coupler_angle": arg(b_), "other_rocker_ratio": other,
    }  # fmt: skip
    for name, value in (
        ("crank_pin", a), ("rocker_pin", a + b), ("position", a + arm), ("velocity", v), ("acceleration", acceleration),
    ):  # fmt: skip
        found[f"{name}[0]"], found[f"{name}[1]"] = value.real, value.imag
    limits = classify(crank, coupler, rocker, ground)
    if "time_ratio" in limits:
        least, greatest = limits["rocker_least"], limits["rocker_greatest"]
        ends = (least, greatest) if side > 0 else (-greatest, -least)
        found |= {"swing": greatest - least, "rocker_least": ends[0], "rocker_greatest": ends[1]}
    return found


def classify(crank: Any, coupler: Any, rocker: Any, ground: Any) -> dict[str, Any]:
    """Limits and transmission angles by the cosine rule."""
    a, b, c, d = crank, coupler, rocker, ground
    s, p, q, longest = sorted((a, b, c, d))
    found = {"margin": p + q - s - longest}

    def corner(opposite: Any, one: Any, two: Any) -> Any:
        return acos((one * one + two * two - opposite * opposite) / (2 * one * two))

    def bounds(one: Any, two: Any, three: Any, four: Any) -> tuple[Any, Any]:
        outer = corner(two + three, one, four) if two + three < one + four else None
        inner = corner(abs(two - three), one, four) if abs(two - three) > abs(one - four) else None
        return outer, inner

    outer, inner = bounds(a, b, c, d)
    found |= {name: value for name, value in (("outer_limit", outer), ("inner_limit", inner)) if value is not None}
    far, near = bounds(c, b, a, d)
    least = None if far is None else pi - far
    greatest = None if near is None else pi - near
    found |= {name: v for name, v in (("rocker_least", least), ("rocker_greatest", greatest)) if v is not None}
    if far is not None and near is not None:
        found["swing"] = far - near
    elif far is not None:
        found["swing"] = 2 * far
    elif greatest is not None:
        found["swing"] = 2 * greatest
    if s == a and found["margin"] > 0:
        first, second = corner(c, a + b, d), pi + corner(c, b - a, d)
        found |= {"extended_at": first, "folded_at": second}
        part = abs(second - first)
        ratio = part / (2 * pi - part)
        found["time_ratio"] = max(ratio, 1 / ratio)
    nearest = abs(a - d) if inner is None else abs(b - c)
    farthest = a + d if outer is None else b + c
    found["least_transmission_angle"] = corner(nearest, b, c) if nearest > abs(b - c) else mpf(0)
    found["greatest_transmission_angle"] = corner(farthest, b, c) if farthest < b + c else pi
    return found


def slider_crank(
    crank: Any, rod: Any, offset: Any, crank_angle: Any, speed: Any, angular_acceleration: Any, load_force: Any
) -> dict[str, Any]:
    """The slider by the rod's angle and loop equations."""
    a = crank * turn(crank_angle)
    tilt = asin((offset - a.imag) / rod)
    bar = rod * turn(tilt)
    j = mpc(0, 1)
    w3, v = solve_two(j * bar, mpc(-1), -speed * j * a)
    right = -(angular_acceleration * j - speed**2) * a + w3**2 * bar
    a3, acceleration = solve_two(j * bar, mpc(-1), right)
    far, near = sqrt((crank + rod) ** 2 - offset**2), sqrt((rod - crank) ** 2 - offset**2)
    start, end = asin(offset / (crank + rod)), pi + asin(offset / (rod - crank))
    part = abs(end - start)
    ratio = part / (2 * pi - part)

    def place(t: Any) -> Any:
        return crank * cos(t) + sqrt(rod**2 - (offset - crank * sin(t)) ** 2)

    guess = max((2 * pi * k / 360 for k in range(360)), key=lambda t: abs(mp.diff(place, t)))
    top = mp.findroot(lambda t: mp.diff(place, t, 2), guess)
    return {
        "top_at": top, "top_slope": abs(mp.diff(place, top)), "top_speed": abs(speed * mp.diff(place, top)),
        "position": (a + bar).real, "travel": far - (a + bar).real, "velocity": v, "acceleration": acceleration,
        "slope": v / speed, "rod_angle": tilt, "rod_speed": w3, "rod_acceleration": a3,
        "crank_torque": load_force * v / speed, "stroke": far - near, "time_ratio": max(ratio, 1 / ratio),
        "outer_at": start, "inner_at": end, "largest_rod_angle": asin((crank + abs(offset)) / rod),
    }  # fmt: skip


def quick_return(
    crank: Any, ground: Any, crank_angle: Any, speed: Any, angular_acceleration: Any, lever: Any
) -> dict[str, Any]:
    """The lever by its angle's derivatives: r e^{iθ} = a − d."""
    a = crank * turn(crank_angle)
    out = a - ground
    theta, r = arg(out), abs(out)
    e, j = turn(theta), mpc(0, 1)
    slip, w = solve_two(e, r * j * e, speed * j * a)
    right = (angular_acceleration * j - speed**2) * a - 2 * slip * w * j * e + w**2 * r * e
    _, bend = solve_two(e, r * j * e, right)
    tip, moving = ground + lever * e, lever * w * j * e
    part = acos(min(crank, ground) / max(crank, ground))
    found = {
        "lever_angle": theta, "lever_ratio": w / speed, "lever_speed": w, "lever_acceleration": bend, "reach": r,
        "slip": slip, "coriolis": 2 * slip * w, "time_ratio": (pi - part) / part,
        "tip[0]": tip.real, "tip[1]": tip.imag, "tip_velocity[0]": moving.real, "tip_velocity[1]": moving.imag,
    }  # fmt: skip
    if crank < ground:
        found |= {"swing": 2 * (pi / 2 - part), "stroke": 2 * lever * crank / ground}
    return found


def body(point: Any, velocity: Any, acceleration: Any, rest: Any) -> dict[str, Any]:
    """Centres by complex division."""
    p, v, a = (mpc(*part) for part in (point, velocity, acceleration))
    w, bend = rest["angular_velocity"], rest["angular_acceleration"]
    j = mpc(0, 1)
    centre, still = p - v / (j * w), p - a / (j * bend - w**2)
    pole = a + (j * bend - w**2) * (centre - p)
    return {
        "angular_velocity": w, "angular_acceleration": bend,
        "instant_centre[0]": centre.real, "instant_centre[1]": centre.imag, "distance": abs(v) / abs(w),
        "zero_acceleration[0]": still.real, "zero_acceleration[1]": still.imag,
        "inflection_diameter": abs(pole) / w**2, "inflection_direction": arg(pole),
    }  # fmt: skip


def chain(links: Any) -> dict[str, Any]:
    """The tip of a chain of absolute angles, by sums of complex numbers."""
    j = mpc(0, 1)
    at = moving = bending = mpc(0)
    found: dict[str, Any] = {}
    for index, link in enumerate(links):
        arm = link["length"] * turn(link["angle"])
        at, moving = at + arm, moving + j * link["speed"] * arm
        bending += (j * link["acceleration"] - link["speed"] ** 2) * arm
        own = f"joints[{index}]."
        found |= {own + "link": mpf(index + 1), own + "angle": link["angle"], own + "speed": link["speed"]}
        for name, value in (
            ("position", at), ("velocity", moving), ("acceleration", bending), ("partial_velocity", j * arm),
        ):  # fmt: skip
            found[f"{own}{name}[0]"], found[f"{own}{name}[1]"] = value.real, value.imag
    for name, value in (("position", at), ("velocity", moving), ("acceleration", bending)):
        found[f"{name}[0]"], found[f"{name}[1]"] = value.real, value.imag
    return found | {"angular_velocity": links[-1]["speed"], "angular_acceleration": links[-1]["acceleration"]}


def curve_length(a: Any, b: Any, c: Any, d: Any, point: Any, count: int) -> Any:
    """Length of the coupler curve of a full crank turn, by the trapezoid rule over the crank angle."""
    j, total = mpc(0, 1), mpf(0)
    for index in range(count):
        one, two, three = closed(a, b, c, d, 2 * pi * index / count, 1)
        w3, _ = solve_two(j * two, -j * three, -j * one)
        total += abs(j * one + w3 * j * point * two / b)
    return total * 2 * pi / count


def rates(place: Any) -> tuple[Any, Any, Any]:
    """Value, first and second derivative by time of a function of it, at time zero."""
    return place(mpf(0)), mp.diff(place, 0), mp.diff(place, 0, 2)


def scotch_yoke(
    crank: Any, crank_angle: Any, slot_angle: Any, speed: Any, angular_acceleration: Any, load_force: Any
) -> dict[str, Any]:
    """Where the slot's line through the pin meets the stroke; rates by differentiation over time."""

    def pin(t: Any) -> Any:
        return crank * turn(crank_angle + speed * t + angular_acceleration * t * t / 2)

    def yoke(t: Any) -> Any:
        return pin(t).real - pin(t).imag * mp.tan(slot_angle)

    x, v, a = rates(yoke)
    slip = mp.diff(lambda t: pin(t).imag / cos(slot_angle), 0)
    return {
        "position": x, "velocity": v, "acceleration": a, "slip": slip, "crank_torque": load_force * v / speed,
        "stroke": 2 * crank / cos(slot_angle), "top_speed": crank * abs(speed) / cos(slot_angle),
        "top_acceleration": crank * speed**2 / cos(slot_angle),
    }  # fmt: skip


def oldham(offset: Any, speed: Any, shaft_angle: Any, mass: Any) -> dict[str, Any]:
    """The disc's centre where the lines of both slots meet; rates by differentiation over time."""

    def shares(t: Any) -> tuple[Any, Any]:
        way = turn(shaft_angle + speed * t)
        return solve_two(way, -mpc(0, 1) * way, mpc(offset, 0))

    def centre(t: Any) -> Any:
        return shares(t)[0] * turn(shaft_angle + speed * t)

    here, v, a = rates(centre)
    return {
        "disc_speed": speed, "largest_slip": offset * abs(speed), "slide": 2 * offset,
        "first_slip": mp.diff(lambda t: shares(t)[0], 0), "second_slip": mp.diff(lambda t: shares(t)[1], 0),
        "centre[0]": here.real, "centre[1]": here.imag, "centre_speed": abs(v), "centre_acceleration": abs(a),
        "shaking_force": mass * abs(a),
    }  # fmt: skip


def trammel(
    bar: Any, angle: Any, point: Any, speed: Any = None, angular_acceleration: Any = 0, pull: Any = None,
    pull_acceleration: Any = 0,
) -> dict[str, Any]:  # fmt: skip
    """The bar between its ends, which slide; rates by differentiation over time."""

    def turned_by(t: Any) -> Any:
        if pull is None:
            return angle + speed * t + angular_acceleration * t * t / 2
        return acos((bar * cos(angle) + pull * t + pull_acceleration * t * t / 2) / bar)

    def place(t: Any) -> Any:
        foot, top = mpc(bar * cos(turned_by(t)), 0), mpc(0, bar * sin(turned_by(t)))
        return foot + (top - foot) * point / bar

    here, v, a = rates(place)
    _, rate, bend = rates(turned_by)
    found = {
        "bar_speed": rate, "bar_acceleration": bend, "foot": bar * cos(angle), "top": bar * sin(angle),
        "foot_velocity": mp.diff(lambda t: bar * cos(turned_by(t)), 0),
        "top_velocity": mp.diff(lambda t: bar * sin(turned_by(t)), 0), "centre[0]": bar * cos(angle),
        "centre[1]": bar * sin(angle), "along_x": abs(bar - point), "along_y": abs(point),
    }  # fmt: skip
    for name, value in (("position", here), ("velocity", v), ("acceleration", a)):
        found[f"{name}[0]"], found[f"{name}[1]"] = value.real, value.imag
    return found
