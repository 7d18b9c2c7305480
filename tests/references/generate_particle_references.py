"""Writes particle.json: flights, falls, tubes, inclines and bends to 40 digits, for ordinary and hard inputs.

Flights without drag and targets come from roots of polynomials, tubes from exponentials of their matrix, inclines and
bends from force polygons; the program has conjugate forms, half angles and series.
Run: python tests/references/generate_particle_references.py [FILE]. The same bytes every time.
"""

import random
from collections.abc import Iterator
from typing import Any

from case_files import write_given
from mpmath import acosh, atan, cos, exp, matrix, mp, mpf, polyroots, re, sin, sqrt, tan

mp.dps = 90
ABOUT = (
    "Written by generate_particle_references.py: SI inputs as doubles, results to 40 digits from 90-digit arithmetic."
)
Case = tuple[str, str, str, str, dict[str, Any], dict[str, Any]]
RANDOM = random.Random(1638)
GRAVITY = mpf(9.80665)


def exact(text: str) -> Any:
    return mpf(float(text))


def drawn(low: float, high: float, digits: int = 3) -> str:
    return repr(round(RANDOM.uniform(low, high), digits))


def flights() -> Iterator[Case]:
    hard = [
        ("1000.0", "-0.7", "1e-06", "launched downwards over a small drop: the root is a difference"),
        ("30.0", "1.5707", "2.0", "all but straight up: the range is the sine of a small angle"),
    ]
    ordinary = [(drawn(5, 60), drawn(0.1, 1.4), drawn(0, 9), "") for _ in range(6)]
    for nth, (speed_text, angle_text, height_text, why) in enumerate([*hard, *ordinary]):
        v, angle, h = exact(speed_text), exact(angle_text), exact(height_text)
        up, across = v * sin(angle), v * cos(angle)
        time = max(re(root) for root in polyroots([-GRAVITY / 2, up, h], maxsteps=500, extraprec=500))
        inputs = {"speed": speed_text, "aim": {"record": "Elevation", "elevation": angle_text}, "height": height_text}
        end = up - GRAVITY * time
        results = {
            "time": time, "range": across * time, "impact_speed": sqrt(across**2 + end**2),
            "impact_angle": atan(-end / across), "greatest_range": v * sqrt(v * v + 2 * GRAVITY * h) / GRAVITY,
            "best_elevation": atan(v / sqrt(v * v + 2 * GRAVITY * h)),
        }  # fmt: skip
        yield "projectile", "hard" if why else "ordinary", f"flight {nth}", why, inputs, results
    targets = [
        ("100000.0", "1.0", "0.0", "the flatter angle is a difference that loses every digit"),
        ("30.0", "80.0", "5.0", ""),
        ("40.0", "60.0", "-20.0", ""),
        ("25.0", "1.0", "25.0", "a target all but overhead: an angle near 90 degrees has lost the slope"),
    ]
    for nth, (speed_text, x_text, y_text, why) in enumerate(targets):
        v, x, y = exact(speed_text), exact(x_text), exact(y_text)
        bend = GRAVITY * x * x / (2 * v * v)
        slopes = sorted(re(root) for root in polyroots([bend, -x, bend + y], maxsteps=900, extraprec=900))
        yield (
            "projectile", "hard" if why else "ordinary", f"target {nth}", why,
            {"speed": speed_text, "aim": {"record": "Target", "target": [x_text, y_text]}},
            {
                "elevation": atan(slopes[0]), "other_elevation": atan(slopes[1]),
                "time": x * sqrt(1 + slopes[0] ** 2) / v,
                "least_speed": sqrt(GRAVITY * (y + sqrt(x * x + y * y))),
            },
        )  # fmt: skip


def falls() -> Iterator[Case]:
    hard = [
        ("1e-06", "60.0", "drag has hardly begun: time and speed are those of a free fall but for their last digits"),
        ("5000.0", "20.0", "all but steady: the speed differs from its limit by less than a last bit"),
    ]
    for nth, (height_text, terminal_text, why) in enumerate(
        [*hard, *((drawn(1, 900), drawn(20, 90), "") for _ in range(5))]
    ):
        h, v = exact(height_text), exact(terminal_text)
        depth = GRAVITY * h / v**2
        yield (
            "fall", "hard" if why else "ordinary", f"fall {nth}", why,
            {"height": height_text, "terminal_speed": terminal_text},
            {
                "speed": v * sqrt(1 - exp(-2 * depth)), "time": v / GRAVITY * acosh(exp(depth)),
                "vacuum_time": sqrt(2 * h / GRAVITY),
            },
        )  # fmt: skip


def tubes() -> Iterator[Case]:
    hard = [
        (
            "0.0001",
            "0.1",
            "1.0",
            "vertical",
            None,
            "gravity's part is a difference of sines that cancels to the third order",
        ),
        ("10.0", "0.3", "0.4", "vertical", "40.0000004", "a spring all but in resonance with the turning"),
        ("10.0", "0.3", "0.4", "horizontal", "20.0000002", "spring and turning all but cancel"),
    ]
    ordinary = [
        (drawn(1, 9), drawn(0.1, 0.9), drawn(0.1, 1), plane, spring, "")
        for plane in ("horizontal", "vertical")
        for spring in (None, drawn(1, 9), drawn(30, 90))
    ]
    for nth, (rotation_text, start_text, time_text, plane, spring, why) in enumerate([*hard, *ordinary]):
        turning, start, time = exact(rotation_text), exact(start_text), exact(time_text)
        mass, free = mpf(float("0.2")), mpf(float("0.25"))
        pull = exact(spring) / mass if spring else mpf(0)
        weight = GRAVITY if plane == "vertical" else mpf(0)
        # position, speed, sine and cosine of the turn, and one
        rows = matrix(5, 5)
        rows[0, 1] = 1
        rows[1, 0], rows[1, 2], rows[1, 4] = turning**2 - pull, -weight, pull * free
        rows[2, 3], rows[3, 2] = turning, -turning
        end = mp.expm(rows * time, method="taylor") * matrix([start, mpf(0), mpf(0), mpf(1), mpf(1)])
        inputs = {
            "rotation": rotation_text,
            "start": start_text,
            "time": time_text,
            "plane": {"word": plane},
            "mass": "0.2",
        }
        if spring:
            inputs["spring"] = {"record": "Spring", "stiffness": spring, "free_length": "0.25"}
        wall = mass * (2 * turning * end[1] + weight * cos(turning * time))
        results = {"position": end[0], "speed": end[1], "wall_force": wall}
        yield "tube", "hard" if why else "ordinary", f"tube {nth}", why, inputs, results


def hoops() -> Iterator[Case]:
    hard = [("6.2632", "just above the critical rotation: the angle is a small difference")]
    for nth, (text, why) in enumerate([*hard, *((drawn(6.5, 20), "") for _ in range(4))]):
        rotation = exact(text)
        cosine = GRAVITY / (mpf("0.25") * rotation**2)
        yield (
            "hoop", "hard" if why else "ordinary", f"hoop {nth}", why, {"radius": "0.25", "rotation": text},
            {
                "angle": mp.acos(cosine), "frequency": rotation * sqrt(1 - cosine**2) / (2 * mp.pi),
                "bottom_growth": sqrt(rotation**2 - GRAVITY / mpf("0.25")), "height": mpf("0.25") * (1 - cosine),
            },
        )  # fmt: skip


def slopes() -> Iterator[Case]:
    for nth in range(5):
        inputs = {
            "mass": drawn(1, 90),
            "angle": drawn(0.4, 1.4),
            "friction": drawn(0.05, 0.35),
            "distance": drawn(1, 9),
        }
        mass, angle, friction, distance = (exact(text) for text in inputs.values())
        pull = GRAVITY * (sin(angle) - friction * cos(angle))
        yield (
            "incline", "ordinary", f"slide {nth}", "", inputs,
            {
                "acceleration": -pull, "needed_friction": tan(angle), "holding_force": mass * pull,
                "moving_force": mass * GRAVITY * (sin(angle) + friction * cos(angle)),
                "speed": sqrt(2 * pull * distance),
                "time": sqrt(2 * distance / pull),
            },
        )  # fmt: skip
    for nth in range(5):
        inputs = {"radius": drawn(5, 200), "friction": drawn(0.05, 0.8), "bank": drawn(0.0, 0.5), "speed": drawn(3, 30)}
        radius, friction, bank, speed = (exact(text) for text in inputs.values())
        scale = GRAVITY * radius
        results = {"free_speed": sqrt(scale * tan(bank)), "acceleration": speed**2 / radius}
        outer = tan(bank + atan(friction))
        if outer > 0:
            results["greatest_speed"] = sqrt(scale * outer)
        results["needed_friction"] = abs(tan(atan(speed**2 / scale) - bank))
        yield "circle", "ordinary", f"bend {nth}", "", inputs, results


def skew(vector: list[Any]) -> Any:
    """The matrix that multiplies as a vector product from the left."""
    x, y, z = vector
    return matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def size(vector: Any) -> Any:
    return sqrt(sum(part * part for part in vector))


def listed(name: str, vector: Any) -> dict[str, Any]:
    return {f"{name}[{place}]": part for place, part in enumerate(vector)}


def frames() -> Iterator[Case]:
    hard = [
        (
            ["3.0", "-7.0", "11.0"],
            ["1.5000001", "-3.5", "5.5"],
            ["0.3", "0.1", "-0.2"],
            ["0.0", "0.0", "0.0"],
            "the velocity is all but along the axis: the products cancel to seven digits",
        )
    ]
    ordinary = [tuple([drawn(-9, 9) for _ in range(3)] for _ in range(4)) + ("",) for _ in range(5)]
    for nth, (turn, velocity, place, gain, why) in enumerate([*hard, *ordinary]):
        inputs = {
            "frame": {"record": "Turning", "angular_velocity": turn, "position": place, "angular_acceleration": gain},
            "velocity": velocity,
            "mass": "2.5",
        }
        spin, bend = (skew([exact(text) for text in texts]) for texts in (turn, gain))
        here, v = (matrix([exact(text) for text in texts]) for texts in (place, velocity))
        # the turn's matrix begins 1 + [ω]t + ([α] + [ω]²)·t²/2
        coriolis, centrifugal, euler = -2 * spin * v, -(spin * spin) * here, -bend * here
        apparent = coriolis + centrifugal + euler
        results = {
            **listed("coriolis", coriolis),
            "coriolis_size": size(coriolis),
            **listed("centrifugal", centrifugal),
            **listed("euler", euler),
            **listed("apparent", apparent),
            **listed("true_velocity", v + spin * here),
            "force_size": mpf("2.5") * size(apparent),
        }
        results = {name: value for name, value in results.items() if value}
        yield "rotating_frame", "hard" if why else "ordinary", f"turning {nth}", why, inputs, results
    for nth in range(4):
        latitude, velocity = drawn(-1.5, 1.5), [drawn(-300, 300) for _ in range(3)]
        angle, v = exact(latitude), matrix([exact(text) for text in velocity])
        rate = exact("7.292115e-05")
        # of the axis, the parts along east, north and up
        spin = skew([mpf(0), rate * cos(angle), rate * sin(angle)])
        coriolis = -2 * spin * v
        level = sqrt(v[0] ** 2 + v[1] ** 2)
        yield (
            "rotating_frame", "ordinary", f"ground {nth}", "",
            {"frame": {"record": "OnEarth", "latitude": latitude}, "velocity": velocity},
            {
                **listed("coriolis", coriolis), "coriolis_size": size(coriolis),
                "inertial_radius": level / (2 * rate * abs(sin(angle))),
                "inertial_time": mp.pi / (rate * abs(sin(angle))), "foucault_rate": rate * sin(angle),
                "foucault_time": 2 * mp.pi / (rate * abs(sin(angle))),
            },
        )  # fmt: skip


def every() -> Iterator[Case]:
    for part in (flights, falls, tubes, hoops, slopes, frames):
        yield from part()


if __name__ == "__main__":
    write_given("particle", ABOUT, every())
