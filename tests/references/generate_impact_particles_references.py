"""Writes impact_particles.json: the particle tasks' answers to 40 digits, for ordinary and hard inputs.

Run: python tests/references/generate_impact_particles_references.py [FILE]. The same bytes every time. The answers are
found in another way than by the program: linear equations of momentum and restitution, velocities before and after,
kinetic energies as differences, constraints by Lagrange multipliers, all in 300 digits.
"""

import random
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from mpmath import acos, atan2, cos, matrix, mp, mpf, pi, polyroots, sin, sqrt
from references.case_files import put
from references.impact_approaches import approach, approaches
from references.impact_chains import chained
from references.impact_found import FOUND
from references.trees import draw, exact, written

mp.dps = 300
G = 9.80665
Case = tuple[str, str, dict[str, Any]]


def mass(value: float) -> dict[str, Any]:
    return {"record": "ByMass", "mass": value}


def weight(value: float) -> dict[str, Any]:
    return {"record": "ByWeight", "weight": value}


FIXED = {"record": "Fixed", "fixed": True}


def mass_of(bulk: dict[str, Any], gravity: Any) -> Any:
    if bulk["record"] == "Fixed":
        return None
    return bulk["mass"] if bulk["record"] == "ByMass" else bulk["weight"] / gravity


def restituted(e: float) -> dict[str, Any]:
    return {"record": "Restituted", "restitution": e}


def ratio_of(contact: dict[str, Any]) -> Any:
    return contact.get("restitution", contact.get("energetic_contact"))


def line_impact(m1: Any, m2: Any, v1: Any, v2: Any, e: Any) -> tuple[Any, Any]:
    """Velocities after, from the equations of momentum and restitution; m2 None is fixed."""
    if m2 is None:
        return v2 - e * (v1 - v2), v2
    found = mp.lu_solve(matrix([[m1, m2], [-1, 1]]), matrix([m1 * v1 + m2 * v2, e * (v1 - v2)]))
    return found[0], found[1]


def push(force: dict[str, Any] | None, reduced: Any, closing: Any, e: Any) -> dict[str, Any]:
    if force is None:
        return {}
    if force["record"] == "Spring":
        k, q = force["contact_stiffness"], mpf(2)
    else:
        k, q = 4 * force["contact_modulus"] * sqrt(force["contact_radius"]) / 3, mpf(5) / 2
    depth = (q * reduced * closing**2 / (2 * k)) ** (1 / q)
    quarter = sqrt(pi) * mp.gamma(1 / q) / (q * mp.gamma(1 / q + mpf(1) / 2))
    duration = (1 + e) * quarter * depth / closing
    return {
        "push.duration": duration,
        "push.peak_force": k * depth ** (q - 1),
        "push.mean_force": (1 + e) * reduced * closing / duration,
        "push.compression": depth,
    }


def central(x: dict[str, Any]) -> dict[str, Any]:
    m1, m2 = mass_of(x["first"]["bulk"], x["gravity"]), mass_of(x["second"]["bulk"], x["gravity"])
    v1, v2 = x["first"].get("velocity"), x["second"].get("velocity")
    closing = x.get("closing_speed")
    if closing is None:
        v1, v2 = v1 or mpf(0), v2 or mpf(0)
        closing = v1 - v2
    elif v2 is None:
        v1 = v1 or mpf(0)
        v2 = v1 - closing
    elif v1 is None:
        v1 = v2 + closing
    e = ratio_of(x["contact"])
    # a closing speed that is given rules over the difference of the velocities
    w1, w2 = line_impact(m1, m2, closing, mpf(0), e)
    d1, d2 = w1 - closing, w2
    after = v1 + d1, v2 + d2
    reduced = m1 if m2 is None else 1 / (1 / m1 + 1 / m2)
    out = {
        "first.velocity": after[0],
        "first.delta_v": d1,
        "first.energy_change": m1 * (after[0] ** 2 - v1**2) / 2,
        "first.mass": m1,
        "second.velocity": after[1],
        "second.delta_v": d2,
        "second.energy_change": -m1 * d1 * v2 if m2 is None else m2 * (after[1] ** 2 - v2**2) / 2,
        "impulse": -m1 * d1,
        "compression_impulse": -m1 * d1 / (1 + e),
        "closing_speed": closing,
        "separation_speed": w2 - w1,
        "common_velocity": v2 if m2 is None else (m1 * (v2 + closing) + m2 * v2) / (m1 + m2) + (v1 - v2 - closing),
        "reduced_mass": reduced,
        "energy_lost": reduced * (closing**2 - (w1 - w2) ** 2) / 2,
        "share_lost": 1 - ((w1 - w2) / closing) ** 2,
    }
    if m2 is not None:
        out["second.mass"] = m2
    return out | push(x.get("force"), reduced, closing, e)


def centrals(generator: random.Random) -> Iterator[Case]:
    for number in range(16):
        own: dict[str, Any] = {
            "first": {"bulk": mass(draw(generator, 0.5, 2000.0)), "velocity": draw(generator, 5.0, 30.0)},
            "second": {"bulk": mass(draw(generator, 0.5, 2000.0)), "velocity": draw(generator, -20.0, 4.0)},
            "contact": restituted(draw(generator, 0.0, 1.0)),
            "gravity": G,
        }
        if number % 4 == 1:
            own["first"]["bulk"] = weight(draw(generator, 3000.0, 20000.0))
        if number % 4 == 2:
            own["force"] = {"record": "Spring", "contact_stiffness": draw(generator, 1e4, 1e6)}
        if number % 4 == 3:
            own["force"] = {"record": "Hertz", "contact_radius": 0.02, "contact_modulus": draw(generator, 1e9, 1e11)}
        if number % 5 == 4:
            own["second"]["bulk"] = FIXED
        yield "ordinary", "", own
    base = {"gravity": G, "contact": restituted(0.3)}

    def pair(m1: float, v1: float, m2: float, v2: float, **more: Any) -> dict[str, Any]:
        first, second = {"bulk": mass(m1), "velocity": v1}, {"bulk": mass(m2), "velocity": v2}
        return {"first": first, "second": second, **base, **more}

    for ratio in (1e12, 1e20, 1e-20):
        yield "hard", "a mass ratio at which differences of velocities have no digits left", pair(ratio, 20.0, 1.0, 3.0)
    for close in (300.0 - 1e-12, 299.99999999999994):
        yield "hard", "speeds that agree to nearly all digits: only the difference counts", pair(1e3, 300.0, 7e2, close)
    gap = {"first": {"bulk": mass(1e3), "velocity": 300.0}, "second": {"bulk": mass(7e2)}, "closing_speed": 1e-12}
    yield (
        "hard",
        "a closing speed of 1e-12 m/s at 300 m/s: it is given, since the velocities' difference has no digit of it",
        {**base, **gap},
    )
    for e in (0.0, 1.0, 0.9999999999999999, 1e-39):
        why = "the ends of restitution: 1 - e² cancels if it is not factored"
        yield "hard", why, pair(3.0, 4.0, 2.0, -1.0, contact=restituted(e))
    why = "equal masses with e = 1 exchange velocities: the first comes to rest exactly"
    yield "hard", why, pair(0.7, 1.3, 0.7, 0.0, contact=restituted(1.0))
    yield (
        "hard",
        "speeds of 1e39 m/s: energies are 75 orders above ordinary ones, and no tolerance may be absolute",
        pair(1e-3, 1e39, 2e-3, -1e38),
    )
    yield (
        "hard",
        "speeds of 1e-38 m/s: energies of 1e-73 J must not vanish beside any tolerance",
        pair(1e3, 1e-38, 2e3, -1e-39),
    )
    wall = {"first": {"bulk": mass(2.0), "velocity": 3.0}, "second": {"bulk": FIXED, "velocity": -40.0}, **base}
    yield "hard", "a wall that comes to meet the body and does work on it", wall
    creeping = {"first": {"bulk": mass(2.0), "velocity": 11.0}, "second": {"bulk": FIXED, "velocity": -1.6e-7}, **base}
    why = "found by search: a wall that hardly moves, at which the body is left with the wall's velocity"
    yield "hard", why, {**creeping, "contact": restituted(0.0)}
    why = "found by search: a grain that is left with what little the heavy body's velocity becomes"
    yield "hard", why, pair(5.3e-5, 20.0, 3.0, 0.0, contact=restituted(8.2e-6))
    energetic = {"record": "Energetic", "energetic_contact": 1.7}
    yield (
        "hard",
        "a contact that gives energy: restitution above one, 1 − e² and the loss are negative",
        pair(3.0, 4.0, 2.0, -1.0, contact=energetic),
    )


def direction(heading: Any, axes: str) -> tuple[Any, Any]:
    return (sin(heading), cos(heading)) if axes == "compass" else (cos(heading), sin(heading))


def heading_of(x: Any, y: Any, axes: str) -> Any:
    return atan2(x, y) if axes == "compass" else atan2(y, x)


def velocity_of(motion: dict[str, Any], axes: str) -> tuple[Any, Any]:
    if motion["record"] == "ByVelocity":
        return tuple(motion["velocity"])
    x, y = direction(motion["heading"], axes)
    return motion["speed"] * x, motion["speed"] * y


def wrapped(angle: Any) -> Any:
    while angle <= -pi:
        angle += 2 * pi
    while angle > pi:
        angle -= 2 * pi
    return angle


def delta_v(change: tuple[Any, Any], nose: Any, axes: str, zero: Any = None) -> dict[str, Any]:
    """ΔV of a body whose nose has a mathematical angle; `zero` is that of PDOF zero."""
    x, y = change
    size = sqrt(x * x + y * y)
    angle = atan2(-y, -x)
    sense = -1 if axes != "sae" else 1
    from_nose = wrapped(sense * (angle - nose))
    along = wrapped(sense * (angle - (nose if zero is None else zero)))
    hour = int(mp.floor(from_nose * 6 / pi + mpf(1) / 2))
    return {
        "delta_v.vector[0]": x,
        "delta_v.vector[1]": y,
        "delta_v.magnitude": size,
        "delta_v.longitudinal": size * cos(angle + pi - nose),
        "delta_v.lateral": size * sin(angle + pi - nose),
        "delta_v.pdof": along,
        "delta_v.clock": mpf(hour if hour > 0 else hour + 12),
    }


def math_angle(vector: tuple[Any, Any]) -> Any:
    return atan2(vector[1], vector[0])


def oblique(x: dict[str, Any]) -> dict[str, Any]:
    axes = x["axes"]["word"]
    m1, m2 = mass_of(x["first"]["bulk"], x["gravity"]), mass_of(x["second"]["bulk"], x["gravity"])
    v = velocity_of(x["first"]["motion"], axes), velocity_of(x["second"]["motion"], axes)
    relative = v[0][0] - v[1][0], v[0][1] - v[1][1]
    line = x["line"]
    if line["record"] == "Normal":
        turn = math_angle(direction(line["normal"], axes))
    elif line["record"] == "Centres":
        a, b = line["first_centre"], line["second_centre"]
        turn = math_angle((b[0] - a[0], b[1] - a[1]))
    else:
        turn = math_angle(relative) + mp.asin(line["offset"] / (line["first_radius"] + line["second_radius"]))
    c, s = cos(turn), sin(turn)
    along = [c * w[0] + s * w[1] for w in v]
    across = [c * w[1] - s * w[0] for w in v]
    e = ratio_of(x["contact"])
    after = line_impact(m1, m2, along[0], along[1], e)
    out: dict[str, Any] = {}
    for name, m, before, n0, n1, t, body in zip(
        ("first", "second"), (m1, m2), v, along, after, across, (x["first"], x["second"]), strict=True
    ):
        u = c * n1 - s * t, s * n1 + c * t
        if m is None:
            u = before
        change = c * (n1 - n0), s * (n1 - n0)
        own = {
            "velocity[0]": u[0],
            "velocity[1]": u[1],
            "speed": sqrt(u[0] ** 2 + u[1] ** 2),
            "heading": heading_of(u[0], u[1], axes),
            "normal_velocity": n1 if m is not None else n0,
            "tangential_velocity": t,
            "energy_change": m1 * (along[0] - after[0]) * n0 if m is None else m * (n1**2 - n0**2) / 2,
        }
        if m is not None:
            moves = before[0] != 0 or before[1] != 0
            travel = math_angle(before if moves else direction(mpf(0), axes))
            nose = travel if body.get("nose") is None else math_angle(direction(body["nose"], axes))
            zeros = {"heading": nose, "travel": travel, "scene": math_angle(direction(mpf(0), axes))}
            own |= delta_v(change, nose, axes, zeros[x["pdof_zero"]["word"]])
        out |= {f"{name}.{key}": value for key, value in own.items()}
    closing = along[0] - along[1]
    impulse = m1 * (along[0] - after[0])
    reduced = m1 if m2 is None else 1 / (1 / m1 + 1 / m2)
    out |= {
        "impulse": impulse,
        "normal_direction": heading_of(c, s, axes),
        "closing_speed": closing,
        "separation_speed": after[1] - after[0],
        "sliding_speed": abs(across[0] - across[1]),
        "energy_lost": reduced * (closing**2 - (after[1] - after[0]) ** 2) / 2,
    }
    return out | push(x.get("force"), reduced, closing, e)


def obliques(generator: random.Random) -> Iterator[Case]:
    zeros = ("heading", "travel", "scene")
    for number in range(18):
        axes = ("mathematical", "compass", "sae", "iso")[number % 4]
        turn = generator.uniform(-3.0, 3.0)
        own: dict[str, Any] = {
            "first": {
                "bulk": mass(draw(generator, 0.5, 2000.0)),
                "motion": {"record": "BySpeed", "speed": draw(generator, 15.0, 30.0), "heading": turn},
            },
            "second": {
                "bulk": mass(draw(generator, 0.5, 2000.0)),
                "motion": {"record": "ByVelocity", "velocity": [generator.uniform(-6, 6), generator.uniform(-6, 6)]},
            },
            "line": {"record": "Normal", "normal": turn + generator.uniform(-0.8, 0.8)},
            "contact": restituted(draw(generator, 0.0, 1.0)),
            "axes": {"word": axes},
            "pdof_zero": {"word": zeros[number % 3]},
            "gravity": G,
        }
        if number % 3 == 1:
            own["first"]["nose"] = turn + generator.uniform(-0.5, 0.5)
        if number % 6 == 5:
            own["line"] = {"record": "Offset", "offset": 0.012, "first_radius": 0.03, "second_radius": 0.04}
        if number == 7:
            own["second"]["bulk"] = FIXED
        yield "ordinary", "", own
    base: dict[str, Any] = {
        "axes": {"word": "mathematical"},
        "pdof_zero": {"word": "heading"},
        "gravity": G,
        "contact": restituted(0.4),
    }

    def pair(m1: float, v1: list[float], m2: float, v2: list[float], line: dict[str, Any]) -> dict[str, Any]:
        first = {"bulk": mass(m1), "motion": {"record": "ByVelocity", "velocity": v1}}
        second = {"bulk": mass(m2), "motion": {"record": "ByVelocity", "velocity": v2}}
        return {"first": first, "second": second, "line": line, **base}

    for off in (1e-6, 1e-9):
        why = "grazing: the line of impact is nearly square to the relative velocity"
        line = {"record": "Normal", "normal": 1.5707963267948966 - off}
        yield "hard", why, pair(2.0, [20.0, 0.0], 3.0, [0.0, 0.0], line)
    for gap in (1e-9, 1e-14):
        line = {"record": "Offset", "offset": 0.07 * (1.0 - gap), "first_radius": 0.03, "second_radius": 0.04}
        why = "spheres that all but pass each other: the normal turns by the root of the gap"
        yield "hard", why, pair(2.0, [20.0, 1.0], 3.0, [0.0, 0.0], line)
    for ratio in (1e15, 1e-15):
        line = {"record": "Normal", "normal": 0.3}
        why = "a mass ratio of 1e15: the heavy body's change is lost in a difference of its velocities"
        yield "hard", why, pair(ratio, [20.0, 4.0], 1.0, [-3.0, 2.0], line)
    line = {"record": "Centres", "first_centre": [1e8, 1e8], "second_centre": [100000000.25, 100000000.125]}
    yield (
        "hard",
        "centres 3e8 sizes from the origin: the line of impact is a difference of positions that keeps eight digits",
        pair(2.0, [5.0, 5.0], 1.0, [0.0, 0.0], line),
    )
    line = {"record": "Normal", "normal": 0.0444}
    own = pair(5.3e-5, [20.0, 0.0], 3.0, [0.0, 0.0], line)
    why = "found by search: a grain whose velocity along the line becomes that of the heavy sphere"
    yield "hard", why, {**own, "contact": restituted(8.2e-6)}
    line = {"record": "Normal", "normal": 0.3}
    yield (
        "hard",
        "closing at a millionth of 1 m/s at 300 m/s: kinetic energies agree in all their digits",
        pair(2.0, [300.0, 40.0], 1.0, [299.999999, 40.0], line),
    )


def drop(x: dict[str, Any]) -> dict[str, Any]:
    g, how = x["gravity"], x["evidence"]
    h = x.get("height")
    if how["record"] == "Restituted":
        e = how["restitution"]
    elif how["record"] == "ReboundHeight":
        e = mp.root(how["rebound_height"] / h, 2 * how.get("after_bounces", 1))
    elif how["record"] == "FlightTimes":
        e = how["next_flight_time"] / how["flight_time"]
        if h is None:
            h = (g * how["flight_time"] / (2 * e)) ** 2 / (2 * g)
    else:
        fall = sqrt(2 * h / g)
        e = (how["rest_time"] - fall) / (how["rest_time"] + fall)
    fall = sqrt(2 * h / g)
    out = {
        "restitution": e,
        "drop_height": h,
        "impact_speed": g * fall,
        "fall_time": fall,
        "share_lost": 1 - e * e,
    }
    if e < 1:
        # the sums of the geometric series of flights and of ways up and down
        out["time_to_rest"] = fall + 2 * fall * e / (1 - e)
        out["way_to_rest"] = h + 2 * h * e * e / (1 - e * e)
    if "mass" in x:
        out["energy_lost"] = x["mass"] * g * (h - e * e * h)
    moment = fall
    for n in range(x.get("bounces", 5)):
        speed = g * fall * e**n
        flight = 2 * speed * e / g
        row = {
            "number": mpf(n + 1), "time": moment, "impact_speed": speed, "rebound_speed": e * speed,
            "height": h * e ** (2 * n + 2), "flight_time": flight,
        }  # fmt: skip
        out |= {f"bounces[{n}].{key}": value for key, value in row.items()}
        moment += flight
    return out


def drops(generator: random.Random) -> Iterator[Case]:
    for number in range(12):
        h = draw(generator, 0.5, 3.0)
        how: dict[str, Any] = {"record": "Restituted", "restitution": draw(generator, 0.2, 0.95)}
        if number % 4 == 1:
            how = {"record": "ReboundHeight", "rebound_height": h * generator.uniform(0.3, 0.9)}
        elif number % 4 == 2:
            how = {"record": "FlightTimes", "flight_time": 0.7, "next_flight_time": generator.uniform(0.3, 0.65)}
        elif number % 4 == 3:
            how = {"record": "RestTime", "rest_time": draw(generator, 2.0, 6.0)}
        own = {"evidence": how, "height": h, "bounces": 3, "gravity": G}
        if number % 3 == 0:
            own["mass"] = draw(generator, 0.05, 3.0)
        yield "ordinary", "", own
    base = {"height": 1.5, "bounces": 3, "gravity": G}

    def found(record: str, **more: Any) -> dict[str, Any]:
        return {"evidence": {"record": record, **more}, **base}

    for e in (0.9999999999999999, 1.0 - 1e-9):
        yield "hard", "nearly elastic: the time to rest grows as 1/(1 - e)", found("Restituted", restitution=e)
    yield (
        "hard",
        "e = 0: no bounce at all, and quotients by e, or logarithms of it, do not exist",
        found("Restituted", restitution=0.0),
    )
    yield (
        "hard",
        "e = 1: bounces have no end, 1 − e divides the time to rest and is zero",
        found("Restituted", restitution=1.0),
    )
    why = "the fiftieth bounce: restitution is a hundredth root of a ratio of heights, a power loses as many digits"
    yield "hard", why, found("ReboundHeight", rebound_height=1e-4, after_bounces=50)
    why = "a rebound as high as the drop to 15 digits: what is lost of restitution and energy is their last place"
    yield "hard", why, found("ReboundHeight", rebound_height=1.4999999999999996)
    why = "rest hardly later than the fall: the difference of two times"
    yield "hard", why, found("RestTime", rest_time=0.5531)
    why = "flight times that agree to ten digits: the restitution's distance from one keeps six"
    yield "hard", why, {**found("FlightTimes", flight_time=0.5, next_flight_time=0.49999999995), "height": 0.4}
    flights = {"record": "FlightTimes", "flight_time": 0.5, "next_flight_time": 1e-3}
    yield (
        "hard",
        "flights that end at once: the height is that of a time whose square is tiny",
        {"evidence": flights, "bounces": 2, "gravity": G},
    )


def pendulum(x: dict[str, Any]) -> dict[str, Any]:
    m, g, e, how = x["shot_mass"], x["gravity"], x["restitution"], x["swing"]
    big = mass_of(x["block"]["bulk"], g)
    out: dict[str, Any] = {}
    if how["record"] == "Hinged":
        stays = 1 if e == 0 else 0
        b, d, theta = how["impact_distance"], how["centre_distance"], how["swing"]
        inertia = how["inertia"] + stays * m * b * b
        spin = sqrt(2 * (big * d + stays * m * b) * g * (1 - cos(theta)) / inertia)
        rise = (big * d + stays * m * b) / (big + stays * m) * (1 - cos(theta))
        effective, speed = how["inertia"] / b**2, b * spin
        out = {"angular_velocity": spin, "hinge_impulse": effective * speed - big * d * spin}
    else:
        if how["record"] == "Rise":
            rise = how["rise"]
        elif how["record"] == "Swing":
            rise = how["length"] * (1 - cos(how["swing"]))
        else:
            rise = how["length"] - sqrt(how["length"] ** 2 - how["travel"] ** 2)
        effective, speed = big, sqrt(2 * g * rise)
    # one unknown: speed before, such that the struck mass leaves at `speed`
    before = speed / line_impact(m, effective, mpf(1), mpf(0), e)[1]
    after = line_impact(m, effective, before, mpf(0), e)[0]
    kinetic = m * before**2 / 2
    lost = kinetic - m * after**2 / 2 - effective * speed**2 / 2
    return out | {
        "speed": before,
        "pendulum_speed": speed,
        "shot_speed_after": after,
        "rise": rise,
        "impulse": effective * speed,
        "effective_mass": effective,
        "energy_before": kinetic,
        "energy_lost": lost,
        "share_lost": lost / kinetic,
    }


def pendulums(generator: random.Random) -> Iterator[Case]:
    for number in range(12):
        how: dict[str, Any] = {"record": "Rise", "rise": draw(generator, 0.02, 0.4)}
        if number % 4 == 1:
            how = {"record": "Swing", "swing": draw(generator, 0.1, 1.2), "length": draw(generator, 0.5, 3.0)}
        elif number % 4 == 2:
            how = {"record": "Sideways", "travel": draw(generator, 0.1, 0.5), "length": draw(generator, 0.6, 3.0)}
        elif number % 4 == 3:
            how = {
                "record": "Hinged", "swing": draw(generator, 0.1, 1.2), "inertia": draw(generator, 1.4, 3.0),
                "centre_distance": draw(generator, 0.4, 0.6), "impact_distance": draw(generator, 0.4, 0.9),
            }  # fmt: skip
        yield "ordinary", "", {
            "shot_mass": draw(generator, 0.01, 0.1), "block": {"bulk": mass(draw(generator, 0.5, 3.0))}, "swing": how,
            "restitution": 0.0 if number % 3 else draw(generator, 0.1, 0.8), "gravity": G,
        }  # fmt: skip
    base = {"shot_mass": 0.01, "block": {"bulk": mass(2.0)}, "restitution": 0.0, "gravity": G}
    for swing in (1e-9, 3.14159):
        why = "1 - cos θ cancels for a small swing; at the top its slope ends"
        yield "hard", why, {**base, "swing": {"record": "Swing", "swing": swing, "length": 1.2}}
    for travel in (1e-10, 1.2 * (1.0 - 1e-12)):
        why = "L - √(L² - x²) cancels for a small travel, and has no slope at the full length"
        yield "hard", why, {**base, "swing": {"record": "Sideways", "travel": travel, "length": 1.2}}
    hinged = {"record": "Hinged", "swing": 0.3, "inertia": 0.72, "centre_distance": 0.6, "impact_distance": 0.6}
    yield "hard", "struck at the centre of percussion: the hinge feels nothing", {**base, "swing": hinged}
    for shot in (1e-15, 1e15):
        rise = {"record": "Rise", "rise": 0.1}
        yield (
            "hard",
            "a shot very light or very heavy beside the bob: the velocity kept is a share near zero or near one",
            {**base, "shot_mass": shot, "swing": rise},
        )


def seize(x: dict[str, Any]) -> dict[str, Any]:
    body = x["body"]
    if body["record"] == "SquarePlate":
        m, a, spin = body["plate_mass"], body["side"], body["spin"]
        one = m * a * a / 12
        inertia = [[one, 0, 0], [0, one, 0], [0, 0, 2 * one]]
        w, v = [spin / sqrt(mpf(2))] * 2 + [mpf(0)], [mpf(0)] * 3
        edge = body["seized"]["word"] == "edge"
        point, axis = [mpf(0) if edge else a / 2, -a / 2, mpf(0)], [mpf(1), mpf(0), mpf(0)] if edge else None
    else:
        m, inertia, w, v = body["mass"], body["inertia"], body["angular_velocity"], body["velocity"]
        point, axis = body["point"], body.get("axis")
    # M (q' − q) = Cᵀ λ, C q' = 0 with q = (v, ω): the held point stands still, and across the axis nothing turns
    big = mp.zeros(6)
    for i in range(3):
        big[i, i] = m
        for j in range(3):
            big[3 + i, 3 + j] = inertia[i][j]
    x0, y0, z0 = point
    rows = [[1, 0, 0, 0, z0, -y0], [0, 1, 0, -z0, 0, x0], [0, 0, 1, y0, -x0, 0]]
    if axis is not None:
        least = min(range(3), key=lambda i: abs(axis[i]))
        helper = [mpf(int(i == least)) for i in range(3)]
        one = crossed(axis, helper)
        rows += [[0, 0, 0, *one], [0, 0, 0, *crossed(axis, one)]]
    count = len(rows)
    system = mp.zeros(6 + count)
    right = mp.zeros(6 + count, 1)
    q = [*v, *w]
    for i in range(6):
        for j in range(6):
            system[i, j] = big[i, j]
            right[i] += big[i, j] * q[j]
        for k in range(count):
            system[i, 6 + k] = -rows[k][i]
            system[6 + k, i] = rows[k][i]
    found = mp.lu_solve(system, right)
    after = [found[i] for i in range(6)]
    change = [after[i] - q[i] for i in range(6)]
    impulse = [m * change[i] for i in range(3)]
    turned = [sum(inertia[i][j] * change[3 + j] for j in range(3)) for i in range(3)]
    couple = [a - b for a, b in zip(turned, crossed(point, impulse), strict=True)]
    kinetic = [sum(state[i] * big[i, j] * state[j] for i in range(6) for j in range(6)) / 2 for state in (q, after)]
    out = {f"angular_velocity[{i}]": after[3 + i] for i in range(3)}
    out |= {f"centre_velocity[{i}]": after[i] for i in range(3)} | {f"impulse[{i}]": impulse[i] for i in range(3)}
    if axis is not None:
        out |= {f"couple[{i}]": couple[i] for i in range(3)} | {"couple_size": norm(couple)}
    if norm(w) > 0:
        out["angular_ratio"] = norm(after[3:]) / norm(w)
    return out | {
        "angular_speed": norm(after[3:]),
        "impulse_size": norm(impulse),
        "energy_before": kinetic[0],
        "energy_after": kinetic[1],
        "energy_lost": kinetic[0] - kinetic[1],
        "energy_ratio": kinetic[1] / kinetic[0],
    }


def crossed(a: list[Any], b: list[Any]) -> list[Any]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a: list[Any]) -> Any:
    return sqrt(sum(part * part for part in a))


def seizes(generator: random.Random) -> Iterator[Case]:
    for part in ("edge", "corner"):
        for size, spin in ((1.0, 10.0), (draw(generator, 0.1, 2.0), -draw(generator, 1.0, 9.0))):
            plate = {"record": "SquarePlate", "plate_mass": draw(generator, 0.5, 4.0), "side": size, "spin": spin}
            yield "ordinary", "", {"body": {**plate, "seized": {"word": part}}}

    def three(size: float) -> list[float]:
        return [draw(generator, -size, size) for _ in range(3)]

    for number in range(10):
        a, b, c = (generator.uniform(0.1, 0.3) for _ in range(3))
        p, q, r = (generator.uniform(-0.03, 0.03) for _ in range(3))
        body: dict[str, Any] = {
            "record": "AnyBody", "mass": draw(generator, 0.5, 5.0), "angular_velocity": three(8.0),
            "inertia": [[a + b, p, q], [p, b + c, r], [q, r, a + c]], "point": three(0.5), "velocity": three(2.0),
        }  # fmt: skip
        if number % 2:
            body["axis"] = three(3.0)
        yield "ordinary", "", {"body": body}
    base: dict[str, Any] = {
        "record": "AnyBody", "mass": 2.0, "angular_velocity": [0.0, 0.0, 5.0], "velocity": [1.0, 0.0, 0.0],
        "inertia": [[0.2, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.4]], "point": [0.0, 0.5, 0.0],
    }  # fmt: skip
    # H_O = J ω + m (r × v): with r = −point it vanishes for v = (2, 0, 0), ω = −5
    for speed in (2.0, 2.0 - 1e-9):
        change = {"angular_velocity": [0.0, 0.0, -5.0], "velocity": [speed, 0.0, 0.0]}
        yield "hard", "everything stops: the angular momentum about the point cancels", {"body": {**base, **change}}
    far = {"point": [1e6, 0.0, 0.0], "axis": [0.0, 0.0, 1.0]}
    yield "hard", "held far from the body: its own inertia hardly counts", {"body": {**base, **far}}
    thin = {"inertia": [[1e-12, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.3]], "angular_velocity": [4.0, 1.0, 0.0]}
    yield "hard", "a thin rod: moments of inertia twelve orders apart in one sum", {"body": {**base, **thin}}
    own = {"point": [0.0, 0.0, 0.0], "velocity": [0.0, 0.0, 0.0]}
    yield "hard", "held at the mass centre about which it turns: nothing is lost", {"body": {**base, **own}}
    plate = {"record": "SquarePlate", "plate_mass": 1e-39, "side": 1e38, "spin": 1e-30}
    yield (
        "hard",
        "a plate of 1e-39 kg and 1e38 m: mass times the square of a side is finite only if taken in one order",
        {"body": {**plate, "seized": {"word": "edge"}}},
    )


def step(x: dict[str, Any]) -> dict[str, Any]:
    r, h, g = x["radius"], x["height"], x["gravity"]
    wheel, m = x["wheel"], x.get("mass")
    axle = wheel["inertia_factor"] * r * r if wheel["record"] == "Factor" else wheel["axle_inertia"] / m
    edge = axle + r * r
    # per unit mass: angular momentum about the edge of a wheel rolling at speed 1
    after_one = (axle / r + (r - h)) / edge
    ratio = after_one * r
    out = {
        "angular_ratio": ratio,
        "share_lost": 1 - ratio**2,
        "least_speed": sqrt(2 * g * h / edge) / after_one,
        "leaves_edge_speed": sqrt(g * (r - h)) / (r * after_one),
    }
    if "speed" not in x:
        return out
    v = x["speed"]
    spin = after_one * v
    energy = edge * spin**2 / 2 - g * h
    over = v >= out["least_speed"]
    side = sqrt(r * r - (r - h) ** 2)
    out |= {
        "angular_velocity": v / r,
        "angular_velocity_after": spin,
        "centre_speed_after": r * spin,
        "speed_on_step": r * sqrt(2 * energy / edge) if over else mpf(0),
        "greatest_rise": mpf(0) if over else edge * spin**2 / (2 * g),
    }
    if m is not None:
        out |= {
            "energy_lost": m * (axle + r * r) * (v / r) ** 2 / 2 - m * edge * spin**2 / 2,
            "impulse_forward": m * (spin * (r - h) - v),
            "impulse_upward": m * spin * side,
        }
    return out


def steps(generator: random.Random) -> Iterator[Case]:
    for number in range(12):
        r = draw(generator, 0.1, 0.5)
        own: dict[str, Any] = {
            "radius": r, "height": r * generator.uniform(0.1, 0.8), "gravity": G,
            "wheel": {"record": "Factor", "inertia_factor": draw(generator, 0.4, 1.0)},
        }  # fmt: skip
        if number % 3:
            own["speed"] = draw(generator, 0.5, 6.0)
        if number % 3 == 2:
            own |= {"mass": draw(generator, 1.0, 20.0), "wheel": {"record": "AxleInertia", "axle_inertia": 0.3}}
        yield "ordinary", "", own
    base: dict[str, Any] = {"radius": 0.3, "wheel": {"record": "Factor", "inertia_factor": 0.5}, "gravity": G}
    for h in (1e-12, 0.3 * (1.0 - 1e-14)):
        why = "a step that hardly is one, and one as high as the axle"
        yield "hard", why, {**base, "height": h, "speed": 2.0, "mass": 3.0}
    for v in (1.4701907, 1.47019071):
        why = "just below and just above the least speed: the speed on the step is a root of a difference"
        yield "hard", why, {**base, "height": 0.1, "speed": v}
    thin = {"wheel": {"record": "Factor", "inertia_factor": 1e-12}}
    yield "hard", "a wheel with all its mass at the axle: it stops dead at a step of its radius", {
        **base, **thin, "height": 0.29999999, "speed": 2.0, "mass": 1.0,
    }  # fmt: skip


def chain(x: dict[str, Any]) -> dict[str, Any]:
    bodies = x["bodies"]
    masses = [body["mass"] for body in bodies]
    start = [body.get("velocity", mpf(0)) for body in bodies]
    ratios = [body.get("restitution", x["restitution"]) for body in bodies[:-1]]
    return chained(masses, start, ratios, x["law"]["word"], mpf(10) ** -60)


def chains(generator: random.Random) -> Iterator[Case]:
    laws = ("sequential", "simultaneous")

    def row(*parts: tuple[float, float], e: float, law: str) -> dict[str, Any]:
        bodies = [{"mass": m, "velocity": v} for m, v in parts]
        return {"bodies": bodies, "restitution": e, "law": {"word": law}}

    for number in range(12):
        count = 2 + number % 4
        parts = [(draw(generator, 0.5, 3.0), draw(generator, -2.0, 2.0)) for _ in range(count)]
        parts[0] = (parts[0][0], 5.0)
        yield "ordinary", "", row(*parts, e=draw(generator, 0.5, 1.0), law=laws[number % 2])
    for law in laws:
        why = "Newton's cradle: rigid bodies do not decide, the laws differ"
        yield "hard", why, row((1.0, 1.0), (1.0, 0.0), (1.0, 0.0), e=1.0, law=law)
        why = "a heavy ball behind light ones: many collisions in turn"
        yield "hard", why, row((100.0, 1.0), (1.0, 0.0), (0.3, 0.0), e=1.0, law=law)
    why = "all contacts without rebound: the bodies leave as one"
    yield "hard", why, row((2.0, 3.0), (1.0, 0.0), (4.0, -1.0), e=0.0, law="simultaneous")
    why = "a ball between two that separate feels the impact of one side only"
    yield "hard", why, row((1.0, 2.0), (2.0, 0.0), (1.0, 5.0), e=0.5, law="simultaneous")
    why = "a mass of 1e12 between light ones: both velocities about it are differences that lose twelve digits"
    yield "hard", why, row((1.0, 2.0), (1e12, 0.0), (1.0, 0.0), e=0.5, law="simultaneous")


def closed(
    x: dict[str, Any], speeds: list[Any], headings: list[Any], masses: list[Any], along: list[Any] | None = None
) -> dict[str, Any]:
    """Everything else, from speeds and headings (first, second before; first, second after).

    Of vehicles that met on one line, the first's, `along` has the velocities along it in the same order.
    """
    axes = x["axes"]["word"]
    v = [tuple(s * part for part in direction(h, axes)) for s, h in zip(speeds, headings, strict=True)]
    out: dict[str, Any] = {}
    changes = [(v[i + 2][0] - v[i][0], v[i + 2][1] - v[i][1]) for i in (0, 1)]
    if along:
        changes = [tuple((along[i + 2] - along[i]) * part for part in direction(headings[0], axes)) for i in (0, 1)]
    for i, name in enumerate(("first", "second")):
        nose = math_angle(direction(x[name].get("nose", headings[i]), axes))
        zeros = {
            "heading": nose,
            "travel": math_angle(direction(headings[i], axes)),
            "scene": math_angle(direction(mpf(0), axes)),
        }
        own = {
            "approach_speed": speeds[i], "approach_heading": headings[i], "exit_speed": speeds[i + 2],
            "exit_heading": headings[i + 2],
            "energy_change": masses[i] * (speeds[i + 2] ** 2 - speeds[i] ** 2) / 2,
        } | delta_v(changes[i], nose, axes, zeros[x["pdof_zero"]["word"]])  # fmt: skip
        out |= {f"{name}.{key}": value for key, value in own.items()}
    impulse = masses[0] * changes[0][0], masses[0] * changes[0][1]
    size = sqrt(impulse[0] ** 2 + impulse[1] ** 2)
    way = impulse[0] / size, impulse[1] / size
    before = v[0][0] - v[1][0], v[0][1] - v[1][1]
    after = v[2][0] - v[3][0], v[2][1] - v[3][1]
    closing, parting = -(before[0] * way[0] + before[1] * way[1]), after[0] * way[0] + after[1] * way[1]
    if along:
        sense = 1 if along[0] > along[1] else -1
        closing, parting = sense * (along[0] - along[1]), sense * (along[3] - along[2])
    total = [masses[0] * v[2][k] + masses[1] * v[3][k] for k in (0, 1)]
    return out | {
        "impulse": size,
        "impulse_heading": heading_of(impulse[0], impulse[1], axes),
        "closing_speed": sqrt(before[0] ** 2 + before[1] ** 2),
        "closing_along_impulse": closing,
        "separation_along_impulse": parting,
        "restitution": parting / closing,
        "energy_lost": sum(m * (speeds[i] ** 2 - speeds[i + 2] ** 2) / 2 for i, m in enumerate(masses)),
        "total_momentum": sqrt(total[0] ** 2 + total[1] ** 2),
        "momentum_heading": heading_of(total[0], total[1], axes),
    }


def given(x: dict[str, Any]) -> tuple[list[Any], list[Any], list[Any]]:
    sides = [(x[name], part) for part in ("approach", "exit") for name in ("first", "second")]
    speeds = [one.get(f"{part}_speed") for one, part in sides]
    headings = [one.get(f"{part}_heading") for one, part in sides]
    masses = [mass_of(x[name]["bulk"], x["gravity"]) for name in ("first", "second")]
    return speeds, headings, masses


def momentum(x: dict[str, Any]) -> dict[str, Any]:
    found = solved(x)
    for side in ("first", "second"):
        blank = [f"{part}_speed" for part in ("approach", "exit") if f"{part}_speed" not in x[side]]
        if blank:
            worst, found[f"{side}.determined.per_degree"] = min(tolerance(x, side, name, found) for name in blank)
            found[f"{side}.determined.heading_tolerance"] = worst
    return found


def tolerance(x: dict[str, Any], side: str, name: str, found: dict[str, Any]) -> tuple[Any, Any]:
    """The error of a heading that changes a speed by a tenth, and the change by a degree, from whole solutions."""
    step, steepest = mpf(10) ** -60, mpf(0)
    for other in ("first", "second"):
        for turn in ("approach_heading", "exit_heading"):
            if turn in x[other]:
                ends = [
                    solved({**x, other: {**x[other], turn: x[other][turn] + off}})[f"{side}.{name}"]
                    for off in (step, -step)
                ]
                steepest = max(steepest, abs(ends[0] - ends[1]) / (2 * step))
    return min(found[f"{side}.{name}"] / steepest / 10, pi) if steepest else +pi, steepest * pi / 180


def solved(x: dict[str, Any]) -> dict[str, Any]:
    speeds, headings, masses = given(x)
    signs = [1, 1, -1, -1]
    weights = [s * m for s, m in zip(signs, masses * 2, strict=True)]
    blank = [i for i in range(4) if speeds[i] is None]
    turned = [i for i in range(4) if headings[i] is None]
    rest = [i for i in range(4) if i not in blank and i not in turned]
    held = [sum(weights[i] * speeds[i] * f(headings[i]) for i in rest) for f in (cos, sin)]
    out: dict[str, Any] = {}
    if len(blank) == 2:
        i, j = blank
        rows = [[weights[k] * f(headings[k]) for k in blank] for f in (cos, sin)]
        speeds[i], speeds[j] = mp.lu_solve(matrix(rows), matrix([-held[0], -held[1]]))
        apart = acos(cos(headings[j] - headings[i]))
        apart = min(apart, pi - apart)
        out["angle_condition"] = 1 / mp.tan(apart / 2)
    elif blank == turned:
        i = blank[0]
        speeds[i] = sqrt(held[0] ** 2 + held[1] ** 2) / masses[i % 2]
        headings[i] = atan2(-held[1] / weights[i], -held[0] / weights[i])
    else:
        i, j = blank[0], turned[0]
        # |held + w_i s d_i| = m_j v_j as a polynomial in s
        a = weights[i] * cos(headings[i]), weights[i] * sin(headings[i])
        wanted = (weights[j] * speeds[j]) ** 2
        quadratic = [a[0] ** 2 + a[1] ** 2, 2 * (a[0] * held[0] + a[1] * held[1]), held[0] ** 2 + held[1] ** 2 - wanted]
        roots = [root for root in polyroots(quadratic, maxsteps=800, extraprec=1200) if root >= 0]
        speeds[i] = min(roots) if x.get("branch", {}).get("word") == "smaller" else max(roots)
        left = held[0] + a[0] * speeds[i], held[1] + a[1] * speeds[i]
        headings[j] = atan2(-left[1] / weights[j], -left[0] / weights[j])
    return out | closed(x, speeds, headings, masses)


def momentum_and_energy(x: dict[str, Any]) -> dict[str, Any]:
    found = by_energy(x, mpf(1))
    step = mpf(10) ** -40
    for side in ("first", "second"):
        effects = []
        for other in ("first", "second"):
            speed = x[other]["exit_speed"]
            moved = [{**x, other: {**x[other], "exit_speed": speed * part}} for part in (1 + step, 1 - step)]
            effects.append([by_energy(one, mpf(1))[f"{side}.approach_speed"] for one in moved])
        effects.append([by_energy(x, part)[f"{side}.approach_speed"] for part in (1 + step, 1 - step)])
        steepest = max(abs(one - two) for one, two in effects) / (2 * step)
        scale = max(abs(found[f"{side}.approach_speed"]), found["closing_along_impulse"] / 4)
        found[f"{side}.determined.tolerance"] = min(scale / steepest / 10, mpf(1))
    return found


def by_energy(x: dict[str, Any], share: Any) -> dict[str, Any]:
    """The solution for a share of the energy of deformation."""
    speeds, headings, masses = given(x)
    line = headings[0]
    damage = x["damage"]
    if damage["record"] == "CrushEnergies":
        energy = damage["first_crush_energy"] + damage["second_crush_energy"]
    else:
        energy = (masses[0] * damage["first_ees"] ** 2 + masses[1] * damage["second_ees"] ** 2) / 2
    energy *= share
    u = [speeds[i] * cos(headings[i] - line) for i in (2, 3)]
    total = masses[0] * u[0] + masses[1] * u[1]
    kinetic = energy + (masses[0] * u[0] ** 2 + masses[1] * u[1] ** 2) / 2
    # m₁v² + (P − m₁v)²/m₂ = 2 T
    m1, m2 = masses
    roots = polyroots(
        [m1 + m1 * m1 / m2, -2 * m1 * total / m2, total**2 / m2 - 2 * kinetic], maxsteps=800, extraprec=1200
    )
    speeds[0] = max(roots)
    sense = 1 if cos(headings[1] - line) >= 0 else -1
    speeds[1] = sense * (total - m1 * speeds[0]) / m2
    found = closed(x, speeds, headings, masses, [speeds[0], sense * speeds[1], *u])
    return found | {"energy_lost": energy}


def momenta(generator: random.Random) -> Iterator[Case]:
    def crash(axes: str = "mathematical", apart: float = 1.5, ratio: float = 1.0) -> dict[str, Any]:
        """A crash that could happen: equal velocities after, a little apart."""
        heading = generator.uniform(-3.0, 3.0)
        m1, m2 = draw(generator, 800.0, 2500.0), ratio * draw(generator, 800.0, 2500.0)
        v1, v2 = generator.uniform(8.0, 25.0), generator.uniform(8.0, 25.0)
        common = [(m1 * v1 * float(f(heading)) + m2 * v2 * float(f(heading + apart))) / (m1 + m2) for f in (cos, sin)]
        size, way = float(sqrt(common[0] ** 2 + common[1] ** 2)), float(atan2(common[1], common[0]))
        bend = 0.04 if apart > 0 else -0.04
        # sliding by each other a little keeps the impulse a push
        first = {"bulk": mass(m1), "approach_heading": heading, "exit_speed": 0.98 * size, "exit_heading": way + bend}
        second = {"bulk": mass(m2), "approach_heading": heading + apart}
        second |= {"exit_speed": 1.02 * size, "exit_heading": way - bend}
        return {
            "first": first, "second": second, "axes": {"word": axes},
            "pdof_zero": {"word": "heading"}, "gravity": G,
        }  # fmt: skip

    for number in range(16):
        axes = ("mathematical", "compass", "sae", "iso")[number % 4]
        own = crash(axes, generator.choice([-1.0, 1.0]) * generator.uniform(0.8, 2.2))
        if number % 3 == 1:
            own["first"]["nose"] = own["first"]["approach_heading"] + 0.1
        if number % 4 == 2:
            own["first"]["bulk"] = weight(own["first"]["bulk"]["mass"] * G)
        if number % 4 == 3:
            own["pdof_zero"]["word"] = ("travel", "scene")[number % 2]
        yield "ordinary", "", own
    for number in range(4):
        own = crash()
        # the first vehicle is known before; the second is wanted whole, or its speed and the first's heading after
        speed = 12.0
        own["first"]["approach_speed"] = speed
        del own["second"]["approach_heading"]
        if number % 2:
            own["second"]["approach_heading"] = own["first"]["approach_heading"] + 1.4
            del own["first"]["exit_heading"]
        yield "ordinary", "", own
    for apart in (0.1668, 2.975, -0.1667):
        yield "hard", "approach paths nearly on one line: an angle condition just below 12", crash(apart=apart)
    for ratio in (1e6, 1e-6):
        yield (
            "hard",
            "vehicles a million times apart in mass: the light one's speed is what is left of the heavy one's momentum",
            crash(ratio=ratio),
        )
    own = crash(apart=1.5707963267948966)
    yield "hard", "paths exactly square to double precision: the condition is 1", own


def collinear(generator: random.Random) -> Iterator[Case]:
    def line(sense: float, bend: float = 0.0) -> dict[str, Any]:
        heading = generator.uniform(-2.0, 2.0)
        u = draw(generator, 4.0, 9.0)
        first = {"bulk": mass(draw(generator, 800.0, 2000.0)), "approach_heading": heading, "exit_speed": u,
                 "exit_heading": heading}  # fmt: skip
        second = {"bulk": mass(draw(generator, 800.0, 2000.0)), "approach_heading": heading + sense + bend,
                  "exit_speed": u + draw(generator, 0.0, 1.0), "exit_heading": heading}  # fmt: skip
        return {
            "first": first, "second": second, "axes": {"word": "mathematical"},
            "pdof_zero": {"word": "heading"}, "gravity": G,
        }  # fmt: skip

    for number in range(8):
        if number % 2:
            damage = {"record": "CrushEnergies", "first_crush_energy": draw(generator, 2e3, 2e4),
                      "second_crush_energy": draw(generator, 2e3, 2e4)}  # fmt: skip
            yield "ordinary", "", {**line(0.0), "damage": damage}
        else:
            damage = {"record": "EquivalentSpeeds", "first_ees": draw(generator, 14.0, 18.0), "second_ees": 12.0}
            yield "ordinary", "", {**line(3.141592653589793), "damage": damage}
    small = {"record": "CrushEnergies", "first_crush_energy": 1e-9, "second_crush_energy": 0.0}
    own = line(0.0)
    yield "hard", "hardly any damage: the closing speed is that of separation", {**own, "damage": small}
    damage = {"record": "CrushEnergies", "first_crush_energy": 2e4, "second_crush_energy": 9e3}
    for heavier in ("first", "second"):
        own = {**line(0.0, 0.08), "damage": damage}
        own[heavier]["bulk"] = mass(9000.0)
        why = f"paths five degrees from one line, the {heavier} heavy: what is neglected is so for both vehicles alike"
        yield "hard", why, own


# The double that stands for half a turn.
HALF_TURN = mpf(3.141592653589793)


def crush(x: dict[str, Any]) -> dict[str, Any]:
    gravity, e = x["gravity"], x["restitution"]
    out, found = {}, []
    for name in ("first", "second"):
        one = x.get(name)
        if one is None:
            continue
        m = mass_of(one["bulk"], gravity)
        if one.get("profile") is None:
            found.append((m, None, m, None))
            continue
        stiff, profile = one["stiffness"], one["profile"]
        if stiff["record"] == "Coefficients":
            a, b = stiff["stiffness_a"], stiff["stiffness_b"]
        else:
            b0 = stiff["no_damage_speed"]
            b1 = stiff.get("speed_slope") or (stiff["test_speed"] - b0) / stiff["test_crush"]
            a, b = (stiff["test_mass"] / stiff["test_width"] * part for part in (b0 * b1, b1 * b1))
        depths = profile.get("stations") or [profile["mean_crush"]] * 2
        width, pieces = profile["width"], len(depths) - 1
        # ½ m_w (b₀ + b₁C)² per width is the work (A + BC)²/(2B), integrated piece by piece along the width
        normal = mean = lever = mpf(0)
        for i in range(pieces):
            left, rise, wide = depths[i], depths[i + 1] - depths[i], width / pieces
            terms = [(a + b * left) ** 2, 2 * (a + b * left) * b * rise, (b * rise) ** 2]
            normal += wide * sum(term / (k + 1) for k, term in enumerate(terms)) / (2 * b)
            mean += (left + rise / 2) / pieces
            lever += wide * ((i * left + (i * rise + left) / 2 + rise / 3) * wide)
        # the work is a quadratic of a change of all depths: two differences give its slope
        works = [
            sum((a + b * (part + shift)) ** 2 + (b * rise) * (a + b * (part + shift)) + (b * rise) ** 2 / 3
                for part, rise in ((depths[i], depths[i + 1] - depths[i]) for i in range(pieces)))
            * width / pieces / (2 * b)
            for shift in (mpf(1), mpf(-1))
        ]  # fmt: skip
        angle = one["force_angle"]
        energy = normal * (1 + mp.tan(angle) ** 2)
        arm = one.get("lever_arm")
        if arm is None and one.get("offset") is not None:
            # moment of a unit force at the damage, (x, D) against −(cos α, sin α)
            place, force = (one.get("face_distance", mpf(0)), one["offset"]), (-cos(angle), -sin(angle))
            arm = place[0] * force[1] - place[1] * force[0]
        effective = m if arm is None else 1 / (1 / m + arm**2 / one["yaw_inertia"])
        own = {
            "energy": energy, "energy_normal": normal, "equivalent_barrier_speed": sqrt(2 * energy / m),
            "force": width * (a + b * mean), "stiffness_a": a, "stiffness_b": b, "stiffness_g": a * a / (2 * b),
            "mean_crush": mean, "mass": m, "effective_mass": effective, "effective_share": effective / m,
        }  # fmt: skip
        own["determined.depth_tolerance"] = normal / (works[0] - works[1]) * 2 / 5
        leaning = abs(mp.diff(lambda turn: -mp.log(cos(turn)), angle)) if angle else mpf(0)
        own["determined.angle_tolerance"] = min(1 / leaning / 10, HALF_TURN) if leaning else HALF_TURN
        if "stations" in profile:
            own["crush_centre"] = lever / (mean * width)
        out |= {f"{name}.{key}": value for key, value in own.items()}
        found.append((m, energy, effective, name))
    total = sum(part[1] for part in found if part[1] is not None)
    out["energy"] = total
    if len(found) == 2:
        reduced = found[0][2] if found[1][2] is None else 1 / (1 / found[0][2] + 1 / found[1][2])
        closing = sqrt(2 * total / (reduced * (1 - e * e)))
        impulse = (1 + e) * reduced * closing
        out |= {"impulse": impulse, "closing_speed": closing, "first.delta_v": impulse / found[0][0]}
        out["restitution_tolerance"] = (1 - e * e) / 10
        if found[1][3] is not None:
            out["second.delta_v"] = impulse / found[1][0]
        elif found[1][0] is not None:
            out["second_delta_v"] = impulse / found[1][0]
    return out


def crushes(generator: random.Random) -> Iterator[Case]:
    def vehicle(number: int) -> dict[str, Any]:
        stiffness: dict[str, Any] = {"record": "Coefficients", "stiffness_a": draw(generator, 2e4, 8e4)}
        stiffness["stiffness_b"] = draw(generator, 2e5, 8e5)
        test = {"no_damage_speed": 2.2, "test_mass": draw(generator, 900.0, 2000.0), "test_width": 1.6}
        if number % 3 == 1:
            stiffness = {"record": "Campbell", "speed_slope": draw(generator, 20.0, 40.0), **test}
        if number % 3 == 2:
            stiffness = {"record": "BarrierTest", "test_speed": 15.6, "test_crush": draw(generator, 0.3, 0.6), **test}
        profile: dict[str, Any] = {"record": "MeanCrush", "mean_crush": draw(generator, 0.1, 0.5), "width": 1.5}
        if number % 4:
            stations = [draw(generator, 0.0, 0.6) for _ in range(1 + number % 6 or 2)] + [0.2]
            profile = {"record": "Stations", "stations": stations, "width": draw(generator, 0.8, 1.7)}
        return {"bulk": mass(draw(generator, 900.0, 2200.0)), "stiffness": stiffness, "profile": profile,
                "force_angle": draw(generator, -0.6, 0.6)}  # fmt: skip

    for number in range(14):
        own: dict[str, Any] = {"first": vehicle(number), "restitution": draw(generator, 0.0, 0.3), "gravity": G}
        if number % 3 == 1:
            own["second"] = vehicle(number + 5)
            own["second"] |= {"lever_arm": draw(generator, 0.1, 0.9), "yaw_inertia": draw(generator, 1500.0, 3000.0)}
        if number % 6 == 2:
            own["second"] = {"bulk": FIXED, "force_angle": 0.0}
        if number % 6 == 5:
            own["second"] = {"bulk": mass(1400.0), "force_angle": 0.0}
        if number % 4 == 3:
            own["first"] |= {"offset": 0.5, "face_distance": 1.9, "yaw_inertia": draw(generator, 1500.0, 3000.0)}
        yield "ordinary", "", own
    base = {
        "bulk": mass(1500.0), "force_angle": 0.0,
        "stiffness": {"record": "Coefficients", "stiffness_a": 5e4, "stiffness_b": 5e5},
        "profile": {"record": "Stations", "stations": [0.1, 0.3, 0.2], "width": 1.5},
    }  # fmt: skip

    def single(**change: Any) -> dict[str, Any]:
        return {"first": {**base, **change}, "restitution": 0.0, "gravity": G}

    yield "hard", "force at 45 degrees: the correction doubles the energy", single(force_angle=0.7853981633974483)
    tiny = {"record": "Coefficients", "stiffness_a": 5e4, "stiffness_b": 1e-9}
    yield "hard", "hardly any B: G = A²/(2B) outgrows all crush, and cancels from it", single(stiffness=tiny)
    none = {"record": "Coefficients", "stiffness_a": 0.0, "stiffness_b": 5e5}
    yield (
        "hard",
        "no A: all energy is of the depth's square, G is zero and its quotient by A zero over zero",
        single(stiffness=none),
    )
    sharp = {"record": "Stations", "stations": [0.0, 0.0, 0.0, 0.0, 0.0, 1e-9], "width": 1.5}
    yield (
        "hard",
        "a scratch at the last of six stations: all other depths are exact zeros, area and centroid are that one's",
        single(profile=sharp),
    )
    elastic = {**single(), "second": {"bulk": FIXED, "force_angle": 0.0}, "restitution": 0.9999999}
    yield "hard", "nearly elastic: (1 + e)/(1 − e) multiplies whatever rounding 1 − e has", elastic
    lever = {"offset": 0.8, "face_distance": 2.0, "force_angle": 0.38050637711236485, "yaw_inertia": 2500.0}
    yield "hard", "the force passes the mass centre: the lever arm is a difference", single(**lever)
    barrier = {"record": "BarrierTest", "test_speed": 15.6, "test_crush": 0.4, "no_damage_speed": 15.599999999,
               "test_mass": 1500.0, "test_width": 1.6}  # fmt: skip
    yield (
        "hard",
        "a test hardly faster than the speed without damage: stiffness is a difference of speeds over the crush",
        single(stiffness=barrier),
    )


def yaw_inertia(x: dict[str, Any]) -> dict[str, Any]:
    m, base, rule = mass_of(x["bulk"], x["gravity"]), x["wheelbase"], x["rule"]["word"]
    front = x.get("front_distance", base / 2)
    rules = {}
    if "length" in x:
        rules["burg"] = mpf(0.1269) * m * x["length"] * base
    rules["dynamic-index"] = m * front * (base - front)
    if "length" in x and "width" in x:
        rules["rectangle"] = m * (x["length"] ** 2 + x["width"] ** 2) / 12
    found = list(rules.values())
    best = sum(found) / len(found) if rule == "mean" else rules[rule]
    out = {f"rules[{i}].yaw_inertia": value for i, value in enumerate(found)}
    index = [mpf(0.7) * rules["dynamic-index"], mpf(1.1) * rules["dynamic-index"]]
    return out | {
        "yaw_inertia": best,
        "lowest": min([*found, *index]),
        "highest": max([*found, *index]),
        "radius_of_gyration": sqrt(best / m),
        "mass": m,
    }


def yaw_inertias(generator: random.Random) -> Iterator[Case]:
    for number in range(8):
        own: dict[str, Any] = {"bulk": mass(draw(generator, 900.0, 2500.0)), "wheelbase": draw(generator, 2.3, 3.0)}
        if number % 3:
            own["length"] = draw(generator, 3.8, 5.0)
        if number % 3 == 2:
            own["width"] = draw(generator, 1.6, 2.0)
        if number % 4 == 1:
            own["front_distance"] = draw(generator, 1.0, 1.4)
        name = ("mean", "dynamic-index")[number % 2]
        yield "ordinary", "", {**own, "rule": {"word": name}, "gravity": G}


# What the record of a part is called that is of one kind only.
PARTS = {
    "central": {"first": "Collinear", "second": "Struck"},
    "oblique": {"first": "Moving", "second": "Met"},
    "pendulum": {"block": "Block"},
    "momentum": {"first": "Vehicle", "second": "Vehicle"},
    "momentum_and_energy": {"first": "Vehicle", "second": "Vehicle"},
    "approach": {"first": "Vehicle", "second": "Vehicle"},
    "crush": {"first": "Damaged", "second": "Opponent"},
}
ALL = (
    ("central", centrals, central), ("oblique", obliques, oblique), ("drop", drops, drop),
    ("pendulum", pendulums, pendulum), ("seize", seizes, seize), ("step", steps, step), ("chain", chains, chain),
    ("momentum", momenta, momentum), ("momentum_and_energy", collinear, momentum_and_energy),
    ("crush", crushes, crush), ("yaw_inertia", yaw_inertias, yaw_inertia), ("approach", approaches, approach),
)  # fmt: skip


def recorded(task: str, tree: dict[str, Any]) -> dict[str, Any]:
    """Inputs as they are written, each part with the name of its record."""
    parts = PARTS.get(task, {})
    return {name: {"record": parts[name], **part} if name in parts else part for name, part in written(tree).items()}


def cases() -> Iterator[dict[str, Any]]:
    for task, inputs, answer in ALL:
        generator = random.Random(f"impact {task}")
        found = [("hard", f"found by search: {why}", own) for why, own in FOUND.get(task, ())]
        for number, (kind, why, own) in enumerate([*inputs(generator), *found]):
            # what is left of exact zeros after 300 digits
            exactly = {
                name: mpf(0) if abs(value) < mpf(10) ** -250 else value for name, value in answer(exact(own)).items()
            }
            case = {"task": task, "kind": kind, "name": f"{task} {number}", **({"why": why} if why else {})}
            results = {name: mp.nstr(value, 40, min_fixed=0, max_fixed=0) for name, value in exactly.items()}
            yield {**case, "inputs": recorded(task, own), "results": results}


def main() -> None:
    """Write the file."""
    about = "Written by generate_impact_particles_references.py: SI inputs as doubles, results to 40 digits from 300."
    put("impact_particles", about, cases())


if __name__ == "__main__":
    main()
