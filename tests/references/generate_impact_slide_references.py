"""Writes tests/impact/slide.json: slides of cars to rest in 30 digits, by extrapolated steps in the body's axes.

Another formula than the program's, which works along the axes of the scene with a variable order: here the velocities
are those along and across the car, turning with it, and a wheel that stands is waited for until its slip is below
1e-10 of the car's speed; from there on the car turns about it, by the equation of the turning moment.

Run: python tests/references/generate_impact_slide_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path

from mpmath import exp, expj, mp, mpc, mpf, pi, sqrt

mp.dps = 30
GRAVITY = mpf("9.80665")
FILE = Path(__file__).resolve().parents[1] / "impact" / "slide.json"
COLUMNS = 7
TOLERANCE = mpf(10) ** -19
STANDS = mpf(10) ** -10
END = 23
DEGREE = pi / 180

# ahead, behind, track, gyration, friction, shares, grip slope, steer in degrees; speed, course, nose, spin
CASES = {
    "S1": (("1.2", "1.4", "1.5", "1.35", "0.7", "1 1 1 1", "0.1", "0"), ("12", "30", "0", "3")),
    "S2": (("1.2", "1.4", "1.5", "1.35", "0.7", "1 1 1 1", "0.1", "0"), ("5", "0", "90", "-7")),
    "S3": (("1.1", "1.5", "1.5", "1.3", "0.65", "1 0.02 0.02 0.02", "0.15", "0"), ("10", "0", "20", "2.5")),
    "S4": (("1.2", "1.4", "1.5", "1.35", "0.7", "1 1 1 1", "0.1", "0"), ("12", "30", "0", "0")),
    "two locked": (("1.1", "1.5", "1.5", "1.3", "0.6", "0.03 1 0.03 1", "0.1", "0"), ("14", "-10", "5", "-4")),
    "steered": (("1.2", "1.4", "1.5", "1.35", "0.7", "0.3 0.3 0.3 0.3", "0.12", "12"), ("9", "10", "0", "0.5")),
    "on the spot": (("1.2", "1.4", "1.5", "1.35", "0.7", "1 1 1 1", "0.1", "0"), ("0", "0", "0", "6")),
}


class Car:
    """A car as complex numbers: wheels at places on the body, each with its own axes."""

    def __init__(self, given):
        ahead, behind, track, self.k, friction, shares, self.slope, steer = (
            part if index == 5 else mpf(part) for index, part in enumerate(given)
        )
        base = ahead + behind
        places = [mpc(x, y) for x in (ahead, -behind) for y in (track / 2, -track / 2)]
        self.wheels = [
            (place, friction * GRAVITY * (behind if index < 2 else ahead) / base / 2, mpf(share),
             expj(steer * DEGREE if index < 2 else 0))
            for index, (place, share) in enumerate(zip(places, shares.split(), strict=True))
        ]  # fmt: skip

    def force(self, wheel, slip):
        """Force on a wheel whose foot moves over the road with this velocity, both in the axes of the body."""
        _, grip, share, way = wheel
        own = slip / way
        if abs(own) == 0:
            return mpc(0)
        if share == 1:
            return -grip * slip / abs(slip)
        braking = share * grip * own.real / abs(own)
        sideways = sqrt(1 - share**2) * grip * own.imag / sqrt(own.imag**2 + (self.slope * own.real) ** 2)
        return -mpc(braking, sideways) * way

    def pushes(self, velocity, spin):
        """Force and moment per mass, and the slips of the wheels."""
        force, moment, slips = mpc(0), mpf(0), []
        for wheel in self.wheels:
            slip = velocity + 1j * spin * wheel[0]
            push = self.force(wheel, slip)
            force += push
            moment += (wheel[0].conjugate() * push).imag
            slips.append(abs(slip))
        return force, moment, slips


def rates(car, size, stretched, y):
    """Derivatives of velocities along and across the car, k times spin, place, nose, time, path."""
    q, turning = mpc(y[0], y[1]), y[2]
    spin = turning / car.k
    force, moment, _ = car.pushes(q, spin)
    shed = -(force.real * q.real + force.imag * q.imag + moment * spin)
    left = size * exp(-stretched)
    clock = left / shed
    # the body turns under the velocity
    change = force / shed - 1j * spin * left * clock * q + q
    place = q * expj(y[5]) * left * clock
    return [
        change.real, change.imag, moment / car.k / shed + turning, place.real, place.imag, spin * left * clock, clock,
        abs(q) * left * clock,
    ]  # fmt: skip


def stepped(car, size, at, y, step):
    """One extrapolated step: the last two columns of the tableau."""
    rows = []
    first = rates(car, size, at, y)
    for column in range(COLUMNS):
        count = 2 * (column + 1)
        h = step / count
        before, now = y, [a + h * b for a, b in zip(y, first, strict=True)]
        for index in range(1, count):
            slope = rates(car, size, at + index * h, now)
            before, now = now, [a + 2 * h * b for a, b in zip(before, slope, strict=True)]
        slope = rates(car, size, at + step, now)
        row = [[(a + b + h * c) / 2 for a, b, c in zip(before, now, slope, strict=True)]]
        for order in range(column):
            ratio = (mpf(count) / (2 * (column - order))) ** 2 - 1
            row.append([a + (a - b) / ratio for a, b in zip(row[order], rows[-1][order], strict=True)])
        rows.append(row)
    return rows[-1][-1], max(abs(a - b) for a, b in zip(rows[-1][-1], rows[-1][-2], strict=True))


def slid(given, motion):
    """Place, nose, time and path at rest."""
    car = Car(given)
    speed, course, nose, spin = (mpf(part) for part in motion)
    q = speed * expj((course - nose) * DEGREE)
    size = sqrt(abs(q) ** 2 + (car.k * spin) ** 2)
    y = [q.real / size, q.imag / size, car.k * spin / size, mpf(0), mpf(0), nose * DEGREE, mpf(0), mpf(0)]
    at, step = mpf(0), mpf("0.02")
    about = None
    while at < END and about is None:
        step = min(step, END - at)
        there, error = stepped(car, size, at, y, step)
        slips = car.pushes(mpc(there[0], there[1]), there[2] / car.k)[2]
        if error > TOLERANCE:
            step *= mpf("0.5")
            continue
        at, y = at + step, there
        norm = sqrt(y[0] ** 2 + y[1] ** 2 + y[2] ** 2)
        y[:3] = [part / norm for part in y[:3]]
        if error < TOLERANCE / 1000:
            step *= mpf("1.6")
        about = next((index for index, slip in enumerate(slips) if slip < STANDS), None)
    left = size * exp(-at)
    if about is None:
        last = rates(car, size, at, y)
        for index in range(3, 8):
            y[index] += last[index] if index == 6 else last[index] / 2
        return y[3:], about
    return turned(car, y, left, about), about


def turned(car, y, left, about):
    """The rest of the way about a wheel that stands: the spin falls steadily."""
    pivot = car.wheels[about][0]
    inertia = car.k**2 + abs(pivot) ** 2
    velocity = left * mpc(y[0], y[1])
    spin = (car.k * left * y[2] + ((-pivot).conjugate() * velocity).imag) / inertia
    moment = mpf(0)
    for index, wheel in enumerate(car.wheels):
        if index != about:
            arm = wheel[0] - pivot
            moment += (arm.conjugate() * car.force(wheel, 1j * spin * arm)).imag
    time = -spin * inertia / moment
    angle = spin * time / 2
    place = mpc(y[3], y[4]) + pivot * expj(y[5]) - pivot * expj(y[5] + angle)
    return [place.real, place.imag, y[5] + angle, y[6] + time, y[7] + abs(pivot) * abs(angle)]


def main():
    """Every case into the file."""
    listed = []
    for name, (given, motion) in CASES.items():
        (x, y, nose, time, path), about = slid(given, motion)
        listed.append(
            {
                "name": name, "car": given, "motion": motion, "about": about,
                "rest": [mp.nstr(part, 18) for part in (x, y)], "nose": mp.nstr(nose, 18), "time": mp.nstr(time, 18),
                "path": mp.nstr(path, 18),
            }
        )  # fmt: skip
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    target.write_text(json.dumps({"cases": listed}, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
