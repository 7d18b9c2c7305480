"""Hard inputs of the skid tasks about a path through curve, air or spin, and of `avoid`: (why, name, inputs)."""

from collections.abc import Iterator
from typing import Any

G = 9.80665
Hard = tuple[str, str, dict[str, Any]]


def yaws() -> Iterator[Hard]:
    base = {"path": {"record": "Radius", "radius": 60.0}, "friction": 0.8, "superelevation": 0.0, "gravity": G}
    for why, change in [
        (
            "friction times bank within 1e-9 of one, where the curve holds any speed: the denominator cancels",
            {"superelevation": 1.25 - 1e-9},
        ),
        (
            "friction times bank one unit in the last place below one: the denominator is that unit",
            {"superelevation": 1.2499999999999998},
        ),
        (
            "a bank that all but cancels the friction: the speed is the root of a difference",
            {"superelevation": -0.8 + 1e-12},
        ),
        (
            "no friction: the bank alone holds the car, and quotients by friction do not exist",
            {"friction": 0.0, "superelevation": 0.1},
        ),
        (
            "a track as wide as the path's radius allows: the centre's radius is a vanishing difference",
            {"track_width": 119.99999999},
        ),
        (
            "an arc flat to a picometre: the radius is a quotient of unlike sizes",
            {"path": {"record": "Chord", "chord": 30.0, "middle_ordinate": 1e-12}},
        ),
        (
            "an arc of nearly a full circle: chord far below middle ordinate",
            {"path": {"record": "Chord", "chord": 1e-3, "middle_ordinate": 40.0}},
        ),
        (
            "a half circle, where both terms of the radius are equal",
            {"path": {"record": "Chord", "chord": 30.0, "middle_ordinate": 15.0}},
        ),
        (
            "the square of the chord overflows, and the radius, its quotient, does not",
            {"path": {"record": "Chord", "chord": 1e200, "middle_ordinate": 1e199}},
        ),
    ]:
        yield why, f"yaw with {change}", {**base, **change}


def vaults() -> Iterator[Hard]:
    for x, y, why in [
        (20.0, 0.0, "level: the line of sight's angle is an exact zero"),
        (1e-9, -5.0, "straight down: the least speed is a difference of fall and path that nearly cancels"),
        (1e-9, 5.0, "straight up: all of the speed is for the height, the distance's part is lost in it"),
        (1e9, -5.0, "so far out that the fall is lost beside the way, and its sign still decides which is less"),
        (20.0, -1e-12, "a fall whose square is lost beside the distance's"),
        (1e-150, 1e-150, "squares of the distances underflow: the hypotenuse must be found without them"),
        (1e150, -1e150, "squares of the distances overflow: the hypotenuse must be found without them"),
    ]:
        yield why, f"{x!r} m out, {y!r} m up", {"distance": x, "rise": y, "gravity": G}


def launches() -> Iterator[Hard]:
    near_vertical, sight = 1.5707963267948966, 0.4636476090008061
    for x, y, angle, why in [
        (20.0, 0.0, 1e-9, "a level take-off to nine digits: a speed of the inverse root of the angle"),
        (20.0, 0.0, 1e-300, "a take-off of 1e-300: a speed of 1e151, whose square is near the largest double"),
        (20.0, -2.0, 0.0, "a level take-off: the slope's term is an exact zero"),
        (20.0, -2.0, -0.09, "downwards, close above the line of sight: fall and slope nearly cancel"),
        (20.0, -2.0, -0.0996686524, "downwards along the line of sight to nine digits: fall and slope cancel"),
        (
            20.0,
            -2.0,
            near_vertical - 1e-9,
            "nearly straight up: the cosine is 1e-9, a difference of the angle from 90 degrees",
        ),
        (20.0, 3.0, near_vertical - 2e-15, "straight up to the last bits: the cosine is a few units of them"),
        (20.0, 10.0, sight + 1e-3, "just above the line of sight: rise and slope nearly cancel"),
        (20.0, 10.0, sight + 1e-10, "above the line of sight by 1e-10: ten digits of rise and slope cancel"),
        (
            20.0,
            10.0,
            0.7853981633974483,
            "at 45 degrees over a rise of half the way: the landing is level to the last bit",
        ),
        (1e-200, -1e-200, 0.3, "squares of the distances underflow: the hypotenuse must be found without them"),
        (1e200, -1e200, 0.3, "squares of the distances overflow: the hypotenuse must be found without them"),
    ]:
        inputs = {"distance": x, "rise": y, "take_off": angle, "gravity": G}
        yield why, f"{x!r}, {y!r} at {angle!r}", inputs


def pedestrians() -> Iterator[Hard]:
    base = {"throw_distance": 25.0, "friction": 0.66, "launch_height": 1.0, "gravity": G}
    for why, change in [
        (
            "throw less friction times height is 1e-12: every speed is the root of a difference",
            {"throw_distance": 0.66 + 1e-12},
        ),
        (
            "thrown flat from the ground: no flight at all, its time and way are exact zeros",
            {"launch_height": 0.0, "launch_angle": 0.0},
        ),
        ("thrown downwards from a height: the flight's root must be taken without cancelling", {"launch_angle": -0.4}),
        ("thrown downwards from the ground: a flight of no length", {"launch_height": 0.0, "launch_angle": -0.9}),
        (
            "steep from the ground: the landing's loss takes nearly all of the horizontal speed",
            {"launch_height": 0.0, "launch_angle": 0.98},
        ),
        (
            "at the angle at which the landing stops the slide: it is a vanishing difference",
            {"launch_height": 0.0, "launch_angle": 0.9874},
        ),
        ("hardly any friction: a slide of huge length beside a short flight", {"friction": 1e-9, "launch_angle": 0.3}),
        (
            "a throw of 1e200 m, whose square overflows: its root must be taken without it",
            {"throw_distance": 1e200, "launch_height": 0.0, "launch_angle": 0.2},
        ),
        ("the smallest angle a double can hold: flat, but not zero", {"launch_angle": 1e-300}),
        ("steep from the ground: the slide is a small part of the throw", {"launch_height": 0.0, "launch_angle": 0.95}),
        (
            "friction tan 30°, where two forms of the greatest angle meet, last bit below",
            {"friction": 0.5773502691896257, "launch_height": 0.0},
        ),
        (
            "friction tan 30°, where two forms of the greatest angle meet, last bit above",
            {"friction": 0.5773502691896258, "launch_height": 0.0},
        ),
        (
            "just below friction tan 30°, where two forms of the greatest angle meet",
            {"friction": 0.577, "launch_height": 0.0},
        ),
        (
            "just above friction tan 30°, where two forms of the greatest angle meet",
            {"friction": 0.578, "launch_height": 0.0},
        ),
        (
            "a short throw from a height: nearly a drop, the slide is what little is left of the distance",
            {"friction": 0.4, "throw_distance": 2.0},
        ),
        (
            "a friction of three: the landing's loss is larger than the speed for most angles",
            {"friction": 3.0, "throw_distance": 60.0},
        ),
        (
            "a throw of twice friction times height, where two forms of the greatest speed meet",
            {"throw_distance": 1.32},
        ),
        ("just below twice friction times height: a level launch stops where it lands", {"throw_distance": 1.3}),
        (
            "just above twice friction times height: a level launch slides a vanishing way",
            {"throw_distance": 1.34, "launch_angle": 1e-3},
        ),
        (
            "ten kilometres nearly straight up: flight and slide of unlike size",
            {"friction": 0.2, "throw_distance": 1e4, "launch_angle": 1.3},
        ),
        (
            "steep and rough: the flight is nearly the whole throw",
            {"friction": 0.9, "launch_height": 0.3, "launch_angle": 0.8},
        ),
    ]:
        yield why, f"throw with {change}", {**base, **change}


def avoids() -> Iterator[Hard]:
    base = {
        "speed": 25.0,
        "sight_distance": 50.0,
        "reaction_time": 1.5,
        "friction": 0.7,
        "grade": 0.0,
        "braking": 1.0,
        "gravity": G,
    }
    for why, change in [
        (
            "the car stops just at the obstacle: the impact speed is the root of a rounding",
            {"speed": 17.85427588404575},
        ),
        ("the car stops just before the obstacle, by the last bit", {"speed": 17.854275884045748}),
        ("the car stops millimetres before the obstacle: what is left is a difference", {"speed": 17.8542}),
        ("the whole distance goes in reaction to the last bit: no braking is left", {"reaction_time": 2.0}),
        ("the obstacle is reached before the brakes are: reaction outlasts the way", {"reaction_time": 3.0}),
        (
            "no reaction: its distance is an exact zero, and the greatest safe speed a plain root",
            {"reaction_time": 0.0},
        ),
        (
            "a reaction of thirty years: the greatest safe speed is a difference that cancels to nothing",
            {"reaction_time": 1e9},
        ),
        ("at rest: every distance is zero, and none of them may be divided by", {"speed": 0.0}),
        ("drag of 1e-12 left of friction and grade: the greatest safe speed cancels", {"grade": -0.7 + 1e-12}),
        (
            "a sight distance whose product with gravity is tiny beside the reaction's square",
            {"sight_distance": 1e-200},
        ),
        ("a sight distance of 1e200 m, whose square overflows", {"sight_distance": 1e200}),
        (
            "reaction takes the whole way and one last bit more: the braking left is below zero",
            {"speed": 33.333333333333336},
        ),
        (
            "reaction takes the whole way, last bit below: the braking left is one rounding",
            {"speed": 33.33333333333333},
        ),
        (
            "a touch at less than a millimetre a second: the root of a difference in the ninth digit",
            {"speed": 17.85427589},
        ),
    ]:
        yield why, f"avoid with {change}", {**base, **change}


def spins() -> Iterator[Hard]:
    base = {"distance": 20.0, "friction": 0.7, "end_speed": 0.0, "grade": 0.0, "gravity": G}
    pi = 3.141592653589793
    for turned, start, rolling, why in [
        (pi, 0.0, 0.0, "half a turn from straight: the mean of |sin| at its corner"),
        (2 * pi, 0.0, 0.0, "a full turn: the mean of |sin| at the corner of its second arch"),
        (100 * pi, 0.3, 0.0, "fifty turns: whole arches must be counted, not integrated"),
        (
            1e-9,
            0.0,
            0.1,
            "a turn of 1e-9 from straight: the mean of |sin| is a vanishing integral over a vanishing turn",
        ),
        (1e-9, 0.7, 0.0, "a turn of 1e-9: a difference of cosines has no digits, the mean of |sin| has all"),
        (pi / 2, pi / 2, 0.0, "from broadside to backwards: the turn ends at the corner of |sin|"),
        (3.0, -0.1, 0.0, "through straight ahead: |sin| is integrated across its corner"),
        (0.2, 3.1, 0.0, "through backwards: |sin| is integrated across its corner"),
        (1e-6, pi - 5e-7, 0.0, "a turn of 1e-6 just across backwards: two vanishing arches on either side of a corner"),
        (12345.678, -2.5, 0.05, "two thousand turns: the angle's reduction by π must not lose digits"),
    ]:
        drag = {"record": "Rotation", "rotation": turned, "start_angle": start, "rolling_drag": rolling}
        yield why, f"spin by {turned!r} from {start!r}", {**base, "drag": drag}
    share = {"record": "Share", "drag_share": 0.5}
    why = "friction's share and downhill grade cancel to 1e-12: four digits of the drag are left"
    yield why, "spin near zero drag", {**base, "drag": share, "grade": -0.35 + 1e-12}
    why = "a picometre at 30 m/s: the speed lost is a difference below the speed's last place"
    yield why, "short spin at speed", {**base, "drag": share, "distance": 1e-12, "end_speed": 30.0}
