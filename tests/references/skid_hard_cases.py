"""The skid tasks' hard inputs, each with what makes it hard: (why, name, inputs) by task."""

from collections.abc import Iterator
from typing import Any

from skid_hard_paths import avoids, launches, pedestrians, spins, vaults, yaws

G = 9.80665
Hard = tuple[str, str, dict[str, Any]]


def segment(d: float, f: float, grade: float = 0.0, braking: float = 1.0) -> dict[str, float]:
    return {"distance": d, "friction": f, "grade": grade, "braking": braking}


# A downhill grade that all but cancels a friction of 0.7, and how many digits the difference keeps.
NEAR_ZERO = [
    (-0.7 * (1.0 - 1e-3), "friction and downhill grade cancel to a thousandth: three of their digits are lost"),
    (-0.7 * (1.0 - 1e-8), "friction and downhill grade cancel to 1e-8: half of their digits are lost"),
    (-0.7 * (1.0 - 1e-12), "friction and downhill grade cancel to 1e-12: four digits of their difference are left"),
    (-0.7 + 1e-15, "friction and downhill grade cancel to a few units in the last place: no digit may be lost again"),
]


def speeds() -> Iterator[Hard]:
    for grade, why in NEAR_ZERO:
        inputs = {"segments": [segment(60.0, 0.7, grade)], "end_speed": 3.0, "gravity": G}
        yield why, f"drag near zero, grade {grade!r}", inputs
    for end, d, why in [
        (
            30.0,
            1e-9,
            "the skid changes the speed in its twelfth digit: the time is a quotient of vanishing differences",
        ),
        (30.0, 1e-20, "the skid changes the speed by less than its last place: speeds are equal, the time is not zero"),
        (13.0, 5e-324, "the smallest length there is: every product with it is a subnormal number"),
        (0.0, 0.0, "no skid and no speed: the time is zero over zero unless it is asked otherwise"),
        (12.0, 0.0, "no skid at speed: the time is a quotient of zeros unless it is taken from the sum of speeds"),
        (1e-12, 20.0, "the end speed's square is lost beside the skid's work"),
    ]:
        yield why, f"end {end!r} after {d!r} m", {"segments": [segment(d, 0.7)], "end_speed": end, "gravity": G}
    for d, f, grade, why in [
        (1e-300, 0.7, 0.0, "work near the smallest double, whose root must be taken without underflow"),
        (1e300, 0.7, 0.0, "work near the largest double, whose root must be taken without overflow"),
        (60.0, 1e-300, 0.0, "a drag factor near the smallest double: speed tiny, time huge"),
        (60.0, 0.7, 1e16, "a wall of a road: the friction is lost beside the grade, and the cosine beside one"),
        (60.0, 1e-9, 1e-9, "friction and grade both a billionth: the drag is tiny and yet known to every digit"),
    ]:
        inputs = {"segments": [segment(d, f, grade)], "end_speed": 0.0, "gravity": G}
        yield why, f"{d!r} m, friction {f!r}, grade {grade!r}", inputs
    mixed = [segment(1e-6, 0.05), segment(500.0, 0.9, -0.3), segment(3.0, 0.01, 0.2, 0.0), segment(40.0, 0.5, 0.1, 0.5)]
    why = "a micrometre of ice before half a kilometre of braking: the first surface's time is a vanishing difference"
    inputs = {"segments": mixed, "end_speed": 0.1, "gravity": G, "mass": 1500.0}
    yield why, "surfaces of very different work", inputs


def distances() -> Iterator[Hard]:
    base = {"friction": 0.7, "grade": 0.0, "braking": 1.0, "gravity": G}
    for v, end, why in [
        (30.0, 30.0, "nothing is slowed: distance and time are exact zeros"),
        (30.0, 29.999999999999996, "speeds one unit in the last place apart: a difference of squares has no digit"),
        (30.0, 29.9999999, "speeds that agree in eight digits: a difference of squares keeps half of them"),
        (1e-300, 0.0, "the square of the speed underflows: distance and time are not zero for that"),
        (1e150, 1.0, "the square of the speed is near the largest double, and the end speed is lost beside it"),
        (0.0, 0.0, "at rest from the start: zeros everywhere, none of them divided by"),
    ]:
        yield why, f"{v!r} to {end!r}", {**base, "speed": v, "end_speed": end}
    for grade, why in NEAR_ZERO:
        yield why, f"drag near zero, grade {grade!r}", {**base, "grade": grade, "speed": 30.0, "end_speed": 10.0}
    # 32²/(2·16·0.5) = 64: a mark that ends at the stop, and one that misses it by half a millionth of a nanometre
    stop = {**base, "speed": 32.0, "friction": 0.5, "gravity": 16.0, "end_speed": 0.0}
    for mark, why in [
        (64.0, "the mark ends just where the car stops: the speed left is the root of an exact zero, at its corner"),
        (63.99999999999999, "the mark misses the stop by one unit in the last place: the speed left is its root, 3e-7"),
        (63.999999, "the mark misses the stop by a micrometre: the speed left is the root of a difference"),
    ]:
        yield why, f"mark {mark!r} of a stop of 64", {**stop, "mark": mark}
    for mark, why in [
        (65.5, "the mark ends at 99.9 % of the stop: the speed left is the root of a difference"),
        (65.553, "the mark ends a fraction of a millimetre before the stop: the speed left is ill-conditioned"),
        (65.55318, "the mark ends micrometres before the stop: the speed left is ill-conditioned"),
        (1e-15, "the mark is shorter than the speed's last place can show: the time at its end is tiny, not zero"),
    ]:
        yield why, f"mark {mark!r} near the stop", {**base, "speed": 30.0, "end_speed": 0.0, "mark": mark}


def frictions() -> Iterator[Hard]:
    one = {"speed": 13.4, "distance": 12.9, "grade": 0.0, "braking": 1.0}
    for why, name, skids in [
        (
            "three equal test skids: their spread is an exact zero, which rounding must not fill",
            "equal test skids",
            [one, one, one],
        ),
        (
            "two test skids that agree in thirteen digits: their spread is a difference with three digits",
            "nearly equal",
            [one, {**one, "distance": 12.900000000001}],
        ),
        (
            "a slope that does nearly all of the slowing: the friction is what is left of two nearly equal numbers",
            "steep",
            [{**one, "grade": 0.70}],
        ),
        (
            "a downhill slope against the friction: a friction above one, from a sum of two large terms",
            "downhill",
            [{**one, "grade": -0.9}],
        ),
        (
            "speed and distance so small that the square of one is the other's size near 1e-200",
            "tiny",
            [{**one, "speed": 1e-100, "distance": 1e-200}],
        ),
    ]:
        yield why, name, {"skids": skids, "gravity": G}


AXLES = {
    "record": "Axles",
    "front_friction": 0.75,
    "rear_friction": 0.75,
    "wheelbase": 2.7,
    "cm_position": 1.2,
    "cm_height": 0.55,
    "front_braking": 1.0,
    "rear_braking": 0.4,
    "grade": 0.0,
}
SLED = {"record": "Sled", "pull": 130.0, "weight": 180.0, "pull_angle": 0.0, "grade": 0.0}


def drag_factors() -> Iterator[Hard]:
    for grade, why in NEAR_ZERO:
        surface = {"record": "Surface", "friction": 0.7, "grade": grade, "braking": 1.0}
        yield why, f"drag near zero, grade {grade!r}", {"measurement": surface, "gravity": G}
    for why, change in [
        ("one axle brakes alone: its load depends on its own drag", {"rear_braking": 0.0}),
        ("a centre of mass so high that the rear wheels are about to lift", {"cm_height": 1.599999999}),
        (
            "as high, with braking shared: load transfer is nearly all of the rear axle's load",
            {"cm_height": 2.2857142857, "front_braking": 0.7},
        ),
        (
            "no height, no load transfer: the general formula at its simplest, without a division by it",
            {"cm_height": 0.0},
        ),
        ("so steep downhill that the grade takes most of the tyres' friction away", {"grade": -0.45}),
        (
            "the centre of mass over the rear axle: the front axle's load at rest is a vanishing difference",
            {"cm_position": 2.699999999999},
        ),
        ("only the rear axle brakes, and lightens itself as it does", {"front_braking": 0.0}),
    ]:
        yield why, f"axles with {change}", {"measurement": {**AXLES, **change}, "gravity": G}
    for why, change in [
        ("a steep pull: its lift takes two thirds of the weight, and the rest divides", {"pull_angle": 1.2}),
        ("downhill with a weak pull: the slope moves the sled more than the pull does", {"grade": -0.3, "pull": 20.0}),
        (
            "a pull that presses the sled down: its cosine is a difference of the angle from 90 degrees",
            {"pull_angle": -1.5},
        ),
        (
            "uphill nearly as steep as the pull is strong: the friction is a small difference",
            {"grade": 0.5, "pull": 100.0},
        ),
    ]:
        yield why, f"sled with {change}", {"measurement": {**SLED, **change}, "gravity": G}


STOP = {"speed": 20.0, "reaction_time": 1.0, "friction": 0.7, "grade": 0.0, "braking": 1.0, "steps": 3, "gravity": G}


def stops() -> Iterator[Hard]:
    for why, change in [
        ("no build-up: the quadratic of its phase divides by its time", {"build_up_time": 0.0}),
        ("the car stops within a hair of the end of build-up: both formulas meet here", {"build_up_time": 5.8}),
        (
            "build-up ends as the car stops: two formulas meet, on one side of their join",
            {"build_up_time": 5.826944438860908},
        ),
        ("build-up ends as the car stops, one unit in the last place before", {"build_up_time": 5.8269444388609065}),
        ("build-up ends as the car stops, one unit in the last place after", {"build_up_time": 5.826944438860909}),
        (
            "a drag of 0.003 left of cancelling terms, and a build-up of half an hour in which the car all but stops",
            {"speed": 28.29286781753336, "friction": 1.1, "grade": -0.69, "braking": 0.63, "build_up_time": 1924.5},
        ),
        ("the car stops before the brakes are full: the time is a root, the distance its cube", {"build_up_time": 8.0}),
        (
            "no reaction and a build-up of a picosecond: its distance is lost beside the braking's",
            {"reaction_time": 0.0, "build_up_time": 1e-12},
        ),
        (
            "so slow that the car stops as the brakes begin to bite, in a hundred-thousandth of the build-up",
            {"speed": 1e-9, "build_up_time": 0.3},
        ),
        (
            "drag of 1e-12 left of friction and grade: a stop of astronomical length",
            {"grade": -0.7 + 1e-12, "build_up_time": 0.3},
        ),
        ("a speed whose square is 1e200: nothing may square it again", {"speed": 1e100}),
    ]:
        yield why, f"stop with {change}", {**STOP, **change}


HARD = {
    "speed": speeds,
    "distance": distances,
    "friction": frictions,
    "drag_factor": drag_factors,
    "stop": stops,
    "yaw": yaws,
    "vault_least_speed": vaults,
    "vault_known_angle": launches,
    "pedestrian": pedestrians,
    "avoid": avoids,
    "spin": spins,
}
