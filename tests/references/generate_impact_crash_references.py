"""Writes tests/impact/crash.json: whole crashes to 30 digits, forward in time from speeds at the start.

A scene is driven forward: every phase by its deceleration over its time, the impact by an impulse along a direction
with a restitution, every slide by its forces until it stops. What a scene file states is read off that motion, and the
speeds it began with are what a reconstruction must find. The program goes back in time by work and momentum.

Run: python tests/references/generate_impact_crash_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path

from mpmath import atan2, cos, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 45
G = mpf("9.80665")
FILE = Path(__file__).resolve().parents[1] / "impact" / "crash.json"


def text(number):
    return mp.nstr(number, 30)


def slowed(speed, friction, grade, braking, distance):
    """Speed after a distance of road, by time: the root of v t − a t²/2 = d that comes first."""
    a = G * (braking * friction + grade) / sqrt(1 + grade * grade)
    time = (speed - sqrt(speed * speed - 2 * a * distance)) / a
    return speed - a * time


def drive(case):
    """A case with what a scene file states of it and what it must give back."""
    scene, answers, velocities = {"first": {}, "second": {}}, {}, []
    for side, given in case["vehicles"].items():
        speed = mpf(given["start"])
        for friction, grade, braking, distance in given["before"]:
            speed = slowed(speed, *map(mpf, (friction, grade, braking, distance)))
        answers[side] = {"start": text(mpf(given["start"])), "approach": text(speed)}
        angle = mpf(given["heading"]) * pi / 180
        velocities.append(matrix([speed * cos(angle), speed * sin(angle)]))
    one, two = (mpf(case["vehicles"][side]["mass"]) for side in ("first", "second"))
    turn = mpf(case["normal"]) * pi / 180
    normal = matrix([cos(turn), sin(turn)])
    along = sum((velocities[0] - velocities[1])[i] * normal[i] for i in (0, 1))
    impulse = (1 + mpf(case["restitution"])) * along * one * two / (one + two)
    for side, mass, sign, before in (("first", one, -1, velocities[0]), ("second", two, 1, velocities[1])):
        after = before + sign * impulse / mass * normal
        speed = sqrt(after[0] ** 2 + after[1] ** 2)
        answers[side] |= {"exit": text(speed), "delta_v": text(abs(impulse) / mass)}
        scene[side]["exit_heading"] = text(atan2(after[1], after[0]))
        stretches = case["vehicles"][side]["after"]
        for friction, grade, braking, distance in stretches[:-1]:
            speed = slowed(speed, *map(mpf, (friction, grade, braking, distance)))
        friction, grade, braking = map(mpf, stretches[-1])
        a = G * (braking * friction + grade) / sqrt(1 + grade * grade)
        time = speed / a
        scene[side]["last_distance"] = text(speed * time - a * time * time / 2)
    lost = sum(m * (v[0] ** 2 + v[1] ** 2) for m, v in ((one, velocities[0]), (two, velocities[1])))
    lost -= sum(m * mpf(answers[s]["exit"]) ** 2 for m, s in ((one, "first"), (two, "second")))
    answers["energy_lost"] = text(lost / 2)
    return {"given": case, "read": scene, "answers": answers}


CASES = [
    {
        "normal": "-40", "restitution": "0.1",
        "vehicles": {
            "first": {"mass": "1500", "heading": "0", "start": "22.5", "before": [["0.7", "0", "1", "12"]],
                      "after": [["0.7", "0", "1", "4"], ["0.45", "0", "1"]]},
            "second": {"mass": "1150", "heading": "90", "start": "16.25", "before": [],
                       "after": [["0.7", "0", "0.75"]]},
        },
    },
    {
        "normal": "20", "restitution": "0",
        "vehicles": {
            "first": {"mass": "1320", "heading": "-15", "start": "27", "after": [["0.6", "0.03", "1"]],
                      "before": [["0.75", "-0.04", "0.3", "20"], ["0.75", "-0.04", "1", "9.5"]]},
            "second": {"mass": "2100", "heading": "115", "start": "14", "before": [["0.5", "0.02", "1", "3"]],
                       "after": [["0.5", "0.02", "0.4"]]},
        },
    },
    {
        "normal": "0", "restitution": "0.25",
        "vehicles": {
            "first": {"mass": "900", "heading": "30", "start": "31.5", "before": [["0.8", "0", "1", "40"]],
                      "after": [["0.3", "-0.01", "1", "1.5"], ["0.8", "0", "1"]]},
            "second": {"mass": "1800", "heading": "160", "start": "11", "before": [["0.8", "0", "0.6", "5"]],
                       "after": [["0.8", "0", "1"]]},
        },
    },
]  # fmt: skip


def published():
    """The speeds of the example, by a linear system of both components."""
    deg = pi / 180
    u1 = sqrt(2 * G * (mpf("0.72") * mpf("6.5") + mpf("0.45") * mpf("4.2")))
    u2 = sqrt(2 * G * mpf("0.72") * mpf("0.75") * mpf("11.6"))
    m1, m2 = mpf(1500), mpf(1150)
    p = [m1 * u1 * sin(48 * deg) + m2 * u2 * sin(53 * deg), m1 * u1 * cos(48 * deg) + m2 * u2 * cos(53 * deg)]
    v1, v2 = p[0] / m1, p[1] / m2
    start = sqrt(v1 * v1 + 2 * G * mpf("0.72") * mpf("12.4"))
    return {"exits": [text(u1), text(u2)], "approaches": [text(v1), text(v2)], "start": text(start)}


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    content = {"cases": [drive(case) for case in CASES], "example": published()}
    target.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    print(target)
