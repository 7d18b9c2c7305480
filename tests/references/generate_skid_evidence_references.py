"""Writes tests/skid/evidence.json: throws on a grade, rollovers, surveyed yaw marks, swerves, start-ups, moving sight.

Each by another route than the program's: throws are simulated in horizontal and vertical axes and the speed found by
bisection; trips are integrated over √θ; circles are fitted through the gradient over the centre alone; swerves come
from the angle of the arc and from integrating the lateral acceleration; start-ups from Lambert's W.

Run: python tests/references/generate_skid_evidence_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path

from mpmath import acos, atan, cos, exp, findroot, hypot, lambertw, matrix, mp, mpf, quad, radians, sin, sqrt, tan

mp.dps = 40
G = mpf("9.80665")
FILE = Path(__file__).resolve().parents[1] / "skid" / "evidence.json"
MARK = [(0, "0"), (5, "2.29"), (10, "4.30"), (15, "6.07"), (20, "7.53"), (25, "8.74"), (30, "9.65"), (35, "10.31"),
        (40, "10.70")]  # fmt: skip
FLAT = [(0, "0"), (10, "0.05"), (20, "0.07"), (30, "0.05"), (40, "0")]


def written(**numbers):
    return {name: mp.nstr(number, 30) for name, number in numbers.items()}


def thrown(speed, launch, friction, height, grade):
    """Horizontal distance, time in the air and horizontal flight, simulated in horizontal and vertical axes."""
    slope = atan(grade)
    right, up = speed * cos(launch), speed * sin(launch)
    # it lands where height above the road, height + up t − g t²/2 − grade·right·t, is gone
    half = (up - grade * right) / G
    time = half + sqrt(half * half + 2 * height / G)
    way, fall = right * time, G * time - up
    along = right * cos(slope) - fall * sin(slope)
    into = fall * cos(slope) + right * sin(slope)
    left = along - friction * into
    slowing = G * (friction * cos(slope) + sin(slope))
    return way + left * left / (2 * slowing) * cos(slope), time, way


def throws():
    made = {}
    for name, grade in (("up", "0.06"), ("level", "0"), ("down", "-0.08")):
        friction, height, distance, grade = mpf("0.6"), mpf("0.9"), mpf(28), mpf(grade)
        launch = radians(mpf(15))

        def speed_of(angle, f=friction, h=height, d=distance, g=grade):
            return findroot(lambda v: thrown(v, angle, f, h, g)[0] - d, mpf(16))

        speed = speed_of(launch)
        _, time, way = thrown(speed, launch, friction, height, grade)
        flattest = findroot(lambda a, s=speed_of: mp.diff(s, a), mpf("0.55"), tol=mpf(10) ** -24)
        made[name] = written(speed=speed, flight_time=time, flight_distance=way, least_speed=speed_of(flattest))
    return made


def rollovers():
    height, half, gyration = mpf("0.70"), mpf("0.77"), mpf("0.55")
    arm = hypot(height, half)
    turning = gyration + arm * arm
    rise = arm - height
    made = {"kerb": written(speed=sqrt(2 * G * turning * rise) / height)}
    for name, share in (("soil", "1.4"), ("weak_soil", "1.15"), ("limit", "1.1000001")):
        rate = mpf(share) * G

        def work(angle, a=rate):
            across = height * sin(angle) + half * (1 - cos(angle))
            return a * across - G * (half * sin(angle) - height * (1 - cos(angle)))

        last = findroot(
            lambda x, a=rate: a * (height * sin(x) + half * (1 - cos(x))) - G * rise, mpf("0.3"), tol=mpf(10) ** -50
        )
        ends = [0, *(sqrt(last) * mpf(10) ** -k for k in (6, 4, 3, 2, 1)), sqrt(last)]
        time = quad(lambda s, w=work: 2 * s / sqrt(2 * w(s * s) / turning), ends)
        made[name] = written(speed=rate * time, angle=last, time=time)
    bank = tan(radians(mpf(-6)))
    factor = half / height
    tip = tan(atan(factor) + atan(bank))
    made["bank"] = written(superelevation=bank, tip_drag=tip, curve_speed=sqrt(G * 60 * tip))
    made["roll"] = written(speed=sqrt(2 * G * mpf("0.53") * 44))
    return made


def fitted(points, sigma):
    """The circle of least squares through the gradient over its centre; the radius is then the mean distance."""
    points = [(mpf(x), mpf(y)) for x, y in points]
    count = len(points)

    def gradient(cx, cy):
        away = [hypot(x - cx, y - cy) for x, y in points]
        radius = sum(away) / count
        return [
            sum((d - radius) * (c - p[axis]) / d for d, p in zip(away, points, strict=True))
            for axis, c in ((0, cx), (1, cy))
        ]

    (x1, y1), (x2, y2), (x3, y3) = points[0], points[count // 2], points[-1]
    det = 2 * (x1 * (y2 - y3) + x2 * (y3 - y1) + x3 * (y1 - y2))
    squares = [x * x + y * y for x, y in ((x1, y1), (x2, y2), (x3, y3))]
    start = (
        (squares[0] * (y2 - y3) + squares[1] * (y3 - y1) + squares[2] * (y1 - y2)) / det,
        (squares[0] * (x3 - x2) + squares[1] * (x1 - x3) + squares[2] * (x2 - x1)) / det,
    )
    cx, cy = findroot(lambda a, b: gradient(a, b), start, tol=mpf(10) ** -60, maxsteps=60, verify=False)
    away = [hypot(x - cx, y - cy) for x, y in points]
    radius = sum(away) / count
    rows = matrix([[(cx - x) / d, (cy - y) / d, -1] for (x, y), d in zip(points, away, strict=True)])
    spread = sigma * sqrt(((rows.T * rows) ** -1)[2, 2])
    made = {"radius": radius, "centre_x": cx, "centre_y": cy, "deviation": spread}
    if count > 3:
        made["scatter"] = sqrt(sum((d - radius) ** 2 for d in away) / (count - 3))
    return made


def marks():
    sigma = mpf("0.03")
    whole = fitted(MARK, sigma)
    return {
        "whole": written(**whole),
        "first_half": written(**fitted(MARK[:5], sigma)),
        "second_half": written(**fitted(MARK[4:], sigma)),
        "three": written(**fitted([MARK[0], MARK[4], MARK[8]], sigma)),
        "flat": written(**fitted(FLAT, sigma)),
        "speed": written(speed=sqrt(mpf("0.72") * G * (whole["radius"] - mpf("0.75")))),
        "braked": written(
            with_braking=sqrt(G * 95 * cos(mp.asin(mpf("0.25") / mpf("0.75"))) * mpf("0.75")),
            without=sqrt(G * 95 * mpf("0.75")),
        ),
    }


def swerves():
    shift, speed, lateral = mpf("3.5"), mpf(25), mpf("0.35") * G
    radius = speed * speed / lateral
    angle = acos(1 - shift / (2 * radius))
    alone = acos(1 - shift / radius)

    def aside(period):
        """∫(T − t)·a·sin(2πt/T) dt: where a sine of lateral acceleration leads."""
        return quad(lambda t: (period - t) * lateral * sin(2 * mp.pi * t / period), [0, period])

    slowing = mpf("0.7") * G

    def difference(v):
        bend = v * v / lateral
        return v * v / (2 * slowing) - 2 * bend * sin(acos(1 - shift / (2 * bend)))

    return written(
        distance=2 * radius * sin(angle), time=2 * radius * angle / speed, one_arc=radius * sin(alone),
        sine_time=findroot(lambda t: aside(t) - shift, mpf("2.5")), equal_speed=findroot(difference, mpf(28)),
    )  # fmt: skip


def start_ups():
    made = {}
    for name, alpha, fade, way in (
        ("book", "2.0", "0.12", 11),
        ("strong", "3.0", "0.6", 80),
        ("weak", "2.0", "1e-9", 11),
    ):
        alpha, fade, way = mpf(alpha), mpf(fade), mpf(way)
        mp.dps = 80
        inside = -exp(-1 - fade * fade * way / alpha)
        time = fade * way / alpha + (1 + lambertw(inside, 0).real) / fade
        made[name] = written(time=time, speed=alpha / fade * (1 - exp(-fade * time)))
    mp.dps = 40
    return made


def moving_sight():
    """A van of 12 m comes the other way; a walker steps out from behind it. Sides of triangles decide."""

    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    def places(t):
        front = (-20 + 10 * t, mpf("-1.2"))
        return (-(13 * t + 2), mpf(0)), (mpf(0), -mpf("1.5") * t), front

    def past_front(t):
        return side(*places(t))

    # the van's front comes into the line; it goes on to hide until the walker has stepped out beside it
    return written(closes=findroot(past_front, mpf("1.29")), opens=mpf("1.2") / mpf("1.5"))


def main():
    made = {
        "about": "Written by generate_skid_evidence_references.py: simulation, quadrature, least squares; 40 digits.",
        "throws": throws(), "rollovers": rollovers(), "marks": marks(), "swerve": swerves(), "start_up": start_ups(),
        "sight": moving_sight(),
    }  # fmt: skip
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    target.write_text(json.dumps(made, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
