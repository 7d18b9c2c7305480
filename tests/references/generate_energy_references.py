"""Writes energy.json: work, momentum, speeds, drops, rolling, power and impulses to 40 digits.

Speeds and compressions come from roots of polynomials, works of springs from integrals, energies beside the mass
centre from pairs of bodies; the program has conjugate forms and sums of squares.
Run: python tests/references/generate_energy_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator
from itertools import combinations
from typing import Any

from case_files import write_given
from mpmath import atan, cos, mp, mpf, polyroots, quad, re, sin, sqrt, tan

mp.dps = 90
ABOUT = "Written by generate_energy_references.py: SI inputs as doubles, results to 40 digits from 90-digit arithmetic."
Case = tuple[str, str, str, str, dict[str, Any], dict[str, Any]]
RANDOM = random.Random(1686)
GRAVITY = mpf(9.80665)


def exact(text: str) -> Any:
    return mpf(float(text))


def drawn(low: float, high: float, digits: int = 3) -> str:
    return repr(round(RANDOM.uniform(low, high), digits))


def positive_root(*coefficients: Any) -> Any:
    roots = polyroots(list(coefficients), maxsteps=900, extraprec=900)
    return max(re(root) for root in roots if abs(root.imag) < mpf(10) ** -60)


def works() -> Iterator[Case]:
    hard = [
        ("2000.0", "0.0", "1e-07", "hardly stretched: the energy is a difference of squares"),
        ("2000.0", "0.3", "-0.3", "from a stretch to the same compression: what it takes it gives back"),
        ("50.0", "0.1", "0.10000000000001", "a change of stretch near its last bits on top of a large stretch"),
    ]
    for nth, (rate, start, end, why) in enumerate(
        [*hard, *((drawn(10, 9000), drawn(-0.3, 0.3), drawn(-0.3, 0.3), "") for _ in range(4))]
    ):
        k = exact(rate)
        value = quad(lambda stretch, k=k: -k * stretch, [exact(start), exact(end)])
        spring = {"record": "Spring", "stiffness": rate, "start_stretch": start, "end_stretch": end}
        yield "work", "hard" if why else "ordinary", f"spring {nth}", why, {"spring": spring}, {"spring": value}
    for nth in range(4):
        inputs = {
            "distance": drawn(1, 9), "force": drawn(10, 500), "angle": drawn(0.1, 1.3), "friction": drawn(0.1, 0.9),
            "normal_force": drawn(10, 300), "torque": drawn(1, 50), "turn": drawn(0.1, 6), "mass": drawn(1, 90),
            "rise": drawn(-3, -0.1),
        }  # fmt: skip
        s, f, a, mu, n, m, turn, mass, rise = (exact(text) for text in inputs.values())
        results = {"constant": s * (f * cos(a)), "rubbing": -s * mu * n, "couple": m * turn,
                   "weight": -GRAVITY * mass * rise}  # fmt: skip
        yield "work", "ordinary", f"forces {nth}", "", inputs, results | {"total": sum(results.values())}


def bodies() -> Iterator[Case]:
    for nth in range(6):
        drift = "100000.0" if nth == 0 else "0.0"
        given = [
            {
                "record": "Body", "mass": drawn(1, 9),
                "velocity": [repr(float(drift) + float(drawn(-5, 5))), drawn(-5, 5), drawn(-2, 2)],
                "at": [drawn(-3, 3), drawn(-3, 3), drawn(-1, 1)], "inertia": drawn(0.1, 2), "rotation": drawn(-9, 9),
            }
            for _ in range(2 + nth % 2)
        ]  # fmt: skip
        masses = [exact(one["mass"]) for one in given]
        turning = sum(exact(one["inertia"]) * exact(one["rotation"]) ** 2 / 2 for one in given)
        apart = mpf(0)
        for (mass, one), (other_mass, other) in combinations(zip(masses, given, strict=True), 2):
            way = [exact(a) - exact(b) for a, b in zip(one["velocity"], other["velocity"], strict=True)]
            apart += mass * other_mass * sum(part * part for part in way)
        energy = sum(
            mass * sum(exact(part) ** 2 for part in one["velocity"]) / 2
            for mass, one in zip(masses, given, strict=True)
        )
        spun = sum(
            mass * (exact(one["at"][0]) * exact(one["velocity"][1]) - exact(one["at"][1]) * exact(one["velocity"][0]))
            + exact(one["inertia"]) * exact(one["rotation"])
            for mass, one in zip(masses, given, strict=True)
        )
        why = "all fly along together: energy beside the mass centre is a small part of the whole" if nth == 0 else ""
        yield (
            "body", "hard" if why else "ordinary", f"bodies {nth}", why, {"bodies": given},
            {
                "energy": energy + turning, "rotation": turning, "inner_energy": apart / sum(masses) / 2 + turning,
                "angular_momentum[2]": spun,
                "centre_velocity[1]": sum(m * exact(b["velocity"][1]) for m, b in zip(masses, given, strict=True))
                / sum(masses),
            },
        )  # fmt: skip


def speeds() -> Iterator[Case]:
    hard = [
        ("1500.0", "33.3", "1e-06", "hardly any work: the change of speed is a difference of equal numbers"),
        ("1500.0", "33.3", "-831667.4", "stopped but for a crawl: what is left of the energy is a difference"),
    ]
    for nth, (mass_text, speed_text, work_text, why) in enumerate(
        [*hard, *((drawn(1, 2000), drawn(1, 40), drawn(1, 9000), "") for _ in range(4))]
    ):
        m, v, w = exact(mass_text), exact(speed_text), exact(work_text)
        end = sqrt(v * v + 2 * w / m)
        inputs = {"mass": mass_text, "start_speed": speed_text, "work": work_text}
        results = {"end_speed": end, "change": end - v, "end_energy": m * v * v / 2 + w}
        yield "speed", "hard" if why else "ordinary", f"work {nth}", why, inputs, results
    for nth in range(4):
        inputs = {
            "mass": drawn(1, 90), "start_speed": drawn(1, 9), "force": drawn(1, 90), "distance": drawn(1, 9),
            "drop": drawn(0.1, 4), "rolling": {"record": "Rolling", "inertia": drawn(0.1, 3), "radius": drawn(0.1, 1)},
        }  # fmt: skip
        m, v, f, s, h = (exact(text) for text in list(inputs.values())[:5])
        rolling: Any = inputs["rolling"]
        turned = exact(rolling["inertia"]) / exact(rolling["radius"]) ** 2
        end = positive_root((m + turned) / 2, 0, -((m + turned) * v * v / 2 + f * s + m * GRAVITY * h))
        yield "speed", "ordinary", f"rolling {nth}", "", inputs, {"end_speed": end, "effective_mass": m + turned}
    for nth in range(3):
        inputs = {"mass": drawn(1, 90), "start_speed": drawn(5, 9), "end_speed": drawn(1, 4), "force": drawn(-90, -1)}
        m, v, end, f = (exact(text) for text in inputs.values())
        yield "speed", "ordinary", f"braked {nth}", "", inputs, {"distance": m * (end**2 - v**2) / 2 / f}


def drops() -> Iterator[Case]:
    hard = [
        ("2.0", "1e-09", "5000.0", "let go on the spring: the fall is nothing beside the compression"),
        ("0.001", "90.0", "1e6", "stopped within a hair: the weight is nothing beside the force"),
    ]
    for nth, (mass_text, height_text, rate_text, why) in enumerate(
        [*hard, *((drawn(1, 90), drawn(0.01, 3), drawn(900, 90000), "") for _ in range(4))]
    ):
        m, h, k = exact(mass_text), exact(height_text), exact(rate_text)
        travel = positive_root(k / 2, -m * GRAVITY, -m * GRAVITY * h)
        yield (
            "drop", "hard" if why else "ordinary", f"fall {nth}", why,
            {
                "mass": mass_text, "arrival": {"record": "Falling", "height": height_text},
                "spring": {"record": "Known", "stiffness": rate_text},
            },
            {
                "compression": travel, "force": k * travel, "deceleration": k * travel / m - GRAVITY,
                "top_speed": sqrt(2 * GRAVITY * h + GRAVITY**2 * m / k), "energy": m * GRAVITY * (h + travel),
            },
        )  # fmt: skip
    for nth in range(3):
        mass_text, height_text, stroke_text = drawn(1, 90), drawn(0.1, 2), drawn(0.01, 0.2)
        m, h, x = exact(mass_text), exact(height_text), exact(stroke_text)
        yield (
            "drop", "ordinary", f"stroke {nth}", "",
            {
                "mass": mass_text, "arrival": {"record": "Falling", "height": height_text},
                "spring": {"record": "Stroke", "stroke": stroke_text},
            },
            {"stiffness": 2 * m * GRAVITY * (h + x) / x**2, "rest": x * x / 2 / (h + x)},
        )  # fmt: skip
        yield (
            "drop", "ordinary", f"buffer {nth}", "",
            {
                "mass": mass_text, "arrival": {"record": "Running", "speed": height_text},
                "spring": {"record": "Stroke", "stroke": stroke_text},
            },
            {"stiffness": m * h * h / x**2, "deceleration": h * h / x},
        )  # fmt: skip


def rolls() -> Iterator[Case]:
    for nth in range(8):
        hard = nth == 0
        ratio, angle, way = drawn(0.2, 1), "1e-07" if hard else drawn(0.1, 1.2), drawn(1, 20)
        friction = drawn(0.02, 0.3)
        k, a, s, mu = exact(ratio), exact(angle), exact(way), exact(friction)
        inputs = {"body": {"record": "Inertial", "inertia_ratio": ratio}, "angle": angle, "friction": friction,
                  "distance": way}  # fmt: skip
        needed = k * tan(a) / (1 + k)
        centre = GRAVITY * sin(a) / (1 + k)
        rim = centre
        if mu < needed:
            centre, rim = GRAVITY * (sin(a) - mu * cos(a)), mu * GRAVITY * cos(a) / k
        time = sqrt(2 * s / centre)
        kept = ((centre * time) ** 2 + k * (rim * time) ** 2) / 2
        results = {
            "acceleration": centre, "needed_friction": needed, "time": time, "speed": centre * time,
            "rim_speed": rim * time, "turning_share": k * (rim * time) ** 2 / 2 / kept,
        }  # fmt: skip
        if mu < needed:
            results["lost_share"] = 1 - kept / (GRAVITY * s * sin(a))
        why = "all but level: sine and tangent of the slope are its first digits" if hard else ""
        yield "roll", "hard" if hard else "ordinary", f"slope {nth}", why, inputs, results


def powers() -> Iterator[Case]:
    for nth in range(3):
        torque, rotation = drawn(1, 300), drawn(10, 600)
        share = drawn(0.5, 0.99)
        value = exact(torque) * exact(rotation)
        yield (
            "power", "ordinary", f"shaft {nth}", "",
            {"load": {"record": "Turning", "torque": torque, "rotation": rotation}, "efficiency": share},
            {"power": value, "input_power": value / exact(share), "loss": value * (1 / exact(share) - 1)},
        )  # fmt: skip
    hard = [
        ("0.05", "0.012", "0.7", "60000.0", ""),
        ("-0.2", "0.012", "0.7", "100.0", "rolls downhill almost by itself: the root is that of another sign"),
        ("0.0", "0.0", "0.7", "60000.0", "drag alone: the root of a cube"),
        ("0.0", "0.012", "1e-12", "3000.0", "hardly any drag: the cubic is all but linear"),
        ("-0.012", "0.012", "0.6", "40000.0", "the slope carries nearly all of the rolling resistance"),
    ]
    for nth, (slope, rolling, area, power, why) in enumerate(hard):
        inputs = {
            "mass": "1500.0", "at": {"record": "WithPower", "power": power}, "slope": slope,
            "rolling_resistance": rolling, "drag_area": area, "density": "1.2", "efficiency": "0.9",
        }  # fmt: skip
        angle = atan(exact(slope))
        constant = 1500 * GRAVITY * (exact(rolling) * cos(angle) + sin(angle))
        square = exact("1.2") * exact(area) / 2
        speed = positive_root(square, 0, constant, -exact(power) * exact("0.9"))
        yield (
            "drive", "hard" if why else "ordinary", f"top {nth}", why, inputs,
            {"speed": speed, "drag": square * speed**2, "force": exact(power) * exact("0.9") / speed},
        )  # fmt: skip
    for nth in range(4):
        inputs = {
            "mass": drawn(800, 3000), "at": {"record": "AtSpeed", "speed": drawn(5, 40)}, "slope": drawn(0.0, 0.1),
            "rolling_resistance": drawn(0.008, 0.02), "drag_area": drawn(0.5, 1.0), "density": "1.2",
            "acceleration": drawn(0.0, 1.0), "efficiency": drawn(0.8, 0.99),
        }  # fmt: skip
        at: Any = inputs["at"]
        m, slope_, c, area_, rho, a, eta = (exact(text) for key, text in inputs.items() if key != "at")  # type: ignore[arg-type]
        v, angle = exact(at["speed"]), atan(slope_)
        force = m * (GRAVITY * (c * cos(angle) + sin(angle)) + a) + rho * area_ * v * v / 2
        yield "drive", "ordinary", f"power {nth}", "", inputs, {"force": force, "power": force * v / eta}


def impulses() -> Iterator[Case]:
    for nth in range(4):
        times = sorted({drawn(0, 0.02, 5) for _ in range(5)}, key=float)
        forces = [drawn(-200, 2000) for _ in times]
        mass, speed = drawn(0.1, 90), drawn(-40, 10)
        momentum = mpf(0)
        for k in range(len(times) - 1):
            t0, t1, f0, f1 = (exact(text) for text in (times[k], times[k + 1], forces[k], forces[k + 1]))
            momentum += quad(lambda t, a=t0, b=t1, p=f0, q=f1: p + (q - p) * (t - a) / (b - a), [t0, t1])
        end = exact(speed) + momentum / exact(mass)
        yield (
            "impulse", "ordinary", f"record {nth}", "",
            {"cause": {"record": "Measured", "times": times, "forces": forces}, "mass": mass, "start_speed": speed},
            {
                "impulse": momentum, "end_speed": end, "mean_force": momentum / (exact(times[-1]) - exact(times[0])),
                "work": exact(mass) * (end**2 - exact(speed) ** 2) / 2,
            },
        )  # fmt: skip
    for nth in range(2):
        mass, before, after, time = drawn(1, 90), drawn(1, 9), drawn(-9, 0), drawn(0.01, 0.2)
        momentum = exact(mass) * (exact(after) - exact(before))
        yield (
            "impulse", "ordinary", f"stop {nth}", "",
            {
                "cause": {"record": "Stopped", "end_speed": after, "duration": time}, "mass": mass,
                "start_speed": before,
            },
            {"impulse": momentum, "mean_force": momentum / exact(time)},
        )  # fmt: skip
    hard = [
        ("5.0", "4.9999999999", "2.0", "hardly drawn in: the work is the difference of equal energies"),
        ("5.0", "1e-06", "2.0", "drawn in to all but nothing: speed and work grow without limit"),
    ]
    for nth, (first, last, rate, why) in enumerate(
        [*hard, *((drawn(1, 9), drawn(0.2, 5), drawn(1, 9), "") for _ in "abc")]
    ):
        i1, i2, w = exact(first), exact(last), exact(rate)
        end = i1 * w / i2
        yield (
            "draw_in", "hard" if why else "ordinary", f"inertia {nth}", why,
            {"inertia": first, "end_inertia": last, "rotation": rate},
            {"end_rotation": end, "work": (i2 * end**2 - i1 * w**2) / 2, "angular_momentum": i1 * w},
        )  # fmt: skip


def every() -> Iterator[Case]:
    for part in (works, bodies, speeds, drops, rolls, powers, impulses):
        yield from part()


if __name__ == "__main__":
    write_given("energy", ABOUT, every())
