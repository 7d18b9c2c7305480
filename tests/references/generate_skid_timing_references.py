"""Writes tests/skid/timing.json: timelines, meetings, contacts and sight to 30 digits, by integrating accelerations.

Each motion is an acceleration over time, integrated twice by Gauss's rule piece by piece; unknown speeds
and times are found by bisection on what the integration gives. The program solves polynomials in closed form.

Run: python tests/references/generate_skid_timing_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path

from mpmath import mp, mpf, sqrt

mp.dps = 45
G = mpf("9.80665")
FILE = Path(__file__).resolve().parents[1] / "skid" / "timing.json"


NODE = sqrt(mpf(3) / 5)
# Gauss's three points integrate what is of degree five exactly, more than these accelerations need.
RULE = ((-NODE, mpf(5) / 9), (mpf(0), mpf(8) / 9), (NODE, mpf(5) / 9))


def integral(function, length):
    return sum(weight * function(length * (1 + node) / 2) for node, weight in RULE) * length / 2


class Motion:
    """A speed at time zero and accelerations from corner to corner; after the last corner there is none."""

    def __init__(self, speed, pieces):
        self.speed, self.pieces = speed, pieces

    def parts(self, time):
        """What lies before `time`: its length and its acceleration as a function of the time since it began."""
        for length, rate in self.pieces:
            yield min(length, time), rate
            time -= length
            if time <= 0:
                return
        yield time, lambda _: mpf(0)

    def at(self, time):
        """Distance and speed: v = v₀ + ∫a, x = v t + ∫(t − s)·a(s)."""
        way, speed = mpf(0), mpf(self.speed)
        if time <= 0:
            return speed * time, speed
        for length, rate in self.parts(time):
            way += speed * length + integral(lambda s, T=length, r=rate: (T - s) * r(s), length)
            speed += integral(rate, length)
        return way, speed


def steady(length):
    return mpf(length), lambda _: mpf(0)


def slowing(length, rate):
    return mpf(length), lambda _: -rate


def rising(length, rate):
    return mpf(length), lambda s: -rate * s / mpf(length)


def root(function, low, high):
    """The place of a change of sign, by halving."""
    low, high = mpf(low), mpf(high)
    below = function(low) < 0
    for _ in range(160):
        middle = (low + high) / 2
        if (function(middle) < 0) == below:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def stop_of(speed, reaction, build_up, rate):
    """The way to rest of a driver who reacts, by integration up to the time at which the speed is gone."""
    pieces = [steady(reaction), rising(build_up, rate), slowing(1000, rate)]
    rest = root(lambda t: Motion(speed, pieces).at(t)[1], 0, 100)
    return Motion(speed, pieces).at(rest)[0]


def braked(end, way, friction, build_up, reaction):
    """The car that comes to the impact at `end`: duration of its braking, and the motion from the reaction on."""
    rate = mpf(friction) * G
    start = root(lambda t: (end * t + rate * t * t / 2) - way, 0, 100)
    before = Motion(0, [rising(build_up, rate)]).at(mpf(build_up))
    travelled = end + rate * start - before[1]
    return travelled, start, Motion(travelled, [steady(reaction), rising(build_up, rate), slowing(start, rate)])


def written(**numbers):
    return {name: mp.nstr(number, 30) for name, number in numbers.items()}


def car():
    travelled, time, motion = braked(mpf(8), mpf(14), "0.7", "0.2", "1.2")
    whole = time + mpf("1.4")
    distance = motion.at(whole)[0]
    onset, before = motion.at(mpf("1.4")), motion.at(mpf("1.2"))
    return motion, whole, distance, written(
        start_speed=travelled, braking_speed=onset[1], braking_time=time, build_up_distance=onset[0] - before[0],
        reaction_distance=before[0], distance=distance, duration=whole,
    )  # fmt: skip


def meeting():
    """The pedestrian: how far the car was, and the speeds that stop short or arrive late."""
    motion, whole, distance, _ = car()
    rate = mpf("0.7") * G
    walk = mpf("4.6") / mpf("1.4")
    away = distance - motion.at(whole - walk)[0]
    stopping = root(lambda v: stop_of(v, "1.2", "0.2", rate) - away, 5, 60)
    found = {"hazard_time": walk, "first_distance": away, "stopping_speed": stopping}
    for name, clear in (("late", walk + mpf("0.44") / mpf("1.4")),):
        pieces = [steady("1.2"), rising("0.2", rate), slowing(100, rate)]
        found[f"{name}_speed"] = root(lambda v, t=clear, p=pieces: Motion(v, p).at(t)[0] - away, 5, 60)
    return written(**found)


def quick_meeting():
    """A cyclist who is clear while the brakes of the car still build up, and one who is within the reaction."""
    found = {}
    for name, way, clear in (("build_up", "7.0", "1.0"), ("reaction", "5.0", "0.4")):
        speed, rate = mpf("6.25"), mpf("0.6") * G
        hazard = mpf(way) / speed
        _, time, motion = braked(mpf(5), mpf(6), "0.6", "0.3", "1.1")
        whole = time + mpf("1.4")
        away = motion.at(whole)[0] - motion.at(whole - hazard)[0]
        free = hazard + mpf(clear) / speed
        pieces = [steady("1.1"), rising("0.3", rate), slowing(100, rate)]
        found[f"{name}_late"] = root(lambda v, t=free, p=pieces, d=away: Motion(v, p).at(t)[0] - d, 1, 80)
        found[f"{name}_away"] = away
    return written(**found)


def following():
    leader = Motion(20, [slowing(mpf(20) / 7, mpf(7))])
    follower = Motion(mpf("20.5"), [steady("1.1"), slowing(mpf("20.5") / mpf("6.5"), mpf("6.5"))])
    contact = root(lambda t: 25 + leader.at(t)[0] - follower.at(t)[0], 0, 4)
    # with a metre more than closes they do not touch: both stand, and the gap left is the difference of the ways
    way = follower.at(mpf("1.1") + mpf("20.5") / mpf("6.5"))[0] - leader.at(mpf(20) / 7)[0]
    nearer = Motion(25, [slowing(2, mpf(4))])
    ahead = Motion(18, [])
    least = root(lambda t: nearer.at(t)[1] - 18, 0, 2)
    return written(
        contact_time=contact, closing_speed=follower.at(contact)[1], way_lost=way,
        least_gap=20 + ahead.at(least)[0] - nearer.at(least)[0], least_gap_time=least,
    )  # fmt: skip


def hidden(time, first, second, before, aside, behind, angle):
    """Below zero while the corner is in the way: which side of the line from eye to target it lies."""
    eye, way = first(time) + behind, second(time)
    target = (-way * mp.cos(angle), -way * mp.sin(angle))
    return (-before + eye) * target[1] - (-aside) * (target[0] + eye)


def sights():
    steadily = root(
        lambda t: hidden(t, lambda u: 13 * u, lambda u: mpf("1.5") * u, mpf(6), mpf("1.8"), mpf(2), mp.pi / 2), 1, 3
    )
    # the car brakes for the last 1.2 s at 0.6 g; the other comes at 70 degrees and has just set out at 1.5 m/s²
    rate = mpf("0.6") * G

    def car_away(u):
        fast = mpf("1.2")
        return (
            7 * u + rate * u * u / 2
            if u <= fast
            else 7 * fast + rate * fast * fast / 2 + (7 + rate * fast) * (u - fast)
        )

    def other_away(u):
        return mpf("4.5") * u - mpf("1.5") * u * u / 2

    angle = mpf("1.221730476396030703846583537942188941")
    opening = root(lambda t: hidden(t, car_away, other_away, mpf(6), mpf("1.2"), mpf("1.9"), angle), "0.5", "2.9")
    return written(
        steadily=steadily, steadily_first=13 * steadily, steadily_second=mpf("1.5") * steadily,
        braking=opening, braking_first=car_away(opening), braking_second=other_away(opening),
    )  # fmt: skip


def main():
    made = {
        "about": "Written by generate_skid_timing_references.py: by integration of accelerations, 45 digits.",
        "car": car()[3], "meeting": meeting(), "quick_meeting": quick_meeting(), "following": following(),
        "sight": sights(),
    }  # fmt: skip
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    target.write_text(json.dumps(made, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
