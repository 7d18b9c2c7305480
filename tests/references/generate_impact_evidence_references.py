"""Writes tests/impact/evidence.json: approach from exit motion and from a recorded ΔV, to 25 digits.

Fits minimise χ² by Newton's method with numerical derivatives and normal equations in 60 digits; the plane is that of
complex numbers. Records are answered by running the impact forward and bisecting what is unknown, or by linear
equations. The program uses Gauss–Newton by QR, and closed forms.

Run: python tests/references/generate_impact_evidence_references.py [FILE]. The same bytes every time.
"""

import json
import sys
from pathlib import Path

from mpmath import (
    arg,
    atan2,
    conj,
    cos,
    erfc,
    exp,
    expj,
    findroot,
    im,
    inverse,
    lu_solve,
    matrix,
    mp,
    mpc,
    mpf,
    pi,
    quad,
    radians,
    sin,
    sqrt,
)

mp.dps = 60
FILE = Path(__file__).resolve().parents[1] / "impact" / "evidence.json"
STEP = mpf(10) ** -20


def plane(x, y):
    return mpc(mpf(x), mpf(y))


def way(angle):
    return expj(radians(mpf(angle)))


def cross(a, b):
    return im(conj(a) * b)


def dot(a, b):
    return (conj(a) * b).real


M, J = (mpf(1500), mpf(1200)), (mpf(2500), mpf(1800))
R = plane("1.8", "-0.3"), plane("-0.7", "0.9")
EXITS = {
    "agreeing": ((plane("11.2", "0.2"), mpf("-0.5")), (plane("4.9", "9.9"), mpf("-2.7"))),
    "contradicting": ((plane("9.1", "3.6"), mpf("1.3")), (plane("6.0", "6.4"), mpf("-2.4"))),
}
SIGMA_U, SIGMA_W = mpf("0.5"), (mpf("0.3"), mpf("0.4"))


def state(x):
    """Approach velocities and the impulse of speeds, impulse and headings in degrees."""
    return x[0] * way(x[4]), x[1] * way(x[5]), mpc(x[2], x[3])


def residuals(x, exits, spread):
    one, two, p = state(x)
    rows = []
    for index, (velocity, sense) in enumerate(((one, 1), (two, -1))):
        u, spin = exits[index]
        gap = velocity + sense * p / M[index] - u
        rows += [gap.real / SIGMA_U, gap.imag / SIGMA_U]
        rows.append((sense * cross(R[index], p) / J[index] - spin) / SIGMA_W[index])
    if spread:
        rows += [(x[4] - 0) / mpf(spread), (x[5] - 90) / mpf(spread)]
    return rows


def slopes(function, x, free):
    """Columns of derivatives, by central differences."""
    columns = []
    for k in free:
        up, down = list(x), list(x)
        up[k], down[k] = x[k] + STEP, x[k] - STEP
        columns.append([(a - b) / (2 * STEP) for a, b in zip(function(up), function(down), strict=True)])
    return matrix(columns).T


def contact(x, normal):
    """Restitution and ratio of impulses along the normal from the second to the first."""
    one, two, p = state(x)
    n = way(normal)
    before = one - two
    after = before + p / M[0] + p / M[1]
    for index in (0, 1):
        after += mpc(0, 1) * R[index] * cross(R[index], p) / J[index]
    return [-dot(after, n) / dot(before, n), dot(p, mpc(0, 1) * n) / dot(p, n)]


def fit(name, spread):
    exits, free = EXITS[name], range(6) if spread else range(4)
    x = [mpf(15), mpf(10), mpf(-5000), mpf(0), mpf(0), mpf(90)]

    def rows(y):
        return residuals(y, exits, spread)

    for _ in range(200):
        columns = slopes(rows, x, free)
        step = lu_solve(columns.T * columns, columns.T * matrix(rows(x)))
        for place, k in enumerate(free):
            x[k] -= step[place]
        if max(abs(one) for one in step) < mpf(10) ** -34:
            break
    columns = slopes(rows, x, free)
    covariance = inverse(columns.T * columns)
    square = sum(one * one for one in rows(x))
    turned = slopes(lambda y: contact(y, 200), x, free)
    implied = turned * covariance * turned.T
    e, ratio = contact(x, 200)
    return {
        "first.approach_speed": x[0],
        "second.approach_speed": x[1],
        "first.approach_heading": radians(x[4]),
        "second.approach_heading": radians(x[5]),
        "first.speed_sigma": sqrt(covariance[0, 0]),
        "second.speed_sigma": sqrt(covariance[1, 1]),
        "correlation": covariance[0, 1] / sqrt(covariance[0, 0] * covariance[1, 1]),
        "chi_squared": square,
        "probability": exp(-square / 2),
        "impulse[0]": x[2],
        "impulse[1]": x[3],
        "restitution": e,
        "impulse_ratio": ratio,
        "restitution_sigma": sqrt(implied[0, 0]),
        "impulse_ratio_sigma": sqrt(implied[1, 1]),
    }


def momentum():
    """Two linear equations of momentum."""
    (u, _), (w, _) = EXITS["agreeing"]
    total = M[0] * u + M[1] * w
    return {"first.approach_speed": total.real / M[0], "second.approach_speed": total.imag / M[1]}


def spins():
    """Two linear equations of angular momentum for the impulse."""
    (u, spin), (w, turn) = EXITS["agreeing"]
    rows = matrix([[-R[0].imag, R[0].real], [R[1].imag, -R[1].real]])
    x, y = lu_solve(rows, matrix([J[0] * spin, J[1] * turn]))
    p = mpc(x, y)
    one, two = u - p / M[0], w + p / M[1]
    return {
        "impulse[0]": x,
        "impulse[1]": y,
        "first.approach_speed": abs(one),
        "second.approach_speed": abs(two),
        "first.approach_heading": atan2(one.imag, one.real),
        "second.approach_heading": atan2(two.imag, two.real),
        "lever_sine": abs(cross(R[0], R[1])) / (abs(R[0]) * abs(R[1])),
    }


RECORD_J = mpf(2600), mpf(1900)
ARMS = plane("1.9", "0.15"), plane("-1.8", "-0.3")


def recorded():
    nose = way(12)
    turn = mpf("1.9")
    return (plane("-44.6", "7.2") / mpf("3.6") - mpc(0, turn) * plane("-0.4", "0.1")) * nose


def forward(speed):
    """Relative velocity of the contact points before and after, and the energies, for a speed of the other."""
    p = M[0] * recorded()
    velocities, after, energy = (mpf("13.2") * way(12), speed * way(140)), [], mpf(0)
    for index, sense in ((0, 1), (1, -1)):
        moved = velocities[index] + sense * p / M[index]
        spin = sense * cross(ARMS[index], p) / RECORD_J[index]
        energy += (M[index] * (abs(velocities[index]) ** 2 - abs(moved) ** 2) - RECORD_J[index] * spin**2) / 2
        after.append((moved, spin))
    points = [moved + mpc(0, spin) * ARMS[k] for k, (moved, spin) in enumerate(after)]
    return velocities[0] - velocities[1], points[0] - points[1], energy, after


def by_restitution(e):
    n = way(192)

    def missing(speed):
        before, leaving, _, _ = forward(speed)
        return dot(leaving, n) + e * dot(before, n)

    speed = findroot(missing, (mpf(1), mpf(60)), solver="secant")
    before, leaving, energy, after = forward(speed)
    p, t = M[0] * recorded(), mpc(0, 1) * n
    return {
        "second.approach_speed": speed,
        "closing_speed": -dot(before, n),
        "impulse_ratio": dot(p, t) / dot(p, n),
        "first.spin_change": after[0][1],
        "second.spin_change": after[1][1],
        "energy_lost": energy,
        "slip_before": dot(before, t),
        "slip_after": dot(leaving, t),
        "first.delta_v.vector[0]": recorded().real,
        "first.delta_v.vector[1]": recorded().imag,
        "first.delta_v.magnitude": abs(recorded()),
    }


def at_rest(x):
    """Places of rest of both: the impulse of one contact by two linear equations, then straight slides."""
    n = way(200)
    t = mpc(0, 1) * n
    velocities = [x[0] * way(0), x[1] * way(90)]
    gain = [[mpf(0), mpf(0)], [mpf(0), mpf(0)]]
    for k, axis in enumerate((n, t)):
        change = axis / M[0] + axis / M[1]
        for index in (0, 1):
            change += mpc(0, 1) * R[index] * cross(R[index], axis) / J[index]
        gain[0][k], gain[1][k] = dot(change, n), dot(change, t)
    closing = dot(velocities[0] - velocities[1], n)
    # along the normal −(1 + e) of the closing; across it the ratio
    rows = matrix([[gain[0][0], gain[0][1]], [mpf("0.45"), mpf(1)]])
    along, across = lu_solve(rows, matrix([-(1 + mpf("0.1")) * closing, 0]))
    p = along * n + across * t
    places = []
    for index, (sense, drag) in enumerate(((1, "0.5"), (-1, "0.45"))):
        out = velocities[index] + sense * p / M[index]
        places.append(out / abs(out) * abs(out) ** 2 / (2 * mpf(drag) * mpf("9.80665")))
    return places


def rest_positions():
    """Gauss and Newton by normal equations to the places of rest."""
    seen = [mpc("12.9", "0.8"), mpc("5.9", "12.1")]

    def rows(y):
        gaps = [(a - b) / mpf("0.5") for a, b in zip(at_rest(y), seen, strict=True)]
        return [part for gap in gaps for part in (gap.real, gap.imag)]

    x = [mpf(15), mpf(10)]
    for _ in range(200):
        columns = slopes(rows, x, range(2))
        step = lu_solve(columns.T * columns, columns.T * matrix(rows(x)))
        x = [a - b for a, b in zip(x, step, strict=True)]
        if max(abs(one) for one in step) < mpf(10) ** -34:
            break
    columns = slopes(rows, x, range(2))
    covariance = inverse(columns.T * columns)
    square = sum(one * one for one in rows(x))
    return {
        "first.approach_speed": x[0],
        "second.approach_speed": x[1],
        "first.speed_sigma": sqrt(covariance[0, 0]),
        "second.speed_sigma": sqrt(covariance[1, 1]),
        "correlation": covariance[0, 1] / sqrt(covariance[0, 0] * covariance[1, 1]),
        "chi_squared": square,
        "probability": exp(-square / 2),
    }


def pulse():
    """A haversine of 0.12 s in a car whose yaw rate rises as its integral: ΔV in the axes of the start."""
    length, spin = mpf("0.12"), mpf("1.9")

    def part(t):
        return t / length - sin(2 * pi * t / length) / (2 * pi)

    def nose(t):
        return spin * (t * t / (2 * length) + length * (cos(2 * pi * t / length) - 1) / (4 * pi * pi))

    def turned(t):
        rate = (1 - cos(2 * pi * t / length)) / length
        return rate * expj(nose(t))

    share = quad(turned, [0, length / 2, length])
    change = mpc("-44.6", "7.2") / mpf("3.6") * share
    return {"along": change.real, "across": change.imag, "turn": nose(length), "shift": arg(share)}


def by_headings():
    change, come, leave = -M[0] * recorded() / M[1], way(140), way(82)
    rows = matrix([[come.real, -leave.real], [come.imag, -leave.imag]])
    before, after = lu_solve(rows, matrix([-change.real, -change.imag]))
    return {"second.approach_speed": before, "second.exit_speed": after}


def in_line(e, arms=(0, 0), radii=(1, 1)):
    """Effective masses at the line of force."""
    change = mpf(27) / mpf("3.6")
    masses = [m * k**2 / (k**2 + h**2) for m, h, k in zip(M, map(mpf, arms), map(mpf, radii), strict=True)]
    return {"closing_speed": M[0] * change * (1 / masses[0] + 1 / masses[1]) / (1 + mpf(e))}


def cases():
    return {
        "momentum": momentum(),
        "spins": spins(),
        "both, headings exact": fit("agreeing", 0),
        "both, headings within 2 deg": fit("agreeing", 2),
        "contradicting, headings exact": fit("contradicting", 0),
        "contradicting, headings within 2 deg": fit("contradicting", 2),
        "rest positions": rest_positions(),
        "pulse": pulse(),
        "record, e 0": by_restitution(mpf(0)),
        "record, e 0.1": by_restitution(mpf("0.1")),
        "record, e 0.2": by_restitution(mpf("0.2")),
        "record, headings": by_headings(),
        "in line, e 0": in_line(0),
        "in line, e 0.1": in_line("0.1"),
        "in line, e 0.2": in_line("0.2"),
        "in line, levers": in_line("0.1", ("0.3", "0.9"), ("1.4", "1.35")),
        "chance": {str(x): erfc(sqrt(mpf(x) / 2)) for x in ("0.1", "1", "4", "9")},
    }


def text():
    numbers = {
        name: {key: mp.nstr(value, 25, strip_zeros=False) for key, value in case.items()}
        for name, case in cases().items()
    }
    about = (
        "Written by generate_impact_evidence_references.py: fits by normal equations, records run forward; 60 digits."
    )
    return json.dumps({"about": about, "cases": numbers}, indent=1) + "\n"


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else FILE
    target.write_text(text(), encoding="utf-8")
    print(target)
